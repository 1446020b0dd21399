# SPDX-License-Identifier: MIT
"""Freshet: a fluid simulator by smoothed particle hydrodynamics.

    import freshet

    sim = freshet.Simulation("dam_break_2d", threads=2)   # a file, a bundled scene or a dict
    sim.run(until=0.5, progress=True)
    print(sim.x.max(axis=0), sim.statistics().speed_max)

    freshet.run("dam_break_2d", "runs/water")             # a folder, as `freshet run` writes it
    water = freshet.open_run("runs/water")
    water.plot("speed max")

All numbers are in SI units. A 2D scene is a slice one metre deep. docs/python.md is the manual.
"""

try:
    from . import _freshet
except ImportError as error:
    import sys
    from pathlib import Path

    built = ", ".join(file.name for file in Path(__file__).parent.glob("_freshet*.so")) or "none"
    raise ImportError(
        f"{sys.executable} (Python {sys.version_info[0]}.{sys.version_info[1]}) cannot load the module "
        f"_freshet: {error}; in this package: {built}. Use the Python that it was built for, with NumPy, "
        "or configure the build with -DPython_EXECUTABLE"
    ) from error

from ._freshet import (
    BodyState,
    CheckedScene,
    Checkpoint,
    Flow,
    FluidInStep,
    Frame,
    Moment,
    Solve,
    Statistics,
    TimeStepBounds,
    TimeSteps,
    Warning,
    instruction_set,
    may_change_while_running,
)
from ._freshet import version as __version__
from .errors import Diagnostic, Error
from .plots import draw_frame
from .reprs import add_reprs as _add_reprs
from .runs import Run, open_run, run
from .scene_classes import (
    Air,
    Body,
    BodyKey,
    Camera,
    Checks,
    Counter,
    Domain,
    Fluid,
    Inlet,
    Joint,
    Outlet,
    Output,
    Particles,
    Picture,
    Scene,
    Solver,
    Surface,
    Time,
    Wall,
    Walls,
    Whitewater,
)
from .scene_classes import Probe as ProbeSection
from .scenes import bundled_scenes, check, data_folder, parse, warnings_of
from .simulation import Probe, Simulation
from .sweeps import sweep
from .tables import Table, read_table
from .toml_text import to_toml

_add_reprs()
