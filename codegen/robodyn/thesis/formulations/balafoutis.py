"""The tensor recursion of Balafoutis, Patel and Misra, over any scalar.

Euler's equation in Cartesian tensors: with the angular acceleration tensor ``W = [alpha x] + [w x]^2`` (the
thesis's lambda) and the pseudo-inertia tensor ``K``, the integral of ``r r^T`` over the mass, the moment
that turns a body is the dual vector of the skew tensor ``W K - (W K)^T``. Everything a link does is then
``W`` times a constant.

Constant are the moments of *augmented* links: a link with the mass of all links beyond put at the origin of
the next frame. With ``M_i`` the mass of link i and beyond, ``p`` the next origin in link i's frame,

    h_i = m_i r_i + M_i+1 p,          K_i = J_i + m_i r_i r_i^T + M_i+1 p p^T,
    F_i = W_i h_i + F_i+1,            f_i = M_i a_i + F_i,
    n_i = dual(W_i K_i - (W_i K_i)^T) + h_i x a_i + p x F_i+1 + n_i+1,

so that no force of a single link is formed, nor acceleration of a centre of mass. Through a prismatic joint
the next origin moves, and mass is not put there: there ``F_i = f_i`` is handed down in full.

Source: Balafoutis, Patel and Misra 1988, Efficient Modeling and Computation of Manipulator Dynamics Using
Orthogonal Cartesian Tensors, IEEE J. Robotics and Automation 4(6); Balafoutis and Patel 1991, Dynamic
Analysis of Robot Manipulators: A Cartesian Tensor Approach. Neither was at hand: tensors, duals and
augmented links are what is generally known of them; the numbering of their equations, their frames and
their way with prismatic joints could not be checked. What speaks for the recursion being theirs is its
cost: 93 multiplications and 81 additions for a revolute joint where nothing is zero. For algorithm 5.7 of
the book, table 10.1 of Featherstone 2008, Rigid Body Dynamics Algorithms, gives 93 n - 108 and 81 n - 100
(as quoted by others).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.arm import Arm, Motion, Symmetric, into_parent
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.modified_newton_euler import Kinematics, forward_pass
from robodyn.dynamics.regroup import lumps_of
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, named, plus, scaled, unmarked


def balafoutis(arm: Arm, motion: Motion, mark: Mark = unmarked) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of ``arm`` in ``motion``."""
    links = forward_pass(arm, motion, mark)
    lumps = augmented_links(arm, [at.p for at in links])
    torques: list[Any] = [None] * len(links)
    force, moment = ZERO, ZERO
    for i in reversed(range(len(links))):
        body, at, lump = arm.bodies[i], links[i], lumps[i]
        turning = named(mark, dual_moment(at, lump.second), i + 1, "nc")
        moment = plus(turning, cross(lump.first, at.a), moment)
        if i + 1 < len(links):
            moment = plus(moment, cross(links[i + 1].p, force))
        force = plus(at.lam.times(lump.first), force)
        if not body.revolute:
            force = plus(force, scaled(lump.mass, at.a))
        force = named(mark, force, i + 1, "fw" if body.revolute else "f")
        moment = named(mark, moment, i + 1, "n")
        torques[i] = joint_torque(arm, i, motion, moment[2] if body.revolute else force[2], mark)
        force = into_parent(body, motion.c[i], motion.s[i], force)
        moment = into_parent(body, motion.c[i], motion.s[i], moment)
    return torques


def augmented_links(arm: Arm, origins: Sequence[Vector]) -> list[Lump]:
    """Mass [kg], first moment [kg m] and pseudo-inertia tensor [kg m^2] of the augmented links.

    ``origins`` [n] are the origins of the frames in the frame before [m]; of a prismatic joint it is not
    used, so that all is constant. ``mass`` includes what lies beyond, up to the next prismatic joint.
    """
    lumps = lumps_of(arm)
    for i in reversed(range(len(lumps) - 1)):
        if arm.bodies[i + 1].revolute:
            own, (x, y, z), beyond, k = lumps[i], origins[i + 1], lumps[i + 1].mass, lumps[i].second
            hx, hy, hz = beyond * x, beyond * y, beyond * z
            lumps[i] = Lump(
                own.mass + beyond,
                plus(own.first, (hx, hy, hz)),
                Symmetric(
                    k.xx + hx * x, k.yy + hy * y, k.zz + hz * z, k.xy + hx * y, k.xz + hx * z, k.yz + hy * z
                ),
            )
    return lumps


def dual_moment(at: Kinematics, k: Symmetric) -> Vector:
    """``dual(W K - (W K)^T)`` [N m], the moment about the origin by which a body turns with ``W`` [1/s^2].

    The dual of a skew tensor is the vector ``v`` with ``S u = v x u``: ``(S_zy, S_xz, S_yx)``. For a
    pseudo-inertia tensor ``K`` [kg m^2]; 15 multiplications and 15 additions.
    """
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = at.lam.rows
    return (
        zx * k.xy + zy * k.yy + (zz - yy) * k.yz - yx * k.xz - yz * k.zz,
        xy * k.yz + xz * k.zz + (xx - zz) * k.xz - zy * k.xy - zx * k.xx,
        yx * k.xx + yz * k.xz + (yy - xx) * k.xy - xy * k.yy - xz * k.yz,
    )
