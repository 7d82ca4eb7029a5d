"""Classes of arms that have inverse kinematics in closed form, and what each needs of the axes.

Pieper (1968): a spherical wrist, or its mirror image at the base. Hawkins (2013): three parallel axes, as the
arms of Universal Robots have them. An arm of seven joints is of a class if one without one of its joints is,
whatever that joint's position; its axes are then joints at with it in several positions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from robodyn.dynamics.inverse.fit import Fit, upright
from robodyn.dynamics.inverse.limits import TOLERANCE
from robodyn.dynamics.inverse.loops import Equation, answered
from robodyn.dynamics.inverse.places import (
    STRUCTURES,
    Axes,
    Reach,
    Structure,
    in_a_plane,
    parallel,
    shoulders,
)
from robodyn.dynamics.inverse.screws import Axis, Chain, Target, feet
from robodyn.dynamics.inverse.subproblems import Branch, Setting, Sum, lever_of, real_root
from robodyn.dynamics.vectors import BASE, Frame, Vector, dot, minus

#: Points of axes by joint.
Points = dict[int, Vector]
#: Branches in which the first of some axes bring a point that they move to a place.
Placing = Callable[[Sequence[Axis], Vector, Vector, Setting], Iterator[Branch]]


class Class(NamedTuple):
    """How the positions of axes follow from a target.

    ``conditions``: what holds for the arm, a sentence each, without a stop. ``points``: points of the axes
    that it needs, by joint, of the chain as it is at rest. ``solve``: all branches, of axes through these.
    """

    conditions: tuple[str, ...]
    points: Points
    solve: Callable[[Sequence[Axis], Target, Setting], Iterator[Branch]]


@dataclass(frozen=True, slots=True)
class Joints:
    """Joints that are to be recognised: their ``axes`` at rest, of exact numbers; the ``tip`` [m]; the arm's
    ``size`` [m].

    ``stances`` are the same axes through given points, with a redundant joint in several positions, in
    floats, lengths as shares of the size. ``moved``: how many of the first axes such a joint is behind.
    ``place_only``: whether the tool may be turned anyhow.
    """

    axes: tuple[Axis, ...]
    tip: Vector
    size: Fraction
    stances: Callable[[Points], Sequence[tuple[Axis, ...]]]
    moved: int = 0
    place_only: bool = False


def classes_of(arm: Joints) -> Iterator[Class]:
    """Ways to see the axes of ``arm``."""
    if len(arm.axes) == 6:
        yield from _wrists(arm)
        yield from _three_parallel(arm)
    elif len(arm.axes) < 6:
        if len(arm.axes) == 3 and arm.place_only:
            yield from _places(arm)
        yield from _one_after_another(arm)


def _wrists(arm: Joints) -> Iterator[Class]:
    """The last three axes meet: the first three joints place the point where they do, the others turn."""
    four, five, six = arm.axes[3:]
    if arm.moved > 3 or not (four.revolute and five.revolute and six.revolute):
        return
    centre, _ = feet(four, five)
    for stance in arm.stances({}):
        a, b, c = stance[3:]
        if not _meet((a, b, c), centre, arm.size) or parallel(a, b) or parallel(b, c):
            return
    marker = _marker_of(six)
    meeting = "axes {}, {} and {} meet in a point".format(*_numbers(arm.axes[3:]))
    for place, points, words in _structures(arm):
        yield Class((meeting, words), points, partial(_by_wrist, place, centre, marker))


def _by_wrist(
    place: Placing, centre: Vector, marker: Vector, axes: Sequence[Axis], target: Target, at: Setting
) -> Iterator[Branch]:
    for branch in place(axes, centre, target.placed(centre), at):

        def rotation(v: Vector, branch: Branch = branch) -> Vector:
            return branch.inward_of(axes[:3], target.turned(v))

        yield from _oriented(_three(axes[3:]), rotation, marker, branch, at)


def _three_parallel(arm: Joints) -> Iterator[Class]:
    """The second, third and fourth axes are parallel, and the last two meet.

    What is along the three tells the first angle, directions tell the sum of the three and the last two, and
    two links in a plane remain.
    """
    one, two, three, four, five, six = arm.axes
    if arm.moved > 1 or not all(axis.revolute for axis in arm.axes):
        return
    centre, _ = feet(five, six)
    first, second = feet(one, two)
    third = three.nearest(second)
    through = (first, second, third, four.nearest(third))
    points = {axis.joint: point for axis, point in zip(arm.axes, through, strict=False)}
    for a, b, c, d, e, f in arm.stances(points):
        if not (parallel(b, c) and parallel(b, d) and _meet((e, f), centre, arm.size)):
            return
        if parallel(a, b) or parallel(d, e) or parallel(e, f):
            return
    marker = _marker_of(four)

    def solve(axes: Sequence[Axis], target: Target, at: Setting) -> Iterator[Branch]:
        one, two, three, four, five, six = axes
        h = two.direction
        p = minus(target.placed(centre), one.point)
        back = target.inverse()
        distance = dot(h, minus(centre, one.point))
        ways = (six.reversed(), five.reversed(), four.reversed())
        for first, w in shoulders(one, h, p, distance, Branch(), at):

            def rotation(v: Vector, branch: Branch = first) -> Vector:
                return back.turned(branch.outward(one, v))

            u = minus(w, minus(two.point, one.point))
            for turned in _oriented(ways, rotation, marker, first, at):
                beyond = turned.outward(four, minus(centre, four.point))
                b, c = minus(three.point, two.point), minus(four.point, three.point)
                for branch in in_a_plane((two, three), b, c, minus(u, beyond), turned, at):
                    senses = (
                        (each.joint, 1 if dot(each.direction, four.direction) > 0 else -1)
                        for each in (two, three)
                    )
                    rest = Sum(branch.positions[four.joint], minus=tuple(senses))
                    yield branch.with_position(four.joint, rest)

    numbers = _numbers(arm.axes)
    words = "axes {1}, {2} and {3} are parallel, and axes {0} and {4} are not", "axes {4} and {5} meet"
    yield Class((words[0].format(*numbers), words[1].format(*numbers)), points, solve)


def _places(arm: Joints) -> Iterator[Class]:
    """Three joints that bring the tool's origin to a point, however it is turned."""
    for place, points, words in _structures(arm):
        yield Class((words,), points, partial(_at_the_tip, place, arm.tip))


def _one_after_another(arm: Joints) -> Iterator[Class]:
    """Each joint follows from an equation of its own."""
    from robodyn.dynamics.inverse.order import order_of

    equations = order_of(Chain(arm.axes, Frame(arm.tip, BASE.x, BASE.y, BASE.z)), arm.place_only)
    if equations is None:
        return
    joints = [arm.axes[equation.place].joint + 1 for equation in equations]
    words = f"joints follow one after another: {', '.join(map(str, joints))}"
    turns = [axis for axis in arm.axes if axis.revolute]
    # Four joints whose turns are about one direction do all that leaves it as it is, and nothing else.
    level = len(arm.axes) == 4 and all(axis.is_along(turns[0]) for axis in turns)
    along = turns[0].direction if level and turns else None
    yield Class((words,), {}, partial(_by_equations, equations, arm.tip, arm.place_only, along))


def _by_equations(
    equations: Sequence[Equation],
    tip: Vector,
    place_only: bool,
    along: Vector | None,
    axes: Sequence[Axis],
    target: Target,
    at: Setting,
) -> Iterator[Branch]:
    able = target if along is None else upright(target, along)
    branches = [Branch()]
    for equation in equations:
        branches = [b for one in branches for b in answered(axes, able, equation, one, at)]
    yield from map(Fit(axes, tip, target, place_only, at, along is not None).fitted, branches)


def _at_the_tip(
    place: Placing, tip: Vector, axes: Sequence[Axis], target: Target, at: Setting
) -> Iterator[Branch]:
    return place(axes, tip, target.placed(tip), at)


def _placed(
    structure: Structure, mirrored: bool, axes: Sequence[Axis], tip: Vector, place: Vector, at: Setting
) -> Iterator[Branch]:
    one, two, three = ordered = _mirror(axes) if mirrored else _three(axes)
    if mirrored:
        tip, place = place, tip
    p, a = minus(place, one.point), minus(two.point, one.point)
    b, c = minus(three.point, two.point), minus(tip, three.point)
    return structure.solve(Reach(ordered, p, a, b, c), Branch(), at)


def _structures(arm: Joints) -> Iterator[tuple[Placing, Points, str]]:
    """Ways to place a point by the first three axes, which are taken from the first to the last or back; the
    points (where the first two are nearest to each other, and on the third what is nearest to that); and what
    is needed, in words."""
    for mirrored in (False, True):
        ordered = _mirror if mirrored else _three
        one, two, three = axes = ordered(arm.axes)
        kinds = "".join("R" if axis.revolute else "P" for axis in axes)
        first, second = feet(one, two)
        points = {one.joint: first, two.joint: second, three.joint: three.nearest(second)}
        for structure in STRUCTURES:
            if structure.kinds == kinds and all(
                structure.applies(*ordered(stance)) for stance in arm.stances(points)
            ):
                words = structure.words.format(*_numbers(axes))
                yield partial(_placed, structure, mirrored), points, words


def _meet(axes: Sequence[Axis], point: Vector, size: Fraction) -> bool:
    """Whether all ``axes``, in floats with lengths as shares of ``size``, go through ``point``."""
    x, y, z = point
    share = (float(x / size), float(y / size), float(z / size))
    return all(axis.distance(share) <= TOLERANCE for axis in axes)


def _three(axes: Sequence[Axis]) -> Axes:
    return axes[0], axes[1], axes[2]


def _mirror(axes: Sequence[Axis]) -> Axes:
    """The first three axes, as they lead from the third back to the base."""
    return axes[2].reversed(), axes[1].reversed(), axes[0].reversed()


def _numbers(axes: Sequence[Axis]) -> list[int]:
    return [axis.joint + 1 for axis in axes]


# --- three axes that turn -----------------------------------------------------------------------------------


def _oriented(
    axes: Axes, rotation: Callable[[Vector], Vector], marker: Vector, branch: Branch, at: Setting
) -> Iterator[Branch]:
    """``branch`` with the angles of three ``axes`` that add up to ``rotation``, in two ways.

    The third axis is turned where ``rotation`` has it by the first two: the first brings it as far along the
    second axis as it is at rest, the second does the rest. ``marker``, a unit vector that is not along the
    third axis, then shows the third angle. Where the first and third axes line up the first angle is free.
    """
    first, second, third = axes
    pointing = rotation(third.direction)
    sideways = rotation(marker)
    along = dot(second.direction, third.direction)
    # along = second . (R1^T pointing) = pointing . (R1 second)
    for one in branch.with_each(first.joint, at.reach(first, second.direction, pointing, along)):
        rest = one.inward(first, pointing)
        lever = lever_of(second.direction, third.direction)
        two = one.with_answer(second.joint, at.onto(second, third.direction, rest, lever=lever))
        marked = two.inward(second, two.inward(first, sideways))
        yield two.with_answer(third.joint, at.onto(third, marker, marked, lever=1))


def _marker_of(axis: Axis) -> Vector:
    """A unit vector across ``axis``, of numbers that are simple where its direction's are."""
    x, y, z = axis.direction
    if abs(x) <= abs(y) and abs(x) <= abs(z):
        v = (0 * x, z, -y)
    elif abs(y) <= abs(z):
        v = (z, 0 * y, -x)
    else:
        v = (y, -x, 0 * z)
    length = real_root(dot(v, v))
    return v[0] / length, v[1] / length, v[2] / length
