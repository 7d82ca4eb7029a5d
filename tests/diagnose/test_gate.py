"""The data gate: each fault of a log is found at its place, and sound logs of any arm pass."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.diagnose.gate.gate import Flag, Gate, inspect
from robodyn.errors import InputError
from robodyn.robot import load
from robodyn.robot.folding import folded
from robodyn.robot.model import EffectEntry, Limits, Robot
from robodyn.simulate.log import Log
from robodyn.simulate.sensors import Sensors, measure, resolution_of
from robodyn.simulate.simulation import Follow, simulate
from robodyn.simulate.trajectories import fourier
from robodyn.verify.reference import Reference
from robodyn_testing import representative

Floats = NDArray[np.float64]
Rng = np.random.Generator

ANGLE = Limits((Fraction(-2), Fraction(2)), Fraction(2), Fraction(8))
WAY = Limits((Fraction(1, 5), Fraction(9, 10)), Fraction(1), Fraction(4))
#: Flags that say that something is wrong, and not merely how the motion is.
WRONG = {
    "garbage", "rates_unusable", "duplicated", "repeated_time", "stray_time", "spike", "jump", "held",
    "missing", "gap", "fragment", "jitter", "cut_down", "rate_scale", "rate_mismatch", "unlike_model",
    "stuck", "perhaps_degrees", "perhaps_millimetres", "perhaps_sign", "perhaps_order", "saturation",
}  # fmt: skip


def arm(name: str) -> Robot:
    """The bundled arm with limits for a motion."""
    robot = load(name, warn=lambda _: None)
    links = [
        replace(k, joint=replace(k.joint, limits=WAY if k.joint.kind == "prismatic" else ANGLE))
        for k in robot.links
    ]
    return replace(robot, links=tuple(links))


def entry(kind: str, joint: int | None, **settings: Any) -> EffectEntry:
    exact = {k: tuple(map(fraction, v)) if isinstance(v, tuple) else fraction(v) for k, v in settings.items()}
    return EffectEntry(kind, joint, tuple(exact.items()))


def fraction(x: Any) -> Any:
    return Fraction(f"{x:.6f}") if isinstance(x, float) else x


GIVEN = arm("puma560_3dof")


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


def at(log: Log, rows: Any) -> Log:
    """The ``rows`` of ``log``, in that order."""
    return replace(log, t=log.t[rows], q=log.q[rows], qd=log.qd[rows], tau=log.tau[rows])  # type: ignore[index]


def put(log: Log, group: str, where: Any, value: Any) -> Log:
    """``log`` with ``value`` in the array ``group``."""
    array = getattr(log, group).copy()
    array[where] = value
    return replace(log, **{group: array})


def times(log: Log, factor: Any, *groups: str) -> Log:
    return replace(log, **{g: getattr(log, g) * factor for g in groups if getattr(log, g) is not None})


def swapped(log: Log, i: int, j: int, *groups: str) -> Log:
    order = np.arange(log.n)
    order[[i, j]] = j, i
    return replace(log, **{g: getattr(log, g)[:, order] for g in groups if getattr(log, g) is not None})


def flag_of(gate: Gate, kind: str) -> Flag:
    (flag,) = gate.flags_of(kind)
    return flag


def test_a_sound_log_passes_as_it_is(log: Log) -> None:
    gate = inspect(log, GIVEN)
    assert not {flag.kind for flag in gate.flags} & WRONG
    assert gate.log.q is log.q
    assert gate.log.tau is log.tau
    assert gate.segments == (slice(0, log.samples),)
    assert gate.period == pytest.approx(1e-3, rel=1e-9)
    np.testing.assert_array_equal(gate.rows, np.arange(log.samples))


def test_what_there_is_of_each_joint(log: Log) -> None:
    for j, one in enumerate(inspect(log, GIVEN).joints):
        speed = np.gradient(log.q[:, j], log.t)
        np.testing.assert_allclose(one.speed, np.quantile(np.abs(speed), 0.99), rtol=0.05)
        assert (one.low, one.high) == (log.q[:, j].min(), log.q[:, j].max())
        assert one.position_step == pytest.approx(2 * np.pi / 2**17, rel=1e-6)
        assert one.torque_step == 0
        assert one.torque_noise == pytest.approx(0.3, rel=0.05)
        assert one.lag == pytest.approx(0.5e-3, abs=0.2e-3)  # a difference looks half a sample back
        assert one.forward == pytest.approx(0.5, abs=0.02)  # a periodic motion
        assert one.drive > 0.2
        assert one.brake > 0.2
        assert one.reversals >= 4


# --- rows and times ---------------------------------------------------------------------------------------


def rows_of(gate: Gate, kind: str) -> list[tuple[int, int]]:
    return [(span.first, span.last) for span in flag_of(gate, kind).spans]


@pytest.mark.parametrize(
    ("kind", "spoil"),
    [
        ("garbage", lambda log: put(log, "q", (500, 1), np.nan)),
        ("garbage", lambda log: put(log, "tau", (500, 2), -np.inf)),
        ("garbage", lambda log: put(log, "q", 500, 1e-300 + 1e20)),
        ("garbage", lambda log: put(log, "t", 500, 2.7e154)),
        ("stray_time", lambda log: put(log, "t", 500, 9e3)),
        ("stray_time", lambda log: put(log, "t", 500, 0.1)),
        ("spike", lambda log: put(log, "q", (500, 0), 1.5)),
        ("spike", lambda log: put(log, "tau", (500, 1), 900.0)),
        ("spike", lambda log: put(put(log, "tau", (500, 1), 900.0), "q", (500, 1), 9.0)),
    ],
)
def test_a_broken_row_is_left_out_and_filled_in(log: Log, kind: str, spoil: Callable[[Log], Log]) -> None:
    gate = inspect(spoil(log), GIVEN)
    for flag in gate.flags_of(kind):
        assert [(span.first, span.last) for span in flag.spans] == [(501, 501)]
    assert gate.flags_of(kind)
    assert flag_of(gate, "missing").spans[0].first == 500
    assert gate.log.samples == log.samples
    np.testing.assert_allclose(gate.log.q[500], log.q[500], atol=2e-4)
    np.testing.assert_allclose(np.delete(gate.log.q, 500, 0), np.delete(log.q, 500, 0), atol=1e-9)


def test_the_joint_of_a_broken_number_is_named(log: Log) -> None:
    flag = flag_of(inspect(put(log, "tau", (500, 2), np.nan), GIVEN), "garbage")
    assert (flag.where, flag.joints) == ("tau3", (3,))
    assert "row 501 (t = 0.5 s)" in str(flag)


def test_rows_that_stand_twice(log: Log) -> None:
    twice = at(log, np.sort(np.r_[0 : log.samples, 70, 300:310]))
    gate = inspect(twice, GIVEN)
    assert rows_of(gate, "duplicated")[0] == (72, 72)
    np.testing.assert_array_equal(gate.log.tau, log.tau)


def test_a_gap_cuts_the_log(log: Log) -> None:
    gate = inspect(at(log, np.r_[0:3000, 3500 : log.samples]), GIVEN)
    assert rows_of(gate, "gap") == [(3000, 3001)]
    assert flag_of(gate, "gap").spans[0].end == pytest.approx(3.5)
    assert gate.segments == (slice(0, 3000), slice(3000, log.samples - 500))
    np.testing.assert_array_equal(gate.log.q[gate.segments[1]], log.q[3500:])


def test_a_jump_of_the_position_cuts_the_log(log: Log) -> None:
    gate = inspect(put(log, "q", np.s_[3000:, 1], log.q[3000:, 1] + 0.5), GIVEN)
    assert rows_of(gate, "jump") == [(3001, 3001)]
    assert [part.start for part in gate.segments] == [0, 3000]


def test_uneven_times_are_resampled(log: Log) -> None:
    rng = np.random.default_rng(2)
    t = log.t + rng.uniform(-2e-4, 2e-4, log.samples)
    course = np.stack([np.interp(t, log.t, log.q[:, j]) for j in range(3)], axis=1)
    gate = inspect(replace(log, t=t, q=course), GIVEN)
    assert gate.flags_of("jitter")
    np.testing.assert_allclose(np.diff(gate.log.t), gate.period, rtol=1e-6)
    within = np.stack([np.interp(gate.log.t, log.t, log.q[:, j]) for j in range(3)], axis=1)
    np.testing.assert_allclose(gate.log.q[2:-2], within[2:-2], atol=1e-4)


def test_times_with_few_digits_are_even(log: Log) -> None:
    thin = at(log, np.arange(0, log.samples, 4))
    gate = inspect(replace(thin, t=np.round(thin.t, 3)), GIVEN)
    assert not gate.flags_of("jitter")
    assert gate.log.q is thin.q


def test_a_slower_source_is_seen(log: Log) -> None:
    held = np.arange(log.samples) // 8 * 8
    gate = inspect(replace(log, q=log.q[held], qd=None, tau=log.tau[held]), GIVEN)
    assert gate.flags_of("held")
    assert gate.period == pytest.approx(8e-3)
    np.testing.assert_array_equal(gate.log.q, log.q[::8])


REFUSED: dict[str, tuple[Callable[[Log], Log], str]] = {
    "10 samples": (lambda log: at(log, slice(10)), "10 rows"),
    "numbers missing": (lambda log: put(log, "q", np.s_[500:1500, 1], np.nan), "q2.*row 501"),
    "no torque": (lambda log: put(log, "tau", np.s_[:, 2], np.nan), "tau3"),
    "counts": (lambda log: times(log, 20000.0, "q"), "q1 cannot be used"),
    "backwards": (lambda log: at(log, slice(None, None, -1)), "time runs backwards.*row 2"),
    "two runs": (lambda log: at(log, np.r_[0:5000, 0:5000]), "time runs backwards.*row 5001"),
    "shuffled": (lambda log: at(log, np.random.default_rng(0).permutation(log.samples)), "backwards"),
    "few digits": (lambda log: replace(log, t=np.round(log.t, 2)), "times repeat.*more digits"),
    "milliseconds": (lambda log: replace(log, t=1e3 * log.t), "t in seconds"),
    "other robot": (lambda log: replace(log, q=log.q[:, :2], qd=None, tau=log.tau[:, :2]), "2 joints"),
    "degrees": (lambda log: times(log, 180 / np.pi, "q", "qd"), "q1, q2, q3: degrees for radians.*pi/180"),
    "degrees in q": (lambda log: times(log, 180 / np.pi, "q"), "degrees for radians in the position"),
    "degrees in qd": (lambda log: times(log, 180 / np.pi, "qd"), "degrees for radians in the rate"),
    "sign of qd2": (lambda log: times(log, [1.0, -1.0, 1.0], "qd"), "qd2 does not fit q2: its sign"),
    "sign of tau2": (lambda log: times(log, [1.0, -1.0, 1.0], "tau"), "tau2: the sign"),
    "sign of tau": (lambda log: times(log, -1.0, "tau"), "tau1, tau2, tau3: the sign"),
    "sign of q2": (lambda log: times(log, [1.0, -1.0, 1.0], "q", "qd"), "q2: the sign"),
    "order of qd": (lambda log: swapped(log, 0, 2, "qd"), "joints 1 and 3 are swapped"),
    "order of tau": (lambda log: swapped(log, 1, 2, "tau"), "tau2, tau3: swapped"),
    "sign of all q": (lambda log: times(log, -1.0, "q", "qd"), "q1, q2, q3: the sign of all positions"),
    "joint 3 turned": (lambda log: times(log, [1.0, 1.0, -1.0], "q", "qd", "tau"), "q3, tau3: the joint"),
    "order of q": (lambda log: swapped(log, 0, 2, "q", "qd"), "q1, q3: swapped"),
    "joints 1 and 2": (lambda log: swapped(log, 0, 1, "q", "qd", "tau"), "joints 1 and 2: swapped"),
    "joints 1 and 3": (lambda log: swapped(log, 0, 2, "q", "qd", "tau"), "joints 1 and 3: swapped"),
    "amperes": (lambda log: times(log, 1 / 30, "tau"), "tau1, tau2, tau3: another unit.*torque constant"),
    "N mm": (lambda log: times(log, 1e3, "tau"), "another unit.*divide by 1000"),
    "kN m": (lambda log: times(log, 1e-3, "tau"), "another unit.*multiply by 1000"),
    "order of joints": (lambda log: swapped(log, 1, 2, "q", "qd", "tau"), "joints 2 and 3: swapped"),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_a_log_that_misleads_is_refused(log: Log, name: str) -> None:
    spoil, says = REFUSED[name]
    with pytest.raises(InputError, match=says) as caught:
        inspect(spoil(log), GIVEN, source="log.csv")
    assert str(caught.value).startswith("log.csv: ")
    assert caught.value.remedy


def test_a_flipped_sign_under_much_friction(log: Log) -> None:
    friction = 40 * np.tanh(log.qd[:, 2] / 0.05)  # type: ignore[index]
    rubbed = put(log, "tau", np.s_[:, 2], log.tau[:, 2] + friction)
    assert not {flag.kind for flag in inspect(rubbed, GIVEN).flags} & WRONG
    with pytest.raises(InputError, match="tau3: the sign"):
        inspect(times(rubbed, [1.0, 1.0, -1.0], "tau"), GIVEN)


# --- lesser things ----------------------------------------------------------------------------------------


def test_velocities_that_are_late(log: Log) -> None:
    late = np.roll(log.qd, 12, axis=0)  # type: ignore[arg-type]
    gate = inspect(replace(log, qd=late), GIVEN)
    np.testing.assert_allclose([one.lag for one in gate.joints], 12.5e-3, atol=0.5e-3)
    assert gate.flags_of("velocity_lag")


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


def test_positions_that_drop_out_often_are_left_out(log: Log) -> None:
    rows = np.arange(50, log.samples - 50, 100)
    gate = inspect(put(log, "q", (rows, 1), 3.0), GIVEN)
    assert [span.first - 1 for span in flag_of(gate, "spike").spans] == rows[:100].tolist()
    np.testing.assert_allclose(gate.log.q, log.q, atol=2e-4)


def test_a_spring_that_outdoes_gravity_passes(log: Log) -> None:
    # It pulls the other way than gravity, and more: the sign of the torque looks flipped.
    for j, stiffness in ((1, -60.0), (1, 120.0), (2, 40.0), (2, -40.0)):
        sprung = put(log, "tau", np.s_[:, j], log.tau[:, j] + stiffness * (log.q[:, j] - 0.2))
        inspect(sprung, GIVEN)


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
    long = replace(long, t=1e-3 * np.arange(long.samples))
    gate = inspect(long, GIVEN, most=5000)
    assert gate.log.samples <= 5000
    assert gate.flags_of("cut_down")
    assert len(gate.segments) > 5
    np.testing.assert_array_equal(gate.log.tau, long.tau[gate.rows])
    assert np.ptp(gate.log.q, axis=0) == pytest.approx(np.ptp(log.q, axis=0), rel=0.1)


@pytest.mark.slow
def test_ten_million_samples_fit() -> None:
    rng = np.random.default_rng(0)
    t = 1e-3 * np.arange(10_000_000)
    q = np.stack([np.sin((0.7 + 0.13 * j) * t) for j in range(6)], axis=1)
    t[7_000_000] = 2.7e154
    tau = rng.standard_normal((1000, 6))[np.arange(len(t)) % 1000]
    gate = inspect(Log(t, q, None, None, tau), arm("puma560"))
    assert gate.log.samples == 200_000
    assert rows_of(gate, "garbage") == [(7_000_001, 7_000_001)]


# --- sound logs -------------------------------------------------------------------------------------------


def sound(name: str, seed: int) -> tuple[Robot, Log]:
    """An arm and a log of it with effects that the arm's model lacks, through imperfect sensors."""
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
    return robot, measure(Log(motion.t, *states, tau), sensors, true.effects, seed=seed)


@pytest.mark.parametrize(
    ("name", "logs"),
    representative(
        [("puma560_3dof", 20), ("puma560", 12), ("stanford", 6), ("ur10", 10), ("tx40", 10), ("panda", 2)],
        "puma560_3dof",
        "stanford",
    ),
)
def test_sound_logs_pass_without_a_word(name: str, logs: int) -> None:
    for seed in range(logs):
        gate = inspect(*sound(name, seed)[::-1])
        assert not [str(flag) for flag in gate.flags if flag.kind in WRONG], seed
