"""Forward dynamics by articulated bodies, over any scalar: operations grow with the joints, not their cube.

Each link, with all beyond it free to move in its joints, resists an acceleration ``(alpha, a)`` of its frame
with the moment ``A alpha + B a + n`` about and the force ``B^T alpha + M a + f`` at its origin. Source:
Featherstone 2008, chapter 7; in classical accelerations (those of the frame's origin), so that of the motion
nothing but the velocity of turning is needed.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Symmetric, about_x, about_z, into_child, origin
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.spatial import Spatial, inertia_of, less
from robodyn.dynamics.state import Moving
from robodyn.dynamics.vectors import ZERO, Mark, Pair, Vector, cross, dot, named, plus, scaled, unmarked
from robodyn.effects.scalars import is_zero
from robodyn.ir.program import Label


class Yielding(NamedTuple):
    """How a joint gives way, its axis being z: the moment and force ``along`` which the body that it carries
    resists a unit of its acceleration, the ``inverse`` of what that is along the joint itself, rotor
    included, their product, the ``share``, and what of the body is ``felt`` through the joint, about and at
    the same origin."""

    along: Pair
    inverse: Any
    share: Pair
    felt: Spatial


def origins_of(at: Moving) -> list[Vector]:
    """The origins of the links [n], along the axes of those before them."""
    return [origin(body, d) for body, d in zip(at.arm.bodies, at.motion.d, strict=True)]


def yielding(at: Moving, origins: Sequence[Vector], mark: Mark) -> list[Yielding]:
    """How the joints [n] give way, each with all that it carries free to move; ``origins`` [n] of the links
    along the axes of those before them."""
    joints: list[Yielding] = []
    for i in reversed(range(len(at.arm.bodies))):
        body = inertia_of(at.lumps[i])
        if joints:
            child, c, s = at.arm.bodies[i + 1], at.motion.c[i + 1], at.motion.s[i + 1]
            felt = joints[-1].felt.about_z(c, s).about_x(child.cos_alpha, child.sin_alpha)
            body = body.with_(felt.moved(origins[i + 1]))
        joints.append(_joint(at, i, body.named(i + 1, "i", mark), mark))
    return joints[::-1]


def articulated_bodies(at: Moving, tau: Sequence[Any], mark: Mark = unmarked) -> list[Any]:
    """Accelerations [n] (rad/s^2; m/s^2 at prismatic joints) that the torques ``tau`` [n] give."""
    arm, motion = at.arm, at.motion
    origins = origins_of(at)
    rates, carried = _rates(at, origins, mark)
    joints = yielding(at, origins, mark)
    # What of the torques is left for acceleration, tip to base.
    n, f = ZERO, ZERO
    left: list[Any] = []
    for i in reversed(range(len(joints))):
        link, joint, w = arm.bodies[i], joints[i], rates[i]
        n = named(mark, plus(cross(w, at.lumps[i].inertia().times(w)), n), i + 1, "n")
        f = named(mark, plus(cross(w, cross(w, at.lumps[i].first)), f), i + 1, "f")
        friction = joint_torque(arm, i, motion, 0, unmarked)
        left.append(tau[i] - friction - (n[2] if link.revolute else f[2]))
        moment, force = joint.felt.times(*carried[i])
        sn, sf = joint.share
        n, f = plus(n, moment, scaled(left[-1], sn)), plus(f, force, scaled(left[-1], sf))
        c, s, ca, sa = motion.c[i], motion.s[i], link.cos_alpha, link.sin_alpha
        n, f = (about_x(ca, sa, about_z(c, s, u)) for u in (n, f))
        n = plus(n, cross(origins[i], f))
    gx, gy, gz = arm.gravity
    alpha, a = ZERO, (-gx, -gy, -gz)
    accelerations = []
    for i, (link, joint) in enumerate(zip(arm.bodies, joints, strict=True)):
        c, s = motion.c[i], motion.s[i]
        a = plus(into_child(link, c, s, plus(a, cross(alpha, origins[i]))), carried[i][1])
        alpha = plus(into_child(link, c, s, alpha), carried[i][0])
        taken = dot(joint.along[0], alpha) + dot(joint.along[1], a)
        qdd = mark((left[-1 - i] - taken) * joint.inverse, Label(i + 1, "qdd", ""))
        accelerations.append(qdd)
        if link.revolute:
            alpha = plus(alpha, (0, 0, qdd))
        else:
            a = plus(a, (0, 0, qdd))
        alpha, a = named(mark, alpha, i + 1, "alpha"), named(mark, a, i + 1, "a")
    return accelerations


def _rates(
    at: Moving, origins: Sequence[Vector], mark: Mark
) -> tuple[list[Vector], list[tuple[Vector, Vector]]]:
    """The links' angular velocities, and what velocities add to their accelerations, angular and linear."""
    w: Vector = ZERO
    rates, carried = [], []
    for i, link in enumerate(at.arm.bodies):
        c, s, qd = at.motion.c[i], at.motion.s[i], at.motion.qd[i]
        linear = into_child(link, c, s, cross(w, cross(w, origins[i])))
        w = into_child(link, c, s, w)
        across = (w[1] * qd, -(w[0] * qd), 0)
        if link.revolute:
            w = plus(w, (0, 0, qd))
            carried.append((across, linear))
        else:
            carried.append((ZERO, plus(linear, scaled(2, across))))
        w = named(mark, w, i + 1, "w")
        rates.append(w)
    return rates, carried


def _joint(at: Moving, i: int, body: Spatial, mark: Mark) -> Yielding:
    link = at.arm.bodies[i]
    A, B, M = body.A, body.B, body.M
    if link.revolute:
        n, f = (A.xz, A.yz, A.zz), B[2]
        own = A.zz
    else:
        n, f = (B[0][2], B[1][2], B[2][2]), (M.xz, M.yz, M.zz)
        own = M.zz
    if not is_zero(link.motor_inertia):
        own = own + link.motor_inertia
    inverse = mark(Fraction(1) / mark(own, Label(i + 1, "pivot", "")), Label(i + 1, "ipivot", ""))
    sn, sf = scaled(inverse, n), scaled(inverse, f)
    A, M = less(A, sn, n), less(M, sf, f)
    one, two, three = (plus(row, scaled(-share, f)) for row, share in zip(B, sn, strict=True))
    if is_zero(link.motor_inertia):  # nothing is felt along the joint; written out it is only almost 0
        if link.revolute:
            A, three = Symmetric(A.xx, A.yy, 0, A.xy, 0, 0), ZERO
        else:
            M = Symmetric(M.xx, M.yy, 0, M.xy, 0, 0)
            one, two, three = ((row[0], row[1], 0) for row in (one, two, three))
    return Yielding((n, f), inverse, (sn, sf), Spatial(A, (one, two, three), M))
