"""Inverse kinematics of any arm by damped least squares: one solution near a reference, step by step.

The step is Levenberg's and Marquardt's, ``dq = J^T (J J^T + damping 1)^-1 error``. The damping is
proportional to the squared error (T. Sugihara, IEEE Trans. Robotics 27, 2011): steps are short where the
arm is far from the pose, whatever the Jacobian is there, and Newton's where it is near. A step that does not
lower the error is taken back, a shorter one is tried from there, and the damping rises. Joints that stand at
a limit and are pushed against it stay there (D. Bertsekas, SIAM J. Control 20, 1982).

Lengths count as shares of the arm's size, so that metres and radians weigh alike. Where there are more
joints than the pose needs, the step is the shortest; where there are fewer, the error is least where it ends.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

from robodyn.dynamics.inverse.limits import (
    DAMPED,
    EASED,
    EDGE,
    FURTHEST,
    LEAST_DAMPED,
    MOST_REFUSED,
    NEARLY,
    REGULAR,
    SHARPENED,
    SHORTENED,
    SOLVED,
)
from robodyn.dynamics.inverse.solution import Joint, Solved
from robodyn.dynamics.inverse.subproblems import both, either
from robodyn.dynamics.jacobians import columns
from robodyn.dynamics.limits import TASK_JOINTS
from robodyn.dynamics.mass_matrix import Factored
from robodyn.dynamics.poses import pose
from robodyn.dynamics.state import Dynamics
from robodyn.dynamics.vectors import Vector, dot, inner, scaled
from robodyn.effects.scalars import choose, root

#: Rows of scalars.
Matrix = list[list[Any]]


class State(NamedTuple):
    """What a step leaves to the next.

    ``q`` [n]: where it looks; ``best`` [n]: the positions of the least squared error so far, ``error``, and
    ``singular``, 1 where the Jacobian loses rank there. ``gain``: the damping, by the squared error.
    ``refused``: steps in a row that did not lower it. ``done``: 1 when there is nothing left to do.
    """

    q: Sequence[Any]
    best: Sequence[Any]
    error: Any
    singular: Any
    gain: Any
    refused: Any
    done: Any

    def flat(self) -> list[Any]:
        """Its numbers, one after another."""
        return [*self.q, *self.best, *self[2:]]

    @classmethod
    def of(cls, x: Sequence[Any]) -> State:
        """From its numbers."""
        n = (len(x) - 5) // 2
        return cls(x[:n], x[n : 2 * n], *x[2 * n :])


@dataclass(frozen=True, slots=True)
class Descent:
    """Steps towards a pose, for an arm with these ``joints`` [n] and of this ``size`` [m].

    ``unit``: the rounding unit of the arithmetic. ``place_only``: whether the tool may be turned anyhow.
    ``locked``: joints (from 0) that stay where they are.
    """

    joints: tuple[Joint, ...]
    size: Fraction
    unit: Fraction
    place_only: bool
    locked: frozenset[int] = frozenset()

    def start(self, q: Sequence[Any], *, within: Fraction | None = None) -> State:
        """Before the first step, at ``q`` [n] (rad or m) or the nearest positions that limits allow; with
        ``within`` it is given up there unless the error is less than that."""
        inside = [joint.clamped(x) for joint, x in zip(self.joints, q, strict=True)]
        error, refused = (FURTHEST, 0) if within is None else (within**2, MOST_REFUSED)
        return State(inside, inside, error, Fraction(0), DAMPED, Fraction(refused), Fraction(0))

    def step(self, at: Dynamics, T: Sequence[Any], x: State) -> State:
        """The next state; ``at`` is the arm at ``x.q``, ``T`` [12] where the tool is to be."""
        missing = self.missing(pose(at), T)
        error = sum((y * y for y in missing[1:]), missing[0] * missing[0])
        lower = x.error - error
        close = choose(self._square(NEARLY) - x.error, 1, 0)

        eased = choose(LEAST_DAMPED - x.gain * EASED, LEAST_DAMPED, x.gain * EASED)
        moves, pivot = self._moves(at, missing, eased * error + REGULAR * self.unit)
        onward = [joint.clamped(q + d) for joint, q, d in zip(self.joints, x.q, moves, strict=True)]
        back = [b + SHORTENED * (q - b) for q, b in zip(x.q, x.best, strict=True)]

        refused = x.refused + 1
        arrived = choose(self._square(SOLVED) - error, 1, 0)
        given_up = either(close, choose(refused - MOST_REFUSED, 1, 0))
        of_step = State(
            onward, x.q, error, choose(EDGE * self.unit - pivot, 1, 0), eased, Fraction(0), arrived
        )
        of_refusal = State(back, x.best, x.error, x.singular, x.gain * SHARPENED, refused, given_up)
        chosen = [choose(lower, a, b) for a, b in zip(of_step.flat(), of_refusal.flat(), strict=True)]
        return State.of(chosen)

    def finish(self, states: Sequence[State], joints: Sequence[Joint]) -> Solved:
        """What was reached from each of several starts; ``joints`` have the limits that flags are about."""
        result = Solved.none()
        for x in states:
            result.solutions.append(list(x.best))
            result.exists.append(choose(self._square(EDGE) - x.error, 1, 0))
            allowed = (joint.allows(q, EDGE * self.unit) for joint, q in zip(joints, x.best, strict=True))
            result.within.append(both(*allowed))
            result.singular.append(x.singular)
            if len(joints) in TASK_JOINTS:
                result.placed.append(result.exists[-1])
                result.off.append(root(x.error))
        return result

    def _square(self, units: int) -> Fraction:
        return (units * self.unit) ** 2

    def missing(self, now: Sequence[Any], T: Sequence[Any]) -> list[Any]:
        """From the pose ``now`` [12] to ``T`` [12]: the way, as a share of the size, and twice the sine of
        half the angle along the axis that it is about."""
        way = [(T[k] - now[k]) / self.size for k in (3, 7, 11)]
        if self.place_only:
            return way
        rows, goal = ([(t[k], t[k + 1], t[k + 2]) for k in (0, 4, 8)] for t in (now, T))
        return [*way, *rotation_between([[dot(u, v) for v in rows] for u in goal])]

    def _moves(self, at: Dynamics, missing: Sequence[Any], damping: Any) -> tuple[list[Any], Any]:
        """The damped step [n] and the least pivot of what it is solved from."""
        J: Matrix = []
        for k, (joint, (v, w)) in enumerate(zip(self.joints, columns(at), strict=True)):
            u: Vector = scaled(1 / self.size, v)
            column = list(u) if self.place_only else [*u, *w]
            J.append([Fraction(0)] * len(column) if k in self.locked else column)
            if joint.limits is not None and k not in self.locked:
                push = inner(column, missing)
                low, high = joint.limits
                q = at.inputs["q"][k]
                blocked = choose(push, choose(high - q, 0, 1), choose(q - low, 0, 1))
                J[k] = [choose(blocked, 0, y) for y in column]
        if len(J) - len(self.locked) >= len(missing):
            rows = [list(row) for row in zip(*J, strict=True)]
            factored = Factored(_damped(rows, damping))
            y = factored.solve(missing)
            return [inner(column, y) for column in J], _least(factored.pivots)
        factored = Factored(_damped(J, damping))
        return factored.solve([inner(column, missing) for column in J]), _least(factored.pivots)


def rotation_between(m: Matrix) -> list[Any]:
    """Axis times twice the sine of half the angle [3] of the rotation ``m`` [3][3] (S. W. Shepperd, J.
    Guidance and Control 1, 1978): of four ways to take its quaternion one that divides by nothing small."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = m
    w, x, y, z = 1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz
    a, b, c = zy - yz, xz - zx, yx - xy
    d, e, f = xy + yx, xz + zx, yz + zy
    # Four times the quaternion, scalar first, by one of its numbers; the last is four times that squared.
    ways = ((w, a, b, c, w), (a, x, d, e, x), (b, d, y, f, y), (c, e, f, z, z))
    chosen = list(ways[3])
    for way in (ways[2], ways[1], ways[0]):
        chosen = [choose(way[4] - Fraction(3, 4), new, old) for new, old in zip(way, chosen, strict=True)]
    scale = 1 / root(chosen[4])
    scale = choose(-chosen[0], -scale, scale)
    return [scale * u for u in chosen[1:4]]


def _damped(rows: Matrix, damping: Any) -> Matrix:
    """``A A^T + damping 1`` of the ``rows`` of ``A``."""
    m = len(rows)
    result: Matrix = [[0] * m for _ in range(m)]
    for i in range(m):
        for j in range(i, m):
            result[i][j] = result[j][i] = inner(rows[i], rows[j])
        result[i][i] = result[i][i] + damping
    return result


def _least(values: Sequence[Any]) -> Any:
    least = values[0]
    for x in values[1:]:
        least = choose(least - x, x, least)
    return least
