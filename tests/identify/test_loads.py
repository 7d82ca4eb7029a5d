"""Torque constants that are wrong, and what an arm carried."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from benchmarks.blind_arms.arms import bare, perturbed, rubbing
from benchmarks.blind_arms.logs import effect

import robodyn
from identify.exact import log_of
from peers.numbers import number
from robodyn.identify.fit import Load, Options
from robodyn.identify.run import Identification
from robodyn.logs.log import Log
from robodyn.robot import to_yaml
from robodyn.robot.model import EffectEntry, Robot
from robodyn.robot.reader import read_text

GAINS = (0.25, -0.25, 0.25)
PAYLOAD = effect("payload", None, mass=3.0, com=(0.05, 0.02, 0.1))


@pytest.fixture(scope="module")
def arm() -> Robot:
    """Three joints with friction; its description will know it to 3 %."""
    return rubbing(bare("puma560_3dof"))


def logged(arm: Robot, *, loaded: bool, seed: int) -> Log:
    """A log of drives whose torque constants are 25 % off."""
    true = replace(arm, effects=(PAYLOAD,) if loaded else ())
    log = log_of(true, noise=0.01, seed=seed, seconds=8.0)
    return Log(log.t, log.q, None, None, log.tau * (1 + np.array(GAINS)))


def outcome_of(arm: Robot, mass: float | None) -> Identification:
    logs = [logged(arm, loaded=False, seed=1), logged(arm, loaded=True, seed=2)]
    options = Options(gains=True, loads=(Load((1,), mass),))
    return robodyn.identify(perturbed(arm, 0.03, 4), logs, options=options)


def test_a_load_is_weighed_although_torque_constants_are_wrong(arm: Robot) -> None:
    outcome = outcome_of(arm, None)
    mass = outcome.parameters["load1.mass"]
    assert mass.stderr is not None
    assert mass.value == pytest.approx(3.0, rel=0.1)
    assert mass.stderr < 0.1 * mass.value
    assert np.all(outcome.residual.validate_after < 1.3 * outcome.residual.noise_floor)


def test_a_known_load_tells_gains_from_masses(arm: Robot) -> None:
    outcome = outcome_of(arm, 3.0)
    for j, gain in enumerate(GAINS, 1):
        one = outcome.parameters[f"joint{j}.torque_gain.gain"]
        assert one.stderr is not None
        assert one.value == pytest.approx(gain, abs=0.02)
    entries = [e for e in outcome.model.effects if e.effect == "torque_gain"]
    assert [e.joint for e in entries] == [1, 2, 3]
    assert not [e for e in outcome.model.effects if e.effect == "payload"]


def test_what_a_description_knows_beside_links_stays(arm: Robot) -> None:
    """A spring, a payload and a gain of the description are taken off the torque and not fitted again."""
    spring, gain = effect("spring", 2, stiffness=30.0, rest=0.2), effect("torque_gain", 3, gain=0.1)
    known = (spring, gain, PAYLOAD)
    true = read_text(to_yaml(replace(arm, effects=known)), warn=lambda _: None)
    log = log_of(replace(true, effects=(spring, PAYLOAD)), noise=0.01)
    log = Log(log.t, log.q, None, None, log.tau * np.array([1, 1, 1.1]))
    outcome = robodyn.identify(true, [log])
    assert outcome.model.effects == true.effects
    assert np.all(outcome.residual.train_before < 1.1 * outcome.residual.noise_floor)
    for old, new in zip(true.links, outcome.model.links, strict=True):
        assert isinstance(new.mass, Fraction)
        assert isinstance(old.mass, Fraction)
        assert float(abs(new.mass - old.mass)) <= 0.05 * float(old.mass)


def test_a_contact_that_is_known_does_not_count(arm: Robot) -> None:
    """A push of two seconds, as the description notes it with the log's hash."""
    log = log_of(arm, noise=0.01, seconds=8.0)
    tau = log.tau.copy()
    pushed = (log.t > 3) & (log.t < 5)
    tau[pushed] += [40.0, 60.0, 25.0]
    push = EffectEntry(
        "external_contact",
        None,
        (("start", Fraction(3)), ("end", Fraction(5)), ("link", 3), ("force_x", Fraction(0)),
         ("force_y", Fraction(0)), ("force_z", Fraction(0)), ("log", "abc")),
    )  # fmt: skip
    log = Log(log.t, log.q, None, None, tau)
    known = robodyn.identify(replace(arm, effects=(push,)), [log], hashes=["abc"])
    unknown = robodyn.identify(replace(arm, effects=(push,)), [log], hashes=["other"])

    def worst(outcome: Identification) -> float:
        return max(
            abs(outcome.parameters[f"joint{j}.coulomb_friction.level"].value - number(link.joint.coulomb))
            for j, link in enumerate(arm.links, 1)
        )

    assert worst(known) < 0.1
    assert worst(unknown) > 3 * worst(known)
