"""What the gate tells of a log and lets pass."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from gate.gated import GIVEN, WRONG, arm, at, entry, flag_of, put, rows_of, swapped
from robodyn.errors import InputError
from robodyn.gate.gate import inspect
from robodyn.logs.log import Log
from robodyn.robot import read_text
from robodyn.robot.folding import folded
from robodyn.robot.model import EffectEntry, Robot
from robodyn.simulate.sensors import Sensors, measure, resolution_of
from robodyn.simulate.trajectories import fourier
from robodyn.verify.reference import Reference
from robodyn_testing import representative

# --- lesser things ----------------------------------------------------------------------------------------


def test_velocities_that_are_late(log: Log) -> None:
    assert log.qd is not None
    late = np.roll(log.qd, 12, axis=0)
    gate = inspect(replace(log, qd=late), GIVEN)
    assert re.search(r"up to 12\.[3-7]\d* ms", flag_of(gate, "velocity_lag").text)


@pytest.mark.parametrize("value", [0.0, np.nan])
def test_velocities_that_are_none(log: Log, value: float) -> None:
    gate = inspect(put(log, "qd", np.s_[:], value), GIVEN)
    assert gate.flags_of("rates_unusable")
    assert gate.log.qd is None
    assert gate.log.samples == log.samples


def test_a_frozen_position(log: Log) -> None:
    fast = int(np.argmax(np.abs(np.gradient(log.q[200:-200, 1])))) + 200
    frozen = put(log, "q", np.s_[fast : fast + 100, 1], log.q[fast, 1])
    gate = inspect(frozen, GIVEN)
    assert rows_of(gate, "stuck") == [(fast + 2, fast + 100)]
    with pytest.raises(InputError, match="q2 stops dead"):
        inspect(replace(log, q=np.clip(log.q, [-9.0, -0.3, -9.0], [9.0, 0.3, 9.0]), qd=None), GIVEN)


LIGHT = """\
name: wrist
gravity: [0, 0, -9.81]
links:
  - joint: revolute
    alpha: 0
    a: 0
    d: 0
    theta: 0
    mass: 0.5
    com: [0.02, 0, 0]
    inertia: {xx: INERTIA, yy: INERTIA, zz: INERTIA}
"""


def pushed_on(inertia: float) -> Log:
    """Of a joint with 1 N m of dry friction and an ``inertia`` [kg m^2], driven for half a second and let go
    for another, at 250 Hz."""
    step, period = 1e-4, 4e-3
    t = np.asarray(step * np.arange(80_000), dtype=np.float64)
    drive = np.where(t % 1 < 0.5, np.where(t % 2 < 1, 1.4, -1.4), 0.0)
    q, speed, positions = 0.0, 0.0, np.empty((len(t), 1))
    for k, torque in enumerate(drive.tolist()):
        positions[k] = q
        free = speed + (torque - 0.5 * speed) * step / inertia
        speed = float(np.sign(free)) * max(abs(free) - step / inertia, 0.0)  # dry friction stops it, no more
        q += speed * step
    every = round(period / step)
    noise = 0.002 * np.random.default_rng(2).standard_normal((len(t), 1))
    return at(Log(t, positions, positions, None, drive[:, None] + noise), np.s_[::every])


def test_dry_friction_may_stop_a_light_joint_within_a_sample() -> None:
    log = replace(pushed_on(0.002), qd=None)
    wrist = read_text(LIGHT.replace("INERTIA", "0.0018"))
    assert not inspect(log, wrist).flags_of("stuck")
    heavy = read_text(LIGHT.replace("INERTIA", "0.6"))  # nothing stops that so
    with pytest.raises(InputError, match="q1 stops dead"):
        inspect(log, heavy)


def test_positions_that_drop_out_often_are_left_out(log: Log) -> None:
    rows = np.arange(50, log.samples - 50, 100)
    gate = inspect(put(log, "q", (rows, 1), 3.0), GIVEN)
    assert [span.first - 1 for span in flag_of(gate, "spike").spans] == rows[:100].tolist()
    np.testing.assert_allclose(gate.log.q, log.q, atol=2e-4)


def test_a_spring_that_outdoes_gravity_passes(log: Log) -> None:
    # It pulls the other way than gravity, and more: the sign of the torque looks flipped.
    for j, stiffness in ((1, -60.0), (1, 120.0), (2, 40.0), (2, -40.0)):
        sprung = put(log, "tau", np.s_[:, j], log.tau[:, j] + stiffness * (log.q[:, j] - 0.2))
        assert not {flag.kind for flag in inspect(sprung, GIVEN).flags} & WRONG


def test_joints_of_a_wrist_are_told_apart() -> None:
    robot = arm("puma560")
    motion = fourier(robot, 0.2, 5, seed=6, period=2e-3)
    tau = Reference(robot).inverse_dynamics(motion.q, motion.qd, motion.qdd)
    tau += 0.01 * np.random.default_rng(0).standard_normal(tau.shape)
    wrist = Log(motion.t, motion.q, None, None, tau)
    assert not {flag.kind for flag in inspect(wrist, robot).flags} & WRONG
    for i, j in ((4, 5), (5, 6)):
        with pytest.raises(InputError, match=f"joints {i} and {j}: swapped"):
            inspect(swapped(wrist, i - 1, j - 1, "q", "tau"), robot)


def test_torques_of_another_run_are_refused(log: Log) -> None:
    other = np.random.default_rng(0).standard_normal(log.tau.shape) * np.abs(log.tau).max(axis=0)
    with pytest.raises(InputError, match="nothing of the torque is like the model's"):
        inspect(replace(log, tau=other), GIVEN)


@pytest.mark.parametrize("step", [0.0, 0.1])
def test_a_torque_that_is_cut_off(log: Log, step: float) -> None:
    limit = np.round(np.quantile(np.abs(log.tau[:, 1]), 0.97), 1)
    tau = log.tau.copy()
    tau[:, 1] = np.clip(tau[:, 1], -limit, limit)
    tau = step * np.rint(tau / step) if step else tau
    gate = inspect(replace(log, tau=tau), GIVEN)
    assert flag_of(gate, "saturation").joints == (2,)
    assert gate.joints[1].limit == pytest.approx(limit)
    at_limit = np.abs(tau[:, 1]) >= limit - 1e-9
    np.testing.assert_array_equal(gate.saturated[:, 1], at_limit)
    assert not gate.saturated[:, [0, 2]].any()


def test_little_motion_is_told(log: Log) -> None:
    q = log.q.copy()
    q[:, 0] = 0.5
    q[:, 1] = 0.2 * log.t
    q[:, 2] *= 0.05
    gate = inspect(replace(log, q=q, qd=None), GIVEN)
    assert [flag_of(gate, kind).joints for kind in ("motionless", "one_way", "narrow")] == [(1,), (2,), (3,)]
    assert [one.moves for one in gate.joints] == [False, True, True]


def test_a_long_log_is_cut_down_to_windows_of_its_motion(log: Log) -> None:
    rest = np.zeros(3 * log.samples, dtype=int)
    long = at(log, np.r_[rest, 0 : log.samples, rest])
    long = replace(long, t=np.asarray(1e-3 * np.arange(long.samples), np.float64))
    gate = inspect(long, GIVEN, most=5000)
    assert gate.log.samples <= 5000
    assert gate.flags_of("cut_down")
    assert len(gate.segments) > 5
    np.testing.assert_array_equal(gate.log.tau, long.tau[gate.rows])
    assert np.ptp(gate.log.q, axis=0) == pytest.approx(np.ptp(log.q, axis=0), rel=0.1)
    assert 1 < len(inspect(long, GIVEN, most=5000, windows=3).segments) <= 3


@pytest.mark.slow
def test_ten_million_samples_fit() -> None:
    rng = np.random.default_rng(0)
    t = np.asarray(1e-3 * np.arange(10_000_000), np.float64)
    rates = 2 * np.pi * np.array([1, 2, 1, 2, 1, 2]) / 10  # in ten seconds all is as it was
    q, qd, qdd = (
        rates**k * np.sin(rates * t[:10_000, None] + np.arange(6) + k * np.pi / 2) for k in range(3)
    )
    tau = Reference(arm("puma560")).inverse_dynamics(q, qd, qdd) + rng.standard_normal(q.shape)
    q, tau = (np.tile(x, (1000, 1)) for x in (q, tau))
    t[7_000_000] = 2.7e154
    gate = inspect(Log(t, q, None, None, tau), arm("puma560"))
    assert gate.log.samples == 200_000
    assert rows_of(gate, "garbage") == [(7_000_001, 7_000_001)]


# --- sound logs -------------------------------------------------------------------------------------------


def sound(name: str, seed: int) -> tuple[Robot, Log, set[str]]:
    """An arm and a log of it with effects that the arm's model lacks, through imperfect sensors; and which
    flags are right of it."""
    rng = np.random.default_rng(seed)
    robot = arm(name)
    motion = fourier(
        robot, float(rng.choice([0.1, 0.2])), 5, seed=seed, period=5e-3, share=float(rng.uniform(0.3, 0.98))
    )
    states = motion.q, motion.qd, motion.qdd
    size = np.sqrt((Reference(robot).inverse_dynamics(*states) ** 2).mean(axis=0))
    size += 0.01 * size.max()
    joint = int(rng.integers(1, robot.n + 1))
    own = float(size[joint - 1])
    found = [
        entry(kind, j, **{key: float(rng.uniform(0.05, 2) * size[j - 1])})
        for kind, key in (("coulomb_friction", "level"), ("viscous_friction", "coefficient"))
        if rng.random() < 0.7
        for j in range(1, robot.n + 1)
    ]
    com = tuple(rng.uniform(-0.15, 0.15, 3).tolist())
    some: list[EffectEntry] = [
        entry("payload", None, mass=float(rng.uniform(0.5, 5)), com=com),
        entry("base_tilt", None, tilt_x=float(rng.uniform(-0.2, 0.2)), tilt_y=float(rng.uniform(-0.2, 0.2))),
        entry("spring", joint, stiffness=float(rng.uniform(-1, 2) * own), rest=0.2),
        entry("torque_bias", joint, bias=float(rng.uniform(-1, 1) * own)),
        entry("torque_gain", joint, gain=float(rng.uniform(-0.4, 0.8))),
        entry("encoder_offset", joint, offset=float(rng.uniform(-0.2, 0.2))),
        entry("time_delay", None, delay=float(rng.uniform(0, 0.03))),
    ]  # fmt: skip
    found += [some[int(k)] for k in rng.choice(len(some), rng.integers(0, 3), replace=False)]
    true = folded(replace(robot, effects=tuple(e for e in found if e.effect != "spring")))
    tau = Reference(true).inverse_dynamics(*states)
    for spring in (e for e in found if e.effect == "spring"):
        tau[:, joint - 1] += spring.number("stiffness") * (motion.q[:, joint - 1] - 0.2)
    rates = str(rng.choice(["true", "none", "difference", "filtered"]))
    sensors = Sensors(
        position_resolution=resolution_of(int(rng.integers(13, 20))),
        velocity=rates,  # type: ignore[arg-type]
        acceleration="difference" if rates == "difference" else "none",
        cutoff=30.0,
        torque_noise=tuple((size * rng.uniform(0.005, 0.3)).tolist()),
        torque_resolution=float(1e-3 * size.max()) if rng.random() < 0.3 else 0.0,
    )
    shown = {"time_delay": "late_torque", "torque_gain": "torque_gain", "encoder_offset": "zero"}
    log = measure(Log(motion.t, *states, tau), sensors, true.effects, seed=seed)
    return robot, log, {shown[e.effect] for e in found if e.effect in shown}


@pytest.mark.parametrize(
    ("name", "logs"),
    representative(
        [("puma560_3dof", 20), ("puma560", 12), ("stanford", 6), ("ur10", 10), ("tx40", 10), ("panda", 2)],
        "puma560_3dof",
        rest="slow",
    ),
)
def test_sound_logs_pass_without_a_word(name: str, logs: int) -> None:
    for seed in range(logs):
        robot, log, right = sound(name, seed)
        kinds = [flag.kind for flag in inspect(log, robot).flags if flag.kind in WRONG]
        assert set(kinds) <= right, seed
        assert len(kinds) == len(set(kinds)), seed
