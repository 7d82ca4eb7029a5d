"""Lagrange's equations in closed form, over any scalar.

``tau_i = sum_j D_ij qdd_j + sum_jk D_ijk qd_j qd_k + D_i``, each a sum over the links p that all its joints
carry,

    D_ij  = tr(dW_p/dq_i J_p (dW_p/dq_j)^T),
    D_ijk = tr(dW_p/dq_i J_p (d2W_p/dq_j dq_k)^T),
    D_i   = -m_p g^T dW_p/dq_i r_p,

``W_p`` the 4x4 transform from link p's frame to the base, ``J_p`` its pseudo-inertia. Sources: J. J. Uicker
1965, On the Dynamic Analysis of Spatial Linkages Using 4x4 Matrices; M. E. Kahn 1969, The Near-Minimum-Time
Control of Open-Loop Articulated Kinematic Chains; in this notation R. P. Paul, Robot Manipulators (1981),
chapter 6. None of them was at hand: the equations are those that every later text quotes.

The operations grow with n^4. ``D_ij = D_ji`` is used; each ``D_ijk`` is formed for itself, product by
product, as the counts of 1980 have it. (In a graph ``D_ijk`` and ``D_ikj`` are one value, and what two traces
have in common is there once.)
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from robodyn.dynamics.arm import Arm, Motion
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.transforms import (
    IDENTITY_4,
    Matrix,
    applied,
    homogeneous,
    inner,
    joint_operator,
    marked,
    product,
    pseudo_inertia,
    trace,
    transform,
    transposed,
)
from robodyn.dynamics.vectors import Mark, unmarked
from robodyn.ir.program import Label


@dataclass(frozen=True, slots=True)
class Slopes:
    """Derivatives of a link's transform ``W`` [4, 4] with respect to the joints up to its own."""

    first: tuple[Matrix, ...]
    """``dW/dq_j`` at ``[j]``."""
    half: tuple[tuple[Matrix, ...], ...]
    """``d2W/dq_j dq_k`` at ``[j][k]`` for ``k <= j``."""

    def second(self, j: int, k: int) -> Matrix:
        """``d2W/dq_j dq_k``."""
        return self.half[max(j, k)][min(j, k)]


def transform_slopes(arm: Arm, motion: Motion, mark: Mark) -> list[Slopes]:
    """The derivatives of every link's transform; a joint's own are ``A Q`` and ``A Q Q``."""
    W = IDENTITY_4
    first: list[Matrix] = []
    half: list[list[Matrix]] = []
    links = []
    for p, body in enumerate(arm.bodies, 1):
        Q = joint_operator(body)
        A = marked(mark, transform(body, motion.c[p - 1], motion.s[p - 1], motion.d[p - 1]), p, "A")
        dA = marked(mark, product(A, Q), p, "dA")
        ddA = marked(mark, product(dA, Q), p, "ddA")
        half = [[product(x, A) for x in row] for row in half]
        half.append([*(product(x, dA) for x in first), product(W, ddA)])
        first = [*(product(x, A) for x in first), product(W, dA)]
        W = marked(mark, product(W, A), p, "W")
        first = [marked(mark, x, p, "dW", f"{j}_") for j, x in enumerate(first, 1)]
        half = [
            [marked(mark, x, p, "ddW", f"{j}_{k}_") for k, x in enumerate(row, 1)]
            for j, row in enumerate(half, 1)
        ]
        links.append(Slopes(tuple(first), tuple(map(tuple, half))))
    return links


def lagrange(arm: Arm, motion: Motion, mark: Mark = unmarked) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of ``arm`` in ``motion``."""
    joints = range(len(arm.bodies))
    links = transform_slopes(arm, motion, mark)
    J = [pseudo_inertia(body) for body in arm.bodies]
    g = tuple(mark(x, Label(0, "g", str(k))) for k, x in enumerate((*arm.gravity, 0), 1))

    def inertial(i: int, j: int) -> Any:
        carried = range(max(i, j), len(joints))
        terms = [weighed(links[p].first[i], J[p], links[p].first[j]) for p in carried]
        return mark(added(terms), Label(i + 1, "m", str(j + 1)))

    def centrifugal(i: int, j: int, k: int) -> Any:
        carried = range(max(i, j, k), len(joints))
        terms = [weighed(links[p].first[i], J[p], links[p].second(j, k)) for p in carried]
        return mark(added(terms), Label(i + 1, "v", f"{j + 1}_{k + 1}"))

    def gravitational(i: int) -> Any:
        terms = []
        for p in joints[i:]:
            at = zip(homogeneous(arm.bodies[p].com), "1234", strict=True)
            r = tuple(mark(x, Label(p + 1, "r", axis)) for x, axis in at)
            terms.append(arm.bodies[p].mass * inner(g, applied(links[p].first[i], r)))
        return mark(-added(terms), Label(i + 1, "tg", ""))

    D: list[list[Any]] = [[0] * len(joints) for _ in joints]
    for i in joints:
        for j in joints[i:]:
            D[i][j] = D[j][i] = inertial(i, j)
    torques = []
    for i in joints:
        accelerating = [D[i][j] * motion.qdd[j] for j in joints]
        moving = [centrifugal(i, j, k) * (motion.qd[j] * motion.qd[k]) for j in joints for k in joints]
        torque = added([*accelerating, *moving, gravitational(i)])
        torques.append(joint_torque(arm, i, motion, torque, mark))
    return torques


def weighed(X: Matrix, J: Matrix, Y: Matrix) -> Any:
    """``tr(X J Y^T)``."""
    return trace(product(product(X, J), transposed(Y)))


def added(terms: list[Any]) -> Any:
    """Sum from left to right."""
    total = terms[0]
    for term in terms[1:]:
        total = total + term
    return total
