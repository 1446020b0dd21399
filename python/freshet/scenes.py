# SPDX-License-Identifier: MIT
"""Scenes from files, dicts and objects, and the bundled ones."""

from __future__ import annotations

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
    Raises freshet.Error with all errors at once. warnings_of() lists what is allowed but doubtful.
    """
    changes = overrides(set)
    if isinstance(scene, CheckedScene):
        return _freshet.parse_scene(scene.source, MEMORY, changes) if changes else scene
    if isinstance(scene, (Section, Mapping)):
        return _freshet.parse_scene(to_toml(scene), MEMORY, changes)
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
    known = ", ".join(bundled) or "none are installed"
    message = f"no such file, and no bundled scene of that name; bundled: {known}"
    raise Error("scene", [("error", str(scene), message)])


def bundled_scenes() -> Dict[str, Path]:
    """The scenes that Freshet is installed with, by name."""
    folder = data_folder("scenes")
    return {file.stem: file for file in sorted(folder.glob("*.toml"))} if folder else {}


def data_folder(name: str) -> Optional[Path]:
    """`scenes` or `validation`: of the package, of an installed Freshet, or of the sources."""
    package = Path(__file__).resolve().parent
    candidates = [package / "share" / name]
    for above in package.parents:
        candidates += [above / "share" / "freshet" / name]
        if (above / "CMakePresets.json").exists():
            candidates.append(above / name)
    return next((folder for folder in candidates if folder.is_dir()), None)
