"""``robodyn doctor``: what is found, what is missing, and what does not answer."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from robodyn import doctor
from robodyn.doctor import ToolState, examine, known, named, version_in
from robodyn.errors import InputError
from robodyn.tools import Library, Tool, Use
from robodyn.tools.libraries import NUMPY
from robodyn_cli.main import main

Capture = pytest.CaptureFixture[str]

PROGRAMS = {
    "answers": "echo 'answers (Debian 9.9-1) 1.2.3 20221205'",
    "chatters": "echo a warning; echo chatters 7.1",
    "silent": "true",
    "fails": "echo no licence; exit 4",
    "fails-silently": "exit 4",
    "hangs": "sleep 600",
}


def tool(name: str) -> Tool:
    return Tool((name,), Use.PROOFS, f"proofs by {name}", name)


@pytest.fixture(autouse=True)
def _programs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    for name, text in PROGRAMS.items():
        (tmp_path / name).write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
        (tmp_path / name).chmod(0o755)
    (tmp_path / "broken").write_bytes(b"\x7fELF of another machine")
    (tmp_path / "broken").chmod(0o755)


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Few tools, one of them missing."""
    tools = (NUMPY, tool("answers"), tool("not-there"), tool("fails"))
    monkeypatch.setattr(doctor, "known", lambda: tools)


def test_one_that_hangs_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(doctor, "SECONDS", 0.2)
    (hangs,) = examine([tool("hangs")])
    assert (hangs.works, hangs.fault) == (False, "no answer within 0.2 s")


def test_each_ends_as_it_does() -> None:
    names = ["answers", "chatters", "silent", "fails", "fails-silently", "broken", "not-there"]
    found = {each.tool.name: each for each in examine(map(tool, names))}
    assert {name: each.version for name, each in found.items() if each.works} == {
        "answers": "1.2.3", "chatters": "7.1", "silent": None,
    }  # fmt: skip
    assert found["fails"].fault == "no licence"
    assert found["fails-silently"].fault == "exit status 4"
    assert found["broken"].fault == "Exec format error"
    assert found["not-there"] == ToolState(tool("not-there"))


def test_libraries_are_not_imported() -> None:
    here, nowhere = examine([NUMPY, Library("robodyn_of_nowhere", Use.LOGS, "logs")])
    assert (here.where, bool(here.version)) == ("numpy", True)
    assert not nowhere.works


@pytest.mark.parametrize(
    ("line", "version"),
    [
        ("gcc (Debian 12.2.0-14+deb12u1) 12.2.0", "12.2.0"),
        ("QEMU emulator version 7.2.22 (Debian 1:7.2+dfsg-7+deb12u18)", "7.2.22"),
        ("valgrind-3.19.0", "3.19.0"),
        ("v20.20.2", "20.20.2"),
        ("cargo 1.75.0 (1d8b05cdd 2023-11-20)", "1.75.0"),
        ("zsh 5.9 (x86_64-debian-linux-gnu)", "5.9"),
        ("25.0-beta (Manganese)", "25.0-beta"),
        ("unknown", None),
    ],
)
def test_versions(line: str, version: str | None) -> None:
    assert version_in(line) == version


def test_tools_have_several_names() -> None:
    assert named("cc").use is named("flang").use is Use.KERNELS
    assert named("gcc").use is Use.PROOFS  # which has to be a real one
    assert named("pinocchio") is named("pin")
    with pytest.raises(InputError, match=r"robodyn uses no tool 'gapa'.*did you mean 'gappa'"):
        named("gapa")


def test_uses_are_together() -> None:
    uses = [tool.use for tool in known()]
    assert list(dict.fromkeys(uses)) == list(Use)
    assert uses == sorted(uses, key=list(Use).index)


class TestCommand:
    def test_the_table(self, few: None, tmp_path: Path, capsys: Capture) -> None:
        assert main(["doctor"]) == 0
        lines = capsys.readouterr().out.splitlines()
        assert lines[0].startswith("robodyn ")
        table = (  # lines break where the path of the folder makes them
            "proofs + answers 1.2.3 proofs by answers - not-there proofs by not-there Debian, Ubuntu: apt "
            f"install not-there - fails proofs by fails {tmp_path}/fails does not work: no licence Debian, "
            "Ubuntu: apt install fails"
        )
        assert " ".join(" ".join(lines[6:]).split()) == table
        assert max(map(len, lines)) <= 100 + len(str(tmp_path))

    def test_json(self, few: None, tmp_path: Path, capsys: Capture) -> None:
        assert main(["doctor", "--json", "--need", "answers"]) == 0
        told = json.loads(capsys.readouterr().out)
        assert list(told) == ["robodyn", "python", "system", "cache", "tools"]
        assert told["tools"][1] == {
            "name": "answers", "kind": "program", "use": "proofs", "enables": "proofs by answers",
            "works": True, "version": "1.2.3", "where": str(tmp_path / "answers"), "fault": None,
            "install": "Debian, Ubuntu: apt install answers",
        }  # fmt: skip
        assert [each["works"] for each in told["tools"]] == [True, True, False, False]

    def test_what_is_needed_is_asked_for(self, few: None, capsys: Capture) -> None:
        assert main(["doctor", "--need", "fails,answers,not-there", "--json"]) == 3
        captured = capsys.readouterr()
        assert len(json.loads(captured.out)["tools"]) == 4  # the findings are the document
        assert captured.err == (
            "robodyn: error: missing: not-there, fails; "
            "Debian, Ubuntu: apt install not-there; Debian, Ubuntu: apt install fails\n"
        )
        assert main(["doctor", "--need", "answer"]) == 2
        assert "did you mean 'answers'" in capsys.readouterr().err

    @pytest.mark.parametrize("module", ["jinja2", "yaml"])
    def test_it_runs_where_nothing_else_does(self, module: str) -> None:
        code = (
            f"import sys; sys.modules[{module!r}] = None; from robodyn_cli.main import main; sys.exit(main())"
        )
        done = subprocess.run(
            [sys.executable, "-c", code, "doctor", "--need", "gcc", "--json"],
            env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert done.returncode == 3, done.stderr
        assert "robodyn: error: missing: " in done.stderr
        states = {each["name"]: each["works"] for each in json.loads(done.stdout)["tools"]}
        assert [name for name, works in states.items() if not works] == [module.replace("yaml", "pyyaml")]

    @pytest.mark.thorough
    def test_of_this_machine(self, capsys: Capture) -> None:
        assert main(["doctor", "--all", "--json"]) == 0
        told = json.loads(capsys.readouterr().out)["tools"]
        assert [each["name"] for each in told] == [tool.name for tool in known()]
        assert all(each["version"] for each in told if each["kind"] == "library" and each["works"])
        assert main(["doctor"]) == 0
        out = capsys.readouterr().out
        assert "needed by everything" in out
        assert "robodyn's own tests" not in out
