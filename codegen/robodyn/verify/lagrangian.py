"""Torques from energies by sympy: an oracle for arms of few joints.

Kinetic and potential energy are written from the forward kinematics (4x4 transforms, velocities of the
centres of mass, turning rates from ``R^T dR/dt``), and the torque is ``d/dt dL/dqd - dL/dq``. No recursion of
forces, no cross product, no formula of rigid-body dynamics but the energy of a body.

Everything is a polynomial with rational coefficients in the cosine and sine of each angle, each sliding
distance and the rates, in sympy's sparse polynomial ring; the derivatives are exact. Only the values at the
end are doubles. (The same through sympy's general expressions takes twenty times longer.)

Rotor inertia adds ``motor_inertia * qd^2 / 2``, friction is added to the result, both on the motor's side
only.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robodyn.arrays import Floats
from robodyn.errors import InputError
from robodyn.robot.model import Joint, Robot
from robodyn.robot.values import Value
from robodyn.tools.libraries import SYMPY
from robodyn.verify.numbers import Parameters, exact_value, filled, real

#: Joints up to which the oracle is quick whatever the angles: at most a second or two. Twists that are
#: multiples of pi/2 are easy (six joints: some seconds), general ones are not (four joints: half a minute).
LIMIT = 3

Torque = Callable[[ArrayLike, ArrayLike, ArrayLike], Floats]
Matrix = list[list[Any]]


def lagrangian(robot: Robot, parameters: Parameters | None = None, *, limit: int = LIMIT) -> Torque:
    """Inverse dynamics of ``robot`` as a function of ``q, qd, qdd``, each ``[n]`` or ``[N, n]``.

    Raises
    ------
    InputError: more joints than ``limit``, or a run-time parameter without a value.
    ToolError: sympy is missing.
    """
    if robot.n > limit:
        raise InputError(
            f"{robot.name} has too many joints for the Lagrangian",
            found=f"{robot.n}",
            expected=f"at most {limit}",
            remedy="raise the limit, and be patient",
        )
    try:
        from sympy import QQ
        from sympy.polys.rings import ring
    except ImportError:
        raise SYMPY.missing() from None
    values = filled(robot, parameters)
    n = robot.n
    names = [f"{name}{k + 1}" for name in ("c", "s", "x", "qd", "qdd") for k in range(n)]
    R, *generators = ring(names, QQ)
    energies = _Energies(robot, values, R, [generators[k * n : (k + 1) * n] for k in range(5)])
    return _callable(robot, values, [_terms(torque) for torque in energies.torques()])


class _Energies:
    """Polynomials in ``c s`` (cosine and sine of q), ``x`` (q of a sliding joint), ``qd``, ``qdd``."""

    def __init__(self, robot: Robot, values: Parameters, R: Any, groups: Sequence[list[Any]]) -> None:
        self.robot, self.values, self.ring = robot, values, R
        self.c, self.s, self.x, self.qd, self.qdd = groups

    def torques(self) -> list[Any]:
        """``d/dt dL/dqd_i - dL/dq_i`` for every joint i."""
        L = self.lagrangian()
        result = []
        for i in range(self.robot.n):
            momentum = L.diff(self.qd[i])
            tau = self.rate(momentum) - self.slope(L, i)
            for j in range(self.robot.n):
                tau += momentum.diff(self.qd[j]) * self.qdd[j]
            result.append(tau)
        return result

    def lagrangian(self) -> Any:
        """Kinetic less potential energy."""
        zero, one = self.ring.zero, self.ring.one
        T: Matrix = [[one if r == k else zero for k in range(4)] for r in range(4)]
        L = zero
        for k, link in enumerate(self.robot.links):
            T = _mul(T, self.step(link.joint, k))
            i, mass = link.inertia, self.at(link.mass)
            tensor = [[i.xx, i.xy, i.xz], [i.xy, i.yy, i.yz], [i.xz, i.yz, i.zz]]
            com = [*(self.at(x) for x in link.com), one]
            centre = [sum((a * b for a, b in zip(T[r], com, strict=True)), zero) for r in range(3)]
            for x, g in zip(centre, self.robot.base_gravity, strict=True):
                L += mass * (self.rate(x) ** 2 * self.real(Fraction(1, 2)) + self.real(g) * x)
            R = [row[:3] for row in T[:3]]
            spin = _mul(
                [list(row) for row in zip(*R, strict=True)], [[self.rate(x) for x in row] for row in R]
            )
            w = [self.tidy(x) for x in (spin[2][1], spin[0][2], spin[1][0])]
            for r in range(3):
                for m in range(3):
                    L += self.at(tensor[r][m]) * self.real(Fraction(1, 2)) * w[r] * w[m]
            if self.robot.torque_side == "motor":
                L += self.at(link.joint.motor_inertia) * self.real(Fraction(1, 2)) * self.qd[k] ** 2
        return self.tidy(L)

    def step(self, joint: Joint, k: int) -> Matrix:
        """Rot(x, alpha) Trans(a, b, 0) Rot(z, theta + q) Trans(z, d), or Rot(z, theta) Trans(z, d + q)."""
        zero, one = self.ring.zero, self.ring.one
        ca, sa, ct, st = (
            self.real(x) for x in (joint.alpha.cos, joint.alpha.sin, joint.theta.cos, joint.theta.sin)
        )
        d = self.at(joint.d)
        turn = [[ct, -st, zero, zero], [st, ct, zero, zero], [zero, zero, one, zero], [zero, zero, zero, one]]
        if joint.kind == "prismatic":
            d = d + self.x[k]
        else:
            c, s = self.c[k], self.s[k]
            turn = _mul(turn, [[c, -s, zero, zero], [s, c, zero, zero], turn[2], turn[3]])
        a, b = self.at(joint.a), self.at(joint.b)
        tilt = [[one, zero, zero, a], [zero, ca, -sa, ca * b], [zero, sa, ca, sa * b], turn[3]]
        rise = [[one, zero, zero, zero], [zero, one, zero, zero], [zero, zero, one, d], turn[3]]
        return _mul(_mul(tilt, turn), rise)

    def slope(self, f: Any, j: int) -> Any:
        """df/dq_j."""
        if self.robot.links[j].joint.kind == "prismatic":
            return f.diff(self.x[j])
        return f.diff(self.s[j]) * self.c[j] - f.diff(self.c[j]) * self.s[j]

    def tidy(self, f: Any) -> Any:
        """``f`` with ``s_j^2 = 1 - c_j^2`` put in, which keeps the number of terms small."""
        n = self.robot.n
        for j in range(n):
            f, terms = self.ring.zero, f.terms()
            by_power: dict[int, dict[tuple[int, ...], Any]] = {}
            for powers, factor in terms:
                rest = (*powers[: n + j], powers[n + j] % 2, *powers[n + j + 1 :])
                by_power.setdefault(powers[n + j] // 2, {})[rest] = factor
            for halves, part in by_power.items():
                f += self.ring.from_dict(part) * (1 - self.c[j] ** 2) ** halves
        return f

    def rate(self, f: Any) -> Any:
        """The sum of df/dq_j qd_j."""
        return sum((self.slope(f, j) * self.qd[j] for j in range(self.robot.n)), self.ring.zero)

    def real(self, value: Fraction) -> Any:
        return self.ring.domain_new(value.numerator) / self.ring.domain_new(value.denominator) * self.ring.one

    def at(self, value: Value) -> Any:
        return self.real(exact_value(value, self.values))


def _mul(A: Matrix, B: Matrix) -> Matrix:
    columns = list(zip(*B, strict=True))
    return [
        [sum((x * y for x, y in zip(row, column, strict=True)), row[0].ring.zero) for column in columns]
        for row in A
    ]


def _terms(polynomial: Any) -> tuple[NDArray[np.intp], Floats]:
    """Exponents ``[terms, generators]`` and coefficients ``[terms]``."""
    terms = polynomial.terms() or [((0,) * polynomial.ring.ngens, 0)]
    coefficients = [real(Fraction(int(c.numerator), int(c.denominator))) if c else 0.0 for _, c in terms]
    return np.array([list(powers) for powers, _ in terms], np.intp), np.array(coefficients)


def _callable(robot: Robot, values: Parameters, torques: Sequence[tuple[NDArray[np.intp], Floats]]) -> Torque:
    viscous = np.array([real(exact_value(link.joint.viscous, values)) for link in robot.links])
    coulomb = np.array([real(exact_value(link.joint.coulomb, values)) for link in robot.links])
    rest = None if robot.rest_velocity is None else float(robot.rest_velocity)

    def torque(q: ArrayLike, qd: ArrayLike, qdd: ArrayLike) -> Floats:
        """Torques [N m or N] of states ``[n]`` or ``[N, n]``."""
        arrays = [np.asarray(x, dtype=np.float64) for x in (q, qd, qdd)]
        shape = arrays[0].shape
        if not 1 <= len(shape) <= 2 or shape[-1] != robot.n or any(a.shape != shape for a in arrays):
            raise InputError(
                f"{robot.name}: states of the wrong shape",
                found=", ".join(str(list(array.shape)) for array in arrays),
                expected=f"[{robot.n}] or [N, {robot.n}] each",
            )
        position, speed, rate = (array.reshape(-1, robot.n) for array in arrays)
        generators = np.concatenate([np.cos(position), np.sin(position), position, speed, rate], axis=1)
        tau = np.stack([_evaluate(generators, *terms) for terms in torques], axis=-1)
        if robot.torque_side == "motor":
            way = np.sign(speed) if rest is None else np.tanh(speed / rest)
            tau = tau + viscous * speed + coulomb * way
        return tau.reshape(shape)

    return torque


def _evaluate(generators: Floats, exponents: NDArray[np.intp], coefficients: Floats) -> Floats:
    """The polynomial at each of the states ``[N, generators]``."""
    total = np.zeros(len(generators))
    for k, state in enumerate(generators):
        powers = state[:, None] ** np.arange(exponents.max(initial=0) + 1)
        total[k] = np.prod(powers[np.arange(len(state)), exponents], axis=1) @ coefficients
    return total
