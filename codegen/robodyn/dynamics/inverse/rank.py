"""Whether joints can move a tool in all directions."""

from __future__ import annotations

from math import cos, sin

from robodyn.dynamics.inverse.limits import FULL_RANK, TOLERANCE, TRIED
from robodyn.dynamics.inverse.screws import Chain, minus, turned
from robodyn.dynamics.vectors import ZERO, Vector, cross, plus, scaled


def moves_all_ways(chain: Chain) -> bool:
    """Whether in some configuration the Jacobian of ``chain``, in floats with lengths as shares of its size,
    has full rank: of the tool's place for three joints or fewer, else of place and direction."""
    return _largest_pivot(chain) > FULL_RANK


def has_full_rank(chain: Chain) -> bool:
    """Whether that has full rank at all, beyond rounding: joints may move the tool hardly in a direction."""
    return _largest_pivot(chain) > TOLERANCE


def _largest_pivot(chain: Chain) -> float:
    return max(_smallest_pivot(_columns(chain, k)) for k in range(len(TRIED)))


def _columns(chain: Chain, start: int) -> list[list[float]]:
    """What moves the tool, by joint, in one of several configurations."""
    tip: Vector = chain.tool.origin
    columns: list[tuple[Vector, Vector]] = []
    for k in reversed(range(len(chain.axes))):
        axis, angle = chain.axes[k], TRIED[(start + k) % len(TRIED)] + 0.1 * k
        if axis.revolute:
            circle = (cos(angle), sin(angle))
            columns = [
                (turned(axis.direction, circle, v), turned(axis.direction, circle, w)) for v, w in columns
            ]
            lever = turned(axis.direction, circle, minus(tip, axis.point))
            tip = plus(axis.point, lever)
            columns.append((cross(axis.direction, lever), axis.direction))
        else:
            tip = plus(tip, scaled(angle, axis.direction))
            columns.append((axis.direction, ZERO))
    place_only = len(columns) <= 3
    return [[*v] if place_only else [*v, *w] for v, w in columns]


def _smallest_pivot(rows: list[list[float]]) -> float:
    """The last pivot of elimination with complete pivoting: 0 where the rows depend on each other."""
    pivot = 0.0
    for step in range(min(len(rows), len(rows[0]))):
        i, j = max(
            ((i, j) for i in range(step, len(rows)) for j in range(step, len(rows[0]))),
            key=lambda place: abs(rows[place[0]][place[1]]),
        )
        rows[step], rows[i] = rows[i], rows[step]
        for row in rows:
            row[step], row[j] = row[j], row[step]
        pivot = abs(rows[step][step])
        if not pivot:
            return 0.0
        for row in rows[step + 1 :]:
            share = row[step] / rows[step][step]
            for k in range(step, len(row)):
                row[k] -= share * rows[step][k]
    return pivot
