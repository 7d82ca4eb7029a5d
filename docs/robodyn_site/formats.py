"""A page for each format with all its elements and attributes, from the table that its reader is made of."""

from __future__ import annotations

from collections import defaultdict
from typing import Final

from robodyn.formats.elements_of import FORMATS, Entry, table_of
from robodyn.formats.tree import PHYSICS
from robodyn_site.markdown import code, page, plain, table

FOLDER: Final = "formats"


def pages() -> dict[str, str]:
    """The pages of the formats, and their index: what is refused, by name."""
    return {f"{FOLDER}/index.md": _index()} | {
        f"{FOLDER}/{title.lower()}.md": of_format(title) for title in FORMATS
    }


def _index() -> str:
    counts = [
        (f"[{title}]({title.lower()}.md)", str(len(rows)), str(sum(map(len, rows.values()))))
        for title, rows in ((title, table_of(title).rows) for title in FORMATS)
    ]
    names = [(code(name), plain(what), ", ".join(_formats_of(name))) for name, what in PHYSICS.items()]
    return page(
        "# Elements of URDF, SDF and MJCF",
        "Every element and attribute of these formats is listed with what it is to robodyn. The readers are "
        "made from the same tables, and a test compares them with what the authors of the formats list: "
        "the schema of urdfdom, the descriptions in sdformat (1.4 to 1.12), the schema that MuJoCo prints. "
        "What a file states and its table does not have is told as unknown to the format.",
        table(("format", "elements", "their attributes and elements"), counts, " rr"),
        "## What is refused",
        "It changes torques and is not modelled. A file that states it is refused with exit code 2, unless "
        "`--without NAME` leaves it out (from Python `without=[NAME]`).",
        table(("name", "what it is", "in"), names),
        "[Import and export](../import.md) says how files are read.",
    )


def _formats_of(name: str) -> list[str]:
    """The formats that have what is refused by that name, as links."""
    entries = {title: _entries(title) for title in FORMATS}
    with_it = [title for title, all_ in entries.items() if any(entry.physics == name for entry in all_)]
    return [f"[{title}]({title.lower()}.md)" for title in with_it]


def _entries(title: str) -> list[Entry]:
    return [entry for row in table_of(title).rows.values() for entry in row.values()]


def of_format(title: str) -> str:
    """The page of one format."""
    rows = []
    for path, row in table_of(title).rows.items():
        cells: dict[str, list[str]] = defaultdict(list)
        for name, entry in row.items():
            cells[_column(entry)].append(_cell(name, entry))
        columns = (" ".join(cells[column]) for column in ("used", "torques", "none"))
        rows.append((code("/".join(path)), *columns))
    return page(
        f"# Elements of {title}",
        "An element is named by the end of its path. Elements in it stand in brackets, attributes do not; "
        "what has no row of its own is described in the one around it.",
        "What changes torques is modelled, or refused by the name that is set beside it (for a value that "
        "changes nothing, such as 0, it is not).",
        table(("element", "read", "changes torques", "of no effect on torques"), rows),
        "[All formats](index.md).",
    )


def _column(entry: Entry) -> str:
    kinds = {"refused": "torques", "silent": "none"}
    return kinds.get(entry.kind, entry.kind)


def _cell(name: str, entry: Entry) -> str:
    refused = f" ({code(entry.physics)})" if entry.physics else ""
    source = f" ({plain(entry.source)})" if entry.source else ""
    return code(name) + refused + source
