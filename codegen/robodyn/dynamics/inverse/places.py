"""Where three joints bring a point: the positions of the first three joints of an arm, or of its last three.

``point = S1 S2 S3 tip``. Each way applies to arms of some structure; all are written in terms of points on
the axes that suit it: ``p`` from the first axis to the point, ``a`` from the first to the second, ``b`` from
the second to the third, ``c`` from there to the tip at rest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from robodyn.dynamics.inverse.branch import Branch, Setting
from robodyn.dynamics.inverse.screws import Axis, across, minus, opposite, turned
from robodyn.dynamics.inverse.subproblems import chosen, is_number, lever_of, real_root
from robodyn.dynamics.vectors import Vector, cross, dot, plus, scaled
from robodyn.effects.scalars import choose


@dataclass(frozen=True, slots=True)
class Reach:
    """Three axes, the tip that they move at rest, and where it is to be [m]."""

    axes: tuple[Axis, Axis, Axis]
    tip: Vector
    place: Vector

    @property
    def p(self) -> Vector:
        """From the first axis to the place."""
        return minus(self.place, self.axes[0].point)

    @property
    def a(self) -> Vector:
        """From the first axis to the second."""
        return minus(self.axes[1].point, self.axes[0].point)

    @property
    def b(self) -> Vector:
        """From the second axis to the third."""
        return minus(self.axes[2].point, self.axes[1].point)

    @property
    def c(self) -> Vector:
        """From the third axis to the tip."""
        return minus(self.tip, self.axes[2].point)


#: A way to place a point, with all its branches, of the branch that it starts from.
Solver = Callable[[Reach, Branch, Setting], Iterator[Branch]]


def _square(u: Vector) -> Any:
    return dot(u, u)


# --- three revolute joints ----------------------------------------------------------------------------------


def second_and_third_parallel(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """The second and third axes are parallel: the first turns the place as far along them as the tip is; then
    there are two links in a plane."""
    one, two, three = arm.axes
    for shoulder, w in shoulders(
        one, two.direction, arm.p, dot(two.direction, plus(arm.a, arm.b, arm.c)), branch, at
    ):
        yield from in_a_plane((two, three), arm.b, arm.c, minus(w, arm.a), shoulder, at)


def shoulders(
    one: Axis, along: Vector, p: Vector, distance: Any, branch: Branch, at: Setting
) -> Iterator[tuple[Branch, Vector]]:
    """The two positions of a revolute joint from behind which ``p`` is ``distance`` along ``along``, and
    ``p`` as it is seen from there."""
    ways = at.reach(one, along, p, distance, 1)
    cosine = dot(one.direction, along)
    for sign, shoulder in zip((-1, 1), branch.each(one.joint, ways), strict=True):
        if not is_number(cosine) or cosine:
            yield shoulder, shoulder.inward(one, p)
            continue
        # Three directions at right angles: what is along the axis stays, and the others are known.
        sideways = scaled(sign * ways.side, cross(one.direction, along))
        height = scaled(dot(one.direction, p), one.direction)
        yield shoulder, plus(scaled(distance - ways.beyond, along), height, sideways)


def first_and_second_meet(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """The first and second axes meet in their points: the third brings the tip as far from there as the place
    is; then there are two axes through a point."""
    one, two, three = arm.axes
    p, b, c = arm.p, arm.b, arm.c
    for folded in branch.each(three.joint, at.fold(three, b, c, _square(p))):
        v = plus(b, folded.outward(three, c))
        yield from through_a_point((one, two), v, p, folded, at)


def in_a_plane(
    axes: tuple[Axis, Axis], b: Vector, c: Vector, u: Vector, branch: Branch, at: Setting
) -> Iterator[Branch]:
    """Two parallel revolute axes with ``u = R1 (b + R2 c)``, but for what is along them."""
    one, two = axes
    b, c, u = (across(one.direction, v) for v in (b, c, u))
    lever = lever_of(one.direction, b) - lever_of(one.direction, c)
    for folded in branch.each(two.joint, at.fold(two, b, c, _square(u))):
        v = plus(b, folded.outward(two, c))
        yield folded.one(one.joint, at.onto(one, v, u, 2, lever=lever))


def through_a_point(
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
    longer = _square(across(k, v)) - _square(across(h, onto))
    # Of a pose out of reach both miss the same; how far off it is shows where the lever is short.
    exist = choose(longer, by_first.exist, by_second.exist)
    for sign, start, other in zip((1, -1), by_first.answers, by_second.answers, strict=True):
        last = at.onto(two, v, turned(h, opposite(start), onto), 2)
        before = at.onto(one, turned(k, other, v), onto, 2)
        meet = choose(longer, by_second.meet, by_first.meet)
        first = chosen(longer, start, before.answer)
        yield branch.sided(one.joint, sign, first, exist, meet).known(
            two.joint, chosen(longer, last.answer, other)
        )


# --- with prismatic joints ----------------------------------------------------------------------------------


def two_turns_and_a_slide_that_meet(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """Revolute, revolute, prismatic, the first two axes meeting in their points, as in the Stanford arm: the
    slide brings the tip as far from there as the place is."""
    one, two, three = arm.axes
    p, b, h = arm.p, plus(arm.b, arm.c), three.direction
    for out in branch.each(three.joint, at.slide(dot(b, h), _square(b) - _square(p))):
        v = plus(b, scaled(out.positions[three.joint], h))
        yield from through_a_point((one, two), v, p, out, at)


def two_parallel_turns_and_a_slide(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """Revolute, revolute, prismatic, the first two axes parallel: only the slide moves the tip along them."""
    one, two, three = arm.axes
    p, a, b, h = arm.p, arm.a, plus(arm.b, arm.c), one.direction
    d = dot(h, minus(p, plus(a, b))) / dot(h, three.direction)
    v = plus(b, scaled(d, three.direction))
    yield from in_a_plane((one, two), a, v, p, branch.known(three.joint, d), at)


def a_slide_between_parallel_turns(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """Revolute, prismatic, revolute, the first and third axes parallel, the slide not across them."""
    one, two, three = arm.axes
    p, a, c, h = arm.p, plus(arm.a, arm.b), arm.c, one.direction
    d = dot(h, minus(p, plus(a, c))) / dot(h, two.direction)
    out = plus(a, scaled(d, two.direction))
    yield from in_a_plane((one, three), out, c, p, branch.known(two.joint, d), at)


def a_slide_across_a_turn(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """Revolute, prismatic, revolute, the slide across the first axis: the third joint alone moves the tip
    along that."""
    one, two, three = arm.axes
    p, a, c, h = arm.p, plus(arm.a, arm.b), arm.c, one.direction
    for folded in branch.each(three.joint, at.reach(three, c, h, dot(h, minus(p, a)), 1)):
        w = plus(a, folded.outward(three, c))
        flat_w, flat_p = across(h, w), across(h, p)
        slide = at.slide(dot(flat_w, two.direction), _square(flat_w) - _square(flat_p))
        for out in folded.each(two.joint, slide):
            v = plus(flat_w, scaled(out.positions[two.joint], two.direction))
            yield out.one(one.joint, at.onto(one, v, flat_p, 2))


def a_turn_and_two_slides(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """Revolute, prismatic, prismatic: the first brings the place into the plane of the slides."""
    one, two, three = arm.axes
    p, a, h, k = arm.p, plus(arm.a, arm.b, arm.c), two.direction, three.direction
    n = cross(h, k)
    length = real_root(dot(n, n))
    n = scaled(1 / length, n)
    for facing in branch.each(one.joint, at.reach(one, n, p, dot(n, a), 1)):
        w = minus(facing.inward(one, p), a)
        x, y, cosine = dot(w, h), dot(w, k), dot(h, k)
        share = 1 / (1 - cosine * cosine)
        out = facing.known(two.joint, share * (x - cosine * y))
        yield out.known(three.joint, share * (y - cosine * x))


def a_turn_along_a_slide(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """Prismatic, revolute, prismatic, the first two along each other, the third not: a cylinder."""
    one, two, three = arm.axes
    p, b, h = minus(arm.p, arm.a), plus(arm.b, arm.c), two.direction
    flat_b, flat_k, flat_p = (across(h, v) for v in (b, three.direction, p))
    share = 1 / _square(flat_k)
    slide = at.slide(share * dot(flat_b, flat_k), share * (_square(flat_b) - _square(flat_p)))
    for out in branch.each(three.joint, slide):
        v = plus(b, scaled(out.positions[three.joint], three.direction))
        d = dot(h, minus(p, v)) * dot(h, one.direction)
        out = out.known(one.joint, d)
        yield out.one(two.joint, at.onto(two, across(h, v), flat_p, 2))


def three_slides(arm: Reach, branch: Branch, at: Setting) -> Iterator[Branch]:
    """Three prismatic joints."""
    p = minus(arm.place, arm.tip)
    u, v, w = (axis.direction for axis in arm.axes)
    volume = dot(u, cross(v, w))
    for axis, side in zip(arm.axes, (cross(v, w), cross(w, u), cross(u, v)), strict=True):
        branch = branch.known(axis.joint, dot(scaled(1 / volume, side), p))
    yield branch
