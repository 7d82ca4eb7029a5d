"""Torques of a rigid arm by its inertial numbers, one column for each; over any scalar.

Moments of mass about a frame's origin give a force and a moment of the link; virtual work carries them to the
joints: a unit rate of joint i moves link j, and what the force and the moment do then is the torque. So only
unit motions go out along the arm, six numbers a pair of joint and link, and no wrench comes back.

Source: Atkeson, An and Hollerbach 1986, with second moments in place of inertias: lambda times one is what
resists to turn (:mod:`~robodyn.dynamics.modified_newton_euler`).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Motion, about_x, about_z, origin
from robodyn.dynamics.joints import smoothed_sign
from robodyn.dynamics.modified_newton_euler import NO_ROTATION, Lambda, lambda_matrix
from robodyn.dynamics.momenta import Twist, gathered, twists
from robodyn.dynamics.parallel import Turns
from robodyn.dynamics.state import Posture
from robodyn.dynamics.vectors import ZERO, Mark, Pair, Vector, cross, named, plus, scaled, unmarked
from robodyn.effects.scalars import is_zero
from robodyn.ir.program import Label


class Accelerated(NamedTuple):
    """A link: ``lam`` and ``a``, the acceleration of its origin less gravity, along its own axes; along those
    in which it begins to turn ``start_a`` and the angular acceleration of what carries it."""

    lam: Lambda
    a: Vector
    alpha: Vector
    start_a: Vector
    carrier: Vector


def unit_torques(at: Posture, columns: Sequence[tuple[str, int]], mark: Mark = unmarked) -> list[list[Any]]:
    """Torques [n][columns] that a unit of each of ``columns`` takes: a quantity and its link (from 1)."""
    links = accelerated(at, mark)
    return [unit_torques_at(i, at, links, columns) for i in range(len(at.arm.bodies))]


def unit_torques_at(
    i: int, at: Posture, links: Sequence[Accelerated], columns: Sequence[tuple[str, int]]
) -> list[Any]:
    """The row of joint ``i`` (from 0), from the motion of ``links``: as far out as ``columns`` go."""
    units = _unit_motion(at, i, max((link for _, link in columns), default=0))
    row: list[Any] = []
    for quantity, link in columns:
        if quantity in _DRIVE:
            row.append(_DRIVE[quantity](at, i) if link == i + 1 else 0)
        elif link <= i:
            row.append(0)
        else:
            far, unit = links[link - 1], units[link - 1 - i]
            row.append(_WORK[quantity](unit.w, unit.v, far.lam.rows, far.a))
    return row


def torques_from(at: Posture, numbers: Mapping[tuple[str, int], Any], mark: Mark = unmarked) -> list[Any]:
    """Torques [n] of an arm whose links (from 1) and drives have these ``numbers`` by quantity and link; what
    is missing is 0."""
    own: list[Pair] = []
    for i, link in enumerate(accelerated(at, mark), 1):
        m, x, y, z, xx, yy, zz, xy, xz, yz = (numbers.get((quantity, i), 0) for quantity in _MOMENTS)
        L, h, a = link.lam.rows, (x, y, z), link.a
        force = plus(scaled(m, a), link.lam.times(h))
        moment = (
            yy * L[2][1] - zz * L[1][2] + xy * L[2][0] - xz * L[1][0] + yz * (L[2][2] - L[1][1]),
            zz * L[0][2] - xx * L[2][0] + yz * L[0][1] - xy * L[2][1] + xz * (L[0][0] - L[2][2]),
            xx * L[1][0] - yy * L[0][1] + xz * L[1][2] - yz * L[0][2] + xy * (L[1][1] - L[0][0]),
        )
        own.append((named(mark, force, i, "fc"), named(mark, plus(moment, cross(h, a)), i, "nc")))
    torques = []
    for i, (f, n) in enumerate(gathered(at, own, mark)):
        torque = n[2] if at.arm.bodies[i].revolute else f[2]
        for quantity, column in _DRIVE.items():
            value = numbers.get((quantity, i + 1), 0)
            if not is_zero(value):
                torque = torque + value * column(at, i)
        torques.append(mark(torque, Label(i + 1, "tau", "")))
    return torques


def _unit_motion(at: Posture, i: int, end: int) -> list[Twist]:
    """Velocities of the links from ``i`` (from 0) to before ``end`` at a unit rate of joint ``i`` alone: all
    before it is at rest."""
    some, motion, turns = slice(i, end), at.motion, at.turns
    bodies = at.arm.bodies[some]
    qd = [int(j == 0) for j in range(len(bodies))]
    follows = turns.follows[some]
    rate: list[Any] = []
    for j, body in enumerate(bodies):
        rate.append(body.cos_alpha * rate[-1] + qd[j] if rate and follows[j] else qd[j])
    moved = Motion(motion.c[some], motion.s[some], motion.d[some], tuple(qd), motion.qdd[some])
    turned = Turns(turns.c[some], turns.s[some], tuple(rate), turns.acceleration[some], follows)
    return twists(Posture(replace(at.arm, bodies=bodies), moved, turned))


def accelerated(at: Posture, mark: Mark = unmarked) -> list[Accelerated]:
    """The links [n] in motion."""
    arm, motion, turns = at.arm, at.motion, at.turns
    gx, gy, gz = arm.gravity
    velocities = twists(at, mark)
    before = Accelerated(NO_ROTATION, (-gx, -gy, -gz), ZERO, ZERO, ZERO)
    links = []
    for i, (body, twist) in enumerate(zip(arm.bodies, velocities, strict=True)):
        c, s, p = turns.c[i], turns.s[i], origin(body, motion.d[i])
        if turns.follows[i]:
            step = about_z(turns.c[i - 1], turns.s[i - 1], before.lam.times(p))
            alpha, a = before.carrier, plus(before.start_a, step)
        else:
            alpha, a = before.alpha, plus(before.a, before.lam.times(p))
        carrier, start_a = (about_x(body.cos_alpha, -body.sin_alpha, u) for u in (alpha, a))
        own_alpha = about_z(c, -s, carrier)
        (wx, wy, _), rate = twist.w, turns.rate[i]
        if body.revolute:
            own_alpha = plus(own_alpha, (wy * rate, -(wx * rate), turns.acceleration[i]))
        else:
            twice = 2 * motion.qd[i]
            wx, wy, _ = twist.start_w
            start_a = plus(start_a, (twice * wy, -(twice * wx), motion.qdd[i]))
        own_alpha = named(mark, own_alpha, i + 1, "alpha")
        own_a = named(mark, about_z(c, -s, start_a), i + 1, "a")
        lam = lambda_matrix(twist.w, own_alpha, i + 1, mark)
        before = Accelerated(lam, own_a, own_alpha, start_a, carrier)
        links.append(before)
    return links


#: The power of the force and the moment that a unit of a quantity takes, at the velocities ``w`` and ``v`` of
#: the link and its origin: ``L`` is its lambda, ``a`` the acceleration of its origin.
_Work = Callable[[Vector, Vector, Sequence[Vector], Vector], Any]


def _first(k: int) -> _Work:
    """A first moment along axis ``k``: the force is a column of lambda, the moment ``k x a``."""
    x, y = (k + 1) % 3, (k + 2) % 3
    return lambda w, v, L, a: v[0] * L[0][k] + v[1] * L[1][k] + v[2] * L[2][k] + (w[y] * a[x] - w[x] * a[y])


def _square(k: int) -> _Work:
    """A second moment along axis ``k``."""
    x, y = (k + 1) % 3, (k + 2) % 3
    return lambda w, v, L, a: w[y] * L[x][k] - w[x] * L[y][k]


def _product(k: int) -> _Work:
    """The mixed second moment of the axes other than ``k``."""
    x, y = (k + 1) % 3, (k + 2) % 3
    return lambda w, v, L, a: w[k] * (L[y][y] - L[x][x]) + w[x] * L[k][x] - w[y] * L[k][y]


_WORK: dict[str, _Work] = {
    "m": lambda w, v, L, a: v[0] * a[0] + v[1] * a[1] + v[2] * a[2],
    **{f"m{axis}": _first(k) for k, axis in enumerate("xyz")},
    **{f"K{axis}{axis}": _square(k) for k, axis in enumerate("xyz")},
    **{f"K{axes}": _product(k) for axes, k in (("xy", 2), ("xz", 1), ("yz", 0))},
}
_MOMENTS = tuple(_WORK)
_DRIVE: dict[str, Callable[[Posture, int], Any]] = {
    "rotor": lambda at, i: at.motion.qdd[i],
    "viscous": lambda at, i: at.motion.qd[i],
    "coulomb": lambda at, i: smoothed_sign(at.motion.qd[i], at.arm.rest_velocity, at.arm.dead_band),
}
