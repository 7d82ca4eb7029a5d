"""``hide``: what the logs show, how large it is, what stays secret, and the score."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.diagnose.blind.drawn import draw, form, places, settings, usual
from robodyn.diagnose.blind.hide import Blind, Setup, hide, lacking, measured, rms
from robodyn.diagnose.blind.seal import open_seal, score, seal
from robodyn.diagnose.run import diagnose
from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.robot import load
from robodyn.robot.model import Robot
from robodyn.robot.reader import read_text
from robodyn.simulate.limits import with_limits
from robodyn.simulate.trajectories.fourier import fourier

Floats = NDArray[np.float64]

MASS, ARM, INERTIA, G = 2.0, 0.5, 0.1, 9.81
PENDULUM = f"""\
name: pendulum
gravity: [0, -{G}, 0]
links:
  - joint: revolute
    mass: {MASS}
    com: [{ARM}, 0, 0]
    inertia: {{zz: {INERTIA}}}
    motor_inertia: 0.05
    limits: {{position: [-2, 2], velocity: 3, acceleration: 12}}
"""


@pytest.fixture(autouse=True)
def cache(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path_factory.getbasetemp() / "robodyn-cache"))


@pytest.fixture(scope="module")
def pendulum() -> Robot:
    return read_text(PENDULUM)


@pytest.fixture(scope="module")
def blind(pendulum: Robot) -> Blind:
    """Coulomb friction, its size left to the draw."""
    return hide(pendulum, [Amendment("coulomb_friction", 1, {})], setup=Setup(seed=3), text=PENDULUM)


def rates(log: Log) -> tuple[Floats, Floats, Floats]:
    """Of a polynomial of degree 4 over 41 samples, at its middle."""
    x = np.arange(-20, 21) * (log.t[1] - log.t[0])
    fit = np.linalg.pinv(np.vander(x, 5, increasing=True))
    q = [np.convolve(log.q[:, 0], fit[k][::-1], "valid") for k in range(3)]
    return q[0], q[1], 2 * q[2]


def closed_form(q: Floats, qdd: Floats) -> Floats:
    return np.asarray((INERTIA + MASS * ARM**2 + 0.05) * qdd + MASS * G * ARM * np.cos(q))


# --- the logs ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("which", ["train", "validate"])
def test_a_log_is_the_models_torque_the_hidden_effect_and_noise(blind: Blind, which: str) -> None:
    log: Log = getattr(blind, which)
    assert log.qd is None
    assert log.qdd is None
    q, qd, qdd = rates(log)
    rest = log.tau[20:-20, 0] - closed_form(q, qdd)
    moving = np.abs(qd) > 0.1
    level = float(np.mean((rest * np.sign(qd))[moving]))
    (one,) = blind.effects
    assert level == pytest.approx(float(one.parameters["level"]), rel=0.01)
    left = (rest - level * np.sign(qd))[moving]
    assert left.std() == pytest.approx(blind.noise[0], rel=0.1)


def test_it_shows_as_much_as_is_wanted(blind: Blind) -> None:
    q, _, qdd = rates(blind.train)
    noise = 0.015 * np.sqrt(np.mean(closed_form(q, qdd) ** 2))
    assert blind.noise[0] == pytest.approx(noise, rel=0.02)
    assert float(blind.effects[0].parameters["level"]) == pytest.approx(4.0 * noise, rel=0.06)
    assert blind.ratio == pytest.approx(4.0, rel=0.06)


def test_encoders_have_steps(blind: Blind) -> None:
    steps = blind.train.q / (2 * np.pi / 2**20)
    assert np.abs(steps - np.rint(steps)).max() < 1e-6


def test_what_is_given_is_kept_and_the_answer_is_what_a_diagnosis_would_add(pendulum: Robot) -> None:
    friction = read_text(PENDULUM + "    friction: {coulomb: 0.2}\n")
    wanted = Amendment("stribeck_friction", 1, {"level": 0.3, "static": 0.9, "velocity": 0.11})
    made = hide(friction, [wanted], setup=Setup(duration=2.0, rate=500.0))
    assert made.effects == (wanted,)
    assert made.true == amended(friction, [wanted])
    assert made.model == friction
    assert made.train.samples == 1001


def test_the_same_seed_gives_the_same_files_and_another_another_path(pendulum: Robot, blind: Blind) -> None:
    again = hide(pendulum, [Amendment("coulomb_friction", 1, {})], setup=Setup(seed=3), text=PENDULUM)
    assert again.files() == blind.files()
    setup = replace(blind.setup, seed=4, duration=2.0)
    other = hide(pendulum, blind.effects, setup=setup, text=PENDULUM)
    assert np.abs(other.train.q[:50] - blind.train.q[:50]).max() > 1e-4
    assert np.abs(blind.validate.q - blind.train.q).max() > 0.1


def test_the_files_do_not_tell(blind: Blind) -> None:
    files = blind.files()
    assert list(files) == [
        "given.yaml", "train.csv", "train.csv.json", "validate.csv", "validate.csv.json", "answer.sealed",
    ]  # fmt: skip
    assert files["given.yaml"] == PENDULUM
    for name in ("train.csv.json", "validate.csv.json"):
        told = json.loads(files[name])
        assert told["effects"] == []
        assert told["seed"] is None
        assert not {"seed", "ratio"} & set(told["options"]) | {"seed"} & set(
            told["options"]["drive"]["trajectory"]
        )
    for name, text in files.items():
        assert "coulomb" not in str(text), name
    answer = open_seal(str(files["answer.sealed"]))
    assert answer["effects"][0]["effect"] == "coulomb_friction"
    assert set(answer["logs"]) == {"train.csv", "validate.csv"}


@pytest.mark.filterwarnings("ignore::RuntimeWarning")  # columns that are 0, of numbers a pendulum lacks
def test_a_diagnosis_finds_it_and_the_score_says_so(pendulum: Robot, blind: Blind) -> None:
    found = diagnose(pendulum, [blind.train], blind.validate, text=PENDULUM)
    said = score(blind.answer(), json.loads(json.dumps(found.to_dict())))
    assert (said.result, said.missed) == ("right", 0)
    assert said.closed is not None
    assert said.closed > 0.9


def test_an_own_trajectory_is_followed(pendulum: Robot) -> None:
    motion = fourier(pendulum, 0.5, 3, 7)
    made = hide(pendulum, setup=Setup(rate=500.0, duration=2.0), motions=[motion])
    assert np.abs(made.train.q[::4] - motion.q[::8]).max() < 2e-3
    assert made.effects == ()
    assert made.gap[0] < 1e-9
    with pytest.raises(InputError, match="does not fit"):
        hide(load("puma560_3dof", warn=lambda _: None), motions=[motion])


@pytest.mark.parametrize(
    ("wanted", "words"),
    [
        (Amendment("friction", 1, {}), "unknown effect"),
        (Amendment("coulomb_friction", 2, {}), "no such joint"),
        (Amendment("coulomb_friction", 1, {"depth": 1.0}), "no such parameter"),
        (Amendment("payload", 1, {"mass": 1.0}), "effect of the whole robot"),
        (Amendment("motor_coupling", None, {}), "shows at no joint"),
        (Amendment("transmission_loss", 1, {"efficiency": 1.5}), "out of range"),
    ],
)
def test_what_cannot_be_hidden_is_refused(pendulum: Robot, wanted: Amendment, words: str) -> None:
    with pytest.raises(InputError, match=words):
        hide(pendulum, [wanted])


def test_run_time_parameters_and_noise_that_drowns_all_are_refused(pendulum: Robot) -> None:
    with pytest.raises(InputError, match="run-time parameters"):
        hide(read_text(PENDULUM.replace("mass: 2.0", "mass: m")))
    with pytest.raises(InputError, match="no room for so many"):
        hide(pendulum, random=20)


# --- draws ------------------------------------------------------------------------------------------------


def test_draws_are_of_all_kinds_and_never_two_that_look_like_a_third() -> None:
    robot = load("puma560", warn=lambda _: None)
    u = usual(robot, fourier(robot, 0.1, 5, 1))
    seen = set()
    for seed in range(150):
        found = draw(u, 3, np.random.default_rng(seed))
        ids = [one.effect for one in found]
        assert len(set(ids)) == 3
        assert not {"payload", "inertial_error"} <= set(ids)
        for joint in range(1, 7):
            here = {one.effect for one in found if one.joint == joint}
            assert len(here & {"coulomb_friction", "asymmetric_friction", "torque_bias"}) < 2
        seen |= {(one.effect, one.joint is None) for one in found}
    assert {id for id, _ in seen} == set(CATALOGUE)
    assert {id for id, whole in seen if whole} == {"payload", "base_tilt", "external_contact", "time_delay"}


@pytest.mark.parametrize("arm", ["puma560", "stanford"])
def test_steady_effects_of_every_form_are_legal_and_of_about_the_size_they_start_at(arm: str) -> None:
    robot = load(arm, warn=lambda _: None)
    motion = fourier(with_limits(robot)[0], 0.1, 5, 1)
    u = usual(robot, motion)
    t, q, qd, qdd = (x[::20] for x in (motion.t, motion.q, motion.qd, motion.qdd))
    for id in CATALOGUE:
        for joint in places(id, u)[:2]:
            one = form(id, joint, u, np.random.default_rng(1))
            true = amended(robot, [Amendment(id, joint, settings(one.build(one.start), {}))])
            log = Log(t, q, qd, qdd, Model(true).torque(q, qd, qdd))
            share = float((rms(lacking(robot, measured(log, true))) / u.tau).max())
            if id not in ("joint_elasticity", "backlash", "external_contact"):
                assert 1e-3 < share < 5, (id, joint)


# --- seal and score ---------------------------------------------------------------------------------------


def test_a_seal_hides_and_opens_and_is_refused_where_it_is_broken() -> None:
    answer = {"robot": "arm", "effects": [{"effect": "spring", "joint": 2, "parameters": {"stiffness": 3.5}}]}
    text = seal(answer)
    assert open_seal(text) == answer
    assert open_seal(text.replace("\n", "\r\n")) == answer
    assert "spring" not in text
    assert max(map(len, text.splitlines())) < 80
    for broken in ("", "spring", text[: len(text) // 2], text.replace("1\n", "2\n", 1), text + "!", seal({})):
        with pytest.raises(InputError, match="not a sealed answer"):
            open_seal(broken)


def finding(effect: str, joint: int | None, *others: str, confidence: float = 0.9) -> Any:
    return {
        "effect": effect, "joint": joint, "parameters": {}, "confidence": confidence,
        "confounded_with": list(others),
    }  # fmt: skip


def coupling(joint: int, other: int) -> Any:
    return {**finding("motor_coupling", joint), "parameters": {"with": {"value": float(other)}}}


def hidden(*effects: tuple[Any, ...]) -> dict[str, Any]:
    listed = [{"effect": e[0], "joint": e[1], "parameters": e[2] if len(e) > 2 else {}} for e in effects]
    return {"effects": listed, "noise": [1.0, 1.0], "logs": {"train.csv": "a" * 64}}


SPRING, BIAS, LOAD = ("spring", 2), ("torque_bias", 2), ("payload", None)
IN_SET = "in the declared set"
BIASED, SPRUNG = finding("torque_bias", 2, "spring"), finding("spring", 2)
WRIST = ("motor_coupling", 6, {"with": 5.0})


@pytest.mark.parametrize(
    ("answer", "findings", "result", "statuses", "missed"),
    [
        ([SPRING], [finding("spring", 2)], "right", ["right"], 0),
        ([SPRING], [finding("spring", 3)], "wrong", ["wrong"], 1),
        ([SPRING], [finding("torque_bias", 2, "spring")], IN_SET, [IN_SET], 0),
        ([SPRING], [finding("torque_bias", 3, "spring")], "wrong", ["wrong"], 1),
        ([LOAD], [finding("inertial_error", 6, "payload")], IN_SET, [IN_SET], 0),
        ([SPRING], [finding("spring", 2, confidence=0.3)], "missed", [], 1),
        ([SPRING, BIAS], [finding("spring", 2)], "missed", ["right"], 1),
        ([SPRING, BIAS], [BIASED, SPRUNG], "right", ["right"] * 2, 0),
        ([SPRING], [finding("spring", 2), finding("spring", 2)], "wrong", ["right", "wrong"], 0),
        ([WRIST], [coupling(5, 6)], "right", ["right"], 0),
        ([WRIST], [coupling(4, 6)], "wrong", ["wrong"], 1),
        ([], [], "right", [], 0),
        ([], [finding("spring", 2)], "wrong", ["wrong"], 0),
    ],
)  # fmt: skip
def test_the_score(answer: Any, findings: Any, result: str, statuses: list[str], missed: int) -> None:
    verdict = "missing_effect" if findings else "consistent"
    found = score(hidden(*answer), {"verdict": verdict, "findings": findings})
    assert (found.result, [c.status for c in found.claims], found.missed) == (result, statuses, missed)


def test_the_gap_that_closed_and_whose_logs_they_are() -> None:
    gap = {"validate": {"before": [5.0, 1.0], "after": [1.0, 1.0]}}
    told = {"verdict": "consistent", "findings": [], "gap": gap, "logs": [{"sha256": "a" * 64}]}
    found = score(hidden(SPRING), told)
    assert found.closed == pytest.approx(1.0)
    assert found.same
    assert not score(hidden(SPRING), {**told, "logs": [{"sha256": "b" * 64}]}).same
    half = {"validate": {"before": [5.0, 5.0], "after": [3.0, 3.0]}}
    assert score(hidden(SPRING), {**told, "gap": half}).closed == pytest.approx(1 - 3**-0.5)
    assert (
        score(hidden(), {**told, "gap": {"validate": {"before": [1.0, 1.0], "after": [1, 1]}}}).closed is None
    )
