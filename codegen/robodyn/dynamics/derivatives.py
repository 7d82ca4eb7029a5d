"""Derivatives of the joint torques with respect to positions and velocities, over any scalar.

What beyond joint i is seen from link i moves as one body there turns with the joint: a particle at ``r`` that
moves at ``u`` relative to the link has the acceleration ``a + lambda r + 2 w x u + du/dt``, and turning joint
i by a small angle turns ``r``, ``u`` and ``du/dt`` about its axis and leaves ``a``, ``lambda`` and ``w``. So
all that the derivatives need of a composite body are its moments, mass, first and second moment, which the
mass matrix takes too, and its momenta relative to the link, ``p = integral of u dm`` and
``N = integral of u r^T dm``. Each joint's wrenches are then carried down to the base like those of the mass
matrix.

Derivatives from composite bodies are the idea of S. Echeandia and P. M. Wensing 2021 and of S. Singh,
R. Russo and P. M. Wensing 2022 ("Efficient analytical derivatives of rigid-body dynamics using spatial vector
algebra"), who write them in spatial vectors. Written with moments and relative momenta, what is zero in their
6x6 matrices does not arise, and regrouped masses, which may be zero, may be used.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Arm, about_x, about_z, origin
from robodyn.dynamics.modified_newton_euler import Lambda, lambda_matrix
from robodyn.dynamics.parallel import reaches
from robodyn.dynamics.spatial import NO_COMPOSITE, Composite
from robodyn.dynamics.state import Moving
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, dot, named, plus, scaled, unmarked

#: Rows of scalars.
Matrix = list[list[Any]]


class _Link(NamedTuple):
    """A link in motion, along the axes in which its joint (or its chain) begins to turn: angular velocity
    ``w``, its lambda matrix ``lam``, acceleration ``a`` of its origin less gravity;
    along its own axes the force ``f`` at and the moment ``n`` about its origin."""

    w: Vector
    lam: Lambda
    a: Vector
    f: Vector
    n: Vector


def coriolis_matrix(at: Moving, mark: Mark = unmarked) -> Matrix:
    """The Coriolis matrix ``C`` [n][n] of Christoffel's symbols: ``C qd`` are the torques of the velocities,
    and ``dM/dt - 2 C`` is skew. Half the derivative of the torques by the velocities."""
    return _derivatives(at, ZERO, 1, mark)[1]


def torque_derivatives(at: Moving, mark: Mark = unmarked) -> tuple[Matrix, Matrix]:
    """Derivatives [n][n] of the rigid arm's torques by positions and by velocities, row i of joint i, without
    rotors and friction.

    Units: N m by rad, rad/s; at prismatic joints N, and by m.
    """
    return _derivatives(at, at.arm.gravity, 2, mark)


def _derivatives(at: Moving, gravity: Vector, times: int, mark: Mark) -> tuple[Matrix, Matrix]:
    """Momenta and rates are taken ``times``, so that the derivatives by velocities come ``times`` half, and
    those by positions right for 2."""
    arm, turns, n = at.arm, at.turns, len(at.arm.bodies)
    reach = reaches(arm, at.motion, turns)
    links = _forward(at, gravity, mark)
    by_q: Matrix = [[0] * n for _ in range(n)]
    by_qd: Matrix = [[0] * n for _ in range(n)]
    beyond = NO_COMPOSITE
    for i in reversed(range(n)):
        c, s = turns.c[i], turns.s[i]
        here, further = _own(at, links, i), NO_COMPOSITE
        if i + 1 < n:
            child = arm.bodies[i + 1]
            further = beyond.turned_x(child.cos_alpha, child.sin_alpha).about(reach[i])
            if not turns.follows[i + 1]:
                here, further = here.with_(further), NO_COMPOSITE
        composite = here.turned_z(c, s).with_(further).named(i + 1, mark)
        wrenches = _wrenches(arm, i, composite, links[i], times)
        _carry_down(at, i, wrenches, links, reach, (by_q, by_qd), times)
        beyond = composite.moving(arm, i, times * at.motion.qd[i])
    return by_q, by_qd


def _forward(at: Moving, gravity: Vector, mark: Mark) -> list[_Link]:
    """Motion, force and moment of each link, base to tip."""
    arm, motion, turns = at.arm, at.motion, at.turns
    gx, gy, gz = gravity
    w, alpha, a = ZERO, ZERO, (-gx, -gy, -gz)  # along the axes of the link before, or of its chain
    lam = lambda_matrix(ZERO, ZERO, 0, unmarked)  # along the link's own axes
    links: list[_Link] = []
    for i, body in enumerate(arm.bodies):
        c, s, qd, qdd = turns.c[i], turns.s[i], motion.qd[i], motion.qdd[i]
        p = origin(body, motion.d[i])
        if turns.follows[i]:
            # Along the axes of the chain nothing turns but what points along the axis.
            p = about_z(turns.c[i - 1], turns.s[i - 1], p)
            before = links[i - 1]
            a = plus(before.a, before.lam.times(p))
        else:
            if i:
                w, alpha, a = (
                    about_z(turns.c[i - 1], -turns.s[i - 1], u)
                    for u in (links[i - 1].w, alpha, links[i - 1].a)
                )
            a = plus(a, lam.times(p))
        w, alpha, a = (about_x(body.cos_alpha, -body.sin_alpha, u) for u in (w, alpha, a))
        if body.revolute:
            alpha = plus(alpha, (w[1] * qd, -(w[0] * qd), qdd))
            w = plus(w, (0, 0, qd))
        else:
            twice = 2 * qd
            a = plus(a, (twice * w[1], -(twice * w[0]), qdd))
        w = named(mark, w, i + 1, "wt")
        alpha = named(mark, alpha, i + 1, "alphat")
        a = named(mark, a, i + 1, "at")
        own_w, own_alpha, own_a = (about_z(c, -s, u) for u in (w, alpha, a))
        lam = lambda_matrix(own_w, own_alpha, i + 1, mark)
        lump = at.lumps[i]
        h, k = lump.first, lump.second
        f = plus(scaled(lump.mass, own_a), lam.times(h))
        moment = plus(_axial(lam, k), cross(h, own_a))
        links.append(_Link(w, lambda_matrix(w, alpha, i + 1, unmarked), a, f, moment))
    return links


def _axial(lam: Lambda, k: Any) -> Vector:
    """``integral of r x (lambda r) dm``, ``k`` the second moments."""
    rows = ((k.xx, k.xy, k.xz), (k.xy, k.yy, k.yz), (k.xz, k.yz, k.zz))
    x, y, z = lam.rows
    return (
        dot(z, rows[1]) - dot(y, rows[2]),
        dot(x, rows[2]) - dot(z, rows[0]),
        dot(y, rows[0]) - dot(x, rows[1]),
    )


def _own(at: Moving, links: Sequence[_Link], i: int) -> Composite:
    """What link ``i`` itself gives, along its own axes."""
    return Composite(at.lumps[i], ZERO, (ZERO, ZERO, ZERO), links[i].f, links[i].n)


class _Wrenches(NamedTuple):
    """Force and moment at and about the origin of joint i: what its unit acceleration needs (``inertia``),
    and derivatives by its ``velocity`` and its ``position``; and the vector ``twice`` whose product with
    what a joint before changes of the angular velocity is what joint i feels of that."""

    inertia: tuple[Vector, Vector]
    velocity: tuple[Vector, Vector]
    position: tuple[Vector, Vector]
    twice: Vector


def _wrenches(arm: Arm, i: int, of: Composite, link: _Link, times: int) -> _Wrenches:
    """Those of joint ``i``, along its axes; ``of.p`` and ``of.N`` are ``times`` the momenta."""
    m, h, k = of.lump.mass, of.lump.first, of.lump.second
    (Nxx, Nxy, Nxz), (Nyx, Nyy, Nyz), (Nzx, Nzy, Nzz) = of.N
    w = scaled(times, link.w)
    (_, _, l13), (_, _, l23), (l31, l32, l33) = link.lam.rows
    a, p = link.a, of.p
    if not arm.bodies[i].revolute:
        force = (m * l13, m * l23, m * l33)
        along = (l13, l23, l33)
        coriolis = (w[1], -w[0], 0)
        momentum = plus(p, cross(w, h))
        return _Wrenches(
            ((0, 0, m), (h[1], -h[0], 0)),
            (scaled(m, coriolis), cross(h, coriolis)),
            (force, plus((-of.f[1], of.f[0], 0), cross(h, along))),
            (momentum[1], -momentum[0], 0),
        )
    inertia = ((-h[1], h[0], 0), (-k.xz, -k.yz, k.xx + k.yy))
    kw = (k.xx * w[0] + k.xy * w[1] + k.xz * w[2], k.xy * w[0] + k.yy * w[1] + k.yz * w[2])
    velocity = (
        (-(w[2] * h[0]) - p[1], p[0] - w[2] * h[1], w[0] * h[0] + w[1] * h[1]),
        (kw[1] - Nxz, -kw[0] - Nyz, Nxx + Nyy),
    )
    # lambda E - E lambda, E the turn about the axis.
    x, y, _ = link.w
    both, unlike = 2 * link.lam.k[2], y * y - x * x
    lam = Lambda(((both, unlike, l23), (unlike, -both, -l13), (l32, -l31, 0)), ZERO)
    turn = (y, -x, 0)  # w x e
    coriolis_moment = (
        (Nyy + Nzz) * turn[0] - Nxy * turn[1],
        (Nxx + Nzz) * turn[1] - Nyx * turn[0],
        -(Nzx * turn[0]) - Nzy * turn[1],
    )
    lift = (-a[1], a[0], 0)  # e x a
    position = (
        plus((-of.f[1], of.f[0], 0), lam.times(h), cross(turn, p), scaled(-m, lift)),
        plus((-of.n[1], of.n[0], 0), _axial(lam, k), coriolis_moment, scaled(-1, cross(h, lift))),
    )
    twice = (
        w[1] * k.xx - w[0] * k.xy - Nzx,
        w[1] * k.xy - w[0] * k.yy - Nzy,
        w[1] * k.xz - w[0] * k.yz + (Nxx + Nyy),
    )
    return _Wrenches(inertia, velocity, position, twice)


def _carry_down(
    at: Moving,
    i: int,
    of: _Wrenches,
    links: Sequence[_Link],
    reach: Sequence[Vector],
    into: tuple[Matrix, Matrix],
    times: int,
) -> None:
    """Column and row ``i`` of the matrices, from the wrenches of joint ``i``."""
    arm, turns = at.arm, at.turns
    by_q, by_qd = into

    def component(j: int, wrench: tuple[Vector, Vector]) -> Any:
        return wrench[1][2] if arm.bodies[j].revolute else wrench[0][2]

    def felt(j: int, inertia: tuple[Vector, Vector], twice: Vector) -> tuple[Any, Any]:
        """What joint ``i`` feels of joint ``j``'s position and velocity."""
        (x, y, _), lam, (ax, ay, _) = scaled(times, links[j].w), links[j].lam.rows, links[j].a
        force, moment = inertia
        if arm.bodies[j].revolute:
            by_position = (
                dot(moment, (lam[0][2], lam[1][2], lam[2][2]))
                + (force[0] * ay - force[1] * ax)
                + (twice[0] * links[j].w[1] - twice[1] * links[j].w[0])
            )
            return by_position, twice[2] + (moment[0] * y - moment[1] * x)
        return dot(force, (lam[0][2], lam[1][2], lam[2][2])), force[0] * y - force[1] * x

    by_qd[i][i] = component(i, of.velocity)
    by_q[i][i] = component(i, of.position)
    wrenches, twice = [of.inertia, of.velocity, of.position], of.twice
    for j in reversed(range(i)):
        child = arm.bodies[j + 1]
        c, s = child.cos_alpha, child.sin_alpha
        twice = about_x(c, s, twice)
        moved = []
        for force, moment in wrenches:
            f, n = about_x(c, s, force), about_x(c, s, moment)
            moved.append((f, plus(n, cross(reach[j], f))))
        wrenches = moved
        # The origin of joint j + 1 moves relative to that of joint j.
        twice = plus(twice, cross(_velocity(at, links, reach, j, times), wrenches[0][0]))
        if not turns.follows[j + 1]:
            c, s = turns.c[j], turns.s[j]
            twice = about_z(c, s, twice)
            wrenches = [(about_z(c, s, f), about_z(c, s, n)) for f, n in wrenches]
        by_qd[j][i] = component(j, wrenches[1])
        by_q[j][i] = component(j, wrenches[2])
        by_q[i][j], by_qd[i][j] = felt(j, wrenches[0], twice)


def _velocity(at: Moving, links: Sequence[_Link], reach: Sequence[Vector], j: int, times: int) -> Vector:
    """``times`` the velocity of the origin of link ``j + 1`` relative to that of link ``j``, along the axes
    of ``reach``."""
    child, turns = at.arm.bodies[j + 1], at.turns
    w = links[j].w
    if not turns.follows[j + 1]:
        w = about_z(turns.c[j], -turns.s[j], w)
    velocity = cross(scaled(times, w), reach[j])
    if not child.revolute:
        rate = times * at.motion.qd[j + 1]
        velocity = plus(velocity, (0, -(child.sin_alpha * rate), child.cos_alpha * rate))
    return velocity
