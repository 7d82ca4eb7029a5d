"""``robodyn build``: what is written, that nothing is done twice, and that nothing is half-written, whatever
ends it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import robodyn_cli.building
from cli.command import Capture, environment, on_terminal, python, run, run_json, tree
from records.made import ELBOW
from robodyn_testing import representative, require_module

PROJECT = """\
[options]
functions = ["inverse_dynamics", "gravity"]
lang = "c"

[robots.one]
robot = "elbow.yaml"

[robots.two]
robot = "other.yaml"
output = "firmware/two"
scalar = "float"
"""
FILES = {
    "generated/one/elbow.h", "generated/one/elbow.c", "firmware/two/other.h", "firmware/two/other.c",
    "robodyn.lock",
}  # fmt: skip
BUILD = "build --workers 1"


@pytest.fixture
def project(elsewhere: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a project of two robots, and an empty store."""
    (elsewhere / "elbow.yaml").write_text(ELBOW)
    (elsewhere / "other.yaml").write_text(ELBOW.replace("elbow", "other"))
    (elsewhere / "robodyn.toml").write_text(PROJECT)
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path / "cache"))
    return elsewhere


@pytest.fixture
def generated(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The names of the robots whose kernels are generated in this process."""
    names: list[str] = []
    carry_out = robodyn_cli.building.carry_out

    def noted(job: Any, root: Path) -> Any:
        names.append(job.name)
        return carry_out(job, root)

    monkeypatch.setattr(robodyn_cli.building, "carry_out", noted)
    return names


def outputs(folder: Path) -> dict[str, str]:
    """What was written, by path."""
    return {name: text for name, text in tree(folder).items() if name in FILES}


def test_it_writes_what_gen_writes(project: Path, capsys: Capture) -> None:
    assert "wrote firmware/two/other.c\n" in run(capsys, "build --workers 3")[0]
    assert set(tree(project)) == FILES | {"elbow.yaml", "other.yaml", "robodyn.toml"}
    options = "--functions inverse_dynamics,gravity --lang c"
    run(capsys, f"gen elbow.yaml {options} -o gen/one")
    run(capsys, f"gen other.yaml {options} --scalar float -o gen/two")
    assert tree(project / "generated" / "one") == tree(project / "gen" / "one")
    assert tree(project / "firmware" / "two") == tree(project / "gen" / "two")


@pytest.mark.parametrize(
    ("file", "before", "after"),
    [
        ("other.yaml", "mass: 1.5", "mass: 1.6"),
        ("robodyn.toml", 'scalar = "float"', 'trig = "builtin"'),
        ("records/other.inverse_dynamics.total.record", "", "no record, but it might be one"),
    ],
)
def test_what_changed_is_done_alone(
    file: str, before: str, after: str, project: Path, generated: list[str], capsys: Capture
) -> None:
    (project / "two").mkdir()
    (project / "other.yaml").rename(project / "two" / "other.yaml")
    text = PROJECT.replace("other.yaml", "two/other.yaml")
    (project / "robodyn.toml").write_text(text)
    run(capsys, BUILD)
    path = project / file if file == "robodyn.toml" else project / "two" / file
    path.parent.mkdir(exist_ok=True)
    path.write_text(path.read_text().replace(before, after) if before else after)
    generated.clear()
    run(capsys, BUILD)
    assert generated == ["two"]
    if before:  # what was generated once is still known
        path.write_text(text if file == "robodyn.toml" else ELBOW.replace("elbow", "other"))
        run(capsys, BUILD)
        assert generated == ["two"]


def test_another_robodyn_generates_anew(
    project: Path, generated: list[str], monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    run(capsys, BUILD)
    monkeypatch.setattr("robodyn.project.fingerprint.own_key", lambda: "other sources")
    run(capsys, BUILD)
    assert generated == ["one", "two"] * 2


def test_the_same_bytes_again(
    project: Path, tmp_path: Path, generated: list[str], monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    """From the store where they were edited, anew where it is damaged, from elsewhere."""
    run(capsys, BUILD)
    wanted = outputs(project)
    with (project / "generated/one/elbow.c").open("a") as file:  # its head says what becomes of that
        file.write("/* edited */\n")
    (project / "firmware/two/other.h").unlink()
    assert run_json(capsys, BUILD)["written"] == ["generated/one/elbow.c", "firmware/two/other.h"]
    assert outputs(project) == wanted
    assert generated == ["one", "two"]
    for name in FILES:
        (project / name).unlink()
    for path in (tmp_path / "cache").glob("*/texts/*.c"):
        path.write_text("damaged")
    (project / "elsewhere").mkdir()
    monkeypatch.chdir(project / "elsewhere")
    run(capsys, f"{BUILD} --file ../robodyn.toml")
    assert outputs(project) == wanted
    assert generated == ["one", "two"] * 2


def test_packages_are_written_with_the_kernels(project: Path, generated: list[str], capsys: Capture) -> None:
    """What robodyn package writes, with the robot's options; locked, checked and left alone like kernels."""
    (project / "robodyn.toml").write_text(
        f'{PROJECT}packages.cmake = {{ version = "1.2.0", functions = ["gravity"] }}\n'
        '[robots.one.packages.crate]\noutput = "crate"\n'
    )
    out, _ = run(capsys, BUILD)
    assert generated == ["one", "one/crate", "two", "two/cmake"]
    assert "two/cmake  gravity " in out
    assert out.endswith("operations; 7 changed\n")
    assert "2 robots, 2 packages, 7 functions, " in out
    run(
        capsys, "package other.yaml --as cmake --functions gravity --scalar float --version 1.2.0 -o packaged"
    )
    assert tree(project / "packages" / "two" / "cmake") == tree(project / "packaged")
    assert '[robots."two/cmake".counts]' in (project / "robodyn.lock").read_text()
    run(capsys, f"{BUILD} --check")
    assert len(generated) == 4
    (project / "crate" / "src" / "lib.rs").write_text("// mine\n")
    _, err = run(capsys, f"{BUILD} --check", code=1)
    assert "crate/src/lib.rs differs from line 1 on: found '// mine'" in err


# --- signals, other builds, terminals ---------------------------------------------------------------------

#: A build that a signal meets when it does something for the NTH time: "replace" is the renaming of a file
#: that it writes, "tell" the beginning of a robot.
HIT = """
import os, signal, sys
from pathlib import Path
from robodyn_cli.entry import main
from robodyn_cli.progress import Line
name, left, number = sys.argv[1], [int(sys.argv[2])], getattr(signal, sys.argv[3])
kind = {"replace": Path, "tell": Line}[name]
method = getattr(kind, name)
def hit(self, *arguments):
    if not left[0]:
        os.kill(os.getpid(), number)
    left[0] -= 1
    return method(self, *arguments)
setattr(kind, name, hit)
sys.argv = ["robodyn", "build", "--workers", sys.argv[4]]
sys.exit(main())
"""


@pytest.mark.parametrize("renamed", representative([0, 2, 4], 2))
def test_a_killed_build_leaves_whole_files_old_or_new(renamed: int, project: Path, capsys: Capture) -> None:
    require_module("fcntl")
    run(capsys, BUILD)
    old = outputs(project)
    (project / "robodyn.toml").write_text(PROJECT.replace('"gravity"', '"bias"'))
    assert python("-c", HIT, "replace", str(renamed), "SIGKILL", "1").returncode == -9
    between = outputs(project)
    run(capsys, BUILD)
    new = outputs(project)
    assert set(new) == set(old) == set(between) == FILES
    assert all(text in (old[name], new[name]) for name, text in between.items())
    assert sum(between[name] == new[name] != old[name] for name in FILES) == renamed
    assert between["robodyn.lock"] == old["robodyn.lock"]
    assert not list(project.rglob(".robodyn.*"))


@pytest.mark.parametrize(
    ("workers", "number", "code", "err"),
    representative(
        [("1", "SIGINT", 130, "robodyn: interrupted\n"), ("2", "SIGINT", 130, "robodyn: interrupted\n"),
         ("2", "SIGTERM", 143, "robodyn: terminated\n"), ("2", "SIGKILL", -9, "")],
        ("2", "SIGINT", 130, "robodyn: interrupted\n"),
    ),
)  # fmt: skip
def test_a_build_that_ends_while_it_generates_has_written_nothing(
    workers: str, number: str, code: int, err: str, project: Path, capsys: Capture
) -> None:
    require_module("fcntl")
    before = tree(project)
    done = python("-c", HIT, "tell", "1", number, workers)
    assert (done.returncode, done.stdout, done.stderr) == (code, "", err)
    assert tree(project) == before
    run(capsys, BUILD)
    assert set(tree(project)) >= FILES


def test_progress_is_a_line_on_a_terminal(project: Path) -> None:
    code, text = on_terminal(BUILD)
    assert code == 0
    assert b"\rrobodyn: 0 of 2 robots generated; one ..." in text
    assert text.endswith(b"\r")


@pytest.mark.thorough
def test_two_builds_at_once_wait_for_each_other(project: Path, capsys: Capture) -> None:
    fcntl = require_module("fcntl")
    with (project / "robodyn.toml").open("rb") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        run(capsys, f"{BUILD} --check", code=1)  # writes nothing, and waits for nobody
        words = [sys.executable, "-m", "robodyn", *BUILD.split()]
        with subprocess.Popen(words, env=environment(), stderr=subprocess.PIPE, text=True) as other:
            assert other.stderr is not None
            assert "another build of robodyn.toml is running" in other.stderr.readline()
            assert not set(tree(project)) & FILES
            fcntl.flock(file, fcntl.LOCK_UN)
            other.communicate()
    assert other.returncode == 0
    assert set(tree(project)) >= FILES
