"""Numbers of an arm from logs of a known one."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from benchmarks.blind_arms.arms import bare, perturbed, rubbing

import robodyn
from identify.exact import log_of, motion
from peers.numbers import number
from robodyn.identify.consistent import pseudo_inertia
from robodyn.identify.regressor import Links
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.robot import load
from robodyn.robot.model import Robot
from robodyn.robot.reader import read_text


def arm(name: str) -> Robot:
    return load(name, warn=lambda _: None)


@pytest.mark.parametrize("name", ["puma560", "stanford", "panda"])
def test_torques_are_columns_times_parameters(name: str) -> None:
    """The columns against Newton and Euler; both ways of evaluating them; a prismatic joint among them."""
    model = Model(arm(name))
    _, q, qd, qdd = motion(model.n, seconds=0.5)
    links = Links.along(model.arm, q, qd, qdd)
    phi = model.standard_parameters()
    rigid = model.evaluate(q, qd, qdd).rigid
    assert np.allclose(phi.ravel() @ links.regressor(), rigid.T, rtol=0, atol=1e-11)
    assert np.allclose(links.torques(phi[None])[0], rigid.T, rtol=0, atol=1e-11)


@pytest.mark.parametrize("name", ["ur10", "puma560", "stanford"])
@pytest.mark.thorough
def test_an_arm_is_identified(name: str) -> None:
    """Inertials 30 % wrong and friction unknown; held out, hardly more than the noise is left."""
    truth = rubbing(arm(name)) if name != "ur10" else _ur10()
    guess = perturbed(_without_friction(truth), 0.3, seed=5)
    outcome = robodyn.identify(guess, [log_of(truth, noise=0.01)])
    residual = outcome.residual
    assert np.all(residual.validate_after < 1.2 * residual.noise_floor)
    assert np.all(residual.validate_before > 3 * residual.noise_floor)
    for j, link in enumerate(truth.links, 1):
        viscous = outcome.parameters[f"joint{j}.viscous_friction.coefficient"]
        assert viscous.stderr is not None
        assert abs(viscous.value - number(link.joint.viscous)) < max(5 * viscous.stderr, 1e-3)


def test_the_description_that_is_written_is_possible_and_reads_back() -> None:
    """Strict reading has nothing to say of it; comments stay."""
    truth = _ur10()
    text = "# of ours\n" + robodyn.robot.to_yaml(perturbed(_without_friction(truth), 0.3, seed=2))
    guess = read_text(text, warn=lambda _: None)
    outcome = robodyn.identify(guess, [log_of(truth, noise=0.01)], text=text)
    warnings: list[str] = []
    assert read_text(outcome.model_text, warn=lambda line: warnings.append(str(line))) == outcome.model
    assert not warnings
    assert outcome.model_text.startswith("# of ours\n")
    for phi in Model(outcome.model).standard_parameters():
        assert np.linalg.eigvalsh(pseudo_inertia(phi)).min() > 0


def test_what_logs_do_not_show_stays_and_is_listed() -> None:
    """The first link's mass enters no torque."""
    truth = _ur10()
    outcome = robodyn.identify(truth, [log_of(truth, noise=0.01)])
    assert "link1.mass" in outcome.not_identifiable
    assert outcome.parameters["link1.mass"].stderr is None
    assert outcome.model.links[0].mass == truth.links[0].mass
    assert "joint1.viscous_friction.coefficient" not in outcome.not_identifiable


def test_of_a_joint_that_stands_still_nothing_is_said() -> None:
    """Noise of its encoder must not pass for a motion."""
    truth = rubbing(bare("puma560_3dof"))
    log = log_of(truth, seconds=6.0)
    q = log.q.copy()
    q[:, 2] = 0.3 + 1e-5 * np.random.default_rng(2).standard_normal(len(q))
    t, moved, qd, qdd = motion(3, seconds=6.0)
    moved[:, 2], qd[:, 2], qdd[:, 2] = 0.3, 0.0, 0.0
    tau = Model(truth).torque(moved, qd, qdd)
    tau += 0.01 * tau.std(axis=0) * np.random.default_rng(1).standard_normal(tau.shape)
    outcome = robodyn.identify(_without_friction(truth), [Log(t, q, None, None, tau)])
    own = {name for name in outcome.not_identifiable if name.startswith("joint")}
    assert {name.partition(".")[0] for name in own} == {"joint3"}
    assert len(own) == 3
    assert any("joint 3 does not move" in line for line in outcome.words)
    assert outcome.model.links[2].joint.coulomb == 0


def test_torque_behind_the_gear_may_show_friction() -> None:
    truth = replace(_ur10(), torque_side="motor")
    links = tuple(replace(x, joint=replace(x.joint, motor_inertia=Fraction(0))) for x in truth.links)
    truth = replace(truth, links=links)
    guess = replace(_without_friction(truth), torque_side="link")
    outcome = robodyn.identify(guess, [log_of(truth, noise=0.01)])
    assert np.all(outcome.residual.validate_after < 1.2 * outcome.residual.noise_floor)
    for old, new in zip(truth.links, outcome.model.links, strict=True):
        assert number(new.joint.coulomb) == pytest.approx(number(old.joint.coulomb), rel=0.05)


def _ur10() -> Robot:
    """With rotors and friction, which its file leaves out."""
    return rubbing(bare("ur10"))


def _without_friction(robot: Robot) -> Robot:
    none = Fraction(0)
    links = tuple(
        replace(link, joint=replace(link.joint, viscous=none, coulomb=none, motor_inertia=none))
        for link in robot.links
    )
    return replace(robot, links=links)
