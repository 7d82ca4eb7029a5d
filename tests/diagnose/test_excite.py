"""``excite``: separations against angles worked out anew, and motions inside the limits."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.diagnose.excite import EffectAt, design, independence, separation
from robodyn.errors import InputError
from robodyn.robot import load
from robodyn.robot.model import Robot
from robodyn.robot.reader import read_text
from robodyn.simulate.limits import outside, with_limits
from robodyn.simulate.trajectories.fourier import fourier
from robodyn.simulate.trajectories.trajectory import Trajectory

Floats = NDArray[np.float64]

MASS, ARM, INERTIA, G = 2.0, 0.5, 0.1, 9.81


def pendulum(confidence: str) -> Robot:
    return read_text(f"""\
name: pendulum
gravity: [0, -{G}, 0]
links:
  - joint: revolute
    mass: {MASS}
    com: [{ARM}, 0, 0]
    inertia: {{zz: {INERTIA}}}
    motor_inertia: 0.05
    confidence: {confidence}
    limits: {{position: [-2, 2], velocity: 3, acceleration: 12}}
""")


def motion_of(robot: Robot, seed: int = 4) -> Trajectory:
    return fourier(with_limits(robot)[0], 0.2, 5, seed, period=0.02)


def seen(motion: Trajectory, confidence: float) -> Floats:
    """The inverse square root [K, K] of the covariance, whole: noise, and the pendulum's own two numbers."""
    q, qdd = motion.q[:, 0], motion.qdd[:, 0]
    about = INERTIA + MASS * ARM**2
    tau = (about + 0.05) * qdd + MASS * ARM * G * np.cos(q)
    own = confidence * np.stack([about * qdd, MASS * ARM * G * np.cos(q)], axis=1)
    own = own / (0.01 * np.sqrt(np.mean(tau**2)))
    values, vectors = np.linalg.eigh(np.eye(len(q)) + own @ own.T)
    return np.asarray(vectors / np.sqrt(values) @ vectors.T)


@pytest.mark.parametrize("confidence", [1e-9, 0.1])
@pytest.mark.parametrize("other", ["viscous_friction", "spring"])
def test_the_separation_is_the_angle_between_whitened_columns(confidence: float, other: str) -> None:
    from scipy.linalg import subspace_angles

    robot = pendulum(str(confidence))
    motion = motion_of(robot)
    q, qd = motion.q[:, 0], motion.qd[:, 0]
    columns = {"viscous_friction": [qd], "spring": [q, np.ones_like(q)]}[other]
    W = seen(motion, confidence)
    angle = subspace_angles(W @ np.sign(qd)[:, None], W @ np.stack(columns, axis=1)).min()
    found, pair = separation(robot, motion, [("coulomb_friction", 1), (other, 1)])
    assert found == pytest.approx(np.sin(angle), rel=1e-6)
    assert pair == f"coulomb_friction at joint 1 and {other} at joint 1"


def test_an_effect_inside_another_is_told_by_what_the_other_has_beyond() -> None:
    """A spring is a bias and a line: told from the bias by the line."""
    robot = pendulum("1e-9")
    motion = motion_of(robot)
    line = motion.q[:, 0] - motion.q[:, 0].mean()
    beyond = np.sqrt(1 - line.sum() ** 2 / (line @ line) / len(line))
    pair: list[EffectAt] = [("torque_bias", 1), ("spring", 1)]
    assert separation(robot, motion, pair)[0] == pytest.approx(beyond, rel=1e-6)
    assert separation(robot, motion, pair[::-1])[0] == pytest.approx(beyond, rel=1e-6)


def test_the_design_is_the_best_that_was_tried_and_inside_the_limits() -> None:
    robot = pendulum("0.1")
    tell: list[EffectAt] = [("coulomb_friction", 1), ("viscous_friction", 1)]
    found = design(robot, tell, duration=6.0, seed=2, tries=5, period=0.01)
    assert found.trajectory.duration == pytest.approx(6.0)
    assert outside(robot, found.trajectory) == []
    # The separation is of the motion that is given, thinned or not.
    again = separation(robot, found.trajectory, tell)[0]
    assert found.separation == pytest.approx(again)
    assert found.typical < found.separation
    first = design(robot, tell, duration=6.0, seed=2, tries=1, period=0.01)
    assert first.separation == first.typical <= found.separation
    assert found.experiments["viscous_friction"] == "three speed levels or more, in both directions"


def test_without_effects_the_whole_library_is_to_be_told_apart() -> None:
    robot = pendulum("0.1")
    found = design(robot, duration=5.0, tries=4, period=0.02)
    assert 0 < found.typical <= found.separation == independence(robot, found.trajectory) < 1
    assert found.pair is None


@pytest.mark.thorough
def test_every_joint_counts_where_none_is_named() -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    motion = motion_of(robot)
    of_all = separation(robot, motion, [("coulomb_friction", None), ("viscous_friction", None)])
    each = [
        separation(robot, motion, [("coulomb_friction", j), ("viscous_friction", j)])[0] for j in (1, 2, 3)
    ]
    assert of_all[0] == pytest.approx(min(each))
    # A body at the tip is the last link's own: no motion tells them apart.
    same, _ = separation(robot, motion, [("payload", None), ("inertial_error", 3)])
    assert same < 1e-3
    assert separation(robot, motion, [("payload", None), ("base_tilt", None)])[0] > 0.3


@pytest.mark.parametrize(
    ("tell", "words"),
    [
        ([("coulomb_friction", 1)], "one effect alone"),
        ([("coulomb", 1), ("spring", 1)], "unknown effect"),
        ([("coulomb_friction", 2), ("spring", 1)], "no such joint"),
        ([("payload", 1), ("spring", 1)], "effect of the whole robot"),
        ([("external_contact", None), ("spring", 1)], "no columns"),
    ],
)
def test_effects_that_cannot_be_separated_are_refused(tell: list[EffectAt], words: str) -> None:
    with pytest.raises(InputError, match=words):
        design(pendulum("0.1"), tell, tries=1, period=0.02)


def test_run_time_parameters_are_refused() -> None:
    robot = read_text("name: r\nlinks:\n  - {joint: revolute, mass: m}\n")
    with pytest.raises(InputError, match="run-time parameters"):
        design(robot)
