"""The diagnoses of units: of what a unit is now, and of what it was before it changed."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from robodyn.fleet.limits import LOGS_AFTER
from robodyn.fleet.result import UnitResult, unit_folder
from robodyn.fleet.sources.fleet import ArmType, LogFile
from robodyn.fleet.store import Store, key_of
from robodyn.fleet.work import diagnose_unit, unpacked
from robodyn.outputs import check_outputs, write_files
from robodyn.toolchain.sources import own_key

#: What makes files, by their names, of a diagnosis; it can be imported by its name.
Maker = Callable[..., Mapping[str, str]]
#: Has tasks worked out, by their keys, and says why some come to nothing.
Work = Callable[[Mapping[str, tuple[Any, ...]], Callable[..., bytes]], Mapping[str, str]]
#: The page among the files, and the folder of those of before a change.
PAGE, BEFORE = "report.html", "before"
_log = logging.getLogger("robodyn.fleet")


def diagnosed(
    types: Mapping[str, ArmType],
    logs: Mapping[str, LogFile],
    hashes: Mapping[str, str],
    units: Sequence[UnitResult],
    store: Store,
    folder: Path,
    files_of: Maker,
    work: Work,
) -> dict[str, list[tuple[str, int | None]]]:
    """Diagnose ``units`` of ``types`` by their ``logs`` by the paths by which workers read them, with their
    ``hashes``, and write the files into ``folder``: by the folder of a unit that has a diagnosis, what is new
    in it since before it changed, effects with their joints, the surest first.

    Raises
    ------
    InputError, OutputError: a file cannot be written.
    WrongWorker: a worker does not see the logs.
    """
    of_unit: dict[tuple[str, str], list[str]] = {}
    for path, log in logs.items():
        of_unit.setdefault((log.type, log.unit), []).append(path)
    cases: dict[str, str] = {}  # keys of what a diagnosis comes to, by where its files go
    tasks: dict[str, tuple[Any, ...]] = {}
    maker: Any = files_of
    for unit in units:
        arm, place = types[unit.type], _folder(unit)
        days = [claim.since for claim in unit.claims if claim.since is not None]
        own = of_unit[unit.type, unit.unit]
        after = [path for path in own if not days or logs[path].date >= max(days)] or own[-1:]
        before = [path for path in own if days and logs[path].date < min(days)]
        for where, chosen in ((place, after[-LOGS_AFTER:]), (f"{place}/{BEFORE}", before[-1:])):
            if chosen:
                contents = [hashes[path] for path in chosen]
                names = (Path(logs[path].source).name for path in chosen)  # stand in the files
                key = key_of(
                    "diagnosis", own_key(), maker.__module__, maker.__qualname__, arm.text, arm.mapping or "",
                    arm.covariance or "", *names, *contents,
                )  # fmt: skip
                cases[where], tasks[key] = key, (arm, chosen, contents, files_of)
    for key, reason in work(tasks, diagnose_unit).items():
        _log.warning("%s: no diagnosis: %s", next(place for place in cases if cases[place] == key), reason)
    for place, key in cases.items():  # all of them, before the first is written
        check_outputs(folder, _outcome(store, place, key)[1])
    named: dict[str, list[tuple[str, int | None]]] = {}
    for place, key in cases.items():
        effects, files = _outcome(store, place, key)
        if files:
            named[place] = effects
            write_files(folder, files)
    new = {}
    for place in map(_folder, units):
        if place in named:
            old = named.get(f"{place}/{BEFORE}", named[place])  # without one nothing is new
            new[place] = [effect for effect in named[place] if effect not in old]
    return new


def completed(unit: UnitResult, new: Mapping[str, Sequence[tuple[str, int | None]]]) -> UnitResult:
    """A unit with its diagnosis, where there is one: what has changed and no number of its logs explains is
    called what is ``new`` in it at that joint."""
    place = _folder(unit)
    if place not in new:
        return unit
    claims = []
    for claim in unit.claims:
        names = [effect for effect, joint in new[place] if joint == claim.joint]
        claims.append(claim if claim.effects else replace(claim, effects=tuple(names[:1])))
    return replace(unit, claims=tuple(claims), diagnosis=f"{place}/{PAGE}")


def _folder(unit: UnitResult) -> str:
    return unit_folder(unit.type, unit.unit)


def _outcome(store: Store, place: str, key: str) -> tuple[list[tuple[str, int | None]], dict[str, bytes]]:
    """What a diagnosis names, and its files by their paths in the folder of results: none where it came to
    nothing."""
    packed = store.result(key)
    if not isinstance(packed, bytes):
        return [], {}
    effects, files = unpacked(packed)
    encoded = {name: text.encode(errors="surrogateescape") for name, text in files.items()}
    return effects, {f"{place}/{name}": content for name, content in encoded.items()}
