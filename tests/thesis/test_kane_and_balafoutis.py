"""Kane's equations and the tensor recursion: exactly the torques of Newton-Euler, and built as they claim."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics.direct import Recorder, State, exact_arm
from ir.programs import Point, every_value
from robodyn import load, program
from robodyn.counts import Count, count
from robodyn.dynamics.arm import Arm, JointAngle, Motion, build_arm, build_motion
from robodyn.dynamics.modified_newton_euler import forward_pass, inertia_moment
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.regroup import lumps_of
from robodyn.dynamics.vectors import Mark, plus, scaled, unmarked
from robodyn.ir import Graph, Label, Program
from robodyn.ir.fingerprint import fingerprint
from robodyn.ir.lowering import lower
from robodyn.optimize.programs import exact, turned
from robodyn.passes import FRESH, run, units
from robodyn.robot import Inertia, Joint, Link, Robot, bundled_names
from robodyn.robot.values import angle, circle_point
from robodyn.thesis.formulations import balafoutis as balafoutis_module
from robodyn.thesis.formulations import kane as kane_module
from robodyn.thesis.formulations.balafoutis import augmented_links, balafoutis, dual_moment
from robodyn.thesis.formulations.kane import kane
from robodyn.verify import Reference
from robodyn_testing.random_robots import random_states

Formulation = Callable[[Arm, Motion, Mark], list[Any]]
FORMULATIONS: tuple[Formulation, ...] = (kane, balafoutis)
ARMS = [exact_arm(seed, joints=1 + seed % 5, generic_angles=0.6, prismatic=0.35) for seed in range(100, 125)]

both = pytest.mark.parametrize("formulation", FORMULATIONS, ids=lambda f: f.__name__)


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


@both
@pytest.mark.parametrize("robot", ARMS, ids=lambda robot: robot.name)
def test_torques_are_newton_eulers_fractions(robot: Robot, formulation: Formulation) -> None:
    state = State(robot, Point(3))
    motion = state.motion()
    assert formulation(state.arm, motion, unmarked) == newton_euler(state.arm, motion)


def test_the_arms_have_both_kinds_of_joints_full_inertias_and_links_without_mass() -> None:
    links = [link for robot in ARMS for link in robot.links]
    kinds = [link.joint.kind for link in links]
    assert min(kinds.count("revolute"), kinds.count("prismatic")) > 20
    assert sum(bool(link.inertia.xy and link.inertia.xz and link.inertia.yz) for link in links) > 20
    assert any(not link.mass for link in links)
    assert {robot.n for robot in ARMS} == {1, 2, 3, 4, 5}


@both
@settings(deadline=None, max_examples=15)
@given(st.integers(0, 10**6), st.integers(1, 5), st.integers(0, 10**6))
def test_torques_are_newton_eulers_fractions_on_any_arm(
    formulation: Formulation, seed: int, n: int, point: int
) -> None:
    state = State(exact_arm(seed, joints=n), Point(point))
    motion = state.motion()
    assert formulation(state.arm, motion, unmarked) == newton_euler(state.arm, motion)


@both
def test_torques_over_sympy(formulation: Formulation) -> None:
    """A polynomial in symbols for sines, cosines and rates, put to rational numbers."""
    state = State(ARMS[6], Point(5))
    numbers = state.motion()
    names = {
        f"{field}{i}": (field, i) for field in ("c", "s", "d", "qd", "qdd") for i in range(state.robot.n)
    }
    symbols = {name: sympy.Symbol(name) for name in names}
    fields = {
        field: tuple(symbols[f"{field}{i}"] for i in range(state.robot.n)) for field, _ in names.values()
    }
    arm = build_arm(state.robot, lambda x: sympy.Rational(x.numerator, x.denominator), sympy.Symbol)
    values = {symbols[name]: getattr(numbers, field)[i] for name, (field, i) in names.items()}
    torques = formulation(arm, Motion(**fields), unmarked)
    found = [sympy.sympify(torque).subs(values) for torque in torques]
    assert [Fraction(int(x.p), int(x.q)) for x in found] == newton_euler(state.arm, numbers)


@both
@pytest.mark.parametrize("name", bundled_names())
def test_torques_in_double_precision_are_the_references(name: str, formulation: Formulation) -> None:
    robot = bundled(name)
    arm = build_arm(robot, float, lambda _: 0.0)
    states = random_states(robot, 6, 1)
    expected = Reference(robot).inverse_dynamics(*states)
    for q, qd, qdd, torque in zip(*(x.tolist() for x in states), expected, strict=True):

        def cosine_and_sine(angle: JointAngle, q: list[float] = q) -> tuple[float, float]:
            total = sum(sign * q[joint] for joint, sign in angle.terms) + angle.offset.radians
            return math.cos(total), math.sin(total)

        motion = build_motion(arm, q, qd, qdd, cosine_and_sine, float)
        found = np.array(formulation(arm, motion, unmarked))
        assert np.abs(found - torque).max() <= 1e-10 * max(1.0, np.abs(torque).max())


@both
@pytest.mark.parametrize("name", ["puma560", "puma560_full", "stanford", "stanford_3dof", "ur5", "tx40"])
def test_customised_programs_mean_what_the_kernel_means(name: str, formulation: Formulation) -> None:
    robot = bundled(name)
    made = run(draft(robot, formulation), FRESH)
    kernel = program(robot, "inverse_dynamics")
    assert fingerprint(made, 5, circle_point) == fingerprint(kernel, 5, circle_point)
    heavier = replace(robot.links[-1], mass=robot.links[-1].mass + Fraction(1, 1000))
    other = draft(replace(robot, links=(*robot.links[:-1], heavier)), formulation)
    assert fingerprint(other, 5, circle_point) != fingerprint(kernel, 5, circle_point)


@both
@pytest.mark.parametrize("name", ["puma560_3dof", "stanford"])
def test_every_named_value_is_the_quantity_of_that_name(name: str, formulation: Formulation) -> None:
    state = State(bundled(name), Point(4))
    recorder = Recorder()
    formulation(state.arm, state.motion(), recorder.mark)
    made = run(draft(state.robot, formulation), FRESH)
    seen = set()
    for (_, _, label), value in zip(made.operations, every_value(made, state.at), strict=True):
        if label is not None and label.quantity not in ("c", "s"):
            known = recorder.values[label._replace(negative=False)]
            assert (-value if label.negative else value) in known, str(label)
            seen.add(label.quantity)
    # Sums in other units lose their names: those of the formulation are counted without that pass.
    plain = run(draft(state.robot, formulation), [each for each in FRESH if each is not units])
    seen |= {label.quantity for _, _, label in plain.operations if label is not None}
    own = {"pw", "pv", "ao"} if formulation is kane else {"lam", "nc", "fw"}
    assert seen >= own | {"w", "tau"}


# --- that each is what it is called -------------------------------------------------------------------------


@pytest.mark.parametrize("robot", ARMS[:5], ids=lambda robot: robot.name)
def test_partial_velocities_are_the_coefficients_of_the_rates(robot: Robot) -> None:
    """A unit acceleration of one joint adds its partial velocities to the accelerations of every link."""

    def recorded(qdd: list[int]) -> dict[Label, list[Any]]:
        recorder = Recorder()
        state = State(robot, Point(6), qdd=qdd)
        kane(state.arm, state.motion(), recorder.mark)
        return recorder.values

    still = recorded([0] * robot.n)
    for r in range(robot.n):
        moved = recorded([int(i == r) for i in range(robot.n)])
        for partial, acceleration in (("pw", "alpha"), ("pv", "ac")):
            for link in range(r + 1, robot.n + 1):
                for axis in "xyz":
                    (coefficient,) = still[Label(link, partial, f"{r + 1}{axis}")]
                    (more,), (less,) = (v[Label(link, acceleration, axis)] for v in (moved, still))
                    assert coefficient == more - less


@pytest.mark.parametrize("robot", ARMS[:5], ids=lambda robot: robot.name)
def test_the_dual_of_the_skew_tensor_is_eulers_moment(robot: Robot) -> None:
    state = State(robot, Point(7))
    for at, lump in zip(forward_pass(state.arm, state.motion(), unmarked), lumps_of(state.arm), strict=True):
        assert dual_moment(at, lump.second) == inertia_moment(lump.inertia(), at)


def test_augmented_links_are_constant_and_carry_what_lies_beyond() -> None:
    for robot in ARMS:
        here, there = (State(robot, Point(seed)) for seed in (8, 9))
        origins = [
            [at.p for at in forward_pass(state.arm, state.motion(), unmarked)] for state in (here, there)
        ]
        lumps = augmented_links(here.arm, origins[0])
        assert lumps == augmented_links(there.arm, origins[1])
        for i, lump in enumerate(lumps):
            beyond = [link.joint.kind for link in robot.links[i + 1 :]]
            carried = beyond.index("prismatic") if "prismatic" in beyond else len(beyond)
            assert lump.mass == sum(link.mass for link in robot.links[i : i + 1 + carried])


def test_two_links_put_together_by_hand() -> None:
    """2 kg at x = 1 m, and 3 kg on a joint at x = 2 m: 5 kg, 2 + 6 kg m, 2 + 12 kg m^2 along x."""
    first = Link("upper", Joint("revolute", angle(Fraction(0)), Fraction(0), Fraction(0), angle(Fraction(0))))
    second = replace(first, mass=Fraction(3), joint=replace(first.joint, a=Fraction(2)))
    robot = Robot(
        "two", (replace(first, mass=Fraction(2), com=(Fraction(1), Fraction(0), Fraction(0))), second)
    )
    state = State(robot, Point(0))
    lump, _ = augmented_links(state.arm, [(0, 0, 0), (2, 0, 0)])
    assert (lump.mass, lump.first, lump.second.entries()) == (5, (8, 0, 0), (14, 0, 0, 0, 0, 0))


# --- what they cost ---------------------------------------------------------------------------------------


def general_arm(n: int) -> Robot:
    """Revolute joints only, and but for theta no number that is zero, one, or there twice."""
    numbers = iter(Fraction(k, 1009) for k in range(101, 900))
    links = []
    for i in range(n):
        alpha, a, d, mass, *rest = (next(numbers) for _ in range(13))
        joint = Joint("revolute", angle(alpha), a, d, angle(Fraction(0)))
        x, y, z, *entries = rest
        links.append(Link(f"link_{i + 1}", joint, mass, (x, y, z), Inertia(*entries)))
    return Robot("general", tuple(links), gravity=(Fraction(3, 2), Fraction(5, 2), Fraction(-9)))


def counted(n: int, formulation: Formulation) -> Count:
    return count(draft(general_arm(n), formulation))


def test_a_revolute_joint_more_costs_the_tensor_recursion_93_and_81() -> None:
    """Balafoutis and Patel 1991, algorithm 5.7: 93 n - 108 and 81 n - 100; equal nodes save two of each."""
    five, six = (counted(n, balafoutis) for n in (5, 6))
    assert (six.mul - five.mul, six.add - five.add) == (93, 81)
    assert (six.mul, six.add) == (93 * 6 - 110, 81 * 6 - 102)


def test_kanes_equations_grow_with_the_square() -> None:
    counts = [counted(n, kane).total for n in (3, 4, 5, 6)]
    steps = [b - a for a, b in pairwise(counts)]
    assert steps[1] - steps[0] == steps[2] - steps[1] > 0


# --- that slips are noticed ---------------------------------------------------------------------------------


@pytest.mark.parametrize("slip", ["kane: origin", "kane: gravity", "balafoutis: sign", "balafoutis: mass"])
def test_a_slip_is_noticed(slip: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def lighter(arm: Arm, origins: Any) -> Any:
        return lumps_of(arm)

    def turned_about(at: Any, k: Any) -> Any:
        return scaled(-1, dual_moment(at, k))

    def unmoved(partials: Any, body: Any, c: Any, s: Any, p: Any) -> Any:
        return genuine(partials, body, c, s, (0, 0, 0))

    genuine = kane_module.propagated
    if slip == "kane: origin":
        monkeypatch.setattr(kane_module, "propagated", unmoved)
    elif slip == "kane: gravity":
        monkeypatch.setattr(kane_module, "minus", plus)
    elif slip == "balafoutis: sign":
        monkeypatch.setattr(balafoutis_module, "dual_moment", turned_about)
    else:
        monkeypatch.setattr(balafoutis_module, "augmented_links", lighter)
    formulation = kane if slip.startswith("kane") else balafoutis
    for name in ("puma560", "stanford"):
        state = State(bundled(name), Point(2))
        assert formulation(state.arm, state.motion(), unmarked) != newton_euler(state.arm, state.motion())
