"""Modified Newton-Euler on base parameters: lambda with first and second moments.

With ``F = m a + lambda h`` and the moment about the frame's origin straight from moments of mass, the
masses may be zero or negative and the arm's parameters regrouped (:mod:`robodyn.dynamics.regroup`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.arm import Arm, Motion, Symmetric, about_x, about_z, origin
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.modified_newton_euler import NO_ROTATION, Kinematics, inertia_moment, lambda_matrix
from robodyn.dynamics.parallel import Turns
from robodyn.dynamics.regroup import Lump, MomentForm
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, named, plus, scaled, unmarked


def second_moment_moment(k: Symmetric, at: Kinematics) -> Vector:
    """The integral of ``r x lambda r``: the antisymmetric part of ``lambda K``."""
    (l11, l12, l13), (l21, l22, l23), (l31, l32, l33) = at.lam.rows
    return (
        (l32 * k.yy - l23 * k.zz) + (l33 - l22) * k.yz + (l31 * k.xy - l21 * k.xz),
        (l13 * k.zz - l31 * k.xx) + (l11 - l33) * k.xz + (l12 * k.yz - l32 * k.xy),
        (l21 * k.xx - l12 * k.yy) + (l22 - l11) * k.xy + (l23 * k.xz - l13 * k.yz),
    )


def base_newton_euler(
    arm: Arm,
    motion: Motion,
    turns: Turns,
    lumps: Sequence[Lump],
    forms: Sequence[MomentForm],
    mark: Mark = unmarked,
) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) from moments of mass about the frames' origins."""
    links = _forward(arm, motion, turns, mark)
    forces: list[Vector] = []
    moments: list[Vector] = []
    for i, (at, lump, form) in enumerate(zip(links, lumps, forms, strict=True)):
        force = plus(scaled(lump.mass, at.a), at.lam.times(lump.first))
        forces.append(named(mark, force, i + 1, "fc"))
        if form == "inertia":
            turning = inertia_moment(lump.inertia(), at)
        else:
            turning = second_moment_moment(lump.second, at)
        moments.append(named(mark, plus(turning, cross(lump.first, at.a)), i + 1, "nc"))
    return _backward(arm, motion, turns, links, forces, moments, mark)


def _forward(arm: Arm, motion: Motion, turns: Turns, mark: Mark) -> list[Kinematics]:
    """Velocities, accelerations and lambda matrices from base to tip.

    ``w0, alpha0, a0`` are along the axes in which the link's chain begins to turn: of what carries the
    chain, and of the link's origin.
    """
    gx, gy, gz = arm.gravity
    at = Kinematics(ZERO, ZERO, NO_ROTATION, (-gx, -gy, -gz), ZERO)
    w0 = alpha0 = a0 = ZERO
    links = []
    for i, body in enumerate(arm.bodies):
        p = origin(body, motion.d[i])
        step = at.lam.times(p)
        if turns.follows[i]:
            a0 = plus(a0, about_z(turns.c[i - 1], turns.s[i - 1], step))
        else:
            w0, alpha0, a0 = at.w, at.alpha, plus(at.a, step)
        w0, alpha0, a0 = (about_x(body.cos_alpha, -body.sin_alpha, u) for u in (w0, alpha0, a0))
        c, s, rate = turns.c[i], -turns.s[i], turns.rate[i]
        w, alpha, a = about_z(c, s, w0), about_z(c, s, alpha0), about_z(c, s, a0)
        if body.revolute:
            alpha = plus(alpha, (w[1] * rate, -(w[0] * rate), turns.acceleration[i]))
            w = plus(w, (0, 0, rate))
        w = named(mark, w, i + 1, "w")
        alpha = named(mark, alpha, i + 1, "alpha")
        if not body.revolute:
            twice = 2 * rate
            a = plus(a, (twice * w[1], -(twice * w[0]), turns.acceleration[i]))
        lam = lambda_matrix(w, alpha, i + 1, mark)
        at = Kinematics(w, alpha, lam, named(mark, a, i + 1, "a"), p)
        links.append(at)
    return links


def _backward(
    arm: Arm,
    motion: Motion,
    turns: Turns,
    links: list[Kinematics],
    forces: list[Vector],
    moments: list[Vector],
    mark: Mark,
) -> list[Any]:
    """Forces and moments from tip to base; the torques [n].

    ``f0, n0`` act through the joint, along the axes in which its chain begins to turn.
    """
    n = len(arm.bodies)
    torques: list[Any] = [None] * n
    f0 = n0 = ZERO
    for i in reversed(range(n)):
        c, s = turns.c[i], turns.s[i]
        f, moment = forces[i], moments[i]
        if i + 1 == n:
            f0, n0 = about_z(c, s, f), about_z(c, s, moment)
        else:
            child = arm.bodies[i + 1]
            f0, n0 = (about_x(child.cos_alpha, child.sin_alpha, u) for u in (f0, n0))
            if turns.follows[i + 1]:
                arm_of_force = about_z(c, s, links[i + 1].p)
                n0 = plus(about_z(c, s, moment), cross(arm_of_force, f0), n0)
                f0 = plus(about_z(c, s, f), f0)
            else:
                moment = named(mark, plus(moment, cross(links[i + 1].p, f0), n0), i + 1, "n")
                f = named(mark, plus(f, f0), i + 1, "f")
                f0, n0 = about_z(c, s, f), about_z(c, s, moment)
        f0 = named(mark, f0, i + 1, "f0")
        n0 = named(mark, n0, i + 1, "n0")
        torques[i] = joint_torque(arm, i, motion, n0[2] if arm.bodies[i].revolute else f0[2], mark)
    return torques
