"""``robodyn export``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from robodyn.robot import load
from robodyn_cli.main import main


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_file_is_written_and_is_a_robot(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["export", "ur10", "--to", "urdf", "-o", "arm.urdf"]) == 0
    out, err = capsys.readouterr()
    assert out == ""
    assert err.splitlines() == ["robodyn: wrote arm.urdf: 6 joints"]
    assert main(["flops", "arm.urdf", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["robot"] == "ur10"


def test_without_output_the_file_goes_to_stdout(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["export", "puma560", "--to", "sdf"]) == 0
    out, err = capsys.readouterr()
    assert out.startswith('<?xml version="1.0" encoding="utf-8"?>\n<!-- PUMA 560, six joints -->\n')
    assert "robodyn: not in the file: rotor inertias" in err.splitlines()
    assert list(folder.iterdir()) == []


def test_json_has_everything(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["export", "puma560", "--to", "mjcf", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["joints"] == [link.name for link in load("puma560").links]
    assert data["missing"] == ["limits of velocity", "limits of acceleration"]
    assert data["text"].rstrip().endswith("</mujoco>")
    assert data["path"] is None


def test_nothing_is_overwritten_unasked(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Path("arm.xml").write_text("mine")
    assert main(["export", "ur5", "--to", "mjcf", "-o", "arm.xml"]) == 2
    assert "already exists" in capsys.readouterr().err
    assert Path("arm.xml").read_text() == "mine"
    assert main(["export", "ur5", "--to", "mjcf", "-o", "arm.xml", "--force"]) == 0


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["nobody", "--to", "urdf"], "nobody"),
        (["ur5", "--to", "dae"], "the format is unknown; found 'dae'; expected urdf, mjcf, sdf"),
        (["ur5"], "--to"),
        (["arm.yaml", "--to", "urdf"], "--param m=VALUE"),
        (["arm.yaml", "--to", "urdf", "--param", "n=1"], "found"),
        (["ur5", "--to", "urdf", "-o", ""], "empty"),
    ],
)
def test_refused_in_one_line(
    folder: Path, capsys: pytest.CaptureFixture[str], words: list[str], message: str
) -> None:
    Path("arm.yaml").write_text("name: arm\nlinks:\n  - {joint: revolute, mass: m}\n")
    assert main(["export", *words]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert message in err
    assert len(err.splitlines()) == 1
    assert [path.name for path in folder.iterdir()] == ["arm.yaml"]


def test_parameters_take_values(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Path("arm.yaml").write_text("name: arm\nlinks:\n  - {joint: revolute, mass: m}\n")
    assert main(["export", "arm.yaml", "--to", "urdf", "--param", "m=17*0.1"]) == 0
    assert 'value="1.7"' in capsys.readouterr().out
