"""The steps of Table 2.9: put together they are Newton-Euler, and each takes what it takes. Polynomials."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from dynamics.direct import State, exact_arm
from ir.programs import Point
from robodyn.counts import Count
from robodyn.dynamics.arm import Symmetric
from robodyn.dynamics.modified_newton_euler import Kinematics, inertia_moment
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.vectors import plus
from robodyn.robot import Robot
from robodyn.thesis import steps
from robodyn.thesis.polynomial import difference, fit, polynomial_text, value
from robodyn.thesis.slips.recursion import Recursion
from robodyn.thesis.steps import step_counts
from robodyn.thesis.tables.formulations import part_costs, uicker_kahn_by_parts
from robodyn_testing import exactly

ARMS = [exact_arm(seed, joints=1 + seed % 4, full=False, prismatic=0.4) for seed in range(400, 410)]


def torques(robot: Robot) -> tuple[list[Any], list[Any]]:
    state = State(robot, Point(9))
    return Recursion().torques(state.arm, state.motion()), newton_euler(state.arm, state.motion())


@pytest.mark.parametrize("robot", ARMS, ids=lambda robot: robot.name)
def test_the_steps_of_method_one_put_together_are_newton_euler(robot: Robot) -> None:
    found, expected = torques(robot)
    assert found == expected


@pytest.mark.parametrize("robot", ARMS[:4], ids=lambda robot: robot.name)
def test_the_steps_of_method_two_are_those_of_method_one(robot: Robot) -> None:
    """On a body of that arm in any motion; of full tensors the moment is that of the book."""
    state = State(robot, Point(9))
    body, numbers = state.arm.bodies[-1], iter(Fraction(k, 7) for k in range(3, 200, 5))
    w, alpha, a, p = ((next(numbers), next(numbers), next(numbers)) for _ in range(4))
    qd, qdd = next(numbers), next(numbers)
    R = ((Fraction(3, 5), Fraction(-4, 5), 0), (0, 0, -1), (Fraction(4, 5), Fraction(3, 5), 0))
    lam, own = steps.lambda_I(w, alpha), steps.omega(R, w, qd)
    rate = (0, 0, qd)
    assert steps.alpha_II(R, alpha, w, rate, qdd) == steps.alpha_I(R, alpha, own, qd, qdd)
    assert steps.a_II(R, a, w, alpha, p) == steps.a_I(R, a, lam, p)
    assert steps.a_c_II(a, w, alpha, p) == steps.a_c_I(a, lam, p)
    assert plus(steps.slide_II(w, rate), (0, 0, qdd)) == steps.slide_I(w, qd, qdd)
    assert steps.euler_II(body.inertia, w, alpha) == steps.euler_I(body.inertia, alpha, lam.k)
    full = Symmetric(*(next(numbers) for _ in range(6)))
    at = Kinematics(w, alpha, lam, a, p)
    assert steps.euler_II(full, w, alpha) == inertia_moment(full, at)


def pairs(counts: dict[str, Count]) -> dict[str, tuple[int, int]]:
    return {step: (found.mul, found.add) for step, found in counts.items()}


def test_what_the_steps_take() -> None:
    """Counted by hand: a product with a full R 9/6, a cross product 6/3, lambda times a vector 9/6."""
    first = pairs(step_counts("I", revolute=True))
    assert list(first.items()) == [
        ("omega", (9, 7)), ("alpha", (11, 9)), ("lambda", (6, 9)), ("a", (18, 15)), ("a_c", (9, 9)),
        ("F", (3, 0)), ("N", (6, 3)), ("f", (0, 3)), ("f_rotated", (9, 6)), ("n", (21, 21)),
    ]  # fmt: skip
    assert pairs(step_counts("II", revolute=True)) == {
        "omega": (9, 7), "alpha": (24, 19), "lambda": (0, 0), "a": (27, 21), "a_c": (18, 15), "F": (3, 0),
        "N": (24, 18), "f": (9, 9), "f_rotated": (0, 0), "n": (21, 21),
    }  # fmt: skip
    assert pairs(step_counts("II", revolute=False))["a"] == (33, 28)
    free = pairs(step_counts("I", revolute=False, rotation="right-angled"))
    assert (free["omega"], free["lambda"], free["n"], free["a"]) == ((0, 0), (0, 0), (12, 15), (11, 12))
    # the 43 tasks of three: 174 less what the zero and the 1 of R save in five products with it
    assert sum(map(sum, first.values())) - 5 * (15 - 6) == 43 * 3


# --- polynomials and parts ----------------------------------------------------------------------------------


def test_polynomials_are_fitted_exactly_and_checked() -> None:
    cubic = {n: 2 * n**3 - n + 5 for n in range(1, 7)}
    assert fit(cubic, 3) == fit(cubic, 4) == exactly(2, 0, -1, 5)
    assert fit({**cubic, 6: 0}, 3) is None
    assert fit(cubic, 2) is None
    assert fit({n: Fraction(n, 3) for n in range(1, 5)}, 1) == exactly(Fraction(1, 3), 0)
    with pytest.raises(ValueError, match="cannot check"):
        fit({1: 1, 2: 2}, 1)


def test_polynomials_are_spelled() -> None:
    assert polynomial_text((Fraction(65, 2), Fraction(0), Fraction(-1), Fraction(7))) == "65/2 n^3 - n + 7"
    assert polynomial_text((Fraction(-1), Fraction(0))) == "-n"
    assert polynomial_text((Fraction(0),)) == "0"
    assert difference((Fraction(2), Fraction(1)), (Fraction(2), Fraction(3))) == exactly(-2)
    assert value((Fraction(2), Fraction(0), Fraction(1)), 3) == 19


def test_parts() -> None:
    assert part_costs() == {"trace": (128, 99), "product": (64, 48), "gravity": (21, 15)}
    assert uicker_kahn_by_parts(6) == {"mul": 67143, "add": 51548 - 13}
