"""``robodyn import``, and ROBOT as a file in another format."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from robodyn.formats import loading
from robodyn.formats.arm import import_arm
from robodyn.robot import load
from robodyn_cli.main import main
from robodyn_testing.urdf_text import GRIPPER, joint, link, robot

ARM = robot(
    link("base"), link("a", link("x")[15:-7] + "<visual/>"), link("b"), joint("one", "base", "a"),
    joint("two", "a", "b", "revolute", '<axis xyz="0 1 0"/>'), name="two-joint arm",
)  # fmt: skip

GRAVITY = "gravity is assumed to be 0, 0, -9.81 m/s^2 in the root's frame: URDF has none"


@pytest.fixture
def arm(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "arm.urdf"
    path.write_text(ARM)
    return path


def test_a_description_is_written_and_reads_back(arm: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["import", "arm.urdf", "-o", "arm.yaml"]) == 0
    out, err = capsys.readouterr()
    assert out == ""
    assert err.splitlines() == [
        f"robodyn: note: arm.urdf: {GRAVITY}",
        "robodyn: note: arm.urdf: not used: visual geometry (line 3)",
        "robodyn: wrote arm.yaml: 2 joints",
    ]
    text = Path("arm.yaml").read_text()
    assert text.startswith("name: two_joint_arm\n")
    notes: list[str] = []
    described = loading.load("arm.yaml", note=notes.append)
    assert notes == [], "nothing that may change numbers"
    assert described.account == import_arm("arm.urdf").robot.account
    assert described.links[1].name == "two"


def test_json_has_everything(arm: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["import", "arm.urdf", "--json", "--lock", "two=pi/2"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["joints"] == ["one"]
    assert data["unused"] == [{"what": "visual geometry", "file": "arm.urdf", "lines": [3]}]
    assert data["remarks"] == ["locked, and lumped into the links that carry them: two at 1.5708"]
    assert data["path"] is None


def test_robot_may_be_a_file_in_another_format(arm: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["import", "arm.urdf", "-o", "arm.yaml"]) == 0
    capsys.readouterr()
    counts = []
    for name in ("arm.urdf", "arm.yaml"):
        assert main(["flops", name, "--json"]) == 0
        counts.append(json.loads(capsys.readouterr().out))
    assert [(count["mul"], count["add"]) for count in counts[:1]] == [(counts[1]["mul"], counts[1]["add"])]
    Path("grip.urdf").write_text(GRIPPER)
    assert main(["flops", "grip.urdf"]) == 2
    assert "several tips; found 2 tips" in capsys.readouterr().err


@pytest.mark.thorough
def test_results_of_a_file_in_another_format_are_descriptions(
    arm: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """What identify and diagnose write, and what simulate takes the hash of, is the YAML that is imported."""
    run = ["simulate", "arm.urdf", "--excite", "--duration", "5", "--seed"]
    for seed, log in (("1", "a.csv"), ("2", "b.csv")):
        assert main([*run, seed, "--torque-noise", "0.01", "-o", log]) == 0
    assert main(["identify", "arm.urdf", "a.csv", "-o", "own"]) == 0
    assert load("own/identified.yaml", warn=lambda _: None).n == 2
    assert main(["diagnose", "arm.urdf", "a.csv", "--validate", "b.csv", "-o", "lacks"]) in (0, 4)
    text = Path("lacks/model.yaml").read_text()
    assert 'imported:\n  file: "arm.urdf"\n  format: "URDF"\n' in text
    assert load("lacks/model.yaml", warn=lambda _: None).links[1].name == "two"
