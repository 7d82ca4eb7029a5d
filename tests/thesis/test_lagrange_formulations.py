"""Lagrange's equations in closed form and in Hollerbach's recursions: exactly Newton-Euler's torques, and
general counts that stand beside the thesis's Table 1.1, difference by difference."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import sympy

from dynamics.direct import State, exact_arm, values_of, with_named_numbers
from ir.programs import Point, exactly
from robodyn import Options, load, program
from robodyn.counts import Count, count
from robodyn.counts.general import Formulation, general_count
from robodyn.dynamics import transforms
from robodyn.dynamics.arm import JointAngle, build_arm, build_motion
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.vectors import unmarked
from robodyn.ir import Graph, Program
from robodyn.ir.fingerprint import fingerprint
from robodyn.ir.lowering import lower
from robodyn.optimize.programs import exact, turned
from robodyn.passes import FRESH, run
from robodyn.robot import Robot
from robodyn.robot.values import circle_point
from robodyn.thesis.formulations import lagrange as closed
from robodyn.thesis.formulations import lagrange_3x3 as three
from robodyn.thesis.formulations import lagrange_4x4 as four
from robodyn.thesis.formulations.lagrange import lagrange
from robodyn.thesis.formulations.lagrange_3x3 import lagrange_3x3
from robodyn.thesis.formulations.lagrange_4x4 import lagrange_4x4
from robodyn.verify import Reference
from robodyn_testing.random_robots import random_states

FORMULATIONS: tuple[Formulation, ...] = (lagrange, lagrange_4x4, lagrange_3x3)
ARMS = [exact_arm(seed, joints=1 + seed % 4, generic_angles=0.7, prismatic=0.4) for seed in range(200, 216)]

each = pytest.mark.parametrize("formulation", FORMULATIONS, ids=lambda f: f.__name__)


def bundled(name: str) -> Robot:
    return load(name, warn=lambda _: None)


def draft(robot: Robot, formulation: Formulation) -> Program:
    """The program of a formulation, no pass run yet."""
    graph = Graph()
    q, qd, qdd = ([graph.input(name, i) for i in range(robot.n)] for name in ("q", "qd", "qdd"))
    arm = build_arm(robot, exact, graph.input)
    motion = build_motion(arm, q, qd, qdd, lambda angle: turned(graph, q, angle), exact)
    return lower(graph, [("tau", formulation(arm, motion, graph.label))])


# --- the torques ------------------------------------------------------------------------------------------


def test_the_arms_have_both_kinds_of_joints_full_inertias_and_links_without_mass() -> None:
    links = [link for robot in ARMS for link in robot.links]
    kinds = [link.joint.kind for link in links]
    assert min(kinds.count("revolute"), kinds.count("prismatic")) > 10
    assert sum(bool(link.inertia.xy and link.inertia.xz and link.inertia.yz) for link in links) > 10
    assert any(not link.mass for link in links)
    assert any(link.joint.motor_inertia and link.joint.viscous for link in links)
    assert {robot.n for robot in ARMS} == {1, 2, 3, 4}
    assert any(all(robot.gravity) for robot in ARMS)


@each
@pytest.mark.parametrize("robot", ARMS, ids=lambda robot: robot.name)
def test_torques_are_newton_eulers_fractions(robot: Robot, formulation: Formulation) -> None:
    state = State(robot, Point(7))
    motion = state.motion()
    assert formulation(state.arm, motion, unmarked) == newton_euler(state.arm, motion)


@each
@pytest.mark.parametrize("name", ["puma560_3dof", "stanford_3dof", "puma560_full", "stanford_full", "rx90"])
def test_torques_in_double_precision_are_the_references(name: str, formulation: Formulation) -> None:
    robot = bundled(name)
    arm = build_arm(robot, float, lambda _: math.nan)

    def trigonometry(q: Any) -> Callable[[JointAngle], tuple[float, float]]:
        def of(angle: JointAngle) -> tuple[float, float]:
            total = angle.offset.radians + sum(sign * q[joint] for joint, sign in angle.terms)
            return math.cos(total), math.sin(total)

        return of

    states = random_states(robot, 6, seed=5)
    expected = Reference(robot).inverse_dynamics(*states)
    found = []
    for q, qd, qdd in zip(*(x.tolist() for x in states), strict=True):
        found.append(formulation(arm, build_motion(arm, q, qd, qdd, trigonometry(q), float), unmarked))
    assert np.max(np.abs(np.array(found) - expected)) < 1e-10 * np.max(np.abs(expected))


@each
@pytest.mark.parametrize("name", ["puma560_3dof", "stanford_3dof"])
def test_the_customised_program_is_the_kernels_function(name: str, formulation: Formulation) -> None:
    robot = bundled(name)
    kernel = program(robot, "inverse_dynamics", Options())
    own = run(draft(robot, formulation), FRESH)
    assert fingerprint(own, 11, circle_point) == fingerprint(kernel, 11, circle_point)


@each
def test_every_number_of_the_arm_may_be_given_at_run_time(formulation: Formulation) -> None:
    robot = next(arm for arm in ARMS if arm.n == 2 and "prismatic" in {x.joint.kind for x in arm.links})
    named = with_named_numbers(robot)
    state = State(robot, Point(3))
    numbers = {**values_of(named, robot), **state.numbers()}
    found = exactly(draft(named, formulation), Point(3), numbers)["tau"]
    assert found == newton_euler(state.arm, state.motion())


@each
def test_expressions_of_sympy_give_the_same_polynomials(formulation: Formulation) -> None:
    robot = next(arm for arm in ARMS if arm.n == 2)

    def rational(x: Fraction) -> sympy.Rational:
        return sympy.Rational(x.numerator, x.denominator)

    arm = build_arm(robot, rational, sympy.Symbol)
    c, s = sympy.symbols("c:2"), sympy.symbols("s:2")

    def trigonometry(angle: JointAngle) -> tuple[sympy.Expr, sympy.Expr]:
        ((joint, _),) = angle.terms
        cosine, sine = rational(angle.offset.cos), rational(angle.offset.sin)
        return cosine * c[joint] - sine * s[joint], sine * c[joint] + cosine * s[joint]

    q, qd, qdd = (sympy.symbols(f"{array}:2", real=True) for array in ("q", "qd", "qdd"))
    motion = build_motion(arm, q, qd, qdd, trigonometry, rational)
    circle = [c[joint] ** 2 + s[joint] ** 2 - 1 for joint in range(2)]
    for x, y in zip(formulation(arm, motion, unmarked), newton_euler(arm, motion), strict=True):
        difference = sympy.expand(x - y)
        assert difference == 0 or sympy.reduced(difference, circle, *s, *c)[1] == 0


MUTATIONS: list[tuple[ModuleType, str, Any]] = [
    (closed, "joint_operator", lambda body: transforms.TURN_4),
    (closed, "pseudo_inertia", lambda body: with_corner(transforms.pseudo_inertia(body), 2 * body.mass)),
    (four, "pseudo_inertia", lambda body: with_corner(transforms.pseudo_inertia(body), 2 * body.mass)),
    (four, "homogeneous", lambda r: (*r, 0)),
    (three, "second_moment", lambda body: transforms.times(2, transforms.second_moment(body))),
    (three, "outer", lambda u, v: transforms.transposed(transforms.outer(u, v))),
    (three, "TURN_3", transforms.transposed(transforms.TURN_3)),
]


def with_corner(J: transforms.Matrix, corner: Any) -> transforms.Matrix:
    return (*J[:3], (*J[3][:3], corner))


@pytest.mark.parametrize(("module", "name", "wrong"), MUTATIONS)
def test_a_slip_in_the_equations_is_noticed(
    module: ModuleType, name: str, wrong: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot = next(arm for arm in ARMS if arm.n == 3 and "prismatic" in {x.joint.kind for x in arm.links[:2]})
    state = State(robot, Point(7))
    formulation = getattr(module, module.__name__.rpartition(".")[2])
    expected = newton_euler(state.arm, state.motion())
    assert formulation(state.arm, state.motion(), unmarked) == expected
    monkeypatch.setattr(module, name, wrong)
    assert formulation(state.arm, state.motion(), unmarked) != expected


# --- general counts, beside Table 1.1 ---------------------------------------------------------------------

SIZES = range(1, 7)


def pairs(n: int) -> int:
    """Joint i and link p with i <= p."""
    return n * (n + 1) // 2


def triples(n: int) -> int:
    """Joints and link i <= j <= p."""
    return n * (n + 1) * (n + 2) // 6


def quadruples(n: int) -> int:
    """Joints i, j, k and link p, none of the joints beyond it: the sum of p^3."""
    return pairs(n) ** 2


def polynomial(n: int, *coefficients: str) -> Fraction:
    """The value at ``n``, coefficients from the highest power to the constant."""
    value = Fraction(0)
    for coefficient in coefficients:
        value = value * n + Fraction(coefficient)
    return value


@pytest.mark.parametrize("n", SIZES)
def test_table_1_1_of_closed_form_lagrange_is_the_sum_of_its_parts_one_of_them_halved(n: int) -> None:
    """The printed polynomials, part by part: each trace two full 4x4 products (128 and 96 + 3) and a sum, two
    rates with it in D_ijk; n^2 - 2 + sum of i <= j <= p transforms; gravity. The inertial traces are counted
    n (n + 1) (n + 2) / 12 times, half of i <= j <= p: not an integer at n = 1. Of the additions 2 1/6 n are
    left, where 2 n would join the three sums."""
    printed_mul = polynomial(n, "65/2", "1037/12", "685/4", "160/3", "-128")
    printed_add = polynomial(n, "25", "199/3", "259/2", "127/3", "-96")
    halved = Fraction(triples(n), 2)
    products = triples(n) + n * n - 2
    velocity, gravity = quadruples(n), pairs(n)
    assert printed_mul == 130 * velocity + 129 * halved + 64 * products + 21 * gravity
    assert printed_add == 100 * velocity + 100 * halved + 48 * products + 15 * gravity + Fraction(13, 6) * n


@pytest.mark.parametrize("n", SIZES)
def test_general_count_of_closed_form_lagrange(n: int) -> None:
    """Beside the table: two rates for a D_ijk, not for each of its traces; a qdd for a D_ij; inertial traces
    for all i <= j <= p; (n - 1)(n - 2) / 2 transforms fewer; the entries of A (4 n); sums over links."""
    products = 2 * quadruples(n) + 2 * triples(n) + (triples(n) + pairs(n) + n - 3)
    traces = 4 * quadruples(n) + 4 * triples(n) - pairs(n)
    assert general_count(lagrange, n, dense=True) == Count(
        mul=64 * products + 2 * n**3 + n**2 + 21 * pairs(n) + 4 * n,
        add=48 * products + traces + n**2 + 16 * pairs(n) - n,
    )


@pytest.mark.parametrize("n", SIZES)
def test_general_count_of_the_recursion_in_4x4(n: int) -> None:
    """Beside the table (830 n - 592, 675 n - 464): 20 n multiplications and two sums of 4x4 matrices a link
    fewer, which its equations do not explain; 16 and 48 fewer, the zero velocity and acceleration of the
    base. Entries of A (4 n) are counted, m r (4 n) is formed beforehand."""
    assert general_count(lagrange_4x4, n, dense=True) == Count(mul=810 * n - 608, add=643 * n - 512)


@pytest.mark.parametrize("n", SIZES)
def test_general_count_of_the_recursion_in_3x3(n: int) -> None:
    """Beside the table (412 n - 277, 320 n - 201): two sums of 3x3 matrices a link fewer, as in 4x4, and
    3 additions for the masses beyond p in h; 13 n multiplications fewer."""
    assert general_count(lagrange_3x3, n, dense=True) == Count(mul=399 * n - 279, add=305 * n - 231)


def test_zeros_and_ones_of_the_frames_need_no_operations() -> None:
    for formulation in FORMULATIONS:
        for prismatic in ((), (2,), (1, 3)):
            dense = general_count(formulation, 3, prismatic, dense=True)
            assert general_count(formulation, 3, prismatic).total < 0.75 * dense.total


def test_customised_counts_of_the_bundled_arms_do_not_grow() -> None:
    most = {
        "puma560_3dof": (491, 339, 339),
        "stanford_3dof": (334, 154, 154),
    }
    for name, limits in most.items():
        robot = bundled(name)
        found = [count(run(draft(robot, formulation), FRESH)).total for formulation in FORMULATIONS]
        assert all(x <= limit for x, limit in zip(found, limits, strict=True)), (name, found)
