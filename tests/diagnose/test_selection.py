"""What is hidden is named, nothing is named where nothing is or where the log does not show it."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from benchmarks.blind_arms.cases import Case
from benchmarks.blind_arms.logs import effect, hidden_log
from benchmarks.gap.blind.trials import trials

from diagnose.plain_arms import PENDULUM, SLIDE, TURNTABLE, WEIGHTLESS, Floats, Lacks, logged, read, rigid
from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.blind.hide import Setup, hide
from robodyn.diagnose.result import Diagnosis, Estimate
from robodyn.diagnose.run import diagnose
from robodyn.formats.loading import robot_of
from robodyn.logs.log import Log, read_log
from robodyn.robot import load
from robodyn.robot.model import EffectEntry, Robot

ROOT = Path(__file__).parents[2]
TX40 = ROOT / "examples" / "tx40"
ARMS = {text.split()[1]: text for text in (TURNTABLE, SLIDE, PENDULUM, WEIGHTLESS)}


def claims(found: Diagnosis) -> set[tuple[str, int | None]]:
    return {(f.effect, f.joint) for f in found.findings if f.confidence >= 0.5}


def holds(estimate: Estimate, true: float) -> bool:
    """Whether the interval is closed and holds it."""
    low, high = estimate.interval or (None, None)
    return low is not None and high is not None and low <= true <= high


# --- arms of a line of numpy ------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ARMS)
def test_nothing_is_named_where_nothing_is_hidden(name: str) -> None:
    robot = read(ARMS[name])
    found = diagnose(robot, [logged(robot)])
    assert found.verdict == "consistent"
    assert found.findings == ()
    assert found.model == robot


@pytest.mark.parametrize("name", ARMS)
def test_friction_is_named_with_its_size(name: str) -> None:
    robot = read(ARMS[name])

    def rubs(q: Floats, qd: Floats, qdd: Floats) -> Floats:
        return np.array([0.6, 0.0])[: robot.n] * np.sign(qd) + np.array([0.0, 0.8])[: robot.n] * qd

    found = diagnose(robot, [logged(robot, rubs)], logged(robot, rubs, seed=2))
    sizes = {("coulomb_friction", 1): 0.6, ("viscous_friction", 2): 0.8}
    sizes = {key: size for key, size in sizes.items() if key[1] <= robot.n}
    assert claims(found) == set(sizes)
    assert found.verdict == "missing_effect"
    for one in found.findings:
        (estimate,) = one.parameters.values()
        assert float(estimate.value) == pytest.approx(sizes[one.effect, one.joint or 0], rel=0.05)
    assert diagnose(found.model, [logged(robot, rubs, seed=3)]).verdict == "consistent"


def late(log: Log, samples: int) -> Log:
    """The log, its torques read so many samples late."""
    return Log(log.t[samples:], log.q[samples:], None, None, log.tau[:-samples])


def test_torques_that_are_read_late_are_no_error_of_reading_within_a_sample() -> None:
    robot = read(PENDULUM)
    found = diagnose(robot, [late(logged(robot), 2)])
    assert claims(found) == {("time_delay", None)}
    (delay,) = (f.parameters["delay"] for f in found.findings)
    assert float(delay.value) == pytest.approx(2 / 250, rel=0.02)
    assert delay.stderr == pytest.approx(1 / 250 / np.sqrt(12), rel=0.05)  # when within a period nobody knows


def test_torques_that_are_all_too_large_are_one_name_and_not_one_a_number() -> None:
    hidden = hidden_log("puma560_3dof", [], seed=4, duration=6.0, friction=True, validation=False)
    diagnosis = diagnose(hidden.given, [replace(hidden.train, tau=1.25 * hidden.train.tau)])
    assert claims(diagnosis) == {("torque_gain", None)}
    (gain,) = (f.parameters["gain"] for f in diagnosis.findings)
    assert float(gain.value) == pytest.approx(0.25, rel=0.02)


def test_the_torque_scale_of_an_arm_of_one_joint_is_no_rival_of_itself() -> None:
    robot = read(PENDULUM.replace("zz: 0.5}", "zz: 0.5}, friction: {coulomb: 2, viscous: 1}"))
    log = logged(robot, lambda q, qd, qdd: 2 * np.sign(qd) + qd, noise=0.02)
    (finding,) = diagnose(robot, [replace(log, tau=1.25 * log.tau)]).findings
    assert (finding.effect, finding.joint) == ("torque_gain", 1)
    assert finding.confidence > 0.9


def test_one_cause_is_likelier_than_two_that_are_the_same_together() -> None:
    """An offset comes in first, then dry friction beside it: together they are friction of two levels."""
    (trial,) = (
        one for one in trials("near", ("random",), range(47001, 47002)) if one.effect == "asymmetric_friction"
    )
    hidden = trial.make()
    diagnosis = diagnose(hidden.given, [hidden.train])
    assert claims(diagnosis) == {("asymmetric_friction", 2), ("viscous_friction", 2)}


def stopping(robot: Robot, level: float, hold: float, seed: int = 1) -> Log:
    """A log of moves between poses with rests: friction of the ``level`` where it moves, at rest the share
    ``hold`` of it on the side of the last move."""
    rng, step, pause = np.random.default_rng(seed), 200, 150
    s = np.linspace(0, 1, step, endpoint=False)
    poses = rng.uniform(-1.2, 1.2, 25)
    T, parts = step / 250, []
    for a, b in pairwise(poses):
        way = b - a
        moves = [
            a + way * (10 * s**3 - 15 * s**4 + 6 * s**5),
            way / T * (30 * s**2 - 60 * s**3 + 30 * s**4),
            way / T**2 * (60 * s - 180 * s**2 + 120 * s**3),
            np.full(step, level * np.sign(way)),
        ]
        rests = [b, 0.0, 0.0, hold * level * np.sign(way)]
        parts += [np.stack(moves), np.tile(np.array(rests)[:, None], pause)]
    q, _, qdd, friction = (x[:, None] for x in np.concatenate(parts, axis=1))
    t = np.arange(len(q)) / 250
    tau = rigid(robot.name, q, qdd) + friction + 0.05 * rng.standard_normal(q.shape)
    return Log(t, q + 1e-6 * rng.standard_normal(q.shape), None, None, tau)


@pytest.mark.parametrize("hold", [0.0, 1.0, -0.9])
def test_what_holds_a_joint_at_rest_makes_no_other_law_of_its_friction(hold: float) -> None:
    """A rest says that torque lies within the level: no less friction, nor one that comes up by and by."""
    robot = read(PENDULUM)
    found = diagnose(robot, [stopping(robot, 0.8, hold)])
    assert claims(found) == {("coulomb_friction", 1)}
    (one,) = found.findings
    assert float(one.parameters["level"].value) == pytest.approx(0.8, rel=0.01)


def test_wrong_numbers_of_an_arm_that_stops_are_no_friction() -> None:
    robot = read(PENDULUM.replace("com: [0.4", "com: [0.43"))
    found = diagnose(robot, [stopping(read(PENDULUM), 0.0, 0.0)])
    assert {effect for effect, _ in claims(found)} <= {"inertial_error", "payload"}
    assert claims(found)


def test_a_wrong_link_is_a_suspicion_where_wrong_numbers_of_all_links_explain_as_much(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    robot, log = read(PENDULUM.replace("com: [0.4", "com: [0.43")), logged(read(PENDULUM))
    (one,) = diagnose(robot, [log]).findings
    monkeypatch.setattr("robodyn.diagnose.select.search.throughout", lambda _, trial: trial.gains)
    (other,) = diagnose(robot, [log]).findings
    assert one.effect == other.effect == "inertial_error"
    assert one.confidence > 0.5 > other.confidence > 0.4 * one.confidence
    assert "all links" in other.where


def test_an_encoder_that_is_far_off_is_no_wrong_number() -> None:
    """By how much a wrong zero changes torques depends on its size: at zero it looks like a moved centre."""
    robot = read(PENDULUM.replace("mass: 3.0", "mass: 3.0, confidence: 0.001"))
    log = logged(robot)
    found = diagnose(robot, [Log(log.t, log.q + 0.15, None, None, log.tau)])
    assert claims(found) == {("encoder_offset", 1)}


def test_a_joint_that_sticks_does_not_take_back_a_name_in_another_log() -> None:
    """At rest friction is a set: what a joint that sticks leaves says nothing against an offset of torque."""
    robot = read(PENDULUM.replace("revolute, mass", "revolute, friction: {coulomb: 2}, mass"))

    def sticking(level: float) -> Lacks:
        return lambda q, qd, qdd: 0.2 + 2 * np.where(np.abs(qd) < 0.3, level, np.sign(qd))

    found = diagnose(robot, [logged(robot, sticking(0.0))], logged(robot, sticking(-0.9), seed=2))
    assert claims(found) == {("torque_bias", 1)}


@pytest.mark.parametrize(
    ("told", "changed"),
    [("mass: 2, ", "mass: 4, "), ("mass: 2, ", "mass: 2, com: [0.01, 0, 0], ")],
    ids=["on the axis", "hardly beside it"],
)
def test_a_mass_that_the_motion_does_not_show_is_no_claim(told: str, changed: str) -> None:
    assert told in TURNTABLE
    wrong = read(TURNTABLE.replace(told, changed))
    found = diagnose(wrong, [logged(read(TURNTABLE))])
    assert claims(found) == set()
    assert found.verdict == "consistent"


def test_where_most_of_the_torque_is_not_explained_nothing_is_claimed() -> None:
    robot = read(TURNTABLE)
    rng = np.random.default_rng(5)

    def storm(q: Floats, qd: Floats, qdd: Floats) -> Floats:
        """Torque that has nothing to do with the motion, four times what the arm needs; and friction."""
        white = rng.standard_normal(len(q) + 199)
        slow = np.convolve(white, np.hanning(200), mode="valid")[:, None]
        return 4 * slow / slow.std() * (0.5 * qdd).std() + 0.3 * np.sign(qd)

    found = diagnose(robot, [logged(robot, storm)])
    assert claims(found) == set()


# --- hidden by simulations --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "seed", [31, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(32, 39))]
)
def test_a_level_of_dry_friction_is_no_other_law(seed: int) -> None:
    robot = robot_of(ROOT / "robots" / "puma560_3dof_d12.yaml")
    blind = hide(robot, [Amendment("coulomb_friction", 2, {})], setup=Setup(seed=seed))
    found = diagnose(blind.model, [blind.train], blind.validate)
    assert claims(found) == {("coulomb_friction", 2)}
    (one,) = found.findings
    level, true = one.parameters["level"], float(blind.effects[0].parameters["level"])
    # The torques of such a log are half a sample early: without a word of that, no level is known better.
    assert float(level.value) == pytest.approx(true, rel=0.02)
    if seed == 31:
        assert holds(level, true)


@pytest.mark.parametrize(
    ("arm", "name", "joint", "seed", "ratio"),
    [
        ("puma560_3dof", "viscous_friction", 2, 1, 3.7),
        pytest.param("puma560_3dof", "stribeck_friction", 1, 1, 4.8, marks=pytest.mark.slow),
        pytest.param("puma560_3dof", "base_tilt", None, 1, 7.6, marks=pytest.mark.slow),
        pytest.param("puma560_3dof", "torque_saturation", 2, 1, 5.1, marks=pytest.mark.slow),
    ],
)
@pytest.mark.thorough
def test_what_is_hidden_is_named(arm: str, name: str, joint: int | None, seed: int, ratio: float) -> None:
    made = Case(arm, ((name, joint),), seed, ratio).make()
    assert claims(diagnose(made.given, [made.train], made.validate)) == {(name, joint)}


@pytest.mark.parametrize(
    "hidden",
    [
        [effect("power_law_friction", 1, level=0.5, exponent=0.6)],
        [effect("viscous_friction", 1, coefficient=0.4), effect("coulomb_friction", 1, level=0.1)],
    ],
    ids=["a power", "a line"],
)
@pytest.mark.thorough
def test_one_law_of_friction_stands_in_the_place_of_two_where_the_log_says_so(
    hidden: list[EffectEntry],
) -> None:
    logs = hidden_log(
        "puma560_3dof", hidden, seed=5, duration=6.0, noise_share=0.015, validation=False, friction=False
    )
    assert claims(diagnose(logs.given, [logs.train])) == {(each.effect, each.joint) for each in hidden}


@pytest.mark.parametrize(
    ("hidden", "ratio"),
    [
        ((("time_delay", None), ("coulomb_friction", 2)), 5.783),
        ((("viscous_friction", 1), ("payload", None)), 4.787),
        ((("spring", 1), ("torque_ripple", 2)), 4.284),
    ],
    ids=str,
)
@pytest.mark.slow
def test_two_effects_are_both_named(hidden: tuple[tuple[str, int | None], ...], ratio: float) -> None:
    made = Case("puma560_3dof", hidden, 1, ratio).make()
    found = diagnose(made.given, [made.train], made.validate)
    assert claims(found) == set(hidden)
    assert np.all(found.gap.validate_after < 1.3 * made.truth.noise)


@pytest.mark.parametrize(
    "outside", ["random_offset", pytest.param("acceleration_friction", marks=pytest.mark.slow)]
)
@pytest.mark.thorough
def test_what_is_in_no_catalogue_is_not_named(outside: str) -> None:
    made = Case("puma560_3dof", ((outside, 1),), 1, 6.0).make()
    found = diagnose(made.given, [made.train], made.validate)
    assert claims(found) == set()


@pytest.mark.thorough
def test_friction_and_bias_are_rivals_where_a_joint_goes_one_way() -> None:
    made = Case("puma560_3dof", (("torque_bias", 2),), 1, 4.806, motion="one_way").make()
    found = diagnose(made.given, [made.train], made.validate)
    (first,) = found.findings
    assert first.joint == 2
    assert {first.effect, *first.confounded_with} >= {"coulomb_friction", "torque_bias"}
    # A level of friction, and one that grows with the load, say the same there: nobody can be sure of one.
    assert len(first.confounded_with) >= 2
    assert first.confidence < 0.7
    assert first.experiment
    assert "one direction" in str(found.record)


@pytest.mark.slow
def test_pieces_of_a_log_count() -> None:
    made = Case("puma560_3dof", (("viscous_friction", 2),), 1, 5.0).make()
    log = made.train
    kept = (log.t // 0.45).astype(int) % 3 != 2
    pieces = Log(log.t[kept], log.q[kept], None, None, log.tau[kept])
    assert claims(diagnose(made.given, [pieces], made.validate)) == {("viscous_friction", 2)}


@pytest.mark.slow
def test_noise_of_the_encoders_is_no_elastic_joint() -> None:
    made = Case("puma560_3dof", (("viscous_friction", 2),), 2, 3.485, motion="narrow").make()
    assert claims(diagnose(made.given, [made.train], made.validate)) == {("viscous_friction", 2)}


@pytest.mark.slow
def test_a_joint_that_sets_out_is_not_touched() -> None:
    made = Case("puma560_3dof", (("coulomb_friction", 3),), 1, 6.0, motion="one_way").make()
    found = diagnose(made.given, [made.train], made.validate)
    assert "external_contact" not in {f.effect for f in found.findings}


@pytest.mark.slow
def test_errors_within_the_stated_confidence_are_no_finding() -> None:
    made = Case("stanford", (), 23, 1.0, friction=True, inertia_error=0.03).make()
    assert diagnose(made.given, [made.train]).findings == ()


@pytest.mark.slow
def test_a_real_arm_from_rigid_to_coupled() -> None:
    """Staubli TX40, from its CAD model: what the figaroh-plus repository identified."""
    robot, log = load(str(TX40 / "tx40.yaml")), read_log(TX40 / "tx40.csv", 6)
    found = diagnose(robot, [log])
    named = claims(found)
    assert ("motor_coupling", 6) in named
    assert {effect for effect, _ in named} >= {"viscous_friction", "coulomb_friction"}
    size = np.sqrt(np.mean(log.tau**2, axis=0))
    assert np.mean(found.gap.train_after / size) < 0.15
