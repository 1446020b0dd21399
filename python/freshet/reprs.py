# SPDX-License-Identifier: MIT
"""What a prompt prints for the values that the C++ part of the package returns."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _freshet

VALUES = (
    _freshet.BodyState,
    _freshet.Checkpoint,
    _freshet.Moment,
    _freshet.Statistics,
    _freshet.TimeStepBounds,
    _freshet.TimeSteps,
)


def add_reprs() -> None:
    """Gives the classes without a repr() one that lists their members."""
    for value in VALUES:
        setattr(value, "__repr__", _repr_of_members)
    setattr(_freshet.CheckedScene, "__repr__", _repr_of_scene)


def _repr_of_members(value: Any) -> str:
    kind = type(value)
    names = [name for name, member in vars(kind).items() if isinstance(member, property)]
    return f"{kind.__name__}({', '.join(f'{name}={_text(getattr(value, name))}' for name in names)})"


def _text(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, np.ndarray):
        return "[" + ", ".join(f"{number:.6g}" for number in value) + "]"
    return repr(value)


def _repr_of_scene(scene: _freshet.CheckedScene) -> str:
    about = f"{scene.solver}, {scene.dimension}D, spacing {scene.spacing:.6g} m"
    return f"<freshet.CheckedScene {scene.title!r}: {about}>"
