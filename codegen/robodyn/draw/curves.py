"""Curves in frames as SVG, the same bytes at any time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

from robodyn.draw.markup import markup_template

BLUE, ORANGE, GREEN, RED, GREY = "#1f5fa8", "#d9822b", "#3a8f5c", "#b03a48", "#666666"
COLOURS: Final = (BLUE, ORANGE, GREEN, RED, GREY)
_WIDTH, _HEIGHT, _LEFT, _TOP, _GAP = 430, 230, 70, 85, 90
_KEY: Final = 18
_TICKS: Final = 6


@dataclass(frozen=True, slots=True)
class Curve:
    """A line through ``x`` and ``y``; its name stands in the key."""

    name: str
    x: Sequence[float]
    y: Sequence[float]
    dashed: bool = False


@dataclass(frozen=True, slots=True)
class Panel:
    """Curves in one frame; ``subtitle`` names the axes."""

    title: str
    subtitle: str
    curves: tuple[Curve, ...]


def figure(title: str, note: str, panels: Sequence[Panel]) -> str:
    """An SVG of ``panels``, two beside each other, with ``note`` above."""
    keys = max(len(panel.curves) for panel in panels)
    pitch = _TOP + _HEIGHT + 40 + _KEY * keys
    columns = min(2, len(panels))
    drawn = [
        _drawn(panel, _LEFT + (k % 2) * (_WIDTH + _GAP), _TOP + (k // 2) * pitch)
        for k, panel in enumerate(panels)
    ]
    return markup_template("curves.svg.j2").render(
        width=_LEFT + columns * _WIDTH + (columns - 1) * _GAP + 30,
        height=-(-len(panels) // 2) * pitch + 10,
        title=title,
        note=note,
        left=_LEFT,
        panels=drawn,
    )


def _drawn(panel: Panel, x: int, y: int) -> dict[str, Any]:
    across = ticks([v for curve in panel.curves for v in curve.x], tight=True)
    up = ticks([v for curve in panel.curves for v in curve.y])
    lines: list[dict[str, str]] = []
    legend: list[dict[str, Any]] = []
    for k, curve in enumerate(panel.curves):
        stroke = COLOURS[k % len(COLOURS)]
        dashes = "6 4" if curve.dashed else ""
        points = " ".join(
            f"{_WIDTH * share(a, across):.1f},{_HEIGHT * (1 - share(b, up)):.1f}"
            for a, b in zip(curve.x, curve.y, strict=True)
        )
        lines.append({"points": points, "stroke": stroke, "dashes": dashes, "name": curve.name})
        y_key = _HEIGHT + 42 + _KEY * k
        legend.append({"y": y_key, "stroke": stroke, "label": curve.name, "dashes": dashes})
    return {
        "x": x, "y": y, "width": _WIDTH, "height": _HEIGHT, "label_y": _HEIGHT + 18,
        "title": panel.title, "subtitle": panel.subtitle, "lines": lines, "legend": legend,
        "x_ticks": [{"at": f"{_WIDTH * share(v, across):.1f}", "label": f"{v:g}"} for v in across],
        "y_ticks": [{"at": f"{_HEIGHT * (1 - share(v, up)):.1f}", "label": f"{v:g}"} for v in up],
    }  # fmt: skip


def share(value: float, marks: Sequence[float]) -> float:
    """Where ``value`` is between the first and the last of ``marks``, as a share of the way."""
    return (value - marks[0]) / (marks[-1] - marks[0])


def ticks(values: Sequence[float], *, tight: bool = False) -> list[float]:
    """Round numbers, evenly spaced, around all of ``values``; with ``tight`` more of them."""
    low, high = min(values), max(values)
    if high - low <= 1e-9 * max(abs(low), abs(high)):
        low, high = low - 0.5, high + 0.5
    rough = (high - low) / (_TICKS + 4 * tight)
    size = 10.0 ** math.floor(math.log10(rough))
    step = size * next((m for m in (1, 2, 5) if m * size >= rough), 10)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    return [round(k * step, 12) for k in range(first, last + 1)]
