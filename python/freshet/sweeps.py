# SPDX-License-Identifier: MIT
"""Parameter sweeps in several processes."""

from __future__ import annotations

import itertools
import multiprocessing
import os
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

from .scenes import CheckedScene, SceneLike, check
from .simulation import Simulation
from .tables import Table
from . import progress as bars

Measure = Callable[[Simulation], Mapping[str, float]]
_Job = Tuple[Any, Dict[str, Any], Measure, Optional[float], int]


def sweep(
    scene: SceneLike,
    parameters: Mapping[str, Sequence[Any]],
    measure: Measure,
    until: Optional[float] = None,
    processes: Optional[int] = None,
    threads: int = 1,
    set: Optional[Mapping[str, Any]] = None,
    progress: bool = False,
) -> Table:
    """Runs a scene for every combination of parameters, and measures each at the end.

    >>> def front(sim):
    ...     return {"front": sim.x[:, 0].max()}
    >>> freshet.sweep("dam_break_2d", {"fluid.viscosity": [0.1, 1, 10]}, front, until=0.3)

    `parameters` has a list of values for each key of the scene, `measure(sim)` returns numbers by
    name. Every simulation is a process of its own with `threads` threads; `processes` of them run at
    once, by default one for each processor. `measure` must be a function of a module, and a script
    must begin its work below `if __name__ == "__main__":`, as for multiprocessing. With
    `processes=1` all run in this process, without these limits.

    Returns a table with a row for each combination: the parameters, then the measurements.
    """
    keys = list(parameters)
    combinations = [dict(zip(keys, values)) for values in itertools.product(*parameters.values())]
    source = _portable(scene)
    fixed = dict(set or {})
    jobs = [(source, {**fixed, **values}, measure, until, threads) for values in combinations]
    for _, values, *_ in jobs:
        check(source, values)  # errors before the first run
    results = _results(jobs, min(processes or os.cpu_count() or 1, len(jobs)), progress)
    rows = [{**values, **result} for values, result in zip(combinations, results)]
    names = list(dict.fromkeys(name for row in rows for name in row))
    return Table({name: [row.get(name, float("nan")) for row in rows] for name in names}, {}, "sweep")


def _portable(scene: SceneLike) -> Any:
    """A scene that another process can read."""
    if isinstance(scene, CheckedScene):
        raise TypeError("a sweep needs a file, a dict or a freshet.Scene, not a checked scene")
    return scene


def _measure(job: _Job) -> Dict[str, float]:
    scene, values, measure, until, threads = job
    sim = Simulation(scene, set=values, threads=threads)
    sim.run(until=until)
    return {name: float(value) for name, value in measure(sim).items()}


def _results(jobs: Sequence[_Job], processes: int, progress: bool) -> List[Dict[str, float]]:
    results: List[Dict[str, float]] = []
    with bars.progress_bar(progress, len(jobs), "runs") as show:
        if processes == 1:
            for job in jobs:
                results.append(_measure(job))
                show(len(results))
            return results
        # New processes: a fork of one whose OpenMP threads exist would wait for them forever.
        with multiprocessing.get_context("spawn").Pool(processes) as pool:
            for result in pool.imap(_measure, jobs):
                results.append(result)
                show(len(results))
    return results
