"""Blind trials: drawn the same again, models as wrong as they say, grades that know right from wrong."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from robodyn.robot import read_text
from robodyn.robot.values import Affine
from robodyn_testing import require_module

require_module("mujoco")

from benchmarks.blind_arms.arms import bare  # noqa: E402
from benchmarks.blind_arms.logs import effect, hidden_log  # noqa: E402
from benchmarks.blind_arms.motion import inverse  # noqa: E402
from benchmarks.blind_arms.random_arms import MOUNTINGS, random_arm  # noqa: E402
from benchmarks.gap.blind import __main__ as blind  # noqa: E402
from benchmarks.gap.blind.diagram import wilson  # noqa: E402
from benchmarks.gap.blind.files import ANSWER, GIVEN  # noqa: E402
from benchmarks.gap.blind.grade import status, truths, values  # noqa: E402
from benchmarks.gap.blind.identification import (  # noqa: E402
    _truth,
    described,
    free_of,
    numbers,
)
from benchmarks.gap.blind.published import intervals_table, names_table, published, renewed  # noqa: E402
from benchmarks.gap.blind.summary import names, reliability  # noqa: E402
from benchmarks.gap.blind.trials import (  # noqa: E402
    ALL_ARMS,
    EFFECTS,
    KINDS,
    KNOWN_ARMS,
    Trial,
    arm_of,
    model_of,
    trials,
)


def finding(
    id: str, joint: int | None, confidence: float = 0.9, rivals: tuple[str, ...] = (), **p: Any
) -> dict[str, Any]:
    numbers = {name: {"value": value, "stderr": error} for name, (value, error) in p.items()}
    return {
        "effect": id, "joint": joint, "parameters": numbers, "confidence": confidence,
        "confounded_with": list(rivals),
    }  # fmt: skip


def hidden_effect(id: str, joint: int | None, /, **settings: Any) -> dict[str, Any]:
    return {"effect": id, "joint": joint, "parameters": truths(effect(id, joint, **settings))}


def test_grades() -> None:
    hidden = [hidden_effect("coulomb_friction", 2, level=3.0)]
    right = finding("coulomb_friction", 2)
    false = finding("spring", 3)
    rival = finding("viscous_friction", 2, rivals=("coulomb_friction",))
    assert status(hidden, [right]) == "right"
    assert status(hidden, [right, false]) == "extra"
    assert status(hidden, [right, right]) == "extra"
    assert status(hidden, [false]) == "wrong"
    assert status(hidden, [finding("coulomb_friction", 3)]) == "wrong"
    assert status(hidden, [rival]) == "set"
    assert status(hidden, []) == "missed"
    assert status([], []) == "silent"
    assert status([], [right]) == "wrong"
    both = [*hidden, hidden_effect("spring", 3, stiffness=4.0, rest=0.0)]
    assert status(both, [right, false]) == "right"
    assert status(both, [right]) == "missed"
    assert status(both, [right, finding("spring", 1)]) == "wrong"


def test_a_coupling_is_at_two_joints() -> None:
    numbers = {"ratio": 1.0, "inertia": 0.1, "viscous": 0.1, "coulomb": 0.1}
    hidden = [hidden_effect("motor_coupling", 6, **{"with": 5}, **numbers)]
    for other, wanted in ((6, "right"), (4, "wrong")):
        joint: dict[str, Any] = {"with": (other, None)}
        claim = finding("motor_coupling", 5, **joint)
        assert status(hidden, [claim]) == wanted


def test_values_beside_the_true_ones() -> None:
    ripple = hidden_effect("torque_ripple", 1, amplitude=2.0, cycles_per_rev=30.0, phase=3.0)
    rows = values(finding("torque_ripple", 1, amplitude=(2.1, 0.1), phase=(-3.2, 0.1)), ripple)
    assert [row[:3] for row in rows] == [
        ["torque_ripple.amplitude", 2.1, 0.1],
        ["torque_ripple.phase", -3.2, 0.1],
    ]
    assert rows[1][3] == pytest.approx(3.0 - 2 * np.pi)
    tool = hidden_effect("payload", None, mass=2.0, com=(0.01, 0.02, 0.03))
    (row,) = values(finding("payload", None, com_y=(0.02, 0.001)), tool)
    assert row[3] == 0.02


def test_only_what_a_bearing_shows_is_asked_for() -> None:
    load = hidden_effect("load_dependent_friction", 2, bearing="journal", mu=0.1, radius=0.06, span=0.2)
    (row,) = values(
        finding("load_dependent_friction", 2, mu_r=(0.007, 0.001), bearing=("radial", None)), load
    )
    assert row[3] == pytest.approx(0.006)
    unknown = finding("load_dependent_friction", 2, mu_r=(0.007, None), span=(0.1, None))
    both = {"mu_r / span": {"value": 0.04, "stderr": 0.01}, "mu_r / depth": {"value": 1.0, "stderr": 0.1}}
    (row,) = values({**unknown, "combinations": both}, load)
    assert row[:3] == ["load_dependent_friction.mu_r / span", 0.04, 0.01]
    assert row[3] == pytest.approx(0.03)


def test_a_push_counts_once_in_each_log_and_at_its_time() -> None:
    push = hidden_effect("external_contact", None, start=1.0, end=1.5, link=6, force_x=3.0)

    def seen(log: str, start: float, end: float) -> dict[str, Any]:
        return finding("external_contact", None, start=(start, 0.1), end=(end, 0.1), log=(log, None))

    assert status([push], [seen("log 1", 1.1, 1.5)]) == "right"
    assert status([push], [seen("log 1", 1.1, 1.5), seen("log 2", 0.9, 1.4)]) == "right"
    assert status([push], [seen("log 1", 1.0, 1.2), seen("log 1", 1.3, 1.5)]) == "extra"
    assert status([push], [seen("log 1", 1.1, 1.5), seen("log 2", 2.0, 2.4)]) == "extra"
    assert status([push], [seen("log 1", 2.0, 2.4)]) == "wrong"


def test_trials_are_drawn_the_same_again_and_each_is_its_own() -> None:
    for arms in (ALL_ARMS, KNOWN_ARMS[:2]):
        for kind in KINDS:
            once, again = (list(trials(kind, arms, range(1, 3))) for _ in range(2))
            assert once == again
            assert len({trial.key for trial in once}) == len(once)
    near = list(trials("near", KNOWN_ARMS[:1], range(1, 2)))
    assert all(1.5 <= trial.ratio <= (6 if trial.beside else 4) for trial in near)
    assert {trial.effect for trial in trials("clear", KNOWN_ARMS[:1], range(1, 2))} == set(EFFECTS)


def test_every_random_arm_is_its_own_and_could_be() -> None:
    seeds = range(100, 130)
    texts = [random_arm(seed) for seed in seeds]
    assert texts == [random_arm(seed) for seed in seeds]
    robots = [read_text(text, strict=True) for text in texts]
    assert {robot.n for robot in robots} == set(range(2, 8))
    assert {robot.gravity for robot in robots} == {read_text(text).gravity for text in texts}
    assert len({robot.gravity for robot in robots}) == len(MOUNTINGS)
    kinds = [[link.joint.kind for link in robot.links] for robot in robots]
    assert all("revolute" in each for each in kinds)
    assert any("prismatic" in each for each in kinds)
    assert len({robot.links[0].mass for robot in robots}) == len(robots)


@pytest.mark.thorough
def test_dry_friction_holds_a_joint_and_is_a_set_at_rest() -> None:
    entries = [effect("asymmetric_friction", 2, positive=10.0, negative=4.0)]
    log = hidden_log(
        "puma560_3dof", entries, seed=1, duration=4.0, motion="stops", sticks=True, validation=False
    ).truth.clean
    assert log.qd is not None
    assert log.qdd is not None
    rubs = (log.tau - inverse(bare("puma560_3dof"), log.q, log.qd, log.qdd))[:, 1]
    speed = log.qd[:, 1]
    assert rubs[speed > 0.01] == pytest.approx(10.0, abs=1e-3)
    assert rubs[speed < -0.01] == pytest.approx(-4.0, abs=1e-3)
    still = abs(speed) < 1e-6
    assert still.mean() > 0.1
    assert -4.001 < rubs[still].min() < rubs[still].max() < 10.001
    assert np.ptp(rubs[still]) > 1.0


def test_files_for_other_programs_are_graded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    hidden = hidden_log("puma560_3dof", [effect("coulomb_friction", 2, level=9.0)], seed=1, duration=1.0)
    monkeypatch.setattr(Trial, "make", lambda _: hidden)
    blind.main(["journal", "--write", str(tmp_path / "trials"), "--seeds", "1:2", "--arms", "ur10"])
    (trial,) = (tmp_path / "trials").iterdir()
    assert {path.name for path in trial.iterdir()} == {*GIVEN, ANSWER}
    assert "coulomb" not in (trial / "robot.yaml").read_text()
    (trial / "mine").mkdir()
    claim = finding("coulomb_friction", 2, level=(9.1, 0.1))
    said = {"verdict": "missing_effect", "findings": [claim], "gap": {"validate": {"after": [1.0, 1.0, 1.0]}}}
    (trial / "mine" / "diagnosis.json").write_text(json.dumps(said))
    blind.main(["--read", str(tmp_path / "trials"), "mine", "-o", str(tmp_path / "rows.jsonl")])
    (row,) = blind.lines_of(tmp_path / "rows.jsonl")
    assert row["status"] == "right"
    assert row["values"] == [["coulomb_friction.level", 9.1, 0.1, 9.0, None, None]]
    blind.main(["--diagram", str(tmp_path / "rows.jsonl"), "-o", str(tmp_path / "picture.svg")])
    assert ElementTree.parse(tmp_path / "picture.svg").getroot().tag.endswith("svg")


def test_reliability_counts_names_by_what_was_said() -> None:
    said = [(0.97, True), (0.96, True), (0.99, False), (1.0, True), (0.3, False)]
    findings = [["spring", 1, confidence, [], right] for confidence, right in said]
    rows = [{"kind": "clear", "findings": findings}, {"kind": "outside", "findings": findings}]
    steps = reliability(rows)
    assert [[*step[:3], step[4]] for step in steps] == [
        [0.0, 0.5, 1, 0],
        [0.95, 0.98, 2, 2],
        [0.98, 1.0, 2, 1],
    ]
    assert steps[1][3] == pytest.approx(0.965)
    low, high = wilson(9, 10)  # 0.596 and 0.982 by any statistics package
    assert low == pytest.approx(0.596, abs=1e-3)
    assert high == pytest.approx(0.982, abs=1e-3)


@pytest.mark.parametrize("share", [0.05, 0.3])
def test_wrong_numbers_are_of_bodies_that_could_be(share: float) -> None:
    trial = Trial("null", "ur10", 3, off=share, stated="unknown")
    true = arm_of(trial)
    wrong = model_of(trial, true)
    masses = []
    for link, before in zip(wrong.links, true.links, strict=True):
        assert link.confidence == "unknown"
        i = link.inertia
        moments = np.linalg.eigvalsh(
            np.array(
                [
                    [_float(x) for x in row]
                    for row in ((i.xx, i.xy, i.xz), (i.xy, i.yy, i.yz), (i.xz, i.yz, i.zz))
                ]
            )
        )
        assert moments[2] < moments[0] + moments[1] + 1e-12
        masses.append(np.log(_float(link.mass) / _float(before.mass)))
    assert 0.2 * share < np.std(masses) < 3 * share


def _float(value: Any) -> float:
    assert not isinstance(value, Affine)
    return float(value)


def test_a_run_goes_on_where_it_stopped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ran = []

    def run(trial: Trial, cache: Path | None, *, is_named: bool) -> dict[str, Any]:
        assert not is_named
        ran.append(trial.key)
        return {"key": trial.key, "kind": trial.kind, "status": "silent", "cpu": 1.0}

    monkeypatch.setattr(blind, "run", run)
    file = tmp_path / "rows.jsonl"
    blind.main(["null", "-o", str(file), "--seeds", "1:7", "--most", "3"])
    first = list(ran)
    blind.main(["null", "-o", str(file), "--seeds", "1:7", "--most", "5"])
    assert len(first) == 3
    assert len(ran) == len(set(ran)) == 5
    rows = [json.loads(line) for line in file.read_text().splitlines()]
    assert names(rows) == "null: 5: silent 5 (100 %); 1 s (median), 1 s"


def test_identified_numbers_stand_beside_the_true_ones() -> None:
    true = arm_of(Trial("identify", "puma560_3dof", 1, friction=True))
    joint = true.links[1].joint
    assert _truth(true, "link2", "mass") == _float(true.links[1].mass)
    assert _truth(true, "link2", "com_z") == _float(true.links[1].com[2])
    assert _truth(true, "link3", "inertia_xy") == _float(true.links[2].inertia.xy)
    assert _truth(true, "joint2", "viscous_friction.coefficient") == _float(joint.viscous)
    assert _truth(true, "joint2", "rotor_inertia.inertia") == _float(joint.motor_inertia)
    assert _truth(true, "joint2", "torque_gain.gain") is None


def test_what_is_described_lacks_friction_and_is_wrong() -> None:
    trial = Trial("identify", "ur10", 1, friction=True, off=0.3, stated=0.3)
    robot, true = described(trial), arm_of(trial)
    assert all(link.joint.coulomb for link in true.links)
    assert not any(link.joint.coulomb or link.joint.viscous for link in robot.links)
    assert all(link.confidence == Fraction(3, 10) for link in robot.links)
    assert robot.links[2].mass != true.links[2].mass
    free = free_of(replace(trial, kind="after", effect="spring", joint=2, ratio=3.0))
    assert (free.effect, free.friction) == (None, True)
    assert free.seed != trial.seed


@pytest.mark.thorough
def test_an_identified_arm_leaves_no_more_than_the_true_one() -> None:
    trial = Trial("identify", "puma560_3dof", 1, friction=True, off=0.3, stated=0.3)
    row = numbers(trial, Trial.make)
    assert row["strict"]
    assert np.all(np.array(row["floor_ratio"]) < 1.05 * np.array(row["truth_ratio"]))
    assert sum(abs(value - true) > 4 * error for _, value, error, true in row["values"]) <= 2


def test_published_figures_are_counts_of_rows() -> None:
    rows: list[dict[str, Any]] = [
        {
            "kind": "clear",
            "status": "right",
            "values": [["backlash.gap", 1.1, 0.1, 1.0], ["a.b", 1.0, 0.1, 2.0]],
        },
        {"kind": "clear", "status": "missed", "arm": "ur5", "contacts": [{"angle": 100.0}, {"angle": 10.0}]},
        {"kind": "null", "status": "silent"},
        {"kind": "outside", "status": "missed"},
        {"kind": "outside", "status": "error"},
        {"kind": "identify", "status": "right", "floor_ratio": [1.2, 1.0], "truth_ratio": [1.0, 1.0]},
        {"kind": "payload", "status": "right", "masses": {"together": 0.05}},
    ]
    rows = [{"arm": "puma560", **row} for row in rows]
    figures = published(rows)
    assert figures["intervals"] == {"a.b": [1, 0], "backlash.gap": [1, 1]}
    assert (figures["pushes"], figures["widths"], figures["payloads"]) == ([2, 1, 1], [1, 1], [1, 1])
    assert figures["identified"] == {"arms": 1, "worst beside the true arm": 1.2}
    lines = names_table(figures).splitlines()
    assert [line.split("|")[2:-1] for line in lines[2:]] == [
        [" 2 ", " 1 ", " 0 ", " 1 ", " 0 ", " 0 "],
        [" 1 ", " 1 ", " 0 ", " 0 ", " 0 ", " 0 "],
        [" 2 ", " 1 ", " 0 ", " 0 ", " 0 ", " 1 "],
    ]
    rows.append({"kind": "identify", "arm": "ur5", "status": "right", "values": [["com_x", 1.0, 0.1, 1.0]]})
    assert intervals_table(published(rows)).splitlines()[2:] == [
        "| a | 1 | 0 % |",
        "| backlash | 1 | 100 % |",
        "| centres of mass | 1 | 100 % |",
        "| all | 3 | 67 % |",
    ]
    later = renewed(
        figures,
        published([{"kind": "clear", "arm": "ur5", "status": "wrong", "values": [["a.b", 2.0, 0.1, 2.0]]}]),
    )
    assert later["names"] == {**figures["names"], "clear": {"wrong": 1}}
    assert later["intervals"] == {"a.b": [1, 1], "backlash.gap": [1, 1]}
    assert (later["identified"], later["pushes"]) == (figures["identified"], figures["pushes"])
