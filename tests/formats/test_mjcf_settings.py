"""MJCF whose settings are those of several models, and equations between tendons: refused where they act."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from robodyn.formats.arm import read_tree
from robodyn.verify.against import read_original
from robodyn_testing import require_module
from robodyn_testing.mjcf_arms import ATTACHED, GRIPPER, MERGED, TENDONS, arm, write
from robodyn_testing.refused import check_is_refused


@pytest.fixture(autouse=True)
def mujoco() -> Any:
    return require_module("mujoco")


def test_a_fluid_of_what_is_attached_is_refused_where_it_is_taken_over(tmp_path: Path) -> None:
    files = {
        "arm.xml": arm('<attach model="g" body="palm" prefix="p_"/>', MERGED + ATTACHED % "gripper.xml"),
        "gripper.xml": GRIPPER.replace("<compiler", '<option density="1.2"/><compiler'),
    }
    check_is_refused(write(tmp_path, files), "density")


DISABLED = '<flag gravity="disable" spring="enable"/>'
OTHERWISE = {
    ("warning", "", 'gravity="0 0 -3">'): ["gravity is 0 0 -9.81, and not 0 0 -3 (g.xml)"],
    ("warning", "", 'density="1.2">'): ["density is 0, and not 1.2 (g.xml)"],
    ("warning", "", f">{DISABLED}"): ["gravity is enable, and not disable (g.xml)"],
    ("warning", 'gravity="0 0 -3">', 'gravity=" 0x0 0 -3.0 ">'): [],
    ("merge", '><flag gravity="enable"/>', f">{DISABLED}"): ["gravity is disable, and not enable (arm.xml)"],
    ("merge", "", f'gravity="0 0 -3">{DISABLED}'): [],
}


@pytest.mark.parametrize(("rule", "of_arm", "of_hand"), OTHERWISE)
def test_what_does_not_count_of_two_models_is_told_and_leaves_no_log(
    rule: str, of_arm: str, of_hand: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: Any
) -> None:
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    option = f"<option {of_arm}</option>" if of_arm else ""
    head = f'<compiler conflict="{rule}"/>{option}' + ATTACHED % "g.xml"
    files = {
        "arm.xml": arm('<attach model="g" body="palm" prefix="p_"/>', head),
        "g.xml": GRIPPER.replace("<compiler", f"<option {of_hand}</option><compiler"),
    }
    path = write(tmp_path, files)
    remarks = read_tree(path, without=["density"]).remarks
    read_original(path)
    lines = [re.sub(r"\(\S*?(\w+\.xml):1:\d+\)", r"(\1)", each) for each in remarks if "and not" in each]
    assert lines == [f"{words}, as MuJoCo reads it" for words in OTHERWISE[rule, of_arm, of_hand]]
    assert not list((tmp_path / "here").iterdir())
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("stated", ["", 'class="on"', 'class="off" active="true"'])
def test_an_active_equation_of_tendons_is_refused(stated: str, tmp_path: Path) -> None:
    off = '<default class="off"><equality active="false"/></default>'
    on = '<default class="on"><equality active="true"/></default>'
    head = f'<default><equality active="{"false" if "on" in stated else "true"}"/>{on}{off}</default>'
    check_is_refused(write(tmp_path, {"arm.xml": arm("", head, TENDONS % stated)}), "equality")
