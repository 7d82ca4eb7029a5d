"""The hooks for pre-commit and the GitHub action: what they call is there, and the action's script works."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
import yaml

from cli.command import environment
from records.made import ELBOW
from robodyn_cli.build import command
from robodyn_cli.main import main
from robodyn_testing import require_tool

ROOT = Path(__file__).parents[2]
SCRIPT = ROOT / ".github" / "check.sh"
ACTION = yaml.safe_load((ROOT / "action.yml").read_text(encoding="utf-8"))
HOOKS = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))
#: Of pre-commit.com, "Creating new hooks": what a hook may have.
OF_A_HOOK = {
    "id", "name", "entry", "language", "files", "exclude", "types", "types_or", "exclude_types", "always_run",
    "fail_fast", "verbose", "pass_filenames", "require_serial", "description", "language_version",
    "minimum_pre_commit_version", "args", "stages", "additional_dependencies",
}  # fmt: skip


@pytest.mark.parametrize("hook", HOOKS, ids=lambda hook: hook["id"])
def test_hooks_are_hooks_and_call_what_is_there(hook: Mapping[str, Any]) -> None:
    assert {"id", "name", "entry", "language"} <= set(hook) <= OF_A_HOOK
    program, name, *arguments = hook["entry"].split()
    assert (program, name) == ("robodyn", "build")
    assert command.make_context(name, arguments).params["check"] is ("check" in hook["id"])
    assert not hook["pass_filenames"]


def test_the_action_is_a_composite_one() -> None:
    assert set(ACTION) == {"name", "description", "inputs", "runs"}
    assert ACTION["runs"]["using"] == "composite"
    for step in ACTION["runs"]["steps"]:
        assert set(step) == {"name", "shell", "env", "run"}
        assert "inputs." not in step["run"], "what somebody else wrote is no part of a script"
    used = set(re.findall(r"inputs\.(\w+)", str(ACTION["runs"])))
    assert used == set(ACTION["inputs"])
    assert all(set(each) == {"description", "default"} for each in ACTION["inputs"].values())
    assert ACTION["inputs"]["file"]["default"] == command.make_context("build", []).params["path"]
    *_, last = ACTION["runs"]["steps"]
    assert last["run"].endswith('/.github/check.sh"')
    read = set(re.findall(r"\$\{?([A-Z]+)\b", SCRIPT.read_text(encoding="utf-8")))
    assert read == set(last["env"])


@pytest.mark.thorough
def test_the_script_of_the_action_compares_with_another_revision(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for tool in ("bash", "git"):
        require_tool(tool)
    folder, programs, summary = tmp_path / "project", tmp_path / "bin", tmp_path / "summary.md"
    for each in (folder, programs):
        each.mkdir()
    (programs / "robodyn").write_text(f'#!/bin/sh\nexec "{sys.executable}" -m robodyn "$@"\n')
    (programs / "robodyn").chmod(0o755)
    monkeypatch.chdir(folder)
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path / "cache"))

    def git(*words: str) -> None:
        known = ["-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false"]
        subprocess.run(["git", *known, *words], check=True, capture_output=True)

    def check(against: str = "", junit: str = "") -> int:
        summary.write_text("before\n")
        variables = environment(
            FILE="robodyn.toml", AGAINST=against, JUNIT=junit, GITHUB_STEP_SUMMARY=str(summary),
            PATH=os.pathsep.join([str(programs), os.environ["PATH"]]),
        )  # fmt: skip
        done = subprocess.run([shutil.which("bash") or "", str(SCRIPT)], env=variables, check=False)
        return done.returncode

    git("init", "--quiet", "--initial-branch=trunk")
    (folder / "elbow.yaml").write_text(ELBOW)
    (folder / "robodyn.toml").write_text('[robots.elbow]\nrobot = "elbow.yaml"\nfunctions = ["gravity"]\n')
    assert check() == 1
    assert main(["build", "--workers", "1"]) == 0
    git("add", "--all")
    git("commit", "--quiet", "--message=before")
    assert check(against="trunk") == 0
    (folder / "elbow.yaml").write_text(ELBOW.replace("gravity: [0.3, 0,", "gravity: [0.3, 0.2,"))
    assert main(["build", "--workers", "1"]) == 0
    assert check() == 0
    assert check(against="trunk", junit="report.xml") == 1
    assert summary.read_text().startswith("before\n### robodyn: robodyn.toml failed\n")
    assert "gravity got worse" in summary.read_text()
    assert 'failures="1"' in (folder / "report.xml").read_text()
    (folder / "robodyn.toml").write_text("[robot.elbow]\n")
    assert check() == 2
