"""No command ends in an internal error on arms without gravity, of one joint, of slides alone or without
mass, nor on logs that are empty, constant, of no number, of a row, or of huge and tiny ones."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterable
from pathlib import Path
from typing import Any

import pytest
import yaml

from cli.strange import (
    Capture,
    commands_of_arm,
    commands_of_log,
    joints_of,
    run,
    write_arm,
    write_log,
)
from robodyn.dynamics.functions import FUNCTIONS
from robodyn_testing.strange_arms import ARMS
from robodyn_testing.strange_logs import LOGS

#: Arms and logs that are tried at once, and those that CI tries; the others take longer.
QUICK_ARMS = ("level_slide", "massless")
MORE_ARMS = (
    "vertical_axis", "gantry", "points_on_axes", "scara", "coaxial", "on_its_axis", "turn_then_slide",
)  # fmt: skip
QUICK_LOGS = ("one_row", "nan_times", "tiny_times", "constant")
MORE_LOGS = (
    "tiny_torque", "noise", "zero", "still", "tiny_motion", "steps", "huge_torque", "bursts", "nan_rates",
    "no_torque", "inf_time",
)  # fmt: skip


def _marked(names: Iterable[str], quick: Collection[str], more: Collection[str]) -> list[Any]:
    thorough, slow = pytest.mark.thorough, pytest.mark.slow
    return [x if x in quick else pytest.param(x, marks=thorough if x in more else slow) for x in names]


@pytest.mark.parametrize("arm", _marked(ARMS, QUICK_ARMS, MORE_ARMS))
def test_commands_of_an_arm(arm: str, elsewhere: Path, capsys: Capture) -> None:
    file = write_arm(arm)
    for words in commands_of_arm(file, joints_of(arm)):
        run(capsys, *words)


@pytest.mark.parametrize("arm", ["level_slide", pytest.param("scara", marks=pytest.mark.thorough)])
def test_what_is_in_a_log(arm: str, elsewhere: Path, capsys: Capture) -> None:
    file = write_arm(arm)
    for log in LOGS:
        for words in commands_of_log(file, write_log(file, log))[:2]:
            run(capsys, *words)


@pytest.mark.parametrize("log", _marked(LOGS, QUICK_LOGS, MORE_LOGS))
def test_logs_of_an_arm_without_gravity(log: str, elsewhere: Path, capsys: Capture) -> None:
    file = write_arm("level_slide")
    name = write_log(file, log)
    for words in commands_of_log(file, name)[2:]:
        run(capsys, *words)


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("arm", "seed", "log"),
    [("on_its_axis", 0, "tiny_torque"), ("rotors_alone", 0, "still"), ("massless_tip", 2, "constant")],
)
def test_logs_of_other_arms(arm: str, seed: int, log: str, elsewhere: Path, capsys: Capture) -> None:
    file = write_arm(arm, seed)
    name = write_log(file, log)
    for words in commands_of_log(file, name)[2:]:
        run(capsys, *words)


@pytest.mark.parametrize(
    "arm", _marked(("massless", "on_its_axis", "gantry"), ("massless",), ("on_its_axis", "gantry"))
)
def test_kernels_agree_where_all_torques_are_zero(arm: str, elsewhere: Path, capsys: Capture) -> None:
    names = "jacobian,tool_jacobian,jacobian_dot_qd,regressor,controller"
    code, _, err = run(capsys, "verify", write_arm(arm), "--states", "5", "--functions", names)
    assert code in (0, 3), err  # 3: no compiler


@pytest.mark.thorough
@pytest.mark.parametrize("arm", ["massless", "gantry"])
def test_every_function(arm: str, elsewhere: Path, capsys: Capture) -> None:
    file = write_arm(arm)
    for function in FUNCTIONS:
        run(capsys, "gen", file, "-o", "out", "--functions", function)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(1, 4))
@pytest.mark.parametrize("arm", ARMS)
def test_everything(arm: str, seed: int, elsewhere: Path, capsys: Capture) -> None:
    file = write_arm(arm, seed)
    for words in commands_of_arm(file, joints_of(arm)):
        run(capsys, *words)
    for function in FUNCTIONS:
        run(capsys, "gen", file, "-o", "out", "--functions", function)
    for log in LOGS:
        name = write_log(file, log)
        for words in commands_of_log(file, name):
            run(capsys, *words)


# --- what is said ----------------------------------------------------------------------------------------


def test_a_column_without_a_number_is_not_observed(elsewhere: Path, capsys: Capture) -> None:
    file = write_arm("two_planar")
    log = write_log(file, "nan_column")
    code, out, _ = run(capsys, "logs", log, "--robot", file)
    assert code == 0
    assert "not observed, no number in them: q1" in out
    assert "joint 1: no numbers" in out
    _, text, _ = run(capsys, "logs", log, "--json", "--robot", file)
    first = json.loads(text)["checks"][0]
    assert first["low"] is None
    assert first["high"] is None
    assert first["correlation"] is None


@pytest.mark.parametrize(
    ("log", "message"),
    [
        ("one_row", "the log is too short to diagnose"),
        ("nan_times", "t cannot be used"),
        ("tiny_times", "the samples are too close together for a time in seconds"),
        ("nan_column", "q1 cannot be used"),
    ],
)
@pytest.mark.parametrize("command", ["diagnose", "identify"])
def test_what_cannot_be_used_is_refused(
    command: str, log: str, message: str, elsewhere: Path, capsys: Capture
) -> None:
    file = write_arm("two_planar")
    out = "--output" if command == "diagnose" else "-o"
    code, _, err = run(capsys, command, file, write_log(file, log), out, "out")
    assert code == 2
    assert message in err


def test_numbers_that_do_not_show_are_not_identified(elsewhere: Path, capsys: Capture) -> None:
    file = write_arm("level_slide")
    code, _, err = run(capsys, "identify", file, write_log(file, "still"), "-o", "out")
    assert code == 2
    assert "none of level_slide's numbers shows in the logs" in err


def test_a_torque_of_which_nothing_is_measured_is_not_observed(elsewhere: Path, capsys: Capture) -> None:
    file = write_arm("level_slide")
    log = write_log(file, "plain")
    robot = yaml.safe_load(Path(file).read_text())
    robot["links"][0]["effects"] = [{"effect": "torque_gain", "gain": -1}]
    Path(file).write_text(yaml.safe_dump(robot))
    for command, out in (("identify", "-o"), ("diagnose", "--output")):
        code, _, err = run(capsys, command, file, log, out, "out")
        assert code == 2
        assert "the torque of joint 1 is not observed" in err
