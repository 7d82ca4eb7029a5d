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


def test_without_output_the_description_goes_to_stdout(arm: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["import", "arm.urdf", "--name", "mine"]) == 0
    assert "name: mine\n" in capsys.readouterr().out
    assert [path.name for path in Path.cwd().iterdir()] == ["arm.urdf"]


def test_json_has_everything(arm: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["import", "arm.urdf", "--json", "--lock", "two=pi/2"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["joints"] == ["one"]
    assert data["unused"] == [{"what": "visual geometry", "file": "arm.urdf", "lines": [3]}]
    assert data["remarks"] == ["locked, and lumped into the links that carry them: two at 1.5708"]
    assert data["path"] is None


def test_nothing_is_overwritten_unasked(arm: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Path("arm.yaml").write_text("mine")
    assert main(["import", "arm.urdf", "-o", "arm.yaml"]) == 2
    assert "arm.yaml already exists" in capsys.readouterr().err
    assert main(["import", "arm.urdf", "-o", "arm.urdf", "--force"]) == 2
    assert arm.read_text() == ARM
    assert main(["import", "arm.urdf", "-o", "arm.yaml", "--force"]) == 0


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--tip", "c"], "arm.urdf: there is no link of the name after --tip; found 'c'"),
        (["--lock", "two"], "'two' is not NAME=VALUE"),
        (["--lock", "two=0", "--lock", "two=1"], "--lock has two values of one name; found two"),
        (["--arg", "x=1"], "arguments are for xacro files"),
        (["--name", "double"], "the robot's name is a keyword of C; found 'double'"),
        (["--gravity", "0,-9.81"], "'0,-9.81' is not x,y,z"),
        (["--snap", "1"], "Invalid value for '--snap'"),
    ],
)
def test_options_that_do_not_fit_are_refused(
    arguments: list[str], words: str, arm: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["import", "arm.urdf", *arguments, "-o", "out.yaml"]) == 2
    out, err = capsys.readouterr()
    assert words in err
    assert out == ""
    assert len(err.splitlines()) == 1
    assert not Path("out.yaml").exists()


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


def test_right_angles_of_few_digits_are_reported(arm: Path, capsys: pytest.CaptureFixture[str]) -> None:
    arm.write_text(ARM.replace('xyz="0 1 0"', 'xyz="0 1 3e-6"'))
    assert main(["import", "arm.urdf", "-o", "rough.yaml"]) == 0
    err = capsys.readouterr().err
    assert "2 angles are multiples of pi/2 but for 3.0e-06 rad, such as two: alpha; with --snap 1e-05" in err
    assert main(["import", "arm.urdf", "--snap", "1e-5", "-o", "arm.yaml"]) == 0
    assert "multiples of pi/2" not in capsys.readouterr().err
    assert load("arm.yaml").links[1].joint.alpha.quarter is not None
    assert load("rough.yaml").links[1].joint.alpha.quarter is None


def test_a_file_that_is_not_there_is_no_robot(arm: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["gen", "none.urdf"]) == 2
    assert "neither a file nor a bundled robot" in capsys.readouterr().err
    assert main(["import", "none.urdf"]) == 2
    assert "none.urdf: the file cannot be read; found no such file" in capsys.readouterr().err


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
