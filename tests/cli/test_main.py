"""The frame of the command line: exit codes, one line or one JSON document an error, lazy loading, help."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path

import click
import pytest

import robodyn
from cli.command import Capture, environment, python, run, run_json
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.errors import CheckError, InputError, Place, ToolError, error_schema
from robodyn_cli import main as frame
from robodyn_cli.failures import asks_for_json, guard
from robodyn_cli.main import COMMANDS, main, module_of
from robodyn_cli.output import Document
from robodyn_testing import representative, require_module

HEAVY = {"numpy", "sympy", "jinja2", "yaml", "cffi", "json", "scipy", "matplotlib"}

# --- what ends a command ----------------------------------------------------------------------------------


def raising(error: BaseException, document: Document | None = None) -> int:
    """The exit code of a command that ends with ``error``."""

    def work() -> None:
        raise error

    return guard(work) if document is None else guard(work, document)


@pytest.mark.parametrize(
    ("error", "code", "line"),
    [
        (CheckError("the budget is exceeded"), 1, "error: the budget is exceeded\n"),
        (
            InputError("no mass", where=Place("arm.yaml", 3, 9), found="two\nlines", remedy="give one"),
            2,
            "error: arm.yaml:3:9: no mass; found two lines; give one\n",
        ),
        (click.UsageError("no such option."), 2, "error: no such option; see robodyn --help\n"),
        (ToolError("no C compiler"), 3, "error: no C compiler\n"),
        (ImportError("no module", name="numpy"), 3, "error: a library cannot be loaded: no module"),
        (
            ZeroDivisionError("of all things"),
            70,
            "internal error: ZeroDivisionError: of all things; unless that file is yours, this is",
        ),
        (OSError(28, "No space left"), 74, "error: the operating system refused: [Errno 28] No space left"),
        (MemoryError(), 74, "error: the operating system refused: out of memory\n"),
        (KeyboardInterrupt(), 130, "interrupted\n"),
        (click.Abort(), 130, "interrupted\n"),
    ],
    ids=lambda value: type(value).__name__ if isinstance(value, BaseException) else None,
)
def test_all_that_can_end_a_command(error: BaseException, code: int, line: str, capsys: Capture) -> None:
    assert raising(error) == code
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert err.startswith(f"robodyn: {line}")
    assert raising(error, Document(as_json=True)) == code
    document = json.loads(capsys.readouterr().out)
    require_module("jsonschema").validate(document, error_schema())
    assert document["error"]["exit_code"] == code
    assert document["error"]["what"] in err
    assert raising(error, Document(as_json=True, begun=True)) == code
    assert capsys.readouterr().out == ""


def test_a_slip_in_an_added_file_names_that_file(capsys: Capture) -> None:
    """An effect, a language or a format is a file in the package."""
    file = Path(robodyn.__file__).parent / "effects" / "mine.py"
    slip = compile("def evaluate():\n    return 1 / 0\n", str(file), "exec")
    names: dict[str, Callable[[], None]] = {}
    exec(slip, names)
    assert guard(names["evaluate"]) == 70
    assert f"internal error: {file}:2: ZeroDivisionError" in capsys.readouterr().err


def test_no_document_where_nothing_failed(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    assert raising(click.exceptions.Exit(4), Document(as_json=True)) == 4
    assert raising(BrokenPipeError(), Document(as_json=True)) == 141
    assert guard(lambda: None, Document(as_json=True)) == 0
    assert capsys.readouterr() == ("", "")
    for stream in ("stdout", "stderr"):
        monkeypatch.setattr(sys, stream, None)
    assert raising(BrokenPipeError()) == 141


def test_a_bug_has_a_traceback_for_those_who_look_for_it(
    monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    monkeypatch.setenv("ROBODYN_DEBUG", "1")
    assert raising(ZeroDivisionError("of all things")) == 70
    assert "Traceback" in capsys.readouterr().err


def test_wrong_usage_of_any_command(capsys: Capture) -> None:
    for name in (*COMMANDS, "nonsense"):
        for words in ("--nonsense --json", "--json --nonsense"):
            out, err = run(capsys, f"{name} {words}", code=2)
            error = json.loads(out)["error"]
            assert err == f"robodyn: error: {error['message']}\n"
            assert "onsense" in error["what"]
            assert error["remedy"] == f"see robodyn{'' if name == 'nonsense' else f' {name}'} --help"
    assert run(capsys, "flops -- --json", code=2)[0] == ""  # the name of a file
    _, err = run(capsys, "robots", "a\x1b[31mb\nc", code=2)
    expected = "Got unexpected extra argument (a\\x1b[31mb c); see robodyn robots --help"
    assert err == f"robodyn: error: {expected}\n"


def test_which_words_ask_for_json() -> None:
    for words in ("flops arm --json", "build --format json", "build --check --format=json"):
        assert asks_for_json(words.split()), words
    for words in ("flops arm", "build --format junit json", "flops -- --json", "build --format"):
        assert not asks_for_json(words.split()), words


def test_every_part_is_in_the_schema_and_in_the_documents() -> None:
    """And none else: an error without any is as valid as one with all."""
    jsonschema = require_module("jsonschema")
    error = InputError("wrong").to_dict()
    jsonschema.validate({"error": error}, error_schema())
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({"error": error | {"more": 1}}, error_schema())
    page = (Path(__file__).parents[2] / "docs" / "shell.md").read_text(encoding="utf-8")
    rows = re.findall(r"(?m)^\| (`.*?) \|", page.partition("| key |")[2].partition("\n\n")[0])
    named = [key for row in rows for key in re.findall(r"`(\w+)`", row)]
    assert named == error_schema()["properties"]["error"]["required"]


# --- processes and their streams --------------------------------------------------------------------------


@pytest.mark.parametrize("module", ["robodyn", "robodyn_cli"])
def test_both_modules_run(module: str) -> None:
    done = python("-m", module, "--version")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("robodyn ")
    assert done.stdout.split()[1][0].isdigit()


def test_no_command_gets_the_help() -> None:
    done = python("-m", "robodyn")
    assert "Generate code:" in done.stdout + done.stderr
    assert "robodyn: error" not in done.stderr


def test_closed_pipe_is_quiet() -> None:
    reader, writer = os.pipe()
    os.close(reader)
    words = [sys.executable, "-m", "robodyn", "robots", "--names"]
    done = subprocess.run(words, stdout=writer, stderr=subprocess.PIPE, env=environment(), check=False)
    os.close(writer)
    assert (done.returncode, done.stderr) == (141, b"")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="missing: /dev/full; only Linux has it")
@pytest.mark.parametrize(
    ("command", "code"),
    representative(
        [
            ("schema >/dev/full", 74),
            ("gen stanford_3dof -o out >/dev/full", 74),
            ("new 'no good' --json >/dev/full", 2),
            ("robots 2>/dev/full", 0),
            ("robots --nonsense 2>/dev/full", 2),
            ("--version <&- >&- 2>&-", 0),
            ("gen stanford_3dof -o out >&- 2>&-", 0),
            ("gen nosuch 2>&-", 2),
        ],
        "schema >/dev/full", "new 'no good' --json >/dev/full", "robots 2>/dev/full",
        "--version <&- >&- 2>&-", "gen nosuch 2>&-",
        rest="slow",
    ),
)  # fmt: skip
def test_full_and_closed_streams_keep_the_exit_code(command: str, code: int, tmp_path: Path) -> None:
    line = f"{shlex.quote(sys.executable)} -m robodyn {command}"
    done = subprocess.run(
        ["sh", "-c", line], capture_output=True, text=True, check=False, cwd=tmp_path, env=environment()
    )
    assert done.returncode == code
    assert done.stderr.count("\n") == (code != 0 and "2>" not in command)
    assert done.stdout == "" or ">&-" not in command
    if code == 74:
        assert "No space left" in done.stderr or "2>" in command


# --- what is loaded, and what help says -------------------------------------------------------------------


def loaded_after(words: str) -> set[str]:
    """The modules that a fresh interpreter has loaded once it has run that command."""
    script = f"import sys\nfrom robodyn_cli.main import main\nassert main({words.split()}) == 0"
    return set(python("-c", f"{script}\nprint(*sys.modules, file=sys.stderr)").stderr.split())


def test_help_imports_nothing_heavy() -> None:
    assert not loaded_after("--help") & (HEAVY | set(map(module_of, COMMANDS)))
    loaded = loaded_after("simulate --help")
    assert not loaded & (HEAVY - {"json"})
    assert loaded & set(map(module_of, COMMANDS)) == {"robodyn_cli.simulate"}


def test_help_of_every_command(capsys: Capture) -> None:
    for name, short in COMMANDS.items():
        assert import_module(module_of(name)).command.get_short_help_str(limit=200) == short
        out, _ = run(capsys, f"{name} --help")
        assert out.startswith(f"Usage: robodyn {name} ")
        assert "--json" in out
    folder = Path(frame.__file__).parent
    files = {path.stem for path in folder.glob("*.py") if "\ndef command(" in path.read_text("utf-8")}
    assert files == {module_of(name).removeprefix("robodyn_cli.") for name in COMMANDS}


# --- small commands ---------------------------------------------------------------------------------------


def test_functions_are_listed_and_described(capsys: Capture) -> None:
    rows = run_json(capsys, "functions")
    assert [row["name"] for row in rows] == list(FUNCTIONS)
    text, _ = run(capsys, "functions")
    assert [line.partition(":")[0] for line in text.splitlines() if not line.startswith(" ")] == list(
        FUNCTIONS
    )
    assert run_json(capsys, "functions gravity") == {
        "name": "gravity",
        "purpose": FUNCTIONS["gravity"].purpose,
        "by_default": True,
        "inputs": {"q": "joint positions [rad, prismatic m]"},
        "results": {"tau": "joint torques [N m, prismatic N]"},
    }
    assert "  takes q: joint positions" in run(capsys, "functions gravity")[0]
    assert "did you mean 'gravity'" in run(capsys, "functions gravit", code=2)[1]


def test_help_of_commands_is_short_where_functions_are_named(capsys: Capture) -> None:
    for name in ("gen", "verify", "bench", "package", "flops"):
        text, _ = run(capsys, f"{name} --help")
        assert '"robodyn functions" lists them' in " ".join(text.split())
        assert "coriolis_matrix" not in text


def test_robots_as_names_and_json_agree(capsys: Capture) -> None:
    robots = run_json(capsys, "robots")
    names = [robot["name"] for robot in robots]
    everything = run_json(capsys, "robots --names")  # older names, too
    assert run(capsys, "robots --names")[0].split() == everything
    assert set(names) <= set(everything)
    assert len(set(everything)) == len(everything)
    assert {robot["name"]: robot["joints"] for robot in robots}["stanford"] == "RRPRRR"
    assert all(robot["title"] for robot in robots)
    origins = [robot["origin"] for robot in robots]
    assert origins.count("synthetic") == 4
    assert origins[-4:] == ["synthetic"] * 4, "arms of products come first"


def test_the_schema_knows_the_keys(capsys: Capture) -> None:
    schema = run_json(capsys, "schema")
    assert {"name", "links", "gravity"} <= set(schema["properties"])
    assert json.loads(run(capsys, "schema")[0]) == schema


def test_the_name_of_a_file_is_escaped(tmp_path: Path, capsys: Capture) -> None:
    path = tmp_path / "a\x1b[31m\nb.yaml"
    for code in (0, 2):
        assert main(["new", "arm", "-o", str(path)]) == code
        err = capsys.readouterr().err
        assert "a\\x1b[31m\\nb.yaml" in err
        assert "\x1b" not in err
        assert len(err.splitlines()) == 1
