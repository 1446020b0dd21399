# SPDX-License-Identifier: MIT
"""Scenes of a few hundred particles."""

import freshet


def column(**more):
    """A column of water that collapses."""
    scene = {
        "domain": {"max": [1.0, 0.6]},
        "particles": {"spacing": 0.04},
        "fluid": {"min": [0.0, 0.0], "max": [0.3, 0.5]},
        "solver": {"name": "wcsph", "sound_speed": 20.0},
        "time": {"end": 1.0, "step": 0.0005},
    }
    scene.update(more)
    return scene


def filling():
    """A tank that an inlet fills, so that the memory of the fluid grows."""
    return column(
        inlet={"center": [0.16, 0.5], "direction": [1.0, 0.0], "width": 0.12, "speed": 3.0},
        walls={"y_max": "open"},
    )


def floating():
    """A free body on water."""
    return column(
        fluid={"min": [0.0, 0.0], "max": [1.0, 0.3]},
        body=[
            {
                "name": "box",
                "motion": "free",
                "density": 500.0,
                "min": [0.4, 0.32],
                "max": [0.6, 0.48],
            }
        ],
    )


def sim(scene=None, **keys):
    return freshet.Simulation(scene or column(), threads=1, **keys)
