"""Torques of a rigid arm by the standard inertial parameters of its links, along arrays of states.

A torque is linear in mass ``m``, first moments ``m c`` and second moments about the origin of the link's
frame. Newton and Euler of a link for one of ten unit parameters give a force and a moment along its axes;
they are handed from frame to frame to the base, all links at once.

Source: Khalil and Dombre, Modeling, Identification and Control of Robots (2002), ch. 9; Atkeson, An and
Hollerbach 1986. Arrays have the samples last: numpy is quickest along the last axis.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.dynamics.arm import Arm, Motion, build_motion, origin, trigonometry_at
from robodyn.dynamics.modified_newton_euler import forward_pass
from robodyn.dynamics.vectors import unmarked
from robodyn.robot.model import AXES

#: Entries of a symmetric tensor by row and column.
_ENTRIES = tuple(("xyz".index(axes[0]), "xyz".index(axes[1])) for axes in AXES)


@dataclass(frozen=True, slots=True, eq=False)
class Links:
    """The links of ``arm`` along ``samples`` states: what its recursion to the base needs."""

    arm: Arm
    motion: Motion
    rates: Sequence[Any]
    samples: int

    @classmethod
    def along(cls, arm: Arm, q: Floats, qd: Floats, qdd: Floats) -> Links:
        """At states [K, n]."""
        columns = [np.ascontiguousarray(x) for x in q.T]
        motion = build_motion(arm, columns, list(qd.T), list(qdd.T), trigonometry_at(columns), float)
        return cls(arm, motion, forward_pass(arm, motion, unmarked), len(q))

    def regressor(self) -> Floats:
        """Torques [n, 10 n, K]: joint, parameter (ten a link), sample; zero where a link is before the
        joint."""
        n, count = len(self.arm.bodies), self.samples
        Y = np.zeros((n, 10 * n, count))
        # Columns of the links beyond, outermost last: forces of four parameters a link, moments of ten.
        forces = np.zeros((3, 4 * n, count))
        moments = np.zeros((3, 10 * n, count))
        for i in range(n - 1, -1, -1):
            near, wide = slice(4 * i, 4 * n), slice(10 * i, 10 * n)
            _wrenches(self.rates[i], forces[:, 4 * i : 4 * i + 4], moments[:, 10 * i : 10 * i + 10])
            body = self.arm.bodies[i]
            if body.revolute:
                Y[i, wide] = moments[2, wide]
            else:
                Y[i, wide].reshape(n - i, 10, count)[:, :4] = forces[2, near].reshape(n - i, 4, count)
            if i == 0:
                break
            c, s = self.motion.c[i], self.motion.s[i]
            for vectors in (forces[:, near], moments[:, wide]):
                _into_parent(body.cos_alpha, body.sin_alpha, c, s, vectors)
            p = origin(body, self.motion.d[i])
            lever = _cross(p, forces[:, near]).reshape(3, n - i, 4, count)
            moments[:, wide].reshape(3, n - i, 10, count)[:, :, :4] += lever
        return Y

    def torques(self, parameters: Floats) -> Floats:
        """Torques [S, n, K] by ``parameters`` [S, n, 10]: of many arms that move alike."""
        n, sets = len(self.arm.bodies), len(parameters)
        tau = np.zeros((sets, n, self.samples))
        f = np.zeros((3, sets, self.samples))
        m = np.zeros((3, sets, self.samples))
        for i in range(n - 1, -1, -1):
            body = self.arm.bodies[i]
            force = np.zeros((3, 4, self.samples))
            moment = np.zeros((3, 10, self.samples))
            _wrenches(self.rates[i], force, moment)
            f += np.einsum("sp,apk->ask", parameters[:, i, :4], force)
            m += np.einsum("sp,apk->ask", parameters[:, i], moment)
            tau[:, i] = m[2] if body.revolute else f[2]
            if i:
                c, s = self.motion.c[i], self.motion.s[i]
                for vectors in (f, m):
                    _into_parent(body.cos_alpha, body.sin_alpha, c, s, vectors)
                m += _cross(origin(body, self.motion.d[i]), f)
        return tau


def _wrenches(at: Any, forces: Floats, moments: Floats) -> None:
    """Forces [3, 4, K] and moments [3, 10, K] of a link by its parameters, along its own axes, in place."""
    w, e, a = at.w, at.alpha, at.a
    xx, yy, zz = (x * x for x in w)
    xy, xz, yz = w[0] * w[1], w[0] * w[2], w[1] * w[2]
    turning = (
        (-(yy + zz), xy - e[2], xz + e[1]),
        (xy + e[2], -(xx + zz), yz - e[0]),
        (xz - e[1], yz + e[0], -(xx + yy)),
    )
    for row in range(3):
        forces[row, 0] = a[row]
        for column in range(3):
            forces[row, 1 + column] = turning[row][column]
    # First moments: the acceleration of the frame's origin acts at them.
    moments[0, 2], moments[0, 3] = a[2], -a[1]
    moments[1, 1], moments[1, 3] = -a[2], a[0]
    moments[2, 1], moments[2, 2] = a[1], -a[0]
    # Second moments: I alpha + w x (I w).
    for k, (r, c) in enumerate(_ENTRIES, 4):
        u: list[Any] = [0.0, 0.0, 0.0]
        moments[r, k] += e[c]
        u[r] = w[c]
        if r != c:
            moments[c, k] += e[r]
            u[c] = w[r]
        moments[0, k] += w[1] * u[2] - w[2] * u[1]
        moments[1, k] += w[2] * u[0] - w[0] * u[2]
        moments[2, k] += w[0] * u[1] - w[1] * u[0]


def _into_parent(cos_alpha: Any, sin_alpha: Any, c: Any, s: Any, u: Floats) -> None:
    """``u`` [3, ..., K] along the axes of the parent's frame, in place."""
    x = c * u[0] - s * u[1]
    y = s * u[0] + c * u[1]
    z = u[2].copy()
    u[0] = x
    u[1] = cos_alpha * y - sin_alpha * z
    u[2] = sin_alpha * y + cos_alpha * z


def _cross(p: Any, f: Floats) -> Floats:
    """``p x f`` [3, ..., K]; parts of ``p`` may be numbers."""
    return np.stack([p[1] * f[2] - p[2] * f[1], p[2] * f[0] - p[0] * f[2], p[0] * f[1] - p[1] * f[0]])
