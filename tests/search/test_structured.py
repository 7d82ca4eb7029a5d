"""The search finds less, the same for the same seed, goes on from what it found, and says nothing wrong."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Final

import pytest

from dynamics.direct import exact_arm
from records.made import bundled
from robodyn import Options, program
from robodyn.counts import count
from robodyn.counts.objective import Objective, operations_of
from robodyn.dynamics.equality import equals_recursion
from robodyn.optimize.costing import Costing
from robodyn.optimize.fast import literature
from robodyn.optimize.programs import Choice, build
from robodyn.passes import FRESH, run
from robodyn.robot import Robot
from robodyn.search import structured
from robodyn.search.structured import Progress, search
from robodyn_testing import sampled
from robodyn_testing.clocks import ticking

pytestmark = pytest.mark.thorough  # whole searches: CI runs them

SHORT: Final[dict[str, Any]] = {"steps": 60, "rounds": 1, "processes": 1}


def regrouped_alone(robot: Robot) -> int:
    """Base-parameter regrouping alone, as the literature has it: what OpenSYMORO does."""
    choice = Choice(variant=literature(Costing(robot).arm), chains=False)
    return count(run(build(robot, "inverse_dynamics", choice), FRESH)).total


def test_what_is_found_is_right_and_different_and_best_first() -> None:
    robot = bundled("puma560_3dof_d3")
    told: list[Progress] = []
    found = search(robot, **SHORT, seed=1, progress=told.append)
    costs = [cost for cost, _, _ in found]
    assert costs == sorted(costs)
    assert costs[0] <= 90
    assert 1 < len(found) <= structured.KEPT
    assert len({made.operations for _, _, made in found}) == len(found)
    for cost, choice, made in found:
        assert count(made).total == cost
        assert count(made).sincos <= 6
        assert equals_recursion(robot, "inverse_dynamics", made)
        assert run(build(robot, "inverse_dynamics", choice), FRESH).operations == made.operations
    assert [at.round for at in told] == [1]
    assert told[0].tried > 100


def test_the_same_seed_finds_the_same() -> None:
    robot = bundled("stanford_3dof_d3")
    one, other, third = (search(robot, **SHORT, seed=seed) for seed in (3, 3, 4))
    assert [choice for _, choice, _ in one] == [choice for _, choice, _ in other]
    assert [choice for _, choice, _ in one] != [choice for _, choice, _ in third]


def test_a_search_keeps_to_its_time(monkeypatch: pytest.MonkeyPatch) -> None:
    ticking(monkeypatch, {structured: 0.01})
    told: list[structured.Progress] = []
    assert search(bundled("panda"), seconds=0.5, processes=1, progress=told.append)
    assert 0 < told[-1].tried < 0.5 / 0.01 + 100  # variants and clock readings go together, but for the last


def test_a_search_with_another_objective() -> None:
    robot = bundled("puma560_3dof_d3")
    for objective in (Objective("mul"), Objective("depth")):
        found = search(robot, **SHORT, seed=2, objective=objective)
        fast = program(robot, "inverse_dynamics", Options(optimize="fast"))
        assert found[0][0] < objective.cost(operations_of(fast))
        assert equals_recursion(robot, "inverse_dynamics", found[0][2])


ARMS = [
    replace(exact_arm(seed, joints=3 + seed % 5, full=bool(seed % 2), prismatic=0.1), torque_side="motor")
    for seed in range(100, 108)
]


@pytest.mark.parametrize("robot", ARMS, ids=lambda robot: robot.name)
def test_fast_is_never_above_regrouping_alone(robot: Robot) -> None:
    made = program(robot, "inverse_dynamics", Options(optimize="fast"))
    assert count(made).total <= regrouped_alone(robot)
    assert equals_recursion(robot, "inverse_dynamics", made, points=1)


@pytest.mark.parametrize("robot", sampled(ARMS[::2], every=4, rest="slow"), ids=lambda robot: robot.name)
def test_a_search_is_always_below_regrouping_alone(robot: Robot) -> None:
    found = search(robot, seconds=2, steps=40, seed=1, processes=1)
    assert found[0][0] < regrouped_alone(robot)
    assert equals_recursion(robot, "inverse_dynamics", found[0][2], points=1)


@pytest.mark.parametrize(
    ("name", "most"),
    [("puma560_d2", 270), ("stanford_d3", 210), ("puma560_3dof_d3", 107), ("stanford_3dof_d3", 67)],
)
def test_fast_on_the_robots_of_the_thesis(name: str, most: int) -> None:
    made = program(bundled(name), "inverse_dynamics", Options(optimize="fast"))
    assert count(made).total <= most
