"""What is left out of a file, and where numbers come from, is told by every command that takes a robot."""

from __future__ import annotations

import html
import json
import re
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import click
import pytest

from cli.command import Capture, run
from robodyn.errors import InputError
from robodyn.formats.arm import import_arm
from robodyn.formats.loading import load
from robodyn.robot import DoubtfulRobot, Robot, read_text, to_yaml
from robodyn.robot.account import Account, account_lines, account_to_dict
from robodyn_cli.choices import ROBOTS
from robodyn_cli.main import COMMANDS, cli, main
from robodyn_testing import representative
from robodyn_testing.urdf_text import joint, link, robot

LIMIT = '<limit lower="-2" upper="2" velocity="2" effort="{}"/>'
#: An arm of which something is left out, something is decided, and something is not used.
ARM = robot(
    link("base"),
    link("a", link("x")[15:-7] + "<visual/>"),
    link("b"),
    joint("one", "base", "a", "revolute", '<dynamics damping="0.5" friction="0.4"/>' + LIMIT.format(50)),
    joint("two", "a", "b", "revolute", '<axis xyz="0 1 0"/>' + LIMIT.format(0)),
    '<transmission name="t"><type>transmission_interface/SimpleTransmission</type><joint name="other"/>'
    '<actuator name="m"><mechanicalReduction>50</mechanicalReduction></actuator></transmission>',
)
WITHOUT = " --without transmission"
#: A quick call of each command that takes a robot, but for --json.
CALLS = {
    "gen": "arm.urdf -o out",
    "package": "arm.urdf --as cmake -o out",
    "flops": "arm.urdf",
    "schedule": "arm.urdf -p 2",
    "plan": "arm.urdf --deadline 100us",
    "bench": "arm.urdf -p 1 --states 100",
    "ik": "arm.urdf --of 0.1,0.2",
    "simulate": "arm.urdf -o log.csv --duration 0.1",
    "diagnose": "arm.urdf hidden/train.csv -o out --no-kernels --only payload --joints 2",
    "logs": "log.csv --robot arm.urdf",
    "identify": "arm.urdf hidden/train.csv -o out",
    "hide": "arm.urdf -o out --duration 2 --rate 200",
    "excite": "arm.urdf -o out --tries 1 --harmonics 2 --duration 2",
    "verify": "arm.urdf --states 5",
    "prove": "arm.urdf --only stack -o out",
    "export": "arm.urdf --to urdf -o out.urdf",
    "diff": "arm.urdf arm.urdf",
    "report": "arm.urdf -o out.html",
}
#: What is to be there before, for those that read logs.
BEFORE = {"logs": "simulate", **dict.fromkeys(("diagnose", "identify"), "hide")}
#: What writes files that people read: without the robot and ``-o``. The last two are compiled.
WRITTEN = [
    "gen --lang c,fortran,rust,javascript,cuda", "gen --batch --latex", "gen --firmware",
    "schedule -p 2 --packed 4", "export --to mjcf", "report", "package --as cmake",
    "package --as wheel", "package --as fmu",
]  # fmt: skip
#: The ends of files that have room for it; of those in archives others come from elsewhere.
ROOM = (".c", ".h", ".cu", ".cuh", ".f90", ".rs", ".mjs", ".tex", ".md", ".xml", ".html")
ROOM_IN_ARCHIVES = ("/METADATA", "modelDescription.xml", ".py", ".pyi", "arm.h", "arm.c")


@pytest.fixture
def arm(elsewhere: Path) -> Robot:
    (elsewhere / "arm.urdf").write_text(ARM)
    return import_arm("arm.urdf", without=["transmission"]).robot


def lines_of(arm: Robot) -> list[str]:
    assert isinstance(arm.account, Account)
    assert arm.account.left_out
    assert arm.account.decided
    assert arm.account.not_used
    return list(arm.account.lines())


def notes_of(err: str, file: str) -> list[str]:
    """What stderr says of the file."""
    head = f"robodyn: note: {file}: "
    return [line.removeprefix(head) for line in err.splitlines() if line.startswith(head)]


def texts_in(folder: Path) -> Iterator[tuple[str, str]]:
    """The files that have room for what is known of the arm, those in archives too: name and text."""
    for path in folder.rglob("*"):
        if path.suffix in ROOM:
            yield path.name, path.read_text()
        elif path.suffix in (".whl", ".fmu"):
            with ZipFile(path) as archive:
                for name in archive.namelist():
                    if name.endswith(ROOM_IN_ARCHIVES):
                        yield name, archive.read(name).decode()


def accounts(data: Any) -> list[dict[str, Any]]:
    """All accounts in a JSON document, wherever they stand."""
    if isinstance(data, dict):
        rest = [account for key, value in data.items() if key != "account" for account in accounts(value)]
        return [*data.get("account", []), *rest]
    return [account for each in data for account in accounts(each)] if isinstance(data, list) else []


def test_the_calls_are_those_of_all_commands_that_take_a_robot() -> None:
    context = click.Context(cli)
    commands = {name: cli.get_command(context, name) for name in COMMANDS}
    assert set(CALLS) == {
        name for name, each in commands.items() if each and any(p.type is ROBOTS for p in each.params)
    }


@pytest.mark.parametrize(
    "name", representative(CALLS, "gen", "flops", "schedule", "logs", "simulate", "diff", "report")
)
def test_a_command_tells_what_is_left_out(name: str, arm: Robot, capsys: Capture) -> None:
    if name in BEFORE:
        before = CALLS[BEFORE[name]].replace("-o out", "-o hidden")
        run(capsys, f"{BEFORE[name]} {before}{WITHOUT}")
    capsys.readouterr()
    assert main(f"{name} {CALLS[name]}{WITHOUT} --json".split()) in (0, 1, 4)
    out, err = capsys.readouterr()
    assert notes_of(err, "arm.urdf") == lines_of(arm) * (2 if name == "diff" else 1)
    wanted = json.dumps(account_to_dict(arm))
    assert {json.dumps(account) for account in accounts(json.loads(out))} == {wanted}
    run(capsys, f"{name} {CALLS[name]} --json", code=2)  # where nothing may be left out


def test_a_description_that_was_imported_tells_it_again(arm: Robot, capsys: Capture) -> None:
    out, err = run(capsys, f"import arm.urdf{WITHOUT} --json")
    assert notes_of(err, "arm.urdf") == lines_of(arm)
    assert accounts(json.loads(out))[0]["imported"]["left_out"]
    run(capsys, f"import arm.urdf{WITHOUT} -o arm.yaml")
    out, err = run(capsys, "flops arm.yaml --json")
    assert notes_of(err, "arm.yaml") == [line for line in lines_of(arm) if line.startswith("left out")]
    assert accounts(json.loads(out)) == [account_to_dict(arm)]


def test_a_build_tells_it_of_each_robot(arm: Robot, capsys: Capture) -> None:
    """Whether it is generated or in the store."""
    Path("robodyn.toml").write_text('[robots.arm]\nrobot = "arm.urdf"\nwithout = ["transmission"]\n')
    for _ in range(2):
        out, err = run(capsys, "build --json")
        assert notes_of(err, "arm.urdf") == lines_of(arm)
        assert accounts(json.loads(out)) == [account_to_dict(arm)]


@pytest.mark.parametrize("written", representative(WRITTEN, WRITTEN[0], WRITTEN[5], WRITTEN[6]))
def test_files_and_pages_say_it(written: str, arm: Robot, capsys: Capture) -> None:
    command, _, options = written.partition(" ")
    file = {"export": "arm.xml", "report": "arm.html"}.get(command, "")
    run(capsys, f"{command} arm.urdf{WITHOUT} {options} -o out/{file}")
    texts = dict(texts_in(Path("out")))
    assert texts
    for name, text in texts.items():
        words = " ".join(re.sub(r"\\(?=\W)|\*|!|//|#|%", " ", html.unescape(text)).split())
        for line in account_lines(arm):
            assert line.split("(")[0].strip() in words, (name, line)


def test_python_warns_of_what_may_change_numbers_and_has_all(arm: Robot) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        assert load("arm.urdf", without=["transmission"]).account == arm.account
    (left_out,) = [line for line in lines_of(arm) if line.startswith("left out")]
    assert [(str(one.message), one.category) for one in caught] == [(f"arm.urdf: {left_out}", DoubtfulRobot)]
    notes: list[str] = []
    load("arm.urdf", without=["transmission"], note=notes.append)
    assert notes == [f"arm.urdf: {line}" for line in lines_of(arm)]


def test_robots_of_which_something_was_left_out_are_not_the_same(arm: Robot, capsys: Capture) -> None:
    out = run(capsys, f"diff arm.urdf arm.urdf{WITHOUT}")[0].splitlines()
    heads = ["not compared", "not compared", "nothing that was compared differs"]
    assert [line.split(":")[0] for line in out[-3:]] == heads


def test_an_account_reads_back(arm: Robot) -> None:
    assert read_text(to_yaml(arm)).account == arm.account
    for imported in (
        "{file: a.urdf}", "{file: a.urdf, format: URDF, left_out: gravity}",
        '{file: "\\u202e", format: URDF}', "{file: a.urdf, format: URDF, decided: [[1]]}",
        "{file: a.urdf, format: URDF, unknown: [a]}", '{file: a.urdf, format: URDF, not_used: ["a\\u0007"]}',
    ):  # fmt: skip
        with pytest.raises(InputError):
            read_text(f"name: arm\nimported: {imported}\nlinks: [{{mass: 1}}]\n")
