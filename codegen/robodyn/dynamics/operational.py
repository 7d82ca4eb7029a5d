"""What the joints weigh at the tool, ``J M^-1 J^T``, and ``M^-1``, over any scalar, in few operations.

With a mass matrix: it is factored once, from tip to base, ``M = U D U^T``. Each row of the Jacobian is solved
half way, ``y = U^-1 J_r``, and an entry is ``y_r^T D^-1 y_s``. Rows that are zero in the last joints, as
those of the tool's velocity are where three axes meet there, stay zero in them.

Without one, by how links respond to a push, all joints free to move: ``J M^-1 J^T`` in as many operations as
an arm has joints, and ``M^-1`` in their square. Two passes. Inward as in :mod:`.articulated`, for how each
joint gives way: to accelerations ``(alpha, a)`` of its frame by ``-k . (alpha, a)``. Outward the response
``E`` of each link: the acceleration of its frame for a force and a moment at its origin. What is behind a
joint gives way in its turn, so that

    E = (1 - s k^T) E' (1 - k s^T) + s s^T / pivot,

``s`` being the joint's axis and ``E'`` the response of the link before, at the same origin. The response of
the last link is the tool's; a torque at a joint moves the joints further out as its link takes them along.

Source: Rodriguez, Jain and Kreutz-Delgado 1992 (operational space by spatial operators); Featherstone 2008,
chapter 7, for the inward pass.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Body, Symmetric, into_child, origin
from robodyn.dynamics.articulated import Yielding, origins_of, yielding
from robodyn.dynamics.jacobians import columns
from robodyn.dynamics.lump import NO_LUMP
from robodyn.dynamics.mass_matrix import Factored
from robodyn.dynamics.poses import placed
from robodyn.dynamics.sections import ROWS, Row
from robodyn.dynamics.spatial import Spatial
from robodyn.dynamics.state import Dynamics, Moving
from robodyn.dynamics.vectors import ZERO, Mark, Pair, Vector, cross, dot, flat, plus, scaled
from robodyn.effects.scalars import is_zero
from robodyn.ir.program import Label


def lambda_inverse(at: Dynamics) -> list[Any]:
    """``J M^-1 J^T`` [36] along the world's axes, row by row; each entry and its mirror image are one."""
    rows = zip(*((*v, *w) for v, w in columns(at)), strict=True)
    factored = Factored(at.mass_matrix(), at.mark)
    halves = [factored.halved(row) for row in rows]
    scaled = [factored.divided(half) for half in halves]

    def entry(r: int, s: int) -> Any:
        total: Any = 0
        for x, y in zip(scaled[r], halves[s], strict=True):
            if not is_zero(x) and not is_zero(y):
                total = total + x * y
        return total

    return _mirrored(at, (entry(r, s) for r in range(6) for s in range(r, 6)))


def _mirrored(at: Dynamics, entries: Iterable[Any]) -> list[Any]:
    """A symmetric matrix [6][6], row by row, from its upper half."""
    result: list[list[Any]] = [[0] * 6 for _ in range(6)]
    places = ((r, s) for r in range(6) for s in range(r, 6))
    for (r, s), value in zip(places, entries, strict=True):
        result[r][s] = result[s][r] = at.mark(value, Label(r + 1, "linv", str(s + 1)))
    return flat(result)


def by_elimination(matrix: Sequence[Sequence[Any]], right: Sequence[Sequence[Any]]) -> list[list[Any]]:
    """``X`` [n][m] with ``matrix X = right``, the matrix [n][n] positive definite; plain elimination, which
    shares nothing with what is emitted."""
    n = len(matrix)
    rows = [[*row, *more] for row, more in zip(matrix, right, strict=True)]
    for k in range(n):
        for i in range(k + 1, n):
            share = rows[i][k] / rows[k][k]
            rows[i] = [x - share * y for x, y in zip(rows[i], rows[k], strict=True)]
    for k in reversed(range(n)):
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(k):
            rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k], strict=True)]
    return [row[n:] for row in rows]


# --- by responses -------------------------------------------------------------------------------------------


class _Response(NamedTuple):
    """How a link responds to a push: the acceleration ``(a, alpha)`` of its frame for a force and a moment at
    its origin, and for a unit torque at its joint ``moves`` and the joint's own acceleration ``turns``.

    By how much the joint gives way, its axis being z: to accelerations ``across`` its own (force and moment
    in one), and ``along`` it: 1 without a rotor.
    """

    pushed: Spatial
    moves: Pair
    turns: Any
    across: Pair
    along: Any


def lambda_inverse_by_responses(at: Dynamics) -> list[Any]:
    """``J M^-1 J^T`` [36], see :func:`lambda_inverse`."""
    links = at.links(at.rest, at.rest)
    *_, last = _responses(links, at.mark)
    x, y, z = links.arm.tool.origin
    tool = last.pushed.moved((-x, -y, -z))
    return _mirrored(at, at.cheapest.apart([partial(_in_world, at, tool, row) for row in ROWS]))


def inverse_mass_matrix_by_responses(at: Dynamics) -> list[list[Any]]:
    """``M^-1`` [n][n]; each entry and its mirror image are one."""
    links = at.links(at.rest, at.rest)
    n = len(links.arm.bodies)
    inverse: list[list[Any]] = [[0] * n for _ in range(n)]
    #: By joints from the base on: the acceleration of the link that was reached, for a unit torque there.
    moving: list[Pair] = []
    for i, (link, response) in enumerate(zip(links.arm.bodies, _responses(links, at.mark), strict=True)):
        for j, (a, alpha) in enumerate(moving):
            a, alpha = _taken_along(links, i, a, alpha)
            rest = dot(response.across[0], a) + dot(response.across[1], alpha)
            own = _own(link, (a, alpha))
            label = Label(i + 1, "minv", str(j + 1))
            inverse[i][j] = inverse[j][i] = at.mark(-(rest + response.along * own), label)
            moving[j] = _with_own(link, (a, alpha), -rest if response.along == 1 else own + inverse[i][j])
        inverse[i][i] = at.mark(response.turns, Label(i + 1, "minv", str(i + 1)))
        moving.append(response.moves)
    return inverse


def _responses(at: Moving, mark: Mark) -> Iterator[_Response]:
    """How the links respond, base to tip."""
    origins = origins_of(at)
    nothing = NO_LUMP.second
    before = Spatial(nothing, (ZERO, ZERO, ZERO), nothing)
    for i, joint in enumerate(yielding(at, origins, mark)):
        link, c, s = at.arm.bodies[i], at.motion.c[i], at.motion.s[i]
        x, y, z = origins[i]
        here = before.moved((-x, -y, -z)).about_x(link.cos_alpha, -link.sin_alpha).about_z(c, -s)
        response = _response(link, joint, here)
        before = response.pushed.named(i + 1, "e", mark)
        yield response._replace(pushed=before)


def _response(link: Body, joint: Yielding, here: Spatial) -> _Response:
    """The response of ``link``, where that of the link before is ``here``."""
    n, f = joint.share
    share, k = _with_own(link, (f, n), 0), 1 if is_zero(link.motor_inertia) else _own(link, (f, n))
    A, B, M = here.A, here.B, here.M
    # What a unit push along the joint does there, and what a push does by which the joint gives way.
    along: Pair = ((A.xz, A.yz, A.zz), B[2])
    if link.revolute:
        along = ((B[0][2], B[1][2], B[2][2]), (M.xz, M.yz, M.zz))
    across = here.times(*share)
    whole = _plus(across, k, along)
    itself = joint.inverse + (dot(share[0], across[0]) + dot(share[1], across[1]))
    turns = itself + k * (_own(link, across) + _own(link, whole))
    moves = _with_own(link, _plus((ZERO, ZERO), -1, whole), turns - _own(link, whole))
    if k == 1:  # the joint takes all of what is along it
        moves = _with_own(link, moves, itself + _own(link, across))
        column = _with_own(link, _plus((ZERO, ZERO), -1, across), itself)
    else:
        column = _plus(along, -1, whole)
        column = _with_own(link, column, _own(link, column) + _own(link, moves))
    return _Response(_with_column(link, here, column), moves, turns, share, k)


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
        one, two, three = ((row[0], row[1], entry) for row, entry in zip(B, (x, y, z), strict=True))
        return Spatial(A, (one, two, three), Symmetric(M.xx, M.yy, w, M.xy, u, v))
    return Spatial(Symmetric(A.xx, A.yy, z, A.xy, x, y), (B[0], B[1], (u, v, w)), M)


def _taken_along(at: Moving, i: int, a: Vector, alpha: Vector) -> Pair:
    """The acceleration of link ``i``, which its joint does not turn, from that of the link before."""
    link, c, s = at.arm.bodies[i], at.motion.c[i], at.motion.s[i]
    a = plus(a, cross(alpha, origin(link, at.motion.d[i])))
    return into_child(link, c, s, a), into_child(link, c, s, alpha)


def _in_world(at: Dynamics, form: Spatial, row: Row) -> list[Any]:
    """The upper half of ``form``, row by row, from the last link's axes along the world's; ``row`` of the
    components of axes is made of the others."""
    axes = list(zip(*placed(at, row).links[len(at.arm.bodies) - 1], strict=True))  # along the link's
    columns = list(zip(*form.B, strict=True))
    pushed = [form.A.times(u) for u in axes]
    mixed = [tuple(dot(u, column) for column in columns) for u in axes]
    turned = [form.M.times(u) for u in axes]
    return flat(
        [
            *([dot(pushed[r], u) for u in axes[r:]] + [dot(mixed[r], u) for u in axes] for r in range(3)),
            *([dot(turned[r], u) for u in axes[r:]] for r in range(3)),
        ]
    )
