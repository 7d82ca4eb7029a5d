"""From branches to joint positions: angles, the turn that suits the limits, flags, the branch nearest to a
reference."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm
from robodyn.dynamics.inverse.branch import Branch, Sum
from robodyn.dynamics.inverse.screws import Circle, opposite, sum_of
from robodyn.dynamics.inverse.subproblems import both
from robodyn.effects.scalars import arctangent, choose, magnitude
from robodyn.robot.values import PI

#: Lowest and highest position of a joint [rad or m]; None: it has no limits.
Limits = tuple[Fraction, Fraction] | None


@dataclass(frozen=True, slots=True)
class Joint:
    """What of a joint its positions need: the angle that its Denavit-Hartenberg row adds, as a circle; limits
    [rad or m]."""

    revolute: bool
    offset: Circle
    limits: Limits

    @property
    def middle(self) -> Fraction:
        """About where solutions are, within half a turn: the middle of the limits."""
        return (self.limits[0] + self.limits[1]) / 2 if self.limits else Fraction(0)

    def turned_near_middle(self, angle: Any, turns: int = 1) -> Any:
        """``angle``, within so many turns, within half a turn of the middle."""
        whole = round(self.middle / (2 * PI))
        middle = self.middle - 2 * PI * whole
        for _ in range(turns):
            if middle > 0 or turns > 1:
                angle = choose(middle - PI - angle, angle + 2 * PI, angle)
            if middle < 0 or turns > 1:
                angle = choose(angle - (middle + PI), angle - 2 * PI, angle)
        return angle + 2 * PI * whole if whole else angle

    def allows(self, position: Any, rounding: Fraction) -> Any:
        """1 where ``position`` is within the limits, or beyond them by rounding; else 0."""
        if self.limits is None:
            return 1
        low, high = self.limits
        if self.revolute and high - low >= 2 * PI:
            return 1
        return both(choose(high + rounding - position, 1, 0), choose(position - (low - rounding), 1, 0))

    def clamped(self, position: Any) -> Any:
        """``position``, or the nearest that the limits allow."""
        if self.limits is None:
            return position
        low, high = self.limits
        return choose(low - position, low, choose(position - high, high, position))


def joints_of(arm: Arm, limits: Sequence[Limits]) -> tuple[Joint, ...]:
    """The joints [n] of ``arm``, with position ``limits`` [n]."""
    return tuple(
        Joint(body.revolute, (body.theta.cos, body.theta.sin), each)
        for body, each in zip(arm.bodies, limits, strict=True)
    )


def places_only(joints: Sequence[Joint]) -> bool:
    """Whether only the place of the tool is solved for, however it is turned: three joints do no more."""
    return len(joints) <= 3


@dataclass(frozen=True, slots=True)
class Solved:
    """Joint positions [b][n] (rad or m), and by branch [b] what is true of them, 1 or 0."""

    solutions: list[list[Any]]
    exists: list[Any]
    within: list[Any]
    singular: list[Any]

    @property
    def count(self) -> Any:
        """How many branches exist."""
        total = self.exists[0]
        for each in self.exists[1:]:
            total = total + each
        return total


class Angles:
    """Arctangents, each taken once: that of the opposite point of the circle is half a turn away."""

    def __init__(self) -> None:
        self._known: dict[Any, Any] = {}

    def of(self, circle: Circle) -> Any:
        """The angle [rad] of ``circle``, within half a turn of 0."""
        c, s = circle
        known = self._known.get((-c, -s))
        if known is not None:
            return choose(known, known - PI, known + PI)
        if (c, -s) in self._known:
            return -self._known[c, -s]
        if (c, s) not in self._known:
            self._known[c, s] = arctangent(s, c)
        return self._known[c, s]


def solved(
    branches: Sequence[Branch], joints: Sequence[Joint], fixed: Mapping[int, Any], rounding: Fraction
) -> Solved:
    """The positions of ``branches``; ``fixed`` are those of joints that no branch decides."""
    angles = Angles()
    result = Solved([], [], [], [])
    for branch in branches:
        q: list[Any] = [None] * len(joints)
        late = []
        for k, joint in enumerate(joints):
            position = fixed[k] if k in fixed else branch.positions[k]
            if isinstance(position, Sum):
                late.append(k)
            elif joint.revolute and k not in fixed:
                own = angles.of(sum_of(position, opposite(joint.offset)))
                q[k] = joint.turned_near_middle(own)
            else:
                q[k] = position
        for k in late:
            position = branch.positions[k]
            total = sum_of(position.angle, opposite(joints[k].offset))
            for other, sense in position.minus:
                offset = joints[other].offset
                total = sum_of(total, opposite(offset) if sense > 0 else offset)
            angle = angles.of(total)
            for other, sense in position.minus:
                angle = angle - q[other] if sense > 0 else angle + q[other]
            q[k] = joints[k].turned_near_middle(angle, 1 + len(position.minus))
        result.solutions.append(q)
        result.exists.append(branch.exists)
        result.within.append(both(*(j.allows(x, rounding) for j, x in zip(joints, q, strict=True))))
        result.singular.append(branch.singular)
    return result


@dataclass(frozen=True, slots=True)
class Nearest:
    """The branch nearest to a reference: positions [n], what is true of them, and its place from 0."""

    solution: list[Any]
    exists: Any
    within: Any
    singular: Any
    branch: Any


def nearest(solved: Solved, joints: Sequence[Joint], near: Sequence[Any], rounding: Fraction) -> Nearest:
    """Of the branches that exist, and of these of the ones within the limits, that with the smallest sum of
    squares of what is between it and ``near`` [n] (rad, m), in the turns nearest to that which limits allow;
    the nearest of all where none exists."""
    best: Nearest | None = None
    least: Any = None
    for k, q in enumerate(solved.solutions):
        turned = [_turned(joint, x, y, rounding) for joint, x, y in zip(joints, q, near, strict=True)]
        total: Any = 0
        for x, y in zip(turned, near, strict=True):
            total = total + (x - y) * (x - y)
        # 0 for what exists and is within limits, 1 for what only exists, 2 or 3 for the rest
        rank = 3 - solved.within[k] - 2 * solved.exists[k]
        each = Nearest(turned, solved.exists[k], solved.within[k], solved.singular[k], Fraction(k))
        if best is None:
            best, least = each, (rank, total)
            continue
        better = choose(least[0] - rank, 1, choose(rank - least[0], 0, choose(least[1] - total, 1, 0)))

        def pick(new: Any, old: Any, better: Any = better) -> Any:
            return choose(better, new, old)

        best = Nearest(
            [pick(x, y) for x, y in zip(each.solution, best.solution, strict=True)],
            pick(each.exists, best.exists),
            pick(each.within, best.within),
            pick(each.singular, best.singular),
            pick(each.branch, best.branch),
        )
        least = (pick(rank, least[0]), pick(total, least[1]))
    assert best is not None
    return best


def _turned(joint: Joint, x: Any, near: Any, rounding: Fraction) -> Any:
    """``x`` with a full turn more or less where that is nearer to ``near`` and limits allow it."""
    if not joint.revolute:
        return x
    other = choose(near - x, x + 2 * PI, x - 2 * PI)
    nearer = choose(magnitude(near - x) - PI, 1, 0)
    if joint.limits is None:
        return choose(nearer, other, x)
    low, high = joint.limits
    if high - low <= 2 * PI:
        return x
    inside = both(choose(high + rounding - other, 1, 0), choose(other - (low - rounding), 1, 0))
    return choose(both(nearer, inside), other, x)
