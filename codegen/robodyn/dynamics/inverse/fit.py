"""How well joint positions fit a pose that has more to it than an arm of fewer than six joints can choose.

Such an arm reaches a pose only where all of it agrees, and then more equations hold than there are joints.
What follows from some of them is brought to what all together say by a step of least squares, and the place
by one more: where a pose does not fit, the tool has its place at least, but for the square of what is off.
What an arm whose axes are all parallel makes of a pose is known before: it is turned the least that brings an
axis upright, and then all equations agree.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from robodyn.dynamics.inverse.limits import BEGUN, FIT, REGULAR
from robodyn.dynamics.inverse.screws import Axis, Target, turned
from robodyn.dynamics.inverse.subproblems import Branch, Setting, both
from robodyn.dynamics.mass_matrix import Factored
from robodyn.dynamics.vectors import BASE, ZERO, Vector, cross, dot, inner, minus, plus, scaled
from robodyn.effects.scalars import arctangent, choose, root
from robodyn.ir.evaluate import Circle

#: Columns of a Jacobian or rows of a matrix.
Rows = list[list[Any]]


@dataclass(frozen=True, slots=True)
class Fit:
    """The joints of ``axes`` [n] bring the tool, at rest at ``tip`` [m] and along the axes of the base, to
    ``target``; with ``place_only`` however it is turned. ``at``: lengths count as shares of its size.
    ``near``: whether positions are those of a target that fits."""

    axes: Sequence[Axis]
    tip: Vector
    target: Target
    place_only: bool
    at: Setting
    near: bool = False

    def fitted(self, branch: Branch) -> Branch:
        """``branch`` nearer to the target, and whether it is there: all of it, and its place; ``off`` by what
        angle [rad]."""
        positions = branch.positions if self.near else self._nearer(branch.positions)
        way, axes = self._tool(positions)
        unit = FIT * self.at.unit
        placed = choose(unit * unit - dot(way, way), 1, 0)
        if self.place_only:
            return replace(branch, positions=positions, exists=placed, placed=placed)
        # Of a rotation by an angle these squares are eight times that of the sine of its half.
        gaps = [minus(u, v) for u, v in zip(axes, self._wanted(), strict=True)]
        square = sum(dot(gap, gap) for gap in gaps)
        off = 2 * arctangent(root(square), root(choose(8 - square, 8 - square, 0)))
        exists = both(placed, choose(2 * unit * unit - square, 1, 0))
        return replace(branch, positions=positions, exists=exists, placed=placed, off=off)

    def _wanted(self) -> list[Vector]:
        return [self.target.turned(unit) for unit in (BASE.x, BASE.y, BASE.z)]

    def _tool(self, positions: Mapping[int, Any]) -> tuple[Vector, list[Vector]]:
        """The way from the tool to where it is to be, as a share of the size, and the tool's axes."""
        place, axes = self.tip, [BASE.x, BASE.y, BASE.z]
        for axis in reversed(self.axes):
            position = positions[axis.joint]
            if axis.revolute:
                place = plus(axis.point, turned(axis.direction, position, minus(place, axis.point)))
                axes = [turned(axis.direction, position, u) for u in axes]
            else:
                place = plus(place, scaled(position, axis.direction))
        return scaled(1 / self.at.size, minus(self.target.placed(self.tip), place)), axes

    def _nearer(self, positions: Mapping[int, Any]) -> dict[int, Any]:
        """``positions`` after both steps, where they are near enough for that."""
        way, axes = self._tool(positions)
        places, turns = self._columns(positions)
        most, steps = dot(way, way), [0] * len(self.axes)
        if not self.place_only:
            sines = [cross(u, v) for u, v in zip(axes, self._wanted(), strict=True)]
            turn = scaled(Fraction(1, 2), plus(*sines))
            most = most + dot(turn, turn)
            columns = [[*u, *w] for u, w in zip(places, turns, strict=True)]
            steps = self._solved(columns, [inner(column, [*way, *turn]) for column in columns])
        rows = [list(row) for row in zip(*places, strict=True)]
        left = [x - inner(row, steps) for x, row in zip(way, rows, strict=True)]
        # What is but rounding would be made much of where joints hardly move the tool some way.
        amiss = choose(inner(left, left) - (REGULAR * self.at.unit) ** 2, 1, 0)
        shares = self._solved(rows, [choose(amiss, x, 0) for x in left])
        steps = [s + inner(column, shares) for s, column in zip(steps, places, strict=True)]
        near = choose(BEGUN**2 - most, 1, 0)
        return {
            axis.joint: self._stepped(axis, positions[axis.joint], choose(near, step, 0))
            for axis, step in zip(self.axes, steps, strict=True)
        }

    def _solved(self, rows: Rows, right: Sequence[Any]) -> list[Any]:
        """``x`` with ``(A A^T) x = right`` of the ``rows`` of ``A``, damped by what is rounding."""
        matrix = [[inner(u, v) for v in rows] for u in rows]
        for k, row in enumerate(matrix):
            row[k] = row[k] + REGULAR * self.at.unit
        return Factored(matrix).solve(right)

    def _columns(self, positions: Mapping[int, Any]) -> tuple[Rows, Rows]:
        """How the tool moves, as shares of the size, and turns with each joint, seen from before all."""
        places: Rows = []
        turns: Rows = []
        tip = self.tip
        for axis in reversed(self.axes):
            position, h = positions[axis.joint], axis.direction
            if axis.revolute:
                lever = minus(tip, axis.point)
                places = [list(turned(h, position, tuple(u))) for u in places]
                turns = [list(turned(h, position, tuple(u))) for u in turns]
                lever = turned(h, position, lever)
                places.insert(0, list(scaled(1 / self.at.size, cross(h, lever))))
                turns.insert(0, list(h))
                tip = plus(axis.point, lever)
            else:
                places.insert(0, list(h))
                turns.insert(0, list(ZERO))
                tip = plus(tip, scaled(position, h))
        return places, turns

    def _stepped(self, axis: Axis, position: Any, step: Any) -> Any:
        """``position`` a little further; lengths by a share of the size."""
        if not axis.revolute:
            return position + self.at.size * step
        c, s = position
        length = 1 / root(1 + step * step)
        turned_on: Circle = (length * (c - step * s), length * (s + step * c))
        return turned_on


def upright(target: Target, along: Vector) -> Target:
    """``target`` turned the least that leaves the direction ``along`` as it is; the tool's place stays."""
    now = target.turned(along)
    axis, cosine = cross(now, along), dot(now, along)
    share = 1 / choose(1 + cosine, 1 + cosine, 1)

    def brought(v: Vector) -> Vector:
        beside = cross(axis, v)
        return plus(v, beside, scaled(share, cross(axis, beside)))

    x, y, z = zip(*map(brought, zip(*target.rows, strict=True)), strict=True)
    return Target((x, y, z), target.start, target.end)
