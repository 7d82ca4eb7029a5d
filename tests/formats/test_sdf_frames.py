"""SDF whose models are put together and placed by frames: Drake reads the same files."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import robodyn
from robodyn.errors import InputError
from robodyn.formats.elements import parse
from robodyn.formats.frames import description_of
from robodyn.formats.sdf import read_tree
from robodyn.formats.serial import serial_chain
from robodyn_cli.main import main
from robodyn_testing.arms import RigidArm
from robodyn_testing.sdf_arms import ARM, ARMS, FIGURES, STATE, joints_of, model, sdf, world

DRAKE = json.loads(FIGURES.read_text())


@pytest.mark.parametrize("name", ARMS)
def test_the_arm_is_what_drake_reads(name: str) -> None:
    text, chosen, tip = ARMS[name]
    tree = read_tree(parse(text.encode(), "arm.sdf"), chosen)
    chain = serial_chain(tree, "arm", tip=tip).chain
    assert tuple(joint.name for joint in chain.joints) == joints_of(name)
    own = RigidArm(description_of(chain))
    q, qd, qdd = (np.array(values[: len(chain.joints)]) for values in STATE)
    assert own.torques(q, qd, qdd) == pytest.approx(DRAKE[name]["torques"], rel=0, abs=1e-9)
    assert own.mass_matrix(q) == pytest.approx(np.array(DRAKE[name]["mass_matrix"]), rel=0, abs=1e-9)
    assert own.tip(q)[:3] == pytest.approx(np.array(DRAKE[name]["tip"]), rel=0, abs=1e-9)


def test_an_arm_beside_a_floor_needs_no_choice() -> None:
    floor = model('<static>true</static><link name="plane"/>', "", "ground_plane")
    fixed = '<joint name="x" type="fixed"><parent>world</parent><child>a</child></joint>'
    still = model(f'<link name="a"/>{fixed}', "", "box")
    tree = read_tree(parse(world(floor + model(ARM) + still).encode(), "arm.sdf"))
    assert tree.name == "arm"
    assert tree.gravity == (0.0, 0.0, -9.81)
    assert tree.remarks == (
        "the model 'arm' is read, the only one with joints that move; not read: ground_plane, box",
    )


def test_models_that_are_placed_by_what_is_deep_in_them_take_no_time_that_doubles() -> None:
    text, path = ARM, "l2"
    for i in range(50):
        text = model(text, f'placement_frame="{path}"', f"m{i}")
        path = f"m{i}::{path}"
    tree = read_tree(parse(sdf(text).encode(), "arm.sdf"))
    assert tree.links[-1].name == path.removeprefix("m49::")


@pytest.fixture
def two(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """A file of two arms, one of them in a model."""
    right = ARM.replace("<mass>1.5", "<mass>1.25")
    text = sdf(model(ARM, "", "left") + model(model(right, "", "right"), "", "torso"))
    monkeypatch.chdir(tmp_path)
    Path("two.sdf").write_text(text)
    Path("two.xml").write_text(text)
    return text


def test_a_model_is_chosen(two: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["import", "two.sdf"]) == 2
    assert "several models; found left, torso; expected" in capsys.readouterr().err
    assert main(["import", "two.sdf", "--model", "torso::right"]) == 0
    assert "mass: 1.25" in capsys.readouterr().out
    assert main(["flops", "two.xml", "--model", "left"]) == 0
    assert main(["flops", "two.sdf", "--model", "lef"]) == 2
    assert "no model of that name; found 'lef'; expected did you mean 'left'?" in capsys.readouterr().err
    robot = robodyn.load("two.sdf", model="torso::right", warn=lambda _: None)
    assert [link.name for link in robot.links] == ["j1", "j2"]
    with pytest.raises(InputError, match="several models"):
        robodyn.load("two.sdf")


def test_a_model_of_what_is_no_sdf_is_refused(two: str, capsys: pytest.CaptureFixture[str]) -> None:
    for command in (["flops", "puma560"], ["import", "arm.urdf"], ["gen", "arm.urdf", "-o", "out"]):
        Path("arm.urdf").write_text('<robot name="arm"/>')
        assert main([*command, "--model", "arm"]) == 2
        assert f"a model is chosen in SDF files; found {command[1]}; leave" in capsys.readouterr().err
    with pytest.raises(InputError, match="a model is chosen in SDF files; found puma560"):
        robodyn.load("puma560", model="arm")
