"""The thesis's modified Newton-Euler recursion with the lambda matrix, over any scalar.

``lambda_i = [alpha_i x] + [w_i x]^2`` takes a position to its acceleration; it is formed once a link
and serves both the next origin and the centre of mass. Source: Dhanaraj 1990, Table 2.4, with its
misprints mended: ``R^T lambda R`` (not ``R lambda R^T``), ``k_z + alpha_z`` in lambda_21, the
``lambda_1 p_1`` term kept, a prismatic joint's variable in its own ``p``, ``f_z`` as a prismatic
joint's force, and rotor inertia on the diagonal.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Arm, Motion, into_child, into_parent, origin
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, named, plus, scaled, unmarked
from robodyn.ir.program import Label


class Lambda(NamedTuple):
    """The lambda matrix of a link and the products ``k = (w_y w_z, w_z w_x, w_x w_y)``."""

    rows: tuple[Vector, Vector, Vector]
    k: Vector

    def times(self, r: Vector) -> Vector:
        """``lambda r``: the acceleration of a point at ``r`` relative to the frame's origin."""
        x, y, z = (row[0] * r[0] + row[1] * r[1] + row[2] * r[2] for row in self.rows)
        return x, y, z


NO_ROTATION = Lambda((ZERO, ZERO, ZERO), ZERO)


def lambda_matrix(w: Vector, alpha: Vector, link: int, mark: Mark) -> Lambda:
    """Step 2A of the thesis: lambda from angular velocity and acceleration."""
    x, y, z = w

    def product(u: Any, v: Any, axes: str) -> Any:
        return mark(u * v, Label(link, "ww", axes))

    def entry(value: Any, axis: str) -> Any:
        return mark(value, Label(link, "lam", axis))

    kx, ky, kz = product(y, z, "yz"), product(z, x, "zx"), product(x, y, "xy")
    xx, yy, zz = product(x, x, "xx"), product(y, y, "yy"), product(z, z, "zz")

    return Lambda(
        (
            (entry(-(yy + zz), "11"), entry(kz - alpha[2], "12"), entry(ky + alpha[1], "13")),
            (entry(kz + alpha[2], "21"), entry(-(xx + zz), "22"), entry(kx - alpha[0], "23")),
            (entry(ky - alpha[1], "31"), entry(kx + alpha[0], "32"), entry(-(xx + yy), "33")),
        ),
        (kx, ky, kz),
    )


class Kinematics(NamedTuple):
    """One link of the forward pass: ``w``, ``alpha``, ``lambda``, acceleration ``a`` of the origin less
    gravity, and ``p``, the origin in the parent's frame."""

    w: Vector
    alpha: Vector
    lam: Lambda
    a: Vector
    p: Vector


def forward_pass(arm: Arm, motion: Motion, mark: Mark) -> list[Kinematics]:
    """Steps 1 to 3: velocities, accelerations and lambda matrices from base to tip."""
    gx, gy, gz = arm.gravity
    at = Kinematics(ZERO, ZERO, NO_ROTATION, (-gx, -gy, -gz), ZERO)
    links = []
    for i, body in enumerate(arm.bodies):
        c, s, qd, qdd = motion.c[i], motion.s[i], motion.qd[i], motion.qdd[i]
        p = origin(body, motion.d[i])
        w = into_child(body, c, s, at.w)
        alpha = into_child(body, c, s, at.alpha)
        if body.revolute:
            alpha = plus(alpha, (w[1] * qd, -(w[0] * qd), qdd))
            w = plus(w, (0, 0, qd))
        w = named(mark, w, i + 1, "w")
        alpha = named(mark, alpha, i + 1, "alpha")
        # A prismatic joint's link turns with its parent; formed anew, its lambda is R^T lambda R of the
        # parent's, and for a right-angled R the same nodes.
        lam = lambda_matrix(w, alpha, i + 1, mark)
        a = into_child(body, c, s, plus(at.a, at.lam.times(p)))
        if not body.revolute:
            twice = 2 * qd
            a = plus(a, (twice * w[1], -(twice * w[0]), qdd))
        a = named(mark, a, i + 1, "a")
        at = Kinematics(w, alpha, lam, a, p)
        links.append(at)
    return links


#: Force and moment in a joint.
Reaction = tuple[Vector, Vector]
NO_REACTION: Reaction = (ZERO, ZERO)


def modified_newton_euler(arm: Arm, motion: Motion, mark: Mark = unmarked) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) by Table 2.4, from centres of mass."""
    torques: list[Any] = [None] * len(arm.bodies)
    for i, f, moment in _inward(arm, motion, mark, NO_REACTION):
        torques[i] = joint_torque(arm, i, motion, moment[2] if arm.bodies[i].revolute else f[2], mark)
    return torques


def reactions(
    arm: Arm, motion: Motion, mark: Mark = unmarked, beyond: Reaction = NO_REACTION
) -> list[Reaction]:
    """Force [N] and moment [N m] of link i-1 on link i for each joint, base to tip, along the axes and about
    the origin of link i's frame (steps 7 and 8); ``beyond`` are those of the last link on what lies beyond
    it, in its frame."""
    return [(f, moment) for _, f, moment in _inward(arm, motion, mark, beyond)][::-1]


def beyond_the_last_link(arm: Arm, motion: Motion, w: Sequence[Any]) -> tuple[Vector, Vector]:
    """Force and moment of the last link on what pushes the tool with ``w`` [6], in that link's frame."""
    f, moment = (scaled(-1, arm.base.back(u)) for u in ((w[0], w[1], w[2]), (w[3], w[4], w[5])))
    for body, c, s in zip(arm.bodies, motion.c, motion.s, strict=True):
        f, moment = into_child(body, c, s, f), into_child(body, c, s, moment)
    return f, plus(moment, cross(arm.tool.origin, f))


def _inward(arm: Arm, motion: Motion, mark: Mark, beyond: Reaction) -> Iterator[tuple[int, Vector, Vector]]:
    """Joint (from 0), force and moment, tip to base."""
    forces: list[Vector] = []
    moments: list[Vector] = []
    links = forward_pass(arm, motion, mark)
    for i, (body, at) in enumerate(zip(arm.bodies, links, strict=True)):
        a_com = named(mark, plus(at.a, at.lam.times(body.com)), i + 1, "ac")
        force = named(mark, scaled(body.mass, a_com), i + 1, "fc")
        forces.append(force)
        moments.append(named(mark, inertia_moment(body.inertia, at), i + 1, "nc"))
    moments = [plus(m, cross(body.com, f)) for m, body, f in zip(moments, arm.bodies, forces, strict=True)]
    return backward_pass(arm, motion, links, forces, moments, mark, beyond)


def inertia_moment(inertia: Any, at: Kinematics) -> Vector:
    """Step 6, Euler's equation: ``I alpha + w x (I w)``, written with ``D`` and ``k`` (eq. 2.41).

    With a diagonal tensor this is ``I alpha + D k``, ``D = (Izz - Iyy, Ixx - Izz, Iyy - Ixx)``.
    """
    (x, y, z), (kx, ky, kz) = at.w, at.lam.k
    i = inertia
    turning = (
        (i.zz - i.yy) * kx + i.yz * (y * y - z * z) + i.xz * kz - i.xy * ky,
        (i.xx - i.zz) * ky + i.xz * (z * z - x * x) + i.xy * kx - i.yz * kz,
        (i.yy - i.xx) * kz + i.xy * (x * x - y * y) + i.yz * ky - i.xz * kx,
    )
    return plus(i.times(at.alpha), turning)


def backward_pass(
    arm: Arm,
    motion: Motion,
    links: list[Kinematics],
    forces: list[Vector],
    moments: list[Vector],
    mark: Mark,
    beyond: Reaction,
) -> Iterator[tuple[int, Vector, Vector]]:
    """Steps 7 and 8: ``f``, ``n`` from tip to base, each with its joint (from 0).

    ``forces[i]`` acts at the origin of link i's frame, ``moments[i]`` about it.
    """
    n = len(arm.bodies)
    f, moment = beyond
    for i in reversed(range(n)):
        body, c, s = arm.bodies[i], motion.c[i], motion.s[i]
        lever = links[i + 1].p if i + 1 < n else ZERO
        moment = plus(moments[i], cross(lever, f), moment)
        f = named(mark, plus(forces[i], f), i + 1, "f")
        moment = named(mark, moment, i + 1, "n")
        yield i, f, moment
        f = into_parent(body, c, s, f)
        moment = into_parent(body, c, s, moment)
