"""In which order the joints of an arm follow from its pose, each by an equation of its own.

Found by trial: arms have their axes parallel, across each other or meeting in so many ways that classes by
name cover few. With some joints known, and the others anywhere, an equation is of one joint where moving that
changes it and moving any other that is not known does not. Of all orders the one with the fewest answers is
taken, and of equations those that are most sensitive where they are least.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache, reduce
from itertools import combinations, permutations
from typing import TYPE_CHECKING, NamedTuple

from robodyn.dynamics.inverse.limits import BLIND, FEW, SAMPLES, SENSITIVE
from robodyn.dynamics.inverse.loops import WAYS, Equation, Object, Way, path
from robodyn.dynamics.inverse.screws import Axis, Chain, as_floats, feet
from robodyn.dynamics.inverse.subproblems import real_root
from robodyn.dynamics.vectors import BASE, Vector, cross, dot, scaled

if TYPE_CHECKING:
    from robodyn.arrays import Floats

#: How far beside a position a slope is taken [rad, and shares of the arm's size]: the cube root of a double's
#: rounding is 6e-6, at which central differences are right to 10 digits; here 8 are, of which 6 are compared.
_STEP = 1e-4
_DIGITS = 6


class _Found(NamedTuple):
    """An equation, and how sensitive it is to its joint's position."""

    equation: Equation
    sense: float

    @property
    def rank(self) -> tuple[int, float]:
        """The less, the better; what differs by rounding, which is another on another machine, is equal."""
        return self.equation.answers, -round(self.sense, _DIGITS)


@cache
def order_of(chain: Chain, place_only: bool) -> tuple[Equation, ...] | None:
    """Equations of all joints of ``chain``, its numbers exact, one after another; None where no order is
    found. ``place_only``: whether only the tool's place is known, and not how it is turned."""
    found = _Search(chain, place_only).orders(frozenset())
    return None if found is None else found[1]


class _Positions:
    """Displacements ``[S, 4, 4]`` of the joints of a chain, and of the target, at some positions."""

    def __init__(self, moves: list[Floats], target: Floats) -> None:
        self.moves, self.target = moves, target
        self.ways: dict[tuple[int, int, Way], Floats] = {}

    def moved(self, k: int, move: Floats) -> _Positions:
        """The same with another displacement of joint ``k``."""
        return _Positions([*self.moves[:k], move, *self.moves[k + 1 :]], self.target)

    def carry(self, values: Floats, start: int, end: int, way: Way) -> Floats:
        """``[S, X, 3]``: what stands behind joint ``start``, ``[X, 4]``, carried to behind ``end``."""
        import numpy as np

        if (start, end, way) not in self.ways:
            whole = np.eye(4)
            for place in path(len(self.moves), start, end, way):
                move = self.target if place is None else self.moves[place]
                inward = (way == "on") != (place is None)
                whole = (_inverse(move) if inward else move) @ whole
            self.ways[start, end, way] = whole
        whole = self.ways[start, end, way]
        result: Floats = np.broadcast_to(values @ np.swapaxes(whole, -1, -2), (SAMPLES, *values.shape))
        return result[..., :3]


class _Search:
    """Objects and positions of a chain at which equations are looked at, lengths as shares of its size."""

    def __init__(self, chain: Chain, place_only: bool) -> None:
        import numpy as np

        self.axes, self.place_only = chain.axes, place_only
        count, size = len(chain.axes), float(chain.size)
        self.objects = [list(_objects(chain, at, place_only)) for at in range(count + 1)]
        self.values = [
            np.array([[*(float(y) / (size if x.is_point else 1) for y in x.value), x.is_point] for x in row])
            for row in self.objects
        ]
        self.floats = as_floats(chain, chain.size).axes
        draw = np.random.default_rng(0)
        true, away, aside = (
            [_displacements(axis, draw.uniform(-2.5, 2.5, SAMPLES)) for axis in self.floats] for _ in range(3)
        )
        self.true, self.away, self.aside = true, away, aside
        self.target = reduce(np.matmul, true)
        self.found: dict[frozenset[int], tuple[int, tuple[Equation, ...]] | None] = {}

    def orders(self, known: frozenset[int]) -> tuple[int, tuple[Equation, ...]] | None:
        """The best equations of the joints that are not ``known``, and how many answers they have."""
        if len(known) == len(self.axes):
            return 1, ()
        if known not in self.found:
            best: tuple[int, tuple[Equation, ...]] | None = None
            for equation in self._next(known):
                rest = self.orders(known | {equation.place})
                if rest is not None and (best is None or equation.answers * rest[0] < best[0]):
                    best = equation.answers * rest[0], (equation, *rest[1])
                if equation.answers == 1:
                    break  # to know it does no harm
            self.found[known] = best
        return self.found[known]

    def _next(self, known: frozenset[int]) -> list[Equation]:
        """Of each joint the best equation that gives it, the best of all first."""
        best: dict[tuple[int, bool], _Found] = {}
        still = [k for k in range(len(self.axes)) if k not in known]
        moves = [self.true[k] if k in known else self.away[k] for k in range(len(self.axes))]
        base = _Positions(moves, self.target)
        moved = {k: base.moved(k, self.aside[k]) for k in still}
        for found in (*self._wholes(base, moved), *self._parts(base, moved)):
            key = found.equation.place, found.equation.carried.is_point
            if found.sense > SENSITIVE and (key not in best or found.rank < best[key].rank):
                best[key] = found
        result: dict[int, Equation] = {}
        for found in sorted(best.values(), key=lambda found: found.rank):
            first = result.setdefault(found.equation.place, found.equation)
            if first is not found.equation and first.answers == found.equation.answers:
                # A point in the place of a direction, or the other way about: seldom are both of no use.
                result[found.equation.place] = first._replace(instead=found.equation)
        return list(result.values())

    def _wholes(self, base: _Positions, moved: dict[int, _Positions]) -> Iterator[_Found]:
        """Equations that say where a joint brings an object."""
        import numpy as np

        count = len(self.axes)
        for k in moved:
            for at in range(count if self.place_only else 0, count + 1):
                values = self.values[at]
                y = base.carry(values, at, k + 1, "back")
                z = base.carry(values, at, k, "on")
                fixed = np.ones(len(values), bool)
                for positions in moved.values():
                    fixed &= np.abs(positions.carry(values, at, k + 1, "back") - y).max(axis=(0, 2)) < BLIND
                    fixed &= np.abs(positions.carry(values, at, k, "on") - z).max(axis=(0, 2)) < BLIND
                for j in np.nonzero(fixed)[0]:
                    x, axis = self.objects[at][j], self.floats[k]
                    lever = y[:, j] - (axis.point if x.is_point else 0.0)
                    levers = np.linalg.norm(np.cross(axis.direction, lever), axis=1)
                    sense = float(np.quantile(levers, FEW)) if axis.revolute else float(x.is_point)
                    yield _Found(Equation(k, x, "back", None, 1), sense)

    def _parts(self, base: _Positions, moved: dict[int, _Positions]) -> Iterator[_Found]:
        """Equations between what an object is measured as, on either way."""
        import numpy as np

        count = len(self.axes)
        beside = {
            k: [
                base.moved(k, self.true[k] @ _displacements(self.floats[k], np.array([step])))
                for step in (_STEP, -_STEP)
            ]
            for k in moved
        }
        for start, end in permutations(range(count + 1), 2):
            if self.place_only and start < count:
                continue
            values = self._measured(base, start, end)
            counts = {
                k: np.abs(self._measured(positions, start, end) - values).max(axis=1) > BLIND
                for k, positions in moved.items()
            }
            alone = sum(count.astype(int) for count in counts.values()) == 1
            for k, counted in counts.items():
                places = np.argwhere(alone & counted)
                if not len(places):
                    continue
                ahead, behind = (self._measured(positions, start, end) for positions in beside[k])
                slope = np.quantile(np.abs(ahead - behind) / (2 * _STEP), FEW, axis=1)
                way = next(each for each in WAYS if k in path(count, start, end, each))
                for kind, j, i in places:
                    x, u = self.objects[start][j], self.objects[end][i]
                    if u.is_point == (kind == 1) and (x.is_point or not u.is_point):
                        single = not (self.axes[k].revolute or u.is_point)
                        equation = Equation(k, x, way, u, 1 if single else 2)
                        yield _Found(equation, float(slope[kind, j, i]))

    def _measured(self, positions: _Positions, start: int, end: int) -> Floats:
        """``[2, S, X, U]``: by how much the two ways from behind joint ``start`` to ``end`` differ, along
        what stands there, and in the square of the distance from it."""
        import numpy as np

        back, on = (positions.carry(self.values[start], start, end, way)[:, :, None] for way in WAYS)
        u = self.values[end][:, :3]
        along = ((back - on) * u).sum(axis=-1)
        squares = ((back - on) * (back + on - 2 * u)).sum(axis=-1)
        return np.stack([along, squares])


def _objects(chain: Chain, at: int, place_only: bool) -> Iterator[Object]:
    """What may stand behind joint ``at`` and be carried from there, its numbers exact."""
    axes, count = chain.axes, len(chain.axes)
    if at == count:
        yield Object(chain.tool.origin, True, at)
        if place_only:
            return
    near = range(max(0, at - 1), min(count, at + 1))
    found: dict[tuple[Vector, bool], None] = {}
    for k in near:
        found[axes[k].direction, False] = None
        for other in axes[max(0, k - 1) : k] + axes[k + 1 : k + 2]:
            if axes[k].revolute:
                found[_foot(axes[k], other), True] = None
    for one, other in combinations(axes[max(0, at - 3) : at + 3], 2):
        across = cross(one.direction, other.direction)
        if any(across):
            # Across both, and across either in their plane: a slide is not seen from there.
            for each in (across, cross(across, one.direction), cross(across, other.direction)):
                found[scaled(1 / real_root(dot(each, each)), each), False] = None
    if at in (0, count):
        found.update({(unit, False): None for unit in (BASE.x, BASE.y, BASE.z)})
    yield from (Object(value, is_point, at) for value, is_point in found)


def _foot(axis: Axis, other: Axis) -> Vector:
    """The point of a revolute axis nearest to another, or to where a slide is."""
    return feet(axis, other)[0] if other.revolute else axis.nearest(other.point)


def _displacements(axis: Axis, positions: Floats) -> Floats:
    """The displacements ``[S, 4, 4]`` of a joint at ``positions`` [S]."""
    import numpy as np

    h, p = np.array(axis.direction), np.array(axis.point)
    moves = np.tile(np.eye(4), (len(positions), 1, 1))
    if axis.revolute:
        K = np.cross(np.eye(3), -h)
        c, s = np.cos(positions)[:, None, None], np.sin(positions)[:, None, None]
        moves[:, :3, :3] = np.eye(3) + s * K + (1 - c) * (K @ K)
        moves[:, :3, 3] = p - moves[:, :3, :3] @ p
    else:
        moves[:, :3, 3] = positions[:, None] * h
    return moves


def _inverse(moves: Floats) -> Floats:
    """The inverses of displacements ``[S, 4, 4]``."""
    import numpy as np

    back = np.zeros_like(moves)
    back[:, :3, :3] = np.swapaxes(moves[:, :3, :3], 1, 2)
    back[:, :3, 3] = -np.einsum("sji,sj->si", moves[:, :3, :3], moves[:, :3, 3])
    back[:, 3, 3] = 1.0
    return back
