# SPDX-License-Identifier: MIT
"""Scenes from files, dicts and objects, and the bundled ones."""

from __future__ import annotations

import difflib
import os
from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union

from . import _freshet
from ._freshet import CheckedScene
from .errors import Diagnostic, Error
from .scene_section import Section
from .toml_text import to_toml, toml_value

SceneLike = Union[str, "os.PathLike[str]", Mapping[str, Any], Section, CheckedScene]
"""A file or the name of a bundled scene, a dict, freshet.Scene, or a checked scene."""

MEMORY = "scene"
"""The name of a scene in memory, in errors."""


def overrides(changes: Optional[Mapping[str, Any]]) -> List[Tuple[str, Optional[str]]]:
    """Keys and values as the parser takes them. None removes a key."""
    items = (changes or {}).items()
    return [(key, None if value is None else toml_value(value)) for key, value in items]


def check(scene: SceneLike, set: Optional[Mapping[str, Any]] = None) -> CheckedScene:
    """Parses and checks a scene.

    `set` replaces keys: {"particles.spacing": 0.01, "fluid[1].viscosity": 2}; None removes one.
    Raises freshet.Error with all errors at once. warnings_of() lists the warnings of a valid scene.
    Relative files of a dict are relative to the working folder.
    """
    changes = overrides(set)
    if isinstance(scene, CheckedScene):
        return _freshet.parse_scene(scene.source, MEMORY, changes) if changes else scene
    if isinstance(scene, (Section, Mapping)):
        return _freshet.parse_scene(to_toml(scene), MEMORY, changes)
    if not isinstance(scene, (str, os.PathLike)):
        raise TypeError(f"a scene is a file, a bundled name, a dict or a freshet.Scene, not {scene!r}")
    return _freshet.load_scene(find(scene), changes)


def parse(text: str, set: Optional[Mapping[str, Any]] = None, name: str = MEMORY) -> CheckedScene:
    """Parses and checks a scene from TOML text. Errors have `name` in place of a file."""
    return _freshet.parse_scene(text, name, overrides(set))


def warnings_of(scene: CheckedScene) -> List[Diagnostic]:
    """The warnings for a valid scene, as `freshet check` prints them."""
    return [Diagnostic(*warning) for warning in scene.warnings]


def find(scene: Union[str, "os.PathLike[str]"]) -> Path:
    """The file of that name, else the bundled scene of that name."""
    path = Path(scene)
    if path.exists() or path.suffix:
        return path
    bundled = bundled_scenes()
    if str(scene) in bundled:
        return bundled[str(scene)]
    close = difflib.get_close_matches(str(scene), bundled, 1)
    known = f"did you mean {close[0]}? bundled: {', '.join(bundled)}" if close else f"bundled: {', '.join(bundled)}"
    message = f"no such file, and no bundled scene of that name; {known}"
    raise Error("scene", [("error", str(scene), message)])


def bundled_scenes() -> Dict[str, Path]:
    """The scenes that Freshet is installed with, by name."""
    return {file.stem: file for file in sorted(data_folder("scenes").glob("*.toml"))}


def data_folder(name: str) -> Path:
    """The folder `scenes` or `validation` of the package, of an installed Freshet, or of the sources.

    Raises freshet.Error if none of them has it.
    """
    package = Path(__file__).resolve().parent
    candidates = [package / "share" / name]
    for above in package.parents:
        candidates += [above / "share" / "freshet" / name]
        if (above / "CMakePresets.json").exists():
            candidates.append(above / name)
    for folder in candidates:
        if folder.is_dir():
            return folder
    raise Error("scene", [("error", name, "no such folder is installed; name a file by its path")])
