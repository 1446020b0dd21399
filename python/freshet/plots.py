# SPDX-License-Identifier: MIT
"""Charts and pictures by matplotlib, in the style of `freshet plot`."""

from __future__ import annotations

import io
from itertools import cycle
from typing import TYPE_CHECKING, Any, Dict, List, Sequence, Tuple

import numpy as np

from ._freshet import CheckedScene, Frame
from .errors import Error

if TYPE_CHECKING:
    from .runs import Run

COLORS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#8c8c8c"]
"""Colours that colour-blind readers can distinguish [Okabe, Ito 2008]."""
STYLES = ["-", "--", ":", "-."]
SETTINGS = {
    "font.family": "DejaVu Sans",
    "font.size": 8,
    "axes.linewidth": 0.8,
    "axes.edgecolor": "#404040",
    "axes.grid": True,
    "grid.color": "#e0e0e0",
    "grid.linewidth": 0.5,
    "lines.linewidth": 1.4,
    "legend.frameon": False,
    "savefig.dpi": 144,
}


def _style() -> Any:
    import matplotlib
    from cycler import cycler

    return matplotlib.rc_context({**SETTINGS, "axes.prop_cycle": cycler(color=COLORS)})


def _new_figure(width: float, height: float) -> Any:
    """A figure that no window and no global list holds, and that notebooks show."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    class Chart(Figure):
        _repr_png_ = png_of

    figure = Chart(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def png_of(figure: Any) -> bytes:
    """The bytes of a figure as PNG, for notebooks and files."""
    data = io.BytesIO()
    figure.savefig(data, format="png", dpi=144)
    return data.getvalue()


def _panels(run: "Run", names: Sequence[str]) -> Dict[Tuple[str, str], List[str]]:
    """Columns by unit, one panel for each unit."""
    known = run.columns()
    panels: Dict[Tuple[str, str], List[str]] = {}
    for name in names:
        found = [key for key in known if key == name or key.endswith(": " + name)]
        if not found:
            message = f"no column {name!r} over time; columns: {', '.join(known)}"
            raise Error("scene", [("error", str(run.path), message)])
        for key in found:
            unit = known[key].units.get(key.split(": ")[-1], "")
            panels.setdefault((unit, name if not unit else ""), []).append(key)
    return panels


def plot_runs(runs: Sequence["Run"], names: Sequence[str], figure: Any = None) -> Any:
    """Draws columns of runs over time. Each run has a line style, each column a colour."""
    panels = _panels(runs[0], names)
    tables = [run.columns() for run in runs]
    with _style():
        figure = figure or _new_figure(7.2, 0.5 + 1.9 * len(panels))
        axes = figure.subplots(len(panels), 1, sharex=True, squeeze=False)[:, 0]
        for panel, ((unit, _), keys) in zip(axes, panels.items()):
            _draw_panel(panel, keys, tables, runs)
            quantity = keys[0].split(": ")[-1] if len(keys) == 1 else ""
            panel.set_ylabel(f"{quantity} [{unit}]".strip() if unit else quantity)
        axes[-1].set_xlabel("time [s]")
        figure.suptitle(runs[0].scene.title, fontweight="bold", fontsize=10)
    return figure


def _draw_panel(panel: Any, keys: Sequence[str], tables: Sequence[Any], runs: Sequence["Run"]) -> None:
    for style, table, run in zip(cycle(STYLES), tables, runs):
        for color, key in zip(cycle(COLORS), keys):
            if key in table:
                values = table[key][key.split(": ")[-1]]
                label = key if len(runs) == 1 else f"{key} ({run.path.name})"
                panel.plot(table[key]["time"], values, style, color=color, label=label)
    if len(keys) > 1 or len(runs) > 1:
        panel.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    panel.margins(x=0)


def draw_frame(frame: Frame, scene: CheckedScene, color_by: str = "speed", axes: Any = None) -> Any:
    """Draws the particles of a frame into `axes`, or into a new figure. 3D is seen along z.

    `color_by` is "speed", "density", "pressure", "x", "y", "height" (y), "id" or "liquid"; other
    names raise ValueError. Returns the matplotlib.figure.Figure.
    """
    low, high = scene.domain
    size = high[:2] - low[:2]
    with _style():
        if axes is None:
            figure = _new_figure(6.4, max(1.6, min(6.4, 5.2 * size[1] / size[0])))
            axes = figure.subplots()
        order = np.argsort(frame.x[:, -1])  # in 3D the nearest last
        dots = axes.scatter(
            *frame.x[order, :2].T, c=values_of(frame, color_by)[order], cmap="viridis", lw=0,
            s=_area(axes, scene.spacing, size),
        )
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
        axes.set(xlabel="x [m]", ylabel="y [m]", title=f"{frame.time:.4g} s")
        axes.grid(False)
        axes.figure.colorbar(dots, ax=axes, label=LABELS.get(color_by, color_by))
    return axes.figure


LABELS = {
    "speed": "speed [m/s]",
    "density": "density [kg/m³]",
    "pressure": "pressure [Pa]",
    "x": "x [m]",
    "y": "y [m]",
    "height": "height [m]",
}


def _area(axes: Any, spacing: float, size: np.ndarray) -> float:
    """The area of a dot as wide as the spacing [pt²]."""
    box = axes.get_window_extent()
    dots_a_metre = min(box.width / size[0], box.height / size[1]) * 72 / axes.figure.dpi
    return max(1.0, (0.95 * spacing * dots_a_metre) ** 2)


def values_of(frame: Frame, color_by: str) -> np.ndarray:
    """The quantity that colours show (n,), by its name."""
    if color_by == "speed":
        return np.linalg.norm(frame.v, axis=1)
    if color_by in ("x", "y", "height"):
        return frame.x[:, 0 if color_by == "x" else 1]
    if color_by == "liquid" and not len(frame.liquid):
        return np.zeros(len(frame))  # a scene with one liquid has no indices
    if color_by in ("density", "pressure", "id", "liquid"):
        return getattr(frame, color_by)
    known = "speed, density, pressure, x, y, height, id, liquid"
    raise ValueError(f"color_by is {color_by!r}; it must be one of {known}")
