"""Three axes through a point, or that act on directions as if they were: the angles of a rotation."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from robodyn.dynamics.inverse.branch import Branch, Setting
from robodyn.dynamics.inverse.screws import Axis
from robodyn.dynamics.inverse.subproblems import lever_of, real_root
from robodyn.dynamics.vectors import Vector, dot

#: A rotation as what it does to a vector.
Rotation = Callable[[Vector], Vector]


def oriented(
    axes: tuple[Axis, Axis, Axis], rotation: Rotation, marker: Vector, branch: Branch, at: Setting
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
    for one in branch.each(first.joint, at.reach(first, second.direction, pointing, along)):
        rest = one.inward(first, pointing)
        lever = lever_of(second.direction, third.direction)
        two = one.one(second.joint, at.onto(second, third.direction, rest, lever=lever))
        marked = two.inward(second, two.inward(first, sideways))
        yield two.one(third.joint, at.onto(third, marker, marked, lever=1))


def marker_of(axis: Axis) -> Vector:
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
