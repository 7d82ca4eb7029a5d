"""Inverse kinematics by iteration: of arms of no class from a reference, of arms that are nearly of a class
from its branches.

A description that has 1.5708 for a quarter turn, or was calibrated, has axes that miss each other by some
micrometres. Where they would be without that, parallel and meeting, is where its branches begin; what was
neglected is made up for by steps towards the pose.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm
from robodyn.dynamics.inverse.closed_form import Inverse, has_exact_lengths, inverse_of
from robodyn.dynamics.inverse.descent import Descent, State
from robodyn.dynamics.inverse.limits import (
    ALMOST,
    ASIDE,
    BEGUN,
    EDGE,
    FULL_RANK,
    ITERATIONS,
    REFINEMENTS,
    TOLERANCE,
)
from robodyn.dynamics.inverse.screws import Axis, Chain, as_floats, chain_of, feet, least_motion, only_places
from robodyn.dynamics.inverse.solution import Joint, Nearest, Solved, joints_of, nearest
from robodyn.dynamics.inverse.subproblems import real_root
from robodyn.dynamics.state import Dynamics, Iterative, NoSuchFunction
from robodyn.dynamics.vectors import Vector, dot, minus, scaled

_WEAK = (
    "there is a direction in which its joints move the tool only because axes do not meet, or are not "
    "parallel: few poses are within reach, and those only from a reference very near them"
)
#: Digits behind the point of what is moved [m].
_DIGITS = 15


@dataclass(frozen=True, slots=True)
class Numerical:
    """Inverse kinematics of an arm by damped least squares, see :mod:`~robodyn.dynamics.inverse.descent`.

    ``size``: about the arm's reach [m]. ``conditions``: why it is solved so. ``place_only``: whether the
    tool may be turned anyhow. ``begins``: the inverse
    kinematics of a similar arm, at whose branches it begins; None: it has one solution, near the reference
    that it begins at, within the joints' limits. ``most``: iterations at most, from each beginning.
    ``weak``: whether the joints move the tool in some direction only because axes miss where they have to
    meet or be parallel: then steps lead to a pose from a reference only that is very near.
    """

    joints: tuple[Joint, ...]
    size: Fraction
    conditions: tuple[str, ...]
    place_only: bool
    begins: Inverse | None = None
    most: int = ITERATIONS
    weak: bool = False

    @property
    def branch_names(self) -> tuple[str, ...]:
        """Names of the solutions."""
        return ("numerical",) if self.begins is None else self.begins.branch_names

    @property
    def branches(self) -> int:
        """How many solutions there are at most."""
        return len(self.branch_names)

    @property
    def redundant(self) -> int | None:
        """The joint (from 0) that takes its position from the reference."""
        return None if self.begins is None else self.begins.redundant

    @property
    def alone(self) -> bool:
        """Whether there is but one solution, from the reference."""
        return self.begins is None

    def approach(self, finish: Callable[[Dynamics, Solved], Sequence[Any]]) -> Iterative:
        """How a function of what was reached is approached."""

        def start(at: Dynamics) -> Sequence[Any]:
            q_near, descent = at.inputs["q_near"], self._descent(at)
            if self.begins is None:
                return descent.start(q_near).flat()
            begun = self.begins.solve(at.inputs["T"], q_near, at.rounding)
            states: list[Any] = []
            for q, singular, signs in zip(begun.solutions, begun.singular, self.begins.signs, strict=True):
                aside = list(q)  # a little, where a branch meets another: no step leads away from there
                for k, sign in signs:
                    length = 1 if self.joints[k].revolute else self.size
                    aside[k] = q[k] + sign * ASIDE * length * singular
                states += descent.start(aside, within=BEGUN).flat()
            return states

        def step(at: Dynamics) -> Sequence[Any]:
            return self._descent(at).step(at, at.inputs["T"], State.of(at.inputs["x"])).flat()

        def results(at: Dynamics) -> Sequence[Any]:
            x = at.inputs["x"]
            size = len(x) // self.branches
            states = [State.of(x[k : k + size]) for k in range(0, len(x), size)]
            return finish(at, self._descent(at).finish(states, self.joints))

        return Iterative(start, step, results, self.most, self.branches)

    def nearest(self, solved: Solved, q_near: Sequence[Any], unit: Fraction) -> Nearest:
        """Of what was reached the nearest to ``q_near`` [n]."""
        return nearest(solved, self.joints, q_near, EDGE * unit)

    def _descent(self, at: Dynamics) -> Descent:
        if self.begins is None:
            return Descent(self.joints, self.size, at.rounding, self.place_only)
        # Branches are those of the arm without limits, which only say whether each is within them.
        free = tuple(replace(joint, limits=None) for joint in self.joints)
        locked = frozenset(() if self.redundant is None else (self.redundant,))
        return Descent(free, self.size, at.rounding, self.place_only, locked)


def solver_of(arm: Arm) -> Inverse | Numerical:
    """The inverse kinematics of ``arm``, its numbers exact: in closed form where it is of a class that has
    one, else by iteration, from the branches of such an arm where it is nearly one.

    Raises
    ------
    NoSuchFunction: a length is a run-time parameter.
    """
    limits = [body.limits for body in arm.bodies]
    try:
        return inverse_of(arm, limits)
    except NoSuchFunction as none:
        if not has_exact_lengths(arm):
            raise
        reason = none.found or none.what
    chain, joints = chain_of(arm), joints_of(arm, limits)
    # The sum of all offsets is about twice the reach: they are along three axes, and those at base and tool
    # are levers of nothing.
    size = chain.size / 2
    similar, neglected = idealised(chain)
    place_only = only_places(as_floats(similar, chain.size))
    try:
        begins = inverse_of(arm, limits, similar)
    except NoSuchFunction:
        motion, without = (least_motion(as_floats(x, chain.size), place_only) for x in (chain, similar))
        if motion > TOLERANCE and without <= FULL_RANK:
            return Numerical(joints, size, (reason, _WEAK, *neglected), place_only, weak=True)
        return Numerical(joints, size, (reason,), place_only)
    return Numerical(joints, size, (*begins.conditions, *neglected), place_only, begins, REFINEMENTS)


def idealised(chain: Chain) -> tuple[Chain, tuple[str, ...]]:
    """``chain``, of exact numbers, with axes parallel that are to within :data:`ALMOST`, and meeting those
    before them that they miss by no more than that as a share of its size; and what was neglected, a
    sentence each, the most of each kind."""
    size = float(chain.size)
    axes: list[Axis] = []
    turned = missed = 0.0
    meeting: Vector | None = None
    for axis in chain.axes:
        moved = replace(axis, direction=_idealised_direction(axis.direction, axes))
        turned = max(turned, axis.slope(moved))
        point = _idealised_meeting(axes[-1], moved, meeting, ALMOST * size) if axes else None
        if point is not None:
            missed = max(missed, moved.distance(point))
            moved = replace(moved, point=point)
        axes.append(moved)
        meeting = point
    neglected = []
    if turned > TOLERANCE:
        neglected.append(f"axes are up to {turned:.1e} rad from where that holds")
    if missed > TOLERANCE * size:
        neglected.append(f"axes miss each other by up to {1000 * missed:.2g} mm where they have to meet")
    return replace(chain, axes=tuple(axes)), tuple(neglected)


def _idealised_direction(direction: Vector, before: Sequence[Axis]) -> Vector:
    """``direction``, or that of an axis before it that is nearly parallel; what is nearly 0 of it is 0."""
    for axis in before:
        along = dot(axis.direction, direction)
        aside = minus(direction, scaled(along, axis.direction))
        if float(dot(aside, aside)) <= ALMOST**2:
            return scaled(1 if along > 0 else -1, axis.direction)
    x, y, z = (Fraction(0) if abs(u) <= ALMOST else u for u in direction)
    if (x, y, z) == direction:
        return direction
    length = real_root(x * x + y * y + z * z)
    return x / length, y / length, z / length


def _idealised_meeting(before: Axis, axis: Axis, meeting: Vector | None, near: float) -> Vector | None:
    """Where ``axis`` nearly meets the one ``before`` it [m], if it does: best where that meets its own."""
    if before.is_along(axis):
        return None
    if meeting is not None and axis.distance(meeting) <= near:
        return meeting
    foot, _ = feet(before, axis)
    if axis.distance(foot) > near:
        return None
    x, y, z = (Fraction(round(u, _DIGITS)) for u in foot)
    # Rounded along the axis before, so that it stays on it.
    return before.nearest((x, y, z))
