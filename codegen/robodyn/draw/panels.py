"""Panels of curves and bars as SVG, the same bytes at any time. Names stand beside what they name."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from robodyn.draw import style
from robodyn.draw.markup import markup_template
from robodyn.draw.scales import decades, label, share, ticks

#: A frame in px, what is above it (title and label of the axis), and below it (ticks and label).
WIDTH, HEIGHT = 360, 220
_ABOVE, _BELOW = 54, 44
#: The head of a picture, and the space between rows of panels.
_HEAD, _GAP = 64, 28
#: Names beside a frame: from where, how long the stroke before one is, how wide one may be.
_NAMES, _STROKE, _WIDEST = 18, 14, 185
#: Ends of curves nearer than so many px are told apart before, within so many percent of their points.
_APART, _BEFORE = 4, 15
#: Bars: their widest in px, their share of a group's place, the size of their figures.
_BAR, _FILLED, _FIGURE = 40, 0.84, 11


@dataclass(frozen=True, slots=True)
class Curve:
    """A line through ``x`` and ``y``, its name at its end; ``colour``: None for the next of the series."""

    name: str
    x: Sequence[float]
    y: Sequence[float]
    dashed: bool = False
    colour: str | None = None


@dataclass(frozen=True, slots=True)
class Bars:
    """A bar in each category of a panel, from 0 up to ``heights`` (None: no bar); ``pale``: outlined in its
    colour only."""

    name: str
    heights: Sequence[float | None]
    colour: str | None = None
    pale: bool = False


@dataclass(frozen=True, slots=True)
class Panel:
    """Curves, or bars by ``categories``, in one frame; ``logarithmic`` is the vertical axis of curves, or
    begins at 0 (``from_zero``; that of bars always does).

    Raises
    ------
    ValueError: bars on a logarithmic axis, which has no 0 to begin at; bars that are not one a category.
    """

    title: str
    x_label: str
    y_label: str
    curves: tuple[Curve, ...] = ()
    bars: tuple[Bars, ...] = ()
    categories: tuple[str, ...] = ()
    logarithmic: bool = False
    from_zero: bool = False

    def __post_init__(self) -> None:
        if self.bars and self.logarithmic:
            raise ValueError(f"{self.title}: bars begin at 0, which a logarithmic axis does not have")
        if any(len(bars.heights) != len(self.categories) for bars in self.bars):
            raise ValueError(f"{self.title}: a bar for each of {len(self.categories)} categories is needed")


@dataclass(frozen=True, slots=True)
class _Axes:
    """Ticks of a panel ``width`` px wide, and where values are in it: px from the left and from the top."""

    width: int
    across: list[float]
    up: list[float]
    logarithmic: bool

    @classmethod
    def of(cls, panel: Panel, width: int) -> _Axes:
        places = [v for curve in panel.curves for v in curve.x] or [0, 1]
        across = ticks(places, tight=True, whole=all(v == int(v) for v in places))
        values = [v for curve in panel.curves for v in curve.y]
        values += [v for bars in panel.bars for v in bars.heights if v is not None]
        values += [0.0] if panel.bars or panel.from_zero else []
        return cls(width, across, decades(values) if panel.logarithmic else ticks(values), panel.logarithmic)

    def x(self, value: float) -> float:
        return self.width * share(value, self.across)

    def y(self, value: float) -> float:
        if self.logarithmic:
            return HEIGHT * (1 - share(math.log10(value), [math.log10(mark) for mark in self.up]))
        return HEIGHT * (1 - share(value, self.up))


def figure(title: str, note: str, panels: Sequence[Panel], *, columns: int = 2, width: int = WIDTH) -> str:
    """An SVG of ``panels``, each ``width`` px wide and ``columns`` beside each other, under ``title`` and
    ``note``."""
    columns = min(columns, len(panels))
    axes = [_Axes.of(panel, width) for panel in panels]
    left = style.MARGIN + 8 + max(style.text_width(label(mark)) for one in axes for mark in one.up)
    names = [_names(panel, one) for panel, one in zip(panels, axes, strict=True)]
    beside = max(
        (style.text_width(line) for each in names for name in each for line in name["lines"]), default=0
    )
    beside = _NAMES + _STROKE + 6 + beside if beside else 12
    below = max((name["bottom"] for each in names for name in each), default=0)
    pitch = (left + width + beside, _ABOVE + max(HEIGHT + _BELOW, below) + _GAP)
    drawn = [
        _drawn(panel, one, beside_it)
        | {
            "x": f"{left + (k % columns) * pitch[0]:.0f}",
            "y": f"{_HEAD + _ABOVE + (k // columns) * pitch[1]:.0f}",
        }
        for k, (panel, one, beside_it) in enumerate(zip(panels, axes, names, strict=True))
    ]
    return markup_template("panels.svg.j2").render(
        style=style,
        width=f"{max(columns * pitch[0] + style.MARGIN, style.head_width(title, note)):.0f}",
        height=f"{_HEAD + -(-len(panels) // columns) * pitch[1]:.0f}",
        frame={"width": width, "height": HEIGHT},
        title=title,
        note=note,
        panels=drawn,
    )


def _drawn(panel: Panel, axes: _Axes, names: list[dict[str, Any]]) -> dict[str, Any]:
    bars = _bars(panel, axes)
    if panel.categories:
        slot = axes.width / len(panel.categories)
        across = [(slot * (k + 0.5), style.wrapped(text, slot)) for k, text in enumerate(panel.categories)]
    else:
        across = [(axes.x(mark), [label(mark)]) for mark in axes.across]
    return {
        "title": panel.title, "x_label": panel.x_label, "y_label": panel.y_label,
        "x_label_y": HEIGHT + 23 + style.LEADING * max(len(lines) for _, lines in across),
        "lines": [
            {
                "points": " ".join(
                    f"{axes.x(a):.1f},{axes.y(b):.1f}" for a, b in zip(curve.x, curve.y, strict=True)
                ),
                "stroke": colour, "dashed": curve.dashed, "name": curve.name,
            }
            for curve, colour in zip(panel.curves, _colours(panel.curves), strict=True)
        ],
        "bars": bars, "names": names,
        "x_ticks": [{"at": f"{x:.1f}", "lines": lines} for x, lines in across],
        "y_ticks": [{"at": f"{axes.y(mark):.1f}", "label": label(mark)} for mark in axes.up],
        "zero": f"{axes.y(0):.1f}" if not panel.logarithmic and axes.up[0] <= 0 <= axes.up[-1] else None,
    }  # fmt: skip


def _colours(series: Sequence[Curve | Bars]) -> list[str]:
    return [one.colour or style.SERIES[k % len(style.SERIES)] for k, one in enumerate(series)]


def _bars(panel: Panel, axes: _Axes) -> list[dict[str, Any]]:
    if not panel.bars:
        return []
    slot = axes.width / len(panel.categories)
    wide = min(_BAR, _FILLED * slot / len(panel.bars))
    figures = [f"{height:g}" for bars in panel.bars for height in bars.heights if height is not None]
    fit = style.text_width(max(figures, key=len, default=""), _FIGURE) <= wide + 6
    drawn = []
    for k, category in enumerate(panel.categories):
        group = [
            (bars, colour, height)
            for bars, colour in zip(panel.bars, _colours(panel.bars), strict=True)
            if (height := bars.heights[k]) is not None
        ]
        for i, (bars, colour, height) in enumerate(group):
            x, y = slot * (k + 0.5) + (i - len(group) / 2) * wide, axes.y(height)
            text = f"{height:g}"
            drawn.append(
                {
                    "x": f"{x + 1:.1f}", "y": f"{y:.1f}", "width": f"{wide - 2:.1f}",
                    "height": f"{HEIGHT - y:.1f}", "stroke": colour,
                    "fill": style.pale(colour) if bars.pale else colour, "label": text if fit else "",
                    "middle": f"{x + wide / 2:.1f}", "label_y": f"{y - 5:.1f}", "size": _FIGURE,
                    "name": f"{category}, {bars.name}: {text}",
                }
            )  # fmt: skip
    return drawn


# --- names --------------------------------------------------------------------------------------------------


def _names(panel: Panel, axes: _Axes) -> list[dict[str, Any]]:
    """Where the names beside a frame stand: those of curves near their ends, those of bars from the top."""
    series: Sequence[Curve | Bars] = panel.curves or panel.bars
    ends = _ends(panel.curves, axes)
    entries: list[dict[str, Any]] = []
    for k, (one, colour) in enumerate(zip(series, _colours(series), strict=True)):
        if not one.name:
            continue
        entry: dict[str, Any] = {"lines": style.wrapped(one.name, _WIDEST), "stroke": colour, "swatch": None}
        if isinstance(one, Curve):
            x, y = ends[k]
            entry |= {"dashed": one.dashed, "from_x": x, "at": y}
        else:
            entry |= {"swatch": style.pale(colour) if one.pale else colour, "at": 0.0}
        entries.append(entry)
    placed = spread([(e["at"], style.LEADING * len(e["lines"]) + 4) for e in entries], HEIGHT)
    for entry, middle in zip(entries, placed, strict=True):
        first = middle - style.LEADING * (len(entry["lines"]) - 1) / 2
        entry |= {
            "x": axes.width + _NAMES, "to_x": axes.width + _NAMES + _STROKE,
            "text_x": axes.width + _NAMES + _STROKE + 6,
            "middle": f"{middle:.1f}", "bottom": middle + style.LEADING * len(entry["lines"]) / 2,
            "rows": [
                {"y": f"{first + style.LEADING * k:.1f}", "text": line}
                for k, line in enumerate(entry["lines"])
            ],
        }  # fmt: skip
        if entry["swatch"] is None:
            entry |= {"from_x": f"{entry['from_x']:.1f}", "from_y": f"{entry['at']:.1f}"}
    return entries


def _ends(curves: Sequence[Curve], axes: _Axes) -> list[tuple[float, float]]:
    """Where the name of each curve is joined to it: at its end, or a little before where the ends meet."""

    def at(part: float) -> list[tuple[float, float]]:
        ordered = [sorted(zip(curve.x, curve.y, strict=True), key=lambda point: point[0]) for curve in curves]
        ends = [points[-1 - int(part * (len(points) - 1))] for points in ordered]
        return [(axes.x(x), axes.y(y)) for x, y in ends]

    def apart(places: list[tuple[float, float]]) -> float:
        return min((b - a for a, b in pairwise(sorted(y for _, y in places))), default=math.inf)

    last = at(0.0)
    if apart(last) >= _APART:
        return last
    best = max((at(k / 100) for k in range(1, _BEFORE + 1)), key=apart)
    return best if apart(best) >= apart(last) + _APART else last


def spread(wanted: Sequence[tuple[float, float]], room: float) -> list[float]:
    """Middles of things of known heights, near where they are wanted, in the same order, none over another.

    ``wanted``: middle and height of each; they stay between 0 and ``room`` as far as there is room.
    """
    order = sorted(range(len(wanted)), key=lambda k: (wanted[k][0], k))
    tops = [0.0] * len(wanted)
    least = min(0.0, room - sum(height for _, height in wanted)) / 2
    for k in order:
        tops[k] = max(wanted[k][0] - wanted[k][1] / 2, least)
        least = tops[k] + wanted[k][1]
    most = max(room, sum(height for _, height in wanted))
    for k in reversed(order):
        tops[k] = min(tops[k], most - wanted[k][1])
        most = tops[k]
    return [top + height / 2 for top, (_, height) in zip(tops, wanted, strict=True)]
