"""Where three joints bring a point: the positions of the first three joints of an arm, or of its last three.

``point = S1 S2 S3 tip``. Each way applies to arms of some structure; all are written in terms of points on
the axes that suit it: ``p`` from the first axis to the point, ``a`` from the first to the second, ``b`` from
the second to the third, ``c`` from there to the tip at rest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from robodyn.dynamics.inverse.limits import TOLERANCE
from robodyn.dynamics.inverse.screws import Axis, across, opposite, turned
from robodyn.dynamics.inverse.subproblems import (
    Branch,
    Setting,
    chosen,
    is_number,
    lever_of,
    real_root,
)
from robodyn.dynamics.vectors import Vector, cross, dot, minus, plus, scaled
from robodyn.effects.scalars import choose

Axes = tuple[Axis, Axis, Axis]


class Reach(NamedTuple):
    """Three axes, and ``p a b c`` of them, see above [m]."""

    axes: Axes
    p: Vector
    a: Vector
    b: Vector
    c: Vector


#: A way to place a point, with all its branches, of the branch that it starts from.
Solver = Callable[[Reach, Branch, Setting], Iterator[Branch]]
#: Whether three axes are as a way needs them.
Fit = Callable[[Axis, Axis, Axis], bool]


class Structure(NamedTuple):
    """A way to place a point by three joints.

    ``kinds``: ``R`` and ``P`` by joint. ``words``: what is needed, with ``{0} {1} {2}`` for the joints.
    ``applies``: whether three axes in floats, through their points, are as the way needs them; lengths there
    are shares of the arm's size.
    """

    kinds: str
    words: str
    applies: Fit
    solve: Solver


#: All ways to place a point by three joints.
STRUCTURES: list[Structure] = []


def _structure(kinds: str, words: str, applies: Fit) -> Callable[[Solver], Solver]:
    def register(solve: Solver) -> Solver:
        STRUCTURES.append(Structure(kinds, words, applies, solve))
        return solve

    return register


def parallel(one: Axis, other: Axis) -> bool:
    """Whether two axes are parallel to within the tolerance."""
    return one.slope(other) <= TOLERANCE


def _crossing(one: Axis, other: Axis) -> bool:
    """Whether two axes meet in their points and are not parallel."""
    u = minus(one.point, other.point)
    return float(dot(u, u)) ** 0.5 <= TOLERANCE and not parallel(one, other)


def _square(one: Axis, other: Axis) -> bool:
    """Whether two axes are perpendicular."""
    return abs(float(dot(one.direction, other.direction))) <= TOLERANCE


def _norm(u: Vector) -> Any:
    return dot(u, u)


# --- three revolute joints ----------------------------------------------------------------------------------


@_structure(
    "RRR",
    "axes {1} and {2} are parallel, and axis {0} is not",
    lambda one, two, three: parallel(two, three) and not parallel(one, two),
)
def _second_and_third_parallel(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """The first turns the place as far along the others as the tip is; two links in a plane remain."""
    one, two, three = arm.axes
    distance = dot(two.direction, plus(arm.a, arm.b, arm.c))
    for shoulder, w in shoulders(one, two.direction, arm.p, distance, branch, at):
        yield from in_a_plane((two, three), arm.b, arm.c, minus(w, arm.a), shoulder, at)


@_structure(
    "RRR",
    "axes {0} and {1} meet, and axis {2} is not parallel to axis {1}",
    lambda one, two, three: _crossing(one, two) and not parallel(two, three),
)
def _first_and_second_meet(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """The third brings the tip as far from where the others meet as the place is; then there are two axes
    through a point."""
    one, two, three = arm.axes
    p, b, c = arm.p, arm.b, arm.c
    for folded in branch.with_each(three.joint, at.fold(three, b, c, _norm(p))):
        v = plus(b, folded.outward(three, c))
        yield from _through_a_point((one, two), v, p, folded, at)


def shoulders(
    one: Axis, along: Vector, p: Vector, distance: Any, branch: Branch, at: Setting
) -> Iterator[tuple[Branch, Vector]]:
    """The two positions of a revolute joint from behind which ``p`` is ``distance`` along ``along``, and
    ``p`` as it is seen from there."""
    ways = at.reach(one, along, p, distance, 1)
    cosine = dot(one.direction, along)
    for sign, shoulder in zip((-1, 1), branch.with_each(one.joint, ways), strict=True):
        if not is_number(cosine) or cosine:
            yield shoulder, shoulder.inward(one, p)
            continue
        # Three directions at right angles: what is along the axis stays, and the others are known.
        sideways = scaled(sign * ways.side, cross(one.direction, along))
        height = scaled(dot(one.direction, p), one.direction)
        yield shoulder, plus(scaled(distance - ways.beyond, along), height, sideways)


def in_a_plane(
    axes: tuple[Axis, Axis], b: Vector, c: Vector, u: Vector, branch: Branch, at: Setting
) -> Iterator[Branch]:
    """Two parallel revolute axes with ``u = R1 (b + R2 c)``, but for what is along them."""
    one, two = axes
    b, c, u = (across(one.direction, v) for v in (b, c, u))
    lever = lever_of(one.direction, b) - lever_of(one.direction, c)
    for folded in branch.with_each(two.joint, at.fold(two, b, c, _norm(u))):
        v = plus(b, folded.outward(two, c))
        yield folded.with_answer(one.joint, at.onto(one, v, u, 2, lever=lever))


def _through_a_point(
    axes: tuple[Axis, Axis], v: Vector, onto: Vector, branch: Branch, at: Setting
) -> Iterator[Branch]:
    """Two revolute axes through a point with ``R1 R2 v = onto``, ``v`` and ``onto`` lengths.

    Along the second axis ``v`` and ``R1^T onto`` agree, which tells the first angle, and the second turns one
    onto the other; or along the first axis ``R2 v`` and ``onto`` do. Where what is turned last has a short
    lever, the equation before is blind to it: both are worked out, and the longer lever decides.
    """
    one, two = axes
    h, k = one.direction, two.direction
    by_first = at.reach(one, k, onto, dot(k, v), 1)
    by_second = at.reach(two, v, h, dot(h, onto), 1)
    longer = _norm(across(k, v)) - _norm(across(h, onto))
    # Of a pose out of reach both miss the same; how far off it is shows where the lever is short.
    exist = choose(longer, by_first.exist, by_second.exist)
    for sign, start, other in zip((1, -1), by_first.answers, by_second.answers, strict=True):
        last = at.onto(two, v, turned(h, opposite(start), onto), 2)
        before = at.onto(one, turned(k, other, v), onto, 2)
        meet = choose(longer, by_second.meet, by_first.meet)
        first = chosen(longer, start, before.answer)
        sided = branch.with_side(one.joint, sign, first, exist, meet)
        yield sided.with_position(two.joint, chosen(longer, last.answer, other))


# --- with prismatic joints ----------------------------------------------------------------------------------


@_structure("RRP", "axes {0} and {1} meet", lambda one, two, three: _crossing(one, two))
def _two_turns_and_a_slide_that_meet(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """As in the Stanford arm: the slide brings the tip as far from where the turns meet as the place is."""
    one, two, three = arm.axes
    p, b, h = arm.p, plus(arm.b, arm.c), three.direction
    for out in branch.with_each(three.joint, at.slide(dot(b, h), _norm(b) - _norm(p))):
        v = plus(b, scaled(out.positions[three.joint], h))
        yield from _through_a_point((one, two), v, p, out, at)


@_structure(
    "RRP",
    "axes {0} and {1} are parallel, and axis {2} is not across them",
    lambda one, two, three: parallel(one, two) and not _square(one, three),
)
def _two_parallel_turns_and_a_slide(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """Only the slide moves the tip along the turns."""
    one, two, three = arm.axes
    p, a, b, h = arm.p, arm.a, plus(arm.b, arm.c), one.direction
    d = dot(h, minus(p, plus(a, b))) / dot(h, three.direction)
    v = plus(b, scaled(d, three.direction))
    yield from in_a_plane((one, two), a, v, p, branch.with_position(three.joint, d), at)


@_structure(
    "RPR",
    "axes {0} and {2} are parallel, and axis {1} is not across them",
    lambda one, two, three: parallel(one, three) and not _square(one, two),
)
def _a_slide_between_parallel_turns(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    one, two, three = arm.axes
    p, a, c, h = arm.p, plus(arm.a, arm.b), arm.c, one.direction
    d = dot(h, minus(p, plus(a, c))) / dot(h, two.direction)
    out = plus(a, scaled(d, two.direction))
    yield from in_a_plane((one, three), out, c, p, branch.with_position(two.joint, d), at)


@_structure(
    "RPR",
    "axis {1} is across axis {0}, and axis {2} is not parallel to axis {0}",
    lambda one, two, three: _square(one, two) and not parallel(one, three),
)
def _a_slide_across_a_turn(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """The third joint alone moves the tip along the first axis."""
    one, two, three = arm.axes
    p, a, c, h = arm.p, plus(arm.a, arm.b), arm.c, one.direction
    for folded in branch.with_each(three.joint, at.reach(three, c, h, dot(h, minus(p, a)), 1)):
        w = plus(a, folded.outward(three, c))
        flat_w, flat_p = across(h, w), across(h, p)
        slide = at.slide(dot(flat_w, two.direction), _norm(flat_w) - _norm(flat_p))
        for out in folded.with_each(two.joint, slide):
            v = plus(flat_w, scaled(out.positions[two.joint], two.direction))
            yield out.with_answer(one.joint, at.onto(one, v, flat_p, 2))


@_structure(
    "RPP",
    "axis {0} is not across both others, and these are not parallel",
    lambda one, two, three: not parallel(two, three) and not (_square(one, two) and _square(one, three)),
)
def _a_turn_and_two_slides(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """The turn brings the place into the plane of the slides."""
    one, two, three = arm.axes
    p, a = arm.p, plus(arm.a, arm.b, arm.c)
    n = cross(two.direction, three.direction)
    n = scaled(1 / real_root(dot(n, n)), n)
    for facing in branch.with_each(one.joint, at.reach(one, n, p, dot(n, a), 1)):
        yield slid(facing, two, three, minus(facing.inward(one, p), a))


def slid(branch: Branch, one: Axis, two: Axis, w: Vector) -> Branch:
    """``branch`` with two slides that are not parallel, the sum of which is nearest to ``w``."""
    x, y, cosine = dot(w, one.direction), dot(w, two.direction), dot(one.direction, two.direction)
    share = 1 / (1 - cosine * cosine)
    branch = branch.with_position(one.joint, share * (x - cosine * y))
    return branch.with_position(two.joint, share * (y - cosine * x))


@_structure(
    "PRP",
    "axes {0} and {1} are parallel, and axis {2} is across them",
    lambda one, two, three: parallel(one, two) and not parallel(two, three),
)
def _a_turn_along_a_slide(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """A cylinder."""
    one, two, three = arm.axes
    p, b, h = minus(arm.p, arm.a), plus(arm.b, arm.c), two.direction
    flat_b, flat_k, flat_p = (across(h, v) for v in (b, three.direction, p))
    share = 1 / _norm(flat_k)
    slide = at.slide(share * dot(flat_b, flat_k), share * (_norm(flat_b) - _norm(flat_p)))
    for out in branch.with_each(three.joint, slide):
        v = plus(b, scaled(out.positions[three.joint], three.direction))
        d = dot(h, minus(p, v)) * dot(h, one.direction)
        yield out.with_position(one.joint, d).with_answer(two.joint, at.onto(two, across(h, v), flat_p, 2))


@_structure(
    "PPP",
    "the axes are not in one plane",
    lambda u, v, w: abs(float(dot(u.direction, cross(v.direction, w.direction)))) > TOLERANCE,
)
def _three_slides(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    p = minus(arm.p, plus(arm.a, arm.b, arm.c))
    u, v, w = (axis.direction for axis in arm.axes)
    volume = dot(u, cross(v, w))
    for axis, side in zip(arm.axes, (cross(v, w), cross(w, u), cross(u, v)), strict=True):
        branch = branch.with_position(axis.joint, dot(scaled(1 / volume, side), p))
    yield branch
