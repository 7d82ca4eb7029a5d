"""An arm with effects that its controller does not know of, and what its model lacks."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from robodyn.effects.catalogue import CATALOGUE
from robodyn.identify.predict import model_torque, offsets
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.robot.model import Robot
from robodyn.simulate.gains import default_gains
from robodyn.simulate.plant import build_plant
from robodyn.simulate.sensors import measured_position, measured_torque
from robodyn.simulate.simulation import Follow, simulate
from robodyn.simulate.trajectories.trajectory import Trajectory

Floats = NDArray[np.float64]


class Arm:
    """The true arm, compiled, under a controller that takes it for the given one."""

    def __init__(self, model: Robot, true: Robot, motion: Trajectory, cache: Path | None) -> None:
        self.model, self.true = model, true
        self.plant = build_plant(true, model=model, energy=False, cache=cache)
        self.gains = default_gains(self.plant.system, motion, "pd", 1e-3, {})

    def log(self, motion: Trajectory, rate: float) -> Log:
        """What perfect sensors show of the arm on ``motion``."""
        follow = Follow(motion, "pd", *self.gains, model=self.model)
        run = simulate(
            self.true, follow, sample_period=1 / rate, method="adaptive", step=1e-2, plant=self.plant
        )
        return run.true_log()


def measured(exact: Log, true: Robot) -> Log:
    """An ``exact`` log as the sensors of ``true`` show it, without noise."""
    q = measured_position(exact.q, true.effects)
    return replace(exact, q=q, tau=measured_torque(exact.tau, exact.t, true.effects))


def lacking(model: Robot, log: Log) -> Floats:
    """The torque [K, n] of ``log``, which has true rates, that ``model`` does not explain."""
    assert log.qd is not None
    assert log.qdd is not None
    if any(CATALOGUE[entry.effect].kind == "state" for entry in model.effects):
        return np.asarray(log.tau - model_torque(model, log.t, log.q, log.qd, log.qdd, log.tau))
    tau = Model(model).torque(log.q - offsets(model), log.qd, log.qdd)
    return np.asarray(log.tau - measured_torque(tau, log.t, model.effects))


def rms(x: Floats) -> Floats:
    """Root mean square [n] of ``x`` [K, n]."""
    return np.asarray(np.sqrt(np.mean(x**2, axis=0)))
