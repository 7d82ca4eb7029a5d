"""Appendix A: Lagrange's equations in closed form and Hollerbach's two recursions, a slip at a time.

The right forms are ``lagrange``, ``lagrange_4x4`` and ``lagrange_3x3`` of :mod:`robodyn.thesis.formulations`,
here once more so that one term can be as it is printed.
Where the print cannot be computed as it stands (a scalar product of vectors of unequal length) the nearest
reading that can is taken; the table says which. Source: Dhanaraj 1990, A.1 to A.3.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

from robodyn.dynamics.arm import Arm, Body, Motion, origin
from robodyn.dynamics.transforms import (
    IDENTITY_4,
    TURN_4,
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
    transform,
    transposed,
)
from robodyn.dynamics.vectors import unmarked
from robodyn.thesis.formulations.lagrange import transform_slopes, weighed
from robodyn.thesis.slips.comparison import Comparison, compared
from robodyn.thesis.slips.recursion import bundled, newton_euler, scalars, stacked, states

#: The arm of the thesis's Lagrangian program D.1.1.
ROBOT: Final = "puma560_3dof_d11"
#: An arm with products of inertia.
FULL: Final = "puma560_full"
_AGAINST: Final = "torques by Newton-Euler of {}, 1000 states"
#: A column that is free of rotation: the origin of a frame.
_ORIGIN: Final = (0, 0, 0, 1)


def _of(name: str, slip: Any, right: Any) -> Comparison:
    robot = bundled(name)
    arm, motion = scalars(robot, states(robot))
    printed, mended = (stacked(run(arm, motion)) for run in (slip, right))
    return compared(printed, mended, newton_euler(name), "N m", _AGAINST.format(name))


# --- A.1, closed form -------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class ClosedForm:
    """``tau_i = sum_j [ sum_k tr(U_jk J_j U_ji^T) qdd_k + sum_km tr(U_jkm J_j U_ji^T) qd_k qd_m
    - m_j g^T U_ji r_j ]`` over the links ``j >= i``, ``U_jk`` the derivative of ``T_j`` by joint k.

    ``first``: whether the first sum has ``U_ij J_i U_ik^T``; ``second``: whether the second has ``J_i``;
    ``weight``: whether gravity lacks ``r_j``, read as acting at the frame's origin.
    """

    first: bool = False
    second: bool = False
    weight: bool = False

    def __call__(self, arm: Arm, motion: Motion) -> list[Any]:
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
                        weighed(U(i, j), J[i], U(i, k)) if self.first else weighed(U(j, k), J[j], slope)
                    )
                    total = total + inertial * motion.qdd[k]
                    for m in range(j + 1):
                        centrifugal = weighed(links[j].second(k, m), J[i if self.second else j], slope)
                        total = total + centrifugal * motion.qd[k] * motion.qd[m]
                r = _ORIGIN if self.weight else homogeneous(arm.bodies[j].com)
                total = total - arm.bodies[j].mass * inner(g, applied(slope, r))
            torques.append(total)
        return torques


def closed_form(slip: ClosedForm) -> Comparison:
    """The closed form with ``slip`` and the right one against Newton-Euler."""
    return _of(ROBOT, slip, ClosedForm())


# --- the recursions ---------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Moving:
    """Transforms ``A_i`` of the links in the frames before, and ``W, Wd, Wdd`` in the base's, with
    ``dW_i/dq_i``; revolute joints."""

    A: list[Matrix]
    W: list[Matrix]
    Wd: list[Matrix]
    Wdd: list[Matrix]
    slope: list[Matrix]


def _moving(arm: Arm, motion: Motion) -> _Moving:
    W, Wd, Wdd = IDENTITY_4, ZERO_4, ZERO_4
    moving = _Moving([], [], [], [], [])
    for i, body in enumerate(arm.bodies):
        qd, qdd = motion.qd[i], motion.qdd[i]
        A = transform(body, motion.c[i], motion.s[i], motion.d[i])
        dA = product(A, TURN_4)
        ddA = product(dA, TURN_4)
        turned = times(2 * qd, product(Wd, dA)), times(qd * qd, product(W, ddA)), times(qdd, product(W, dA))
        Wdd = summed(product(Wdd, A), *turned)
        slope = product(W, dA)
        Wd, W = summed(product(Wd, A), times(qd, slope)), product(W, A)
        for entries, matrix in zip(
            (moving.A, moving.W, moving.Wd, moving.Wdd, moving.slope), (A, W, Wd, Wdd, slope), strict=True
        ):
            entries.append(matrix)
    return moving


@dataclass(frozen=True, slots=True)
class Recursive4x4:
    """A.2: ``D_i = J_i T''_i^T + A_(i+1) D_(i+1)``, ``c_i = m_i r_i + A_(i+1) c_(i+1)``,
    ``tau_i = tr(dT_i/dq_i D_i) - g^T dT_i/dq_i c_i``.

    ``slower``: whether D has the first derivative of T; ``from_base``: whether the transform of link i + 1
    is the one from frame 0; ``turned``: whether c has ``T_i`` before ``r_i``; ``products``: whether the
    pseudo-inertia takes the tensor's entries ``I_xy`` for integrals of ``x y``.
    """

    slower: bool = False
    from_base: bool = False
    turned: bool = False
    products: bool = False

    def __call__(self, arm: Arm, motion: Motion) -> list[Any]:
        at = _moving(arm, motion)
        g = (*arm.gravity, 0)
        D, c = ZERO_4, (0, 0, 0, 0)
        torques: list[Any] = [None] * len(arm.bodies)
        for i in reversed(range(len(arm.bodies))):
            body = arm.bodies[i]
            rates = at.Wd[i] if self.slower else at.Wdd[i]
            r = tuple(body.mass * x for x in homogeneous(body.com))
            share = product(self._pseudo(body), transposed(rates))
            if self.turned:
                r = applied(at.A[i], r)
            if i + 1 < len(arm.bodies):
                beyond = at.W[i + 1] if self.from_base else at.A[i + 1]
                D, c = product(beyond, D), applied(beyond, c)
            D, c = summed(share, D), tuple(x + y for x, y in zip(r, c, strict=True))
            inertial = trace(product(at.slope[i], D)) - inner(g, applied(at.slope[i], c))
            torques[i] = inertial + body.motor_inertia * motion.qdd[i]
        return torques

    def _pseudo(self, body: Body) -> Matrix:
        right = pseudo_inertia(body)
        if not self.products:
            return right
        i = body.inertia
        signs = ((0, i.xy, i.xz, 0), (i.xy, 0, i.yz, 0), (i.xz, i.yz, 0, 0), (0, 0, 0, 0))
        return summed(right, times(2, signs))


def recursive_4x4(slip: Recursive4x4) -> Comparison:
    """The recursion A.2 with ``slip`` and the right one against Newton-Euler."""
    return _of(FULL if slip.products else ROBOT, slip, Recursive4x4())


@dataclass(frozen=True, slots=True)
class Recursive3x3:
    """A.3: ``D_i = R_(i+1) D_(i+1) + p_(i+1) e_(i+1)^T + m s r''^T + J R''^T``,
    ``e_i = e_(i+1) + m r'' + m R'' s``, ``c_i = m s + R_(i+1) c_(i+1) + p_(i+1) M_(i+1)``, ``M_(i+1)`` the
    mass from link i + 1 on; ``r''`` is the acceleration of the frame's origin.

    ``from_base``: whether R of link i + 1 is the one from frame 0; ``divided``: whether D has ``s / m``;
    ``turned``: whether ``e_(i+1)`` is turned by R; ``last``: whether the last term of e is ``s / m`` times
    ``r''``, read entry by entry; ``at_joint``: whether c lacks the offset.
    """

    from_base: bool = False
    divided: bool = False
    turned: bool = False
    last: bool = False
    at_joint: bool = False

    def __call__(self, arm: Arm, motion: Motion) -> list[Any]:
        at = _moving(arm, motion)
        D: Matrix = ((0, 0, 0),) * 3
        e: tuple[Any, ...] = (0, 0, 0)
        c: tuple[Any, ...] = (0, 0, 0)
        beyond_mass: Any = 0
        torques: list[Any] = [None] * len(arm.bodies)
        for i in reversed(range(len(arm.bodies))):
            body = arm.bodies[i]
            Wdd, slope = _turn(at.Wdd[i]), _turn(at.slope[i])
            speed = tuple(row[3] for row in at.Wdd[i][:3])
            s = first_moment(body)
            light = tuple(x / body.mass if body.mass else 0 * x for x in body.com)
            share = outer(light if self.divided else s, speed)
            share = summed(share, product(second_moment(body), transposed(Wdd)))
            last = tuple(x * y for x, y in zip(light, speed, strict=True)) if self.last else applied(Wdd, s)
            if i + 1 < len(arm.bodies):
                R = _turn(at.W[i + 1] if self.from_base else at.A[i + 1])
                p = origin(arm.bodies[i + 1], motion.d[i + 1])
                share = summed(product(R, D), outer(p, e), share)
                offset = (0, 0, 0) if self.at_joint else tuple(x * beyond_mass for x in p)
                c = tuple(x + y for x, y in zip(applied(R, c), offset, strict=True))
                e = applied(R, e) if self.turned else e
            D = share
            e = tuple(x + body.mass * y + z for x, y, z in zip(e, speed, last, strict=True))
            c = tuple(x + y for x, y in zip(s, c, strict=True))
            beyond_mass = beyond_mass + body.mass
            inertial = trace(product(slope, D)) - inner(arm.gravity, applied(slope, c))
            torques[i] = inertial + body.motor_inertia * motion.qdd[i]
        return torques


def recursive_3x3(slip: Recursive3x3) -> Comparison:
    """The recursion A.3 with ``slip`` and the right one against Newton-Euler."""
    return _of(ROBOT, slip, Recursive3x3())


def _turn(T: Matrix) -> Matrix:
    return tuple(row[:3] for row in T[:3])
