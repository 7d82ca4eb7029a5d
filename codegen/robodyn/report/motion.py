"""A simulated motion as a picture: positions, velocities and torques of all joints over time."""

from __future__ import annotations

import importlib
import io
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import ToolError
from robodyn.logs.log import Log
from robodyn.robot.model import Robot
from robodyn.simulate.trajectories.trajectory import Trajectory

Floats = NDArray[np.float64]

#: Points of a line at most.
POINTS = 4000
_SIZE = (9.0, 7.5)  # inches
_OWN = {"revolute": ("rad", "rad/s", "N m"), "prismatic": ("m", "m/s", "N")}


def motion_picture(robot: Robot, log: Log, kind: str, reference: Trajectory | None = None) -> bytes:
    """The picture of ``log`` as ``kind`` svg or png, the same bytes for the same log.

    A column for revolute joints and one for prismatic ones, a line a joint; the positions of ``reference``
    are dashed. A log without velocities gets no velocities.

    Raises
    ------
    ToolError: matplotlib is missing.
    """
    matplotlib, backend = _matplotlib(kind)
    kinds = [name for name in _OWN if any(link.joint.kind == name for link in robot.links)]
    rows = [("position", log.q), ("velocity", log.qd), ("torque", log.tau)]
    shown = [(name, values, i) for i, (name, values) in enumerate(rows) if values is not None]
    settings = {"svg.hashsalt": "robodyn", "svg.fonttype": "path", "axes.grid": True, "grid.alpha": 0.3}
    with matplotlib.style.context(["default", settings]):
        figure = matplotlib.figure.Figure(figsize=_SIZE, layout="constrained")
        canvas = backend(figure)
        axes = figure.subplots(len(shown), len(kinds), sharex=True, squeeze=False)
        places = _thinned(len(log.t))
        for column, joint_kind in enumerate(kinds):
            joints = [j for j, link in enumerate(robot.links) if link.joint.kind == joint_kind]
            for row, (name, values, unit) in enumerate(shown):
                panel = axes[row][column]
                what = "force" if name == "torque" and joint_kind == "prismatic" else name
                panel.set_ylabel(f"{what} [{_OWN[joint_kind][unit]}]")
                for j in joints:
                    colour = f"C{j % 10}" if robot.n <= 10 else matplotlib.colormaps["viridis"](j / robot.n)
                    panel.plot(log.t[places], values[places, j], color=colour, lw=1, label=f"joint {j + 1}")
                    if name == "position" and reference is not None:
                        seen = _thinned(len(reference.t))
                        panel.plot(reference.t[seen], reference.q[seen, j], "--", color=colour, lw=0.7)
            axes[0][column].legend(fontsize="small", ncols=3, loc="best")
            axes[-1][column].set_xlabel("t [s]")
        figure.suptitle((robot.title or robot.name).replace("$", r"\$"))  # $ begins a formula
        stream = io.BytesIO()
        metadata = {"Date": None} if kind == "svg" else {"Software": None}
        canvas.print_figure(stream, format=kind, metadata=metadata, dpi=120)
    return stream.getvalue()


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
        raise ToolError(
            "a picture needs matplotlib, which is not installed", remedy="pip install matplotlib"
        ) from None
