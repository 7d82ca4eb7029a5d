"""A simulated motion as a picture: a row a joint with its position, velocity and torque over time."""

from __future__ import annotations

import importlib
import io
from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.draw import style
from robodyn.logs.log import Log
from robodyn.report.figures import UNITS
from robodyn.robot.model import Robot
from robodyn.simulate.trajectories.trajectory import Trajectory
from robodyn.tools.libraries import MATPLOTLIB

Floats = NDArray[np.float64]

#: Points of a line at most.
POINTS: Final = 2000
#: Sizes in px: a panel, what is between panels, and the margins of the picture.
_PANEL, _BETWEEN = (290, 84), (70, 22)
_LEFT, _RIGHT, _TOP, _BOTTOM = 118, 20, 84, 52
#: What is left of the panels where joints of both kinds have their units there.
_LEFT_MIXED: Final = 178


def motion_picture(robot: Robot, log: Log, kind: str, reference: Trajectory | None = None) -> bytes:
    """The picture of ``log`` as ``kind`` svg or png, the same bytes for the same log.

    Each panel has a scale of its own; the positions of ``reference`` are dashed. A log without velocities
    gets no velocities.

    Raises
    ------
    ToolError: matplotlib is missing.
    """
    matplotlib, backend = _matplotlib(kind)
    known = (("position", log.q), ("velocity", log.qd), ("torque", log.tau))
    shown = [(name, values) for name, values in known if values is not None]
    left = _LEFT if len({link.joint.kind for link in robot.links}) == 1 else _LEFT_MIXED
    sizes = [
        before + count * size + (count - 1) * between + after
        for before, count, size, between, after in (
            (left, len(shown), _PANEL[0], _BETWEEN[0], _RIGHT),
            (_TOP, robot.n, _PANEL[1], _BETWEEN[1], _BOTTOM),
        )
    ]
    with matplotlib.style.context(["default", style.matplotlib_settings()]):
        figure = matplotlib.figure.Figure(figsize=[style.PX * size for size in sizes])
        canvas = backend(figure)
        grid = figure.add_gridspec(
            robot.n, len(shown), left=left / sizes[0], right=1 - _RIGHT / sizes[0],
            top=1 - _TOP / sizes[1], bottom=_BOTTOM / sizes[1],
            wspace=_BETWEEN[0] / _PANEL[0], hspace=_BETWEEN[1] / _PANEL[1],
        )  # fmt: skip
        axes = grid.subplots(sharex=True, squeeze=False)
        _words(figure, axes, robot, [name for name, _ in shown], left, reference is not None)
        places = _thinned(len(log.t))
        for j in range(robot.n):
            for panel, (name, values) in zip(axes[j], shown, strict=True):
                if name == "position" and reference is not None:
                    there = _thinned(len(reference.t))
                    drawn = panel.plot(reference.t[there], reference.q[there, j], color=style.VERMILION)
                    drawn[0].set(dashes=(4, 2), zorder=3)
                panel.plot(log.t[places], values[places, j], color=style.BLUE)
                panel.margins(x=0)
                panel.locator_params(axis="y", nbins=4, min_n_ticks=3)
        stream = io.BytesIO()
        metadata = {"Date": None} if kind == "svg" else {"Software": None}
        canvas.print_figure(stream, format=kind, metadata=metadata, dpi=1.25 / style.PX)
    return stream.getvalue()


def _words(figure: Any, axes: Any, robot: Robot, names: Sequence[str], left: int, followed: bool) -> None:
    """Title, what each column and each row is, units and time."""
    high = figure.get_figheight()
    x, right = style.PX * 16 / figure.get_figwidth(), 1 - style.PX * _RIGHT / figure.get_figwidth()
    title = (robot.title or robot.name).replace("$", r"\$")  # $ begins a formula
    figure.suptitle(title, x=x, y=1 - style.PX * 14 / high, ha="left", va="top")
    if followed:
        words = {"size": style.POINT * style.TEXT, "color": style.SOFT, "ha": "right", "va": "top"}
        figure.text(right, 1 - style.PX * 18 / high, "dashed: the reference", **words)
    kinds = {link.joint.kind for link in robot.links}
    for panel, name in zip(axes[0], names, strict=True):
        what = "torque, force" if name == "torque" and "prismatic" in kinds else name
        unit = f" [{UNITS[next(iter(kinds))][name]}]" if len(kinds) == 1 else ""
        panel.set_title(f"{what}{unit}", pad=style.POINT * 12)
    for j, link in enumerate(robot.links):
        units = ", ".join(UNITS[link.joint.kind][name] for name in names)
        own = f"joint {j + 1}" if len(kinds) == 1 else f"joint {j + 1}\n[{units}]"
        axes[j][0].set_ylabel(own, rotation=0, ha="left", va="center", color=style.INK)
        axes[j][0].yaxis.set_label_coords((16 - left) / _PANEL[0], 0.5)
    for panel in axes[-1]:
        panel.set_xlabel("t [s]")


def _thinned(samples: int) -> Sequence[int] | Floats:
    """Places of the samples that are drawn, first and last among them."""
    places: Floats = np.unique(np.linspace(0, samples - 1, min(samples, POINTS)).astype(int))
    return places


def _matplotlib(kind: str) -> tuple[Any, Any]:
    try:
        for name in ("figure", "style"):
            importlib.import_module(f"matplotlib.{name}")
        canvas = importlib.import_module(f"matplotlib.backends.backend_{'svg' if kind == 'svg' else 'agg'}")
        backend = canvas.FigureCanvasSVG if kind == "svg" else canvas.FigureCanvasAgg
        return importlib.import_module("matplotlib"), backend
    except ImportError:
        raise MATPLOTLIB.missing() from None
