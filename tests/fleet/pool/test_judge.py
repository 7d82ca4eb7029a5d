"""A fleet by formulas: friction that drifts, a body that nobody entered, and healthy siblings."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
import pytest

from robodyn.fleet.digest import Digest, digest_of
from robodyn.fleet.pool.judge import judge
from robodyn.fleet.result import FleetResult
from robodyn.fleet.sources.fleet import ArmType, Fleet, LogFile
from robodyn.formats.loading import load, text_of
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.robot.model import Robot

DAY = 86400.0
NAME = "stanford_3dof"
UNITS, LOGS = 12, 8
DRIFTS, LOADED = 3, 7
BEGINS = 150 * DAY


def _arm(level: np.ndarray, mass: float) -> Robot:
    """An arm with friction ``level`` [n, 2] (viscous, Coulomb) and so much more mass at its last link."""
    robot = load(NAME)
    links = []
    for j, link in enumerate(robot.links):
        joint = replace(
            link.joint, viscous=Fraction(float(level[j, 0])), coulomb=Fraction(float(level[j, 1]))
        )
        links.append(replace(link, joint=joint))
    links[-1] = replace(links[-1], mass=links[-1].mass + Fraction(mass))
    return replace(robot, links=tuple(links))


def _log(robot: Robot, rng: np.random.Generator) -> Log:
    n, t = robot.n, np.arange(8 * 200) / 200
    ranges = ((0.0, 6.0), (0.8, 2.5), (0.05, 0.25))
    phase, speed, size = (rng.uniform(low, high, (3, n)) for low, high in ranges)
    angle = speed[:, None] * t[None, :, None] + phase[:, None]
    q = (size[:, None] * np.sin(angle)).sum(axis=0)
    q[:, 2] += 0.8
    qd = ((size * speed)[:, None] * np.cos(angle)).sum(axis=0)
    qdd = -((size * speed**2)[:, None] * np.sin(angle)).sum(axis=0)
    tau = Model(robot).torque(q, qd, qdd)
    return Log(t, q, None, None, tau + 0.05 * rng.standard_normal(tau.shape))


@cache
def _fleet(planted: bool = True) -> tuple[Fleet, dict[str, Digest]]:
    """Twelve units with eight logs; friction falls by 1 % a degree."""
    arm = ArmType(NAME, NAME, text_of(NAME))
    rng = np.random.default_rng(11)
    logs, digests = [], {}
    for unit in range(UNITS):
        own = np.exp(0.2 * rng.standard_normal((3, 1))) * np.array([[4.0, 6.0], [5.0, 8.0], [8.0, 10.0]])
        for k in range(LOGS):
            date = (20 + 45 * k) * DAY
            warmth = float(rng.uniform(15, 35))
            level = own * np.exp(-0.01 * (warmth - 25)) * np.exp(0.02 * rng.standard_normal((3, 1)))
            late = max(0.0, min(1.0, (date - BEGINS) / (60 * DAY))) if planted else 0.0
            if unit == DRIFTS:
                level[1] *= 1 + 0.4 * late
            mass = 1.0 if planted and unit == LOADED and date > BEGINS else 0.0
            log = LogFile(f"{unit}-{k}", NAME, f"unit {unit:02d}", date, {"temperature": warmth})
            logs.append(log)
            digests[log.source] = digest_of(arm, [_log(_arm(level, mass), rng)])
    return Fleet("twelve", {NAME: arm}, tuple(logs)), digests


@cache
def _result(planted: bool = True) -> FleetResult:
    return judge(*_fleet(planted))


@pytest.mark.thorough
def test_what_is_planted_is_named_and_nothing_else() -> None:
    named = {one.unit: one.claims for one in _result().units if one.claims}
    assert set(named) == {f"unit {DRIFTS:02d}", f"unit {LOADED:02d}"}
    (drift,), (load_,) = named[f"unit {DRIFTS:02d}"], named[f"unit {LOADED:02d}"]
    assert (drift.joint, drift.effects) == (2, ("coulomb_friction", "viscous_friction"))
    assert drift.share == pytest.approx(0.4, abs=0.1)
    assert drift.since is not None
    assert abs(drift.since - BEGINS) < 30 * DAY
    assert load_.effects == ("payload",)
    assert load_.size == pytest.approx(1.0, abs=0.15)
    assert load_.shape == "step"
    assert load_.since_interval is not None
    assert load_.since_interval[0] - 5 * DAY < BEGINS < load_.since_interval[1] + 5 * DAY


@pytest.mark.slow
def test_a_healthy_fleet_has_no_names() -> None:
    assert not [one for one in _result(False).units if one.claims]


@pytest.mark.thorough
def test_temperature_is_no_drift() -> None:
    (of_type,) = _result().types
    friction = next(one for one in of_type.features if one.name == "friction_2")
    assert friction.slopes["temperature"] == pytest.approx(-0.01 * friction.mean, rel=0.3)


@pytest.mark.slow
def test_the_order_of_logs_is_no_matter() -> None:
    fleet, digests = _fleet()
    backwards = dict(reversed(digests.items()))
    assert judge(fleet, backwards) == _result()


@pytest.mark.thorough
@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    "sources",
    [("0-0",), ("0-0", "0-1", "0-2"), ("0-0", "1-0"), tuple(f"{DRIFTS}-{k}" for k in range(LOGS))],
    ids=["one log", "one unit", "two units of a log", "one unit that drifts"],
)
def test_few_logs_say_little_and_break_nothing(sources: tuple[str, ...]) -> None:
    fleet, digests = _fleet()
    few = replace(fleet, logs=tuple(log for log in fleet.logs if log.source in sources))
    result = judge(few, {source: digests[source] for source in sources})
    assert not [one for one in result.units if one.claims]
    assert sum(one.logs for one in result.units) == len(sources)


@pytest.mark.thorough
@pytest.mark.filterwarnings("error")
def test_logs_without_a_temperature_or_of_one_day() -> None:
    fleet, digests = _fleet()
    cold = replace(fleet, logs=tuple(replace(log, conditions={}) for log in fleet.logs))
    named = [one.unit for one in judge(cold, digests).units if one.claims]
    assert named == [f"unit {DRIFTS:02d}", f"unit {LOADED:02d}"]
    at_once = replace(fleet, logs=tuple(replace(log, date=0.0) for log in fleet.logs))
    claims = [claim for one in judge(at_once, digests).units for claim in one.claims]
    assert {claim.shape for claim in claims} <= {"always"}
