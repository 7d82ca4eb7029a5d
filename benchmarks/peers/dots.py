"""A figure a row as dots on a logarithmic axis, where no bar could begin at 0. SVG, always the same bytes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from robodyn.draw import style
from robodyn.draw.markup import markup_template
from robodyn.draw.scales import decades, label

#: The frame's width, the height of a row, the radius of a dot, the head, in px.
_WIDTH, _ROW, _RADIUS = 460, 22, 5
_HEAD = 68


@dataclass(frozen=True, slots=True)
class Dot:
    """One figure, positive; ``ours`` stands out."""

    name: str
    value: float
    ours: bool = False


def dots(title: str, note: str, x_label: str, rows: Sequence[Dot]) -> str:
    """An SVG of ``rows`` from top to bottom on a logarithmic axis; their figures stand beside the dots."""
    marks = decades([row.value for row in rows])
    first, last = math.log10(marks[0]), math.log10(marks[-1])

    def x(value: float) -> float:
        return _WIDTH * (math.log10(value) - first) / (last - first)

    left: Final = style.MARGIN + max(style.text_width(row.name) for row in rows) + 10
    colours = [style.OURS if row.ours else style.OTHERS for row in rows]
    markup = markup_template("panels.svg.j2").environment
    template = markup.from_string(Path(__file__).with_name("dots.svg.j2").read_text(encoding="utf-8"))
    return template.render(
        style=style,
        width=f"{max(left + _WIDTH + 60, style.head_width(title, note)):.0f}",
        height=_HEAD + _ROW * len(rows) + 52,
        left=f"{left:.0f}", top=_HEAD, frame_width=_WIDTH, bottom=_ROW * len(rows),
        radius=_RADIUS,
        title=title,
        note=note,
        x_label=x_label,
        ticks=[{"at": f"{x(mark):.1f}", "label": label(mark)} for mark in marks],
        rows=[
            {
                "y": _ROW * k + _ROW / 2, "x": f"{x(row.value):.1f}", "text_x": f"{x(row.value) + 11:.1f}",
                "name": row.name, "text": f"{row.value:.2g}", "fill": colours[k], "ours": row.ours,
            }
            for k, row in enumerate(rows)
        ],
    )  # fmt: skip
