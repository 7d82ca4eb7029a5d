"""``robodyn verify ROBOT --against FILE``."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from robodyn_cli.main import main
from robodyn_testing import require_module
from robodyn_testing.original_arms import MJCF, URDF
from robodyn_testing.xacro_arms import TWO_LINKS

Capture = pytest.CaptureFixture[str]
QUICK = ("--states", "20", "--optimize", "fast")


@pytest.fixture
def folder(elsewhere: Path) -> Path:
    for name in ("mujoco", "pinocchio"):
        require_module(name)
    (elsewhere / "arm.xml").write_text(MJCF)
    (elsewhere / "arm.urdf").write_text(URDF)
    for file in ("arm.xml", "arm.urdf"):
        assert main(["import", file, "--tip", "tool", "-o", f"{Path(file).suffix[1:]}.yaml"]) == 0
    return elsewhere


@pytest.mark.parametrize(("file", "library"), [("arm.xml", "MuJoCo"), ("arm.urdf", "Pinocchio")])
def test_an_imported_arm_is_its_file(folder: Path, file: str, library: str, capsys: Capture) -> None:
    robot = f"{Path(file).suffix[1:]}.yaml"
    capsys.readouterr()
    assert main(["verify", robot, "--against", file, *QUICK, "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    rows = [row for row in report["comparisons"] if row["against"].startswith(library)]
    functions = {row["function"] for row in rows}
    assert functions >= {
        "inverse_dynamics",
        "mass_matrix",
        "forward_dynamics",
        "motion of links",
        "tool frame",
    }
    version = require_module(library.lower()).__version__
    title = f"{library} {version} reading {file}"
    assert {row["against"] for row in rows} - {title} == {f"{title}, {'site ' * (file == 'arm.xml')}tool"}
    assert ("gear ratios" in functions) == (file == "arm.xml")
    assert ("gravity" in report["skipped"]) == (file == "arm.urdf")


def test_a_wrong_number_is_exit_code_1_and_the_joint_is_named(folder: Path, capsys: Capture) -> None:
    (folder / "arm.xml").write_text(MJCF.replace('damping="0.4"', 'damping="0.5"'))
    capsys.readouterr()
    assert main(["verify", "xml.yaml", "--against", "arm.xml", *QUICK]) == 1
    out, err = capsys.readouterr()
    failed = [line for line in out.splitlines() if line.endswith("FAILED")]
    assert {line.split()[0] for line in failed} == {"inverse_dynamics", "bias", "forward_dynamics"}
    assert "most at joint 2 (j); 2 more rows differ" in err


def test_the_file_itself_and_xacro(folder: Path, capsys: Capture) -> None:
    require_module("xacro")
    (folder / "two.urdf.xacro").write_text(TWO_LINKS)
    assert main(["verify", "two.urdf.xacro", "--against", "two.urdf.xacro", *QUICK]) == 0
    assert "reading two.urdf.xacro, expanded by xacro" in capsys.readouterr().out


def test_a_library_that_is_missing_is_exit_code_3(
    folder: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    capsys.readouterr()
    monkeypatch.setitem(sys.modules, "pinocchio", None)
    assert main(["verify", "urdf.yaml", "--against", "arm.urdf", *QUICK]) == 3
    out, err = capsys.readouterr()
    assert out == ""
    assert "need pin, which is not installed; pip install pin" in err
