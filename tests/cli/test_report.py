"""``robodyn report`` and ``robodyn tables``; and what a newcomer sees first: no warning, no line too long."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from cli.command import Capture, run, run_json
from robodyn.robot import bundled_names
from robodyn.thesis import tables as rooms
from robodyn.thesis.tables import TABLE_IDS, make, to_text
from robodyn_cli.output import WIDTH

pytestmark = pytest.mark.usefixtures("elsewhere")


def test_a_page_is_written(capsys: Capture) -> None:
    assert run(capsys, "report stanford_3dof -o pages") == ("", "robodyn: wrote pages/stanford_3dof.html\n")
    (file,) = Path("pages").iterdir()
    assert file.read_text(encoding="utf-8").startswith("<!doctype html>")


def test_a_page_of_two_arms_and_their_differences(capsys: Capture) -> None:
    data = run_json(capsys, "report stanford_3dof stanford_3dof_d3 -o both.html")
    assert [robot["robot"] for robot in data["robots"]] == ["stanford_3dof", "stanford_3dof_d3"]
    assert not data["comparison"]["same"]
    text = Path("both.html").read_text(encoding="utf-8")
    assert text.count('type="module"') == 3
    assert "stanford_3dof_d3_inverse_dynamics" in text


def test_json_alone_writes_nothing(elsewhere: Path, capsys: Capture) -> None:
    (elsewhere / "arm.yaml").write_text(
        "name: arm\nlinks: [{joint: revolute, mass: m_tool, com: [1, 0, 0]}]\n"
    )
    data = run_json(capsys, "report arm.yaml --param m_tool=2")
    assert (data["home"]["torque"], data["links"][0]["mass"]) == ([0.0], 2.0)
    assert [file.name for file in elsewhere.iterdir()] == ["arm.yaml"]


def test_tables(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    table = make("4.4")
    assert run(capsys, "tables 4.4") == (to_text(table), "")
    assert run_json(capsys, "tables 4.4") == table.to_dict()
    monkeypatch.setattr("robodyn.thesis.tables.pictures.operations_svg", lambda: "<svg/>\n")
    out, err = run(capsys, "tables 2.9 --picture new/figure.svg")
    assert out == to_text(make("2.9"))
    assert "wrote" in err
    assert Path("new/figure.svg").read_text() == "<svg/>\n"
    asked = []

    def quick(name: str, progress: object) -> rooms.Table:
        asked.append(name)
        return table

    monkeypatch.setattr(rooms, "make", quick)
    assert run(capsys, "tables") == ("\n".join([to_text(table)] * len(TABLE_IDS)), "")
    assert tuple(asked) == TABLE_IDS
    assert json.loads(run(capsys, "tables --json")[0]) == [table.to_dict()] * len(TABLE_IDS)


def checked(capsys: Capture, command: str) -> str:
    """The output of the command, which warns of nothing and has no long line."""
    out, err = run(capsys, command)
    assert "warning" not in err
    assert not [line for line in (out + err).splitlines() if len(line) > WIDTH]
    return out


def test_the_first_command_is_quiet_and_narrow(capsys: Capture) -> None:
    makefile = Path(__file__).parents[2].joinpath("Makefile").read_text(encoding="utf-8")
    name = re.search(r"(?m)^ROBOT \?= (\S+)$", makefile)
    assert name
    assert "robodyn gen $(ROBOT) --compile" in makefile
    assert "c: compiled with " in checked(capsys, f"gen {name[1]} --compile --lang c")


def test_so_is_an_arm_of_a_long_name(capsys: Capture) -> None:
    robot = max(bundled_names(), key=len)
    assert f"{robot}.f90" in checked(capsys, f"gen {robot}")
    checked(capsys, f"flops {robot}")


def test_notes_are_whole_though_broken(capsys: Capture) -> None:
    out = " ".join(checked(capsys, "flops puma560").split())
    assert "thesis: Table 2.10, puma_6: counts the listing of appendix D.3.4 as printed" in out
    assert out.endswith("lambda_1 p_1 are left out of it")
    for command in ("robots", "verify puma560_3dof --states 20"):
        checked(capsys, command)
