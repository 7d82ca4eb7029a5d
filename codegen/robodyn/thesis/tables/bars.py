"""Bars in groups, on an axis that begins at 0. SVG, the same bytes at any time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from robodyn.draw.markup import markup_template

OURS: Final = "#1f5fa8"
_HEIGHT: Final = 300
_LEFT: Final = 70
_TOP: Final = 70
_GAP: Final = 2  # between bars of a group
_BETWEEN: Final = 30  # between groups
_LETTER: Final = 6.8  # width of a letter below a group
_STEP: Final = 100  # operations between two lines of the axis


@dataclass(frozen=True, slots=True)
class Series:
    """The bars of one colour; ``name`` stands in the tooltip of each, ``label`` in the key."""

    name: str
    label: str
    fill: str


def grouped_bars(
    groups: Mapping[str, Sequence[int | None]],
    series: Sequence[Series],
    *,
    title: str,
    description: str,
    heading: str,
    bar: int = 40,
) -> str:
    """An SVG with a bar for each of ``series`` in each of ``groups``, in their order; None has no bar."""
    top = _STEP * (1 + max(value or 0 for values in groups.values() for value in values) // _STEP)
    slot = _BETWEEN + max(len(series) * (bar + _GAP), round(_LETTER * max(map(len, groups))))
    width = slot * len(groups)
    bars: list[dict[str, Any]] = []
    ticks = []
    for k, (group, values) in enumerate(groups.items()):
        shown = [(one, value) for one, value in zip(series, values, strict=True) if value is not None]
        ticks.append({"at": f"{slot * (k + 0.5):.1f}", "label": group})
        for i, (one, value) in enumerate(shown):
            left = slot * (k + 0.5) + (i - len(shown) / 2) * (bar + _GAP)
            height = _HEIGHT * value / top
            bars.append(
                {
                    "x": f"{left:.1f}", "y": f"{_HEIGHT - height:.1f}", "width": bar,
                    "height": f"{height:.1f}", "fill": one.fill, "stroke": OURS, "label": value,
                    "middle": f"{left + bar / 2:.1f}", "label_y": f"{_HEIGHT - height - 5:.1f}",
                    "name": f"{group}, {one.name}: {value}",
                }
            )  # fmt: skip
    panel: dict[str, Any] = {
        "x": _LEFT, "y": _TOP, "width": width, "height": _HEIGHT, "label_y": _HEIGHT + 18,
        "title": heading, "subtitle": "multiplications and additions together",
        "bars": bars, "lines": [], "x_ticks": ticks,
        "legend": [
            {
                "x": 0, "x_end": 26, "text_x": 33, "y": _HEIGHT + 46 + 18 * row, "stroke": one.fill,
                "label": one.label, "thickness": 9, "dashes": "",
            }
            for row, one in enumerate(series)
        ],
        "y_ticks": [
            {"at": f"{_HEIGHT * (1 - y / top):.1f}", "label": str(y)} for y in range(0, top + 1, _STEP)
        ],
    }  # fmt: skip
    return markup_template("operations.svg.j2").render(
        width=_LEFT + width + 30,
        height=_TOP + _HEIGHT + 64 + 18 * len(series),
        title=title,
        description=description,
        panels=[panel],
    )
