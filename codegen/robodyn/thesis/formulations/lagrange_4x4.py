"""The recursive Lagrangian with 4x4 transforms, over any scalar.

With ``W_i`` the transform from link i's frame to the base and ``W_i = W_{i-1} A_i``:

    Wd_i  = Wd_{i-1} A_i + W_{i-1} dA_i/dq_i qd_i,
    Wdd_i = Wdd_{i-1} A_i + 2 Wd_{i-1} dA_i/dq_i qd_i + W_{i-1} d2A_i/dq_i^2 qd_i^2 + W_{i-1} dA_i/dq_i qdd_i,
    D_i   = J_i Wdd_i^T + A_{i+1} D_{i+1},        h_i = m_i r_i + A_{i+1} h_{i+1},
    tau_i = tr(dW_i/dq_i D_i) - g^T dW_i/dq_i h_i.

Source: J. M. Hollerbach 1980, A Recursive Lagrangian Formulation of Manipulator Dynamics and a Comparative
Study of Dynamics Formulation Complexity, IEEE Trans. SMC-10 (11), where ``h`` is ``c``; the forward recursion
is R. C. Waters's (1979). Neither was at hand: the equations are those that later texts quote.

Written term by term as there: ``W_{i-1} dA_i/dq_i`` stands three times, as it was counted (see the test of
the general counts). In a graph it is one value.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from robodyn.dynamics.arm import Arm, Motion
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.transforms import (
    IDENTITY_4,
    ZERO_4,
    Matrix,
    applied,
    homogeneous,
    inner,
    joint_operator,
    marked,
    product,
    pseudo_inertia,
    summed,
    times,
    trace,
    transform,
    transposed,
)
from robodyn.dynamics.vectors import Mark, unmarked
from robodyn.ir.program import Label


class Moving(NamedTuple):
    """The transform ``A`` [4, 4] of a link in the frame before, and ``W, Wd, Wdd`` in the base's, with its
    derivative ``dW`` by the link's own joint."""

    A: Matrix
    W: Matrix
    Wd: Matrix
    Wdd: Matrix
    dW: Matrix


def passed_on(
    parent: tuple[Matrix, Matrix, Matrix], own: tuple[Matrix, Matrix, Matrix], qd: Any, qdd: Any
) -> tuple[Matrix, Matrix, Matrix]:
    """``Wd``, ``Wdd`` and ``dW/dq`` of a link by those of its parent (``W, Wd, Wdd``) and by its joint (``A``
    and two derivatives), of transforms or of rotations."""
    (W, Wd, Wdd), (A, dA, ddA) = parent, own
    accelerations = summed(
        product(Wdd, A),
        times(2 * qd, product(Wd, dA)),
        times(qd * qd, product(W, ddA)),
        times(qdd, product(W, dA)),
    )
    return summed(product(Wd, A), times(qd, product(W, dA))), accelerations, product(W, dA)


def moving_links(arm: Arm, motion: Motion, mark: Mark) -> list[Moving]:
    """The links of ``arm`` [n] in ``motion``, from base to tip."""
    W, Wd, Wdd = IDENTITY_4, ZERO_4, ZERO_4
    links = []
    for i, body in enumerate(arm.bodies):
        qd, qdd = motion.qd[i], motion.qdd[i]
        A = marked(mark, transform(body, motion.c[i], motion.s[i], motion.d[i]), i + 1, "A")
        dA = marked(mark, product(A, joint_operator(body)), i + 1, "dA")
        ddA = marked(mark, product(dA, joint_operator(body)), i + 1, "ddA")
        Wd, Wdd, dW = passed_on((W, Wd, Wdd), (A, dA, ddA), qd, qdd)
        W = marked(mark, product(W, A), i + 1, "W")
        Wd = marked(mark, Wd, i + 1, "Wd")
        Wdd = marked(mark, Wdd, i + 1, "Wdd")
        links.append(Moving(A, W, Wd, Wdd, marked(mark, dW, i + 1, "dW")))
    return links


def lagrange_4x4(arm: Arm, motion: Motion, mark: Mark = unmarked) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of ``arm`` in ``motion``."""
    n, links = len(arm.bodies), moving_links(arm, motion, mark)
    g = tuple(mark(x, Label(0, "g", str(k))) for k, x in enumerate((*arm.gravity, 0), 1))
    D, h = ZERO_4, (0, 0, 0, 0)
    torques: list[Any] = [None] * n
    for i in reversed(range(n)):
        body = arm.bodies[i]
        D_i = product(pseudo_inertia(body), transposed(links[i].Wdd))
        h_i = tuple(body.mass * x for x in homogeneous(body.com))
        if i + 1 < n:
            D_i = summed(D_i, product(links[i + 1].A, D))
            h_i = tuple(x + y for x, y in zip(h_i, applied(links[i + 1].A, h), strict=True))
        D = marked(mark, D_i, i + 1, "D")
        h = tuple(mark(x, Label(i + 1, "h", axis)) for x, axis in zip(h_i, "xyzm", strict=True))
        torque = trace(product(links[i].dW, D)) - inner(g, applied(links[i].dW, h))
        torques[i] = joint_torque(arm, i, motion, torque, mark)
    return torques
