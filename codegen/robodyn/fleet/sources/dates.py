"""When a log was recorded: dates out of names of files and cells of manifests."""

from __future__ import annotations

import re
from dataclasses import dataclass
from datetime import UTC, datetime, tzinfo
from typing import Final

from robodyn.errors import InputError
from robodyn.fleet.limits import LONGEST_FORMAT
from robodyn.logs.limits import EARLIEST, LATEST
from robodyn.robot.names import shown

#: ISO 8601, and what becomes of it in names of files: no colons, other marks for T. Without a day or with a
#: part of the time only it is none.
_PARTS: Final = (
    r"(\d{4})-?([01]\d)-?([0-3]\d)"
    r"(?:[T_ -]?([0-2]\d)[:_.-]?([0-5]\d)(?:[:_.-]?([0-6]\d)(?:[.,](\d{1,9}))?)?"
    r"(?: ?(Z|[+-][01]\d:?[0-5]\d))?)?"
)
#: The same as a part of another regular expression, without groups.
ISO: Final = re.sub(r"\((?!\?)", "(?:", _PARTS)
#: A date in the name of a log.
_IN_NAME: Final = re.compile(rf"(?<!\d){ISO}(?!\d)", re.ASCII)
#: [s] A day of UTC, which has no leap seconds here.
DAY: Final = 86400.0
#: Words in place of a format: seconds and milliseconds since 1970.
UNIX: Final = {"unix": 1.0, "unix_ms": 1000.0}
#: What a date of each word, and one without a format, looks like.
_EXAMPLES: Final = {
    "unix": "a number of seconds since 1970",
    "unix_ms": "a number of milliseconds since 1970",
    "": "a date like 2026-05-03T1200 (ISO 8601)",
}
#: What each directive of a format can stand for in the name of a file.
_DIRECTIVES: Final = {
    "Y": r"\d{4}", "G": r"\d{4}", "j": r"\d{1,3}", "f": r"\d{1,6}", "z": r"(?:Z|[+-]\d\d:?\d\d)", "%": "%",
    **dict.fromkeys("mdyHIMSUWV", r"\d{1,2}"), **dict.fromkeys("uw", r"\d"),
    **dict.fromkeys("aAbBp", r"[^\W\d_]+"),
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class DateFormat:
    """How dates are written: a ``format`` of strptime, a word of :data:`UNIX`, or "" for ISO 8601; ``zone``:
    of dates that state none."""

    format: str
    zone: tzinfo = UTC

    def seconds(self, text: str) -> float:
        """The point in time [s since 1970, UTC] that ``text`` says.

        Raises
        ------
        InputError: it says none, or one that no log can have.
        """
        expected = _EXAMPLES.get(self.format, f"a date like {self.format}")
        try:
            seconds = self._seconds(text.strip())
            if EARLIEST <= seconds < LATEST:
                return seconds
            expected = "a date from 1990 to 2099"
        except (ValueError, OverflowError):
            pass
        raise InputError(
            "the date of a log cannot be read",
            found=shown(text),
            expected=expected,
            remedy="correct it, leave the log out (exclude), or say in fleet.toml how dates are written: "
            "date = '%d.%m.%Y', or 'unix'",
        )

    def _seconds(self, text: str) -> float:
        if self.format in UNIX:
            return float(text) / UNIX[self.format]
        if self.format:
            moment = datetime.strptime(text, self.format)
        else:
            match = re.fullmatch(_PARTS, text, re.ASCII)
            if match is None:
                raise ValueError(text)
            year, month, day, hour, minute, second = (int(part or 0) for part in match.groups()[:6])
            micros = int((match[7] or "").ljust(6, "0")[:6])
            zone = zone_of(match[8]) if match[8] else None
            moment = datetime(year, month, day, hour, minute, second, micros, zone)
        return (moment if moment.tzinfo else moment.replace(tzinfo=self.zone)).timestamp()


def date_in(name: str) -> re.Match[str] | None:
    """Where the name of a file has a date; None where it has none."""
    match = _IN_NAME.search(name)
    try:
        if match is not None:
            DateFormat("").seconds(match[0])
    except InputError:
        return None
    return match


def zone_of(text: str) -> tzinfo:
    """The time zone called ``text``: UTC, +02:00, Europe/Berlin.

    Raises
    ------
    InputError: there is none.
    """
    import zoneinfo

    try:
        return datetime.strptime(text.removeprefix("UTC") or "Z", "%z").tzinfo or UTC
    except ValueError:
        pass
    try:
        return zoneinfo.ZoneInfo(text)
    except (KeyError, OSError, ValueError):
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
    if text in _EXAMPLES:
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
    return re.sub(r"%(.)", lambda match: _DIRECTIVES.get(match[1], "[^/]+?"), re.escape(text)) or ISO
