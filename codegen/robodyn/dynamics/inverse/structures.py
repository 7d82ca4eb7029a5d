"""What three axes have to be like for each way to place a point, and where their points are best."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from robodyn.dynamics.inverse import places
from robodyn.dynamics.inverse.limits import TOLERANCE
from robodyn.dynamics.inverse.lines import distance, feet, nearest, slope
from robodyn.dynamics.inverse.places import Solver
from robodyn.dynamics.inverse.screws import Axis, minus
from robodyn.dynamics.vectors import Vector, cross, dot

Axes = tuple[Axis, Axis, Axis]
Points = dict[int, Vector]


@dataclass(frozen=True, slots=True)
class Structure:
    """A way to place a point by three joints.

    ``kinds``: ``R`` and ``P`` by joint. ``applies``: whether three axes in floats, through the points chosen,
    are as the way needs them; lengths there are shares of the arm's size. ``points``: the points, of exact
    axes. ``words``: what is needed, with ``{0} {1} {2}`` in the joints' places.
    """

    words: str
    kinds: str
    applies: Callable[[Axes], bool]
    points: Callable[[Axes], Points]
    solve: Solver


def parallel(one: Axis, other: Axis) -> bool:
    """Whether two axes are parallel to within the tolerance."""
    return slope(one, other) <= TOLERANCE


def crossing(one: Axis, other: Axis) -> bool:
    """Whether two axes meet in their points and are not parallel."""
    u = minus(one.point, other.point)
    return float(dot(u, u)) ** 0.5 <= TOLERANCE and not parallel(one, other)


def square(one: Axis, other: Axis) -> bool:
    """Whether two axes are perpendicular."""
    return abs(float(dot(one.direction, other.direction))) <= TOLERANCE


def through(axes: tuple[Axis, ...], point: Vector) -> bool:
    """Whether all ``axes`` go through ``point``."""
    return all(distance(axis, point) <= TOLERANCE for axis in axes)


def _at_the_elbow(axes: Axes) -> Points:
    """Where the first two axes are nearest to each other, and on the third what is nearest to that."""
    one, two, three = axes
    first, second = feet(one, two)
    return {one.joint: first, two.joint: second, three.joint: nearest(three, second)}


def _independent(one: Axis, two: Axis, three: Axis) -> bool:
    return abs(float(dot(one.direction, cross(two.direction, three.direction)))) > TOLERANCE


STRUCTURES = (
    Structure(
        "axes {1} and {2} are parallel, and axis {0} is not",
        "RRR",
        lambda axes: parallel(axes[1], axes[2]) and not parallel(axes[0], axes[1]),
        _at_the_elbow,
        places.second_and_third_parallel,
    ),
    Structure(
        "axes {0} and {1} meet, and axis {2} is not parallel to axis {1}",
        "RRR",
        lambda axes: crossing(axes[0], axes[1]) and not parallel(axes[1], axes[2]),
        _at_the_elbow,
        places.first_and_second_meet,
    ),
    Structure(
        "axes {0} and {1} meet",
        "RRP",
        lambda axes: crossing(axes[0], axes[1]),
        _at_the_elbow,
        places.two_turns_and_a_slide_that_meet,
    ),
    Structure(
        "axes {0} and {1} are parallel, and axis {2} is not across them",
        "RRP",
        lambda axes: parallel(axes[0], axes[1]) and not square(axes[0], axes[2]),
        _at_the_elbow,
        places.two_parallel_turns_and_a_slide,
    ),
    Structure(
        "axes {0} and {2} are parallel, and axis {1} is not across them",
        "RPR",
        lambda axes: parallel(axes[0], axes[2]) and not square(axes[0], axes[1]),
        _at_the_elbow,
        places.a_slide_between_parallel_turns,
    ),
    Structure(
        "axis {1} is across axis {0}, and axis {2} is not parallel to axis {0}",
        "RPR",
        lambda axes: square(axes[0], axes[1]) and not parallel(axes[0], axes[2]),
        _at_the_elbow,
        places.a_slide_across_a_turn,
    ),
    Structure(
        "axis {0} is not across both others, and these are not parallel",
        "RPP",
        lambda axes: (
            not parallel(axes[1], axes[2]) and not (square(axes[0], axes[1]) and square(axes[0], axes[2]))
        ),
        _at_the_elbow,
        places.a_turn_and_two_slides,
    ),
    Structure(
        "axes {0} and {1} are parallel, and axis {2} is across them",
        "PRP",
        lambda axes: parallel(axes[0], axes[1]) and not parallel(axes[1], axes[2]),
        _at_the_elbow,
        places.a_turn_along_a_slide,
    ),
    Structure(
        "the axes are not in one plane",
        "PPP",
        lambda axes: _independent(*axes),
        _at_the_elbow,
        places.three_slides,
    ),
)
