"""``--arg`` and ``--model`` of every command that takes a ROBOT, and what a project cannot state."""

from __future__ import annotations

from pathlib import Path

import click
import pytest

from robodyn_cli.choices import ROBOTS
from robodyn_cli.main import COMMANDS, cli, main
from robodyn_testing import require_module
from robodyn_testing.xacro_arms import HEAD, PACKAGE, arm, write

FILES = {
    "arm/arm.xacro": arm(
        '<xacro:arg name="m" default="1"/><xacro:property name="m" value="$(arg m)"/>'
        '<xacro:include filename="$(find more)/more.xacro"/>'
    ),
    "arm/more.xacro": f"{HEAD}</robot>",
    "arm/package.xml": PACKAGE % "more",
    "far/more.xacro": f'{HEAD}<xacro:property name="m" value="$(env MASS)"/></robot>',
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    require_module("xacro")
    write(tmp_path, FILES)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_every_command_that_takes_a_robot_has_the_options() -> None:
    context = click.Context(cli)
    commands = [cli.get_command(context, name) for name in COMMANDS]
    takers = [each for each in commands if each and any(option.type is ROBOTS for option in each.params)]
    assert len(takers) > 15
    for command in takers:
        options = [option for each in command.params for option in each.opts]
        assert [options.count(name) for name in ("--arg", "--model", "--massless")] == [1, 1, 1], command.name


def test_arguments_reach_every_reading_of_the_file(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write(folder, {"five/arm.xacro": FILES["arm/arm.xacro"].replace('default="1"', 'default="5"')})
    stated = ["--arg", "find more=arm"]
    assert main(["diff", "arm/arm.xacro", "five/arm.xacro", "--ignore", "names", *stated]) == 1
    assert "mass" in capsys.readouterr().out
    assert (
        main(["diff", "arm/arm.xacro", "five/arm.xacro", "--ignore", "names", *stated, "--arg", "m=3"]) == 0
    )


def test_a_package_and_a_variable_are_stated(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    stated = ["--arg", "find more=far", "--arg", "env MASS=7"]
    assert main(["import", "arm/arm.xacro", *stated]) == 0
    assert "mass: 7" in capsys.readouterr().out
    assert main(["import", "arm/arm.xacro", *stated[:2]]) == 2
    assert "MASS is not read; state it: --arg 'env MASS=VALUE'" in capsys.readouterr().err


def test_a_project_states_nothing(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Nobody who proposes a robodyn.toml opens folders or variables by it."""
    (folder / "robodyn.toml").write_text('[robots.arm]\nrobot = "arm/arm.xacro"\narg = ["find more=/"]\n')
    assert main(["build", "--check"]) == 2
    assert "arg" in capsys.readouterr().err


@pytest.mark.parametrize("command", ["gen", "flops", "import", "build"])
def test_no_command_runs_what_a_file_says(
    command: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = "python['vars'](python['type'](xacro.load_yaml))['__globals__']"
    (folder / "bad.xacro").write_text(f'{HEAD}<link name="${{{text}}}"/></robot>')
    (folder / "robodyn.toml").write_text('[robots.bad]\nrobot = "bad.xacro"\n')
    files = sorted(folder.rglob("*"))
    assert main(["build", "--check"] if command == "build" else [command, "bad.xacro"]) == 2
    assert "name 'vars' is not defined" in capsys.readouterr().err
    assert sorted(folder.rglob("*")) == files
