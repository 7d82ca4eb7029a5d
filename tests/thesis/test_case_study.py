"""The case study: its torques by an independent recursion, its motion, its pictures, its document."""

from __future__ import annotations

import csv
import io
import json
import math
import re
import xml.etree.ElementTree as ET
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from benchmarks.marked import part

from robodyn.outputs import LIST
from robodyn.thesis.case_arm import D4_START, FOREARM, efficiency_curve, led, led_at, robots
from robodyn.thesis.case_pictures import pictures
from robodyn.thesis.case_study import (
    LABEL,
    SHOWN,
    Assumptions,
    Study,
    case_study,
    motion_of,
    shares,
    torques_along,
)
from robodyn.thesis.case_text import to_csv, to_dict, to_text
from robodyn.thesis.printed import TABLE_3_4
from robodyn.verify.reference import Reference
from robodyn_cli.main import main
from robodyn_testing import constant
from thesis.recomputed import SVG, check_frames

DOCUMENT = Path(__file__).parents[2] / "docs" / "case-study.md"
Capture = pytest.CaptureFixture[str]


@pytest.fixture(scope="module")
def study() -> Study:
    return case_study()


def close(found: Any, expected: Any, within: float = 1e-12) -> None:
    np.testing.assert_allclose(found, expected, rtol=1e-11, atol=within)


def test_the_motion_is_the_line_from_the_start_of_d4(study: Study) -> None:
    motion, point = study.motion, study.point
    assert (len(motion), motion.duration) == (201, 2.0)
    close(motion.q[0], D4_START, 5e-6)
    close(point[:, 0], 0.4)
    close(point[:, 1], point[:, 2])
    close(point[[0, -1], 1], [0.1, 0.5])
    close(motion.qd[[0, -1]], 0)
    h = motion.period
    close((motion.q[2:] - motion.q[:-2]) / (2 * h), motion.qd[1:-1], 2e-3)
    close((motion.qd[2:] - motion.qd[:-2]) / (2 * h), motion.qdd[1:-1], 2e-2)


def test_torques_are_those_of_the_plain_recursion(study: Study) -> None:
    """The reference shares neither code nor formulas with the kernels, effects included."""
    motion, found, arms = study.motion, study.torques, study.robots
    pairs = ((arms.rigid, found.rigid), (arms.with_bearings, found.joint), (arms.complete, found.input))
    for robot, torque in pairs:
        close(torque, Reference(robot).inverse_dynamics(motion.q, motion.qd, motion.qdd), 1e-11)


@pytest.mark.parametrize("span", [0.2, 0.4])
def test_the_parts_add_up_to_table_3_2(span: float, study: Study) -> None:
    """Table 3.2 written out case by case, with the curve's efficiency at the load of the moment."""
    way = np.sign(study.motion.qd)
    found = torques_along(robots(0.0, span), study.motion)
    close(found.rigid + found.bearing, found.joint)
    close(found.joint + found.transmission, found.input)
    close(found.breakaway + found.loss, found.transmission)
    largest, breakaway = (
        np.array([float(getattr(drive, name)) for drive in TABLE_3_4]) for name in ("largest", "breakaway")
    )
    close(found.breakaway, breakaway * way)
    close(found.load, np.abs(found.joint) / largest)
    drives = found.joint * way > 0
    passed = np.where(drives, found.joint / found.efficiency, found.joint * found.efficiency)
    moving = slice(1, -1)
    close((passed + breakaway * way)[moving], found.input[moving], 1e-10)
    assert (way[[0, -1]] == 0).all()
    close(found.input[[0, -1]], found.rigid[[0, -1]])  # no friction at rest
    assert (found.bearing * way >= 0).all()
    assert drives[moving].all() == (span == 0.2)  # narrow bearings alone outweigh what the arm gives back


def test_the_efficiency_curve_has_the_three_points_and_rises() -> None:
    knots = [(float(x), float(y)) for x, y in efficiency_curve()]
    assert knots[:3] == [(0.0076, 0.3458), (0.0307, 0.4543), (0.0856, 0.5619)]
    assert knots[-1][0] == 1
    (x2, y2), (x3, y3) = knots[1:3]
    (x1, y1) = knots[0]
    for slope in (math.log(y2 / y1) / math.log(x2 / x1), math.log(y3 / y2) / math.log(x3 / x2)):
        assert slope == pytest.approx(0.2, abs=0.01)  # what the extension goes by
    assert all(a[0] < b[0] and a[1] < b[1] < 1 for a, b in pairwise(knots))


def test_the_simulated_arm_follows_the_line(study: Study) -> None:
    assert study.closed_loop.point < 2e-4 < study.open_loop.point < 1e-3
    for run in (study.open_loop, study.closed_loop):
        energies = run.energies
        assert energies["error"] < 1e-9
        assert energies["stored"] == pytest.approx(energies["work"] - energies["loss"])
    t, off = study.deviation
    assert (t[-1], float(off.max())) == (2.0, study.closed_loop.point)
    found, motion = study.torques, study.motion
    power = (found.input * motion.qd).sum(axis=1)
    work = float(((power[1:] + power[:-1]) / 2 * motion.period).sum())  # of the torques, not of the run
    assert study.open_loop.energies["work"] == pytest.approx(work, rel=2e-3)


def test_the_stored_energy_is_that_of_the_raised_masses(study: Study) -> None:
    """At rest at both ends: weight times height, from the frames alone. Beside it: D.1.3 has the forearm
    along +y, D.1.2 its load along -y, which is twice the forearm off, and the offsets' gap."""
    assert study.load_point == pytest.approx(math.hypot(2 * 0.4318, 0.1501 - 0.127), abs=1e-5)
    kinematics = led_at(study.robots.rigid, -FOREARM).kinematics
    masses = [constant(link.mass) for link in study.robots.rigid.links]
    energy = []
    for q in study.motion.q[[0, -1]]:
        heights = [
            (origin + turn @ np.array([constant(x) for x in link.com]))[2]
            for origin, turn, link in zip(*kinematics.frames(q), study.robots.rigid.links, strict=True)
        ]
        energy.append(9.8 * float(np.dot(masses, heights)))
    assert study.closed_loop.energies["stored"] == pytest.approx(energy[1] - energy[0], rel=1e-2)


def test_assumptions_change_what_they_should() -> None:
    """Motions and kernels alone, without simulations."""
    usual, heavy = robots(0.0, 0.2), robots(10.0, 0.2)
    assert usual.rigid.effects == ()
    for robot in (heavy.rigid, heavy.with_bearings, heavy.complete):
        assert [entry.effect for entry in robot.effects].count("payload") == 1
    consistent = led("consistent")
    motion = motion_of(Assumptions(arm="consistent", profile="trapezoid", end=0.3), consistent).sampled(0.01)
    close(consistent.kinematics.position(motion.q)[-1], [0.4, 0.3, 0.3])
    loaded = led_at(usual.rigid, -FOREARM).kinematics.position(motion.q[0])
    close(loaded, [0.4, 0.1, 0.1])
    q, none = motion.q, np.zeros_like(motion.q)
    weight = Reference(heavy.rigid).gravity(q) - Reference(usual.rigid).gravity(q)
    lift = consistent.kinematics.jacobian(q)[:, 2] * 10 * 9.8  # J^T F of the load
    close(weight, lift, 1e-9)
    wide = robots(0.0, 0.4)
    narrow, broad = (Reference(r.with_bearings).inverse_dynamics(q, motion.qd, none) for r in (usual, wide))
    assert np.abs(narrow - broad)[1:-1].max() > 0.1


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--profile", "constant"), "begins and ends at rest"),
        (("--end", "0.1"), "the line has no length"),
        (("--end", "0.6"), "is out of reach"),
        (("--end", "nan"), "not a point"),
        (("--payload", "-1"), "not a mass"),
        (("--span", "0"), "not a length"),
        (("--arm", "left"), "no such arm"),
        (("-o", ""), "is empty"),
    ],
)
def test_what_is_refused(arguments: tuple[str, ...], words: str, capsys: Capture) -> None:
    assert main(["case-study", *arguments]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert words in err


# --- what is printed ----------------------------------------------------------------------------------------


def test_the_command(study: Study, tmp_path: Path, capsys: Capture) -> None:
    folder = tmp_path / "new"
    assert main(["case-study", "-o", str(folder)]) == 0
    out, err = capsys.readouterr()
    assert out == to_text(study)
    text = DOCUMENT.read_text(encoding="utf-8")
    assert f"<!-- case-study -->\n```text\n{out}```\n<!-- end -->" in text
    assert max(map(len, out.splitlines())) <= 110
    assert LABEL in out
    assert "wrote 9 files" in err
    expected = {"case-study.csv": to_csv(study), **pictures(study)}
    written = [path for path in folder.iterdir() if path.name != LIST]
    assert {path.name: path.read_text() for path in written} == expected


def test_the_data(study: Study) -> None:
    found = json.loads(json.dumps(to_dict(study), allow_nan=False))
    assert found["label"] == LABEL
    assert found["at"]["t"] == pytest.approx(0.6)
    assert found["at"]["input"] == study.torques.input[SHOWN].tolist()
    assert found["at"]["direction"] == [1, 1, -1]  # Table 3.5 has + - +
    assert found["sizes"] == shares(study.torques)
    rows = list(csv.DictReader(io.StringIO(to_csv(study))))
    assert len(rows) == 201
    assert float(rows[SHOWN]["input2"]) == study.torques.input[SHOWN, 1]
    assert float(rows[SHOWN]["t"]) == study.motion.t[SHOWN]
    assert len(rows[0]) == 1 + 3 + 9 + 27


@pytest.mark.parametrize(
    ("name", "given"),
    [
        ("as above", Assumptions()),
        ("trapezoid", Assumptions(profile="trapezoid")),
        ("bearings 0.4 m apart", Assumptions(span=0.4)),
        ("consistent", Assumptions(arm="consistent")),
    ],
)
def test_the_document_shows_other_assumptions(name: str, given: Assumptions) -> None:
    motion = motion_of(given, led(given.arm)).sampled(0.01)
    sizes = shares(torques_along(robots(given.payload, given.span), motion))
    text = part(DOCUMENT.read_text(encoding="utf-8"), "assumptions")
    (row,) = re.findall(rf"^\| {name} \| (.*) \|$", text, flags=re.MULTILINE)
    parts = [" ".join(f"{x:.2f}" for x in sizes[of]["rms"]) for of in ("rigid", "bearing", "input")]
    assert row.split(" | ") == parts


def test_pictures_are_labelled_and_stay_in_their_frames(study: Study) -> None:
    found = pictures(study)
    assert len(found) == 8
    for text in found.values():
        assert LABEL in [element.text for element in ET.fromstring(text).iter(f"{SVG}text")]
        check_frames(text)
    assert pictures(study) == found
