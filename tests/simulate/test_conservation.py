"""Energy is kept where nothing takes it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from robodyn.robot.model import Robot
from robodyn.simulate.simulation import simulate
from simulate.arms import TIGHT, Effects, each, effect, hung, plant_of, rotors, start_of


def pairs(robot: Robot) -> Effects:
    return [
        effect("motor_coupling", robot.n, **{"with": robot.n - 1}, inertia=0.25, ratio=0.7),
        effect("motor_coupling", 1, **{"with": 2}, inertia=0.25, ratio=-0.7),
    ]


def springs(robot: Robot) -> Effects:
    return each(robot, "spring", stiffness=30.0, rest=0.2, cubic=5.0)


def ripple(robot: Robot) -> Effects:
    return each(robot, "torque_ripple", amplitude=1.5, cycles_per_rev=9.0, phase=0.3)


def elastic(robot: Robot) -> Effects:
    return rotors(robot) + each(robot, "joint_elasticity", stiffness=400.0)


def play(robot: Robot) -> Effects:
    return rotors(robot) + each(robot, "backlash", gap=0.02, stiffness=2000.0, damping=0.0, transition=0.5)


TOGETHER = (springs, ripple, pairs)
KINDS: dict[str, tuple[Callable[[Robot], Effects], ...]] = {
    "rigid": (), "springs": (springs,), "ripple": (ripple,), "pairs": (pairs,), "elastic": (elastic,),
    "play": (play,), "together": TOGETHER, "all elastic": (elastic, *TOGETHER),
}  # fmt: skip
#: Kinds in the normal run and in CI; all others in `make prove-all`.
MARKS: dict[str, Any] = {
    "stanford springs": (), "puma560_3dof elastic": (), "puma560_3dof play": (),
    "puma560 together": pytest.mark.thorough, "panda rigid": pytest.mark.thorough,
}  # fmt: skip
CASES = [
    pytest.param(name, kind, id=f"{name} {kind}", marks=MARKS.get(f"{name} {kind}", pytest.mark.slow))
    for name in ("puma560", "stanford", "panda", "puma560_3dof")
    for kind in KINDS
]


@pytest.mark.parametrize(("name", "kind"), CASES)
def test_energy_is_kept(name: str, kind: str) -> None:
    """Ten seconds of falling, swinging and twisting."""
    robot = hung(name, *KINDS[kind])
    run = simulate(
        robot, start=start_of(robot), duration=10.0, sample_period=0.02, plant=plant_of(robot), **TIGHT
    )
    found = run.balance()
    drift = float(np.abs(found.residual).max()) / float(np.ptp(found.kinetic))
    print(f"{name} {kind}: drift {drift:.1e} of {np.ptp(found.kinetic):.3g} J")
    assert np.ptp(found.kinetic) > 5
    assert drift < 1e-8
    assert (found.work == 0).all()
    assert np.abs(found.loss).max() < 1e-12 * np.ptp(found.kinetic)
