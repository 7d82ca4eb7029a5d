"""The steps of Table 2.9: put together they are Newton-Euler, and each takes what it takes."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest

from dynamics.direct import State, exact_arm
from ir.programs import Point
from robodyn.counts import Count
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.vectors import cross, plus
from robodyn.robot import Robot
from robodyn.thesis import method_steps as steps
from robodyn.thesis.method_steps import Method, by_steps
from robodyn.thesis.parts import part_costs, uicker_kahn_by_parts
from robodyn.thesis.polynomial import difference, fitted, spelled, value
from robodyn.thesis.steps import STEPS, step_counts
from robodyn_testing import exactly

ARMS = [exact_arm(seed, joints=1 + seed % 4, full=False, prismatic=0.4) for seed in range(400, 410)]
METHODS: tuple[Method, ...] = ("I", "II")


def torques(robot: Robot, method: Method) -> tuple[list[Any], list[Any]]:
    state = State(robot, Point(9))
    return by_steps(state.arm, state.motion(), method), newton_euler(state.arm, state.motion())


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("robot", ARMS, ids=lambda robot: robot.name)
def test_the_steps_put_together_are_newton_euler(robot: Robot, method: Method) -> None:
    found, expected = torques(robot, method)
    assert found == expected


def test_full_tensors_by_method_two() -> None:
    robot = exact_arm(411, joints=3, degenerate=0)
    assert any(link.inertia.xy for link in robot.links)
    found, expected = torques(robot, "II")
    assert found == expected


@pytest.mark.parametrize(
    ("method", "name", "wrong"),
    [
        ("I", "lambda_carried", lambda R, before: before),
        ("I", "slide_I", lambda w, qd, qdd, double=2: (qd * w[1], -(qd * w[0]), qdd)),
        ("II", "alpha_II", lambda R, alpha, w, rate, qdd: steps.turned_back(R, alpha)),
        ("II", "euler_II", lambda inertia, w, alpha: inertia.times(alpha)),
        ("I", "moment", lambda N, s, F, p_next, f_next, n_next: plus(N, cross(s, F), n_next)),
    ],
)  # fmt: skip
def test_a_slip_in_a_step_is_noticed(
    method: Method, name: str, wrong: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    kinds = ["revolute", "revolute", "prismatic", "revolute"]
    arms = (
        exact_arm(seed, joints=4, full=False, prismatic=0.3, generic_angles=1, zeros=0, degenerate=0)
        for seed in range(500)
    )
    robot = next(arm for arm in arms if [link.joint.kind for link in arm.links] == kinds)
    found, expected = torques(robot, method)
    assert found == expected
    monkeypatch.setattr(steps, name, wrong)
    found, expected = torques(robot, method)
    assert found != expected


def pairs(counts: dict[str, Count]) -> dict[str, tuple[int, int]]:
    return {step: (found.mul, found.add) for step, found in counts.items()}


def test_what_the_steps_take() -> None:
    """Counted by hand: a product with a full R 9/6, a cross product 6/3, lambda times a vector 9/6."""
    first = pairs(step_counts("I", revolute=True))
    assert tuple(first) == STEPS
    assert first == {
        "omega": (9, 7), "alpha": (11, 9), "lambda": (6, 9), "a": (18, 15), "a_c": (9, 9), "F": (3, 0),
        "N": (6, 3), "f": (0, 3), "f_rotated": (9, 6), "n": (21, 21),
    }  # fmt: skip
    second = pairs(step_counts("II", revolute=True))
    assert second == {
        "omega": (9, 7), "alpha": (24, 19), "lambda": (0, 0), "a": (27, 21), "a_c": (18, 15), "F": (3, 0),
        "N": (24, 18), "f": (9, 9), "f_rotated": (0, 0), "n": (21, 21),
    }  # fmt: skip
    assert pairs(step_counts("II", revolute=False))["a"] == (33, 28)
    free = pairs(step_counts("I", revolute=False, rotation="right-angled"))
    assert (free["omega"], free["lambda"], free["n"], free["a"]) == ((0, 0), (0, 0), (12, 15), (11, 12))


def test_the_129_operations_of_the_43_tasks() -> None:
    """Method I by 43 tasks of three: 174 less what the zero and the 1 of R save in five products with it."""
    whole = sum(found.total for found in step_counts("I", revolute=True).values())
    assert whole - 5 * (15 - 6) == 43 * 3


# --- polynomials and parts ----------------------------------------------------------------------------------


def test_polynomials_are_fitted_exactly_and_checked() -> None:
    cubic = {n: 2 * n**3 - n + 5 for n in range(1, 7)}
    assert fitted(cubic, 3) == exactly(2, 0, -1, 5)
    assert fitted(cubic, 4) == exactly(2, 0, -1, 5)
    assert fitted({**cubic, 6: 0}, 3) is None
    assert fitted(cubic, 2) is None
    assert fitted({n: Fraction(n, 3) for n in range(1, 5)}, 1) == exactly(Fraction(1, 3), 0)
    with pytest.raises(ValueError, match="cannot check"):
        fitted({1: 1, 2: 2}, 1)


def test_polynomials_are_spelled() -> None:
    assert spelled((Fraction(65, 2), Fraction(0), Fraction(-1), Fraction(7))) == "65/2 n^3 - n + 7"
    assert spelled((Fraction(-1), Fraction(0))) == "-n"
    assert spelled((Fraction(0),)) == "0"
    assert difference((Fraction(2), Fraction(1)), (Fraction(2), Fraction(3))) == exactly(-2)
    assert value((Fraction(2), Fraction(0), Fraction(1)), 3) == 19


def test_parts() -> None:
    assert part_costs() == {"trace": (128, 99), "product": (64, 48), "gravity": (21, 15)}
    assert uicker_kahn_by_parts(6) == exactly(67143, 51548 - 13)
