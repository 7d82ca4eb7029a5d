"""What a newcomer sees first: no warning, and no line that his terminal breaks."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from robodyn.robot import bundled_names
from robodyn_cli.common import WIDTH
from robodyn_cli.main import main
from robodyn_testing import sampled

Capture = pytest.CaptureFixture[str]
pytestmark = pytest.mark.usefixtures("elsewhere")


def checked(capsys: Capture, *arguments: str) -> str:
    """The output of the command, which warns of nothing and has no long line."""
    assert main(list(arguments)) == 0
    out, err = capsys.readouterr()
    assert "warning" not in err
    long = [line for line in (out + err).splitlines() if len(line) > WIDTH]
    assert not long
    return out


def test_the_first_command_is_quiet_and_narrow(capsys: Capture) -> None:
    makefile = Path(__file__).parents[2].joinpath("Makefile").read_text(encoding="utf-8")
    name = re.search(r"(?m)^ROBOT \?= (\S+)$", makefile)
    assert name
    assert "robodyn gen $(ROBOT) --compile" in makefile
    out = checked(capsys, "gen", name[1], "--compile", "--lang", "c")
    assert "c: compiled with " in out


@pytest.mark.parametrize("robot", sampled(bundled_names(), every=5))
def test_every_bundled_robot_is(capsys: Capture, robot: str) -> None:
    out = checked(capsys, "gen", robot)
    assert f"{robot}.h" in out
    assert f"{robot}.f90" in out
    checked(capsys, "flops", robot)


def test_notes_are_whole_though_broken(capsys: Capture) -> None:
    out = " ".join(checked(capsys, "flops", "puma560").split())
    assert "thesis: Table 2.10, puma_6: counts the listing of appendix D.3.4 as printed" in out
    assert out.endswith("lambda_1 p_1 are left out of it")
    for arguments in (("robots",), ("verify", "puma560_3dof", "--states", "20")):
        checked(capsys, *arguments)
