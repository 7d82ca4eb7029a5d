"""Where a simulation begins: motors of elastic joints twisted as the arm's weight has them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.drives.coupling import coupler_of
from robodyn.drives.drive import Loads, Rates, layer_of, passed_on, rigid_part
from robodyn.dynamics.arm import build_arm, build_motion, trigonometry_at
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.simulate.system import System

Floats = NDArray[np.float64]


def start_state(
    system: System, q: Floats, qd: Floats, parameters: Mapping[str, float]
) -> tuple[Floats, Floats, Floats]:
    """Coordinates, velocities and internal states for links at ``q``, moving at ``qd`` [n].

    Couplers are twisted by the torque that holds the arm still there, their two sides move alike; bristles
    are straight.
    """
    robot, n = system.robot, system.robot.n
    y, v = np.concatenate([q, q[list(system.coupled)]]), np.concatenate([qd, qd[list(system.coupled)]])
    if system.coupled:
        passed = _static_torques(system, [float(x) for x in q], parameters)
        layer = layer_of(robot, float, parameters.__getitem__, bare=True)
        for k, i in enumerate(system.coupled):
            acting = layer.joints[i].coupler
            assert acting is not None
            y[n + k] += coupler_of(acting).twist(acting.values, passed[i])
    return y, v, np.zeros(len(system.states))


def _static_torques(system: System, q: list[float], parameters: Mapping[str, float]) -> list[Any]:
    """Torques [n] that the links ask of their drives at rest."""
    robot = system.robot
    arm = build_arm(rigid_part(robot, bare=True), float, parameters.__getitem__)

    zeros = [0.0] * robot.n
    tau = newton_euler(arm, build_motion(arm, q, zeros, zeros, trigonometry_at(q), float))
    layer = layer_of(robot, float, parameters.__getitem__, bare=True)
    none = dict.fromkeys(range(robot.n), (0, 0, 0))
    loads = Loads(tau, none, none)
    return passed_on(layer, loads, Rates(q, zeros, zeros, zeros))
