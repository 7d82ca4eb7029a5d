"""Arms that are nearly of a class: axes a little aside, so that they are parallel and meet.

A description that has 1.5708 for a quarter turn, or was calibrated, has axes that miss each other by some
micrometres. Where they would be without that is where its branches begin; what was neglected is made up for
by steps towards the pose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from robodyn.dynamics.inverse.limits import ALMOST, TOLERANCE
from robodyn.dynamics.inverse.lines import distance, feet, nearest, one_way, slope
from robodyn.dynamics.inverse.screws import Axis, Chain, minus
from robodyn.dynamics.inverse.subproblems import real_root
from robodyn.dynamics.vectors import Vector, dot, scaled

#: Digits behind the point of what is moved [m].
_DIGITS = 15


def idealised(chain: Chain, size: Fraction) -> tuple[Chain, tuple[str, ...]]:
    """``chain``, of exact numbers, with axes parallel that are to within :data:`ALMOST`, and meeting those
    before them that they miss by no more than that as a share of ``size`` [m]; and what was neglected, a
    sentence each, the most of each kind."""
    axes: list[Axis] = []
    turned = missed = 0.0
    meeting: Vector | None = None
    for axis in chain.axes:
        moved = replace(axis, direction=_direction(axis.direction, axes))
        turned = max(turned, slope(axis, moved))
        point = _meeting(axes[-1], moved, meeting, ALMOST * float(size)) if axes else None
        if point is not None:
            missed = max(missed, distance(moved, point))
            moved = replace(moved, point=point)
        axes.append(moved)
        meeting = point
    neglected = []
    if turned > TOLERANCE:
        neglected.append(f"axes are up to {turned:.1e} rad from where that holds")
    if missed > TOLERANCE * float(size):
        neglected.append(f"axes miss each other by up to {1000 * missed:.2g} mm where they have to meet")
    return replace(chain, axes=tuple(axes)), tuple(neglected)


def _direction(direction: Vector, before: Sequence[Axis]) -> Vector:
    """``direction``, or that of an axis before it that is nearly parallel; what is nearly 0 of it is 0."""
    for axis in before:
        along = dot(axis.direction, direction)
        aside = minus(direction, scaled(along, axis.direction))
        if float(dot(aside, aside)) <= ALMOST**2:
            return scaled(1 if along > 0 else -1, axis.direction)
    x, y, z = (Fraction(0) if abs(u) <= ALMOST else u for u in direction)
    if (x, y, z) == direction:
        return direction
    length = real_root(x * x + y * y + z * z)
    return x / length, y / length, z / length


def _meeting(before: Axis, axis: Axis, meeting: Vector | None, near: float) -> Vector | None:
    """Where ``axis`` nearly meets the one ``before`` it [m], if it does: best where that meets its own."""
    if one_way(before, axis):
        return None
    if meeting is not None and distance(axis, meeting) <= near:
        return meeting
    foot, _ = feet(before, axis)
    if distance(axis, foot) > near:
        return None
    x, y, z = (Fraction(round(u, _DIGITS)) for u in foot)
    # Rounded along the axis before, so that it stays on it.
    return nearest(before, (x, y, z))
