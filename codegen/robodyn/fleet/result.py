"""What is said of a fleet: of each type what its units have in common, of each unit what its own."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Final, Literal
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
    """A number that every log of a type shows."""

    name: Annotated[str, "Its name, unique within the type."]
    effects: Annotated[
        tuple[str, ...], "Ids of the catalogue: what they do together. None: what no effect explains."
    ]
    joint: Annotated[int | None, "The joint, from 1; null: the whole arm."]
    unit: Annotated[str, "The unit of measurement."]
    mean: Annotated[float, "The mean of the type."]
    between_units: Annotated[float, "Standard deviation from unit to unit."]
    between_logs: Annotated[float, "Standard deviation from log to log of one unit."]
    slopes: Annotated[Mapping[str, float], "Change with a condition, by its name, a unit of the condition."]
    logs: Annotated[int, "How many logs show it."]


@dataclass(frozen=True, slots=True)
class TypeResult:
    """What units of a type have in common."""

    name: Annotated[str, "The type's name."]
    joints: Annotated[int, "Joints of its arms."]
    units: Annotated[int, "How many units there are."]
    logs: Annotated[int, "How many of their logs were used."]
    programs: Annotated[int, "How many programs of motion these are of."]
    features: Annotated[tuple[Feature, ...], "The numbers that each log of the type shows."]
    account: Annotated[
        tuple[str, ...], "Where the numbers of its description come from, and what of its file is not in it."
    ]


@dataclass(frozen=True, slots=True)
class Claim:
    """What is peculiar to a unit. Points in time are seconds since 1970, UTC.

    That a unit runs another program (:data:`PROGRAM_CHANGE`) or its clock is wrong (:data:`CLOCK`) is none of
    the arm: effect and feature have that name, ``p`` and ``q`` are 0."""

    effects: Annotated[
        tuple[str, ...],
        "Ids of the catalogue, or program_change, clock; of several, what they do together. "
        "None: no effect explains it.",
    ]
    joint: Annotated[int | None, "The joint, from 1; null: the whole arm."]
    feature: Annotated[str, "The type's feature that shows it."]
    shape: Annotated[Shape, "How it came: gradually, at once, or so in all logs."]
    since: Annotated[float | None, "The day from which on it is so; null: in all logs."]
    since_interval: Annotated[
        tuple[float, float] | None, "Days between which the change was, in 95 of 100 cases."
    ]
    until: Annotated[
        float | None, "The day from which on a drift has not grown; null: it still does, or it was none."
    ]
    size: Annotated[float, "How much more there is than there was, or than its siblings have."]
    stderr: Annotated[float, "The standard error of the size."]
    unit: Annotated[str, "The unit of measurement of both."]
    share: Annotated[float | None, "The size as a share of what there was; null where that was nothing."]
    p: Annotated[float, "How often chance alone makes a unit look as odd, over all features and days."]
    q: Annotated[float, "The share of healthy units among all that are named and no less sure."]


@dataclass(frozen=True, slots=True)
class Reading:
    """What a log shows of a feature."""

    date: Annotated[float, "Days of the logs."]
    value: Annotated[float, "What each shows, without what conditions do."]
    stderr: Annotated[float, "Standard errors."]
    program: Annotated[int, "The program of motion of each log, from 1 within the type."]


@dataclass(frozen=True, slots=True)
class UnitResult:
    """A unit. ``unusual`` is the larger of how far it is from its siblings and from what it was."""

    type: Annotated[str, "The type's name."]
    unit: Annotated[str, "The unit's name."]
    logs: Annotated[int, "How many of its logs were used."]
    first: Annotated[float, "The first of them."]
    last: Annotated[float, "The last of them."]
    claims: Annotated[tuple[Claim, ...], "What is peculiar to it, the surest first."]
    readings: Annotated[Mapping[str, tuple[Reading, ...]], "By feature: what each log shows."]
    now: Annotated[
        Mapping[str, tuple[float, float]], "By feature: value after pooling, and its standard error."
    ]
    unusual: Annotated[
        Mapping[str, float],
        "By feature: standard deviations that are as rare by chance; negative: less than usual.",
    ]
    diagnosis: Annotated[
        str | None, "The page of its diagnosis, relative to this file; null: there is none."
    ] = None


@dataclass(frozen=True, slots=True)
class Unused:
    """A log that was not used: it cannot be read, is not of its type, or is the copy of another."""

    source: Annotated[str, "The log, as the fleet names it."]
    type: Annotated[str, "The type's name."]
    unit: Annotated[str, "The unit's name."]
    why: Annotated[str, "Why it was not used."]


@dataclass(frozen=True, slots=True)
class NotObserved:
    """A joint of a unit of which the logs say too little for a change to be told."""

    type: Annotated[str, "The type's name."]
    unit: Annotated[str, "The unit's name."]
    joint: Annotated[int | None, "The joint, from 1; null: all of the arm."]
    reason: Annotated[str, "Why no change can be told."]
    record: Annotated[str, "What to record."]


@dataclass(frozen=True, slots=True)
class OddLog:
    """A log that is off from all others of its unit and program: a single one is no change."""

    type: Annotated[str, "The type's name."]
    unit: Annotated[str, "The unit's name."]
    source: Annotated[str, "The log, as the fleet names it."]
    date: Annotated[float, "When it was recorded."]
    feature: Annotated[str, "The type's feature in which it is off most."]


@dataclass(frozen=True, slots=True)
class Look:
    """A unit to look at, in words."""

    type: Annotated[str, "The type's name."]
    unit: Annotated[str, "The unit's name."]
    why: Annotated[str, "Why to look at it."]
    action: Annotated[str, "What to do."]
    record: Annotated[str, "What to record next."]


@dataclass(frozen=True, slots=True)
class FleetResult:
    """All that is said of a fleet. The description of each field is that of ``fleet.json``."""

    name: Annotated[str, "The fleet's name."]
    types: Annotated[tuple[TypeResult, ...], "What units of a type have in common."]
    units: Annotated[tuple[UnitResult, ...], "Units, by type and name."]
    unused: Annotated[tuple[Unused, ...], "Logs that were not used."]
    not_observed: Annotated[
        tuple[NotObserved, ...], "Joints of which the logs say too little for a change to be told."
    ]
    odd_logs: Annotated[
        tuple[OddLog, ...],
        "Logs that are off from all others of their unit and program: single ones, no changes.",
    ]
    first_to_look_at: Annotated[tuple[Look, ...], "Units to look at, the most urgent first."]
    false_names: Annotated[float, "The share of all named units that are healthy, on average, at most."]


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
