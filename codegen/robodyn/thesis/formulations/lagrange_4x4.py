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

from typing import Any

from robodyn.dynamics.arm import Arm, Motion
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.transforms import (
    IDENTITY_4,
    ZERO_4,
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


def lagrange_4x4(arm: Arm, motion: Motion, mark: Mark = unmarked) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of ``arm`` in ``motion``."""
    n = len(arm.bodies)
    W, Wd, Wdd = IDENTITY_4, ZERO_4, ZERO_4
    transforms, slopes, accelerations = [], [], []
    for i, body in enumerate(arm.bodies):
        qd, qdd = motion.qd[i], motion.qdd[i]
        A = marked(mark, transform(body, motion.c[i], motion.s[i], motion.d[i]), i + 1, "A")
        dA = marked(mark, product(A, joint_operator(body)), i + 1, "dA")
        ddA = marked(mark, product(dA, joint_operator(body)), i + 1, "ddA")
        Wdd = summed(
            product(Wdd, A),
            times(2 * qd, product(Wd, dA)),
            times(qd * qd, product(W, ddA)),
            times(qdd, product(W, dA)),
        )
        Wd = summed(product(Wd, A), times(qd, product(W, dA)))
        dW = product(W, dA)
        W = marked(mark, product(W, A), i + 1, "W")
        Wd = marked(mark, Wd, i + 1, "Wd")
        Wdd = marked(mark, Wdd, i + 1, "Wdd")
        transforms.append(A)
        slopes.append(marked(mark, dW, i + 1, "dW"))
        accelerations.append(Wdd)

    g = tuple(mark(x, Label(0, "g", str(k))) for k, x in enumerate((*arm.gravity, 0), 1))
    D, h = ZERO_4, (0, 0, 0, 0)
    torques: list[Any] = [None] * n
    for i in reversed(range(n)):
        body = arm.bodies[i]
        D_i = product(pseudo_inertia(body), transposed(accelerations[i]))
        h_i = tuple(body.mass * x for x in homogeneous(body.com))
        if i + 1 < n:
            D_i = summed(D_i, product(transforms[i + 1], D))
            h_i = tuple(x + y for x, y in zip(h_i, applied(transforms[i + 1], h), strict=True))
        D = marked(mark, D_i, i + 1, "D")
        h = tuple(mark(x, Label(i + 1, "h", axis)) for x, axis in zip(h_i, "xyzm", strict=True))
        torque = trace(product(slopes[i], D)) - inner(g, applied(slopes[i], h))
        torques[i] = joint_torque(arm, i, motion, torque, mark)
    return torques
