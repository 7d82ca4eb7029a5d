"""The inverse kinematics of an arm: its class, its branches, and where they put the joints."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from math import cos, isqrt, sin
from typing import Any

from robodyn.dynamics.arm import Arm
from robodyn.dynamics.inverse.branch import Branch, Setting
from robodyn.dynamics.inverse.classes import (
    Class,
    Joints,
    few,
    parallels,
    shares,
    whole_places,
    wrists,
)
from robodyn.dynamics.inverse.limits import TRIED
from robodyn.dynamics.inverse.rank import moves_all_ways
from robodyn.dynamics.inverse.screws import Axis, Chain, Circle, as_floats, chain_of, minus, sum_of
from robodyn.dynamics.inverse.solution import (
    Joint,
    Limits,
    Nearest,
    Solved,
    joints_of,
    nearest,
    places_only,
    solved,
)
from robodyn.dynamics.inverse.structures import Points
from robodyn.dynamics.state import NoSuchFunction
from robodyn.effects.scalars import cosine, sine

#: The order in which the joints of an arm of seven are tried as the redundant one (from 0): the one between
#: shoulder and elbow, then the ends.
_REDUNDANT = (2, 6, 0, 4, 1, 5, 3)


@dataclass(frozen=True, slots=True)
class Inverse:
    """Inverse kinematics of an arm in closed form.

    Attributes
    ----------
    conditions: what holds for its axes, a sentence each.
    branches: how many solutions there are at most; each has its place.
    branch_names: which of its two positions each joint has that has two: ``1+ 3- 5+``.
    redundant: the joint (from 0) that takes its position from the reference; None without one.
    """

    arm: Arm
    chain: Chain
    joints: tuple[Joint, ...]
    mirrored: bool
    redundant: int | None
    kind: Class
    size: Fraction
    signs: tuple[tuple[tuple[int, int], ...], ...] = ()

    @property
    def branch_names(self) -> tuple[str, ...]:
        """Names of the branches."""
        return tuple(
            " ".join(f"{joint + 1}{'+' if sign > 0 else '-'}" for joint, sign in signs)
            for signs in self.signs
        )

    @property
    def branches(self) -> int:
        """How many solutions there are at most."""
        return len(self.signs)

    @property
    def conditions(self) -> tuple[str, ...]:
        """What holds for its axes."""
        return self.kind.conditions

    @property
    def place_only(self) -> bool:
        """Whether only the place of the tool is solved for, however it is turned: three joints do no more."""
        return places_only(self.joints)

    def solve(self, T: Sequence[Any], q_near: Sequence[Any], unit: Fraction) -> Solved:
        """All branches for the tool at ``T`` [12], ``[R p]`` row by row, over any scalar; ``q_near`` [n] (rad
        or m) says where joints are that the pose leaves free. ``unit``: the arithmetic's rounding unit."""
        fixed = {} if self.redundant is None else {self.redundant: q_near[self.redundant]}
        branches = self._branches(T, q_near, unit)
        return solved(branches, self.joints, fixed, self._rounding(unit))

    def nearest(self, T: Sequence[Any], q_near: Sequence[Any], unit: Fraction) -> Nearest:
        """The branch nearest to ``q_near``, see :func:`~robodyn.dynamics.inverse.solution.nearest`."""
        return nearest(self.solve(T, q_near, unit), self.joints, q_near, self._rounding(unit))

    def _rounding(self, unit: Fraction) -> Fraction:
        """What positions may be beyond limits by [rad or m]: near singular poses angles are no more exact."""
        return Fraction(1, isqrt(unit.denominator))

    def _branches(self, T: Sequence[Any], q_near: Sequence[Any], unit: Fraction) -> list[Branch]:
        circles: dict[int, Circle] = {}

        def near(joint: int) -> Circle:
            if joint not in circles:
                own = (cosine(q_near[joint]), sine(q_near[joint]))
                circles[joint] = sum_of(own, self.joints[joint].offset)
            return circles[joint]

        target = self.chain.target(T, self.arm.base)
        chain = self.chain
        if self.mirrored:
            chain, target = chain.reversed(), target.inverse()
        axes = chain.axes
        if self.redundant is not None:
            place = next(k for k, axis in enumerate(axes) if axis.joint == self.redundant)
            position = near(self.redundant) if axes[place].revolute else q_near[self.redundant]
            target, axes = target.behind(axes[place], position), chain.without(place, position)
        return list(self.kind.solve(axes, target, Setting(near, self.size, unit)))


def inverse_of(arm: Arm, limits: Sequence[Limits], chain: Chain | None = None) -> Inverse:
    """The inverse kinematics of ``arm``, its numbers exact, with position ``limits`` [n] by joint; of other
    axes, ``chain``, in the place of its own.

    Raises
    ------
    NoSuchFunction: it is of no class that has one in closed form.
    """
    n = len(arm.bodies)
    if not all(isinstance(x, (int, Fraction)) for body in arm.bodies for x in (body.a, body.b, body.d)):
        raise _none("lengths are run-time parameters", "numbers")
    chain = chain or chain_of(arm)
    size = size_of(chain)
    joints = joints_of(arm, limits)
    if not moves_all_ways(as_floats(chain, size)):
        raise _none(
            "its joints do not move the tool in all directions",
            "joints that do, and where there are three or fewer a tool that is not on the last one's axis",
        )
    for redundant in _REDUNDANT if n == 7 else (None,):
        for mirrored in (False, True) if n > 3 else (False,):
            for kind in _classes(chain.reversed() if mirrored else chain, redundant, size):
                through = chain.through(kind.points)
                own = Inverse(arm, through, joints, mirrored, redundant, kind, size)
                return _named(own)
    raise _none(
        "its axes are of no class that has inverse kinematics in closed form",
        "a spherical wrist or shoulder (three axes that meet) with two axes that are parallel or meet; three "
        "parallel axes; or an arm of three joints or fewer",
    )


def _classes(chain: Chain, redundant: int | None, size: Fraction) -> Iterator[Class]:
    """Ways to see the axes of ``chain``."""
    place = next((k for k, axis in enumerate(chain.axes) if axis.joint == redundant), None)
    floats = as_floats(chain, size)

    def stances(points: Points) -> list[tuple[Axis, ...]]:
        placed = {j: shares(point, size) for j, point in points.items()}
        through = floats.through(placed)
        if place is None:
            return [through.axes]
        positions = [(cos(x), sin(x)) if chain.axes[place].revolute else x for x in TRIED]
        return [through.without(place, position) for position in positions]

    axes = chain.axes if place is None else (*chain.axes[:place], *chain.axes[place + 1 :])
    joints = Joints(axes, chain.tool.origin, size, stances, place or 0)
    if len(axes) == 6:
        yield from wrists(joints)
        yield from parallels(joints)
    elif len(axes) == 3:
        yield from whole_places(joints)
    elif len(axes) < 3:
        yield from few(joints)


def _named(inverse: Inverse) -> Inverse:
    """With the signs of its branches, found by solving for a pose in floats."""
    T = [float(k == j) for k in range(3) for j in range(4)]
    near = [0.1 * (k + 1) for k in range(len(inverse.joints))]
    branches = inverse._branches(T, near, Fraction(1, 1 << 52))
    return replace(inverse, signs=tuple(tuple(sorted(branch.signs)) for branch in branches))


def size_of(chain: Chain) -> Fraction:
    """No less than any lever of the arm at any position, and about its reach [m]."""
    points = [*(axis.point for axis in chain.axes), chain.tool.origin]
    total = sum(
        (abs(x) for one, other in pairwise(points) for x in minus(other, one)),
        Fraction(0),
    )
    return total or Fraction(1)


def _none(reason: str, expected: str) -> NoSuchFunction:
    return NoSuchFunction("there is no inverse kinematics in closed form", found=reason, expected=expected)
