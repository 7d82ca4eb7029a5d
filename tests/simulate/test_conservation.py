"""Energy is kept where nothing takes it, and fixed steps are of the fourth order."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from robodyn.robot.model import Robot
from robodyn.simulate.simulation import Torques, simulate
from robodyn_testing import require_module
from simulate.arms import TIGHT, Effects, Floats, arm, each, effect, hung, plant_of, rotors, start_of


def springs(robot: Robot) -> Effects:
    return each(robot, "spring", stiffness=30.0, rest=0.2, cubic=5.0)


def ripple(robot: Robot) -> Effects:
    return each(robot, "torque_ripple", amplitude=1.5, cycles_per_rev=9.0, phase=0.3)


def pairs(robot: Robot) -> Effects:
    return [
        effect("motor_coupling", robot.n, **{"with": robot.n - 1}, inertia=0.25, ratio=0.7),
        effect("motor_coupling", 1, **{"with": 2}, inertia=0.25, ratio=-0.7),
    ]


def elastic(robot: Robot) -> Effects:
    return rotors(robot) + each(robot, "joint_elasticity", stiffness=400.0)


def play(robot: Robot) -> Effects:
    return rotors(robot) + each(robot, "backlash", gap=0.02, stiffness=2000.0, damping=0.0, transition=0.5)


def rigid(robot: Robot) -> Effects:
    return []


def together(robot: Robot) -> Effects:
    return [*springs(robot), *ripple(robot), *pairs(robot)]


def all_elastic(robot: Robot) -> Effects:
    return [*elastic(robot), *together(robot)]


KINDS = [rigid, springs, ripple, pairs, elastic, play, together, all_elastic]
QUICK = {("stanford", springs), ("puma560_3dof", elastic), ("puma560_3dof", play)}
THOROUGH = {("puma560", together), ("panda", rigid)}
CASES = [
    pytest.param(
        name,
        kind,
        id=f"{name} {kind.__name__}",
        marks=()
        if (name, kind) in QUICK
        else pytest.mark.thorough
        if (name, kind) in THOROUGH
        else pytest.mark.slow,
    )
    for name in ("puma560", "stanford", "panda", "puma560_3dof")
    for kind in KINDS
]


@pytest.mark.parametrize(("name", "kind"), CASES)
def test_energy_is_kept(name: str, kind: Callable[[Robot], Effects]) -> None:
    """Ten seconds of falling, swinging and twisting."""
    robot = hung(name, kind)
    run = simulate(
        robot, start=start_of(robot), duration=10.0, sample_period=0.02, plant=plant_of(robot), **TIGHT
    )
    found = run.balance()
    drift = float(np.abs(found.residual).max()) / float(np.ptp(found.kinetic))
    print(f"{name} {kind.__name__}: drift {drift:.1e} of {np.ptp(found.kinetic):.3g} J")
    assert np.ptp(found.kinetic) > 5
    assert drift < 1e-8
    assert (found.work == 0).all()
    assert np.abs(found.loss).max() < 1e-12 * np.ptp(found.kinetic)


@pytest.mark.parametrize("name", ["stanford", pytest.param("puma560", marks=pytest.mark.slow)])
def test_energies_are_those_of_mujoco(name: str) -> None:
    require_module("mujoco")
    import mujoco

    from peers import mujoco_peer

    robot = arm(name, *rotors(arm(name)), *each(arm(name), "spring", stiffness=30.0, rest=0.2))
    run = simulate(robot, start=start_of(robot), duration=2.0, sample_period=0.1, plant=plant_of(robot))
    model = mujoco_peer.moving_model(robot, mujoco_peer.Moving(1e-3))
    data = mujoco.MjData(model)
    energies = []
    for q, qd in zip(run.q, run.qd, strict=True):
        data.qpos[:], data.qvel[:] = q, qd
        mujoco.mj_forward(model, data)
        mujoco.mj_energyPos(model, data)
        mujoco.mj_energyVel(model, data)
        energies.append(data.energy.copy())
    expected = np.array(energies)
    found = run.balance()
    size = np.ptp(expected[:, 0])
    assert size > 5
    np.testing.assert_allclose(found.kinetic, expected[:, 1], atol=1e-12 * size)
    np.testing.assert_allclose(
        found.potential - found.potential[0], expected[:, 0] - expected[0, 0], atol=1e-11 * size
    )


# --- the order of the fixed steps ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name",
    ["puma560_3dof", *(pytest.param(r, marks=pytest.mark.slow) for r in ("puma560", "stanford", "panda"))],
)
def test_half_the_step_a_sixteenth_of_the_error(name: str) -> None:
    """With viscous friction, springs and rotors; torques jump between the steps only."""
    bare = arm(name)
    robot = arm(name, *springs(bare), *rotors(bare), *each(bare, "viscous_friction", coefficient=1.5))
    table = 5 * np.cos(np.outer(np.arange(10), 1 + np.arange(robot.n)))

    def end(**options: Any) -> Floats:
        run = simulate(
            robot, Torques(table, 0.1), start=start_of(robot), duration=1.0, sample_period=0.1,
            plant=plant_of(robot), **options,
        )  # fmt: skip
        last: Floats = run.record.y[-1]
        return last

    exact = end(**TIGHT)
    steps = [0.02, 0.01, 0.005]
    off = [float(np.abs(end(step=step) - exact).max()) for step in steps]
    print(name, [f"{x:.2e}" for x in off], "ratios", off[0] / off[1], off[1] / off[2])
    assert off[2] < 1e-5
    assert 12 < off[0] / off[1] < 24
    assert 14 < off[1] / off[2] < 18.5
