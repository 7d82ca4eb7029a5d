"""Mass matrix by composite bodies, and forward dynamics by factoring it; over any scalar.

Sources: Walker and Orin 1982 (composite rigid bodies); Featherstone 2008, chapter 6.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from robodyn.dynamics.arm import about_x, about_z
from robodyn.dynamics.lump import NO_LUMP
from robodyn.dynamics.parallel import reaches
from robodyn.dynamics.regroup import about_axis_x, about_axis_z, merged, shifted
from robodyn.dynamics.state import Moving
from robodyn.dynamics.vectors import Mark, Vector, cross, named, plus, unmarked
from robodyn.effects.scalars import is_zero, quotient
from robodyn.ir.program import Label


def mass_matrix(at: Moving, mark: Mark = unmarked) -> list[list[Any]]:
    """Mass matrix [n, n] (kg m^2, kg m, kg), rotor inertias on its diagonal.

    Composite bodies, forces and moments are along the axes in which a joint (or its chain) begins to
    turn: the turn leaves the joint's own axis where it is.
    """
    arm, turns, n = at.arm, at.turns, len(at.arm.bodies)
    matrix: list[list[Any]] = [[0] * n for _ in range(n)]
    reach = reaches(arm, at.motion, turns)
    composite = NO_LUMP
    for j in reversed(range(n)):
        body, c, s = arm.bodies[j], turns.c[j], turns.s[j]
        here, further = at.lumps[j], NO_LUMP
        if j + 1 < n:
            child = arm.bodies[j + 1]
            further = shifted(about_axis_x(composite, child.cos_alpha, child.sin_alpha), reach[j])
            if not turns.follows[j + 1]:
                here, further = merged(here, further), NO_LUMP
        # Inertia about the joint's axis, which the turn does not change.
        about_axis = (here.second.xx + here.second.yy) + (further.second.xx + further.second.yy)
        composite = merged(about_axis_z(here, c, s), further).named(mark, j + 1)
        (x, y, _), k = composite.first, composite.second
        # Force and moment that a unit acceleration of joint j alone needs, about the frame's origin.
        if body.revolute:
            f: Vector = (-y, x, 0)
            moment: Vector = (-k.xz, -k.yz, about_axis)
            own = moment[2]
        else:
            f = (0, 0, composite.mass)
            moment = (y, -x, 0)
            own = f[2]
        if not is_zero(body.motor_inertia):
            own = own + body.motor_inertia
        matrix[j][j] = mark(own, Label(j + 1, "m", str(j + 1)))
        for i in reversed(range(j)):
            child = arm.bodies[i + 1]
            f, moment = (about_x(child.cos_alpha, child.sin_alpha, u) for u in (f, moment))
            moment = plus(moment, cross(reach[i], f))
            value = moment[2] if arm.bodies[i].revolute else f[2]
            matrix[i][j] = matrix[j][i] = mark(value, Label(i + 1, "m", str(j + 1)))
            if not turns.follows[i + 1]:
                f, moment = (about_z(turns.c[i], turns.s[i], u) for u in (f, moment))
            f = named(mark, f, i + 1, "fu")
            moment = named(mark, moment, i + 1, "nu")
    return matrix


class Factored:
    """A positive definite matrix [n, n] as ``U D U^T``; n divisions at most, no square root.

    ``matrix`` is read on and below its diagonal. Joints are eliminated from tip to base: near the tip a mass
    matrix has its zeros and numbers, and a number divides when the program is written. ``pivots`` [n]: what
    is on the diagonal of D, from tip to base.
    """

    def __init__(self, matrix: Sequence[Sequence[Any]], mark: Mark = unmarked) -> None:
        n = len(matrix)
        order = range(n - 1, -1, -1)
        factor: list[list[Any]] = [[0] * n for _ in range(n)]
        scaled: list[list[Any]] = [[0] * n for _ in range(n)]  # U D
        inverse: list[Any] = [0] * n
        pivots: list[Any] = []
        for j in range(n):
            row = order[j]
            pivot = matrix[row][row]
            for k in range(j):
                pivot = pivot - factor[j][k] * scaled[j][k]
            pivot = mark(pivot, Label(row + 1, "pivot", ""))
            pivots.append(pivot)
            inverse[j] = mark(quotient(1, pivot), Label(row + 1, "ipivot", ""))
            for i in range(j + 1, n):
                entry = matrix[row][order[i]]
                for k in range(j):
                    entry = entry - factor[i][k] * scaled[j][k]
                scaled[i][j] = mark(entry, Label(order[i] + 1, "ud", str(row + 1)))
                factor[i][j] = mark(entry * inverse[j], Label(order[i] + 1, "u", str(row + 1)))
        self._factor, self._inverse, self._mark, self._order = factor, inverse, mark, order
        self.pivots = tuple(pivots)

    def halved(self, right: Sequence[Any]) -> list[Any]:
        """``U^-1 right`` [n], from tip to base; what is zero at the tip stays zero there."""
        return self._halved(right, lambda total, row: total)

    def _halved(self, right: Sequence[Any], mark: Callable[[Any, int], Any]) -> list[Any]:
        half: list[Any] = []
        for i, row in enumerate(self._order):
            total = right[row]
            for k in range(i):
                total = total - self._factor[i][k] * half[k]
            half.append(mark(total, row))
        return half

    def divided(self, half: Sequence[Any]) -> list[Any]:
        """``D^-1 half``."""
        return [x * inverse for x, inverse in zip(half, self._inverse, strict=True)]

    def solve(self, right: Sequence[Any]) -> list[Any]:
        """The solution [n] of ``matrix x = right``."""
        mark, order, n = self._mark, self._order, len(right)
        half = self._halved(right, lambda total, row: mark(total, Label(row + 1, "y", "")))
        x = self.divided(half)
        for i in reversed(range(n)):
            for k in range(i + 1, n):
                x[i] = x[i] - self._factor[k][i] * x[k]
            x[i] = mark(x[i], Label(order[i] + 1, "qdd", ""))
        return [x[order[i]] for i in range(n)]

    def inverse(self) -> list[list[Any]]:
        """The inverse [n][n]; each entry and its mirror image are one."""
        factor, order, n = self._factor, self._order, len(self._inverse)
        inverse: list[list[Any]] = [[0] * n for _ in range(n)]
        # Backwards as they are here, row i of U^T X = D^-1 U^-1, whose right side is 0 above the diagonal.
        for i in reversed(range(n)):
            for j in reversed(range(i, n)):
                total = self._inverse[i] if i == j else 0
                for k in range(i + 1, n):
                    total = total - factor[k][i] * inverse[k][j]
                label = Label(order[j] + 1, "minv", str(order[i] + 1))
                inverse[i][j] = inverse[j][i] = self._mark(total, label)
        return [[inverse[order[i]][order[j]] for j in range(n)] for i in range(n)]


def factoring(n: int) -> int:
    """Operations that :class:`Factored` takes for a matrix [n, n] without zeros and numbers."""
    return sum(2 * j + 1 + (n - 1 - j) * (2 * j + 1) for j in range(n))


def solve_symmetric(
    matrix: Sequence[Sequence[Any]], right: Sequence[Any], mark: Mark = unmarked
) -> list[Any]:
    """Solution [n] of a positive definite system by ``U D U^T``."""
    return Factored(matrix, mark).solve(right)
