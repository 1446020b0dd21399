# SPDX-License-Identifier: MIT
"""Dicts as TOML, the language of scene files."""

from __future__ import annotations

import json
import math
import os
from typing import Any, List, Mapping

import numpy as np

from .scene_section import Section, plain


def to_toml(scene: Any) -> str:
    """The TOML text of a scene that is a dict or an object.

    Nested dicts are tables, lists of dicts are arrays of tables. Keys with the value None are
    skipped. Errors of the scene have the lines of this text.
    """
    return "\n".join(_table_lines("", plain(scene))) + "\n"


def toml_value(value: Any) -> str:
    """A value as TOML. Accepts numbers, strings, paths, Booleans, lists, dicts and NumPy arrays."""
    if isinstance(value, Section):
        value = value.to_dict()
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return _number(float(value))
    if isinstance(value, (str, os.PathLike)):
        return _text(os.fspath(value))
    if isinstance(value, np.ndarray):
        return toml_value(value.tolist())
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml_value(v) for v in value) + "]"
    if isinstance(value, Mapping):
        keys = (f"{_key(k)} = {toml_value(v)}" for k, v in value.items() if v is not None)
        return "{ " + ", ".join(keys) + " }"
    raise TypeError(
        f"{value!r} has no form in TOML; use numbers, strings, Booleans, lists, dicts or NumPy arrays"
    )


def _number(value: float) -> str:
    if math.isnan(value):
        return "nan"
    if math.isinf(value):
        return "inf" if value > 0 else "-inf"
    return repr(value)


def _text(value: str) -> str:
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def _key(key: str) -> str:
    bare = key.isascii() and key.replace("_", "").replace("-", "").isalnum()
    return key if bare else _text(key)


def _is_tables(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(v, Mapping) for v in value)


def _table_lines(name: str, table: Mapping[str, Any]) -> List[str]:
    """Plain keys first, as TOML demands, then the tables below this one."""
    lines: List[str] = []
    below = {k: v for k, v in table.items() if isinstance(v, Mapping) or _is_tables(v)}
    for key, value in table.items():
        if key not in below and value is not None:
            lines.append(f"{_key(key)} = {toml_value(value)}")
    for key, value in below.items():
        path = f"{name}.{_key(key)}" if name else _key(key)
        for one in value if _is_tables(value) else [value]:
            lines += ["", f"[[{path}]]" if _is_tables(value) else f"[{path}]"]
            lines += _table_lines(path, one)
    return lines
