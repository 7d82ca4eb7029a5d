"""What is known of each log, from wherever it is known, put together."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

from robodyn.errors import InputError, Place, did_you_mean
from robodyn.files import label
from robodyn.fleet.as_json import day
from robodyn.fleet.limits import LISTED, LONGEST_NAME, MOST_CONDITIONS, MOST_LOGS
from robodyn.fleet.result import Unused
from robodyn.fleet.sources.dates import DateFormat
from robodyn.fleet.sources.fleet import IN_LOG, ArmType, Fleet, LogFile
from robodyn.fleet.sources.pattern import DATE
from robodyn.logs.content import files_of
from robodyn.robot.names import shown

#: What a log must have, and where it may be stated; all else that is known of it are conditions.
NEEDED: Final = {
    "type": "{type} in the pattern, a column of the manifest, or type = ...",
    "unit": "{unit} in the pattern, a column of the manifest, or unit = ...",
    DATE: "{date} in the pattern, a column of the manifest, or date = 'log' for times in it",
}
#: What is known of a log: type, unit and date [s since 1970; IN_LOG: its own times say it], and conditions.
Facts = dict[str, Any]


class Gathering:
    """The logs of a fleet: each once, however many places speak of it."""

    def __init__(self) -> None:
        self._logs: dict[str, tuple[str, Place, Facts]] = {}
        self._faults: dict[str, list[InputError]] = {}

    def take(
        self,
        source: str,
        where: Place,
        texts: Mapping[str, str],
        fixed: Mapping[str, Any],
        dates: DateFormat | None,
    ) -> None:
        """Take up the ``texts`` by their names that stand ``where`` of the log ``source``, beside what is
        ``fixed`` of several: type, unit, its date as ``dates`` are written, and conditions.

        Raises
        ------
        InputError: another place says otherwise, or there are too many logs.
        """
        facts: Facts = dict(fixed)
        try:
            for name, text in texts.items():
                if name not in NEEDED:
                    facts[name] = _number(name, text)
                elif name != DATE:
                    facts[name] = text
                elif dates is not None:
                    facts[name] = dates.seconds(text)
        except InputError as error:
            self._fault(error.at(where))
        else:
            self._add(source, where, facts)
        if len(self._logs) + sum(map(len, self._faults.values())) > MOST_LOGS:
            raise InputError("there are too many logs", where=where, found=f"more than {MOST_LOGS}")

    def _add(self, source: str, where: Place, facts: Facts) -> None:
        key = "+".join(os.path.abspath(part) for part in source.split("+"))  # noqa: PTH100 (a million)
        source = "+".join(os.path.normpath(part) for part in source.split("+"))
        source, first, known = self._logs.setdefault(key, (source, where, facts))
        for name, value in facts.items():
            if known.get(name, IN_LOG) is IN_LOG:
                known[name] = value
            elif value is not IN_LOG and known[name] != value:
                one, other = (day(x) if name == DATE else shown(str(x)) for x in (known[name], value))
                raise InputError(
                    f"two places differ in the {name} of {label(source)}",
                    where=where,
                    found=other,
                    expected=f"{one}, as {first} has it",
                    remedy="correct one of them, or leave one out with exclude",
                )

    def _fault(self, error: InputError) -> None:
        self._faults.setdefault(error.what, []).append(error)

    def fleet(self, name: str, types: Mapping[str, ArmType], where: Place) -> Fleet:
        """The fleet called ``name`` of the ``types``, which is described at ``where``.

        Raises
        ------
        InputError: there are no logs; one lacks its type, unit or date, or has those that no log can have.
        """
        logs, missing = [], []
        for source, place, facts in self._logs.values():
            if len(types) == 1:
                facts.setdefault("type", next(iter(types)))
            if not facts.keys() >= NEEDED.keys() and not all(map(os.path.exists, files_of(source))):
                kind, unit = (facts.get(key, "") for key in ("type", "unit"))
                missing.append(Unused(source, kind, unit, f"{place} names it, and it is not there"))
                continue
            try:
                logs.append(_log(source, place, facts, types))
            except InputError as error:
                self._fault(error)
        for same in self._faults.values():
            raise _with_others(same)
        if not logs:
            raise InputError("the fleet has no logs", where=where, found="none, or all of them excluded")
        return Fleet(name, types, tuple(sorted(logs, key=lambda log: log.order)), tuple(missing))


def _log(source: str, where: Place, facts: Facts, types: Mapping[str, ArmType]) -> LogFile:
    """The log that ``facts`` describe.

    Raises
    ------
    InputError: something is missing, or cannot be.
    """
    for what, remedy in NEEDED.items():
        if what not in facts:
            raise InputError(f"the {what} of a log is not known", where=where, remedy=f"say it: {remedy}")
    kind, unit, date = (facts[name] for name in NEEDED)
    if kind not in types:
        raise InputError(
            f"there is no type called {shown(kind)}",
            where=where,
            expected=f"one of {', '.join(map(shown, list(types)[:8]))}",
            remedy=did_you_mean(kind, types) or "write a table for it, [types.NAME], or exclude its logs",
        )
    conditions = {name: facts[name] for name in sorted(facts) if name not in NEEDED}
    for what, text in (("the unit", unit), *(("a condition", name) for name in conditions)):
        check_name(text, what, where)
    if len(conditions) > MOST_CONDITIONS:
        raise InputError(
            "a log has too many conditions", where=where, found=str(len(conditions)),
            expected=f"at most {MOST_CONDITIONS}", remedy="say which: conditions = ['temperature']",
        )  # fmt: skip
    if not _is_text(source):
        raise InputError(
            "the name of a log is not UTF-8", where=where, remedy="rename it, or leave it out with exclude"
        )
    return LogFile(source, kind, unit, date, conditions, "" if where.line is None else str(where))


def check_name(text: str, what: str, where: Place | None = None) -> None:
    """Hold the name of a unit, a type or a condition to what can be written down.

    Raises
    ------
    InputError: it is empty, too long, or not UTF-8.
    """
    if not text.strip() or len(text) > LONGEST_NAME or not _is_text(text):
        raise InputError(
            f"{what} cannot be called so",
            where=where,
            found=shown(text),
            expected=f"1 to {LONGEST_NAME} characters of UTF-8",
        )


def _number(name: str, text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if math.isfinite(number):
        return number
    raise InputError(
        f"the condition {shown(name)} is not a number",
        found=shown(text),
        expected="a number, decimals with a point, or nothing",
        remedy="correct it, or say which columns of a manifest are conditions: conditions = ['temperature']",
    )


def _is_text(name: str) -> bool:
    """Whether UTF-8 has the ``name``: those of files may hold bytes that are none."""
    return not re.search("[\ud800-\udfff]", name)


def _with_others(errors: list[InputError]) -> InputError:
    """The first of ``errors``, which have one fault, with how many more there are."""
    first, more = errors[0], errors[1:]
    if more:
        names = ", ".join(str(error.where) for error in more[: LISTED - 1])
        others = f"so are {names}" + (f" and {len(more) - LISTED + 1} more" if len(more) >= LISTED else "")
        first.remedy = f"{first.remedy} ({others})" if first.remedy else others
    return first if first.where is None else first.at(first.where)


def source_of(folder: Path, text: str) -> str:
    """The path of a log that a file in ``folder`` calls ``text``; of two that are joined by ``+``, both."""
    if "+" not in text or (folder / text).exists():
        return str(folder / text)
    return "+".join(str(folder / part) for part in text.split("+"))
