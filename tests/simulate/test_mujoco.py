"""Five seconds of whole arms against MuJoCo: the same Runge-Kutta steps, so that motions agree to rounding.

MuJoCo knows damping, dry friction, armature, springs, payload and tilted gravity. Its dry friction is a
regularised one: the same where joints slide, and nearer to ours at reversals and at rest the stiffer it is.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from robodyn.robot.model import Inertia, Robot
from robodyn.simulate.plant import build_plant
from robodyn.simulate.simulation import Drive, Follow, Simulation, Torques, simulate
from robodyn.simulate.trajectories.trajectory import Trajectory
from robodyn_testing import require_module
from simulate.arms import Floats, arm, each, effect, plant_of, rotors, start_of

STEP, PERIOD, DURATION = 1e-3, 1e-2, 5.0
TIMES = PERIOD * np.arange(round(DURATION / PERIOD), dtype=np.float64)
ROBOTS = ["puma560", "stanford", "ur10", "panda"]


@pytest.fixture(autouse=True)
def _mujoco() -> None:
    require_module("mujoco")


@functools.cache
def laden(name: str) -> Robot:
    """With all that MuJoCo has but dry friction, different at every joint."""
    n = arm(name).n
    box = Inertia(Fraction(1, 100), Fraction(2, 100), Fraction(25, 1000), Fraction(1, 1000))
    found = [
        effect("payload", mass=1.3, com=(0.02, -0.01, 0.1), inertia=box),
        effect("base_tilt", tilt_x=0.1, tilt_y=-0.2),
    ]
    for j in range(1, n + 1):
        found += [
            effect("viscous_friction", j, coefficient=0.5 + 0.1 * j),
            effect("rotor_inertia", j, inertia=0.2 + 0.05 * j),
            effect("spring", j, stiffness=15.0 + j, rest=round(0.4 - 0.1 * j, 1)),
        ]
    return arm(name, *found)


@functools.cache
def dry(name: str) -> Robot:
    """With rotors, damping, and dry friction of a level of its own at every joint."""
    robot = arm(name)
    found = [*rotors(robot), *each(robot, "viscous_friction", coefficient=2.0)]
    found += [effect("coulomb_friction", j, level=1.0 + j) for j in range(1, robot.n + 1)]
    return arm(name, *found)


def waves(robot: Robot, times: Floats) -> tuple[Floats, Floats, Floats]:
    """Positions, velocities, accelerations [K, n]: a sine of its own for each joint, from zero."""
    w = 0.7 + 0.3 * np.arange(robot.n)
    size = np.array([0.5 if link.joint.kind == "revolute" else 0.15 for link in robot.links])
    phase = np.outer(times, w)
    return size * np.sin(phase), size * w * np.cos(phase), -size * w**2 * np.sin(phase)


def drift(robot: Robot, times: Floats) -> tuple[Floats, Floats, Floats]:
    """At a steady speed, so that nothing turns."""
    speed = np.full(robot.n, 0.2)
    q = np.outer(times, speed) - 0.3
    return q, np.broadcast_to(speed, q.shape), np.zeros_like(q)


@dataclass(frozen=True)
class Law:
    """A controller of the tests' own: torque [K, n] ahead and, around the ``motion``, kp and kd."""

    ahead: Floats
    motion: Trajectory
    kp: float = 0.0
    kd: float = 0.0

    def __call__(self, t: float, q: Floats, qd: Floats) -> Floats:
        k = min(round(t / PERIOD), len(self.ahead) - 1)
        off, slow = self.motion.q[k] - q, self.motion.qd[k] - qd
        torque: Floats = self.ahead[k] + self.kp * off + self.kd * slow
        return torque


def law_along(
    robot: Robot, motion: Callable[[Robot, Floats], tuple[Floats, Floats, Floats]], **gains: float
) -> Law:
    """With the torques that the bare arm needs for the motion."""
    from peers import mujoco_peer

    wanted = Trajectory(TIMES, *motion(robot, TIMES))
    bare = replace(robot, effects=())
    ahead = mujoco_peer.torques(mujoco_peer.mujoco_model(bare), bare, wanted.q, wanted.qd, wanted.qdd)
    return Law(ahead, wanted, **gains)


def ours(
    robot: Robot, drive: Drive | None, q: Floats, qd: Floats, duration: float, **options: Any
) -> Simulation:
    return simulate(
        robot, drive, start=q, speed=qd, duration=duration, sample_period=PERIOD,
        **{"step": STEP, "plant": plant_of(robot), **options},
    )  # fmt: skip


def theirs(
    robot: Robot,
    torque: Callable[[float, Floats, Floats], Floats] | None,
    q: Floats,
    qd: Floats,
    duration: float,
    step: float = STEP,
    hardness: float = 1e6,
) -> Floats:
    """Positions [S, n] by MuJoCo, torques held for a period."""
    from peers import mujoco_peer

    every = round(PERIOD / step)
    model = mujoco_peer.moving_model(robot, mujoco_peer.Moving(step, hardness))
    law = torque or (lambda t, q, qd: np.zeros(robot.n))
    found, _ = mujoco_peer.motion(model, q, qd, law, every * round(duration / PERIOD), every)
    return found


def apart(one: Floats, other: Floats) -> float:
    """The largest difference, as a share of what the joint went through."""
    share: float = (np.abs(one - other).max(axis=0) / np.maximum(np.ptp(other, axis=0), 1e-3)).max()
    print(f"apart by {share:.1e} of the range")
    return share


@pytest.mark.parametrize(
    "name",
    [
        "stanford",
        pytest.param("panda", marks=pytest.mark.thorough),
        *(pytest.param(name, marks=pytest.mark.slow) for name in ("puma560", "ur10")),
    ],
)
def test_a_laden_arm_let_go_driven_and_controlled(name: str) -> None:
    """Damping, rotors, springs, a payload on a tilted base; no torque, a table, PD, computed torque."""
    from peers import mujoco_peer

    robot = laden(name)
    q, still = start_of(robot), np.zeros(robot.n)
    made = ours(robot, None, q, still, DURATION)
    assert np.ptp(made.q, axis=0).min() > 0.1
    assert apart(theirs(robot, None, q, still, DURATION), made.q) < 1e-11

    table = law_along(robot, waves)
    made = ours(robot, Torques(table.ahead, PERIOD), q, still, DURATION)
    assert apart(theirs(robot, table, q, still, DURATION), made.q) < 1e-11

    wanted = table.motion
    pd = replace(table, ahead=0 * table.ahead, kp=60.0, kd=6.0)
    made = ours(robot, Follow(wanted, "pd", 60.0, 6.0, PERIOD, without_model=True), q, still, DURATION)
    assert apart(theirs(robot, pd, q, still, DURATION), made.q) < 1e-11
    np.testing.assert_allclose(
        made.command[:-1],
        [pd(t, *state) for t, *state in zip(TIMES, made.q, made.qd, strict=False)],
        atol=1e-9,
    )

    model = mujoco_peer.moving_model(robot, mujoco_peer.Moving(STEP))

    def computed(t: float, q: Floats, qd: Floats) -> Floats:
        k = min(round(t / PERIOD), len(TIMES) - 1)
        asked = wanted.qdd[k] + 12 * (wanted.qd[k] - qd) + 36 * (wanted.q[k] - q)
        found = mujoco_peer.torques(model, robot, q[None], qd[None], asked[None], add_friction=False)
        torque: Floats = found[0]
        return torque

    made = ours(robot, Follow(wanted, "computed_torque", 36.0, 12.0, PERIOD), q, still, DURATION)
    assert apart(theirs(robot, computed, q, still, DURATION), made.q) < 1e-11


@pytest.mark.parametrize(
    "name", ["puma560_3dof", *(pytest.param(name, marks=pytest.mark.slow) for name in ROBOTS)]
)
def test_dry_friction(name: str) -> None:
    """Sliding one way both laws are one. Through reversals MuJoCo's comes nearer to ours the harder it is."""
    robot = dry(name)
    plant = build_plant(robot, model=replace(robot, effects=()))

    def follow(law: Law, q: Floats, qd: Floats, duration: float, **options: Any) -> Simulation:
        drive = Follow(law.motion, "pd", law.kp, law.kd, PERIOD, plant.model)
        return ours(robot, drive, q, qd, duration, plant=plant, **options)

    law = law_along(robot, drift, kp=150.0, kd=15.0)
    q, qd = law.motion.q[0] + 0.01, law.motion.qd[0]
    made = follow(law, q, qd, DURATION)
    assert made.qd.min() > 0.1
    assert apart(theirs(robot, law, q, qd, DURATION), made.q) < 1e-12

    law = law_along(robot, waves, kp=150.0, kd=15.0)
    q, qd = law.motion.q[0], law.motion.qd[0]
    made = follow(law, q, qd, 2.0, method="adaptive", rtol=1e-10)
    turned = (np.diff(np.sign(made.qd), axis=0) != 0).any(axis=0)
    assert turned.sum() >= 2
    fixed = follow(law, q, qd, 2.0)
    assert apart(fixed.q, made.q) < 1e-9
    off = [
        apart(theirs(robot, law, q, qd, 2.0, step, 1 / step), made.q) for step in (2e-3, 1e-3, 5e-4, 2.5e-4)
    ]
    assert off[0] < 1e-4
    assert off[2] < off[1] < off[0]
    assert off[3] < off[0] / 50
