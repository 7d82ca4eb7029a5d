"""No command ends in an internal error on arms without gravity, of one joint, of slides alone or without
mass, nor on logs that are empty, constant, of no number, of a row, or of huge and tiny ones; and nothing
undefined looks like a result."""

from __future__ import annotations

import itertools
import json
import re
import shutil
from collections.abc import Collection, Iterable
from pathlib import Path
from typing import Any, Final

import numpy as np
import pytest
import yaml

from cli.command import Capture
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.robot import load
from robodyn_cli.main import main
from robodyn_testing.strange_arms import ARMS, arm_text
from robodyn_testing.strange_logs import LOGS, plain_log, text_of

pytestmark = pytest.mark.usefixtures("elsewhere")

#: A number that is none, but for a row's own time in the remark that it is left out.
_UNDEFINED: Final = re.compile(r"(?<![\w.+\-])(?<!t = )-?(?:nan|inf|infinity)\b", re.IGNORECASE)
OUT: Final = Path("out")
#: What a command may end with: done, or an error that is none of robodyn's.
CODES: Final = range(5)
#: Quick commands that take an arm alone, of which Q is a position.
OF_ARM = """\
flops arm.yaml --json
simulate arm.yaml -o out/log.csv --duration 0.2
export arm.yaml --to urdf -o out/arm.urdf
export arm.yaml --to mjcf -o out/arm.mjcf
export arm.yaml --to sdf -o out/arm.sdf
diff arm.yaml arm.yaml
diff arm.yaml puma560_3dof --json
ik arm.yaml --of Q --json
ik arm.yaml --pose 0.1,0.2,0.3,0,0,0
ik arm.yaml --pose 1e300,0,0,0,0,0
schedule arm.yaml -p 2 --json
schedule arm.yaml -p 2 --cut 3"""
OF_LOG = ("logs log.csv --robot arm.yaml", "logs log.csv --json")
OF_BOTH = ("identify arm.yaml log.csv -o out", "diagnose arm.yaml log.csv -o out --no-kernels")

#: Arms and logs that are tried at once, and those that CI tries; the others take longer.
QUICK_ARMS, MORE_ARMS = ("level_slide",), ("massless", "vertical_axis", "scara", "on_its_axis")
QUICK_LOGS, MORE_LOGS = ("one_row", "tiny_times", "constant"), ("nan_rates", "noise", "huge_torque", "still")


def _marked(names: Iterable[str], quick: Collection[str], more: Collection[str]) -> list[Any]:
    thorough, slow = pytest.mark.thorough, pytest.mark.slow
    return [x if x in quick else pytest.param(x, marks=thorough if x in more else slow) for x in names]


def write(arm: str, log: str = "", seed: int = 0) -> None:
    """The file of an arm in this folder, and that of a log of it."""
    Path("arm.yaml").write_text(arm_text(arm, seed))
    if log:
        columns = plain_log(load("arm.yaml", warn=lambda _: None))
        with np.errstate(all="ignore"):
            Path("log.csv").write_text(text_of(LOGS[log](columns)))


def run(capsys: Capture, command: str) -> tuple[int, str, str]:
    """Run a command; its exit code, standard output and standard error.

    Warnings are errors in tests, and an error that is none of robodyn's is exit code 70.
    """
    code = main(command.split())
    out, err = capsys.readouterr()
    assert code in CODES, (command, err)
    assert "Traceback" not in err
    assert not _UNDEFINED.search(out), (command, out)
    if code == 2:
        assert err.strip(), command
        assert not OUT.exists()
    for path in OUT.rglob("*"):
        if path.suffix in (".json", ".yaml", ".csv"):
            assert not _UNDEFINED.search(path.read_text()), (command, path)
    shutil.rmtree(OUT, ignore_errors=True)
    return code, out, err


@pytest.mark.parametrize("arm", _marked(ARMS, QUICK_ARMS, MORE_ARMS))
def test_commands_of_an_arm(arm: str, capsys: Capture) -> None:
    write(arm)
    for command in OF_ARM.replace("Q", ",".join(["0.1"] * len(ARMS[arm]))).splitlines():
        assert run(capsys, command)[0] in CODES


@pytest.mark.parametrize("arm", ["level_slide", pytest.param("scara", marks=pytest.mark.slow)])
def test_what_is_in_a_log(arm: str, capsys: Capture) -> None:
    for log in LOGS:
        write(arm, log)
        for command in OF_LOG:
            assert run(capsys, command)[0] in CODES


@pytest.mark.parametrize("log", _marked(LOGS, QUICK_LOGS, MORE_LOGS))
def test_logs_of_an_arm_without_gravity(log: str, capsys: Capture) -> None:
    write("level_slide", log)
    for command in OF_BOTH:
        assert run(capsys, command)[0] in CODES


@pytest.mark.parametrize("arm", _marked(("massless", "on_its_axis", "gantry"), ("massless",), ()))
def test_kernels_agree_where_all_torques_are_zero(arm: str, capsys: Capture) -> None:
    names = "jacobian,tool_jacobian,jacobian_dot_qd,regressor,controller"
    write(arm)
    code, _, err = run(capsys, f"verify arm.yaml --states 5 --functions {names}")
    assert code in (0, 3), err  # 3: no compiler


@pytest.mark.thorough
def test_every_function(capsys: Capture) -> None:
    write("massless")
    for function in FUNCTIONS:
        assert run(capsys, f"gen arm.yaml -o out --functions {function}")[0] in CODES


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(1, 4))
@pytest.mark.parametrize("arm", ARMS)
def test_everything(arm: str, seed: int, capsys: Capture) -> None:
    write(arm, seed=seed)
    for command in OF_ARM.replace("Q", ",".join(["0.1"] * len(ARMS[arm]))).splitlines():
        assert run(capsys, command)[0] in CODES
    for function in FUNCTIONS:
        assert run(capsys, f"gen arm.yaml -o out --functions {function}")[0] in CODES
    for log, command in itertools.product(LOGS, (*OF_LOG, *OF_BOTH)):
        write(arm, log, seed)
        assert run(capsys, command)[0] in CODES


# --- what is said ----------------------------------------------------------------------------------------


def test_a_column_without_a_number_is_not_observed(capsys: Capture) -> None:
    write("two_planar", "nan_column")
    _, out, _ = run(capsys, OF_LOG[0])
    assert "not observed, no number in them: q1" in out
    assert "joint 1: no numbers" in out
    _, text, _ = run(capsys, f"{OF_LOG[0]} --json")
    first = json.loads(text)["checks"][0]
    assert (first["low"], first["high"], first["correlation"]) == (None, None, None)


@pytest.mark.parametrize(
    ("arm", "log", "message"),
    [
        ("two_planar", "one_row", "the log is too short to diagnose"),
        ("two_planar", "nan_times", "t cannot be used"),
        ("two_planar", "tiny_times", "the samples are too close together for a time in seconds"),
        ("two_planar", "nan_column", "q1 cannot be used"),
        ("level_slide", "plain", "the torque of joint 1 is not observed"),
    ],
)
def test_what_cannot_be_used_is_refused(arm: str, log: str, message: str, capsys: Capture) -> None:
    write(arm, log)
    if log == "plain":
        robot = yaml.safe_load(Path("arm.yaml").read_text())
        robot["links"][0]["effects"] = [{"effect": "torque_gain", "gain": -1}]
        Path("arm.yaml").write_text(yaml.safe_dump(robot))
    for command in OF_BOTH:
        code, _, err = run(capsys, command)
        assert (code, message in err) == (2, True), err


def test_numbers_that_do_not_show_are_not_identified(capsys: Capture) -> None:
    write("level_slide", "still")
    code, _, err = run(capsys, OF_BOTH[0])
    assert code == 2
    assert "none of level_slide's numbers shows in the logs" in err
