"""Zeros, gains, lateness and torques without gravity are flagged with their number, whatever masses are."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from benchmarks.blind_arms.arms import perturbed

from gate.gated import WRONG, arm, entry, swapped
from robodyn.errors import InputError
from robodyn.gate.gate import Gate, inspect
from robodyn.logs.log import Log, read_log
from robodyn.robot import load
from robodyn.robot.folding import folded
from robodyn.robot.model import Robot
from robodyn.simulate.trajectories import fourier
from robodyn.verify.reference import Reference

READINGS = {"torque_gain", "zero", "late_torque", "perhaps_no_gravity", "description_off"}


@pytest.fixture(scope="module")
def ur10() -> Robot:
    return arm("ur10")


@pytest.fixture(scope="module")
def described(ur10: Robot) -> Robot:
    """Its masses, centres and inertias 30 % off; nothing is stated of them."""
    return perturbed(ur10, 0.3, 1)


@pytest.fixture(scope="module")
def clean(ur10: Robot) -> Log:
    """A log with friction and noise."""
    motion = fourier(ur10, 0.2, 5, seed=6, period=5e-3)
    tau = Reference(ur10).inverse_dynamics(motion.q, motion.qd, motion.qdd)
    tau += 0.3 * np.tanh(motion.qd / 0.02) + 0.02 * np.random.default_rng(0).standard_normal(tau.shape)
    return Log(motion.t, motion.q, None, None, tau)


def flag_text(gate: Gate, kind: str, where: str) -> str:
    """What the flag of that ``kind`` says, the only one of a reading."""
    (flag,) = [flag for flag in gate.flags if flag.kind in READINGS]
    assert (flag.kind, flag.where) == (kind, where)
    return flag.text


def number_in(text: str) -> float:
    first = re.search(r"-?[\d.]+", text)
    assert first
    return float(first[0])


def test_a_clean_log_has_no_other_reading(clean: Log, described: Robot) -> None:
    kinds = {flag.kind for flag in inspect(clean, described).flags}
    assert not kinds & (READINGS | WRONG)


@pytest.fixture(scope="module")
def recorded() -> tuple[Robot, Log]:
    """A UR10 and its recording; of its links nothing is stated."""
    folder = Path(__file__).parents[2] / "examples" / "real" / "ur10_bag"
    robot = load(folder / "ur10_bag.yaml", warn=lambda _: None)
    return robot, read_log(folder / "ur10_bag.csv", robot.n)


def spoilt(log: Log, joint: int, factor: float = 1.0, zero: float = 0.0) -> Log:
    """``log`` with a torque times the ``factor``, and a position that reads ``zero`` [rad] more."""
    own = np.arange(log.n) == joint - 1
    return replace(log, tau=log.tau * np.where(own, factor, 1.0), q=log.q + zero * own)


def test_a_recording_passes_as_it_is(recorded: tuple[Robot, Log]) -> None:
    robot, log = recorded
    assert not {flag.kind for flag in inspect(log, robot).flags} & (READINGS | WRONG)


@pytest.mark.parametrize(
    ("joint", "groups", "says"),
    [
        (4, ("q", "qd", "tau"), "joints 4 and 5: swapped"),
        (2, ("tau",), "tau2, tau3: swapped"),
        (4, ("tau",), "tau4, tau5: swapped"),
        (5, ("tau",), "tau5, tau6: swapped"),
        (3, ("q", "qd"), "q3, q4: swapped"),
    ],
)
def test_neighbours_of_a_recording_exchanged(
    recorded: tuple[Robot, Log], joint: int, groups: tuple[str, ...], says: str
) -> None:
    robot, log = recorded
    with pytest.raises(InputError, match=f"^{says}"):
        inspect(swapped(log, joint - 1, joint, *groups), robot)


@pytest.mark.parametrize(("joint", "factor"), [(1, 10.0), (2, 0.1), (4, 0.05)])
def test_a_recorded_torque_in_amperes(recorded: tuple[Robot, Log], joint: int, factor: float) -> None:
    robot, log = recorded
    text = flag_text(inspect(spoilt(log, joint, factor), robot), "torque_gain", f"tau{joint}")
    assert number_in(text) == pytest.approx(factor, rel=0.1)


def test_a_zero_that_a_description_can_tell(clean: Log, ur10: Robot) -> None:
    near = perturbed(ur10, 0.05, 1)
    assert not {flag.kind for flag in inspect(clean, near).flags} & READINGS
    text = flag_text(inspect(spoilt(clean, 3, zero=np.radians(6)), near), "zero", "q3")
    assert number_in(text) == pytest.approx(6, abs=1)


def test_a_zero_of_a_vertical_axis_shows_in_no_torque(clean: Log, described: Robot) -> None:
    gate = inspect(spoilt(clean, 1, zero=np.pi / 2), described)
    assert not {flag.kind for flag in gate.flags} & READINGS


def test_a_description_of_another_arm(clean: Log, ur10: Robot) -> None:
    links = [
        replace(link, mass=link.mass * factor, confidence=Fraction(1, 10))
        for link, factor in zip(ur10.links, (1, 2, 1, 3, 1, 4), strict=True)
    ]
    gate = inspect(clean, replace(ur10, links=tuple(links)))
    assert [flag.kind for flag in gate.flags if flag.kind in READINGS] == ["description_off"]


def test_a_load_is_no_other_reading(clean: Log, ur10: Robot, described: Robot) -> None:
    payload = entry("payload", None, mass=3.0, com=(0.05, 0.0, 0.1))
    loaded = folded(replace(ur10, effects=(payload,)))
    motion = fourier(ur10, 0.2, 5, seed=6, period=5e-3)  # of the log
    states = motion.q, motion.qd, motion.qdd
    own, more = (Reference(one).inverse_dynamics(*states) for one in (ur10, loaded))
    gate = inspect(replace(clean, tau=clean.tau + more - own), described)
    assert not {flag.kind for flag in gate.flags} & WRONG


@pytest.mark.parametrize("factor", [0.05, 2.0])
def test_a_torque_constant(clean: Log, described: Robot, factor: float) -> None:
    text = flag_text(inspect(spoilt(clean, 3, factor), described), "torque_gain", "tau3")
    assert number_in(text) == pytest.approx(factor, rel=0.1)


def test_a_zero(clean: Log, described: Robot) -> None:
    text = flag_text(inspect(spoilt(clean, 3, zero=np.pi / 2), described), "zero", "q3")
    assert number_in(text) == pytest.approx(90, abs=6)


def test_late_torques(clean: Log, described: Robot) -> None:
    tau = np.stack([np.interp(clean.t - 0.02, clean.t, x) for x in clean.tau.T], axis=1)
    text = flag_text(
        inspect(replace(clean, tau=tau), described), "late_torque", "tau1, tau2, tau3, tau4, tau5, tau6"
    )
    assert number_in(text) == pytest.approx(20, abs=2)


@pytest.mark.parametrize("clock", [0.5, 1.1, 2.0])
def test_a_clock(clean: Log, described: Robot, clock: float) -> None:
    with pytest.raises(InputError, match=r"^t: ") as caught:
        inspect(replace(clean, t=clock * clean.t), described)
    assert number_in(str(caught.value)) == pytest.approx(clock, rel=0.05)
    assert "divide t by about" in str(caught.value)


@pytest.mark.parametrize("factor", [0, 1, 3])
def test_inertias_that_are_all_far_off_are_no_clock(clean: Log, ur10: Robot, factor: int) -> None:
    links = [
        replace(link, inertia=type(link.inertia)(*(factor * x for x in link.inertia.entries)))
        for link in ur10.links
    ]
    gate = inspect(clean, replace(ur10, links=tuple(links)))
    assert not {flag.kind for flag in gate.flags} & WRONG


def test_torques_without_gravity(clean: Log, ur10: Robot, described: Robot) -> None:
    weight = Reference(ur10).inverse_dynamics(clean.q, 0 * clean.q, 0 * clean.q)
    gate = inspect(replace(clean, tau=clean.tau - weight), described)
    assert [flag.kind for flag in gate.flags if flag.kind in READINGS] == ["perhaps_no_gravity"]


def test_a_wrist_in_another_order(clean: Log, described: Robot) -> None:
    order = [0, 1, 2, 4, 3, 5]
    with pytest.raises(InputError, match="joints 4 and 5: swapped"):
        inspect(replace(clean, q=clean.q[:, order], tau=clean.tau[:, order]), described)


@pytest.mark.parametrize("down", [(9.81, 0, 0), (0, -9.81, 0), (0, 0, 9.81), (0, 6.9, -6.9)])
def test_an_arm_that_is_mounted_otherwise(
    clean: Log, ur10: Robot, described: Robot, down: tuple[float, float, float]
) -> None:
    gravity = dict(zip("xyz", map(Fraction, down), strict=True))
    mounted = replace(ur10, gravity=(gravity["x"], gravity["y"], gravity["z"]))
    weights = [
        Reference(each).inverse_dynamics(clean.q, 0 * clean.q, 0 * clean.q) for each in (ur10, mounted)
    ]
    with pytest.raises(InputError, match=r"gravity: acts along") as refused:
        inspect(replace(clean, tau=clean.tau + weights[1] - weights[0]), described)
    assert refused.value.remedy is not None
    found = np.array([float(x) for x in re.findall(r"-?[\d.]+", refused.value.remedy)[:3]])
    assert found @ np.array(down) > 0.95 * np.linalg.norm(found) * np.linalg.norm(down)


def test_a_log_of_which_no_reading_is_like_the_model_has_no_map_that_mends_it(
    clean: Log, described: Robot
) -> None:
    with pytest.raises(InputError, match=r"however the log is read|nothing of the torque is like") as refused:
        inspect(replace(clean, tau=clean.tau[::-1].copy()), described)
    assert refused.value.remedy == "see whether the log is of another robot or run, and in SI units"
