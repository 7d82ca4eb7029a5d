"""With ``--json`` stdout has one JSON document, whatever happens: the results, or else the error."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import click
import pytest

from robodyn.errors import CheckError, InputError, error_schema
from robodyn_cli.common import Document
from robodyn_cli.failures import asks_for_json, guard
from robodyn_cli.main import COMMANDS, main
from robodyn_testing.wanted import require_module

Capture = pytest.CaptureFixture[str]

BROKEN = "name: arm\nlinks:\n  - {joint: revolute, mass: -1}\n"


def error_of(captured: Any, code: int) -> dict[str, Any]:
    """The error on stdout, which says what the one line on stderr says, and the exit code."""
    document = json.loads(captured.out)
    assert list(document) == ["error"]
    error: dict[str, Any] = document["error"]
    assert error["exit_code"] == code
    assert captured.err.splitlines()[-1] == f"robodyn: error: {error['message']}"
    require_module("jsonschema").validate(document, error_schema())
    return error


def test_without_json_stdout_is_empty(tmp_path: Path, capsys: Capture) -> None:
    arm = tmp_path / "arm.yaml"
    arm.write_text(BROKEN, encoding="utf-8")
    assert main(["flops", str(arm)]) == 2
    assert capsys.readouterr().out == ""
    assert main(["flops", "--", "--json"]) == 2  # the name of a file
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize("name", [*COMMANDS, "nonsense"])
def test_wrong_usage_of_any_command(name: str, capsys: Capture) -> None:
    for arguments in ([name, "--nonsense", "--json"], [name, "--json", "--nonsense"]):
        assert main(arguments) == 2
        error = error_of(capsys.readouterr(), 2)
        assert "onsense" in error["what"]
        assert error["remedy"] == f"see robodyn{'' if name == 'nonsense' else f' {name}'} --help"


@pytest.mark.parametrize(
    ("error", "code", "what"),
    [
        (CheckError("too many"), 1, "too many"),
        (click.UsageError("no such thing."), 2, "no such thing"),
        (KeyboardInterrupt(), 130, "interrupted"),
        (ZeroDivisionError("of all things"), 70, "ZeroDivisionError: of all things"),
        (
            OSError(28, "No space left on device"),
            74,
            "the operating system refused: [Errno 28] No space left",
        ),
        (ImportError("no module", name="numpy"), 3, "a library cannot be loaded: no module"),
    ],
    ids=lambda value: type(value).__name__ if isinstance(value, BaseException) else None,
)
def test_all_that_can_end_a_command(error: BaseException, code: int, what: str, capsys: Capture) -> None:
    def run() -> None:
        raise error

    assert guard(run, Document(as_json=True)) == code
    printed = json.loads(capsys.readouterr().out)["error"]
    assert printed["exit_code"] == code
    assert printed["what"].startswith(what)
    assert guard(run, Document(as_json=True, begun=True)) == code
    assert capsys.readouterr().out == ""


def test_no_document_where_nothing_failed(capsys: Capture) -> None:
    for error in (click.exceptions.Exit(4), BrokenPipeError()):

        def run(raised: Exception = error) -> None:
            raise raised

        assert guard(run, Document(as_json=True)) in (4, 141)
        assert capsys.readouterr().out == ""


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="missing: /dev/full; only Linux has it")
def test_a_full_disk_under_stdout_changes_no_exit_code() -> None:
    with Path("/dev/full").open("w") as full:
        command = [sys.executable, "-m", "robodyn", "new", "no good", "--json"]
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr.startswith("robodyn: error: ")
    assert len(done.stderr.splitlines()) == 1


def test_which_words_ask_for_json() -> None:
    for words in ("flops arm --json", "build --format json", "build --check --format=json"):
        assert asks_for_json(words.split()), words
    for words in ("flops arm", "build --format junit json", "flops -- --json", "build --format"):
        assert not asks_for_json(words.split()), words


def test_every_part_is_in_the_schema() -> None:
    """And none else: an error without any is as valid as one with all."""
    jsonschema = require_module("jsonschema")
    error = InputError("wrong").to_dict()
    jsonschema.validate({"error": error}, error_schema())
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({"error": error | {"more": 1}}, error_schema())


def test_the_documents_name_every_part() -> None:
    page = (Path(__file__).parents[2] / "docs" / "shell.md").read_text(encoding="utf-8")
    rows = re.findall(r"(?m)^\| (`.*?) \|", page.partition("| key |")[2].partition("\n\n")[0])
    named = [key for row in rows for key in re.findall(r"`(\w+)`", row)]
    assert named == error_schema()["properties"]["error"]["required"]
