"""The inverse kinematics of an arm in closed form: its class, its branches, and where they put the joints."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import cos, isqrt, sin
from typing import Any

from robodyn.dynamics.arm import Arm
from robodyn.dynamics.inverse.classes import Class, Joints, Points, classes_of
from robodyn.dynamics.inverse.limits import FULL_RANK, TRIED
from robodyn.dynamics.inverse.screws import Axis, Chain, as_floats, chain_of, least_motion, only_places
from robodyn.dynamics.inverse.solution import (
    Joint,
    Limits,
    Nearest,
    Solved,
    joints_of,
    nearest,
    solved,
)
from robodyn.dynamics.inverse.subproblems import Branch, Setting
from robodyn.dynamics.state import NoSuchFunction
from robodyn.effects.scalars import cosine, sine
from robodyn.ir.evaluate import Circle, turn

#: The order in which the joints of an arm of seven are tried as the redundant one (from 0): the one between
#: shoulder and elbow, then the ends.
_REDUNDANT = (2, 6, 0, 4, 1, 5, 3)


@dataclass(frozen=True, slots=True)
class Inverse:
    """Inverse kinematics of an arm in closed form.

    Attributes
    ----------
    redundant: the joint (from 0) that takes its position from the reference; None without one.
    kind: its class.
    place_only: whether only the tool's place is solved for, however it is turned.
    signs: by branch, which of its two positions (+1 or -1) each joint has that has two.
    """

    arm: Arm
    chain: Chain
    joints: tuple[Joint, ...]
    mirrored: bool
    redundant: int | None
    kind: Class
    size: Fraction
    place_only: bool
    signs: tuple[tuple[tuple[int, int], ...], ...] = ()

    @property
    def branch_names(self) -> tuple[str, ...]:
        """Names of the branches, by the positions of joints that have two: ``1+ 3- 5+``."""
        return tuple(
            " ".join(f"{joint + 1}{'+' if sign > 0 else '-'}" for joint, sign in signs)
            for signs in self.signs
        )

    @property
    def branches(self) -> int:
        """How many solutions there are at most; each has its place."""
        return len(self.signs)

    @property
    def conditions(self) -> tuple[str, ...]:
        """What holds for its axes, a sentence each."""
        return self.kind.conditions

    def solve(self, T: Sequence[Any], q_near: Sequence[Any], unit: Fraction) -> Solved:
        """All branches for the tool at ``T`` [12], ``[R p]`` row by row, over any scalar; ``q_near`` [n] (rad
        or m) says where joints are that the pose leaves free. ``unit``: the arithmetic's rounding unit."""
        fixed = {} if self.redundant is None else {self.redundant: q_near[self.redundant]}
        return solved(self._branches(T, q_near, unit), self.joints, fixed, _rounding(unit))

    def nearest(self, T: Sequence[Any], q_near: Sequence[Any], unit: Fraction) -> Nearest:
        """The branch nearest to ``q_near``, see :func:`~robodyn.dynamics.inverse.solution.nearest`."""
        return nearest(self.solve(T, q_near, unit), self.joints, q_near, _rounding(unit))

    def _branches(self, T: Sequence[Any], q_near: Sequence[Any], unit: Fraction) -> list[Branch]:
        circles: dict[int, Circle] = {}

        def near(joint: int) -> Circle:
            if joint not in circles:
                own = (cosine(q_near[joint]), sine(q_near[joint]))
                circles[joint] = turn(own, self.joints[joint].offset)
            return circles[joint]

        chain, target = self.chain, self.chain.target(T, self.arm.base)
        if self.mirrored:
            chain, target = chain.reversed(), target.inverse()
        axes = chain.axes
        if self.redundant is not None:
            place = next(k for k, axis in enumerate(axes) if axis.joint == self.redundant)
            position = near(self.redundant) if axes[place].revolute else q_near[self.redundant]
            target, axes = target.behind(axes[place], position), chain.without(place, position)
        return list(self.kind.solve(axes, target, Setting(near, self.size, unit)))


def _rounding(unit: Fraction) -> Fraction:
    """What positions may be beyond limits by [rad or m]: near singular poses angles are no more exact."""
    return Fraction(1, isqrt(unit.denominator))


def inverse_of(arm: Arm, limits: Sequence[Limits], chain: Chain | None = None) -> Inverse:
    """The inverse kinematics of ``arm``, its numbers exact, with position ``limits`` [n] by joint; of other
    axes, ``chain``, in the place of its own.

    Raises
    ------
    NoSuchFunction: it is of no class that has one in closed form.
    """
    n = len(arm.bodies)
    if not has_exact_lengths(arm):
        raise _none("lengths are run-time parameters", "numbers")
    chain = chain or chain_of(arm)
    joints = joints_of(arm, limits)
    floats = as_floats(chain, chain.size)
    place_only = only_places(floats)
    if least_motion(floats, place_only) <= FULL_RANK:
        raise _none(
            "its joints do not move the tool in all directions",
            "joints that do, and where there are three or fewer a tool that is not on the last one's axis",
        )
    for redundant in _REDUNDANT if n == 7 else (None,):
        for mirrored in (False, True) if n > 5 else (False,):
            for kind in _classes(chain.reversed() if mirrored else chain, redundant, chain.size, place_only):
                through = chain.through(kind.points)
                return _named(
                    Inverse(arm, through, joints, mirrored, redundant, kind, chain.size, place_only)
                )
    raise _none(
        "its axes are of no class that has inverse kinematics in closed form",
        "a spherical wrist or shoulder (three axes that meet) with two axes that are parallel or meet; three "
        "parallel axes; or fewer than six joints that follow one after another",
    )


def has_exact_lengths(arm: Arm) -> bool:
    """Whether no length of ``arm`` is a run-time parameter."""
    return all(isinstance(x, (int, Fraction)) for body in arm.bodies for x in (body.a, body.b, body.d))


def _classes(chain: Chain, redundant: int | None, size: Fraction, place_only: bool) -> Iterator[Class]:
    """Ways to see the axes of ``chain``."""
    place = next((k for k, axis in enumerate(chain.axes) if axis.joint == redundant), None)
    floats = as_floats(chain, size)

    def stances(points: Points) -> list[tuple[Axis, ...]]:
        through = floats.through(
            {j: (float(x / size), float(y / size), float(z / size)) for j, (x, y, z) in points.items()}
        )
        if place is None:
            return [through.axes]
        positions = [(cos(x), sin(x)) if chain.axes[place].revolute else x for x in TRIED]
        return [through.without(place, position) for position in positions]

    axes = chain.axes if place is None else (*chain.axes[:place], *chain.axes[place + 1 :])
    return classes_of(Joints(axes, chain.tool.origin, size, stances, place or 0, place_only))


def _named(inverse: Inverse) -> Inverse:
    """With the signs of its branches, found by solving for a pose in floats."""
    T = [float(k == j) for k in range(3) for j in range(4)]
    near = [0.1 * (k + 1) for k in range(len(inverse.joints))]
    branches = inverse._branches(T, near, Fraction(1, 1 << 52))
    return replace(inverse, signs=tuple(tuple(sorted(branch.signs)) for branch in branches))


def _none(reason: str, expected: str) -> NoSuchFunction:
    return NoSuchFunction("there is no inverse kinematics in closed form", found=reason, expected=expected)
