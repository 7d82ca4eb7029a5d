"""The arm's own numbers beside findings that move the arm: a base that leans shows what a level one hides."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from benchmarks.blind_arms.arms import misjudged
from benchmarks.blind_arms.logs import hidden_log

from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.diagnose.select import own_numbers as room
from robodyn.diagnose.select import refine
from robodyn.diagnose.select.choice import _is_likely
from robodyn.diagnose.select.fit import Fit, Problem, by_prior, covariance, fitted, problem, tighter
from robodyn.diagnose.select.forward import Chosen, Key, Named
from robodyn.diagnose.select.library import Context, context_of
from robodyn.diagnose.select.library.candidate import single
from robodyn.diagnose.select.limits import LEAST_PRIOR_SHARE, TIGHT
from robodyn.diagnose.select.own_numbers import own_numbers, own_numbers_of
from robodyn.diagnose.select.prior_share import prior_share
from robodyn.diagnose.select.refine import refined
from robodyn.diagnose.select.selection import _View, prior_scales, select, start_of
from robodyn.diagnose.select.trial import Trial
from robodyn.diagnose.select.uncertainty import uncertainties
from robodyn.identify.twist import behind_motors
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.logs.signals import signals_of
from robodyn.robot import load
from robodyn.robot.model import Robot
from robodyn.simulate.sensors import measured_torque

Torques = Callable[[Any, Any, Any, Any], Any]
ARM = load("puma560_3dof", warn=lambda _: None)
ROTOR = ARM.links[1].joint.motor_inertia
TILT = Amendment("base_tilt", None, {"tilt_x": 0.02, "tilt_y": -0.03})


RUBBING = amended(ARM, [Amendment("coulomb_friction", j, {"level": 10.0}) for j in (1, 2, 3)])
LATE = Amendment("time_delay", None, {"delay": 0.01})


def along(share: float) -> tuple[list[Context], Problem]:
    """A log of the leaning arm, as a search of the level one sees it, whose numbers are known to a share."""
    return seen(ARM, share, lambda q, qd, qdd, t: Model(amended(ARM, [TILT])).torque(q, qd, qdd))


def seen(robot: Robot, share: float, torques: Torques, step: float = 0.01) -> tuple[list[Context], Problem]:
    """A log with such ``torques``, as a search of ``robot`` sees it, whose numbers are known to a share."""
    t = np.arange(0, 6, step)
    phase = np.array([0.0, 1.0, 2.0])
    q, qd, qdd = (
        0.9 * (2 * np.pi * 0.4) ** k * np.sin(2 * np.pi * 0.4 * t[:, None] + phase + k * np.pi / 2)
        for k in range(3)
    )
    tau = torques(q, qd, qdd, t)
    tau = tau + 0.01 * np.random.default_rng(1).standard_normal(tau.shape)
    contexts = [context_of(Model(robot), signals_of(Log(t, q, None, None, tau)))]
    return contexts, start_of(contexts, prior_scales(contexts[0].model, share))


def test_columns_are_those_of_the_arm_as_it_stands() -> None:
    contexts, start = along(0.1)
    leaning = amended(ARM, [TILT])
    columns, prior = own_numbers_of(leaning, ARM, contexts, start)
    assert (
        len(prior) == columns.shape[1] > start.nuisance
    )  # a centre of mass that the level arm does not feel
    Y = Model(leaning).regressor(contexts[0].slow.q, contexts[0].slow.qd, contexts[0].slow.qdd)
    seen = contexts[0].slow.thinned(contexts[0].slow.filtered(Y.reshape(len(Y), 3, -1)))
    units = (seen * start.sizes / start.sigma[:, None]).reshape(len(columns), -1)
    some = slice(None, None, 20)
    np.testing.assert_allclose(columns[some] @ columns[some].T, units[some] @ units[some].T, atol=1e-4)
    again, _ = own_numbers_of(ARM, ARM, contexts, start)
    assert np.shares_memory(again, own_numbers(start)[0])


def test_a_tilt_is_known_no_better_than_the_centre_of_mass_that_it_shows() -> None:
    errors = []
    for share in (0.003, 0.3):
        contexts, start = along(share)
        _, (sure,) = uncertainties(ARM, [TILT], contexts, start)
        stderr = sure["tilt_y"].stderr
        assert stderr is not None
        errors.append(stderr)
    assert errors[1] > 2 * errors[0]


@pytest.mark.thorough
def test_of_a_link_and_its_rotor_only_the_sum_is_known_better_than_said() -> None:
    """An identified arm has the rigid arm's torques right, and a rotor for some of its link's inertia."""
    step, spring = 0.005, Amendment("joint_elasticity", 2, {"stiffness": 3000.0, "damping": 6.0})
    second = ARM.links[1]
    less, more = (x + sign * Fraction(3, 20) for x, sign in ((second.inertia.zz, -1), (ROTOR, 1)))
    mixed = replace(
        second, inertia=replace(second.inertia, zz=less), joint=replace(second.joint, motor_inertia=more),
        confidence=Fraction(3, 10),
    )  # fmt: skip
    described = replace(ARM, links=(ARM.links[0], mixed, ARM.links[2]))

    def torques(q: Any, qd: Any, qdd: Any, t: Any) -> Any:
        return behind_motors(Model(amended(ARM, [spring])), q, qd, qdd, step).total

    contexts, start = seen(described, 0.3, torques, step)
    (one,), (sure,) = uncertainties(described, [spring], contexts, tighter(start, 0.01))
    low, high = sure["stiffness"].low, sure["stiffness"].high
    assert low is not None
    assert high is not None
    assert low < 3000 < high < 1.1 * low
    assert float(one.parameters["stiffness"]) == pytest.approx(3000, rel=0.02)
    assert float(one.parameters["damping"]) == pytest.approx(6, rel=0.05)


def test_joints_that_stick_at_reversals_are_no_delay(monkeypatch: pytest.MonkeyPatch) -> None:
    step = 0.002

    def torques(q: Any, qd: Any, qdd: Any, t: Any) -> Any:
        # Friction turns a sample before the joints do.
        early = np.sign(qd + step * qdd) - np.sign(qd)
        torque = Model(RUBBING).torque(q, qd, qdd) + 10.0 * early
        return measured_torque(torque, t, amended(RUBBING, [LATE]).effects)

    contexts, start = seen(RUBBING, 0.1, torques, step)

    def off() -> float:
        (one,) = refined(RUBBING, [LATE], contexts, start)
        _, (sure,) = uncertainties(RUBBING, [one], contexts, start)
        assert sure["delay"].stderr is not None
        return abs(float(one.parameters["delay"]) - 0.01) / sure["delay"].stderr

    assert off() < 2.5
    monkeypatch.setattr(room, "TURN_TIME", 1e-9)
    assert off() > 4


@pytest.mark.parametrize(
    ("wrong", "name", "true"),
    [
        (Amendment("torque_gain", 2, {"gain": -0.6}), "gain", -0.6),
        (Amendment("time_delay", None, {"delay": 0.04}), "delay", 0.04),
        (Amendment("torque_saturation", 3, {"limit": 4.0, "clips": "sensor"}), "limit", 4.0),
    ],
    ids=lambda value: value.effect if isinstance(value, Amendment) else None,
)
def test_torque_channels_pass_the_arms_own_numbers_on(
    wrong: Amendment, name: str, true: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Errors of the links' numbers come through late, scaled or not at all, as the torque does."""
    ARMS_OWN = 1.1  # its inertial numbers are larger than described

    def torques(q: Any, qd: Any, qdd: Any, t: Any) -> Any:
        torque = Model(ARM).torque(q, qd, qdd)
        more = (ARMS_OWN - 1) * Model(ARM).rigid_torque(q, qd, qdd)
        return measured_torque(torque + more, t, amended(ARM, [wrong]).effects)

    contexts, start = seen(ARM, 0.1, torques)

    def off() -> float:
        begun = Amendment(wrong.effect, wrong.joint, {**wrong.parameters, name: 1.02 * true})
        (one,) = refined(ARM, [begun], contexts, start)
        _, (sure,) = uncertainties(ARM, [one], contexts, start)
        assert sure[name].stderr is not None
        return abs(float(one.parameters[name]) - true) / sure[name].stderr

    assert off() < 2.5
    monkeypatch.setattr(room, "measured_slopes", lambda slopes, *_: slopes)
    assert off() > 4


def test_joints_that_creep_near_rest_have_no_less_static_friction(monkeypatch: pytest.MonkeyPatch) -> None:
    law = {"level": 10.0, "static": 25.0, "velocity": 0.6}
    slow = Amendment("stribeck_friction", 2, law)

    def torques(q: Any, qd: Any, qdd: Any, t: Any) -> Any:
        free, rubbing = (Model(arm).torque(q, qd, qdd) for arm in (ARM, amended(ARM, [slow])))
        return free + (rubbing - free) * np.minimum(1.0, np.abs(qd) / 0.1)

    contexts, start = seen(ARM, 0.1, torques, 0.002)

    def off() -> float:
        (one,) = refined(ARM, [slow], contexts, start)
        (one,), _ = uncertainties(ARM, [one], contexts, start)
        return abs(float(one.parameters["static"]) / 25.0 - 1)

    assert off() < 0.005
    monkeypatch.setattr(refine, "STICKING_SPEEDS", (1e-9,))
    assert off() > 0.02


def test_a_sticking_speed_that_does_not_show_leaves_the_other_numbers_free() -> None:
    """No sample of the log is so slow: the speed has no slope at all."""
    friction = Amendment("load_dependent_friction", 2, {"bearing": "torque", "mu": 0.05})
    true = Model(amended(ARM, [friction]))
    contexts, start = seen(ARM, 0.1, lambda q, qd, qdd, t: true.torque(q, qd, qdd))
    began = replace(friction, parameters={**friction.parameters, "mu": 0.06})
    freed = refine.Freed.of(ARM, [began], contexts, start, by_drives=True)
    x = refine.fitted(replace(freed, sticking={1: 1e-9}))
    assert x[0] == pytest.approx(0.05, rel=0.05)
    assert x[1] == 1e-9


# --- how exact a description is ---------------------------------------------------------------------------


SAMPLES, NUMBERS = 400, 20


def log_of(share: float, seed: int, size: float = 3.0) -> Problem:
    """A log of an arm that is wrong by a ``share`` of what is said; each number shows by ``size``."""
    rng = np.random.default_rng(seed)
    Y = size * rng.standard_normal((SAMPLES, 1, NUMBERS))
    wrong = share * rng.standard_normal(NUMBERS)
    return problem(Y @ wrong + rng.standard_normal((SAMPLES, 1)), Y, np.ones(1), 1.0)


@pytest.mark.parametrize("share", [1.0, 0.3, 0.1])
def test_the_share_of_what_is_said_shows(share: float) -> None:
    logs = [log_of(share, seed) for seed in range(5)]
    shares = [prior_share(p, fitted(p)) for p in logs]
    assert 0.75 * share < np.mean(shares) < min(1.3 * share, 1.0)


def test_nothing_is_taken_to_be_exact_that_does_not_show() -> None:
    p = log_of(0.0, 1)
    assert prior_share(p, fitted(p)) < 3 * LEAST_PRIOR_SHARE
    p = log_of(0.0, 1, size=0.01)
    assert prior_share(p, fitted(p)) > 0.95
    p = tighter(p, LEAST_PRIOR_SHARE)
    assert prior_share(p, fitted(p)) == pytest.approx(LEAST_PRIOR_SHARE)


@pytest.mark.parametrize("share", [1.0, 0.03])
def test_intervals_beside_the_arms_numbers_hold_however_exact_these_are(share: float) -> None:
    off = []
    for seed in range(60):
        rng = np.random.default_rng((seed, 7))
        column = log_of(0.0, seed).A[:, :, :1].astype(np.float64) + 0.1 * rng.standard_normal((SAMPLES, 1, 1))
        p = log_of(share, seed).with_columns((0,), column)
        p = tighter(p, prior_share(p, fitted(p)))
        off.append(abs(fitted(p).known[-1]) / np.sqrt(covariance(p, fitted(p))[-1, -1]))
    assert 53 <= np.sum(np.array(off) < 1.96) <= 60
    assert np.median(off) > 0.3


def test_what_no_torque_shows_is_known_as_well_as_its_prior_says() -> None:
    rng = np.random.default_rng(2)
    columns = np.concatenate([rng.standard_normal((SAMPLES, 1, 1)), np.zeros((SAMPLES, 1, 1))], axis=2)
    p = log_of(0.0, 2).with_columns((0,), columns, np.array([5.0, 7.0]))
    seen, unseen = np.sqrt(np.diag(covariance(p, fitted(p)))[-2:])
    assert unseen == pytest.approx(7.0, rel=0.3)
    assert seen < 0.2
    own = np.sqrt(np.sum(by_prior(p, slice(NUMBERS, NUMBERS + 2)) ** 2, axis=1))
    assert own[0] < 0.05 * seen
    assert own[1] > 0.7 * unseen


# --- numbers that are better than described ---------------------------------------------------------------


@pytest.mark.thorough
def test_of_a_scatter_of_all_numbers_no_link_and_no_load_is_named() -> None:
    logs = hidden_log(
        "puma560_3dof", [], seed=5, duration=6.0, noise_share=0.015, validation=False, friction=False
    )
    assert select(misjudged(logs.given, 0.1, 5), logs.train).findings == ()


def view(names: list[Key], tight: float, evidence: float) -> _View:
    now = problem(np.ones((100, 1)), np.ones((100, 1, 1)), np.ones(1), 1.0)
    named = [
        Named(
            replace(one, candidate=replace(one.candidate, effect=effect, joint=joint)),
            (),
            0.9,
            *[np.zeros(1)] * 2,
        )
        for effect, joint in names
        for one in [trial(1.0, 0.1, 1.0)]
    ]
    return _View(now, Chosen(named, now, fitted(now), []), evidence, tight, None)


@pytest.mark.parametrize(
    ("names", "known", "tight", "evidence", "may"),
    [
        ([("gas_spring", 2)], [], 0.1, 6.0, True),
        ([("inertial_error", 2)], [], min(TIGHT), 1000.0, True),
        ([("inertial_error", 2)], [], max(TIGHT), 1000.0, False),  # the others are not exact
        ([("inertial_error", 2)], [], min(TIGHT), 20.0, False),
        ([("inertial_error", 2), ("inertial_error", 3)], [], min(TIGHT), 1000.0, False),
        ([("payload", None)], [], min(TIGHT), 1000.0, True),
        ([("payload", None)], [], max(TIGHT), 1000.0, False),
        ([("payload", None)], [("coulomb_friction", 1)], min(TIGHT), 1000.0, True),
        ([("payload", None)], [("inertial_error", 3)], min(TIGHT), 1000.0, False),
    ],
)
def test_a_body_is_news_beside_exact_numbers_only(
    names: list[Key], known: list[Key], tight: float, evidence: float, may: bool
) -> None:
    assert view(names, tight, evidence).may_name(view([], 1.0, 0.0), frozenset(known)) == may


def trial(x: float, error: float, left: float) -> Trial:
    """A candidate that is likely from 1 on: its coefficient, known to an error, and the mean square left."""
    candidate = single(
        "coulomb_friction", 0, [np.ones(10)], (1,), lambda x: {}, 1, likely=lambda x: bool(x[0] >= 1)
    )
    fit = Fit(np.array([x]), np.array([[error**2]]), np.zeros(0), np.full((10, 1), left), 0.0)
    return Trial(candidate, np.ones((10, 1, 1)), fit, 100.0, 5.0, 5.0, np.full(10, 10.0))


@pytest.mark.parametrize(
    ("x", "error", "left", "rough", "is_likely"),
    [
        (1.1, 0.0, 9.0, False, True),
        (0.8, 0.2, 9.0, False, False),
        (0.8, 0.2, 1.0, False, True),  # it alone explains the log
        (0.8, 0.2, 1.0, True, False),
    ],
)
def test_what_is_not_likely_needs_a_log_that_says_so(
    x: float, error: float, left: float, rough: bool, is_likely: bool
) -> None:
    now = problem(np.ones((100, 1)), np.ones((100, 1, 1)), np.ones(1), 1.0)
    one = trial(x, error, left)
    assert _is_likely(now, one, [one], rough=rough) == is_likely
    if is_likely and not rough and x < 1:  # but not beside another that explains as much
        assert not _is_likely(now, one, [one, trial(2.0, 0.1, left)], rough=False)
