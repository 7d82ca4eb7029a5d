"""What is known of each log, from wherever it is known, put together."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place, did_you_mean
from robodyn.files import label
from robodyn.fleet.as_json import day
from robodyn.fleet.limits import LISTED, LONGEST_NAME, MOST_CONDITIONS, MOST_LOGS
from robodyn.fleet.sources.fleet import IN_LOG, ArmType, Fleet, LogFile
from robodyn.robot.names import shown

_MEND: Final = "correct one of them, or leave one out with exclude"


@dataclass(slots=True)
class Facts:
    """What one place says of a log: ``where`` it does; ``in_log``: whether the log itself has its date."""

    where: Place
    type: str | None = None
    unit: str | None = None
    date: float | None = None
    in_log: bool = False
    conditions: Mapping[str, float] = field(default_factory=dict)


class Gathering:
    """The logs of a fleet: each once, however many places speak of it."""

    def __init__(self) -> None:
        self._facts: dict[str, Facts] = {}
        self._sources: dict[str, str] = {}
        self._faults: dict[str, list[InputError]] = {}

    def add(self, source: str, facts: Facts) -> None:
        """Take up what ``facts`` say of the log ``source``.

        Raises
        ------
        InputError: there are too many logs, or another place says otherwise.
        """
        key = "+".join(os.path.abspath(part) for part in source.split("+"))  # noqa: PTH100 (a million)
        source = "+".join(os.path.normpath(part) for part in source.split("+"))
        source = self._sources.setdefault(key, source)
        own = self._facts.setdefault(key, facts)
        if len(self._facts) > MOST_LOGS:
            raise InputError("there are too many logs", where=facts.where, found=f"more than {MOST_LOGS}")
        if own is facts:
            return
        pairs = {
            "type": (own.type, facts.type),
            "unit": (own.unit, facts.unit),
            "date": (own.date, facts.date),
            **{name: (own.conditions.get(name), value) for name, value in facts.conditions.items()},
        }
        for name, (one, other) in pairs.items():
            if one is not None and other is not None and one != other:
                raise InputError(
                    f"two places differ in the {name} of {label(source)}",
                    where=facts.where,
                    found=_in_words(name, other),
                    expected=f"{_in_words(name, one)}, as {own.where} has it",
                    remedy=_MEND,
                )
        own.type, own.unit = own.type or facts.type, own.unit or facts.unit
        own.date = facts.date if own.date is None else own.date
        own.in_log = own.in_log or facts.in_log
        own.conditions = {**own.conditions, **facts.conditions}

    def fault(self, error: InputError) -> None:
        """Note what is wrong with one log; :meth:`fleet` says it, with how many others have the same."""
        self._faults.setdefault(error.what, []).append(error)

    def fleet(self, name: str, types: Mapping[str, ArmType], where: Place) -> Fleet:
        """The fleet called ``name`` of the ``types``, which is described at ``where``.

        Raises
        ------
        InputError: there are no logs; one lacks its type, unit or date, or has those that no log can have.
        """
        logs = []
        for key, facts in self._facts.items():
            try:
                logs.append(_log(self._sources[key], facts, types))
            except InputError as error:
                self.fault(error)
        for same in self._faults.values():
            raise _with_others(same)
        if not logs:
            raise InputError("the fleet has no logs", where=where, found="none, or all of them excluded")
        return Fleet(name, types, tuple(sorted(logs, key=lambda log: log.order)))


def _log(source: str, facts: Facts, types: Mapping[str, ArmType]) -> LogFile:
    """The log that ``facts`` describe.

    Raises
    ------
    InputError: something is missing, or cannot be.
    """
    where = facts.where
    kind = facts.type or (next(iter(types)) if len(types) == 1 else None)
    if kind is None:
        raise _lacks("type", where, "{type} in the pattern, a column of the manifest, or type = ...")
    if kind not in types:
        raise InputError(
            f"there is no type called {shown(kind)}",
            where=where,
            expected=f"one of {', '.join(map(shown, list(types)[:8]))}",
            remedy=did_you_mean(kind, types) or "write a table for it, [types.NAME], or exclude its logs",
        )
    if facts.unit is None:
        raise _lacks("unit", where, "{unit} in the pattern, a column of the manifest, or unit = ...")
    if facts.date is None and not facts.in_log:
        raise _lacks(
            "date", where, "{date} in the pattern, a column of the manifest, or date = 'log' for times in it"
        )
    for what, text in (("the unit", facts.unit), *(("a condition", name) for name in facts.conditions)):
        check_name(text, what, where)
    try:
        source.encode()
    except UnicodeEncodeError:
        raise InputError(
            "the name of a log is not UTF-8", where=where, remedy="rename it, or leave it out with exclude"
        ) from None
    if len(facts.conditions) > MOST_CONDITIONS:
        raise InputError(
            "a log has too many conditions", where=where, found=str(len(facts.conditions)),
            expected=f"at most {MOST_CONDITIONS}", remedy="say which: conditions = ['temperature']",
        )  # fmt: skip
    date = IN_LOG if facts.date is None else facts.date
    return LogFile(source, kind, facts.unit, date, dict(sorted(facts.conditions.items())))


def check_name(text: str, what: str, where: Place | None = None) -> None:
    """Hold the name of a unit, a type or a condition to what can be written down.

    Raises
    ------
    InputError: it is empty, too long, or not UTF-8.
    """
    try:
        text.encode()
        sound = 0 < len(text) <= LONGEST_NAME and bool(text.strip())
    except UnicodeEncodeError:
        sound = False
    if not sound:
        raise InputError(
            f"{what} cannot be called so",
            where=where,
            found=shown(text),
            expected=f"1 to {LONGEST_NAME} characters of UTF-8",
        )


def _in_words(name: str, value: str | float) -> str:
    """The ``value`` of ``name`` for a message."""
    return day(value) if name == "date" and isinstance(value, float) else shown(str(value))


def _lacks(what: str, where: Place, remedy: str) -> InputError:
    return InputError(f"the {what} of a log is not known", where=where, remedy=f"say it: {remedy}")


def _with_others(errors: list[InputError]) -> InputError:
    """The first of ``errors``, which have one fault, with how many more there are."""
    first, more = errors[0], errors[1:]
    if not more:
        return first
    names = ", ".join(str(error.where) for error in more[: LISTED - 1])
    others = f"so are {names}" + (f" and {len(more) - LISTED + 1} more" if len(more) >= LISTED else "")
    return InputError(
        first.what,
        where=first.where,
        found=first.found,
        expected=first.expected,
        remedy=f"{first.remedy} ({others})" if first.remedy else others,
    )


def source_of(folder: Path, text: str) -> str:
    """The path of a log that a file in ``folder`` calls ``text``; of two that are joined by ``+``, both."""
    whole = folder / text
    if "+" not in text or whole.exists():
        return str(whole)
    return "+".join(str(folder / part) for part in text.split("+"))
