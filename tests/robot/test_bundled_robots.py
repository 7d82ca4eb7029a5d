"""Every number of the bundled robots against a transcription of the thesis's tables, made for this test."""

from __future__ import annotations

import hashlib
import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import yaml

from robodyn.resources import data_dir
from robodyn.robot import Comparison, Link, Robot, bundled_names, bundled_text, load, read_text
from robodyn.robot.masses import inertia_doubt
from robodyn.verify.numbers import exact_value
from robodyn_testing import exactly

#: Of robots of the thesis: which DH rows, the links, and the row of Table 2.10.
TRANSCRIPTS = yaml.safe_load(Path(__file__).with_name("transcripts.yaml").read_text(encoding="utf-8"))
ROBOTS: dict[str, dict[str, Any]] = TRANSCRIPTS["robots"]
# Program D.1.1: diagonals of the pseudo-inertias and m x, m y of links 1 to 3; of link 1 only Izz counts.
PSEUDO_D11 = (("0.0058 0.0058 -0.0058", "0 0"), ("0.6984 0.0340 0.2416", "-1.1832 0"),
              ("0.0039 0.0335 0.1432", "0 -0.4235"))  # fmt: skip
# The others are bundled as they were when others' figures were measured on them: no number that enters a
# torque changes.
AS_THEY_ARE = {
    "iiwa": "9bff701bca92ce967973096c1f98a671b67ef23888da5fc3fdb6951fd0aae622",
    "iiwa7": "2700507a69f29983e127a1cb5c829b30c8f7e8604c8fd309abcc8d4079dbf2b3",
    "panda": "7747082c67e0834b15df4b0ccfab9bcce85d2096a1a1349ec85fb92e7672bcb1",
    "puma560_full": "a087a4db7d8ce02ca0dda6cb5484f9f5ef4e70f14e0f7813525d8139e74de1bf",
    "puma560_rotor_in_link": "7df9a0a0ecfbff211d8ebd348f7e08eb05e845c6afd9b6dcda4f2f4c265f1205",
    "rx90": "ecf93243d899eea90775f4f4c3897b50f2ededc75a07b131f5d4656de0073cd6",
    "stanford_full": "7bc479b459bd4e887b9f8f89ab10ef59b225e12569a6280e296d5c67373247f5",
    "tx40": "b63a70437939faf55c2a5094fbd18c2d49c61e4f030e71374ec9ecb313814641",
    "ur10": "b1dd82558928b4fd4ba1d2f5aaf33af74755a7b7b2fa188500e3bab42ae76fda",
    "ur5": "d0d03b25c5894c707ca44a11892de6c4c293c9df4139e5b48fa7c7b7619a7a9e",
}


#: Links whose tensors no body has, which the files acknowledge.
DOUBTFUL = {
    "puma560": [3], "puma560_3dof": [3], "puma560_d2": [2, 3, 4, 5, 6], "puma560_3dof_d3": [2, 3],
    "puma560_3dof_d12": [2, 3], "puma560_3dof_d4": [2, 3], "puma560_rotor_in_link": [2, 3, 4, 5, 6],
    "stanford_d3": [1, 2, 4, 5], "stanford_3dof_d3": [1, 2],
}  # fmt: skip


def _load(name: str) -> Robot:
    return load(name, warn=lambda _: None)


def _row(text: str) -> tuple[Fraction, ...]:
    return tuple(Fraction(number) for number in text.split())


def test_all_robots_are_there() -> None:
    assert set(bundled_names()) == {*ROBOTS, *AS_THEY_ARE}
    assert (data_dir("robots") / "README.md").is_file()


@pytest.mark.parametrize("name", bundled_names())
def test_each_has_its_file_name_a_title_and_a_source(name: str) -> None:
    robot = _load(name)
    assert robot.name == name
    assert robot.title
    assert robot.source
    assert robot.parameters == ()
    assert all(len(line) <= 110 for line in bundled_text(name).splitlines() if name in ROBOTS)
    if name in ("tx40", "panda"):  # a licence stays with what it is of
        assert "Apache-2.0" in robot.source


def _check_link(link: Link, dh: str, row: str, prismatic: bool) -> None:
    quarter, a, d = dh.split()
    body, moments, motor = row.split(" | ")
    joint, tensor = link.joint, link.inertia
    assert joint.kind == ("prismatic" if prismatic else "revolute")
    assert (joint.alpha.quarter, joint.theta.quarter) == (int(quarter), 0)
    assert (joint.a, joint.d) == (Fraction(a), Fraction(d))
    assert (link.mass, *link.com) == _row(body)
    assert (tensor.xx, tensor.yy, tensor.zz) == _row(moments)
    assert (tensor.xy, tensor.xz, tensor.yz) == exactly(0, 0, 0)
    assert joint.motor_inertia == Fraction(motor)
    assert (joint.viscous, joint.coulomb) == exactly(0, 0)


@pytest.mark.parametrize("name", ROBOTS)
def test_the_thesis_robots_number_by_number(name: str) -> None:
    robot, rows, compared = _load(name), ROBOTS[name]["links"], ROBOTS[name]["row"]
    dh = TRANSCRIPTS["dh"][ROBOTS[name]["dh"]]
    assert robot.gravity == exactly(0, 0, Fraction(-98, 10))
    assert robot.compare == (Comparison("2.10", compared) if compared else None)
    assert robot.n == len(rows)
    for i, (link, row) in enumerate(zip(robot.links, rows, strict=True)):
        _check_link(link, dh[i], row, prismatic=ROBOTS[name]["dh"] == "stanford" and i == 2)


def test_the_pseudo_inertias_of_d_1_1() -> None:
    """Second moments about the frames' origins, whose pairs add up to the moments of inertia there."""
    for link, (diagonal, first) in zip(_load("puma560_3dof_d11").links, PSEUDO_D11, strict=True):
        xx, yy, zz = _row(diagonal)
        mass, x, y, _ = (exact_value(number, {}) for number in (link.mass, *link.com))
        assert (mass * x, mass * y) == _row(first)
        about_origin = (yy + zz, xx + zz, xx + yy)
        tensor = link.inertia
        moments = [exact_value(number, {}) for number in (tensor.xx, tensor.yy, tensor.zz)]
        shifts = (y * y, x * x, x * x + y * y)  # z of both centres is 0
        assert about_origin == tuple(i + mass * s for i, s in zip(moments, shifts, strict=True))


def test_the_sets_hang_together() -> None:
    """What the thesis says of how one set came from another."""
    tool = _load("puma560_3dof_d13").tool
    assert tool is not None
    assert tool.xyz == _row("0 0.4318 0")
    assert all(angle.quarter == 0 for angle in tool.rpy)
    d12, d4 = _load("puma560_3dof_d12").links[2], _load("puma560_3dof_d4").links[2]
    payload, arm = 10, Fraction("0.4318")
    assert isinstance(d4.mass, Fraction)
    assert d4.mass - Fraction("6.05") == payload
    lumped = -(Fraction("6.05") * Fraction("0.07") + arm * payload) / d4.mass
    assert round(lumped, 4) == d4.com[1]
    increment = round(payload * arm**2, 6)
    assert (d4.inertia.xx, d4.inertia.zz) == (d12.inertia.xx + increment, d12.inertia.zz + increment)
    masses = [link.mass for link in _load("stanford").links]
    assert _load("stanford_3dof_d3").links[2].mass == masses[2] + masses[3] + masses[4] + masses[5]
    for tables, listing in zip(_load("stanford").links, _load("stanford_d3").links, strict=True):
        if tables.joint.kind == "revolute":
            assert listing.inertia.zz == tables.inertia.zz + tables.joint.motor_inertia
    for tables, folded in zip(_load("puma560").links, _load("puma560_rotor_in_link").links, strict=True):
        assert folded.inertia.zz == tables.inertia.zz + tables.joint.motor_inertia
        assert (folded.mass, folded.com) == (tables.mass, tables.com)


@pytest.mark.parametrize("name", bundled_names())
def test_no_bundled_robot_warns_and_each_reason_holds(name: str) -> None:
    """What is said of a rotor within Izz is true: without it the tensor is a body's, unless it says not."""
    told: list[str] = []
    robot = load(name, warn=told.append)
    assert told == []
    read_text(re.sub(r"\n    acknowledged: .*", "", bundled_text(name)), warn=told.append)
    doubtful = [int(line.split("link ")[1].split(":")[0]) for line in told]
    acknowledged = [i for i, link in enumerate(robot.links, 1) if link.acknowledged]
    assert doubtful == acknowledged == DOUBTFUL.get(name, [])
    for link in robot.links:
        stated = re.match(r"the rotor \(([0-9.]+) kg m\^2\) is (in|folded into) Izz", link.acknowledged)
        if stated:
            rest = replace(link.inertia, zz=link.inertia.zz - Fraction(stated[1]))
            assert ("without it, too" in link.acknowledged) == (inertia_doubt(rest) is not None)
        elif link.acknowledged:
            lacking = re.search(r"Ixx \+ Iyy falls short of Izz by ([0-9.]+) kg m\^2", link.acknowledged)
            inertia = link.inertia
            assert lacking
            assert inertia.zz - inertia.xx - inertia.yy == Fraction(lacking[1])


@pytest.mark.parametrize("name", AS_THEY_ARE)
def test_the_others_are_as_they_were(name: str) -> None:
    lines = bundled_text(name).splitlines(keepends=True)
    words = ("#", "    acknowledged:", "origin:", "    limits:")
    text = "".join(line for line in lines if not line.startswith(words))
    assert hashlib.sha256(text.encode()).hexdigest() == AS_THEY_ARE[name]
