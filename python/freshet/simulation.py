# SPDX-License-Identifier: MIT
"""A simulation in memory."""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from numbers import Integral
from typing import Any, Callable, Dict, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _freshet, plots
from .errors import Error
from .progress import progress_bar
from .scenes import SceneLike, check, overrides


_LATEST = sys.float_info.max
"""In place of an infinite time, from which no tolerance can be subtracted."""


@dataclass(frozen=True)
class Probe:
    """What a probe measures now."""

    name: str
    places: np.ndarray
    """Where (n, D) [m]; empty for `surface` and `wall` probes."""
    values: Dict[str, np.ndarray]
    """By quantity (n,); NaN outside the fluid."""
    units: Dict[str, str]

    def __getitem__(self, quantity: str) -> np.ndarray:
        return self.values[quantity]


class Simulation(_freshet.SimulationBase):
    """A simulation in memory: it writes no file and prints nothing.

    >>> sim = freshet.Simulation("dam_break_2d", set={"time.end": 0.5})
    >>> sim.run(until=0.2)
    >>> sim.x.max(axis=0)

    `scene` is a file, the name of a bundled scene, a dict, a freshet.Scene or a checked scene;
    `set` replaces keys of it, as in freshet.check. `threads` is the number of threads; 0 uses all
    processors, but at most one for every 2048 particles. `isa` is an instruction set: "avx512",
    "avx2", "sse42" or "plain"; "" uses the best. Neither changes the bits of results. Invalid scenes
    raise freshet.Error.

    The arrays x, v, density, pressure, id and liquid show the memory of the simulation without a
    copy. They are read-only, and an array never changes: when the simulation moves on, an array that
    is still in use keeps its memory, and the simulation takes other memory. All have one order, which
    changes from step to step; frame() has the order of ids.

    Several threads may use one simulation, one at a time; several simulations run at the same time.
    """

    def __init__(
        self,
        scene: SceneLike,
        set: Optional[Mapping[str, Any]] = None,
        threads: int = 0,
        isa: str = "",
    ) -> None:
        super().__init__(check(scene, set), threads, isa)

    def run(
        self,
        until: Optional[float] = None,
        every: Optional[Union[int, float]] = None,
        callback: Optional[Callable[["Simulation"], Any]] = None,
        progress: bool = False,
    ) -> "Simulation":
        """Steps until a time [s]; by default to time.end. An infinite time leaves the end to `callback`.

        `callback(sim)` is called at the start, at the end and between: after every `every` steps if
        that is an int, after the first step at or beyond each multiple of `every` seconds if it is a
        float, else after every step. The run ends early if it returns False. `progress` shows a bar,
        by tqdm if that is installed. Returns the simulation.

        Raises freshet.Error if a step fails, and KeyboardInterrupt after Ctrl-C.
        """
        until = self.scene.end if until is None else float(until)
        if math.isnan(until):
            raise ValueError("until is NaN; it must be a time [s]")
        if every is not None and not (every > 0 and math.isfinite(every)):
            raise ValueError(f"every is {every}; it must be a positive number of steps or seconds")
        call = callback or (lambda sim: None)
        with progress_bar(progress, until, "s") as show:
            going = _continues(call(self))
            while going and not self._reached(until):
                self._advance(until, every if callback else math.inf, show)
                going = _continues(call(self))
        return self

    def _reached(self, time: float) -> bool:
        return self.time >= time - 1e-9 * abs(time)

    def _advance(self, until: float, every: Optional[Union[int, float]], show: Callable) -> None:
        """Steps to the next call of run()."""
        by_steps = every is None or isinstance(every, Integral)
        steps = int(every or 1) if by_steps else 2**62
        time = until
        if every is not None and not by_steps and every < math.inf:
            time = min(until, (math.floor(self.time / every + 1e-9) + 1) * every)
        while steps > 0 and not self._reached(time):
            steps -= self._step_until(min(time, _LATEST), steps, 0.1)
            show(self.time)

    def change(self, set: Mapping[str, Any]) -> None:
        """Changes keys of the scene and keeps the state: gravity, viscosities, inlet speeds, ...

        freshet.may_change_while_running(key) returns whether a key may change; others raise
        freshet.Error. The next steps have the bits of a
        simulation of the changed scene that resumes from this state.
        """
        self._change(overrides(set))

    def set_body_force(self, functions: Optional[Sequence[str]]) -> None:
        """An acceleration beside gravity [m/s²], as functions of x, y, z and t, one per axis.

        >>> sim.set_body_force(["2*sin(10*t)", "0"])

        It is the key domain.body_force. Checkpoints of the changed scene hold it. None removes it.
        """
        if functions is not None:
            return self.change({"domain.body_force": list(functions)})
        is_set = any(key == "domain.body_force" and set for key, _, _, _, set, _ in self.scene.keys)
        if is_set:
            self.change({"domain.body_force": None})

    def remove_particles(self, ids: npt.ArrayLike) -> None:
        """Removes the particles with these ids (k,).

        >>> sim.remove_particles(sim.id[sim.x[:, 0] > 1.0])

        Raises freshet.Error if an id is unknown or occurs twice, and TypeError for a mask.
        """
        numbers = np.asarray(ids)
        if numbers.size and numbers.dtype.kind not in "iu":
            raise TypeError(f"ids are integers, not {numbers.dtype}; for a mask use sim.id[mask]")
        super().remove_particles(numbers)

    def push_body(
        self,
        body: Union[int, str],
        force: Sequence[float],
        torque: Union[float, Sequence[float]] = 0.0,
    ) -> None:
        """Pulls a free body until the next call, with a force and a torque beside gravity.

        `body` is its name or its index, `force` has D components [N; N/m in 2D]. `torque` acts about
        the centre of mass: three components, or a number about z [N m; N m/m in 2D]. Zeros end the
        pull. Raises freshet.Error if the body is unknown or not free.
        """
        turn = np.zeros(3)
        if np.ndim(torque) == 0:
            turn[2] = torque
        else:
            turn[:] = torque
        pull = np.zeros(3)
        pull[: len(force)] = force
        index = self._body_index(body)
        self._push_body(index, (pull[0], pull[1], pull[2]), (turn[0], turn[1], turn[2]))

    def _body_index(self, body: Union[int, str]) -> int:
        if isinstance(body, int):
            return body
        names = list(self.bodies())
        if body in names:
            return names.index(body)
        known = ", ".join(names) or "the scene has none"
        raise Error("scene", [("error", "", f"no body is named {body!r}; bodies: {known}")])

    def probes(self) -> Dict[str, Probe]:
        """The present readings of the scene's probes by name, as freshet.Probe."""
        return {name: _probe(name, *rest) for name, *rest in self._probes()}

    def draw(self, color_by: str = "speed", axes: Any = None) -> Any:
        """Draws the particles with matplotlib, as freshet.draw_frame. Returns the figure."""
        return plots.draw_frame(self.frame(), self.scene, color_by, axes)

    def __repr__(self) -> str:
        title = self.scene.title or self.scene.solver
        return (
            f"<freshet.Simulation {title!r}: {len(self)} particles, step {self.steps}, "
            f"{self.time:.6g} s>"
        )


def _continues(answer: Any) -> bool:
    """Whether run() continues after a callback: not after False, of Python or of NumPy."""
    return not (isinstance(answer, (bool, np.bool_)) and not answer)


def _probe(
    name: str,
    quantities: Sequence[Tuple[str, str]],
    places: Sequence[Sequence[float]],
    values: Sequence[Sequence[float]],
) -> Probe:
    columns = np.asarray(values, dtype=float).reshape(len(places), len(quantities)).T
    at = np.asarray([place for place in places if place], dtype=float)
    return Probe(
        name, at, {q: column for (q, _), column in zip(quantities, columns)}, dict(quantities)
    )
