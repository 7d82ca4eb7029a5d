"""The recursive Lagrangian with 3x3 rotations and position vectors, over any scalar.

The rotations ``W_i`` from link i's axes to the base's and their derivatives as in :mod:`.lagrange_4x4`;
besides, with ``p_i`` the origin of frame i in frame i - 1, its acceleration ``pdd_i`` along the base's axes,
``n_i = m_i r_i``, and ``J_i`` the second moment of mass, all about the frame's origin:

    pdd_i = pdd_{i-1} + Wdd_{i-1} p_i,
    D_i   = R_{i+1} D_{i+1} + p_{i+1} e_{i+1}^T + n_i pdd_i^T + J_i Wdd_i^T,
    e_i   = e_{i+1} + m_i pdd_i + Wdd_i n_i,      h_i = n_i + R_{i+1} h_{i+1} + (m_{i+1} + ... + m_n) p_{i+1},
    tau_i = tr(dW_i/dq_i D_i) - g^T dW_i/dq_i h_i.

Source: J. M. Hollerbach 1980, A Recursive Lagrangian Formulation of Manipulator Dynamics and a Comparative
Study of Dynamics Formulation Complexity, IEEE Trans. SMC-10 (11), where ``h`` is ``c``, joints are revolute
and origins turn with their own joint, which in these frames they do not. It was not at hand: the equations
are those that later texts quote. A prismatic joint's force is ``dp_i/dq_i . (e_i - m g)``, ``m`` the mass
that it carries.

``W_{i-1} dR_i/dq_i`` stands three times, as it was counted; in a graph it is one value.
"""

from __future__ import annotations

from typing import Any

from robodyn.dynamics.arm import Arm, Motion, origin
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.transforms import (
    IDENTITY_3,
    TURN_3,
    ZERO_3,
    Matrix,
    first_moment,
    inner,
    marked,
    outer,
    product,
    rotation,
    second_moment,
    summed,
    trace,
    transposed,
    turned,
)
from robodyn.dynamics.vectors import ZERO, Mark, Vector, named, plus, scaled, unmarked
from robodyn.thesis.formulations.lagrange_4x4 import passed_on


def lagrange_3x3(arm: Arm, motion: Motion, mark: Mark = unmarked) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of ``arm`` in ``motion``."""
    n = len(arm.bodies)
    W, Wd, Wdd = IDENTITY_3, ZERO_3, ZERO_3
    pdd: Vector = ZERO
    rotations, origins, turns, slides = [], [], [], []
    slopes: list[Matrix] = []  # dW/dq; at a prismatic joint dp/dq, a row
    for i, body in enumerate(arm.bodies):
        qd, qdd = motion.qd[i], motion.qdd[i]
        R = marked(mark, rotation(body, motion.c[i], motion.s[i]), i + 1, "R")
        p = origin(body, motion.d[i])
        pdd = plus(pdd, turned(Wdd, p))
        if body.revolute:
            dR = marked(mark, product(R, TURN_3), i + 1, "dR")
            ddR = marked(mark, product(dR, TURN_3), i + 1, "ddR")
            Wd, Wdd, slope = passed_on((W, Wd, Wdd), (R, dR, ddR), qd, qdd)
        else:
            axis: Vector = (0, -body.sin_alpha, body.cos_alpha)  # dp/dq
            slope = (turned(W, axis),)
            pdd = plus(pdd, scaled(2 * qd, turned(Wd, axis)), scaled(qdd, turned(W, axis)))
            Wd, Wdd = product(Wd, R), product(Wdd, R)
        W = marked(mark, product(W, R), i + 1, "W")
        Wd = marked(mark, Wd, i + 1, "Wd")
        Wdd = marked(mark, Wdd, i + 1, "Wdd")
        pdd = named(mark, pdd, i + 1, "pdd")
        slopes.append(marked(mark, slope, i + 1, "dW" if body.revolute else "dp"))
        rotations.append(R)
        origins.append(p)
        turns.append(Wdd)
        slides.append(pdd)

    D, e, h, mass = ZERO_3, ZERO, ZERO, 0
    torques: list[Any] = [None] * n
    for i in reversed(range(n)):
        body = arm.bodies[i]
        Wdd, pdd, moment = turns[i], slides[i], first_moment(body)
        D_i = summed(outer(moment, pdd), product(second_moment(body), transposed(Wdd)))
        h_i = moment
        if i + 1 < n:
            R, p = rotations[i + 1], origins[i + 1]
            D_i = summed(product(R, D), outer(p, e), D_i)
            h_i = plus(h_i, turned(R, h), scaled(mass, p))
        D = marked(mark, D_i, i + 1, "D")
        e = named(mark, plus(e, scaled(body.mass, pdd), turned(Wdd, moment)), i + 1, "e")
        h = named(mark, h_i, i + 1, "h")
        mass = mass + body.mass
        if body.revolute:
            torque = trace(product(slopes[i], D)) - inner(arm.gravity, turned(slopes[i], h))
        else:
            (axis,) = slopes[i]
            torque = inner(axis, plus(e, scaled(-mass, arm.gravity)))
        torques[i] = joint_torque(arm, i, motion, torque, mark)
    return torques
