"""Kane's dynamical equations as inverse dynamics, over any scalar.

Generalised speeds are the joint rates, ``u_r = qd_r``; the coefficient of ``u_r`` in a velocity is the
partial velocity, in an angular velocity the partial angular velocity. Per joint

    F_r + F*_r = 0,
    F*_r = -sum_i (m_i ac_i . v_ri + (I_i alpha_i + w_i x I_i w_i) . w_ri),
    F_r  = tau_r + sum_i m_i g . v_ri,

with ``w_ri`` and ``v_ri`` the partial angular velocity of link i and the partial velocity of its centre
of mass for joint r. Gravity is an active force, as it is Kane's: turned into the axes of each link, it
joins the inertia force there, and both are dotted at once. (As an acceleration of the base, which is not
Kane's, it would not have to be turned, and take fewer operations.)

Source: Kane and Levinson 1983, The Use of Kane's Dynamical Equations in Robotics, Int. J. Robotics
Research 2(3); 1985, Dynamics: Theory and Applications, chapters 4 and 6. Neither was at hand: the equations
are the well-known ones, the arrangement is ours. The paper derives its equations by hand for the Stanford
arm. Here they are written for any arm, in link frames, and what a hand would see is left to the scalars: a
partial velocity that is zero or constant is a plain number. There is a pair of partial velocities for each
link and each joint up to it, so that the operations grow with n^2.
"""

from __future__ import annotations

from typing import Any

from robodyn.dynamics.arm import Arm, Body, Motion, into_child, origin
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.vectors import AXES, ZERO, Mark, Vector, cross, dot, named, plus, scaled, unmarked
from robodyn.ir.program import Label

AXIS: Vector = (0, 0, 1)
#: Partial angular velocity of a link and partial velocity of its frame's origin, along the link's axes.
Partial = tuple[Vector, Vector]


def kane(arm: Arm, motion: Motion, mark: Mark = unmarked) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of ``arm`` in ``motion``."""
    n = len(arm.bodies)
    torques: list[Any] = [0] * n
    partials: list[Partial] = []
    w, alpha, a, g = ZERO, ZERO, ZERO, arm.gravity
    for i, body in enumerate(arm.bodies):
        c, s, qd, qdd = motion.c[i], motion.s[i], motion.qd[i], motion.qdd[i]
        p = origin(body, motion.d[i])
        partials = propagated(partials, body, c, s, p)
        a = into_child(body, c, s, plus(a, cross(alpha, p), cross(w, cross(w, p))))
        w, alpha, g = (into_child(body, c, s, u) for u in (w, alpha, g))
        if body.revolute:
            alpha = plus(alpha, cross(w, (0, 0, qd)), (0, 0, qdd))
            w = plus(w, (0, 0, qd))
        else:
            a = plus(a, scaled(2, cross(w, (0, 0, qd))), (0, 0, qdd))
        w, alpha = named(mark, w, i + 1, "w"), named(mark, alpha, i + 1, "alpha")
        a, g = named(mark, a, i + 1, "ao"), named(mark, g, i + 1, "g")
        relative = plus(a, cross(alpha, body.com), cross(w, cross(w, body.com)))
        a_com = named(mark, minus(relative, g), i + 1, "ac")
        force = named(mark, scaled(body.mass, a_com), i + 1, "fc")
        momentum = body.inertia.times(w)
        moment = named(mark, plus(body.inertia.times(alpha), cross(w, momentum)), i + 1, "nc")
        for r, (turning, at_origin) in enumerate(partials):
            turning = each_joint(mark, turning, i + 1, "pw", r + 1)
            moving = each_joint(mark, plus(at_origin, cross(turning, body.com)), i + 1, "pv", r + 1)
            torques[r] = torques[r] + dot(force, moving) + dot(moment, turning)
    return [joint_torque(arm, r, motion, torque, mark) for r, torque in enumerate(torques)]


def propagated(partials: list[Partial], body: Body, c: Any, s: Any, p: Vector) -> list[Partial]:
    """The partial velocities of a link from those of its parent: one pair more.

    What the joints below do to the parent they do to the link, whose origin is at ``p`` [m] in the
    parent's frame; the link's own joint turns it about z or moves it along z.
    """
    carried: list[Partial] = [
        (into_child(body, c, s, turning), into_child(body, c, s, plus(moving, cross(turning, p))))
        for turning, moving in partials
    ]
    return [*carried, (AXIS, ZERO) if body.revolute else (ZERO, AXIS)]


def minus(u: Vector, v: Vector) -> Vector:
    """``u - v``."""
    return u[0] - v[0], u[1] - v[1], u[2] - v[2]


def each_joint(mark: Mark, vector: Vector, link: int, quantity: str, joint: int) -> Vector:
    """``vector`` with each component marked; the axis says for which joint: ``pw3_1x``."""
    x, y, z = (mark(u, Label(link, quantity, f"{joint}{axis}")) for u, axis in zip(vector, AXES, strict=True))
    return x, y, z
