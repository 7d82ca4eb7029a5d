"""Every formulation variant gives what the plain recursion gives, and costs what is counted."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics.direct import NO_SHRINKING, exact_arm, values_of, with_named_numbers
from ir.programs import Point, exactly
from records.made import bundled
from robodyn import InputError
from robodyn.counts import count
from robodyn.dynamics.equality import equals_recursion
from robodyn.dynamics.lump import Lump
from robodyn.ir import Program
from robodyn.optimize.costing import Costing
from robodyn.optimize.fast import suited_variant
from robodyn.optimize.gauge import Unsuited, regrouped_as
from robodyn.optimize.programs import Choice, build
from robodyn.optimize.variant import LinkVariant, Variant
from robodyn.robot import Robot
from robodyn.search.space import Candidates, Space
from robodyn_testing import sampled
from robodyn_testing.functions import OF_ANY_ARM

pytestmark = pytest.mark.thorough  # whole searches: CI runs them


def suited(robot: Robot, seed: int, steps: int) -> Variant:
    """A variant that suits ``robot``, so many changes away from the plain one."""
    space, candidates, rng = Space(robot), Candidates(robot), random.Random(seed)
    variant = space.fitted(suited_variant(space.arm))
    for _ in range(steps):
        other = space.random_neighbour(variant, rng)
        if candidates.cost(other) is not None:
            variant = other
    return variant


def counted(robot: Robot, variant: Variant, made: Program) -> bool:
    """Whether ``made`` costs what the tally says, or less: written out in another order a sum may fold."""
    return 0 <= Costing(robot).total(variant) - count(made).total <= 4


@settings(deadline=None, max_examples=25, phases=NO_SHRINKING)
@given(st.integers(0, 10**6), st.integers(1, 7), st.integers(1, 60), st.booleans(), st.booleans())
def test_any_writing_of_any_arm(seed: int, n: int, steps: int, full: bool, simple: bool) -> None:
    more: dict[str, Any] = {"generic_angles": 0, "zeros": 0.6, "parallel": 0.5} if simple else {}
    robot = exact_arm(seed, joints=n, full=full, **more)
    variant = suited(robot, seed, steps)
    choice = Choice(variant=variant)
    made = build(robot, "inverse_dynamics", choice)
    assert equals_recursion(robot, "inverse_dynamics", made, points=1), choice
    assert counted(robot, variant, made), choice
    revolute = sum(link.joint.kind == "revolute" for link in robot.links)
    assert count(made).sincos <= 2 * revolute


@pytest.mark.parametrize("function", sampled(OF_ANY_ARM, every=4, rest="slow"))
def test_writings_of_every_function(function: str) -> None:
    for seed in (3, 4):
        robot = replace(exact_arm(seed, joints=4, motors=1), torque_side="motor")
        made = build(robot, function, Choice(variant=suited(robot, seed, 40)))
        assert equals_recursion(robot, function, made, points=1)


@settings(deadline=None, max_examples=6, phases=NO_SHRINKING)
@given(st.integers(0, 10**6), st.integers(1, 4), st.integers(0, 7))
def test_writings_with_numbers_that_are_known_at_run_time(seed: int, n: int, which: int) -> None:
    """What would divide by a name or ask whether it is zero is not offered; the rest is right."""
    robot = exact_arm(seed, joints=n)
    named = with_named_numbers(robot, lambda name: sum(map(ord, name)) % 8 <= which)
    variant = suited(named, seed, 30)
    made = build(named, "inverse_dynamics", Choice(variant=variant))
    at, numbers = Point(seed), values_of(named, robot)
    plain = build(robot, "inverse_dynamics", Choice("newton_euler", regroup=False, chains=False))
    assert exactly(made, at, numbers) == exactly(plain, at)
    assert counted(named, variant, made)


def test_slides_spins_and_units_of_length_are_worth_something() -> None:
    robot = bundled("puma560_d2")
    costing = Costing(robot)
    plain = suited_variant(costing.arm)
    slid = plain.with_link(
        1, slide="own"
    )  # what `fast` does: the second origin on the first axis, the tip a spin
    assert costing.total(slid) <= costing.total(plain) - 9
    assert costing.total(slid.with_link(5, second="-xx", form="spin", frame="start")) <= 270
    for unit in ("a", "d"):
        variant = replace(plain, unit=unit, unit_link=4)
        made = build(robot, "inverse_dynamics", Choice(variant=variant))
        assert equals_recursion(robot, "inverse_dynamics", made, points=1)
        assert costing.total(variant) < costing.total(plain)


RULES: list[tuple[int, dict[str, str], Callable[[Lump, Lump], Any]]] = [
    (2, {"second": "xx"}, lambda own, parent: own.second.zz - own.second.xx),
    (2, {"second": "-yy"}, lambda own, parent: own.second.zz + own.second.yy),
    (3, {"second": "parent_zero"}, lambda own, parent: parent.second.yy),
    (3, {"second": "parent_xx"}, lambda own, parent: parent.second.yy - parent.second.xx),
    (3, {"second": "parent_-xx"}, lambda own, parent: parent.second.yy + parent.second.xx),
    (3, {"first": "parent_first"}, lambda own, parent: parent.first[1]),
    (3, {"mass": "parent_first"}, lambda own, parent: parent.first[0]),
    (3, {"mass": "parent_second"}, lambda own, parent: parent.second.xx),
    (2, {"first": "keep", "slide": "com", "mass": "keep"}, lambda own, parent: own.first[2]),
    (2, {"slide": "xz"}, lambda own, parent: own.second.xz),
    (2, {"slide": "yz"}, lambda own, parent: own.second.yz),
    (2, {}, lambda own, parent: own.mass or own.first[2] or own.second.zz),
]


@pytest.mark.parametrize(
    ("link", "rules", "left"), RULES, ids=[f"{link}-{rules}" for link, rules, _ in RULES]
)
def test_rules_do_what_they_say(link: int, rules: dict[str, str], left: Callable[[Lump, Lump], Any]) -> None:
    """What a rule makes zero is zero, and was not before."""
    arm = Space(bundled("puma560_full")).arm
    plain = Variant((LinkVariant(),) * 6)
    before, _ = regrouped_as(arm, Variant((LinkVariant(), *(LinkVariant("keep", "keep", "keep"),) * 5)))
    after, _ = regrouped_as(arm, plain.with_link(link, **rules))
    assert left(before[link].lump, before[link - 1].lump) != 0
    assert left(after[link].lump, after[link - 1].lump) == 0


# --- what does not suit -----------------------------------------------------------------------------------


def test_a_writing_of_another_arm_is_refused() -> None:
    robot = bundled("puma560_3dof_d3")
    plain = suited_variant(Space(robot).arm)
    for variant, said in (
        (Variant(plain.links[:2]), "a variant of another arm; found 2 links; expected 3"),
        (plain.with_link(2, form="spin"), "does not suit link 3"),
        (plain.with_link(2, form="wrist", frame="start"), "does not suit link 3"),
        (plain.with_link(2, frame="before"), "does not suit link 3"),
        (plain.with_link(2, second="parent_xx"), "does not suit link 3; found an axis parallel"),
        (plain.with_link(0, mass="keep"), "does not suit link 1; found a base that takes everything"),
        (replace(plain, unit="a", unit_link=1), "does not suit link 1; found no length"),
    ):
        with pytest.raises(InputError, match=said):
            build(robot, "inverse_dynamics", Choice(variant=variant))
        if len(variant.links) == 3:
            assert Candidates(robot).cost(variant) is None


def test_a_prismatic_link_gives_up_its_second_moment_only() -> None:
    robot = bundled("stanford_3dof_d3")
    plain = suited_variant(Space(robot).arm)
    for changes in ({"mass": "keep"}, {"first": "keep"}, {"second": "xx"}):
        with pytest.raises(Unsuited, match="a prismatic joint"):
            build(robot, "inverse_dynamics", Choice(variant=plain.with_link(2, **changes)))
    kept = build(robot, "inverse_dynamics", Choice(variant=plain.with_link(2, second="keep")))
    assert equals_recursion(robot, "inverse_dynamics", kept, points=1)
