"""The page of programs and libraries beside robodyn, from their records."""

from __future__ import annotations

from itertools import groupby

from robodyn.doctor import known
from robodyn.tools import Library, Tool
from robodyn_site.markdown import code, page, plain, table


def pages() -> dict[str, str]:
    """The page."""
    sections: list[str] = []
    for use, tools in groupby(known(), key=lambda tool: tool.use):
        sections += [
            f"## {use[0].upper()}{use[1:]}",
            table(("tool", "for", "how to get it"), map(_row, tools)),
        ]
    return {
        "tools.md": page(
            "# Programs and libraries",
            "What robodyn can use beside itself. Only what is needed by everything has to be there, and pip "
            "installs that; all else is optional, and what lacks it says so. "
            "[`robodyn doctor`](commands/doctor.md) shows what a machine has.",
            *sections,
        )
    }


def _row(tool: Tool | Library) -> tuple[str, str, str]:
    name = code(tool.name)
    if isinstance(tool, Tool) and tool.variable:
        name += f", or what {code(tool.variable)} names"
    return name, plain(tool.enables), plain(tool.install)
