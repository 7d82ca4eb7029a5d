"""Three formulations, on fractions and as programs: exactly the same torques."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics.direct import NO_SHRINKING, Recorder, State, exact_arm
from ir.programs import Point, every_value
from robodyn import load, program
from robodyn.dynamics.arm import Symmetric
from robodyn.dynamics.functions import function_named
from robodyn.dynamics.lump import Lump, MomentForm
from robodyn.dynamics.modified_newton_euler import modified_newton_euler
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.regroup import about_axis_x, moved_into, regrouped, shifted
from robodyn.errors import InputError
from robodyn.ir import Input
from robodyn.ir.evaluate import angle_form, evaluate_exact
from robodyn.optimize.fast import slid
from robodyn.optimize.programs import Choice, build, signature
from robodyn.optimize.variant import LinkVariant, Variant
from robodyn.passes import FRESH, run, units
from robodyn.robot import Robot
from robodyn.robot.values import circle_point
from robodyn.verify.exact import exact_torque
from robodyn_testing import covering, sampled
from robodyn_testing.functions import OF_ANY_ARM

ARMS = [exact_arm(seed, joints=1 + seed % 9) for seed in range(14)]
FORMS: tuple[MomentForm, ...] = ("inertia", "second_moment")
CHOICES = {
    "newton_euler": Choice("newton_euler", regroup=False, chains=False),
    "modified": Choice(regroup=False, chains=False),
    "base": Choice(chains=False),
    "base-chains": Choice(),
}


def ids(robot: Robot) -> str:
    return robot.name


# --- on fractions -----------------------------------------------------------------------------------------


@settings(deadline=None, max_examples=10, phases=NO_SHRINKING)
@given(st.integers(0, 10**6), st.integers(1, 6), st.integers(0, 10**6), st.booleans(), st.data())
def test_three_recursions_give_the_same_fractions(
    seed: int, n: int, point: int, parallel: bool, data: st.DataObject
) -> None:
    """Whatever form each link's moment is written in, in whatever frames, with chains or without."""
    state = State(exact_arm(seed, joints=n, parallel=0.8 if parallel else 0.35), Point(point))
    motion = state.motion()
    expected = newton_euler(state.arm, motion)
    assert modified_newton_euler(state.arm, motion) == expected
    other = slid(state.arm)
    assert newton_euler(other, state.motion(other)) == expected
    for choice in CHOICES.values():
        assert state.outputs("inverse_dynamics", choice) == expected
    forms = tuple(data.draw(st.lists(st.sampled_from(FORMS), min_size=n, max_size=n)))
    for chains in (False, True):
        for arm in (state.arm, other):
            links = [LinkVariant(form=form, column="carried", chained=chains) for form in forms]
            found = state.outputs("inverse_dynamics", Choice(variant=Variant(tuple(links))), arm=arm)
            assert found == expected


@pytest.mark.parametrize("robot", ARMS[3:8], ids=ids)
def test_torques_are_those_of_virtual_work(robot: Robot) -> None:
    """The oracle shares no equation with the recursions; its sines are right to 1e-30."""
    state = State(robot, Point(2))
    q = [Fraction(k, 7) for k in range(1, robot.n + 1)]
    numbers = state.numbers() | {Input("q", i): x for i, x in enumerate(q)}
    points = {Input("q", i): circle_point(x) for i, x in enumerate(q)}
    found = evaluate_exact(program(robot, "inverse_dynamics"), numbers, points, circle_point)["tau"]
    expected = exact_torque(robot, q, state.given["qd"], state.given["qdd"])
    largest = max(map(abs, expected))
    assert largest > 0
    assert all(abs(x - y) < Fraction(1, 10**24) * largest for x, y in zip(found, expected, strict=True))


# --- regrouping, and other frames -------------------------------------------------------------------------


def test_regrouping_leaves_nothing_that_could_move() -> None:
    """A revolute link keeps no mass, no first moment along its axis and one inertia less."""
    for robot in ARMS:
        arm = State(robot, Point(0)).arm
        for form in FORMS:
            lumps = regrouped(arm, [form] * robot.n)
            for body, lump in zip(arm.bodies, lumps, strict=True):
                k = lump.second
                if body.revolute:
                    assert (lump.mass, lump.first[2]) == (0, 0)
                    assert (k.zz if form == "second_moment" else lump.inertia().yy) == 0
                else:
                    assert k.entries() == (0,) * 6


@pytest.mark.parametrize("seed", range(12))
def test_moments_moved_in_whole_numbers_are_those_in_fractions(seed: int) -> None:
    chance = random.Random(seed)
    m, x, y, z, *second, p0, p1, p2 = (
        chance.choice(
            (0, chance.randrange(-3, 4), Fraction(chance.randrange(-99, 99), chance.randrange(1, 999)))
        )
        for _ in range(13)
    )
    lump = Lump(m, (x, y, z), Symmetric(*second))
    c, s = circle_point(Fraction(chance.randrange(9), chance.randrange(1, 9)))
    expected = shifted(about_axis_x(lump, c, s), (p0, p1, p2))
    assert moved_into(lump, c, s, (p0, p1, p2)) == expected


def test_parallel_axes_need_one_offset() -> None:
    """The elbow of the PUMA 560: what lies between its second and third axis moves to the second."""
    before = State(bundled("puma560_d2"), Point(0)).arm
    after = slid(before)
    assert [body.d for body in before.bodies[1:3]] == [Fraction("0.2435"), Fraction("-0.0934")]
    assert [body.d for body in after.bodies[1:3]] == [Fraction("0.1501"), 0]
    assert after.bodies[1].com[2] == before.bodies[1].com[2] + Fraction("0.0934")
    assert after.bodies[3:] == before.bodies[3:]


# --- as programs ------------------------------------------------------------------------------------------


def bundled(name: str) -> Robot:
    return load(name, warn=lambda _: None)


@pytest.mark.parametrize(("choice", "function"), sampled(covering(CHOICES, OF_ANY_ARM), every=5))
def test_every_named_value_is_the_quantity_of_that_name(choice: str, function: str) -> None:
    """``w3_x`` in the emitted code is the x component of link 3's angular velocity, with its sign.

    The recursion runs directly on fractions and notes what it names. A name may come more than once (a
    row of the mass matrix), and quantities that nothing needs are missing in the program.
    """
    robots = [ARMS[5], bundled("stanford_3dof")]
    for robot in robots:
        state = State(robot, Point(4))
        recorder = Recorder()
        regrouped_arm = CHOICES[choice].regroup and not function_named(function).geometric
        arm = slid(state.arm) if regrouped_arm else state.arm
        state.outputs(function, CHOICES[choice], recorder.mark, arm)
        if "wrench" in function or "reactions" in function:  # along the axes of the description
            state.outputs(function, CHOICES[choice], recorder.mark)
        drafted = build(robot, function, CHOICES[choice])
        plain = run(drafted, [each for each in FRESH if each is not units])
        for made in (run(drafted, FRESH), plain):
            for (_, _, label), value in zip(made.operations, every_value(made, state.at), strict=True):
                if label is not None and label.quantity.rstrip("0123456789") not in ("c", "s", "angle"):
                    known = recorder.values[label._replace(negative=False)]
                    assert (-value if label.negative else value) in known, (robot.name, str(label))
        # Sums in other units lose their names: without that pass there are as many as links, or more.
        labels = [label for _, _, label in plain.operations if label is not None]
        named = sum(label.quantity.rstrip("0123456789") not in ("c", "s", "angle") for label in labels)
        assert named >= (robot.n - 1 if len(plain.operations) > 20 else 1)


def test_sines_and_cosines_are_called_by_their_joints() -> None:
    """``c23`` is the cosine of q2 + q3; of a longer chain ``c2to4``."""
    seen = set()
    for name in ("puma560", "ur5", "stanford"):
        made = program(bundled(name), "inverse_dynamics")
        for op, args, label in made.operations:
            if op in ("sin", "cos"):
                assert label is not None
                terms, _ = angle_form(made, args[0])
                first, *_, last = [f"{x.index + 1}" for x, _ in terms] * 2  # type: ignore[operator]
                joints = {1: first, 2: first + last}.get(len(terms), f"{first}to{last}")
                assert str(label) == op[0] + joints
                seen.add(str(label))
    assert seen >= {"c2", "c23", "s2to4", "s6"}


def test_a_formulation_or_function_must_be_known() -> None:
    robot = ARMS[0]
    with pytest.raises(InputError, match="unknown formulation 'khalil'"):
        build(robot, "inverse_dynamics", Choice(formulation="khalil"))
    with pytest.raises(InputError, match="unknown function 'inverse'"):
        signature(robot, "inverse")
