"""A fleet by formulas: friction that drifts, a body that nobody entered, another program, siblings."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
import pytest

from fleet.small_fleet import DAY, NAME, motion
from robodyn.fleet.digest import Digest, digest_of
from robodyn.fleet.pool.judge import judge
from robodyn.fleet.result import FleetResult
from robodyn.fleet.sources.fleet import ArmType, Fleet, LogFile
from robodyn.formats.loading import load, text_of
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log

UNITS, LOGS = 10, 8
DRIFTS, LOADED, OTHER, RESTS, FAST = 3, 7, 5, 1, 8
BEGINS = 150 * DAY


def _log(program: int, level: np.ndarray, mass: float, rng: np.random.Generator, *, rests: bool) -> Log:
    """A log of a ``program`` of an arm with friction ``level`` [n, 2] (viscous, Coulomb) and more ``mass`` at
    its last link; the last joint may rest."""
    robot = load(NAME)
    n, t = robot.n, np.arange(6 * 100) / 100
    q, qd, qdd = motion(np.random.default_rng(program), t, n, pace=rng.uniform(0.9, 1.1))
    if rests:
        q[:, -1] = qd[:, -1] = qdd[:, -1] = 0.0
    q[:, 2] += 0.8
    links = (*robot.links[:-1], replace(robot.links[-1], mass=robot.links[-1].mass + Fraction(mass)))
    tau = Model(replace(robot, links=links)).torque(q, qd, qdd)
    tau += level[:, 0] * qd + level[:, 1] * np.sign(qd) + 0.05 * rng.standard_normal(tau.shape)
    return Log(t, q, None, None, tau)


@cache
def _fleet() -> tuple[Fleet, dict[str, Digest]]:
    """Ten units with eight logs of one program each; friction falls by 1 % a degree. In one unit friction
    drifts, one carries a body, one runs another program from a day on, one rests with a joint, and of one the
    clock runs fast."""
    arm = ArmType(NAME, NAME, text_of(NAME))
    rng = np.random.default_rng(11)
    logs, digests = [], {}
    for unit in range(UNITS):
        own = np.exp(0.2 * rng.standard_normal((3, 1))) * np.array([[4.0, 6.0], [5.0, 8.0], [8.0, 10.0]])
        for k in range(LOGS):
            date = (20 + 45 * k) * DAY
            warmth = float(rng.uniform(15, 35))
            level = own * np.exp(-0.01 * (warmth - 25)) * np.exp(0.02 * rng.standard_normal((3, 1)))
            if unit == DRIFTS:
                level[1] *= 1 + 0.4 * max(0.0, min(1.0, (date - BEGINS) / (60 * DAY)))
            mass = 1.0 if unit == LOADED and date > BEGINS else 0.0
            program = 100 + unit + 50 * (unit == OTHER and date > BEGINS)
            log = _log(program, level, mass, rng, rests=unit == RESTS)
            if unit == FAST and date > BEGINS:
                log = Log(1.1 * log.t, log.q, None, None, log.tau)
            file = LogFile(f"{unit}-{k}", NAME, f"unit {unit:02d}", date, {"temperature": warmth})
            logs.append(file)
            digests[file.source] = digest_of(arm, [log])
    return Fleet("ten", {NAME: arm}, tuple(logs)), digests


@cache
def _result() -> FleetResult:
    fleet, digests = _fleet()
    return judge(fleet, digests.__getitem__)


@pytest.mark.thorough
def test_what_is_planted_is_named_and_nothing_else() -> None:
    named = {one.unit: one.claims for one in _result().units if one.claims}
    assert set(named) == {f"unit {k:02d}" for k in (DRIFTS, LOADED, OTHER, FAST)}
    (drift,), (load_,) = named[f"unit {DRIFTS:02d}"], named[f"unit {LOADED:02d}"]
    assert (drift.joint, drift.effects) == (2, ("coulomb_friction", "viscous_friction"))
    assert drift.share == pytest.approx(0.4, abs=0.1)
    assert drift.since is not None
    assert abs(drift.since - BEGINS) < 40 * DAY
    assert load_.effects == ("payload",)
    assert load_.size == pytest.approx(1.0, abs=0.15)
    assert load_.shape == "step"
    assert load_.since_interval is not None
    assert load_.since_interval[0] - 5 * DAY < BEGINS < load_.since_interval[1] + 5 * DAY


@pytest.mark.thorough
def test_another_program_and_a_wrong_clock_are_events_of_their_own() -> None:
    claims = {one.unit: one.claims for one in _result().units}
    (program,), (clock,) = claims[f"unit {OTHER:02d}"], claims[f"unit {FAST:02d}"]
    assert (program.effects, clock.effects) == (("program_change",), ("clock",))
    assert clock.size == pytest.approx(0.1, abs=0.005)
    for one in (program, clock):
        assert one.since_interval is not None
        assert one.since_interval[0] <= BEGINS <= one.since_interval[1]


@pytest.mark.thorough
def test_a_joint_that_rests_is_not_observed() -> None:
    result = _result()
    (unseen,) = [one for one in result.not_observed if one.unit == f"unit {RESTS:02d}"]
    assert unseen.joint == 3
    assert "does not move in 8 of 8 logs" in unseen.reason
    (unit,) = [one for one in result.units if one.unit == unseen.unit]
    assert "friction_3" not in unit.readings


@pytest.mark.thorough
def test_temperature_is_no_drift() -> None:
    (of_type,) = _result().types
    friction = next(one for one in of_type.features if one.name == "friction_2")
    assert friction.slopes["temperature"] == pytest.approx(-0.01 * friction.mean, rel=0.3)
    assert of_type.programs == UNITS + 1


@pytest.mark.thorough
def test_a_date_that_a_clock_has_lost_is_said() -> None:
    fleet, digests = _fleet()
    lost = {f"0-{k}" for k in (6, 7)}
    logs = tuple(
        replace(log, date=log.date - 2000 * DAY) if log.source in lost else log for log in fleet.logs
    )
    result = judge(replace(fleet, logs=tuple(sorted(logs, key=lambda log: log.order))), digests.__getitem__)
    assert {log.source for log in result.unused} == lost
    (claim,) = result.units[0].claims
    assert (claim.effects, claim.feature) == (("clock",), "date")


@pytest.mark.thorough
@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    "sources",
    [("0-0",), ("0-0", "0-1", "0-2"), ("0-0", "1-0"), tuple(f"{RESTS}-{k}" for k in range(LOGS))],
    ids=["one log", "one unit", "two units of a log", "one unit"],
)
def test_few_logs_say_little_and_break_nothing(sources: tuple[str, ...]) -> None:
    fleet, digests = _fleet()
    few = replace(fleet, logs=tuple(log for log in fleet.logs if log.source in sources))
    result = judge(few, digests.__getitem__)
    assert not [one for one in result.units if one.claims]
    assert sum(one.logs for one in result.units) == len(sources)
    assert {one.unit for one in result.not_observed} == {one.unit for one in result.units}
