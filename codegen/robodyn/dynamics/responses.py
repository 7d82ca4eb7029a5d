"""How links answer a push, all joints free to move, over any scalar: ``J M^-1 J^T`` of the tool in as many
operations as an arm has joints, and ``M^-1`` in their square, without a mass matrix.

Two passes. Inward as in :mod:`~robodyn.dynamics.articulated`, for how each joint gives way: to accelerations
``(alpha, a)`` of its frame by ``-k . (alpha, a)``. Outward the answer ``E`` of each link: the acceleration of
its frame for a force and a moment at its origin. What is behind a joint gives way in its turn, so that

    E = (1 - s k^T) E' (1 - k s^T) + s s^T / pivot,

``s`` being the joint's axis and ``E'`` the answer of the link before, at the same origin. The answer of the
last link is the tool's; and a torque at a joint moves the joints further out as its link takes them along.

Source: Rodriguez, Jain and Kreutz-Delgado 1992 (operational space by spatial operators); Featherstone 2008,
chapter 7, for the inward pass.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

from robodyn.dynamics.arm import Body, Symmetric, into_child, origin
from robodyn.dynamics.articulated import Yielding, yielding
from robodyn.dynamics.poses import placed
from robodyn.dynamics.sections import ROWS, Row
from robodyn.dynamics.spatial import Pair, Spatial
from robodyn.dynamics.state import Dynamics, Moving
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, dot, flat, plus, scaled
from robodyn.effects.scalars import is_zero
from robodyn.ir.program import Label

_NOTHING = Symmetric(0, 0, 0, 0, 0, 0)


@dataclass(frozen=True, slots=True)
class _Answer:
    """How a link answers a push: the acceleration ``(a, alpha)`` of its frame for a force and a moment at its
    origin, and for a unit torque at its joint ``moves`` and the joint's own acceleration ``turns``."""

    pushed: Spatial
    moves: Pair
    turns: Any


@dataclass(frozen=True, slots=True)
class _Share:
    """By how much a joint gives way, its axis being z: to accelerations ``across`` its own (force and moment
    in one), and along it: 1 without a rotor."""

    across: Pair
    along: Any


def lambda_inverse_by_answers(at: Dynamics) -> list[list[Any]]:
    """``J M^-1 J^T`` [6][6] along the world's axes; each entry and its mirror image are one."""
    links = at.links(at.rest, at.rest)
    *_, (_, _, last) = _outward(links, at.mark)
    x, y, z = links.arm.tool.origin
    tool = last.pushed.moved((-x, -y, -z))
    values = at.cheapest.apart([partial(_in_world, at, tool, row) for row in ROWS])
    result: list[list[Any]] = [[0] * 6 for _ in range(6)]
    places = ((r, s) for r in range(6) for s in range(r, 6))
    for (r, s), value in zip(places, values, strict=True):
        result[r][s] = result[s][r] = at.mark(value, Label(r + 1, "linv", str(s + 1)))
    return result


def inverse_mass_matrix_by_answers(at: Dynamics) -> list[list[Any]]:
    """``M^-1`` [n][n]; each entry and its mirror image are one."""
    links = at.links(at.rest, at.rest)
    n = len(links.arm.bodies)
    inverse: list[list[Any]] = [[0] * n for _ in range(n)]
    #: By joints from the base on: the acceleration of the link that was reached, for a unit torque there.
    moving: list[Pair] = []
    for i, (link, share, answer) in enumerate(_outward(links, at.mark)):
        for j, (a, alpha) in enumerate(moving):
            a, alpha = _taken_along(links, i, a, alpha)
            rest = dot(share.across[0], a) + dot(share.across[1], alpha)
            own = _own(link, (a, alpha))
            label = Label(i + 1, "minv", str(j + 1))
            inverse[i][j] = inverse[j][i] = at.mark(-(rest + share.along * own), label)
            moving[j] = _with_own(link, (a, alpha), -rest if share.along == 1 else own + inverse[i][j])
        inverse[i][i] = at.mark(answer.turns, Label(i + 1, "minv", str(i + 1)))
        moving.append(answer.moves)
    return inverse


def _outward(at: Moving, mark: Mark) -> Iterator[tuple[Body, _Share, _Answer]]:
    """The links, how their joints give way, and how they answer, base to tip."""
    origins = [origin(body, d) for body, d in zip(at.arm.bodies, at.motion.d, strict=True)]
    before = Spatial(_NOTHING, (ZERO, ZERO, ZERO), _NOTHING)
    for i, joint in enumerate(yielding(at, origins, mark)):
        link, c, s = at.arm.bodies[i], at.motion.c[i], at.motion.s[i]
        x, y, z = origins[i]
        here = before.moved((-x, -y, -z)).about_x(link.cos_alpha, -link.sin_alpha).about_z(c, -s)
        share = _share(link, joint)
        answer = _answer(link, joint, share, here)
        before = answer.pushed.named(i + 1, "e", mark)
        yield link, share, _Answer(before, answer.moves, answer.turns)


def _share(link: Body, joint: Yielding) -> _Share:
    n, f = joint.share
    own = _own(link, (f, n))
    return _Share(_with_own(link, (f, n), 0), 1 if is_zero(link.motor_inertia) else own)


def _answer(link: Body, joint: Yielding, share: _Share, here: Spatial) -> _Answer:
    """The answer of ``link``, where that of the link before is ``here``."""
    A, B, M, k = here.A, here.B, here.M, share.along
    # What a unit push along the joint does there, and what a push does by which the joint gives way.
    along: Pair = ((A.xz, A.yz, A.zz), B[2])
    if link.revolute:
        along = ((B[0][2], B[1][2], B[2][2]), (M.xz, M.yz, M.zz))
    across = here.times(*share.across)
    whole = _plus(across, k, along)
    itself = joint.inverse + (dot(share.across[0], across[0]) + dot(share.across[1], across[1]))
    turns = itself + k * (_own(link, across) + _own(link, whole))
    moves = _with_own(link, _plus((ZERO, ZERO), -1, whole), turns - _own(link, whole))
    if k == 1:  # the joint takes all of what is along it
        moves = _with_own(link, moves, itself + _own(link, across))
        column = _with_own(link, _plus((ZERO, ZERO), -1, across), itself)
    else:
        column = _plus(along, -1, whole)
        column = _with_own(link, column, _own(link, column) + _own(link, moves))
    return _Answer(_with_column(link, here, column), moves, turns)


def _plus(one: Pair, factor: Any, other: Pair) -> Pair:
    """``one + factor other``."""
    return plus(one[0], scaled(factor, other[0])), plus(one[1], scaled(factor, other[1]))


def _own(link: Body, pair: Pair) -> Any:
    """What of an acceleration ``(a, alpha)`` is along the joint of ``link``."""
    a, alpha = pair
    return alpha[2] if link.revolute else a[2]


def _with_own(link: Body, pair: Pair, own: Any) -> Pair:
    """``pair``, what is along the joint of ``link`` replaced by ``own``."""
    (x, y, z), (u, v, w) = pair
    return ((x, y, z), (u, v, own)) if link.revolute else ((x, y, own), (u, v, w))


def _with_column(link: Body, form: Spatial, column: Pair) -> Spatial:
    """``form`` with another row and ``column`` of the joint of ``link``."""
    A, B, M = form.A, form.B, form.M
    (x, y, z), (u, v, w) = column
    if link.revolute:
        rows = tuple((row[0], row[1], entry) for row, entry in zip(B, (x, y, z), strict=True))
        return Spatial(A, (rows[0], rows[1], rows[2]), Symmetric(M.xx, M.yy, w, M.xy, u, v))
    return Spatial(Symmetric(A.xx, A.yy, z, A.xy, x, y), (B[0], B[1], (u, v, w)), M)


def _taken_along(at: Moving, i: int, a: Vector, alpha: Vector) -> Pair:
    """The acceleration of link ``i``, which its joint does not turn, from that of the link before."""
    link, c, s = at.arm.bodies[i], at.motion.c[i], at.motion.s[i]
    a = plus(a, cross(alpha, origin(link, at.motion.d[i])))
    return into_child(link, c, s, a), into_child(link, c, s, alpha)


def _in_world(at: Dynamics, form: Spatial, row: Row) -> list[Any]:
    """The upper half of ``form``, row by row, from the last link's axes along the world's; ``row`` of the
    components of axes is made of the others."""
    x, y, z = placed(at, row).links[len(at.arm.bodies) - 1]
    axes = list(zip(x, y, z, strict=True))  # the world's, along the link's
    columns = list(zip(*form.B, strict=True))
    pushed = [form.A.times(u) for u in axes]
    mixed = [tuple(dot(u, column) for column in columns) for u in axes]
    turned = [form.M.times(u) for u in axes]
    halves = [
        *([dot(pushed[r], u) for u in axes[r:]] + [dot(mixed[r], u) for u in axes] for r in range(3)),
        *([dot(turned[r], u) for u in axes[r:]] for r in range(3)),
    ]
    return flat(halves)
