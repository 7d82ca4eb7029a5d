"""That each formulation is what it is called, and costs what its authors or the thesis's Table 1.1 say,
difference by difference."""

from __future__ import annotations

from typing import Any

import pytest

from dynamics.direct import Recorder, State, exact_arm
from ir.programs import Point
from robodyn.counts import Count
from robodyn.counts.general import general_count
from robodyn.dynamics.modified_newton_euler import forward_pass, inertia_moment
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.regroup import lumps_of
from robodyn.dynamics.transforms import IDENTITY_3, product, transposed, turned
from robodyn.dynamics.vectors import unmarked
from robodyn.ir import Label
from robodyn.robot import Robot
from robodyn.thesis.formulations.balafoutis import augmented_links, balafoutis, dual_moment
from robodyn.thesis.formulations.kane import kane
from robodyn.thesis.formulations.lagrange import lagrange
from robodyn.thesis.formulations.lagrange_3x3 import lagrange_3x3
from robodyn.thesis.formulations.lagrange_4x4 import lagrange_4x4
from robodyn.thesis.formulations.newton_euler_base import inertia_in_base, motion_in_base
from robodyn.thesis.formulations.orin import orin
from robodyn.thesis.tables.formulations import pairs, triples

ARMS = [exact_arm(seed, joints=1 + seed % 5, generic_angles=0.6, prismatic=0.35) for seed in range(100, 110)]

every_arm = pytest.mark.parametrize("robot", ARMS[:5], ids=lambda robot: robot.name)


@every_arm
def test_motion_in_the_base_is_that_of_the_links_turned(robot: Robot) -> None:
    """Velocities and accelerations of the recursion in link frames, each turned into the base; ``E I E^T``
    takes ``E u`` to ``E I u``."""
    state = State(robot, Point(6))
    recorder = Recorder()
    newton_euler(state.arm, state.motion(), recorder.mark)

    def in_link(link: int, quantity: str) -> tuple[Any, Any, Any]:
        x, y, z = (recorder.values[Label(link, quantity, axis)][0] for axis in "xyz")
        return x, y, z

    for i, at in enumerate(motion_in_base(state.arm, state.motion(), unmarked), 1):
        assert product(at.E, transposed(at.E)) == IDENTITY_3
        for found, quantity in ((at.w, "w"), (at.alpha, "alpha"), (at.a, "a")):
            assert found == turned(at.E, in_link(i, quantity)), (i, quantity)
        inertia = state.arm.bodies[i - 1].inertia
        for u in ((1, 0, 0), (0, 1, 0), (0, 0, 1), (2, -3, 5)):
            own = turned(at.E, inertia.times(u))
            assert inertia_in_base(at.E, inertia).times(turned(at.E, u)) == own


def test_orins_forces_are_along_the_links() -> None:
    """His forces and moments are those of the recursion in link frames, component by component."""
    state = State(ARMS[4], Point(6))
    book, mixed = Recorder(), Recorder()
    newton_euler(state.arm, state.motion(), book.mark)
    orin(state.arm, state.motion(), mixed.mark)
    for label, values in book.values.items():
        if label.quantity in ("fc", "nc", "f", "n", "w", "alpha", "a", "ac"):
            assert mixed.values[label] == values, str(label)


@every_arm
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


@every_arm
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


# --- what they cost ---------------------------------------------------------------------------------------


def test_a_revolute_joint_more_costs_the_tensor_recursion_93_and_81() -> None:
    """Balafoutis and Patel 1991, algorithm 5.7: 93 n - 108 and 81 n - 100."""
    five, six = (general_count(balafoutis, n) for n in (5, 6))
    assert (six.mul - five.mul, six.add - five.add) == (93, 81)


@pytest.mark.parametrize("n", range(1, 7))
def test_general_counts_of_lagrange(n: int) -> None:
    """Beside the table, the closed form: two rates for a D_ijk, not for each of its traces; a qdd for a D_ij;
    inertial traces for all i <= j <= p; (n - 1)(n - 2) / 2 transforms fewer; the entries of A (4 n); sums
    over links. In 4x4 (830 n - 592, 675 n - 464): 20 n multiplications and two sums of 4x4 matrices a link
    fewer, which its equations do not explain; 16 and 48 fewer, the zero velocity and acceleration of the
    base. In 3x3 (412 n - 277, 320 n - 201): two sums of 3x3 matrices a link fewer and 3 additions for the
    masses beyond p in h; 13 n multiplications fewer."""
    products = 2 * pairs(n) ** 2 + 2 * triples(n) + (triples(n) + pairs(n) + n - 3)
    traces = 4 * pairs(n) ** 2 + 4 * triples(n) - pairs(n)
    assert general_count(lagrange, n, dense=True) == Count(
        mul=64 * products + 2 * n**3 + n**2 + 21 * pairs(n) + 4 * n,
        add=48 * products + traces + n**2 + 16 * pairs(n) - n,
    )
    assert general_count(lagrange_4x4, n, dense=True) == Count(mul=810 * n - 608, add=643 * n - 512)
    assert general_count(lagrange_3x3, n, dense=True) == Count(mul=399 * n - 279, add=305 * n - 231)
