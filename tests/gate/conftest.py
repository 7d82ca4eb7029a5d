"""Fixtures of this folder."""

from __future__ import annotations

from dataclasses import replace

import pytest

from gate.gated import GIVEN, entry
from robodyn.logs.log import Log
from robodyn.robot.folding import folded
from robodyn.simulate.sensors import Sensors, resolution_of
from robodyn.simulate.simulation import Follow, simulate
from robodyn.simulate.trajectories import fourier


@pytest.fixture(scope="module")
def log() -> Log:
    """Of an arm with friction and a load that the model does not know, under a controller."""
    friction = [entry("coulomb_friction", j, level=3.0) for j in (1, 2, 3)]
    true = folded(replace(GIVEN, effects=(*friction, entry("payload", None, mass=1.0, com=(0.1, 0.0, 0.05)))))
    motion = fourier(GIVEN, 0.2, 5, seed=4, periods=2)
    run = simulate(true, Follow(motion, "pd", kp=2000.0, kd=200.0))
    sensors = Sensors(
        position_resolution=resolution_of(17), velocity="difference", acceleration="none", torque_noise=0.3
    )
    return run.log(sensors, seed=1)
