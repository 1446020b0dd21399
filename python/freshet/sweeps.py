# SPDX-License-Identifier: MIT
"""Parameter sweeps in several processes."""

from __future__ import annotations

import itertools
import multiprocessing
import os
import pickle
import sys
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence

from . import progress as bars
from .errors import Error
from .scenes import CheckedScene, SceneLike, check
from .simulation import Simulation
from .tables import Table

Measure = Callable[[Simulation], Mapping[str, float]]


class _Job(NamedTuple):
    scene: Any
    set: Dict[str, Any]
    values: Dict[str, Any]
    """Of the parameters."""
    measure: Measure
    until: Optional[float]
    threads: int


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

    `parameters` has a list of values for each key of the scene. `measure(sim)` returns a dict of
    numbers at time `until` [s], by default at time.end. `set` replaces other keys. `progress` shows a
    bar. Returns a table with a row for each combination: the parameters, then the measurements, NaN
    where a name is missing.

    Each simulation runs with `threads` threads, and `processes` of them at once; by default one for
    each processor. Other processes must be able to import `measure`: it is a function of a module, or
    of a script that begins its work below `if __name__ == "__main__":`. In a notebook, or for a
    lambda, use `processes=1`, which runs all in this process.

    Raises freshet.Error before the first run if a combination is invalid, and after the first run
    that fails; the message names its parameters.
    """
    combinations = _combinations(parameters)
    if isinstance(scene, CheckedScene):
        raise TypeError("a sweep needs a file, a dict or a freshet.Scene, not a checked scene")
    jobs = [_Job(scene, dict(set or {}), values, measure, until, threads) for values in combinations]
    for job in jobs:
        check(scene, {**job.set, **job.values})
    results = _results(jobs, min(processes or os.cpu_count() or 1, len(jobs)), progress)
    rows = [{**values, **result} for values, result in zip(combinations, results)]
    names = list(dict.fromkeys(name for row in rows for name in row))
    return Table({name: [row.get(name, float("nan")) for row in rows] for name in names}, {}, "sweep")


def _combinations(parameters: Mapping[str, Sequence[Any]]) -> List[Dict[str, Any]]:
    for key, values in parameters.items():
        if isinstance(values, (str, bytes)) or not hasattr(values, "__len__"):
            raise TypeError(f"parameters[{key!r}] is {values!r}; it must be a list of values")
        if not len(values):
            raise ValueError(f"parameters[{key!r}] is empty; give at least one value")
    return [dict(zip(parameters, values)) for values in itertools.product(*parameters.values())]


def _measure(job: _Job) -> Dict[str, float]:
    try:
        sim = Simulation(job.scene, set={**job.set, **job.values}, threads=job.threads)
        sim.run(until=job.until)
        measured = job.measure(sim)
    except Error as error:
        place = ", ".join(f"{key} = {value}" for key, value in job.values.items())
        found = [(d.severity, d.place or place, d.message) for d in error.diagnostics]
        raise Error(error.kind, found) from None
    if not isinstance(measured, Mapping):
        raise TypeError(f"measure returned {measured!r}; it must return a dict of numbers by name")
    return {name: float(value) for name, value in measured.items()}


def _results(jobs: Sequence[_Job], processes: int, progress: bool) -> List[Dict[str, float]]:
    with bars.progress_bar(progress, len(jobs), "runs") as show:
        if processes > 1:
            _check_importable(jobs[0].measure)
            return _in_processes(jobs, processes, show)
        results: List[Dict[str, float]] = []
        for job in jobs:
            results.append(_measure(job))
            show(len(results))
        return results


def _check_importable(measure: Measure) -> None:
    """Rejects a function that another process cannot import."""
    main = sys.modules["__main__"]
    try:
        pickle.dumps(measure)
        found = getattr(measure, "__module__", "") != "__main__" or hasattr(main, "__file__")
    except (pickle.PicklingError, AttributeError, TypeError):
        found = False
    if not found:
        raise ValueError(
            f"other processes cannot import {measure!r}; define it with def in a module or a script, "
            "or use processes=1"
        )


def _in_processes(
    jobs: Sequence[_Job], processes: int, show: Callable[[float], None]
) -> List[Dict[str, float]]:
    # New processes: a forked process would wait forever for the OpenMP threads of its parent.
    with ProcessPoolExecutor(processes, multiprocessing.get_context("spawn")) as pool:
        try:
            runs = [pool.submit(_measure, job) for job in jobs]
            for done, run in enumerate(as_completed(runs), 1):
                run.result()  # raises the error of the run
                show(done)
            return [run.result() for run in runs]
        except BrokenProcessPool:
            message = (
                "a process ended without a result; begin the work of a script below "
                '`if __name__ == "__main__":`, and check that memory suffices for all processes'
            )
            raise Error("run", [("error", "sweep", message)]) from None
        finally:
            pool.shutdown(wait=True, cancel_futures=True)
