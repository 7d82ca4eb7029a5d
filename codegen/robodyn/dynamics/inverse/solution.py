"""From branches to joint positions: angles, the turn that suits the limits, flags, the branch nearest to a
reference."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Arm
from robodyn.dynamics.inverse.screws import opposite
from robodyn.dynamics.inverse.subproblems import Branch, Sum, both
from robodyn.dynamics.limits import TASK_JOINTS
from robodyn.effects.scalars import arctangent, choose, magnitude
from robodyn.ir.evaluate import Circle, turn
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

    def turned_near_middle(self, angle: Any, turns: int = 1) -> Any:
        """``angle``, within so many turns, within half a turn of the middle of the limits."""
        middle = (self.limits[0] + self.limits[1]) / 2 if self.limits else Fraction(0)
        whole = round(middle / (2 * PI))
        middle = middle - 2 * PI * whole
        for _ in range(turns):
            if middle > 0 or turns > 1:
                angle = choose(middle - PI - angle, angle + 2 * PI, angle)
            if middle < 0 or turns > 1:
                angle = choose(angle - (middle + PI), angle - 2 * PI, angle)
        return angle + 2 * PI * whole if whole else angle

    def turned_near(self, x: Any, near: Any, rounding: Fraction) -> Any:
        """``x`` with a full turn more or less where that is nearer to ``near`` and limits allow it."""
        if not self.revolute:
            return x
        other = choose(near - x, x + 2 * PI, x - 2 * PI)
        nearer = choose(magnitude(near - x) - PI, 1, 0)
        if self.limits is None:
            return choose(nearer, other, x)
        if self.limits[1] - self.limits[0] <= 2 * PI:
            return x
        return choose(both(nearer, self._within(other, rounding)), other, x)

    def allows(self, position: Any, rounding: Fraction) -> Any:
        """1 where ``position`` is within the limits, or beyond them by rounding; else 0."""
        if self.limits is None or (self.revolute and self.limits[1] - self.limits[0] >= 2 * PI):
            return 1
        return self._within(position, rounding)

    def _within(self, position: Any, rounding: Fraction) -> Any:
        assert self.limits is not None
        low, high = self.limits
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


class Solved(NamedTuple):
    """Joint positions [b][n] (rad or m), and by branch [b] what is true of them, 1 or 0; of an arm of four or
    five joints whether they reach the tool's place, and by what angle they miss its rotation [rad]."""

    solutions: list[list[Any]]
    exists: list[Any]
    within: list[Any]
    singular: list[Any]
    placed: list[Any]
    off: list[Any]

    @classmethod
    def none(cls) -> Solved:
        """Of no branch."""
        return cls([], [], [], [], [], [])


def solved(
    branches: Sequence[Branch], joints: Sequence[Joint], fixed: Mapping[int, Any], rounding: Fraction
) -> Solved:
    """The positions of ``branches``; ``fixed`` are those of joints that no branch decides."""
    angles: dict[Circle, Any] = {}

    def angle_of(circle: Circle) -> Any:
        """The angle [rad] within half a turn of 0; each arctangent is taken once: that of the opposite point
        of the circle is half a turn away."""
        c, s = circle
        opposed = angles.get((-c, -s))
        if opposed is not None:
            return choose(opposed, opposed - PI, opposed + PI)
        if (c, -s) in angles:
            return -angles[c, -s]
        if circle not in angles:
            angles[circle] = arctangent(s, c)
        return angles[circle]

    result = Solved.none()
    for branch in branches:
        q: list[Any] = [None] * len(joints)
        late = []
        for k, joint in enumerate(joints):
            position = fixed[k] if k in fixed else branch.positions[k]
            if isinstance(position, Sum):
                late.append(k)
            elif joint.revolute and k not in fixed:
                q[k] = joint.turned_near_middle(angle_of(turn(position, opposite(joint.offset))))
            else:
                q[k] = position
        for k in late:
            position = branch.positions[k]
            total = turn(position.angle, opposite(joints[k].offset))
            for other, sense in position.minus:
                offset = joints[other].offset
                total = turn(total, opposite(offset) if sense > 0 else offset)
            angle = angle_of(total)
            for other, sense in position.minus:
                angle = angle - q[other] if sense > 0 else angle + q[other]
            q[k] = joints[k].turned_near_middle(angle, 1 + len(position.minus))
        result.solutions.append(q)
        result.exists.append(branch.exists)
        result.within.append(both(*(j.allows(x, rounding) for j, x in zip(joints, q, strict=True))))
        result.singular.append(branch.singular)
        if len(joints) in TASK_JOINTS:
            result.placed.append(branch.placed)
            result.off.append(branch.off)
    return result


class Nearest(NamedTuple):
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
    best: list[Any] = []
    for k, (q, exists, within, singular) in enumerate(zip(*solved[:4], strict=True)):
        turned = [joint.turned_near(x, y, rounding) for joint, x, y in zip(joints, q, near, strict=True)]
        total = sum((x - y) * (x - y) for x, y in zip(turned, near, strict=True))
        # 0 for what exists and is within limits, 1 for what only exists, 2 or 3 for the rest
        rank = 3 - within - 2 * exists
        if solved.placed:  # of those that do not exist, the ones that are in place before the others
            rank = rank + 2 * (1 - solved.placed[k])
        each = [*turned, exists, within, singular, Fraction(k), rank, total]
        if best:
            *_, least, closest = best
            better = choose(least - rank, 1, choose(rank - least, 0, choose(closest - total, 1, 0)))
            each = [choose(better, new, old) for new, old in zip(each, best, strict=True)]
        best = each
    *positions, exists, within, singular, branch, _, _ = best
    return Nearest(positions, exists, within, singular, branch)
