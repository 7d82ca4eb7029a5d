"""What an export states, its import computes: exactly the same function, in as few operations."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from robodyn import count, program
from robodyn.dynamics.equality import same_in_field
from robodyn.formats.arm import import_arm
from robodyn.formats.exporting import TARGETS, export_arm
from robodyn.formats.writers.parts import parts_of
from robodyn.formats.writers.physical import physical
from robodyn.robot import bundled_names, load, read_text
from robodyn.robot.model import Robot
from robodyn_testing import representative, require_module

#: Joints behind which nothing has an inertia about the axis: formats that want bodies cannot say so exactly.
NO_INERTIA = ("tx40",)


def again(robot: Robot, to: str, folder: Path) -> Robot:
    """``robot`` out and in, with what the format has no word for."""
    if to == "mjcf":
        require_module("mujoco")
    path = folder / f"arm{TARGETS[to]}"
    path.write_text(export_arm(robot, to).text, encoding="utf-8")
    x, y, z = map(float, robot.gravity)
    imported = import_arm(path, gravity=(x, y, z) if to == "urdf" else None).robot
    if to != "sdf":
        return imported
    rotors = [link.joint.motor_inertia for link in robot.links]
    links = [
        replace(link, joint=replace(link.joint, motor_inertia=rotor))
        for link, rotor in zip(imported.links, rotors, strict=True)
    ]
    return replace(imported, links=tuple(links))


def possible(robot: Robot, to: str) -> bool:
    """Whether the format has bodies of all links."""
    return to == "urdf" or not any(
        remark.startswith("no body moves") for remark in export_arm(robot, to).remarks
    )


CASES = [(name, to) for name in bundled_names() for to in TARGETS]
QUICK = [
    ("ur10", "sdf"),
    ("panda", "mjcf"),
    ("puma560", "mjcf"),
    ("puma560_full", "sdf"),
    ("stanford", "urdf"),
]


@pytest.mark.parametrize(("name", "to"), representative(CASES, *QUICK))
def test_a_bundled_arm_comes_back_as_the_same_function(name: str, to: str, tmp_path: Path) -> None:
    robot = load(name, warn=lambda _: None)
    if not possible(robot, to):
        return
    imported = again(robot, to, tmp_path)
    exact = to == "urdf" or name not in NO_INERTIA
    assert same_in_field(imported, "inverse_dynamics", program(robot, "inverse_dynamics")) is exact
    for function in ("inverse_dynamics", "mass_matrix"):
        assert (count(imported, function).total == count(robot, function).total) is exact


def test_a_flat_body_is_a_body() -> None:
    text = "name: arm\nlinks:\n  - {joint: revolute, mass: 2, inertia: {xx: 0.1, yy: 0.2, zz: 0.3}}\n"
    plate = read_text(text)
    assert export_arm(plate, "mjcf").remarks == ()
    assert 'diaginertia="0.1 0.2 0.3"' in export_arm(plate, "mjcf").text
    assert export_arm(read_text(text.replace("0.3}", "0.31}"), warn=lambda _: None), "mjcf").remarks != ()


def test_what_is_moved_has_few_digits() -> None:
    robot = load("puma560", warn=lambda _: None)
    parts = parts_of(robot).joints
    moved, _ = physical(parts)
    changed = [new.body for new, old in zip(moved, parts, strict=True) if new.body != old.body]
    assert len(changed) == 3
    for body in changed:
        assert all(len(repr(x)) <= 12 for x in (body.mass, *body.com, *body.inertia)), body


def test_gravity_that_a_file_does_not_have_can_be_stated(tmp_path: Path) -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    path = tmp_path / "arm.urdf"
    path.write_text(export_arm(robot, "urdf").text, encoding="utf-8")
    assert import_arm(path).robot.gravity[2] == Fraction("-9.81")
    assert import_arm(path, gravity=(0.0, 0.0, -9.8)).robot.gravity == robot.gravity
