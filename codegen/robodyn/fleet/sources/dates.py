"""When a log was recorded: dates out of names of files and cells of manifests."""

from __future__ import annotations

import re
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta, timezone, tzinfo
from typing import Final

from robodyn.errors import InputError
from robodyn.fleet.limits import LONGEST_FORMAT
from robodyn.logs.limits import EARLIEST, LATEST
from robodyn.robot.names import shown

#: ISO 8601, and what becomes of it in names of files: no colons, other marks for T. Without a day or with a
#: part of the time only it is none.
ISO: Final = (
    r"\d{4}-?[01]\d-?[0-3]\d"
    r"(?:[T_ -]?[0-2]\d[:_.-]?[0-5]\d(?:[:_.-]?[0-6]\d(?:[.,]\d{1,9})?)?"
    r"(?: ?(?:Z|[+-][01]\d:?[0-5]\d))?)?"
)
_PARTS: Final = re.compile(
    r"(\d{4})-?(\d\d)-?(\d\d)"
    r"(?:[T_ -]?(\d\d)[:_.-]?(\d\d)(?:[:_.-]?(\d\d)(?:[.,](\d{1,9}))?)?"
    r"(?: ?(Z|[+-]\d\d:?\d\d))?)?\Z",
    re.ASCII,
)
#: [s]
DAY: Final = 86400.0
#: Words in place of a format: seconds and milliseconds since 1970.
UNIX: Final = {"unix": 1.0, "unix_ms": 1000.0}
#: What each directive of a format can stand for in the name of a file.
_DIRECTIVES: Final = {
    "Y": r"\d{4}", "G": r"\d{4}", "j": r"\d{1,3}", "f": r"\d{1,6}", "z": r"(?:Z|[+-]\d\d:?\d\d)", "%": "%",
    **dict.fromkeys("mdyHIMSUWV", r"\d{1,2}"), **dict.fromkeys("uw", r"\d"),
    **dict.fromkeys("aAbBp", r"[^\W\d_]+"),
}  # fmt: skip
_OFFSET: Final = re.compile(r"(?:UTC)?([+-])([01]\d):?([0-5]\d)\Z", re.ASCII)


class NotADate(ValueError):
    """A text that is no date; the message says what was expected."""


@dataclass(frozen=True, slots=True)
class DateFormat:
    """How dates are written: a ``format`` of strptime, a word of :data:`UNIX`, or "" for ISO 8601; ``zone``:
    of dates that state none."""

    format: str
    zone: tzinfo

    @property
    def expected(self) -> str:
        """What a date looks like, for messages."""
        if self.format in UNIX:
            return f"a number of {'milliseconds' if self.format == 'unix_ms' else 'seconds'} since 1970"
        return f"a date like {self.format}" if self.format else "a date like 2026-05-03T1200 (ISO 8601)"

    def seconds(self, text: str) -> float:
        """The point in time [s since 1970, UTC] that ``text`` says.

        Raises
        ------
        NotADate: it says none, or one that no log can have.
        """
        try:
            seconds = self._seconds(text.strip())
        except (ValueError, OverflowError):
            raise NotADate(self.expected) from None
        if not EARLIEST <= seconds < LATEST:
            raise NotADate("a date from 1990 to 2099")
        return seconds

    def _seconds(self, text: str) -> float:
        if self.format in UNIX:
            return float(text) / UNIX[self.format]
        moment = datetime.strptime(text, self.format) if self.format else iso(text)
        if moment.tzinfo is None:
            moment = moment.replace(tzinfo=self.zone)
        return moment.timestamp()


def iso(text: str) -> datetime:
    """The date, perhaps with a time of day and an offset, that ``text`` says (:data:`ISO`).

    Raises
    ------
    ValueError: it is none.
    """
    match = _PARTS.match(text)
    if match is None:
        raise ValueError(text)
    numbers = [int(digits or 0) for digits in match.groups()[:6]]
    micros = int((match[7] or "").ljust(6, "0")[:6])
    zone = None if match[8] is None else UTC if match[8] == "Z" else zone_of(match[8])
    return datetime(*numbers, micros, tzinfo=zone)  # type: ignore[arg-type, misc]


def zone_of(text: str) -> tzinfo:
    """The time zone called ``text``: UTC, +02:00, Europe/Berlin.

    Raises
    ------
    ValueError: there is none.
    """
    offset = _OFFSET.match(text)
    if offset is not None:
        span = timedelta(hours=int(offset[2]), minutes=int(offset[3]))
        return timezone(-span if offset[1] == "-" else span)
    if text in ("UTC", "Z"):
        return UTC
    import zoneinfo

    try:
        return zoneinfo.ZoneInfo(text)
    except (KeyError, OSError, ValueError):
        raise ValueError(text) from None


def checked_zone(text: str) -> tzinfo:
    """As :func:`zone_of`.

    Raises
    ------
    InputError: there is no such zone.
    """
    try:
        return zone_of(text)
    except ValueError:
        raise InputError(
            "there is no such time zone",
            found=shown(text),
            expected="UTC, an offset such as +02:00, or a name such as Europe/Berlin",
            remedy="where no names are known, the package tzdata has them",
        ) from None


def check_format(text: str) -> str:
    """``text``, if it is a format of dates.

    Raises
    ------
    InputError: it is none, or one without a year.
    """
    if text in UNIX or not text:
        return text
    day = datetime(2026, 5, 3, 12, 34, tzinfo=UTC)
    try:
        if len(text) > LONGEST_FORMAT:
            raise ValueError(text)
        year = datetime.strptime(day.strftime(text), text).year
    except (ValueError, re.error, OverflowError):
        year = None
    if year != day.year:
        raise InputError(
            "this is no format of dates" if year is None else "the format of dates has no year",
            found=shown(text),
            expected="one like %Y-%m-%dT%H%M (as Python's strptime), or unix, or unix_ms",
            remedy="leave it out for dates as ISO 8601 has them",
        )
    return text


def regex_of(text: str) -> str:
    """A regular expression for the texts that dates of the format ``text`` can be."""
    if text in UNIX:
        return r"\d{1,16}(?:\.\d+)?"
    if not text:
        return ISO
    pieces = re.split(r"%(.)", text)
    literals = map(re.escape, pieces[::2])
    directives = [_DIRECTIVES.get(letter, ".+?") for letter in pieces[1::2]]
    return "".join(part for pair in zip(literals, [*directives, ""], strict=True) for part in pair)
