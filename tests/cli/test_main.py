"""The frame of the command line: exit codes, one line an error, lazy loading, help."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from typing import IO

import click
import pytest

from robodyn.errors import CheckError, InputError, Place, ToolError
from robodyn_cli import main as frame
from robodyn_cli.failures import guard
from robodyn_cli.main import COMMANDS, main, module_of

HEAVY = {"numpy", "sympy", "jinja2", "yaml", "cffi", "json", "scipy", "matplotlib"}


def loaded_after(code: str) -> set[str]:
    """The modules that a fresh interpreter has loaded once it has run `code`."""
    script = f"import sys\n{code}\nprint(*sys.modules, file=sys.stderr)"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    return set(run.stderr.split())


def robodyn(*arguments: str, stdout: IO[str] | int = subprocess.PIPE) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "robodyn", *arguments]
    return subprocess.run(command, stdout=stdout, stderr=subprocess.PIPE, text=True, check=False)


def shell(command: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run `command`, redirections and all, with DIR standing for `folder`."""
    text = f"{shlex.quote(sys.executable)} -m robodyn {command.replace('DIR', shlex.quote(str(folder)))}"
    return subprocess.run(["sh", "-c", text], capture_output=True, text=True, check=False)


class TestGuard:
    @pytest.mark.parametrize(
        ("error", "code", "text"),
        [
            (CheckError("the budget is exceeded"), 1, "robodyn: error: the budget is exceeded\n"),
            (
                InputError("no mass", where=Place("arm.yaml", 3, 9), found="two\nlines", remedy="give one"),
                2,
                "robodyn: error: arm.yaml:3:9: no mass; found two lines; give one\n",
            ),
            (ToolError("no C compiler"), 3, "robodyn: error: no C compiler\n"),
            (KeyboardInterrupt(), 130, "robodyn: interrupted\n"),
            (click.Abort(), 130, "robodyn: interrupted\n"),
            (click.UsageError("no such option"), 2, "robodyn: error: no such option; see robodyn --help\n"),
            (click.exceptions.Exit(4), 4, ""),
        ],
        ids=lambda value: type(value).__name__ if isinstance(value, BaseException) else None,
    )
    def test_error_becomes_a_line_and_a_code(
        self, error: BaseException, code: int, text: str, capsys: pytest.CaptureFixture[str]
    ) -> None:
        def run() -> None:
            raise error

        assert guard(run) == code
        out, err = capsys.readouterr()
        assert (out, err) == ("", text)

    @pytest.mark.parametrize("debug", [False, True])
    def test_unexpected_error_is_called_a_bug(
        self, debug: bool, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        def run() -> None:
            raise ZeroDivisionError("of all things")

        monkeypatch.setenv("ROBODYN_DEBUG", "1" if debug else "")
        assert guard(run) == 70
        err = capsys.readouterr().err
        expected = "robodyn: internal error: ZeroDivisionError: of all things; this is a bug in robodyn"
        assert err.splitlines()[-1].startswith(expected)
        assert ("Traceback" in err) is debug
        assert (len(err.splitlines()) == 1) is not debug

    def test_success(self) -> None:
        assert guard(lambda: None) == 0


class TestProcess:
    @pytest.mark.parametrize("module", ["robodyn", "robodyn_cli"])
    def test_both_modules_run(self, module: str) -> None:
        run = subprocess.run(
            [sys.executable, "-m", module, "--version"], capture_output=True, text=True, check=True
        )
        assert run.stdout.startswith("robodyn ")
        assert run.stdout.split()[1][0].isdigit()
        assert run.stderr == ""

    @pytest.mark.parametrize("arguments", ["nonsense", "--nonsense", "robots --nonsense", "robots more"])
    def test_wrong_usage_is_bad_input(self, arguments: str) -> None:
        run = robodyn(*arguments.split())
        assert run.returncode == 2
        assert run.stdout == ""
        assert run.stderr.startswith("robodyn: error: ")
        command = "robodyn robots" if arguments.startswith("robots") else "robodyn"
        assert run.stderr.endswith(f"; see {command} --help\n")
        assert len(run.stderr.splitlines()) == 1

    def test_wrong_usage_is_escaped(self, capsys: pytest.CaptureFixture[str]) -> None:
        assert main(["robots", "a\x1b[31mb\nc"]) == 2
        expected = "Got unexpected extra argument (a\\x1b[31mb c); see robodyn robots --help"
        assert capsys.readouterr().err == f"robodyn: error: {expected}\n"

    def test_no_command_gets_the_help(self) -> None:
        run = robodyn()
        assert "Commands:" in run.stdout + run.stderr
        assert "robodyn: error" not in run.stderr

    def test_closed_pipe_is_quiet(self) -> None:
        reader, writer = os.pipe()
        os.close(reader)
        run = robodyn("robots", "--names", stdout=writer)
        os.close(writer)
        assert run.stderr == ""
        assert run.returncode == 141

    @pytest.mark.skipif(not Path("/dev/full").exists(), reason="missing: /dev/full; only Linux has it")
    def test_full_disk_is_one_line(self) -> None:
        with Path("/dev/full").open("w") as full:
            run = robodyn("schema", stdout=full)
        assert run.returncode == 74
        assert len(run.stderr.splitlines()) == 1
        assert "No space left" in run.stderr

    @pytest.mark.skipif(not Path("/dev/full").exists(), reason="missing: /dev/full; only Linux has it")
    @pytest.mark.parametrize(
        ("command", "code"),
        [
            ("gen stanford_3dof -o DIR >/dev/full", 74),
            ("--help >/dev/full", 74),
            ("robots >/dev/full 2>/dev/full", 74),
            ("robots 2>/dev/full", 0),
            ("gen nosuch 2>/dev/full", 2),
            ("robots --nonsense 2>/dev/full", 2),
            ("new arm -o DIR/arm.yaml 2>/dev/full", 0),
        ],
    )
    def test_full_devices_keep_the_exit_code(self, command: str, code: int, tmp_path: Path) -> None:
        assert shell(command, tmp_path).returncode == code

    @pytest.mark.parametrize(
        ("command", "code"),
        [
            ("robots >&-", 0),
            ("schema >&- 2>&-", 0),
            ("--version <&- >&- 2>&-", 0),
            ("gen stanford_3dof -o DIR >&- 2>&-", 0),
            ("verify stanford_3dof --seed -1 >&- 2>&-", 2),
            ("gen nosuch 2>&-", 2),
        ],
    )
    def test_closed_streams_are_quiet(self, command: str, code: int, tmp_path: Path) -> None:
        run = shell(command, tmp_path)
        assert (run.returncode, run.stdout, run.stderr) == (code, "", "")

    def test_guard_bears_closed_streams(self, monkeypatch: pytest.MonkeyPatch) -> None:
        def run() -> None:
            raise BrokenPipeError

        monkeypatch.setattr(sys, "stdout", None)
        monkeypatch.setattr(sys, "stderr", None)
        assert guard(run) == 141


class TestLaziness:
    def test_the_frame_imports_nothing_heavy(self) -> None:
        assert not loaded_after("import robodyn_cli.main") & HEAVY

    def test_help_imports_no_command(self) -> None:
        loaded = loaded_after("from robodyn_cli.main import main\nassert main(['--help']) == 0")
        assert not loaded & set(map(module_of, COMMANDS))
        assert not loaded & HEAVY

    def test_a_command_imports_only_itself(self) -> None:
        loaded = loaded_after("from robodyn_cli.main import main\nassert main(['new', '--help']) == 0")
        assert {name for name in loaded if name.startswith("robodyn_cli.")} == {
            "robodyn_cli.main",
            "robodyn_cli.new",
            "robodyn_cli.choices",
            "robodyn_cli.common",
            "robodyn_cli.failures",
            "robodyn_cli.file_options",
            "robodyn_cli.values",
        }


class TestHelp:
    def test_lists_every_command(self, capsys: pytest.CaptureFixture[str]) -> None:
        assert main(["--help"]) == 0
        out = capsys.readouterr().out
        for name, short in COMMANDS.items():
            assert name in out
            assert short.split()[0] in out

    @pytest.mark.parametrize("name", COMMANDS)
    def test_short_help_is_the_commands_own(self, name: str) -> None:
        assert import_module(module_of(name)).command.get_short_help_str(limit=200) == COMMANDS[name]

    @pytest.mark.parametrize("name", COMMANDS)
    def test_every_command_has_help_and_json(self, name: str, capsys: pytest.CaptureFixture[str]) -> None:
        assert main([name, "--help"]) == 0
        out = capsys.readouterr().out
        assert out.startswith(f"Usage: robodyn {name} ")
        assert "--json" in out

    def test_no_command_file_is_forgotten(self) -> None:
        folder = Path(frame.__file__).parent
        files = {path.stem for path in folder.glob("*.py") if "\ndef command(" in path.read_text("utf-8")}
        assert files == {module_of(name).removeprefix("robodyn_cli.") for name in COMMANDS}


class TestRobots:
    def test_names(self, capsys: pytest.CaptureFixture[str]) -> None:
        assert main(["robots", "--names"]) == 0
        names = capsys.readouterr().out.split()
        assert "puma560" in names
        assert len(set(names)) == len(names)
        assert main(["robots", "--names", "--json"]) == 0
        assert json.loads(capsys.readouterr().out) == names

    def test_table_and_json_agree(self, capsys: pytest.CaptureFixture[str]) -> None:
        assert main(["robots", "--json"]) == 0
        robots = json.loads(capsys.readouterr().out)
        assert {robot["name"]: robot["joints"] for robot in robots}["stanford"] == "RRPRRR"
        assert all(robot["title"] for robot in robots)
        assert main(["robots"]) == 0
        lines = re.sub(r"\n {9,}", " ", capsys.readouterr().out).splitlines()  # long titles are broken
        words = ("name", "joints", "origin", "title")
        assert [line.split() for line in lines] == [
            " ".join(map(robot.get, words)).split() for robot in robots
        ]
        origins = [robot["origin"] for robot in robots]
        assert origins.count("synthetic") == 4
        assert origins[-4:] == ["synthetic"] * 4, "arms of products come first"


class TestSchema:
    def test_is_a_schema_that_knows_the_keys(self, capsys: pytest.CaptureFixture[str]) -> None:
        assert main(["schema"]) == 0
        out = capsys.readouterr().out
        schema = json.loads(out)
        assert {"name", "links", "gravity"} <= set(schema["properties"])
        assert main(["schema", "--json"]) == 0
        assert capsys.readouterr().out == out


class TestNew:
    def test_writes_a_robot_that_loads(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        from robodyn.robot import load

        monkeypatch.chdir(tmp_path)
        assert main(["new", "crane", "--joints", "3"]) == 0
        robot = load("crane.yaml")
        assert robot.name == "crane"
        assert len(robot.links) == 3

    @pytest.mark.parametrize("length", [250, 300])
    def test_a_name_that_is_too_long(
        self, length: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        path = tmp_path / ("x" * length)
        assert main(["new", "arm", "-o", str(path)]) == (0 if length < 256 else 2)
        said = f"robodyn: error: cannot write {path}: File name too long; choose another path with -o"
        assert capsys.readouterr().err.startswith(said) is (length > 255)

    def test_the_name_of_a_file_is_escaped(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        path = tmp_path / "a\x1b[31m\nb.yaml"
        for code in (0, 2):
            assert main(["new", "arm", "-o", str(path)]) == code
            err = capsys.readouterr().err
            assert "a\\x1b[31m\\nb.yaml" in err
            assert "\x1b" not in err
            assert len(err.splitlines()) == 1
