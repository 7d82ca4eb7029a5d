"""Figure 2.9: operations of the PUMA's inverse dynamics by published methods, ours beside.

Table 2.10's totals for six joints, bars on an axis that begins at 0. SVG, the same bytes at any time.
"""

from __future__ import annotations

from typing import Any, Final

from robodyn.thesis.printed_counts import METHODS
from robodyn.thesis.tables import table_2_10
from robodyn.thesis.tables.bars import OURS, Series, grouped_bars
from robodyn.thesis.tables.table import Table

_ROW: Final = "puma_6"
_SERIES: Final = (
    Series("printed", "printed in Table 2.10", "#c6d8ec"),
    Series("ours", "ours: by that method where it is known (I, IV, VI), else what robodyn gen writes", OURS),
)


def figure_2_9_svg(table: Table | None = None) -> str:
    """The picture; of ``table`` 2.10 where it is at hand."""
    rows = table or table_2_10.table()
    groups = {
        f"{method}, {who}": (
            int(row.printed["operations"]["total"]),
            _total(row.ours.get("method") or row.ours["default"]),
        )
        for method, who in METHODS.items()
        for row in [rows.row(f"{_ROW}, {method}")]
    }
    return grouped_bars(
        groups,
        _SERIES,
        title="Figure 2.9, redrawn: operations by published methods",
        description="Totals of Table 2.10 for the PUMA 560 with six joints, printed and recomputed.",
        heading="Six joints of the PUMA 560",
    )


def _total(operations: Any) -> int:
    return int(operations["total"])
