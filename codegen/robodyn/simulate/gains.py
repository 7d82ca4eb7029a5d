"""Gains of a controller where none are asked for: as stiff as inertia and the control's rate allow."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.ir.evaluate import REAL_FUNCTIONS, evaluate
from robodyn.ir.program import Input
from robodyn.simulate.shape import without_inertia
from robodyn.simulate.system import System
from robodyn.simulate.trajectories.trajectory import Trajectory

#: Natural frequency of the controlled joints [rad/s], where the control's rate allows it.
STIFFEST = 30.0
#: The largest share of its speed that any motion of the arm may lose in one period of the control.
_SHARE = 1.0
_STATES = 33


def default_gains(
    system: System, motion: Trajectory, law: str, period: float, parameters: Mapping[str, float]
) -> tuple[Floats, Floats]:
    """``kp`` and ``kd`` [n] for following ``motion`` with a control every ``period`` [s].

    Critically damped: ``kp = w^2 m``, ``kd = 2 w m``, in the units of
    :class:`~robodyn.simulate.simulation.Follow`. m is 1 for ``computed_torque``, and for ``pd`` each joint's
    largest inertia along the motion (its diagonal element of the mass matrix, links and motors as one). w is
    :data:`STIFFEST`, or less: so that ``2 w period`` times the largest eigenvalue of M^-1 times the inertia
    that the controller reckons with, at the motors, stays at or below 1 all along the motion. A slow control,
    and light motors on elastic joints, ask for that.

    Raises
    ------
    InputError: nothing resists the acceleration of some joint.
    """
    n = system.robot.n
    chosen = np.unique(np.linspace(0, len(motion) - 1, _STATES).astype(int))
    mass = masses(system, motion.q[chosen], parameters)
    motors = list(system.motors)
    together = np.zeros((system.coordinates, n))
    together[:n] = np.eye(n)
    together[motors, range(n)] = 1.0
    rigid = together.T @ mass @ together
    unit = np.diagonal(rigid, axis1=1, axis2=2).max(axis=0)
    reckoned = rigid if law == "computed_torque" else np.broadcast_to(np.diag(unit), rigid.shape)
    try:
        inverse = np.linalg.inv(mass)
    except np.linalg.LinAlgError:
        raise without_inertia(system.robot.name, unit) from None
    answers = inverse[:, motors][:, :, motors] @ reckoned
    quickest = float(np.abs(np.linalg.eigvals(answers)).max())
    w = min(STIFFEST, _SHARE / (2 * period * quickest))
    m = np.ones(n) if law == "computed_torque" else unit
    return w * w * m, 2 * w * m


def masses(system: System, q: Floats, parameters: Mapping[str, float]) -> Floats:
    """Mass matrices [K, coordinates, coordinates] (kg m^2 or kg) with links, and motors beside them, at ``q``
    [K, n]."""
    y = np.hstack([q, q[:, list(system.coupled)]])
    inputs: dict[Input, Any] = {Input("y", i): y[:, i] for i in range(system.coordinates)}
    inputs.update({Input(name, None): value for name, value in parameters.items()})
    functions: dict[str, Any] = {**REAL_FUNCTIONS, "sin": np.sin, "cos": np.cos}
    (flat,) = evaluate(system.programs["mass"], inputs, functions=functions).values()
    matrix = np.stack([np.broadcast_to(np.asarray(x, float), len(q)) for x in flat], axis=1)
    return matrix.reshape(len(q), system.coordinates, system.coordinates)
