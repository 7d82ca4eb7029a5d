"""A robot against its original file as MuJoCo or Pinocchio reads it: right, wrong, and not compared."""

from __future__ import annotations

import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from robodyn.errors import InputError, ToolError
from robodyn.formats.arm import import_arm
from robodyn.robot.model import EffectEntry, Robot
from robodyn.tools import Library
from robodyn.tools.libraries import MUJOCO, PINOCCHIO
from robodyn.verify.against import comparable, compare, read_original
from robodyn_testing import require_module
from robodyn_testing.original_arms import MJCF, PLANTED, URDF

TEXTS = {"mjcf": MJCF, "urdf": URDF}


@pytest.fixture(autouse=True)
def libraries() -> None:
    for name in ("mujoco", "pinocchio"):
        require_module(name)


def original(folder: Path, form: str, text: str | None = None) -> Path:
    path = folder / f"arm.{'xml' if form == 'mjcf' else form}"
    path.write_text(TEXTS[form] if text is None else text)
    return path


def imported(path: Path, **options: object) -> Robot:
    return import_arm(path, tip="tool", **options).robot  # type: ignore[arg-type]


def failing(robot: Robot, path: Path, locks: dict[str, float] | None = None) -> dict[str, int | None]:
    """The rows that differ, and their joints."""
    arm = read_original(path).arm(robot, locks or {})
    rows = compare(comparable(robot, arm)[0], arm, states=30)
    assert {"inverse_dynamics", "mass_matrix", "motion of links", "tool frame"} <= {
        row.function for row in rows
    }
    return {row.function: row.joint for row in rows if not row.passed}


@pytest.mark.parametrize("form", TEXTS)
def test_what_is_imported_is_what_the_library_reads(form: str, tmp_path: Path) -> None:
    path = original(tmp_path, form)
    assert failing(imported(path), path) == {}


@pytest.mark.parametrize(("form", "what"), PLANTED)
def test_every_planted_error_is_noticed(form: str, what: str, tmp_path: Path) -> None:
    robot = imported(original(tmp_path, form))
    right, wrong, rows, joint = PLANTED[form, what]
    text = TEXTS[form].replace(right, wrong)
    assert text.count(wrong) == 1
    differ = failing(robot, original(tmp_path, form, text))
    assert rows <= set(differ)
    assert joint is None or differ["motion of links"] == joint


def test_a_joint_beside_the_arm_stands_where_it_is_locked(tmp_path: Path) -> None:
    for form in TEXTS:
        path = original(tmp_path, form)
        robot = imported(path, locks={"f": 0.045})
        assert failing(robot, path, {"f": 0.045}) == {}
        assert "mass_matrix" in failing(robot, path)


def test_joints_of_other_names_are_taken_in_order_if_there_are_as_many(tmp_path: Path) -> None:
    text = MJCF.partition('<body name="finger"')[0] + "</body></body></body></body></worldbody></mujoco>"
    robot = imported(original(tmp_path, "mjcf", text))
    renamed = replace(robot, links=tuple(replace(link, name=f"axis_{link.name}") for link in robot.links))
    assert failing(renamed, original(tmp_path, "mjcf", text)) == {}
    nameless = original(tmp_path, "mjcf", text.replace(' name="j"', "").replace(' name="k"', ""))
    assert failing(imported(nameless), nameless) == {}
    mixed = replace(robot, links=(*robot.links[:2], renamed.links[2]))
    with pytest.raises(InputError, match="the file has no joint 'axis_k', which arm has"):
        read_original(original(tmp_path, "mjcf", text)).arm(mixed, {})


def test_what_the_library_has_no_model_of_is_not_compared(tmp_path: Path) -> None:
    path = original(tmp_path, "urdf")
    robot = imported(path)
    spring = EffectEntry("spring", 2, (("stiffness", Fraction(3)),))
    stribeck = EffectEntry(
        "stribeck_friction",
        1,
        (("level", Fraction(1)), ("static", Fraction(2)), ("velocity", Fraction(1, 10))),
    )
    payload = EffectEntry("payload", None, (("mass", Fraction(1)), ("com", (Fraction(0),) * 3)))
    joint = replace(robot.links[2].joint, motor_inertia=Fraction(2))
    links = (*robot.links[:2], replace(robot.links[2], joint=joint))
    richer = replace(robot, links=links, effects=(spring, stribeck))
    arm = read_original(path).arm(richer, {})
    assert failing(richer, path) == {}
    _, left_out = comparable(richer, arm)
    assert set(left_out) == {
        "spring of joint j",
        "stribeck_friction of joint i",
        "rotor inertia of k",
        "gravity",
        "gears and rotors",
    }
    assert "inverse_dynamics" in failing(replace(robot, effects=(payload,)), path)


def test_constraints_are_not_compared(tmp_path: Path) -> None:
    path = original(tmp_path, "mjcf", MJCF.replace("<equality>", '<equality><weld body1="base"/>'))
    arm = read_original(path).arm(imported(path), {})
    assert list(arm.not_compared) == ["constraints of the file (1)"]


def test_meshes_that_are_not_there_are_needed_only_for_inertias(tmp_path: Path) -> None:
    mesh = '<asset><mesh name="m" file="shell.obj"/></asset><worldbody><geom type="mesh" mesh="m"/>'
    shape = '<geom type="mesh" mesh="m"/><site name="tool"'
    text = MJCF.replace("<worldbody>", mesh).replace('<site name="tool"', shape)
    path = original(tmp_path, "mjcf", text)
    robot = imported(path)
    assert failing(robot, path) == {}
    assert "meshes" in read_original(path).arm(robot, {}).not_compared
    last = '<inertial pos="0 0.1 0" mass="0.4" diaginertia="0.001 0.001 0.001"/>'
    for less in (
        text.replace(last, '<geom type="mesh" mesh="m"/>'),
        text.replace("<compiler", '<compiler inertiafromgeom="true"'),
    ):
        with pytest.raises(InputError, match=r"MuJoCo refuses the file; .*shell\.obj"):
            read_original(original(tmp_path, "mjcf", less))


@pytest.mark.parametrize(("form", "library"), [("mjcf", MUJOCO), ("urdf", PINOCCHIO)])
def test_a_library_that_is_missing_is_named(
    form: str, library: Library, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = original(tmp_path, form)
    monkeypatch.setitem(sys.modules, library.module, None)
    with pytest.raises(ToolError, match="not installed") as error:
        read_original(path)
    assert library.install in error.value.message()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("<sdf version='1.9'/>", "no library that is used here reads this format"),
        ("<robot", "the file is not XML"),
        ("<robot name='a'/>", "Pinocchio refuses the file"),
        ("<mujoco><worldbody><body><geom/></body></worldbody></mujoco>", "MuJoCo refuses the file"),
        ("<mujoco><include file='none.xml'/></mujoco>", "MuJoCo refuses the file"),
    ],
)
def test_what_is_not_read_is_refused_with_the_place(text: str, words: str, tmp_path: Path) -> None:
    path = tmp_path / "arm.xml"
    path.write_text(text)
    with pytest.raises(InputError, match=words) as error:
        read_original(path)
    assert str(path) in str(error.value)


def test_what_is_not_xml_by_the_letter_is_read_as_pinocchio_reads_it(tmp_path: Path) -> None:
    wilder = URDF.replace('<link name="world"/>', '<a:b/><!-- a -- b --><link name="world"/>')
    path = original(tmp_path, "urdf", f"\n<?xml version='1.0'?>{wilder}")
    assert failing(imported(path), path) == {}
