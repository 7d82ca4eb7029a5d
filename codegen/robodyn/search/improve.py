"""Searching for a better program of a robot, and keeping what is found.

``search`` goes through formulation variants, closed forms of short arms among them, and walks on
from the best for a while; ``full`` walks on for long, by any identity that holds. Either ends in a record:
compared with the plain recursion without rounding, or not handed out at all.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

from robodyn.counts.objective import Objective, operations_of
from robodyn.dynamics.equality import same_in_field
from robodyn.dynamics.functions import FUNCTIONS, function_named
from robodyn.errors import InputError, ToolError
from robodyn.ir.program import Program, rarely_collected
from robodyn.kernels.generate import Options
from robodyn.kernels.generate import program as generated
from robodyn.optimize.closed_form import closed_forms
from robodyn.optimize.records import Record, best_record, identity
from robodyn.optimize.records.find import file_name, identity_at
from robodyn.optimize.records.record import labelled
from robodyn.optimize.records.rounding import Rounding
from robodyn.optimize.records.validation import adopted, check_reading, validated
from robodyn.outputs import replace_file
from robodyn.passes import SPELLING, run, units
from robodyn.robot.model import Robot
from robodyn.search.climb import Climbed, climb
from robodyn.search.structured import search
from robodyn.search.transfer import transferred
from robodyn.search.walk import library
from robodyn.toolchain.cache import default_root

Stage = Literal["search", "full"]

#: Seconds that each level takes unless told otherwise.
BUDGET = {"search": 60.0, "full": 180.0}
#: What is found is kept every so many seconds, so that an interrupted search can go on from there.
_SAVE_AFTER = 10.0
#: The share of the time that goes to formulation variants; the rest is for the walk.
_WRITINGS = {"search": 0.85, "full": 0.4}
#: The share of the time that records of arms which are built alike may take.
_ALIKE = 0.3
#: How hard closed forms are looked for, by second of the budget: ten seconds of work for a minute.
_EFFORT, _LEAST_EFFORT = 1 / 60, 0.08
#: Closed forms are written out for so many joints at the most.
_SHORT = 3


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a search is: the stage, the seconds gone of those it has, and the least cost so far."""

    stage: str
    seconds: float
    of: float
    best: float


@rarely_collected()
def improved(
    robot: Robot,
    *,
    level: Stage = "full",
    function: str = "inverse_dynamics",
    seconds: float | None = None,
    seed: int = 0,
    objective: Objective | None = None,
    processes: int = 2,
    folders: Sequence[Path] = (),
    resume: bool = True,
    known: Sequence[Record] = (),
    progress: Callable[[Progress], None] | None = None,
) -> Record:
    """The best program of ``function`` that is found in ``seconds``, as a record.

    With ``resume`` the search starts from the records that there are (in ``folders``, in the cache, bundled)
    and what it finds goes into the cache; without, it starts from the ``known`` ones and keeps nothing. It is
    never worse than what ``fast`` gives.

    Raises
    ------
    InputError: an unknown function or level, or a budget that is none.
    ToolError: ``full`` without a C compiler (``search`` then does not walk).
    """
    check_search(level, function, seconds)
    budget = BUDGET[level] if seconds is None else seconds
    end = time.monotonic() + budget
    objective = objective or Objective()
    recursion = generated(robot, function, Options((function,), optimize="fast"))
    known = known_records(robot, function, objective, folders, recursion) if resume else list(known)
    starts = [recursion, *(record.program for record in known)]
    if resume and not known:
        starts += transferred(robot, function, time.monotonic() + _ALIKE * budget)
    # A variant knows the inverse dynamics only; the other functions are walked from where they stand.
    # Where a record is known already, most of the time goes to walking on from it.
    written = (_WRITINGS[level] if len(starts) == 1 else 0.5 * _WRITINGS[level]) * budget
    if function_named(function).is_recursion:

        def told(at: Any) -> None:
            if progress is not None:
                progress(Progress("variants", at.seconds, written, at.best))

        variants = search(
            robot, seconds=written, seed=seed, objective=objective, processes=processes, progress=told
        )
        starts += [program for _, _, program in variants]
        if robot.n <= _SHORT and cost(recursion, objective) > 0:
            starts += closed_forms(robot, effort=min(1.0, max(_LEAST_EFFORT, budget * _EFFORT)))
    distinct = _distinct([*starts, *map(units, starts)], objective)
    how = f"robodyn --optimize {level}, seed {seed}"
    if level == "full" or _compiler():
        left = max(0.5, end - time.monotonic())
        saved = (0.0, cost(distinct[0], objective))

        def tell(at: Climbed) -> None:
            nonlocal saved
            if progress is not None:
                progress(Progress("algebra", at.seconds, left, at.best))
            if resume and at.best < saved[1] and at.seconds > saved[0] + _SAVE_AFTER:
                saved = (at.seconds, at.best)
                if (better := proved(robot, function, at.program, recursion, objective, how)) is not None:
                    keep(better)

        distinct = climb(
            distinct, seconds=left, seed=seed, objective=objective, threads=processes, progress=tell
        )
    results = (proved(robot, function, program, recursion, objective, how) for program in distinct)
    record = next(result for result in results if result is not None)  # the recursion equals itself
    record = next((old for old in known if old.program.operations == record.program.operations), record)
    if resume:
        keep(record)
    return record


def _compiler() -> bool:
    """Whether the walk can be compiled: ``search`` does without where it cannot."""
    try:
        library()
    except ToolError:
        return False
    return True


def cost(program: Program, objective: Objective) -> float:
    """What ``program`` costs by ``objective``."""
    return objective.cost(operations_of(program))


def check_search(level: str, function: str, seconds: float | None) -> None:
    """
    Raises
    ------
    InputError: an unknown function or level, or a budget that is none.
    """
    if level not in BUDGET:
        raise InputError(f"unknown search {level!r}", expected=f"one of {', '.join(BUDGET)}")
    if function not in FUNCTIONS or not FUNCTIONS[function].searchable:
        allowed = [name for name, known in FUNCTIONS.items() if known.searchable]
        raise InputError(f"no search for the function {function!r}", expected=f"one of {', '.join(allowed)}")
    if seconds is not None and not (math.isfinite(seconds) and 0 < seconds <= 1e6):
        raise InputError("no budget in seconds", found=str(seconds), expected="a number above 0, at most 1e6")


def _distinct(programs: Sequence[Program], objective: Objective) -> list[Program]:
    """The programs, best first, each once."""
    distinct: dict[object, Program] = {}
    for program in programs:
        plain = tuple((op, args) for op, args, _ in program.operations)
        distinct.setdefault((plain, program.outputs), replace(program, origin=None))
    return sorted(distinct.values(), key=lambda program: cost(program, objective))


def proved(
    robot: Robot, function: str, program: Program, recursion: Program, objective: Objective, how: str
) -> Record | None:
    """``program`` as a record that was found ``how``, named and spelled; None where it is not what the
    recursion is, or loses too many digits to rounding."""
    named = labelled(run(replace(program, origin=None), SPELLING), recursion)
    record = Record(robot.name, identity(robot), function, objective.key, how, named)
    try:
        check_reading(record, rounding := Rounding(recursion))
        validated(named, recursion, record, rounding=rounding)
    except InputError:
        return None
    return record if same_in_field(robot, function, named) else None


def known_records(
    robot: Robot, function: str, objective: Objective, folders: Sequence[Path], recursion: Program
) -> list[Record]:
    """Records of earlier searches; damaged ones are passed over, since a search makes new ones."""
    programs = []
    places: list[Sequence[Path]] = [folders, ()]
    if (cache := kept_folder()) is not None:
        places.insert(0, (cache,))
    for place in places:
        try:
            record = best_record(robot, function, objective.key, place)
            if record is not None:
                check_reading(record, rounding := Rounding(recursion))
                validated(record.program, recursion, record, rounding=rounding)
                programs.append(record)
        except InputError:
            continue
    if not programs:
        record = adopted(
            robot, function, lambda _: recursion, lambda _: Rounding(recursion), objective.key, folders
        )
        programs = [record] if record is not None else []
    return programs


def kept_folder() -> Path | None:
    """Where searches keep what they found between runs; None where there is no cache."""
    root = default_root()
    return None if root is None else root / "records"


def keep(record: Record) -> None:
    """Keep ``record`` in the cache, if there is one."""
    folder = kept_folder()
    if folder is not None:
        try:
            write_record(record, folder)
        except OSError:  # a cache that cannot be written is no cache
            return


def write_record(record: Record, folder: Path) -> Path:
    """Write ``record`` into ``folder``, whole or not at all; its path.

    The record of another robot of that name, as an arm and the same arm with a tool are, stays.
    """
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / file_name(record.robot, record.function, record.objective)
    if identity_at(path) not in (None, record.identity):
        name = f"{record.robot}-{record.identity[:8]}"
        path = folder / file_name(name, record.function, record.objective)
    replace_file(path, record.text().encode())
    return path
