"""The diagnoses of units: of what a unit is now, and of what it was before it changed."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from robodyn.cluster import Cluster, Done
from robodyn.errors import InputError
from robodyn.fleet.limits import LOGS_AFTER
from robodyn.fleet.result import UnitResult, unit_folder
from robodyn.fleet.sources.fleet import ArmType, Fleet, LogFile
from robodyn.fleet.store import Refused, Store, key_of
from robodyn.fleet.work import Changed, absolute_source, check_changed, diagnose_unit, unpacked, why
from robodyn.outputs import check_outputs, write_files
from robodyn.toolchain.sources import own_key

#: What makes files, by their names, of a diagnosis; it can be imported by its name.
Maker = Callable[..., Mapping[str, str]]
#: The page among them, and the folder of those of before a change.
PAGE, BEFORE = "report.html", "before"
_log = logging.getLogger("robodyn.fleet")


@dataclass(frozen=True, slots=True)
class _Case:
    """Logs of a ``unit`` of a ``type`` that are diagnosed together: their ``paths`` as a worker reads them,
    and ``hashes``, where the files go (``place``, relative), and the ``key`` of what they come to."""

    type: str
    unit: str
    place: str
    paths: tuple[str, ...]
    hashes: tuple[str, ...]
    key: str


@dataclass(frozen=True, slots=True)
class Diagnosed:
    """What came of the diagnosis of a unit: its ``page`` and what is ``new`` since before it changed, effects
    with their joints."""

    page: str
    new: tuple[tuple[str, int | None], ...]


def diagnosed(
    fleet: Fleet,
    units: Sequence[UnitResult],
    hashes: Mapping[str, str],
    store: Store,
    cluster: Callable[[], Cluster],
    folder: Path,
    files_of: Maker,
    tell: Callable[[int, int], object],
) -> dict[tuple[str, str], Diagnosed]:
    """Diagnose ``units`` by their logs of which ``hashes`` (by source) are known, and write the files into
    ``folder``: what came of it by type and unit.

    Raises
    ------
    InputError, OutputError: a file cannot be written.
    WrongWorker: a worker does not see the logs.
    """
    of_unit: dict[tuple[str, str], list[LogFile]] = {}
    for log in fleet.logs:
        if log.source in hashes:
            of_unit.setdefault((log.type, log.unit), []).append(log)
    cases = [
        case
        for unit in units
        for case in _cases(unit, of_unit[unit.type, unit.unit], fleet.types[unit.type], hashes, files_of)
    ]
    new = {case.key: case for case in cases if not store.has(case.key)}
    tasks = ((key, (fleet.types[case.type], case.paths, case.hashes, files_of)) for key, case in new.items())
    if new:
        tell(0, len(new))
        for k, (key, outcome) in enumerate(cluster().each(diagnose_unit, tasks)):
            if isinstance(outcome, Done):
                store.keep(key, outcome.value)
            else:
                case = new[key]
                reason = why(outcome.error, "")
                if isinstance(outcome.error, Changed):
                    check_changed(case.paths, case.hashes, reason)
                _log.warning("%s %s: no diagnosis: %s", case.type, case.unit, reason)
                if isinstance(outcome.error, InputError):
                    store.keep(key, Refused(reason))
            tell(k + 1, len(new))
    for case in cases:  # all of them, before the first is written
        check_outputs(folder, _outcome(case, store)[1])
    named = dict[str, list[tuple[str, int | None]]]()
    for case in cases:
        effects, files = _outcome(case, store)
        if files:
            named[case.place] = effects
            write_files(folder, files)
    results = {}
    for unit in units:
        place = unit_folder(unit.type, unit.unit)
        if place in named:
            before = named.get(f"{place}/{BEFORE}", named[place])  # without one nothing is new
            new_effects = tuple(effect for effect in named[place] if effect not in before)
            results[unit.type, unit.unit] = Diagnosed(f"{place}/{PAGE}", new_effects)
    return results


def completed(unit: UnitResult, diagnosis: Diagnosed | None) -> UnitResult:
    """A unit with its diagnosis: what has changed and no number of its logs explains is called what is new
    in it at that joint."""
    if diagnosis is None:
        return unit
    claims = []
    for claim in unit.claims:
        names = tuple(effect for effect, joint in diagnosis.new if joint == claim.joint)
        claims.append(claim if claim.effects else replace(claim, effects=names[:1]))
    return replace(unit, claims=tuple(claims), diagnosis=diagnosis.page)


def _cases(
    unit: UnitResult, logs: Sequence[LogFile], arm: ArmType, hashes: Mapping[str, str], files_of: Maker
) -> list[_Case]:
    """What is diagnosed of a ``unit``: its last logs since it changed last, and the last of before."""
    days = [claim.since for claim in unit.claims if claim.since is not None]
    after = [log for log in logs if not days or log.date >= max(days)] or list(logs[-1:])
    before = [log for log in logs if days and log.date < min(days)]
    place = unit_folder(unit.type, unit.unit)
    cases = []
    for where, chosen in ((place, after[-LOGS_AFTER:]), (f"{place}/{BEFORE}", before[-1:])):
        if chosen:
            sources = tuple(log.source for log in chosen)
            own = tuple(hashes[source] for source in sources)
            maker: Any = files_of
            names = (Path(source).name for source in sources)  # stand in the files
            key = key_of(
                "diagnosis", own_key(), maker.__module__, maker.__qualname__, arm.text, arm.mapping or "",
                *names, *own,
            )  # fmt: skip
            paths = tuple(map(absolute_source, sources))
            cases.append(_Case(unit.type, unit.unit, where, paths, own, key))
    return cases


def _outcome(case: _Case, store: Store) -> tuple[list[tuple[str, int | None]], dict[str, bytes]]:
    """What the diagnosis of a ``case`` names, and its files, relative to the folder of results: none where it
    came to nothing."""
    packed = store.result(case.key)
    if not isinstance(packed, bytes):
        return [], {}
    effects, files = unpacked(packed)
    encoded = {name: text.encode(errors="surrogateescape") for name, text in files.items()}
    return effects, {f"{case.place}/{name}": content for name, content in encoded.items()}
