"""``robodyn diff``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from robodyn_cli.main import main


def test_whatever_the_formats(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for to, file in (("urdf", "arm.urdf"), ("sdf", "arm.sdf")):
        assert main(["export", "ur10", "--to", to, "-o", str(tmp_path / file)]) == 0
    capsys.readouterr()
    assert main(["diff", str(tmp_path / "arm.urdf"), str(tmp_path / "arm.sdf")]) == 0
    out, err = capsys.readouterr()
    assert out.splitlines()[-1] == "nothing differs"
    assert [
        "gravity is assumed" in line or "not used: visual geometry" in line for line in err.splitlines()
    ] == [True] * 3


def test_json_has_everything(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["diff", "ur5", "ur10", "--json", "--tolerance", "0.5"]) == 1
    data = json.loads(capsys.readouterr().out)
    assert data["robots"] == ["ur5", "ur10"]
    assert data["same"] is False
    assert data["operations"] == [185, 185]
    assert data["torques"]["share"] > 0
    assert len(data["torques"]["joints"]) == 6
    assert data["tool"]["distance"] > 0
    first = data["differences"][0]
    assert first == {
        "group": "names", "where": None, "what": "name of the robot", "left": "ur5", "right": "ur10",
        "by": None, "unit": "",
    }  # fmt: skip
