# SPDX-License-Identifier: MIT
"""The base of the classes that make up a scene."""

from __future__ import annotations

import dataclasses
from typing import Any, Dict


class Section:
    """A table of a scene. Keys that are None are not set, so their defaults apply."""

    def to_dict(self) -> Dict[str, Any]:
        """The keys that are set, as nested dicts and lists."""
        return {key: plain(value) for key, value in _members(self).items() if value is not None}

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in self.__dataclass_fields__:  # type: ignore[attr-defined]
            raise AttributeError(f"{type(self).__name__} has no key {name}; help() lists its keys")
        object.__setattr__(self, name, value)

    def __repr__(self) -> str:
        keys = ", ".join(f"{k}={v!r}" for k, v in _members(self).items() if v is not None)
        return f"{type(self).__name__}({keys})"


def _members(section: Any) -> Dict[str, Any]:
    """Values by key: `from_` is the key `from`, which is a keyword of Python."""
    return {f.name.rstrip("_"): getattr(section, f.name) for f in dataclasses.fields(section)}


def plain(value: Any) -> Any:
    """A value without sections: dicts and lists of numbers, strings and Booleans."""
    if isinstance(value, Section):
        return value.to_dict()
    if isinstance(value, dict):
        return {key: plain(v) for key, v in value.items() if v is not None}
    if isinstance(value, (list, tuple)):
        return [plain(v) for v in value]
    return value
