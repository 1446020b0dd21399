# SPDX-License-Identifier: MIT
"""Types of the C++ part of the package."""

import os
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

version: str

_Path = Union[str, os.PathLike[str]]
_Overrides = Sequence[Tuple[str, Optional[str]]]
_Real = npt.NDArray[np.floating[Any]]
_Force = Callable[["FluidInStep", float], Any]

class CheckedScene:
    title: str
    description: str
    source: str
    dimension: int
    solver: str
    spacing: float
    end: float
    domain: Tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]
    rest_densities: List[float]
    derived: Dict[str, Any]
    keys: List[Tuple[str, str, str, str, bool, bool]]
    warnings: List[Tuple[str, str, str]]

class BodyState:
    position: npt.NDArray[np.float64]
    orientation: npt.NDArray[np.float64]
    velocity: npt.NDArray[np.float64]
    angular_velocity: npt.NDArray[np.float64]
    force: npt.NDArray[np.float64]
    torque: npt.NDArray[np.float64]

class Frame:
    dimension: int
    step: int
    time: float
    id: npt.NDArray[np.uint64]
    x: npt.NDArray[np.float32]
    v: npt.NDArray[np.float32]
    density: npt.NDArray[np.float32]
    pressure: npt.NDArray[np.float32]
    liquid: npt.NDArray[np.int32]
    bodies: List[BodyState]
    def __len__(self) -> int: ...

class RunFrames:
    scene: CheckedScene
    def __init__(self, folder: _Path) -> None: ...
    def __len__(self) -> int: ...
    def file(self, k: int) -> Path: ...
    def read(self, k: int) -> Frame: ...

class FluidInStep:
    id: npt.NDArray[np.uint64]
    x: _Real
    v: _Real
    density: _Real
    pressure: _Real
    liquid: npt.NDArray[np.int32]
    dimension: int
    def __len__(self) -> int: ...

class Solve:
    name: str
    tolerance: float
    solves: int
    iterations: int
    most_iterations: int
    not_converged: int
    last_iterations: int
    last_error: float
    worst_error: float

class Flow:
    kind: str
    name: str
    particles: int
    volume: float
    rate: float
    waiting: int

class Statistics:
    particles: int
    out_of_bounds: int
    density_mean: float
    density_min: float
    density_max: float
    density_error_mean: float
    density_error_max: float
    speed_mean: float
    speed_max: float
    fastest: int
    height_mean: float
    kinetic_energy: float
    potential_energy: float
    momentum: npt.NDArray[np.float64]
    angular_momentum: npt.NDArray[np.float64]

class TimeSteps:
    last: float
    min: float
    max: float
    ruled: Dict[str, int]
    last_ruled: str
    retried: int

class TimeStepBounds:
    acoustic: float
    force: float
    viscous: float
    flow: float
    capillary: float
    least: float
    ruling: str

class Warning:
    kind: str
    message: str
    first_step: int
    last_step: int
    first_time: float
    unphysical: bool

class Checkpoint:
    steps: int
    time: float

class Moment:
    time: float

class SimulationBase:
    density: _Real
    pressure: _Real
    id: npt.NDArray[np.uint64]
    liquid: npt.NDArray[np.int32]
    time: float
    steps: int
    finished: bool
    threads: int
    scene: CheckedScene
    time_steps: TimeSteps
    warnings: List[Warning]
    @property
    def x(self) -> _Real: ...
    @x.setter
    def x(self, x: npt.ArrayLike) -> None: ...
    @property
    def v(self) -> _Real: ...
    @v.setter
    def v(self, v: npt.ArrayLike) -> None: ...
    def __init__(self, scene: CheckedScene, threads: int = 0, isa: str = "") -> None: ...
    def __len__(self) -> int: ...
    def frame(self) -> Frame: ...
    def step(self, n: int = 1) -> int: ...
    def _step_until(self, time: float, steps: int, seconds: float) -> int: ...
    def bounds(self) -> TimeStepBounds: ...
    def moment(self) -> Moment: ...
    def wall_forces(self, since: Optional[Moment] = None) -> Dict[str, npt.NDArray[np.float64]]: ...
    def boundary_forces(self) -> Dict[str, npt.NDArray[Any]]: ...
    def flows(self, since: Optional[Moment] = None) -> List[Flow]: ...
    def _probes(self) -> List[Any]: ...
    def bodies(self) -> Dict[str, BodyState]: ...
    def solves(self) -> List[Solve]: ...
    def statistics(self) -> Statistics: ...
    def set_force(self, force: Optional[_Force]) -> None: ...
    def set_gravity(self, gravity: Sequence[float]) -> None: ...
    def _change(self, overrides: _Overrides) -> None: ...
    def _push_body(
        self,
        body: int,
        force: Tuple[float, float, float],
        torque: Tuple[float, float, float],
    ) -> None: ...
    def add_particles(
        self, x: npt.ArrayLike, v: Optional[npt.ArrayLike] = None, liquid: int = 0
    ) -> int: ...
    def remove_particles(self, ids: npt.ArrayLike) -> None: ...
    def checkpoint(self) -> Checkpoint: ...
    def restore(self, checkpoint: Checkpoint) -> None: ...
    def save(self, file: _Path) -> None: ...
    def load(self, file: _Path) -> None: ...
    def state_sha256(self) -> str: ...
    def kept_sha256(self) -> str: ...

def load_scene(file: _Path, overrides: _Overrides) -> CheckedScene: ...
def parse_scene(text: str, name: str, overrides: _Overrides) -> CheckedScene: ...
def may_change_while_running(key: str) -> bool: ...
def instruction_set(isa: str = "") -> str: ...
def scene_schema() -> str: ...
def run(
    scene: CheckedScene,
    output: _Path,
    overwrite: bool,
    name: str,
    threads: int,
    isa: str,
    video: Optional[_Path],
    fps: float,
    speed: float,
    progress: Optional[Callable[[float, int], Any]],
) -> str: ...
def plot(
    run: _Path, columns: Sequence[str], output: _Path, against: Sequence[_Path]
) -> List[Path]: ...
