"""Walks from several programs at once, and what stops them."""

from __future__ import annotations

import itertools
import threading
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest

from records.made import ELBOW, arm, better, fast
from robodyn import Options, program
from robodyn.counts.objective import operations_of, parse_objective
from robodyn.dynamics.equality import equals_recursion
from robodyn.ir import Input, Label, Program
from robodyn.ir.field import Field
from robodyn.optimize.records.record import labelled, values_in
from robodyn.search import climb as climbing
from robodyn.search.climb import Climbed, climb
from robodyn.search.network import NoWalk
from robodyn.search.walk import Walk
from robodyn_testing.clocks import ticking
from robodyn_testing.waiting import eventually
from search.arms import bundled

ELBOW_ARM = arm(ELBOW)
PLAIN = fast(ELBOW_ARM)
OBJECTIVES = ("total", "mul", "fma", "depth", "sincos", "weighted:cortex-m3", "weighted:cortex-m4")


def cost(made: Program, objective: str = "total") -> float:
    return parse_objective(objective).cost(operations_of(made))


@pytest.fixture(autouse=True)
def _no_threads_left() -> Any:
    before = threading.active_count()  # other tests of this process may have left some
    yield
    assert eventually(lambda: threading.active_count() <= before)


@pytest.fixture(autouse=True)
def _clock(monkeypatch: pytest.MonkeyPatch) -> None:
    """A second is ten thousand steps of a walk, however fast the machine is."""
    ticking(monkeypatch, {climbing: 0.1})


@pytest.mark.parametrize("objective", OBJECTIVES)
def test_what_is_found_is_equal_and_costs_no_more(objective: str) -> None:
    found = climb(
        [PLAIN], seconds=0.15 if objective != "total" else 3.0, seed=1, objective=parse_objective(objective)
    )
    assert 1 <= len(found) <= 12
    costs = [cost(made, objective) for made in found]
    assert costs == sorted(costs)
    assert costs[0] <= cost(PLAIN, objective)
    if objective == "total":
        assert costs[0] < cost(PLAIN)
    for made in found:
        assert equals_recursion(ELBOW_ARM, "inverse_dynamics", made, points=1)


def test_the_best_given_is_among_what_is_found() -> None:
    worse = program(ELBOW_ARM, "inverse_dynamics", Options(optimize="none"))
    assert cost(worse) > cost(PLAIN)
    for seconds in (0.001, 0.5):
        found = climb([worse, PLAIN, worse], seconds=seconds, threads=4)
        assert cost(found[0]) <= cost(PLAIN)
    assert climb([PLAIN], seconds=0.0)[0] == PLAIN
    assert climb([PLAIN], seconds=-3.0, threads=-1)[0] == PLAIN


def test_time_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    steps = itertools.count()
    run = Walk.run

    def counted(self: Walk, number: int, temperature: float) -> int:
        next(steps)
        return run(self, number, temperature)

    monkeypatch.setattr(Walk, "run", counted)
    climb([fast(bundled("puma560_3dof"))], seconds=0.5)
    assert 1 <= next(steps) <= 5


def test_what_cannot_be_walked_from_does_not_stop_the_others(monkeypatch: pytest.MonkeyPatch) -> None:
    best = better(ELBOW_ARM).program

    def walk(programs: list[Program], **more: Any) -> Walk:
        if programs[0] is best:
            raise NoWalk("of the test")
        return Walk(programs, **more)

    monkeypatch.setattr(climbing, "Walk", walk)
    assert cost(best) < cost(PLAIN)
    found = climb([best, PLAIN], seconds=0.5, threads=1, seed=3)
    assert found[0] is best or cost(found[0]) < cost(best)
    assert [made for made in found if made is not best and cost(made) < cost(PLAIN)]


def test_nothing_to_rewrite_ends_at_once() -> None:
    nothing = Program((), (("tau", (Input("qd", 0), Fraction(1, 2))),))
    assert climb([nothing, replace(nothing)], seconds=1e9) == [nothing, nothing]


def test_progress_is_told() -> None:
    told: list[Climbed] = []
    found = climb([PLAIN], seconds=0.7, progress=told.append)
    assert told
    assert [at.seconds for at in told] == sorted(at.seconds for at in told)
    assert [at.best for at in told] == sorted((at.best for at in told), reverse=True)
    assert [at.steps for at in told] == sorted(at.steps for at in told)
    assert told[-1].best == cost(told[-1].program) >= cost(found[0])


@pytest.mark.parametrize("error", [KeyboardInterrupt, ZeroDivisionError])
def test_an_interrupt_stops_all_walks(error: type[BaseException]) -> None:
    def progress(at: Climbed) -> None:
        raise error

    with pytest.raises(error):
        climb([PLAIN], seconds=1e9, progress=progress)


def test_an_error_in_a_walk_is_passed_on(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(self: Walk, steps: int, temperature: float) -> int:
        raise MemoryError("of the test")

    monkeypatch.setattr(Walk, "run", fails)
    with pytest.raises(MemoryError, match="of the test"):
        climb([PLAIN], seconds=1e9)


# --- names ------------------------------------------------------------------------------------------------


def test_labels_are_true() -> None:
    """A value has the name of a quantity only if it is it, or minus it: and no two have one name."""
    field = Field("here")

    def labels(made: Program) -> list[tuple[Label, int]]:
        return [
            (op.label._replace(negative=False), (-value if op.label.negative else value) % field.prime)
            for value, op in zip(values_in(made, field), made.operations, strict=True)
            if op.label is not None
        ]

    walk = Walk([PLAIN], seed=4)
    walk.run(2000, 0.3)
    truth, named = dict(labels(PLAIN)[::-1]), labels(labelled(walk.best(), PLAIN))
    assert len(dict(named)) == len(named) > 10
    assert all(truth[label] == value for label, value in named)
    bare = replace(PLAIN, operations=tuple(op._replace(label=None) for op in PLAIN.operations), origin=None)
    assert {value for _, value in labels(labelled(bare, PLAIN))} == set(truth.values())
