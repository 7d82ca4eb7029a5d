"""Derivatives of torques and accelerations, and the Coriolis matrix, which is half of one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from robodyn.dynamics.functions.record import QD, QDD, TAU, Array, Function, Pair, Q
from robodyn.dynamics.joints import friction_slope
from robodyn.dynamics.mass_matrix import Factored, solve_symmetric
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.state import Dynamics, ReferenceDynamics, Vector
from robodyn.dynamics.vectors import flat, inner, products


def _square(name: str, holds: str, unit: str) -> Array:
    return Array(name, holds, unit, "N in place of N m, m in place of rad", ("n", "n"))


DTAU_DQ = _square("dtau_dq", "torques by positions", "N m/rad")
DTAU_DQD = _square("dtau_dqd", "torques by velocities", "N m s/rad")
DQDD_DQ = _square("dqdd_dq", "accelerations by positions", "rad/(rad s^2)")
DQDD_DQD = _square("dqdd_dqd", "accelerations by velocities", "rad/(rad s)")
DQDD_DTAU = _square("dqdd_dtau", "accelerations by torques: the inverse mass matrix", "rad/(N m s^2)")
C = Array("C", "Coriolis matrix", "kg m^2/s, kg m/s, kg/s", shape=("n", "n"))


def _by_q_and_qd(at: Dynamics, qdd: Vector) -> tuple[Sequence[Vector], Sequence[Vector]]:
    """Derivatives of the torques by positions and by velocities, as rows: written out, or of a program that
    is there already."""
    from robodyn.dynamics.derivatives import torque_derivatives

    qd = at.inputs["qd"]
    differentiated = at.torque_derivatives(qdd)
    if differentiated is not None:
        return differentiated
    by_q, by_qd = torque_derivatives(at.links(qd, qdd), at.mark)
    for i, row in enumerate(by_qd):
        row[i] = row[i] + friction_slope(at.arm, i, qd[i])
    return by_q, by_qd


def _of_torques(at: Dynamics) -> Sequence[Any]:
    by_q, by_qd = _by_q_and_qd(at, at.inputs["qdd"])
    return [*flat(by_q), *flat(by_qd)]


def _slopes(at: ReferenceDynamics, qdd: Vector, x: Vector) -> list[Any]:
    """Derivatives [2 n] of the torques along ``x``, of the positions and of the velocities."""
    none = [0] * len(x)
    return [*at.torque_slopes(qdd, x, none), *at.torque_slopes(qdd, none, x)]


def _torques_change(at: ReferenceDynamics, result: Sequence[Any], x: Vector) -> Pair:
    """Both matrices times ``x``, beside the derivative of the torques along it."""
    return products(result, x), _slopes(at, at.inputs["qdd"], x)


def _of_accelerations(at: Dynamics) -> Sequence[Any]:
    """``-M^-1`` times the derivatives of the torques that the accelerations need."""
    matrix = Factored(at.mass_matrix(), at.mark)
    bias = at.torques(at.inputs["qd"], at.rest)
    qdd = matrix.solve([tau - h for tau, h in zip(at.inputs["tau"], bias, strict=True)])
    inverse = matrix.inverse()
    columns = [list(zip(*by, strict=True)) for by in _by_q_and_qd(at, qdd)]
    changes = [-inner(row, column) for by in columns for row in inverse for column in by]
    return [*changes, *flat(inverse)]


def _accelerations_change(at: ReferenceDynamics, result: Sequence[Any], x: Vector) -> Pair:
    """Each matrix times ``x``, carried back to torques: to compare accelerations would measure the condition
    of the mass matrix instead."""
    matrix, n = at.mass_matrix(), len(x)
    bias = at.torques(at.inputs["qd"], at.rest)
    qdd = solve_symmetric(matrix, [tau - h for tau, h in zip(at.inputs["tau"], bias, strict=True)])
    changes = products(result, x)
    needed = [inner(row, changes[k : k + n]) for k in range(0, 3 * n, n) for row in matrix]
    return needed, [-slope for slope in _slopes(at, qdd, x)] + list(x)


def _coriolis(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.derivatives import coriolis_matrix

    return flat(coriolis_matrix(at.links(at.inputs["qd"], at.rest), at.mark))


def _polar(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """``2 C x`` is what the torques of velocities, which are quadratic, have of ``qd`` and ``x`` together."""
    qd = at.inputs["qd"]
    bodies = tuple(replace(body, viscous=0, coulomb=0) for body in at.arm.bodies)
    arm = replace(at.arm, bodies=bodies, gravity=(0, 0, 0))
    sums = [v + w for v, w in zip(qd, x, strict=True)]
    torques = (at.folded(newton_euler(arm, at.motion(rates, at.rest))) for rates in (sums, qd, x))
    return [2 * y for y in products(result, x)], [b - v - w for b, v, w in zip(*torques, strict=True)]


FUNCTIONS = (
    Function(
        "coriolis_matrix",
        "Coriolis matrix of Christoffel's symbols: dM/dt - 2 C is skew",
        (Q, QD),
        (C,),
        _coriolis,
        condition=_polar,
    ),
    Function(
        "inverse_dynamics_derivatives",
        "derivatives of the inverse dynamics; that by qdd is the mass matrix",
        (Q, QD, QDD),
        (DTAU_DQ, DTAU_DQD),
        _of_torques,
        condition=_torques_change,
        parts=("inverse_dynamics",),
    ),
    Function(
        "forward_dynamics_derivatives",
        "derivatives of the forward dynamics",
        (Q, QD, TAU),
        (DQDD_DQ, DQDD_DQD, DQDD_DTAU),
        _of_accelerations,
        in_coordinates=_of_accelerations,
        condition=_accelerations_change,
        solves=True,
    ),
)
