# SPDX-License-Identifier: MIT
"""Run folders: written by run(), read by open_run()."""

from __future__ import annotations

import json
import os
from functools import cached_property
from pathlib import Path
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, Union

import numpy as np

from . import _freshet, plots
from ._freshet import CheckedScene, Frame
from .errors import Error
from .progress import progress_bar
from .scenes import SceneLike, check
from .tables import Table, read_table

PathLike = Union[str, "os.PathLike[str]"]


def run(
    scene: SceneLike,
    output: PathLike,
    set: Optional[Mapping[str, Any]] = None,
    overwrite: bool = False,
    threads: int = 0,
    isa: str = "",
    video: Optional[PathLike] = None,
    fps: float = 30,
    speed: float = 1,
    progress: bool = False,
) -> "Run":
    """Runs a scene into a folder, as `freshet run` does, and opens it.

    `set` replaces keys of the scene, as in freshet.check; `threads` and `isa` are those of
    freshet.Simulation. A folder that holds a run raises freshet.Error unless `overwrite`. `video` is
    a *.mp4, *.gif or *.webp of `fps` pictures per second, at `speed` simulated seconds per second.
    `progress` shows a bar. Ctrl-C ends the run with
    complete files, which `freshet resume` continues, and raises KeyboardInterrupt.
    """
    checked = check(scene, set)
    name = os.fspath(scene) if isinstance(scene, (str, os.PathLike)) else "scene"
    film = None if video is None else Path(video)
    with progress_bar(progress, checked.end, "s") as show:
        bar = (lambda time, steps: show(time)) if progress else None
        _freshet.run(checked, Path(output), overwrite, name, threads, isa, film, fps, speed, bar)
    return open_run(output)


def open_run(folder: PathLike) -> "Run":
    """Opens the folder of a run, which may still be in progress.

    Raises freshet.Error if the folder does not exist or holds no run.
    """
    return Run(folder)


class Frames(Sequence[Frame]):
    """The frames of a run's data files. frames[k] reads file k."""

    def __init__(self, files: _freshet.RunFrames) -> None:
        self._files = files

    def __len__(self) -> int:
        return len(self._files)

    def __getitem__(self, k: Any) -> Any:
        if isinstance(k, slice):
            return [self[i] for i in range(*k.indices(len(self)))]
        if not -len(self) <= k < len(self):
            raise IndexError(f"no frame {k}; the run has {len(self)}")
        return self._files.read(k % len(self))

    def files(self) -> List[Path]:
        """The data files."""
        return [Path(self._files.file(k)) for k in range(len(self))]

    def __repr__(self) -> str:
        return f"<freshet.Frames: {len(self)}>"


class Run:
    """The folder of a run: its frames, tables and report. docs/runs.md describes the files.

    >>> water = freshet.open_run("runs/water")
    >>> water.frames[-1].x, water.observables["speed max"], water.probes["gauge"]["distance"]
    >>> water.plot("speed max")
    """

    def __init__(self, folder: PathLike) -> None:
        self.path = Path(folder)
        """The folder."""
        if not (self.path / "scene.toml").is_file():
            message = "no run is in this folder (it has no scene.toml); name the folder of a run"
            if not self.path.exists():
                message = "no such folder; check the path"
            raise Error("scene", [("error", str(self.path), message)])

    @cached_property
    def scene(self) -> CheckedScene:
        """The scene as run."""
        return check(self.path / "scene.toml")

    @property
    def report(self) -> Dict[str, Any]:
        """report.json: state, statistics, checks, warnings, digests.

        Raises freshet.Error before the run has ended.
        """
        file = self.path / "report.json"
        if not file.is_file():
            message = "no such file; a run writes it at its end"
            raise Error("scene", [("error", str(file), message)])
        return json.loads(file.read_text(encoding="utf-8"))

    @property
    def frames(self) -> Frames:
        """The frames of the data files."""
        return Frames(_freshet.RunFrames(self.path))

    def table(self, file: str) -> Table:
        """A table by its file, for example "measured.csv"."""
        return read_table(self.path / file)

    @property
    def observables(self) -> Table:
        """observables.csv: energies, errors, time steps, forces on walls, flows."""
        return self.table("observables.csv")

    @property
    def percentiles(self) -> Table:
        """percentiles.csv: 1st and 99th percentile of each quantity that colours show."""
        return self.table("percentiles.csv")

    @property
    def probes(self) -> Dict[str, Table]:
        """The table of each probe by name."""
        return {file.stem: read_table(file) for file in sorted((self.path / "probes").glob("*.csv"))}

    @property
    def bodies(self) -> Dict[str, Table]:
        """The rows of each body by name; empty in scenes without bodies."""
        if not (self.path / "bodies.csv").is_file():
            return {}
        all_bodies = self.table("bodies.csv")
        return {str(name): all_bodies.where(all_bodies["body"] == name) for name in np.unique(all_bodies["body"])}

    def columns(self) -> Dict[str, Table]:
        """Every column over time by the name that plot() takes, with its table."""
        tables = {"": self.observables}
        tables.update({f"{name}: ": t for name, t in {**self.probes, **self.bodies}.items()})
        found: Dict[str, Table] = {}
        for owner, table in tables.items():
            times = table["time"] if "time" in table else np.empty(0)
            if len(np.unique(times)) < len(times):
                continue  # several places at one time
            for name in table:
                if name not in ("time", "step") and table[name].dtype.kind == "f":
                    found[owner + name] = table
        return found

    def plot(self, *columns: str, against: Sequence["Run"] = (), figure: Any = None) -> Any:
        """Draws columns over time with matplotlib, in the style of `freshet plot`.

        Columns are named as for `freshet plot --columns`: "speed max", "gauge: distance", "box: y".
        Columns of one unit share a panel. `against` are other runs, in other line styles. Returns the
        matplotlib.figure.Figure.
        """
        return plots.plot_runs([self, *against], columns or ("speed max", "kinetic energy"), figure)

    def draw(self, frame: int = -1, color_by: str = "speed", axes: Any = None) -> Any:
        """Draws a frame with matplotlib, as freshet.draw_frame. Returns the figure."""
        return plots.draw_frame(self.frames[frame], self.scene, color_by, axes)

    def _repr_png_(self) -> Optional[bytes]:
        picture = self.path / "result.png"
        return picture.read_bytes() if picture.is_file() else None

    def __repr__(self) -> str:
        return f"<freshet.Run {str(self.path)!r}>"

    def __iter__(self) -> Iterator[Frame]:
        return iter(self.frames)
