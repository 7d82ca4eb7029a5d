"""The references behind one face: a torque for arrays of states, and what follows from it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.robot.model import Robot
from robodyn.verify.exact import exact_torque
from robodyn.verify.lagrangian import lagrangian
from robodyn.verify.numbers import Parameters, real
from robodyn.verify.reference import Floats, Reference

#: float64, or Fractions in an array of objects.
Numbers = NDArray[Any]


@dataclass(frozen=True, slots=True)
class Oracle:
    """A reference by name; ``torque(q, qd, qdd)`` takes and gives ``[N, n]``.

    ``matrix(q)`` gives ``[N, n, n]`` where the reference has a better way than by differences of torques.
    """

    name: str
    torque: Callable[[Floats, Floats, Floats], Numbers]
    matrix: Callable[[Floats], Numbers] | None = None

    def gravity(self, q: Floats) -> Numbers:
        """Torques at rest, ``[N, n]``."""
        return self.torque(q, np.zeros_like(q), np.zeros_like(q))

    def bias(self, q: Floats, qd: Floats) -> Numbers:
        """Torques at zero acceleration, ``[N, n]``."""
        return self.torque(q, qd, np.zeros_like(q))

    def mass_matrix(self, q: Floats) -> Numbers:
        """``[N, n, n]``: torques of unit accelerations less those of none."""
        if self.matrix is not None:
            return self.matrix(q)
        still = self.gravity(q)
        columns = []
        for j in range(q.shape[1]):
            unit = np.zeros_like(q)
            unit[:, j] = 1.0
            columns.append(self.torque(q, np.zeros_like(q), unit) - still)
        return np.stack(columns, axis=-1)


def reference_oracle(robot: Robot, parameters: Parameters) -> Oracle:
    """Plain Newton-Euler in double precision."""
    reference = Reference(robot, parameters)
    return Oracle("reference", reference.inverse_dynamics, reference.mass_matrix)


def exact_oracle(robot: Robot, parameters: Parameters) -> Oracle:
    """Virtual work over rationals; an array of Fractions."""

    def torque(q: Floats, qd: Floats, qdd: Floats) -> Numbers:
        found = np.empty(q.shape, dtype=object)
        for k in range(len(q)):
            found[k] = exact_torque(robot, q[k].tolist(), qd[k].tolist(), qdd[k].tolist(), parameters)
        return found

    return Oracle("exact", torque)


def lagrangian_oracle(robot: Robot, parameters: Parameters) -> Oracle:
    """Energies and derivatives; however many joints there are."""
    return Oracle("lagrangian", lagrangian(robot, parameters, limit=robot.n))


def differences(actual: Floats, expected: Numbers) -> Floats:
    """``|actual - expected|`` without rounding ``expected`` first; infinite where one is not finite."""
    if expected.dtype != object:
        sound = np.isfinite(actual) & np.isfinite(expected)
        with np.errstate(invalid="ignore", over="ignore"):
            return np.where(sound, np.abs(actual - expected), np.inf)
    result = np.full(actual.shape, np.inf)
    for place in np.ndindex(actual.shape):
        if np.isfinite(actual[place]):
            result[place] = real(abs(Fraction(float(actual[place])) - expected[place]))
    return result
