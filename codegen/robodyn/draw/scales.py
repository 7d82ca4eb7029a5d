"""Axes: round numbers, where a value is between them, and how they read."""

from __future__ import annotations

import math
from collections.abc import Sequence
from datetime import UTC, datetime
from typing import Final

_TICKS: Final = 6


def share(value: float, marks: Sequence[float]) -> float:
    """Where ``value`` is between the first and the last of ``marks``, as a share of the way."""
    return (value - marks[0]) / (marks[-1] - marks[0])


def ticks(values: Sequence[float], *, tight: bool = False, whole: bool = False) -> list[float]:
    """Round numbers, evenly spaced, around all of ``values``; with ``tight`` more of them, with ``whole`` no
    parts of one."""
    low, high = min(values), max(values)
    if high - low <= 1e-9 * max(abs(low), abs(high)):
        low, high = low - 0.5, high + 0.5
    rough = (high - low) / (_TICKS + 4 * tight)
    size = 10.0 ** math.floor(math.log10(rough))
    step = size * next((m for m in (1, 2, 5) if m * size >= rough), 10)
    step = max(step, 1) if whole else step
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    return [round(k * step, 12) for k in range(first, last + 1)]


def decades(values: Sequence[float]) -> list[float]:
    """Powers of ten around all of ``values``, which are positive."""
    first, last = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    return [10.0**k for k in range(first, max(last, first + 1) + 1)]


def label(value: float) -> str:
    """A number at an axis: thousands apart, no power of ten where it can be read without."""
    if value == int(value) and abs(value) < 1e9:
        return f"{int(value):,}".replace(",", " ")
    return f"{value:g}"


DAY: Final = 86_400.0
"""Seconds of a day."""

_MONTHS: Final = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")
#: Months between ticks, the smallest that gives few enough.
_STEPS: Final = (1, 2, 3, 6, 12)
#: Years between ticks where these are too short; more ticks than this are on no axis.
_YEARS: Final = (2, 5, 10, 20, 50, 100, 1000)
_MOST: Final = 100
#: Days between ticks where a month is too long.
_DAYS: Final = (1, 2, 5, 10)
#: The first and the last moment of a calendar [s since 1970].
_FIRST, _LAST = -62_135_596_800.0, 253_402_300_799.0


def moment(seconds: float) -> datetime:
    """The point in time ``seconds`` after 1970 began; the calendar's end where it is beyond it."""
    return datetime.fromtimestamp(math.floor(min(max(seconds, _FIRST), _LAST)), UTC)


def day_text(seconds: float) -> str:
    """``3 May 2025``."""
    at = moment(seconds)
    return f"{at.day} {_MONTHS[at.month - 1]} {at.year}"


def range_text(first: float, last: float) -> str:
    """``3 to 17 May 2025``, with month and year of the first day where they differ."""
    a, b = moment(first), moment(last)
    if a.date() == b.date():
        return day_text(first)
    head = str(a.day)
    if (a.year, a.month) != (b.year, b.month):
        head += f" {_MONTHS[a.month - 1]}"
    if a.year != b.year:
        head += f" {a.year}"
    return f"{head} to {day_text(last)}"


def date_ticks(first: float, last: float, most: int) -> list[tuple[float, str]]:
    """Places between two points in time [s] and their labels, ``most`` (2 or more) at most: firsts of months,
    days where less than two of those are between them."""
    for step in _steps(first, last):
        at = [seconds for seconds in _months(first, last, step) if first <= seconds <= last]
        if len(at) <= most:
            break
    else:
        at = []
    if len(at) >= 2:
        return [(seconds, _label(seconds, k == 0)) for k, seconds in enumerate(at)]
    for days in (*_DAYS, max(1, math.ceil((last - first) / DAY / most))):
        begin = math.ceil(first / (days * DAY)) * days * DAY
        at = [begin + k * days * DAY for k in range(int(max(0.0, last - begin) / (days * DAY)) + 1)]
        at = [seconds for seconds in at if first <= seconds <= last]
        if len(at) <= most:
            break
    return [(seconds, f"{moment(seconds).day} {_MONTHS[moment(seconds).month - 1]}") for seconds in at]


def _steps(first: float, last: float) -> list[int]:
    """Months between ticks that are tried: from the first that gives few enough up to the whole range."""
    years = int((last - first) / (365 * DAY)) + 1
    steps = [*_STEPS, *(12 * k for k in _YEARS if k <= 2 * years)]
    return [step for step in steps if 12 * years / step <= _MOST]


def _months(first: float, last: float, step: int) -> list[float]:
    """Every ``step``-th first of a month about a range [s since 1970]; years begin anew."""
    start, end = moment(first), moment(last)
    begin = (start.year * 12 + start.month - 1) // step * step
    return [
        datetime(month // 12, month % 12 + 1, 1, tzinfo=UTC).timestamp()
        for month in range(max(begin, 12), min(end.year * 12 + end.month, 9999 * 12 + 11) + 1, step)
    ]


def _label(seconds: float, is_first: bool) -> str:
    """A month; with its year where one begins, or where it is the first."""
    at = moment(seconds)
    return f"{_MONTHS[at.month - 1]} {at.year}" if is_first or at.month == 1 else _MONTHS[at.month - 1]
