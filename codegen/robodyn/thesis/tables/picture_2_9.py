"""Figure 2.9: operations of the PUMA's inverse dynamics by published methods, ours beside.

Table 2.10's totals for six joints, bars on an axis that begins at 0. SVG, the same bytes at any time.
"""

from __future__ import annotations

from typing import Any, Final

from robodyn.draw.panels import Bars, Panel, figure
from robodyn.draw.style import OURS
from robodyn.thesis.printed_counts import METHODS
from robodyn.thesis.tables import table_2_10
from robodyn.thesis.tables.table import Table

_ROW: Final = "puma_6"
_WIDTH: Final = 720


def figure_2_9_svg(table: Table | None = None) -> str:
    """The picture; of ``table`` 2.10 where it is at hand."""
    rows = table or table_2_10.table()
    totals = [
        (row.printed["operations"]["total"], _total(row.ours.get("method") or row.ours["default"]))
        for method in METHODS
        for row in [rows.row(f"{_ROW}, {method}")]
    ]
    printed, ours = zip(*totals, strict=True)
    return figure(
        "Figure 2.9, redrawn: operations by published methods",
        "Totals of Table 2.10; ours: by that method where it is known (I, IV, VI), else by robodyn gen",
        [
            Panel(
                "PUMA 560, six joints", "method, by whom", "multiplications and additions",
                bars=(Bars("printed in Table 2.10", printed, OURS, pale=True), Bars("ours", ours, OURS)),
                categories=tuple(f"{method}, {who}" for method, who in METHODS.items()),
            )
        ],
        width=_WIDTH,
    )  # fmt: skip


def _total(operations: Any) -> int:
    return int(operations["total"])
