"""Logs by their paths: patterns such as ``logs/{type}/{unit}/{date}.csv``, and what of a folder fits them.

A field stands for any text between its neighbours, a date for one of its format only. What has the shape of
the pattern, but no date where there should be one, is not passed over: it is named.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.fleet.limits import DEEPEST, LISTED, MOST_ENTRIES, MOST_FIELDS
from robodyn.fleet.sources.dates import check_format, regex_of
from robodyn.logs.formats import is_log
from robodyn.robot.names import shown

DATE: Final = "date"
_TOKENS: Final = re.compile(r"\{([^{}]*)\}|(\*)|(\?)")
_NAME: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\Z")
_NUMBER: Final = r"[-+]?\d+(?:\.\d+)?"
_ANY: Final = "**"
#: Fields that hold text; all others but the date are conditions, and hold numbers.
TEXTS: Final = ("type", "unit")


@dataclass(frozen=True, slots=True)
class _Part:
    """A part of a pattern between slashes: its ``text``; ``shape``: what a name must be, with any text in the
    place of dates and numbers, None where it is the text itself; ``strict``: the same with dates and numbers,
    None where there are none of them. Fields are groups of both, by the ``names``."""

    text: str
    shape: re.Pattern[str] | None = None
    strict: re.Pattern[str] | None = None
    names: tuple[str, ...] = ()

    def match(self, name: str) -> tuple[str, ...] | None:
        """The fields in ``name``; None if it does not have the shape."""
        if self.shape is None:
            return () if name == self.text else None
        match = self.shape.fullmatch(name)  # in time that is linear in the name, whatever the pattern
        if match is not None and self.strict is not None:
            match = self.strict.fullmatch(name) or match
        return None if match is None else match.groups()


@dataclass(frozen=True, slots=True)
class Pattern:
    """A pattern of paths: its ``parts``, in the folder ``anchor`` where it is absolute; the ``format`` of its
    date, whose pieces are joined by blanks."""

    anchor: str
    parts: tuple[_Part, ...]
    format: str


@dataclass(frozen=True, slots=True)
class Match:
    """A ``path`` that has the shape of a pattern, and what stands in its ``fields``."""

    path: str
    fields: dict[str, str]


def pattern_of(text: str, format: str) -> Pattern:
    """The pattern that ``text`` says; ``format``: of a date that has none.

    Raises
    ------
    InputError: it is no pattern.
    """
    formats: list[str] = []
    text = text.replace("\\", "/")
    anchor = Path(text).anchor
    listed = text[len(anchor) :].split("/")
    parts = [_part(part, format, formats) for part in listed if part not in ("", ".")]
    if not parts or listed[-1] in ("", ".", "..", _ANY):
        raise InputError("the pattern ends in no file", found=shown(text, 80), expected=".../{date}.csv")
    if len(formats) > 1 and "" in formats:
        raise InputError(
            "a date of several pieces needs the format of each",
            found=shown(text, 80),
            expected="{date:%Y-%m-%d}/{date:%H%M}.csv",
        )
    return Pattern(anchor, tuple(parts), check_format(" ".join(formats)))


def _part(text: str, format: str, formats: list[str]) -> _Part:
    if not _TOKENS.search(text) or text == _ANY:
        if "{" in text or "}" in text:
            raise InputError(
                "a field of the pattern has no end or no beginning",
                found=shown(text),
                expected="{unit}, within one part of the path",
            )
        return _Part(text)
    strict = re.escape(text[: next(_TOKENS.finditer(text)).start()])
    shape = strict
    names: list[str] = []
    formatted = free = 0
    tokens = list(_TOKENS.finditer(text))
    for match, after in zip(tokens, [*tokens[1:], None], strict=True):
        literal = re.escape(text[match.end() : None if after is None else after.start()])
        inner, any_text = (".", ".") if match[3] else (".*?", ".*?")
        if match[1] is not None:
            name, own = _field(match[1])
            any_text = "(.+?)"
            inner = any_text
            if name == DATE:
                formats.append(own or format)
                inner = f"({regex_of(formats[-1])})"
            elif name not in TEXTS:
                inner = f"({_NUMBER})"
            names.append(name)
        free += inner in (".*?", "(.+?)")
        formatted += inner not in (".", ".*?", "(.+?)")
        strict += inner + literal
        # As far as the first place that fits, and never back: that finds a fit where there is one.
        shape += any_text + literal if after is None else f"(?>{any_text}{literal})"
    if free > MOST_FIELDS:
        raise InputError(
            "the pattern has too many fields in one part of the path",
            found=str(free),
            expected=f"at most {MOST_FIELDS}",
        )
    flags = re.DOTALL | re.ASCII
    return _Part(
        text, re.compile(shape, flags), re.compile(strict, flags) if formatted else None, tuple(names)
    )


def _field(text: str) -> tuple[str, str]:
    """The name of the field in braces, and the format of its own that a date may have."""
    name, _, own = text.partition(":")
    if not _NAME.match(name) or (own and name != DATE):
        raise InputError(
            "this is no field of a pattern",
            found=shown("{" + text + "}"),
            expected="{type}, {unit}, {date}, {date:%Y%m%d}, or the name of a condition",
        )
    return name, own


@dataclass(slots=True)
class _Walk:
    """A walk through folders for a ``pattern``; ``exclude``: what need not be read; ``listed``: how many
    entries; ``furthest``: the last folder in which nothing fitted a part, and how many parts had."""

    pattern: Pattern
    base: str
    exclude: Sequence[Pattern] = ()
    listed: int = 0
    furthest: tuple[int, str, list[str]] = field(default_factory=lambda: (-1, "", []))

    def paths(
        self, folder: str, k: int, fields: dict[str, str], above: tuple[object, ...]
    ) -> Iterator[Match]:
        """What in the ``folder`` fits the parts from ``k`` on; ``above``: the folders that it lies in."""
        part, last = self.pattern.parts[k], k == len(self.pattern.parts) - 1
        if part.text == _ANY:
            yield from self.paths(folder, k + 1, fields, above)
            yield from self._deeper(folder, k, fields, above)
            return
        if part.shape is None:
            path = _below(folder, part.text)
            if last and os.path.lexists(self._full(path)):
                yield Match(path, fields)
            elif not last and os.path.isdir(self._full(path)):  # noqa: PTH112 (never raises)
                yield from self.paths(path or "/", k + 1, fields, ())
            elif k > self.furthest[0]:
                self.furthest = (k, folder, [name for name, _ in self._entries(folder)])
            return
        names = []
        fitted = False
        for name, is_folder in self._entries(folder):
            names.append(name)
            if name.startswith(".") and not part.text.startswith("."):
                continue
            more = _fields(part, name, fields)
            if more is None or (not last and not is_folder):
                continue
            fitted = True
            path = _below(folder, name)
            if last:
                yield Match(path, more)
            else:
                yield from self.paths(path, k + 1, more, ())
        if not fitted and k > self.furthest[0]:
            self.furthest = (k, folder, names)

    def _deeper(
        self, folder: str, k: int, fields: dict[str, str], above: tuple[object, ...]
    ) -> Iterator[Match]:
        """The same of all folders in the ``folder``; one that lies in itself, by a link, is not gone into."""
        about = Path(self._full(folder)).stat()
        own = (about.st_dev, about.st_ino)
        if own in above or len(above) > DEEPEST:
            return
        for name, is_folder in self._entries(folder):
            if is_folder and not name.startswith("."):
                yield from self.paths(_below(folder, name), k, fields, (*above, own))

    def _full(self, path: str) -> str:
        return os.path.join(self.base, path) if path else self.base  # noqa: PTH118 (a hundred thousand)

    def _entries(self, folder: str) -> list[tuple[str, bool]]:
        """Names in a folder, in order, and which of them are folders."""
        full = self._full(folder)
        try:
            with os.scandir(full) as entries:
                listed = sorted((entry.name, _is_folder(entry)) for entry in entries)
        except OSError as error:
            if any(excluded(each, self.pattern.anchor + folder) for each in self.exclude):
                return []
            raise InputError(
                "the folder cannot be read",
                where=Place(label(full)),
                found=(error.strerror or str(error)).lower(),
                remedy="leave it out (exclude), or allow it to be read",
            ) from None
        self.listed += len(listed)
        if self.listed > MOST_ENTRIES:
            raise InputError(
                "the pattern leads through too many files",
                found=f"more than {MOST_ENTRIES}",
                remedy="name the folder of the logs in the pattern",
            )
        return listed


def _is_folder(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_dir()
    except OSError:  # links that lead round in circles
        return False


def _below(folder: str, name: str) -> str:
    """The path of ``name`` in ``folder``; "" stands for the folder that a pattern starts in."""
    return name if not folder else f"{folder}{name}" if folder.endswith("/") else f"{folder}/{name}"


def _fields(part: _Part, name: str, fields: dict[str, str]) -> dict[str, str] | None:
    """The ``fields`` with those in ``name``; None if it does not have the shape of ``part``."""
    texts = part.match(name)
    if texts is None:
        return None
    more = dict(fields)
    for key, text in zip(part.names, texts, strict=True):
        if key == DATE and key in more:
            text = f"{more[key]} {text}"
        elif more.get(key, text) != text:
            return None
        more[key] = text
    return more


def matches(pattern: Pattern, base: Path, exclude: Sequence[Pattern]) -> Iterator[Match]:
    """The logs in ``base`` that have the shape of ``pattern``, but for those that fit one of ``exclude``; in
    the order of their paths, none of them read.

    Raises
    ------
    InputError: there are none, a folder cannot be read, or what fits is no file.
    """
    base = Path(pattern.anchor) if pattern.anchor else base
    walk = _Walk(pattern, os.fspath(base), exclude)
    count = 0
    for match in walk.paths("", 0, {}, ()):
        count += 1
        path = pattern.anchor + match.path
        if not any(excluded(each, path) for each in exclude):
            _check_kind(base / match.path)
            yield Match(path, match.fields)
    if not count:
        k, folder, names = walk.furthest
        listed = ", ".join(map(shown, names[:LISTED])) + (", ..." if len(names) > LISTED else "")
        raise InputError(
            "no log fits the pattern",
            found=f"in {label(base / folder)}: {listed or 'nothing'}",
            expected=shown(pattern.parts[max(k, 0)].text, 80),
            remedy="write the pattern as the paths are; * stands for any text, ** for folders in folders",
        )


def excluded(pattern: Pattern, path: str) -> bool:
    """Whether ``path`` fits ``pattern``, or lies in a folder that does."""
    if not path.startswith(pattern.anchor) or (not pattern.anchor and path.startswith("/")):
        return False
    return _covers(pattern.parts, path[len(pattern.anchor) :].split("/"))


def _covers(parts: Sequence[_Part], names: Sequence[str]) -> bool:
    if not parts:
        return True
    if parts[0].text == _ANY:
        return any(_covers(parts[1:], names[k:]) for k in range(len(names)))
    if not names:
        return False
    return parts[0].match(names[0]) is not None and _covers(parts[1:], names[1:])


def _check_kind(path: Path) -> None:
    """Refuse what is no log: nothing is opened."""
    kind = kind_of(path)
    if kind is not None:
        raise InputError(
            f"what the pattern names is {kind}",
            where=Place(label(path)),
            expected="a file, or a folder with a recording of ROS 2",
            remedy="delete it, or leave it out with exclude",
        )


def kind_of(path: Path) -> str | None:
    """What ``path`` is, where it is no log: a link to nothing, a folder, a pipe; None where it may be one."""
    if path.is_file():
        return None
    if path.is_dir():
        return None if is_log(path) else "a folder without a recording"
    return "neither a file nor a folder" if path.exists() else "not there, or a link to nothing"
