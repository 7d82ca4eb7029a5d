"""Puts the operations of all bundled robots into docs/operation-counts.md, and draws the README's picture.

python -m benchmarks.counts
"""

from __future__ import annotations

import sys
from pathlib import Path

from benchmarks.marked import with_part

from robodyn.thesis.tables import Table, make
from robodyn.thesis.tables.pictures import robots_svg

DOCS = Path(__file__).parents[1] / "docs"
PAGE = DOCS / "operation-counts.md"
PICTURE = DOCS / "pictures" / "operations.svg"
MARK = "counts"
_HEAD = (
    "| robot | joints | `none` | `fast` | shipped | OpenSYMORO, base parameters | thesis |\n"
    "|---|---|---|---|---|---|---|\n"
)


def markdown(table: Table) -> str:
    """The table ``robots`` of the thesis's tables as Markdown."""
    rows = []
    for row in table.rows:
        ours, shipped = row.ours, row.ours["default"]
        cells = (
            f"`{row.name}`",
            ours["joints"],
            ours["none"]["total"],
            ours["fast"]["total"],
            f"{shipped['mul']}+{shipped['add']} = {shipped['total']}",
            ours["opensymoro"] or "",
            row.printed.get("total", ""),
        )
        rows.append("| " + " | ".join(map(str, cells)) + " |\n")
    return _HEAD + "".join(rows)


def main() -> int:
    """Writes the page and the picture."""
    table = make("robots")
    PAGE.write_text(with_part(PAGE.read_text(encoding="utf-8"), MARK, markdown(table)), encoding="utf-8")
    PICTURE.write_text(robots_svg(table), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
