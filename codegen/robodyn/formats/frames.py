"""A chain of joint axes in any direction as a description: modified DH frames, a base and a tool.

Each axis becomes the z axis of its link's frame. Two freedoms are left at every joint: where on its axis the
frame's origin stands, and how the frame is turned about it. They are chosen so that numbers vanish: x is
perpendicular to this axis and the next, the origin is where their common normal begins, and where axes are
parallel (any common normal is one) where an offset ``d`` is zero. Of axes that are nearly parallel the
common normal lies far away: the origin stays near the arm, and the row has an offset ``b`` more. So it has
between parallel axes, if the common normal is oblique to the frame before.

Joint coordinates, their zeros and the torques are those of the chain; the pose of the tool in the world too.

Source: Craig, Introduction to Robotics, section 3.4; of nearly parallel axes Hayati and Mirmirani 1985, where
a turn about y takes the place of ``b``.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from robodyn.formats.chain import IDENTITY, Chain, ChainJoint, Rotation, onto
from robodyn.formats.conversion import effects_of_springs
from robodyn.formats.limits import SLIDE, STEEP
from robodyn.robot.model import Inertia, Joint, Link, Robot
from robodyn.robot.numbers import shortest
from robodyn.robot.parts import Exact, JointKind, Rows
from robodyn.robot.rotations import (
    NOTHING,
    QUARTER_TURN,
    SAME,
    about_x,
    about_z,
    applied,
    direction,
    placement,
    product,
    summed,
    tidy,
    turned_tensor,
    twist_of,
)
from robodyn.robot.rotations import transposed as exact_transposed
from robodyn.robot.values import ZERO, Angle, quarter_turns


def vector(u: tuple[float, float, float]) -> Exact:
    """The decimals of ``u``."""
    x, y, z = map(shortest, u)
    return x, y, z


def rows(rotation: Rotation) -> Rows:
    """The entries of ``rotation``, whole where it turns axes into axes."""
    if rotation == IDENTITY:
        return SAME
    squared = all(abs(entry - round(entry)) <= QUARTER_TURN for row in rotation for entry in row)
    x, y, z = (tuple(Fraction(round(entry) if squared else entry) for entry in row) for row in rotation)
    return x, y, z  # type: ignore[return-value]


@dataclass(frozen=True, slots=True)
class Step:
    """From the aligned frame of a joint (of the base, for the first) to that of the next, at q = 0.

    ``rotation`` and ``offset`` [m] place the frame in the one before; ``into`` takes vectors of the joint's
    own frame, as the chain has it, into the aligned one, whose origin is ``shift`` [m] away from the chain's.
    """

    rotation: Rows
    offset: Exact
    into: Rows
    shift: Exact = (ZERO, ZERO, ZERO)

    def seen(self, point: Exact) -> Exact:
        """A point of the joint's own frame in the aligned one [m]."""
        return _plus(applied(self.into, point), self.shift, -1)


def aligned(joints: Iterable[ChainJoint]) -> list[Step]:
    """The steps of ``joints``, base to tip."""
    steps = []
    before = SAME
    for joint in joints:
        into = exact_transposed(rows(onto(joint.axis)))
        turn = product(product(before, rows(joint.pose.rotation)), exact_transposed(into))
        steps.append(Step(turn, applied(before, vector(joint.pose.xyz)), into))
        before = into
    return steps


def with_free_lines(steps: Sequence[Step], kinds: Sequence[JointKind]) -> list[Step]:
    """``steps`` with the lines of prismatic joints put where they save offsets; any parallel line serves.

    A line goes through the next origin, so that the next row has no offset across it; behind the last joint
    that turns there is none to go through, and lines go through the origin before.
    """
    moved = list(steps)
    last = max((i for i, kind in enumerate(kinds) if kind == "revolute"), default=-1)
    for i in reversed(range(last)):
        if kinds[i] == "prismatic":
            x, y, _ = moved[i + 1].offset
            _shift(moved, i, (x, y, ZERO))
    for i in range(max(last + 1, 1), len(moved)):
        x, y, z = applied(exact_transposed(moved[i].rotation), moved[i].offset)
        _shift(moved, i, (-x, -y, -z))
    return moved


def _shift(steps: list[Step], i: int, by: Exact) -> None:
    """Move the origin of frame ``i`` by a vector in it."""
    step = steps[i]
    steps[i] = replace(step, offset=_plus(step.offset, applied(step.rotation, by)), shift=by)
    if i + 1 < len(steps):
        steps[i + 1] = replace(steps[i + 1], offset=_plus(steps[i + 1].offset, by, -1))


def _plus(u: Exact, v: Exact, sign: int = 1) -> Exact:
    """``u + v``, or with ``sign`` -1 their difference."""
    return u[0] + sign * v[0], u[1] + sign * v[1], u[2] + sign * v[2]


_NONE, _HALF = quarter_turns(0), quarter_turns(2)


@dataclass(slots=True)
class _Row:
    """What leads from a frame to the next one: ``phi`` turns the frame before about its own z beforehand.
    ``slide`` [m] is how far the row's own origin stands along its axis from where the chain has it."""

    phi: Angle
    alpha: Angle
    a: Fraction
    b: Fraction
    d: Fraction
    theta: Angle
    slide: Fraction = ZERO


def description_of(chain: Chain, snap: float = 0.0) -> Robot:
    """The description of ``chain``; angles of axes within ``snap`` [rad] of a multiple of pi/2 become it.

    Links have the names of their joints. No offset is longer than twice the sum of the distances between the
    chain's frames.
    """
    within = max(snap, QUARTER_TURN)
    steps = aligned(chain.joints)
    reaches = [step.offset for step in steps[1:]] + [steps[-1].seen(vector(chain.tool.xyz))]
    size = sum(math.hypot(*each) for each in reaches) or 1.0
    steps = with_free_lines(steps, [joint.kind for joint in chain.joints])
    turn, origin, first = _base(steps[0], within)
    table = [first]
    for step in steps[1:]:
        table.append(_row(step, table[-1].theta, size, within))
    _slide(table, size)
    # How each frame is turned about its own z, for the row after it.
    ends = [row.phi for row in table[1:]] + [_undone(table[-1].theta)]
    if turn != SAME:  # the base frame is free: the first row leads nowhere
        origin = _plus(origin, applied(turn, (ZERO, ZERO, first.d)))
        first.d = ZERO
        if ends[0].quarter is not None:
            turn, first.theta = product(turn, about_z(ends[0])), -ends[0]
    links = [_link(*parts, size) for parts in zip(chain.joints, steps, table, ends, strict=True)]
    ground = rows(chain.base.rotation)
    base = _plus(vector(chain.base.xyz), applied(ground, origin))
    last = about_z(-ends[-1])
    tool = product(last, product(steps[-1].into, rows(chain.tool.rotation)))
    x, y, z = applied(last, steps[-1].seen(vector(chain.tool.xyz)))
    return Robot(
        chain.name,
        tuple(links),
        chain.title,
        chain.source,
        gravity=vector(chain.gravity),
        effects=effects_of_springs(joint.spring for joint in chain.joints),
        base=placement(product(ground, turn), base, size, within),
        tool=placement(tool, (x, y, z - table[-1].slide), size, within),
        couplings=chain.couplings,
    )


def _base(step: Step, within: float) -> tuple[Rows, Exact, _Row]:
    """The base frame in that of the chain, and the row from it to the first joint. It is only shifted where
    the first axis is parallel to its z axis, and else is the first joint's own."""
    twist = twist_of(step.rotation, within)
    if not twist.parallel:
        return step.rotation, step.offset, _Row(_NONE, _NONE, ZERO, ZERO, ZERO, _NONE)
    x, y, z = step.offset
    way = twist.alpha.cos
    return SAME, (x, y, ZERO), _Row(_NONE, twist.alpha, ZERO, ZERO, way * z, twist.theta)


def _row(step: Step, before: Angle, size: float, within: float) -> _Row:
    """The row of a joint; ``before`` is the angle theta of the row before so far.

    Turning x the other way exchanges the signs of alpha and a: what leaves the smaller theta is taken.
    """
    twist = twist_of(step.rotation, within)
    phi, alpha, theta = twist.phi, twist.alpha, twist.theta
    if twist.parallel:
        x, y = (ZERO if abs(e) <= NOTHING * size else e for e in step.offset[:2])
        phi = direction(x, y, QUARTER_TURN) if x or y else _undone(before)
        if before.quarter is not None and phi.quarter is None:
            phi = _undone(before)  # across an oblique offset: b and a cost less than two angles theta
        theta = summed(theta, -phi if alpha.cos > 0 else phi)
    other = summed(phi, _HALF)
    if abs(summed(before, other).radians) < abs(summed(before, phi).radians):
        phi, alpha, theta = other, alpha if twist.parallel else -alpha, summed(theta, _HALF)
    a, b, d = applied(about_x(-alpha), applied(about_z(-phi), step.offset))
    return _Row(phi, alpha, a, b, d, theta)


def _slide(table: Sequence[_Row], size: float) -> None:
    """Origins slid along their axes: to the common normal with the next axis where that is near, else so that
    an offset ``d`` vanishes: the next one, or where the axes before are not parallel that before it, since
    between parallel axes an offset costs less. The last one slides so that its own ``d`` does."""
    for i in reversed(range(1, len(table))):
        row, before = table[i], table[i - 1]
        c, s = row.alpha.cos, row.alpha.sin
        normal, further = _normal(row, size), _normal(before, size) if i > 1 else None
        if normal is not None:
            before.slide, row.b = normal, ZERO
        else:
            along = None if further is None else further * before.alpha.cos - before.d
            before.slide = (row.d + row.slide) / c if along is None else along
            row.b -= before.slide * s
        if i == len(table) - 1:
            row.slide = before.slide * c - row.d
        row.d += row.slide - before.slide * c
    table[0].d += table[0].slide


def _normal(row: _Row, size: float) -> Fraction | None:
    """How far along the axis before a row its common normal with the row's is [m]; None: too far, or any."""
    s = row.alpha.sin
    normal = row.b / s if s else None
    return normal if normal is not None and (abs(s) >= STEEP or abs(normal) <= SLIDE * size) else None


def _link(joint: ChainJoint, step: Step, row: _Row, end: Angle, size: float) -> Link:
    """The link of ``joint``, whose frame is turned by ``end`` about its z axis in the end."""
    body, turn = joint.body, product(about_z(-end), step.into)
    com = vector(body.com)
    trace = math.fsum(map(abs, body.inertia[:3]))
    entries = [tidy(e, trace) for e in turned_tensor(turn, tuple(map(shortest, body.inertia)))]
    if body.mass or any(com):  # a link without mass has no centre: do not invent one
        x, y, z = applied(about_z(-end), step.seen(com))
        com = (x, y, z - row.slide)
    x, y, z = (tidy(e, size) for e in com)
    a, b, d = (tidy(e, size) for e in (row.a, row.b, row.d))
    frame = Joint(
        joint.kind,
        row.alpha,
        a,
        d,
        summed(row.theta, end),
        shortest(joint.motor_inertia),
        shortest(joint.viscous),
        shortest(joint.coulomb),
        joint.limits,
        joint.gear,
        b,
    )
    return Link(joint.name, frame, shortest(body.mass), (x, y, z), Inertia(*entries), origins=joint.origins)


def _undone(turn: Angle) -> Angle:
    """What takes a turn by quarters back; nothing where it is another, since it would cost digits."""
    return -turn if turn.quarter is not None else _NONE
