"""Searching and keeping: never worse, always exact, and a search goes on from where the last one ended."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from records.made import ELBOW, SMOOTH, arm, better, fast
from robodyn import InputError, Options, program
from robodyn.counts import count
from robodyn.counts.objective import Objective, parse_objective
from robodyn.dynamics.equality import equals_recursion
from robodyn.ir import Operation, Program
from robodyn.optimize.records import FOLDER, Record, identity, parse_record
from robodyn.robot import Robot
from robodyn.search import climb as climbing
from robodyn.search import improve as improving
from robodyn.search.improve import Progress, cost, improved, write_record
from robodyn.search.walk import library
from robodyn_testing import representative
from robodyn_testing.clocks import ticking
from search.arms import SPECIAL, search_for_a_moment

pytestmark = pytest.mark.thorough  # whole searches: CI runs them

ROBOT = arm(ELBOW)
NAME = "elbow.inverse_dynamics.total.record"


@pytest.fixture(scope="module", autouse=True)
def _compiled() -> None:
    library()  # once, into the cache of all tests


@pytest.fixture
def moment(monkeypatch: pytest.MonkeyPatch) -> None:
    search_for_a_moment(monkeypatch)


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A cache of the test's own."""
    folder = tmp_path / "cache"
    monkeypatch.setenv("ROBODYN_CACHE", str(folder))
    yield folder
    assert not list(tmp_path.rglob("*.tmp"))


def quick(robot: Robot = ROBOT, **more: Any) -> Record:
    """A short search in this process: variants only, unless told otherwise."""
    return improved(robot, **{"level": "search", "seconds": 0.05, "processes": 1, **more})


def check(record: Record, robot: Robot = ROBOT, function: str = "inverse_dynamics") -> None:
    objective = parse_objective(record.objective)
    assert (record.robot, record.identity, record.function) == (robot.name, identity(robot), function)
    assert cost(record.program, objective) <= cost(fast(robot, function), objective)
    if robot.rest_velocity is None:
        assert equals_recursion(robot, function, record.program)
    assert parse_record(record.text(), "") == record
    made = program(robot, function, Options((function,), objective=record.objective, records=(record,)))
    assert cost(made, objective) <= cost(fast(robot, function), objective)


@pytest.mark.usefixtures("moment")
@pytest.mark.parametrize("level", ["search", "full"])
def test_a_short_search_is_exact_and_no_worse(level: Any) -> None:
    record = quick(level=level, seed=3, seconds=0.5)
    check(record)
    check(quick(SPECIAL["smooth"], level=level), SPECIAL["smooth"])  # what has no exact value
    assert record.origin == f"robodyn --optimize {level}, seed 3"
    assert count(record.program).total < count(fast(ROBOT)).total


@pytest.mark.usefixtures("moment")
@pytest.mark.parametrize(("level", "seconds"), [("search", 0.01), ("search", 1e-9), ("full", 1e-9)])
def test_hardly_any_time(level: Any, seconds: float) -> None:
    check(improved(ROBOT, level=level, seconds=seconds, processes=1))


@pytest.mark.parametrize(
    "objective", representative(["mul", "fma", "depth", "sincos", "weighted:cortex-m3"], "depth", rest="slow")
)
def test_objectives(objective: str, cache: Path) -> None:
    check(quick(objective=parse_objective(objective)))
    (path,) = (cache / FOLDER).iterdir()
    assert f"\nobjective {objective}\n" in path.read_text()


# --- keeping and going on ---------------------------------------------------------------------------------


@pytest.mark.usefixtures("moment")
def test_what_was_found_is_kept_and_gone_on_from(cache: Path) -> None:
    first = quick(level="full")
    path = cache / FOLDER / NAME
    assert path.read_text() == first.text()
    for level in ("search", "full"):
        again = quick(level=level, seconds=1e-6, seed=9)
        assert count(again.program).total <= count(first.program).total
        if again.program.operations == first.program.operations:
            assert again.origin == first.origin, "who found it first is told"


def test_from_nothing_without_resume(cache: Path) -> None:
    write_record(better(ROBOT), cache / FOLDER)
    before = (cache / FOLDER / NAME).read_text()
    record = quick(seconds=1e-6, resume=False)
    assert record.program.operations != better(ROBOT).program.operations
    assert (cache / FOLDER / NAME).read_text() == before
    (cache / FOLDER / NAME).unlink()
    quick(resume=False)
    assert list((cache / FOLDER).iterdir()) == []


def damaged(kind: str) -> str:
    good = better(ROBOT)
    if kind == "text":
        return good.text().replace("tau = ", "tau := ")
    if kind == "program":
        k = next(k for k, op in enumerate(good.program.operations) if op.op == "sub")
        changed = good.program.operations[k]._replace(op="add")
        lines = (*good.program.operations[:k], changed, *good.program.operations[k + 1 :])
        return replace(good, program=replace(good.program, operations=lines)).text()
    if kind == "zero":
        more = Operation("div", (Fraction(1), 0)), Operation("sin", (1,))
        lines = (*good.program.operations, more[0])
        return replace(good, program=Program(lines, good.program.outputs)).text()
    return good.text()[: len(good.text()) // 2]


@pytest.mark.parametrize("kind", representative(["text", "program", "zero", "half"], "program"))
def test_a_damaged_record_in_the_cache_is_passed_over(kind: str, cache: Path) -> None:
    path = cache / FOLDER / NAME
    path.parent.mkdir(parents=True)
    path.write_text(damaged(kind))
    record = quick()
    check(record)
    assert path.read_text() == record.text()


@pytest.mark.parametrize(
    "where",
    representative(["/dev/null", "/proc/nowhere", "file", "~nobody-there/x"], "/proc/nowhere", "file"),
)
def test_a_cache_that_cannot_be_written_is_none(
    where: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "file"
    file.write_text("")
    monkeypatch.setenv("ROBODYN_CACHE", str(file) if where == "file" else where)
    check(quick())
    assert file.read_text() == ""


def test_an_interrupted_search_has_kept_what_it_found(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ticking(monkeypatch, {climbing: 0.1})  # a first walk of a hundred thousand steps, and as many after it
    monkeypatch.setattr(improving, "_SAVE_AFTER", 0.0)
    monkeypatch.setattr(improving, "search", lambda *_, **__: [])
    monkeypatch.setattr(improving, "closed_forms", lambda *_, **__: [])

    def stop(at: Progress) -> None:
        if (cache / FOLDER / NAME).exists():
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        improved(ROBOT, level="full", seconds=20, processes=1, progress=stop)
    kept = parse_record((cache / FOLDER / NAME).read_text(), "")
    check(kept)
    assert count(kept.program).total < count(fast(ROBOT)).total


def test_progress_is_told(cache: Path) -> None:
    told: list[Progress] = []
    record = quick(progress=told.append, level="full", seconds=1.5)
    stages = [at.stage for at in told]
    assert sorted(stages, reverse=True) == stages
    assert set(stages) == {"variants", "algebra"}
    assert all(0 < at.of <= 1.5 for at in told)
    for stage in set(stages):
        best = [at.best for at in told if at.stage == stage]
        assert best == sorted(best, reverse=True)
    assert cost(record.program, Objective()) <= told[-1].best


# --- what is refused --------------------------------------------------------------------------------------


def test_what_is_no_search() -> None:
    for seconds in (0, -1, math.nan, math.inf, 1e7):
        with pytest.raises(InputError, match="budget in seconds"):
            improved(ROBOT, seconds=seconds)
    with pytest.raises(InputError, match="unknown search 'fast'"):
        improved(ROBOT, level="fast")  # type: ignore[arg-type]
    for function in ("forward_dynamics", "torque"):
        with pytest.raises(InputError, match=f"no search for the function '{function}'"):
            improved(ROBOT, function=function)


def test_a_program_that_is_wrong_is_never_handed_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever a search believes: a program with a sign wrong, and cheaper, is left out."""
    for robot in (ROBOT, arm(SMOOTH)):
        plain = fast(robot)
        ((name, elements),) = plain.outputs
        wrong = Program(plain.operations[:3], ((name, (0, *([1] * (len(elements) - 1)))),))

        def climbs(programs: Any, wrong: Program = wrong, **_: Any) -> list[Program]:
            return [wrong, *programs]

        monkeypatch.setattr(improving, "climb", climbs)
        record = quick(robot, level="full")
        check(record, robot)
        assert record.program.operations != wrong.operations
