"""Appendix A: Lagrange's equations in closed form and Hollerbach's two recursions, a slip at a time.

The right forms are ``lagrange``, ``lagrange_4x4`` and ``lagrange_3x3`` of :mod:`robodyn.thesis.formulations`,
here once more, with a ``slip`` that says which term is as it is printed.
Where the print cannot be computed as it stands (a scalar product of vectors of unequal length) the nearest
reading that can is taken; the table says which. Source: Dhanaraj 1990, A.1 to A.3.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from robodyn.dynamics.arm import Arm, Motion, origin
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.transforms import (
    ZERO_3,
    ZERO_4,
    Matrix,
    applied,
    first_moment,
    homogeneous,
    inner,
    outer,
    product,
    pseudo_inertia,
    second_moment,
    summed,
    times,
    trace,
    transposed,
    turned,
)
from robodyn.dynamics.vectors import ZERO, plus, scaled, unmarked
from robodyn.thesis.formulations.lagrange import transform_slopes, weighed
from robodyn.thesis.formulations.lagrange_4x4 import moving_links
from robodyn.thesis.slips import Comparison
from robodyn.thesis.slips.recursion import against_newton_euler

#: The arm of the thesis's Lagrangian program D.1.1, and one with products of inertia.
ROBOT: Final = "puma560_3dof_d11"
FULL: Final = "puma560_full"


def of_equations(form: str, slip: str) -> Comparison:
    """Equations with ``slip`` and the right ones against Newton-Euler."""
    equations: dict[str, Callable[..., list[Any]]] = {
        "A.1": closed_form, "A.2": recursive_4x4, "A.3": recursive_3x3
    }  # fmt: skip
    run = equations[form]
    name = FULL if slip == "products" else ROBOT
    return against_newton_euler(name, lambda at: run(*at, slip), lambda at: run(*at))


def closed_form(arm: Arm, motion: Motion, slip: str = "") -> list[Any]:
    """A.1: ``tau_i = sum_j [ sum_k tr(U_jk J_j U_ji^T) qdd_k + sum_km tr(U_jkm J_j U_ji^T) qd_k qd_m
    - m_j g^T U_ji r_j ]`` over the links ``j >= i``, ``U_jk`` the derivative of ``T_j`` by joint k.

    Slips: ``first``: the first sum has ``U_ij J_i U_ik^T``; ``second``: the second has ``J_i``; ``weight``:
    gravity lacks ``r_j``, read as acting at the frame's origin.
    """
    links = transform_slopes(arm, motion, unmarked)
    J = [pseudo_inertia(body) for body in arm.bodies]
    n = len(arm.bodies)
    g = (*arm.gravity, 0)

    def U(j: int, k: int) -> Matrix:
        return links[j].first[k] if k <= j else ZERO_4

    torques = []
    for i in range(n):
        total: Any = arm.bodies[i].motor_inertia * motion.qdd[i]
        for j in range(i, n):
            slope = U(j, i)
            for k in range(j + 1):
                inertial = (
                    weighed(U(i, j), J[i], U(i, k)) if slip == "first" else weighed(U(j, k), J[j], slope)
                )
                total = total + inertial * motion.qdd[k]
                for m in range(j + 1):
                    centrifugal = weighed(links[j].second(k, m), J[i if slip == "second" else j], slope)
                    total = total + centrifugal * motion.qd[k] * motion.qd[m]
            r = homogeneous(ZERO if slip == "weight" else arm.bodies[j].com)
            total = total - arm.bodies[j].mass * inner(g, applied(slope, r))
        torques.append(total)
    return torques


# --- the recursions ---------------------------------------------------------------------------------------


def recursive_4x4(arm: Arm, motion: Motion, slip: str = "") -> list[Any]:
    """A.2: ``D_i = J_i T''_i^T + A_(i+1) D_(i+1)``, ``c_i = m_i r_i + A_(i+1) c_(i+1)``,
    ``tau_i = tr(dT_i/dq_i D_i) - g^T dT_i/dq_i c_i``.

    Slips: ``slower``: D has the first derivative of T; ``from_base``: the transform of link i + 1 is the one
    from frame 0; ``turned``: c has ``T_i`` before ``r_i``; ``products``: the pseudo-inertia takes the
    tensor's entries ``I_xy`` for integrals of ``x y``.
    """
    links = moving_links(arm, motion, unmarked)
    g = (*arm.gravity, 0)
    D, c = ZERO_4, (0, 0, 0, 0)
    torques: list[Any] = [None] * len(links)
    for i in reversed(range(len(links))):
        body, at, J = arm.bodies[i], links[i], pseudo_inertia(arm.bodies[i])
        if slip == "products":
            xy, xz, yz = body.inertia.xy, body.inertia.xz, body.inertia.yz
            J = summed(J, times(2, ((0, xy, xz, 0), (xy, 0, yz, 0), (xz, yz, 0, 0), (0, 0, 0, 0))))
        share = product(J, transposed(at.Wd if slip == "slower" else at.Wdd))
        r = tuple(body.mass * x for x in homogeneous(body.com))
        if slip == "turned":
            r = applied(at.A, r)
        if i + 1 < len(links):
            beyond = links[i + 1].W if slip == "from_base" else links[i + 1].A
            D, c = product(beyond, D), applied(beyond, c)
        D, c = summed(share, D), tuple(x + y for x, y in zip(r, c, strict=True))
        torque = trace(product(at.dW, D)) - inner(g, applied(at.dW, c))
        torques[i] = joint_torque(arm, i, motion, torque, unmarked)
    return torques


def recursive_3x3(arm: Arm, motion: Motion, slip: str = "") -> list[Any]:
    """A.3: ``D_i = R_(i+1) D_(i+1) + p_(i+1) e_(i+1)^T + m s r''^T + J R''^T``,
    ``e_i = e_(i+1) + m r'' + m R'' s``, ``c_i = m s + R_(i+1) c_(i+1) + p_(i+1) M_(i+1)``, ``M_(i+1)`` the
    mass from link i + 1 on; ``r''`` is the acceleration of the frame's origin.

    Slips: ``from_base``: R of link i + 1 is the one from frame 0; ``divided``: D has ``s / m``; ``turned``:
    ``e_(i+1)`` is turned by R; ``last``: the last term of e is ``s / m`` times ``r''``, read entry by entry;
    ``at_joint``: c lacks the offset.
    """
    links = moving_links(arm, motion, unmarked)
    D, e, c, beyond_mass = ZERO_3, ZERO, ZERO, 0
    torques: list[Any] = [None] * len(links)
    for i in reversed(range(len(links))):
        body, at = arm.bodies[i], links[i]
        Wdd, slope = _turn(at.Wdd), _turn(at.dW)
        x, y, z = (row[3] for row in at.Wdd[:3])
        s = first_moment(body)
        light = tuple(u / body.mass if body.mass else 0 * u for u in body.com)
        share = outer(light if slip == "divided" else s, (x, y, z))
        share = summed(share, product(second_moment(body), transposed(Wdd)))
        last = (light[0] * x, light[1] * y, light[2] * z) if slip == "last" else turned(Wdd, s)
        if i + 1 < len(links):
            R = _turn(links[i + 1].W if slip == "from_base" else links[i + 1].A)
            p = origin(arm.bodies[i + 1], motion.d[i + 1])
            share = summed(product(R, D), outer(p, e), share)
            c = plus(turned(R, c), ZERO if slip == "at_joint" else scaled(beyond_mass, p))
            e = turned(R, e) if slip == "turned" else e
        D = share
        e = plus(e, scaled(body.mass, (x, y, z)), last)
        c = plus(s, c)
        beyond_mass = beyond_mass + body.mass
        torque = trace(product(slope, D)) - inner(arm.gravity, turned(slope, c))
        torques[i] = joint_torque(arm, i, motion, torque, unmarked)
    return torques


def _turn(T: Matrix) -> Matrix:
    return tuple(row[:3] for row in T[:3])
