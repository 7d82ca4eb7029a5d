"""Classes of arms that have inverse kinematics in closed form, and what each needs of the axes.

Pieper (1968): a spherical wrist, or its mirror image at the base. Hawkins (2013): three parallel axes, as the
arms of Universal Robots have them. An arm of seven joints is of a class if one without one of its joints is,
whatever that joint's position; its axes are then joints at with it in several positions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Protocol

from robodyn.dynamics.inverse import few_joints
from robodyn.dynamics.inverse.branch import Branch, Setting, Sum
from robodyn.dynamics.inverse.lines import feet, nearest
from robodyn.dynamics.inverse.orientation import marker_of, oriented
from robodyn.dynamics.inverse.places import Reach, in_a_plane, shoulders
from robodyn.dynamics.inverse.screws import Axis, Target, minus
from robodyn.dynamics.inverse.structures import (
    STRUCTURES,
    Axes,
    Points,
    Structure,
    parallel,
    through,
)
from robodyn.dynamics.vectors import Vector, dot


class Class(Protocol):
    """How the angles of ``axes`` follow from a target."""

    @property
    def conditions(self) -> tuple[str, ...]:
        """What holds for the arm, a sentence each, without a stop."""
        ...

    @property
    def points(self) -> Points:
        """Points of the axes that it needs, by joint, of the chain as it is at rest."""
        ...

    def solve(self, axes: Sequence[Axis], target: Target, at: Setting) -> Iterator[Branch]:
        """All branches; ``axes`` through ``points``."""
        ...


@dataclass(frozen=True, slots=True)
class Wrist:
    """The last three axes meet: the first three joints place the point where they do, the others turn."""

    structure: Structure
    mirrored: bool
    centre: Vector
    marker: Vector
    points: Points
    conditions: tuple[str, ...]

    def solve(self, axes: Sequence[Axis], target: Target, at: Setting) -> Iterator[Branch]:
        """All branches."""
        first = _three(axes[:3])
        place = target.placed(self.centre)
        for branch in _placed(self.structure, self.mirrored, first, self.centre, place, at):

            def rotation(v: Vector, branch: Branch = branch) -> Vector:
                return branch.inward_of(first, target.turned(v))

            yield from oriented(_three(axes[3:]), rotation, self.marker, branch, at)


@dataclass(frozen=True, slots=True)
class ThreeParallel:
    """The second, third and fourth axes are parallel, and the last two meet.

    What is along the three tells the first angle, directions tell the sum of the three and the last two, and
    two links in a plane remain.
    """

    centre: Vector
    marker: Vector
    points: Points
    conditions: tuple[str, ...]

    def solve(self, axes: Sequence[Axis], target: Target, at: Setting) -> Iterator[Branch]:
        """All branches."""
        one, two, three, four, five, six = axes
        h = two.direction
        p = minus(target.placed(self.centre), one.point)
        back = target.inverse()
        distance = dot(h, minus(self.centre, one.point))
        ways = (six.reversed(), five.reversed(), four.reversed())
        for first, w in shoulders(one, h, p, distance, Branch(), at):

            def rotation(v: Vector, branch: Branch = first) -> Vector:
                return back.turned(branch.outward(one, v))

            u = minus(w, minus(two.point, one.point))
            for turned in oriented(ways, rotation, self.marker, first, at):
                beyond = turned.outward(four, minus(self.centre, four.point))
                b, c = minus(three.point, two.point), minus(four.point, three.point)
                for branch in in_a_plane((two, three), b, c, minus(u, beyond), turned, at):
                    others = tuple((each.joint, _sense(each, four)) for each in (two, three))
                    rest = Sum(branch.positions[four.joint], minus=others)
                    yield branch.known(four.joint, rest)


@dataclass(frozen=True, slots=True)
class Place:
    """Three joints that bring the tool's origin to a point, however it is turned."""

    structure: Structure
    mirrored: bool
    tip: Vector
    points: Points
    conditions: tuple[str, ...]

    def solve(self, axes: Sequence[Axis], target: Target, at: Setting) -> Iterator[Branch]:
        """All branches."""
        place = target.placed(self.tip)
        yield from _placed(self.structure, self.mirrored, _three(axes), self.tip, place, at)


@dataclass(frozen=True, slots=True)
class FewJoints:
    """One or two joints that bring the tool's origin to a point, however it is turned."""

    tip: Vector
    points: Points
    conditions: tuple[str, ...]

    def solve(self, axes: Sequence[Axis], target: Target, at: Setting) -> Iterator[Branch]:
        """All branches."""
        yield from few_joints.placed(axes, self.tip, target.placed(self.tip), at)


def _placed(
    structure: Structure, mirrored: bool, axes: Axes, tip: Vector, place: Vector, at: Setting
) -> Iterator[Branch]:
    """Branches of three joints that bring ``tip`` to ``place``."""
    reach = Reach(_mirror(axes), place, tip) if mirrored else Reach(axes, tip, place)
    yield from structure.solve(reach, Branch(), at)


# --- what an arm is of --------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Joints:
    """Joints that are to be recognised: their ``axes`` at rest, of exact numbers; the ``tip`` [m]; the arm's
    ``size`` [m].

    ``stances`` are the same axes through given points, with a redundant joint in several positions, in
    floats, lengths as shares of the size. ``moved``: how many of the first axes such a joint is behind.
    """

    axes: tuple[Axis, ...]
    tip: Vector
    size: Fraction
    stances: Callable[[Points], Sequence[tuple[Axis, ...]]]
    moved: int = 0


def wrists(arm: Joints) -> Iterator[Wrist]:
    """Ways to see the last three of six axes as a spherical wrist."""
    four, five, six = arm.axes[3:]
    if arm.moved > 3 or not (four.revolute and five.revolute and six.revolute):
        return
    centre, _ = feet(four, five)
    point = shares(centre, arm.size)
    for stance in arm.stances({}):
        last = stance[3:]
        if not through(last, point) or parallel(last[0], last[1]) or parallel(last[1], last[2]):
            return
    meeting = "axes {}, {} and {} meet in a point".format(*_numbers(arm.axes[3:]))
    for structure, mirrored, points in _structures(arm):
        words = structure.words.format(*_numbers(_mirror(arm.axes) if mirrored else arm.axes))
        yield Wrist(structure, mirrored, centre, marker_of(six), points, (meeting, words))


def parallels(arm: Joints) -> Iterator[ThreeParallel]:
    """The way to see the second, third and fourth of six axes as parallel, if there is one."""
    one, two, three, four, five, six = arm.axes
    if arm.moved > 1 or not all(axis.revolute for axis in arm.axes):
        return
    centre, _ = feet(five, six)
    first, second = feet(one, two)
    third = nearest(three, second)
    points = dict(zip((0, 1, 2, 3), (first, second, third, nearest(four, third)), strict=True))
    points = {arm.axes[k].joint: point for k, point in points.items()}
    point = shares(centre, arm.size)
    for a, b, c, d, e, f in arm.stances(points):
        if not (parallel(b, c) and parallel(b, d) and through((e, f), point)):
            return
        if parallel(a, b) or parallel(d, e) or parallel(e, f):
            return
    numbers = _numbers(arm.axes)
    yield ThreeParallel(
        centre,
        marker_of(four),
        points,
        (
            "axes {1}, {2} and {3} are parallel, and axes {0} and {4} are not".format(*numbers),
            "axes {4} and {5} meet".format(*numbers),
        ),
    )


def whole_places(arm: Joints) -> Iterator[Place]:
    """Ways to bring the tip to a point by three axes."""
    for structure, mirrored, points in _structures(arm):
        words = structure.words.format(*_numbers(_mirror(arm.axes) if mirrored else arm.axes))
        yield Place(structure, mirrored, arm.tip, points, (words,))


def few(arm: Joints) -> Iterator[FewJoints]:
    """The way to bring the tip to a point by one or two axes."""
    points = {}
    if len(arm.axes) == 2:
        one, two = arm.axes
        first, second = feet(one, two)
        points = {one.joint: first, two.joint: second}
    yield FewJoints(arm.tip, points, ("there are fewer than three joints",))


def _structures(arm: Joints) -> Iterator[tuple[Structure, bool, Points]]:
    """Ways to place a point by the first three axes; whether these are taken from the last to the first."""
    for mirrored in (False, True):
        axes = _mirror(arm.axes) if mirrored else _three(arm.axes)
        kinds = "".join("R" if axis.revolute else "P" for axis in axes)
        for structure in STRUCTURES:
            if structure.kinds != kinds:
                continue
            points = structure.points(axes)
            stances = arm.stances(points)
            if all(structure.applies(_mirror(each) if mirrored else _three(each)) for each in stances):
                yield structure, mirrored, points


def shares(u: Vector, size: Fraction) -> Vector:
    """Lengths as shares of ``size``, in floats."""
    return float(u[0] / size), float(u[1] / size), float(u[2] / size)


def _sense(one: Axis, other: Axis) -> int:
    """1 where two parallel axes point one way, else -1."""
    return 1 if dot(one.direction, other.direction) > 0 else -1


def _three(axes: Sequence[Axis]) -> Axes:
    return axes[0], axes[1], axes[2]


def _mirror(axes: Sequence[Axis]) -> Axes:
    """The first three axes, as they lead from the third back to the base."""
    return axes[2].reversed(), axes[1].reversed(), axes[0].reversed()


def _numbers(axes: Sequence[Axis]) -> list[int]:
    return [axis.joint + 1 for axis in axes]
