"""``robodyn report``: one file, whole or not at all; data on request; errors as of other commands."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from robodyn_cli.main import main

ARM = "name: arm\nlinks: [{joint: revolute, mass: m_tool, com: [1, 0, 0]}]\n"


def test_it_writes_a_page_and_says_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["report", "stanford_3dof", "-o", str(tmp_path / "pages")]) == 0
    out, err = capsys.readouterr()
    (file,) = (tmp_path / "pages").iterdir()
    assert file.name == "stanford_3dof.html"
    assert file.read_text(encoding="utf-8").startswith("<!doctype html>")
    assert out == ""
    assert err == f"robodyn: wrote {file}\n"


def test_two_arms_and_their_differences(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = tmp_path / "both.html"
    arguments = ["report", "stanford_3dof", "stanford_3dof_d3", "-o", str(page), "--json"]
    assert main(arguments) == 0
    data = json.loads(capsys.readouterr().out)
    assert [robot["robot"] for robot in data["robots"]] == ["stanford_3dof", "stanford_3dof_d3"]
    assert not data["comparison"]["same"]
    text = page.read_text(encoding="utf-8")
    assert text.count('type="module"') == 3
    assert "stanford_3dof_d3_inverse_dynamics" in text


def test_json_alone_writes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "arm.yaml").write_text(ARM)
    assert main(["report", "arm.yaml", "--json", "--param", "m_tool=2"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["home"]["torque"] == [0.0]
    assert data["links"][0]["mass"] == 2.0
    assert [file.name for file in tmp_path.iterdir()] == ["arm.yaml"]
