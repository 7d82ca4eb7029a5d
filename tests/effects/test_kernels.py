"""Emitted C, the definition run by Python, an independent reference and the simulator: the same torques."""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input, Program
from robodyn.kernels.generate import NoForwardDynamics, generate, maker
from robodyn.kernels.kernel import Kernel
from robodyn.kernels.options import Options
from robodyn.kernels.robot_kernel import compile as compile_kernel
from robodyn.robot import Robot
from robodyn.robot.values import ZERO
from robodyn.simulate.control import Control
from robodyn.simulate.plant import Plant, build_plant
from robodyn.simulate.start import start_state
from robodyn.verify import Reference
from robodyn_testing import representative
from robodyn_testing.effect_arms import TEXTS, arm

Floats = NDArray[np.float64]
STATES = 40
VALUES = {"f_s": 5.5, "m_load": 2.8, "c_1": 3.25, "k_b": 2500.0}


def parameters(robot: Robot) -> dict[str, float]:
    return {name: VALUES[name] for name in robot.parameters}


def states(robot: Robot, seed: int = 0) -> tuple[Floats, Floats, Floats]:
    rng = np.random.default_rng(seed)
    q, qd, qdd = rng.uniform(-1, 1, (3, STATES, robot.n)) * np.array([3.0, 2.0, 5.0])[:, None, None]
    return q, qd, qdd


@cache
def kernel(name: str) -> Kernel:
    return compile_kernel(arm(name))


@cache
def plant(name: str) -> Plant:
    return build_plant(arm(name))


def run(program: Program, values: Mapping[str, float], **arrays: Any) -> dict[str, list[float]]:
    """``program`` on floats, operation by operation."""
    inputs = {Input(name, i): float(x) for name, array in arrays.items() for i, x in enumerate(array)}
    return evaluate(program, inputs | {Input(name, None): value for name, value in values.items()})


def close(found: Any, expected: Any, scale: float) -> None:
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * scale)


@pytest.mark.parametrize("name", representative([name for name in TEXTS if name != "remembering"], "sliding"))
def test_the_simulator_solves_for_the_accelerations_of_the_definition(name: str) -> None:
    robot = arm(name)
    values, (q, qd, qdd) = parameters(robot), states(robot, 1)
    tau = kernel(name).inverse_dynamics(q, qd, qdd, params=values or None)
    made = plant(name)
    scale = float(np.abs(tau).max())
    for k in range(STATES):
        y, v, z = start_state(made.system, q[k], qd[k], values)
        found = made.engine.run(
            y, v, z, duration=0.0, sample_period=1e-3, control=Control.held(tau[k : k + 1], 1.0),
            parameters=[values[p] for p in robot.parameters],
        )  # fmt: skip
        assert found.status == "done"
        back = kernel(name).inverse_dynamics(q[k], qd[k], found.a[0], params=values or None)
        close(back, tau[k], scale)
        np.testing.assert_allclose(found.a[0], qdd[k], rtol=0, atol=1e-9)


@pytest.mark.thorough
def test_the_simulator_moves_couplers_and_bristles_as_the_definition_has_them() -> None:
    """Coordinates of links and motors apart: each equation of motion holds for the reference's rigid arm."""
    robot = arm("remembering")
    values, made = parameters(robot), plant("remembering")
    system = made.system
    assert (system.coordinates, system.coupled) == (5, (1, 2))
    assert (system.motors, system.encoders) == ((0, 3, 4), (0, 3, 2))
    bare = replace(
        robot,
        effects=tuple(e for e in robot.effects if e.effect in ("spring", "load_dependent_friction")),
        links=tuple(
            replace(link, joint=replace(link.joint, motor_inertia=ZERO, viscous=ZERO, coulomb=ZERO))
            for link in robot.links
        ),
    )
    rigid = Reference(bare, {name: values[name] for name in bare.parameters})
    rng = random.Random(5)
    for _ in range(STATES):
        y, v = (np.array([rng.uniform(-1, 1) for _ in range(5)]) for _ in range(2))
        y[3:] = y[1:3] + np.array([rng.uniform(-3e-3, 3e-3) for _ in range(2)])
        z, tau = np.array([rng.uniform(-5e-4, 5e-4) for _ in range(2)]), np.array([5.0, -20.0, 8.0])
        found = made.engine.run(
            y, v, z, duration=0.0, sample_period=1e-3,
            control=Control.held(tau[None], 1.0, place=system.motors),
            parameters=[values[p] for p in robot.parameters],
        )  # fmt: skip
        a = found.a[0]
        passed = rigid.inverse_dynamics(y[:3], v[:3], a[:3])
        twist, rate = y[3:] - y[1:3], v[3:] - v[1:3]
        elastic = 20000 * twist[0] + 10 * rate[0]
        x, k, w = abs(twist[1]), 1e4, 0.05
        b = k * (x - 0.001) - w
        flank = np.sign(twist[1]) * (b + np.sqrt(b * b + 4 * w * k * x)) / 2 + rate[1]
        way = np.sign(v)
        drives = elastic * v[3] > 0
        motors = [
            passed[0] + 1.14 * a[0] + 1.2 * v[0] + _bristle(3000, 2, 5, z[0], v[0]),
            (elastic / 0.8 if drives else elastic * 0.8) + way[3] + 4.71 * a[3] + 2 * v[3] + 3 * way[3],
            flank + 0.83 * a[4] + 0.7 * np.sin(50 * y[4] + 0.3) + _bristle(2500, 1, 0, z[1], v[4]),
        ]
        close(passed[1:], [elastic, flank], float(np.abs(passed).max()))
        close(motors, tau, float(max(np.abs(motors).max(), np.abs(a).max())))


def _bristle(stiffness: float, level: float, damping: float, z: float, v: float) -> float:
    return stiffness * z + damping * (v - stiffness * abs(v) / level * z)


def test_what_depends_on_the_load_has_no_forward_dynamics_in_closed_form() -> None:
    made = generate(arm("rubbing"))
    assert "forward_dynamics" not in made.counts
    assert made.left_out["forward_dynamics"].startswith("friction that depends on the load")
    with pytest.raises(NoForwardDynamics, match="no forward dynamics in closed form"):
        maker(arm("rubbing"), Options()).program("forward_dynamics")


def test_what_of_the_counts_is_of_the_rigid_arm() -> None:
    """A payload alone is part of it."""
    counted = generate(arm("sliding"))
    rigid = counted.rigid_counts["inverse_dynamics"]
    assert rigid is not None
    assert 0 < rigid.total < counted.counts["inverse_dynamics"].total
    assert (rigid.sqrt, rigid.other) == (0, 1)  # sgn of the first joint
    robot = arm("rubbing")
    loaded = replace(robot, effects=robot.effects_at(None))
    made = generate(loaded, Options(functions=("inverse_dynamics",)))
    assert made.rigid_counts == {"inverse_dynamics": None}
    values = {name: VALUES[name] for name in loaded.parameters}
    q, qd, qdd = states(loaded)
    found = compile_kernel(loaded).inverse_dynamics(q, qd, qdd, params=values)
    expected = Reference(loaded, values).inverse_dynamics(q, qd, qdd)
    close(found, expected, float(np.abs(expected).max()))
