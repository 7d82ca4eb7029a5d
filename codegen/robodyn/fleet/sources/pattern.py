"""Logs by their paths: patterns such as ``logs/{type}/{unit}/{date}.csv``, and what of a folder fits them.

A pattern is a glob whose fields have names. What has its shape, but no date where there should be one, is not
passed over: it is named.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final, NoReturn

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.fleet.limits import DEEPEST, LISTED, MOST_ENTRIES, MOST_FIELDS
from robodyn.fleet.sources.dates import check_format, regex_of
from robodyn.robot.names import shown

DATE: Final = "date"
#: Fields that hold text; all others but the date are conditions, and hold numbers.
TEXTS: Final = ("type", "unit")
_TOKENS: Final = re.compile(r"(\{[^{}]*\}|\*|\?)")
_FIELD: Final = re.compile(r"\{([A-Za-z]\w*)(?::([^{}]+))?\}", re.ASCII)
_NUMBER: Final = r"[-+]?\d+(?:\.\d+)?"
_ANY: Final = "**"
#: Any text within a part of a path, as short as it can be; any folders, but hidden ones.
_TEXT, _FOLDERS = "[^/]+?", r"(?:(?!\.)[^/]+/)*"


@dataclass(frozen=True, slots=True)
class Pattern:
    """A pattern of paths, in the folder ``anchor`` where it is absolute: its ``parts``; what a path must be
    (``strict``), and the same with any text for dates and numbers (``shape``); what the folders are, each
    with a slash behind it, that lead to such paths (``way``); the ``format`` of its date, whose pieces are
    joined by blanks."""

    anchor: str
    parts: tuple[str, ...]
    strict: re.Pattern[str]
    shape: re.Pattern[str]
    way: re.Pattern[str]
    format: str

    def fields(self, path: str) -> dict[str, str] | None:
        """The fields of ``path``; None if it does not have the shape."""
        match = self.strict.fullmatch(path) or self.shape.fullmatch(path)
        if match is None:
            return None
        fields = match.groupdict()
        pieces = [fields.pop(name) for name in list(fields) if name[0] == "_"]
        return {**fields, DATE: " ".join(pieces)} if pieces else fields

    def covers(self, path: str) -> bool:
        """Whether ``path`` fits, or lies in a folder that does."""
        parts = path.split("/")
        return any(self.shape.fullmatch("/".join(parts[:k])) for k in range(1, len(parts) + 1))


def pattern_of(text: str, format: str = "") -> Pattern:
    """The pattern that ``text`` says; ``format``: of a date that has none.

    Raises
    ------
    InputError: it is no pattern.
    """
    text = text.replace("\\", "/")
    anchor = Path(text).anchor
    parts = [part for part in text[len(anchor) :].split("/") if part not in ("", ".")]
    if not parts or parts[-1] in ("..", _ANY) or text.endswith("/"):
        raise InputError("the pattern ends in no file", found=shown(text, 80), expected=".../{date}.csv")
    formats: list[str] = []
    names: set[str] = set()
    strict, shape = zip(*(_regexes(part, format, formats, names) for part in parts), strict=True)
    if len(formats) > 1 and "" in formats:
        raise InputError(
            "a date of several pieces needs the format of each",
            found=shown(text, 80),
            expected="{date:%Y-%m-%d}/{date:%H%M}.csv",
        )
    way = ""
    for part in reversed(shape[:-1]):
        way = f"{part}(?:{way})?"
    begin = re.escape(anchor)
    wholes = ("".join(strict)[:-1], "".join(shape)[:-1], f"(?:{way})?")
    exact, free, leading = (re.compile(begin + whole, re.ASCII) for whole in wholes)
    return Pattern(anchor, tuple(parts), exact, free, leading, check_format(" ".join(formats)))


def _regexes(part: str, format: str, formats: list[str], names: set[str]) -> tuple[str, str]:
    """Regular expressions of a ``part`` of a pattern and the slash behind it: with dates and numbers in their
    places, and with any text there. Adds to the ``formats`` of dates and the ``names`` of fields so far."""
    if part == _ANY:
        return _FOLDERS, _FOLDERS
    pieces = _TOKENS.split(part)
    strict = shape = "" if part.startswith(".") else r"(?!\.)"
    texts = 0
    for k, piece in enumerate(pieces):
        exact = free = {"*": "[^/]*?", "?": "[^/]"}.get(piece, re.escape(piece))
        field = _FIELD.fullmatch(piece)
        texts += piece == "*" or (field is not None and field[1] in TEXTS)
        if field and (field[1] == DATE or not field[2]):
            name, exact = field[1], _TEXT
            if name == DATE:
                formats.append(field[2] or format)
                name, exact = f"_{len(formats)}", regex_of(formats[-1])
            elif name not in TEXTS:
                exact = _NUMBER
            exact, free = (f"(?P<{name}>{each})" for each in (exact, _TEXT))
            if name in names:
                exact = free = f"(?P={name})"
            names.add(name)
        elif "{" in piece or "}" in piece:
            raise InputError(
                "this is no field of a pattern, or it has no end within its part of the path",
                found=shown(piece),
                expected="{type}, {unit}, {date}, {date:%Y%m%d}, or the name of a condition",
            )
        # As far as the first place that fits, and never back: that finds a fit where there is one.
        is_held = 0 < k < len(pieces) - 2
        strict += exact
        shape += f"(?>{free}" if is_held and k % 2 else f"{free})" if is_held else free
    if texts > MOST_FIELDS:
        raise InputError(
            "the pattern has too many fields in one part of the path",
            found=str(texts),
            expected=f"at most {MOST_FIELDS}",
        )
    return f"{strict}/", f"{shape}/"


def matches(
    pattern: Pattern, base: Path, exclude: Sequence[Pattern] = ()
) -> Iterator[tuple[str, dict[str, str]]]:
    """The paths in ``base`` that have the shape of ``pattern``, with their fields, but for those that fit one
    of ``exclude``; none of them is read.

    Raises
    ------
    InputError: there are none, they lie among too many files, or a folder cannot be read.
    """
    start, skipped = pattern.anchor, 0
    for part in pattern.parts[:-1]:  # folders that the pattern names are not looked for
        if _TOKENS.search(part) or not os.path.isdir(base / start / part):  # noqa: PTH112 (never raises)
            break
        start, skipped = f"{start}{part}/", skipped + 1
    listed, count, furthest = 0, 0, (-1, "", list[str]())
    for folder, folders, files in os.walk(base / start, onerror=_refuse_folder, followlinks=True):
        below = Path(folder).relative_to(base / start).parts
        names = sorted([*folders, *files])
        furthest = max(furthest, (len(below), folder, names), key=lambda one: one[0])
        listed += len(names)
        if listed > MOST_ENTRIES:
            raise InputError(
                "the pattern leads through too many files",
                found=f"more than {MOST_ENTRIES}",
                remedy="name the folder of the logs in the pattern",
            )
        inside, further = set(folders), list[str]()
        for name in names:
            path = start + "/".join((*below, name))
            fields = pattern.fields(path)
            is_excluded = any(each.covers(path) for each in exclude)
            count += is_excluded or fields is not None
            if fields is not None and not is_excluded:
                yield path, fields
            leads_on = name in inside and len(below) < DEEPEST and pattern.way.fullmatch(f"{path}/")
            if leads_on and not is_excluded and not _leads_up(folder, name):
                further.append(name)
        folders[:] = further
    if not count:
        depth, folder, names = furthest
        some = ", ".join(map(shown, names[:LISTED])) + (", ..." if len(names) > LISTED else "")
        raise InputError(
            "no log fits the pattern",
            found=f"in {label(folder)}: {some or 'nothing'}",
            expected=shown(pattern.parts[-1 if _ANY in pattern.parts else skipped + depth], 80),
            remedy="write the pattern as the paths are; * stands for any text, ** for folders in folders",
        )


def _leads_up(folder: str, name: str) -> bool:
    """Whether ``name`` in ``folder`` is a link to a folder that it lies in: whoever follows it goes round."""
    path = os.path.join(folder, name)  # noqa: PTH118 (a hundred thousand)
    return os.path.islink(path) and Path(os.path.realpath(folder)).is_relative_to(os.path.realpath(path))  # noqa: PTH114


def _refuse_folder(error: OSError) -> NoReturn:
    raise InputError(
        "the folder cannot be read",
        where=Place(label(error.filename)),
        found=(error.strerror or str(error)).lower(),
        remedy="leave it out (exclude), or allow it to be read",
    ) from None
