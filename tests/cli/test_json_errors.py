"""With ``--json`` stdout has one JSON document, whatever happens: the results, or else the error."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

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


def test_the_parts_of_an_error_stand_apart(tmp_path: Path, capsys: Capture) -> None:
    arm = tmp_path / "arm.yaml"
    arm.write_text(BROKEN, encoding="utf-8")
    assert main(["flops", str(arm), "--json"]) == 2
    error = error_of(capsys.readouterr(), 2)
    assert error["where"] == {"file": str(arm), "line": 3, "column": 29}
    assert "mass" in error["what"]
    assert error["found"] == "-1 kg"
    assert error["expected"]
    assert error["message"].startswith(f"{arm}:3:29: {error['what']}; found -1 kg; expected ")


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


def test_a_failed_check_without_results(tmp_path: Path, capsys: Capture) -> None:
    arguments = ["gen", "stanford_3dof", "--functions", "gravity", "-o", str(tmp_path / "none")]
    assert main([*arguments, "--check", "--json"]) == 1
    assert "none" in error_of(capsys.readouterr(), 1)["message"]


def test_results_are_the_only_document_where_there_are_any(capsys: Capture) -> None:
    assert main(["flops", "stanford_3dof", "--functions", "gravity", "--budget", "total=1", "--json"]) == 1
    captured = capsys.readouterr()
    assert json.loads(captured.out)["function"] == "gravity"
    assert "over the budget of 1" in captured.err


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


class TestBuild:
    @pytest.fixture
    def project(self, tmp_path: Path) -> Path:
        path = tmp_path / "a\x1b<&.toml"
        path.write_text("[robots.arm]\nnonsense = 1\n", encoding="utf-8")
        return path

    def test_json(self, project: Path, capsys: Capture) -> None:
        for ask in (["--format", "json"], ["--json"]):
            assert main(["build", "--check", "--file", str(project), *ask]) == 2
            error = json.loads(capsys.readouterr().out)["error"]
            assert error["where"]["line"] == 2
            assert "unknown key 'nonsense'" in error["what"]

    def test_junit(self, project: Path, capsys: Capture) -> None:
        assert main(["build", "--check", "--file", str(project), "--format", "junit"]) == 2
        suites = ElementTree.fromstring(capsys.readouterr().out)
        assert suites.attrib == {"tests": "1", "failures": "0", "errors": "1"}
        (error,) = suites.iter("error")
        assert "a\\x1b<&.toml:2:1: unknown key 'nonsense'" in error.attrib["message"]

    def test_markdown(self, project: Path, capsys: Capture) -> None:
        assert main(["build", "--check", "--file", str(project), "--format", "markdown"]) == 2
        out = capsys.readouterr().out
        assert out.startswith("### robodyn: nothing was compared\n")
        assert "\\<&.toml:2:1: unknown key 'nonsense'" in out

    def test_text_is_said_once(self, project: Path, capsys: Capture) -> None:
        assert main(["build", "--check", "--file", str(project)]) == 2
        assert capsys.readouterr().out == ""

    @pytest.mark.parametrize(("form", "begins"), [("json", "{"), ("junit", "<?xml"), ("text", "error: ")])
    def test_an_old_report_does_not_stay(self, form: str, begins: str, project: Path, tmp_path: Path) -> None:
        """A file of an earlier, successful check would be read as this one's."""
        report = tmp_path / "report"
        report.write_text("passed", encoding="utf-8")
        arguments = ["build", "--check", "--file", str(project), "--format", form, "-o", str(report)]
        assert main(arguments) == 2
        text = report.read_text(encoding="utf-8")
        assert text.startswith(begins)
        assert "unknown key 'nonsense'" in text

    def test_a_report_that_cannot_be_written_hides_no_error(
        self, project: Path, tmp_path: Path, capsys: Capture
    ) -> None:
        assert main(["build", "--file", str(project), "--format", "junit", "-o", str(tmp_path)]) == 2
        err = capsys.readouterr().err
        assert "cannot write" in err
        assert "unknown key 'nonsense'" in err.splitlines()[-1]


def test_the_schema_is_printed(capsys: Capture) -> None:
    assert main(["schema", "--error"]) == 0
    assert json.loads(capsys.readouterr().out) == error_schema()
    assert main(["schema", "--error", "--project", "--json"]) == 2
    assert "one schema at a time" in error_of(capsys.readouterr(), 2)["what"]


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
