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

import pytest

from robodyn.errors import InputError
from robodyn.formats.arm import import_arm
from robodyn.formats.loading import load
from robodyn.robot import DoubtfulRobot, read_text, to_yaml
from robodyn.robot.account import account_lines, account_to_dict
from robodyn_cli.choices import ROBOTS
from robodyn_cli.main import COMMANDS, cli, main
from robodyn_testing.urdf_text import joint, link, robot

Capture = pytest.CaptureFixture[str]

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
WITHOUT = ("--without", "transmission")
#: A quick call of each command that takes a robot, without the robot and ``--json``.
CALLS = {
    "gen": ("-o", "out"),
    "package": ("--as", "cmake", "-o", "out"),
    "flops": (),
    "schedule": ("-p", "2"),
    "plan": ("--deadline", "100us"),
    "bench": (),
    "ik": ("--of", "0.1,0.2"),
    "simulate": ("-o", "log.csv", "--duration", "0.5"),
    "diagnose": ("hidden/train.csv", "-o", "out", "--no-kernels", "--only", "payload", "--joints", "2"),
    "logs": (),
    "identify": ("hidden/train.csv", "-o", "out"),
    "hide": ("-o", "out"),
    "excite": ("-o", "out"),
    "verify": (),
    "prove": ("--only", "stack", "-o", "out"),
    "export": ("--to", "urdf", "-o", "out.urdf"),
    "diff": ("arm.urdf",),
    "report": ("-o", "out.html"),
}
#: Those that take seconds.
SLOW = ("bench", "diagnose", "identify", "excite")

#: What writes files that people read: without the robot and ``-o``.
WRITTEN = [
    "gen --lang c,fortran,rust,javascript",
    "gen --batch --latex",
    "gen --firmware",
    "schedule -p 2 --packed 4",
    "export --to mjcf",
    "report",
    "package --as cmake",
    pytest.param("package --as wheel", marks=pytest.mark.thorough),  # these two are compiled
    pytest.param("package --as fmu", marks=pytest.mark.thorough),
]
#: The ends of files that have room for it; of those in archives others come from elsewhere.
ROOM = (".c", ".h", ".f90", ".rs", ".mjs", ".tex", ".md", ".xml", ".html")
ROOM_IN_ARCHIVES = ("/METADATA", "modelDescription.xml", ".py", ".pyi", "arm.h", "arm.c")


@pytest.fixture
def folder(elsewhere: Path) -> Path:
    (elsewhere / "arm.urdf").write_text(ARM)
    return elsewhere


def notes_of(err: str, file: str) -> list[str]:
    """What stderr says of the file."""
    head = f"robodyn: note: {file}: "
    return [line.removeprefix(head) for line in err.splitlines() if line.startswith(head)]


def lines_of(file: str) -> list[str]:
    account = import_arm(file, without=["transmission"]).robot.account
    assert account is not None
    assert account.left_out
    assert account.decided
    assert account.not_used
    return list(account.lines())


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
    commands = (cli.get_command(None, name) for name in COMMANDS)  # type: ignore[arg-type]
    takes = [
        name
        for name, command in zip(COMMANDS, commands, strict=True)
        if command is not None and any(parameter.type is ROBOTS for parameter in command.params)
    ]
    assert takes == list(CALLS)


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.thorough) if n in SLOW else n for n in CALLS]
)
def test_a_command_tells_what_is_left_out(name: str, folder: Path, capsys: Capture) -> None:
    robot_words = ("log.csv", "--robot", "arm.urdf") if name == "logs" else ("arm.urdf",)
    if name == "logs":
        assert main(["simulate", "arm.urdf", *WITHOUT, *CALLS["simulate"]]) == 0
    if name in ("diagnose", "identify"):
        assert main(["hide", "arm.urdf", *WITHOUT, "-o", "hidden"]) == 0
    capsys.readouterr()
    assert main([name, *robot_words, *CALLS[name], *WITHOUT, "--json"]) in (0, 1, 4)
    out, err = capsys.readouterr()
    arms = 2 if name == "diff" else 1
    assert notes_of(err, "arm.urdf") == lines_of("arm.urdf") * arms
    wanted = account_to_dict(import_arm("arm.urdf", without=["transmission"]).robot)
    assert {json.dumps(account) for account in accounts(json.loads(out))} == {json.dumps(wanted)}
    assert main([name, *robot_words, *CALLS[name], "--json"]) == 2  # where nothing may be left out


def test_a_description_that_was_imported_tells_it_again(folder: Path, capsys: Capture) -> None:
    assert main(["import", "arm.urdf", *WITHOUT, "--json"]) == 0
    out, err = capsys.readouterr()
    assert notes_of(err, "arm.urdf") == lines_of("arm.urdf")
    assert accounts(json.loads(out))[0]["imported"]["left_out"]
    assert main(["import", "arm.urdf", *WITHOUT, "-o", "arm.yaml"]) == 0
    capsys.readouterr()
    assert main(["flops", "arm.yaml", "--json"]) == 0
    out, err = capsys.readouterr()
    assert notes_of(err, "arm.yaml") == [line for line in lines_of("arm.urdf") if line.startswith("left out")]
    assert accounts(json.loads(out)) == [
        account_to_dict(import_arm("arm.urdf", without=["transmission"]).robot)
    ]


@pytest.mark.parametrize("first", [True, False], ids=["generated", "in the store"])
def test_a_build_tells_it_of_each_robot(first: bool, folder: Path, capsys: Capture) -> None:
    Path("robodyn.toml").write_text('[robots.arm]\nrobot = "arm.urdf"\nwithout = ["transmission"]\n')
    if not first:
        assert main(["build"]) == 0
        capsys.readouterr()
    assert main(["build", "--json"]) == 0
    out, err = capsys.readouterr()
    assert notes_of(err, "arm.urdf") == lines_of("arm.urdf")
    assert accounts(json.loads(out)) == [
        account_to_dict(import_arm("arm.urdf", without=["transmission"]).robot)
    ]


@pytest.mark.parametrize("written", WRITTEN)
def test_files_and_pages_say_it(written: str, folder: Path) -> None:
    command, *options = written.split()
    file = {"export": "arm.xml", "report": "arm.html"}.get(command, "")
    assert main([command, "arm.urdf", *WITHOUT, *options, "-o", f"out/{file}"]) == 0
    texts = dict(texts_in(Path("out")))
    assert texts
    for name, text in texts.items():
        words = " ".join(re.sub(r"\\(?=\W)|\*|!|//|#|%", " ", html.unescape(text)).split())
        for line in account_lines(import_arm("arm.urdf", without=["transmission"]).robot):
            assert line.split("(")[0].strip() in words, (name, line)


def test_python_warns_of_what_may_change_numbers_and_has_all(folder: Path) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        account = load("arm.urdf", without=["transmission"]).account
    (left_out,) = [line for line in lines_of("arm.urdf") if line.startswith("left out")]
    assert [(str(one.message), one.category) for one in caught] == [(f"arm.urdf: {left_out}", DoubtfulRobot)]
    assert account is not None
    assert list(account.lines()) == lines_of("arm.urdf")
    notes: list[str] = []
    load("arm.urdf", without=["transmission"], note=notes.append)
    assert notes == [f"arm.urdf: {line}" for line in lines_of("arm.urdf")]


def test_robots_of_which_something_was_left_out_are_not_the_same(folder: Path, capsys: Capture) -> None:
    assert main(["diff", "arm.urdf", "arm.urdf", *WITHOUT]) == 0
    out = capsys.readouterr().out.splitlines()
    assert [line.split(":")[0] for line in out[-3:]] == [
        "not compared",
        "not compared",
        "nothing that was compared differs",
    ]


def test_an_account_reads_back(folder: Path) -> None:
    arm = import_arm("arm.urdf", without=["transmission"]).robot
    assert read_text(to_yaml(arm)).account == arm.account


@pytest.mark.parametrize(
    "imported",
    ["{file: a.urdf}", "{file: a.urdf, format: URDF, left_out: gravity}", '{file: "\\u202e", format: URDF}',
     "{file: a.urdf, format: URDF, decided: [[1]]}", "{file: a.urdf, format: URDF, unknown: [a]}",
     '{file: a.urdf, format: URDF, not_used: ["a\\u0007"]}'],
)  # fmt: skip
def test_an_account_that_is_none_is_refused(imported: str) -> None:
    with pytest.raises(InputError):
        read_text(f"name: arm\nimported: {imported}\nlinks: [{{mass: 1}}]\n")
