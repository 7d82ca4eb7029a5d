"""How a table is written as text: what separates its cells, where its names stand, how decimals are marked.

Most logs begin with a line of names that commas separate. Others have lines above it, names behind a
comment mark, a row of units, semicolons and decimal commas, tabs, blanks. What it is, the first rows with
numbers say.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

from robodyn.logs.units import is_unit

#: So much of a file is looked at [bytes], and so many lines above the numbers are passed over.
HEAD: Final = 1 << 16
ABOVE: Final = 200

_INDEXED: Final = re.compile(r"(q|qd|qdd|tau|ql)([1-9][0-9]{0,2})\Z")
_COMMENTS: Final = ("#", "%", "//")
_MARKS: Final = (",", ";", "\t", "|", " ")
_POINT: Final = re.compile(
    r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?\Z|[-+]?(nan|inf|infinity)\Z", re.IGNORECASE
)
_COMMA: Final = re.compile(r"[-+]?(\d+,?\d*|,\d+)([eE][-+]?\d+)?\Z|[-+]?(nan|inf|infinity)\Z", re.IGNORECASE)
_COMMENT_BYTES: Final = tuple(word.encode() for word in _COMMENTS)
_COMMENT_LINE: Final = re.compile(rb"(?m)^[ \t]*(?:#|%|//).*$")
_BLANKS: Final = re.compile(rb"[ \t]+")
_BLANK_ENDS: Final = re.compile(rb"(?m)^[ \t]+|[ \t\r]+$")
_EMPTY: Final = re.compile(rb"(?<=[,\n])(?=[,\n])")
_WITH_UNIT: Final = re.compile(
    r"(?P<name>.*\S)\s*[\[(]\s*(?P<unit>[^\[\]()]*?[^\[\]()\d\s][^\[\]()]*?)\s*[\])]\Z"
)


@dataclass(frozen=True, slots=True)
class Dialect:
    """How a table is written: ``names`` of its columns, the ``units`` of those that state one, the ``mark``
    between cells, whether decimals have a ``comma``, and the ``line`` (from 1) at which numbers begin.
    ``comment``: what begins a line that is not a row, "" if nothing does. ``named``: whether a line has
    names; else they are column1 and so on. ``empty``: whether a cell may be empty, and is then NaN."""

    names: tuple[str, ...]
    mark: str = ","
    comma: bool = False
    line: int = 2
    comment: str = ""
    units: Mapping[str, str] = field(default_factory=dict)
    named: bool = True
    empty: bool = False

    @property
    def plain(self) -> bool:
        """Whether the rows are as numpy reads them."""
        return self.mark == "," and not self.comma and not self.comment


def dialect_of(head: str) -> Dialect | None:
    """The dialect of a file that begins with ``head``; None if no rows of numbers are in it.

    The last line of ``head`` may be cut off.
    """
    lines = head.split("\n")
    lines = [line.rstrip("\r") for line in (lines[:-1] if len(lines) > 2 else lines)]
    for k, line in enumerate(lines[:ABOVE]):
        if not line.strip() or line.lstrip().startswith(_COMMENTS):
            continue
        below = lines[k : k + 50]
        following = [each for each in below if each.strip() and not each.lstrip().startswith(_COMMENTS)]
        for mark in _MARKS:
            comma = _decimals(following, mark)
            if comma is not None:
                return _dialect(lines, k, mark, comma)
    return None


def cells_of(line: str, mark: str) -> list[str]:
    """The cells of a ``line``, without blanks and quotes around them."""
    parts = line.split() if mark == " " else line.split(mark)
    return [part.strip().removeprefix('"').removesuffix('"').strip() for part in parts]


def canonical(block: bytes, dialect: Dialect) -> bytes:
    """The lines of ``block`` with commas between their cells and points in their decimals; a comment becomes
    an empty line, so that lines keep their numbers."""
    if dialect.comment and any(word in block for word in _COMMENT_BYTES):
        block = _COMMENT_LINE.sub(b"", block)
    if dialect.mark == " ":
        return _BLANKS.sub(b",", _BLANK_ENDS.sub(b"", block))
    if dialect.mark == ",":
        return block
    # Decimals by commas become decimals by points; a comma that is none must not separate cells.
    table = bytes.maketrans(dialect.mark.encode() + b",", b",." if dialect.comma else b",?")
    return block.translate(table, b'"')


def filled(text: bytes) -> bytes:
    """``text``, which has no empty lines, with nan in its empty cells."""
    if b",," not in text and b",\n" not in text and b"\n," not in text and not text.startswith(b","):
        return text
    return _EMPTY.sub(b"nan", b"\n" + text)[1:]


def _decimals(lines: Sequence[str], mark: str) -> bool | None:
    """Whether decimals have a comma in ``lines``, if ``mark`` separates their cells and they are of numbers:
    most cells of each of the first are; None if they are not."""
    rows = [cells_of(line, mark) for line in lines[:2]]
    width = len(rows[0])
    if width < 2 or any(len(row) != width for row in rows):
        return None
    for comma, form in ((False, _POINT), (True, _COMMA)):
        if comma and mark == ",":
            continue
        # A column of words, such as a date, may be among them.
        if all(2 * sum(map(bool, map(form.match, filter(None, row)))) > len(row) for row in rows):
            more = (cell for line in lines for cell in cells_of(line, mark))
            return comma or (mark != "," and any(map(_only_comma, more)))
    return None


def _only_comma(cell: str) -> bool:
    """Whether a cell is a number if commas mark decimals, and none else: whole numbers are both."""
    return _COMMA.match(cell) is not None and _POINT.match(cell) is None


def _dialect(lines: Sequence[str], first: int, mark: str, comma: bool) -> Dialect:
    """The dialect of ``lines`` whose rows of numbers begin at ``first``."""
    width = len(cells_of(lines[first], mark))
    above: list[list[str]] = []
    for line in reversed(lines[:first]):
        text = line.strip()
        begun = next((word for word in _COMMENTS if text.startswith(word)), "")
        cells = cells_of(text.removeprefix(begun).strip(), mark)
        if len(cells) == width and any(cells):
            above.append(cells)
        elif len(above):
            break
        if len(above) == 2:
            break
    units: dict[str, str] = {}
    names = [f"column{k + 1}" for k in range(width)]
    if above:
        names = above[0]
        if len(above) == 2 and are_units(above[0]):
            names = above[1]
            units = {name: unit.strip("[]() ") for name, unit in zip(names, above[0], strict=True)}
        matches = [_WITH_UNIT.match(name) for name in names]
        short = [match["name"] if match else name for name, match in zip(names, matches, strict=True)]
        if len(set(short)) == width:
            units.update({match["name"]: match["unit"] for match in matches if match})
            names = short
    comments = [word for word in _COMMENTS for line in lines if line.lstrip().startswith(word)]
    return Dialect(
        tuple(names), mark, comma, first + 1, comments[0] if comments else "",
        {name: unit for name, unit in units.items() if unit}, bool(above),
    )  # fmt: skip


def are_units(cells: Sequence[str]) -> bool:
    """Whether a row of cells has units: brackets, or short words that are units."""
    stated = [cell for cell in cells if cell.strip("-")]
    return bool(stated) and all(is_unit(cell.strip("[]() ")) or cell.startswith("[") for cell in stated)


def joint_of(name: str) -> tuple[str, int] | None:
    """The group of a column of a log, and the number of its joint; None where ``name`` is none."""
    match = _INDEXED.match(name)
    return (match[1], int(match[2])) if match else None


def is_known(name: str) -> bool:
    """Whether ``name`` is one that a column of a log has."""
    return name == "t" or joint_of(name) is not None


def number_of(cell: bytes) -> float | None:
    """The double nearest to what the cell says, or None."""
    try:
        return None if b"_" in cell else float(cell)
    except ValueError:
        return None
