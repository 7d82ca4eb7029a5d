"""What is said of a fleet: of each type what its units have in common, of each unit what its own."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, Literal
from urllib.parse import quote

#: What a claim may say beside effects of the catalogue: the unit runs another program; its clock is wrong.
PROGRAM_CHANGE: Final = "program_change"
CLOCK: Final = "clock"
#: The feature of a clock that has lost its date.
DATE: Final = "date"
#: How a unit came to be what it is: it went up or down from a day on, jumped, or was so in all its logs.
Shape = Literal["drift", "step", "always"]


@dataclass(frozen=True, slots=True)
class Feature:
    """A number that every log of a type shows: what ``effects`` (ids of the catalogue) do at a ``joint``
    (from 1; None: of the whole arm). ``name`` is its own among the type's; ``unit``: its unit.

    Of the type: its ``mean``, the standard deviation from unit to unit (``between_units``) and from log to
    log of one unit (``between_logs``), and what it changes by with conditions that were logged (``slopes``,
    by the condition's name, in its unit a unit of the condition); ``logs`` that show it."""

    name: str
    effects: tuple[str, ...]
    joint: int | None
    unit: str
    mean: float
    between_units: float
    between_logs: float
    slopes: Mapping[str, float]
    logs: int


@dataclass(frozen=True, slots=True)
class TypeResult:
    """What units of a type have in common: their number, their logs, the programs that these are of, the
    features; ``joints``: how many;
    ``account``: lines on where the numbers of its description come from and what of its file is not in it."""

    name: str
    joints: int
    units: int
    logs: int
    programs: int
    features: tuple[Feature, ...]
    account: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Claim:
    """What is peculiar to a unit: ``effects`` at a ``joint``, by the type's ``feature``; ``since`` [s since
    1970, UTC] with the interval that holds the day in 95 of 100 cases (None where it has always been so).
    That it runs another program (:data:`PROGRAM_CHANGE`) or its clock is wrong (:data:`CLOCK`) is none of the
    arm: effect and feature have that name, ``p`` and ``q`` are 0.

    ``until``: the day from which on it has not grown (a drift that ended; None: it still grows, or is none).
    ``size``: how much more of the feature there is now than there was (``always``: than its siblings have),
    with its standard error, and as a share of what it was (None where that was nothing); ``p``: how often
    chance alone makes a unit look as odd, over all features and days that were looked at; ``q``: the share of
    healthy units among all that are named and no less sure than this one (Benjamini and Hochberg)."""

    effects: tuple[str, ...]
    joint: int | None
    feature: str
    shape: Shape
    since: float | None
    since_interval: tuple[float, float] | None
    until: float | None
    size: float
    stderr: float
    unit: str
    share: float | None
    p: float
    q: float


@dataclass(frozen=True, slots=True)
class Reading:
    """What a log shows of a feature: ``value`` without what conditions do, and its standard error; when, and
    which ``program`` (from 1) of its type it is of."""

    date: float
    value: float
    stderr: float
    program: int


@dataclass(frozen=True, slots=True)
class UnitResult:
    """A unit: its ``logs`` that were used, the first and the last day of them; what is peculiar to it (the
    surest first); by name of a feature its ``readings``, what it comes to ``now`` after pooling (value,
    standard error), and how far it is from its siblings or from what it was, in standard deviations of what
    is usual (``unusual``, the larger of both, with the sign of the difference); ``diagnosis``: the page of
    its diagnosis, relative to the fleet's."""

    type: str
    unit: str
    logs: int
    first: float
    last: float
    claims: tuple[Claim, ...]
    readings: Mapping[str, tuple[Reading, ...]]
    now: Mapping[str, tuple[float, float]]
    unusual: Mapping[str, float]
    diagnosis: str | None = None


@dataclass(frozen=True, slots=True)
class Unused:
    """A log that was not used, and ``why``: it cannot be read, is not of its type, or is another's copy."""

    source: str
    type: str
    unit: str
    why: str


@dataclass(frozen=True, slots=True)
class NotObserved:
    """A ``joint`` (from 1; None: all of the arm) of a unit of which the logs say too little for a change to
    be told: the ``reason``, and what to ``record``."""

    type: str
    unit: str
    joint: int | None
    reason: str
    record: str


@dataclass(frozen=True, slots=True)
class OddLog:
    """A log that is off from all others of its unit and program, most of all in a ``feature``: a single one
    is no change."""

    type: str
    unit: str
    source: str
    date: float
    feature: str


@dataclass(frozen=True, slots=True)
class Look:
    """A unit to look at, in the order of their worth: ``why``, the ``action`` to take, and what to record
    next of it, in words."""

    type: str
    unit: str
    why: str
    action: str
    record: str


@dataclass(frozen=True, slots=True)
class FleetResult:
    """All that is said of a fleet. Names are so sure that at most the share ``false_names`` of the units that
    have one is healthy, in the mean."""

    name: str
    types: tuple[TypeResult, ...]
    units: tuple[UnitResult, ...]
    unused: tuple[Unused, ...]
    not_observed: tuple[NotObserved, ...]
    odd_logs: tuple[OddLog, ...]
    first_to_look_at: tuple[Look, ...]
    false_names: float


#: What stands in a folder's name as it is; all else by its bytes, as in addresses.
_PLAIN: Final = re.compile(r"[\w .+()=,@-]")
#: Bytes of a folder's name that every file system takes, with some room.
_LONGEST: Final = 120


def unit_folder(type: str, unit: str) -> str:
    """The folder of a ``unit``, relative to that of the results: ``units/TYPE/UNIT``.

    Names may be any text: what a path or a file system could misunderstand is written as ``%`` and two
    digits, and of a long name the end is a hash of all of it. Two units have two folders.
    """
    return f"units/{_name(type)}/{_name(unit)}"


def address(path: str) -> str:
    """The relative address, for a link, of a file or folder."""
    return quote(path)


def _name(text: str) -> str:
    name = "".join(c if _PLAIN.match(c) else quote(_bytes(c), safe="") for c in text) or "%"
    if name.startswith("."):  # hidden, or the folder above
        name = name.replace(".", "%2E")
    if len(name.encode()) <= _LONGEST:
        return name
    digest = hashlib.sha256(_bytes(text)).hexdigest()[:16]
    return name.encode()[: _LONGEST - 20].decode(errors="ignore") + f"%-{digest}"


def _bytes(text: str) -> bytes:
    """Its bytes; names of files may hold some that are no text."""
    return text.encode(errors="surrogatepass")
