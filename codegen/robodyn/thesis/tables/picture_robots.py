"""Operations of some bundled robots as bars: the textbook's recursion, OpenSYMORO, the thesis, ours."""

from __future__ import annotations

from typing import Any, Final

from robodyn.draw.panels import Bars, Panel, figure
from robodyn.draw.style import GREY, ORANGE, OURS, SKY
from robodyn.thesis.tables import robots
from robodyn.thesis.tables.table import Row, Table

#: One parameter set of each arm of six or seven joints that another tool was counted on.
SHOWN: Final = ("ur10", "stanford_d3", "puma560_d2", "rx90", "iiwa", "panda")
_SERIES: Final = (
    ("textbook's recursion, common subexpressions computed once", GREY, True),
    ("the thesis, Table 2.10", SKY, False),
    ("OpenSYMORO, base parameters", ORANGE, False),
    ("robodyn gen", OURS, False),
)
_WIDTH: Final = 840


def robots_svg(table: Table | None = None) -> str:
    """The picture; of the table ``robots`` where it is at hand."""
    rows = table or robots.table()
    columns = zip(*(_figures(rows.row(name)) for name in SHOWN), strict=True)
    return figure(
        "Operations of the inverse dynamics",
        "Multiplications and additions of one call for bundled robots, by robodyn and by others",
        [
            Panel(
                "One call of the inverse dynamics", "robot", "multiplications and additions",
                bars=tuple(
                    Bars(name, totals, colour, is_pale)
                    for (name, colour, is_pale), totals in zip(_SERIES, columns, strict=True)
                ),
                categories=SHOWN,
            )
        ],
        width=_WIDTH,
    )  # fmt: skip


def _figures(row: Row) -> tuple[int | None, ...]:
    ours: dict[str, Any] = dict(row.ours)
    return (
        ours["none"]["total"],
        row.printed.get("total"),
        ours["opensymoro"],
        ours["default"]["total"],
    )
