"""Closed forms in absolute angles: exactly the plain recursion's torques, and fewer operations."""

from __future__ import annotations

import functools
import random
from dataclasses import replace
from fractions import Fraction

import pytest

from dynamics.direct import exact_arm, with_named_numbers
from records.made import bundled
from robodyn import Options, program
from robodyn.counts import count
from robodyn.dynamics.arm import build_arm, build_motion
from robodyn.dynamics.equality import equals_recursion
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.ir import Graph, Program
from robodyn.ir.fingerprint import fingerprint
from robodyn.ir.lowering import lower
from robodyn.optimize.closed_form import closed_forms, seeds
from robodyn.optimize.closed_form.extraction import Extraction, Memory, Numbers, System, Taste
from robodyn.optimize.closed_form.scales import Scaling
from robodyn.optimize.polynomial import Polynomial, Ring
from robodyn.optimize.programs import exact, turned
from robodyn.passes import FRESH, run
from robodyn.robot import Robot
from robodyn.robot.values import circle_point
from robodyn_testing import representative, sampled

#: Enough for equality; the figures of the documentation take effort 1.
LITTLE = 0.02
ARMS = [exact_arm(seed, joints=2 + seed % 2, generic_angles=0.2, friction=0.7) for seed in range(300, 320)]


@functools.cache
def forms(name: str) -> list[Program]:
    return closed_forms(bundled(name), effort=0.08)


@functools.cache
def forms_of_arm(number: int) -> list[Program]:
    return closed_forms(ARMS[number], effort=LITTLE)


def book(robot: Robot) -> Program:
    """The plain recursion's program."""
    graph = Graph()
    q, qd, qdd = ([graph.input(name, i) for i in range(robot.n)] for name in ("q", "qd", "qdd"))
    arm = build_arm(robot, exact, graph.input)
    motion = build_motion(arm, q, qd, qdd, lambda angle: turned(graph, q, angle), exact)
    return lower(graph, [("tau", newton_euler(arm, motion))])


@pytest.mark.parametrize("number", sampled(sampled(range(len(ARMS)), every=2, rest="slow"), every=6))
def test_torques_are_the_plain_recursions_fractions(number: int) -> None:
    robot, programs = ARMS[number], forms_of_arm(number)
    assert programs
    assert all(equals_recursion(robot, "inverse_dynamics", program) for program in programs)
    assert [seeds.operations(p) for p in programs] == [count(p).total for p in programs]
    assert [count(p).total for p in programs] == sorted(count(p).total for p in programs)


@pytest.mark.parametrize(
    ("name", "most"),
    representative(
        [("puma560_3dof_d3", 66), ("puma560_3dof", 81), ("stanford_3dof_d3", 48), ("stanford_3dof", 51)],
        "puma560_3dof",
        "stanford_3dof_d3",
    ),
)
def test_bundled_arms_take_few_operations_and_several_programs_are_offered(name: str, most: int) -> None:
    programs = forms(name)
    assert count(programs[0]).total <= most
    assert len(programs) >= 4
    assert all(equals_recursion(bundled(name), "inverse_dynamics", program) for program in programs)
    assert count(programs[0]).sincos <= 2 * sum(x.joint.kind == "revolute" for x in bundled(name).links)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "most"),
    [("puma560_3dof_d3", 65), ("puma560_3dof", 77), ("stanford_3dof_d3", 46), ("stanford_3dof", 48)],
)
def test_a_whole_search_takes_fewer(name: str, most: int) -> None:
    assert count(closed_forms(bundled(name))[0]).total <= most


@pytest.mark.thorough
def test_it_is_below_the_recursion_on_most_arms() -> None:
    better = 0
    for number, robot in enumerate(ARMS):
        fast = count(program(robot, "inverse_dynamics", Options())).total
        better += count(forms_of_arm(number)[0]).total < fast
    assert better >= 17


def test_equal_arguments_give_equal_programs() -> None:
    robot = bundled("stanford_3dof")
    once, again = (closed_forms(robot, effort=0.02, seed=3) for _ in range(2))
    assert once == again
    assert count(run(once[0], FRESH)).total <= count(once[0]).total
    assert closed_forms(bundled("puma560_d2")) == []  # long arms are left to recursions


def test_smoothed_friction_and_run_time_numbers() -> None:
    smooth = replace(ARMS[0], rest_velocity=Fraction(1, 50))
    links = tuple(replace(x, joint=replace(x.joint, coulomb=Fraction(3, 2))) for x in smooth.links)
    smooth = replace(smooth, links=links)
    named = with_named_numbers(next(arm for arm in ARMS if arm.n == 2))
    for robot in (smooth, named):
        expected = fingerprint(book(robot), 5, circle_point)
        for found in closed_forms(robot, effort=LITTLE):
            assert fingerprint(found, 5, circle_point) == expected


# --- the parts --------------------------------------------------------------------------------------------


def test_squares_of_sines_are_none() -> None:
    c, s = (Polynomial(Ring({1: 0}), {(v,): 1}) for v in (0, 1))
    assert c * c + s * s == 1
    assert (s * s * s).terms == {(1,): 1, (0, 0, 1): -1}
    assert s - s == 0
    assert (2 * (s + 1) - 2).terms == {(1,): 2}


def system(*polynomials: dict[tuple[int, ...], int], leaves: int) -> System:
    numbered = dict(enumerate(polynomials, leaves))
    return System(leaves, numbered, tuple(numbered))


def test_common_factors_are_found() -> None:
    """a c + b c, 3 a d + 3 b d: one sum, two products, one constant."""
    numbers = Numbers()
    three = numbers.number(3)
    a, b, c, d = range(4)
    start = system({(a, c): 1, (b, c): 1}, {(a, d): three, (b, d): three}, leaves=4)
    found = Extraction(start, Taste(), random.Random(1), Memory(start, numbers)).run()
    assert found.cost() == 4


def test_constants_are_scaled_away() -> None:
    """x = 3 a b + 3 c, y = x d / 3: with x / 3 in the place of x no constant is left."""
    numbers = Numbers()
    three, third = numbers.number(3), numbers.number(Fraction(1, 3))
    start = System(4, {4: {(0, 1): three, (2,): three}, 5: {(3, 4): third}}, (5,))
    scaling = Scaling.of(start, numbers)
    scaling.improve(random.Random(1), 30)
    assert scaling.cost == 3
    assert scaling.scales() == {4: Fraction(1, 3)}
