"""Operations of some bundled robots as bars: the textbook's recursion, OpenSYMORO, the thesis, ours."""

from __future__ import annotations

from typing import Any, Final

from robodyn.thesis.tables import robots
from robodyn.thesis.tables.bars import OURS, Series, grouped_bars
from robodyn.thesis.tables.table import Row, Table

#: One parameter set of each arm of six or seven joints that another tool was counted on.
SHOWN: Final = ("ur10", "stanford_d3", "puma560_d2", "rx90", "iiwa", "panda")
_SERIES: Final = (
    Series("recursion", "the textbook's recursion, common subexpressions computed once", "#e3e3e3"),
    Series("thesis", "the thesis, Table 2.10", "#c6d8ec"),
    Series("OpenSYMORO", "OpenSYMORO, base parameters", "#f6dfc5"),
    Series("robodyn", "robodyn gen", OURS),
)


def robots_svg(table: Table | None = None) -> str:
    """The picture; of the table ``robots`` where it is at hand."""
    rows = table or robots.table()
    return grouped_bars(
        {name: _figures(rows.row(name)) for name in SHOWN},
        _SERIES,
        title="Operations of the inverse dynamics",
        description="Multiplications and additions of one call for bundled robots, by robodyn and by others.",
        heading="One call of the inverse dynamics",
        bar=34,
    )


def _figures(row: Row) -> tuple[int | None, ...]:
    ours: dict[str, Any] = dict(row.ours)
    return (
        ours["none"]["total"],
        row.printed.get("total"),
        ours["opensymoro"],
        ours["default"]["total"],
    )
