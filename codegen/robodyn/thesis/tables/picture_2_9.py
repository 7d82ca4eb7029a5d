"""Figure 2.9: operations of the PUMA's inverse dynamics by published methods, ours beside.

Table 2.10's totals for six joints, bars on an axis that begins at 0. SVG, the same bytes at any time.
"""

from __future__ import annotations

from typing import Any, Final

from robodyn.draw.markup import markup_template
from robodyn.thesis.printed_counts import METHODS
from robodyn.thesis.tables import table_2_10
from robodyn.thesis.tables.table import Table

_ROW: Final = "puma_6"
_WIDTH, _HEIGHT, _LEFT, _TOP = 900, 300, 70, 70
_BAR: Final = 40
_PRINTED, _OURS = "#c6d8ec", "#1f5fa8"


def figure_2_9_svg(table: Table | None = None) -> str:
    """The picture; of ``table`` 2.10 where it is at hand."""
    rows = table or table_2_10.table()
    bars, ticks = [], []
    totals = {
        method: (row.printed["operations"]["total"], _total(row.ours.get("method") or row.ours["default"]))
        for method in METHODS
        for row in [rows.row(f"{_ROW}, {method}")]
    }
    top = 100 * (1 + max(max(pair) for pair in totals.values()) // 100)
    slot = _WIDTH / len(METHODS)
    for k, (method, pair) in enumerate(totals.items()):
        who = METHODS[method]
        ticks.append({"at": f"{slot * (k + 0.5):.1f}", "label": who})
        for i, (total, fill, whose) in enumerate(
            zip(pair, (_PRINTED, _OURS), ("printed", "ours"), strict=True)
        ):
            left, height = slot * (k + 0.5) + (i - 1) * (_BAR + 2), _HEIGHT * total / top
            bars.append(
                {
                    "x": f"{left:.1f}", "y": f"{_HEIGHT - height:.1f}", "width": _BAR,
                    "height": f"{height:.1f}", "fill": fill, "stroke": _OURS, "label": total,
                    "middle": f"{left + _BAR / 2:.1f}", "label_y": f"{_HEIGHT - height - 5:.1f}",
                    "name": f"{method}, {who}, {whose}: {total}",
                }
            )  # fmt: skip
    legend = [
        {
            "x": 0, "x_end": 26, "text_x": 33, "y": _HEIGHT + 46 + 18 * row, "stroke": stroke, "label": label,
            "thickness": 9, "dashes": "",
        }
        for row, (stroke, label) in enumerate(
            (
                (_PRINTED, "printed in Table 2.10"),
                (_OURS, "ours: by that method where it is known (I, IV, VI), else what robodyn gen writes"),
            )
        )
    ]  # fmt: skip
    panel: dict[str, Any] = {
        "x": _LEFT, "y": _TOP, "width": _WIDTH, "height": _HEIGHT, "label_y": _HEIGHT + 18,
        "title": "Six joints of the PUMA 560", "subtitle": "multiplications and additions together",
        "bars": bars, "lines": [], "x_ticks": ticks, "legend": legend,
        "y_ticks": [
            {"at": f"{_HEIGHT * (1 - y / top):.1f}", "label": str(y)} for y in range(0, top + 1, 100)
        ],
    }  # fmt: skip
    return markup_template("operations.svg.j2").render(
        width=_LEFT + _WIDTH + 30,
        height=_TOP + _HEIGHT + 100,
        title="Figure 2.9, redrawn: operations by published methods",
        description="Totals of Table 2.10 for the PUMA 560 with six joints, printed and recomputed.",
        panels=[panel],
    )


def _total(operations: Any) -> int:
    return int(operations["total"])
