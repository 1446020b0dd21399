# SPDX-License-Identifier: MIT
"""Compares resolutions: one scene with three spacings, in processes."""

import freshet

COLUMN = {
    "domain": {"max": [1.0, 0.6]},
    "fluid": {"min": [0.0, 0.0], "max": [0.24, 0.48]},
    "solver": {"name": "wcsph", "sound_speed": 20.0},
    "time": {"end": 0.2, "step": "adaptive", "step_max": 0.001},
}


def front(sim):
    """Measured at the end of each run."""
    return {"particles": len(sim), "front [m]": sim.x[:, 0].max()}


def main():
    table = freshet.sweep(COLUMN, {"particles.spacing": [0.04, 0.03, 0.02]}, front, processes=2)
    for row in zip(*table.values()):
        print("   ".join(f"{name} {value:g}" for name, value in zip(table, row)))
    return table


if __name__ == "__main__":
    main()
