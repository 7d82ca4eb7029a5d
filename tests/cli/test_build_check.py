"""``robodyn build --check``, which a CI job calls: each fault has its line and exit code 1."""

from __future__ import annotations

import json
import re
import shutil
import tomllib
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest

from cli.generated import Capture, tree
from records.made import ELBOW
from robodyn_cli.main import main

PROJECT = """\
[robots.elbow]
robot = "elbow.yaml"
functions = ["inverse_dynamics", "gravity"]
lang = "c"
"""
SOURCE = Path("generated/elbow/elbow.c")
LOCK = Path("robodyn.lock")


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project that was built, and the store of what it was built of."""
    folder = tmp_path_factory.mktemp("project")
    (folder / "elbow.yaml").write_text(ELBOW)
    (folder / "robodyn.toml").write_text(PROJECT)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("ROBODYN_CACHE", str(folder.parent / "store"))
        assert main(["build", "--file", str(folder / "robodyn.toml")]) == 0
    return folder


@pytest.fixture
def project(built: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of the project."""
    folder = tmp_path / "copy"
    shutil.copytree(built, folder)
    monkeypatch.chdir(folder)
    monkeypatch.setenv("ROBODYN_CACHE", str(built.parent / "store"))
    return folder


def changed_file() -> None:
    """Line 40 of a file, or so, says something else."""
    text = SOURCE.read_text()
    line = next(line for line in text.splitlines() if line.startswith("    const"))
    SOURCE.write_text(text.replace(line, "    mine"))


def missing_file() -> None:
    SOURCE.unlink()


def longer_file() -> None:
    with SOURCE.open("a") as file:
        file.write("mine\n")


def worse_count() -> None:
    """The lock file knows two additions fewer than there are."""
    shift(-2)


def better_count() -> None:
    shift(1)


def shift(more: int) -> None:
    """So many additions more in the lock file, of the first function."""
    text = LOCK.read_text()
    for kind in ("add", "total"):
        text = re.sub(
            rf"\b{kind} = (\d+)", lambda m: f"{m[0].split()[0]} = {int(m[1]) + more}", text, count=1
        )
    LOCK.write_text(text)


def missed_budget() -> None:
    with Path("robodyn.toml").open("a") as file:
        file.write("budgets.inverse_dynamics = { mul = 5000, total = 10 }\n")


def missing_lock() -> None:
    LOCK.unlink()


def other_robots() -> None:
    LOCK.write_text(LOCK.read_text().replace("robots.elbow", "robots.other"))


def other_hash() -> None:
    LOCK.write_text(re.sub(r'("elbow\.c" = ")....', r"\g<1>0000", LOCK.read_text()))


FAULTS = [
    (changed_file, "file", r"generated/elbow/elbow\.c differs from line \d+ on: found '    mine', exp"),
    (missing_file, "file", r"generated/elbow/elbow\.c is missing"),
    (longer_file, "file", r"generated/elbow/elbow\.c differs from line \d+ on: found 'mine', expected ''"),
    (missed_budget, "budget", r"elbow: inverse_dynamics: total (\d+) is \d+ over the budget of 10"),
    (worse_count, "count", r"elbow: inverse_dynamics got worse: add \d+, locked \d+ \(\+2\), total "),
    (better_count, "lock", r"robodyn\.lock is not up to date: elbow has other counts of inverse_dynamics"),
    (missing_lock, "lock", r"robodyn\.lock is missing"),
    (other_robots, "lock", r"robodyn\.lock is not up to date: elbow is not in it"),
    (other_hash, "lock", r"robodyn\.lock is not up to date: elbow has other files now"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("spoil", "kind", "line"), FAULTS, ids=lambda value: getattr(value, "__name__", None)
)
def test_each_fault_has_its_line_and_exit_code_1(
    spoil: Callable[[], None], kind: str, line: str, project: Path, capsys: Capture
) -> None:
    assert main(["build", "--check"]) == 0
    spoil()
    before = tree(project)
    capsys.readouterr()
    assert main(["build", "--check", "--json"]) == 1
    out, err = capsys.readouterr()
    faults = json.loads(out)["faults"]
    assert kind in {fault["kind"] for fault in faults}
    assert re.search(rf"(?m)^robodyn: error: {line}", err)
    assert len(faults) == len(err.splitlines()) - 1 == (2 if spoil is other_robots else 1)
    assert tree(project) == before


def test_a_build_mends_all_but_a_missed_budget(project: Path, capsys: Capture) -> None:
    before = tree(project)
    for spoil in (changed_file, worse_count):
        spoil()
    assert main(["build"]) == 0
    assert "robodyn: note: elbow: inverse_dynamics got worse: add " in capsys.readouterr().err
    assert tree(project) == before
    missed_budget()
    assert main(["build"]) == 1
    assert "over the budget of 10" in capsys.readouterr().err


def test_the_table_says_what_changed(project: Path, capsys: Capture) -> None:
    lock = tomllib.loads(LOCK.read_text())["robots"]["elbow"]["counts"]
    count = lock["inverse_dynamics"]
    worse_count()
    missed_budget()
    assert main(["build", "--check"]) == 1
    heads, row, summary = capsys.readouterr().out.splitlines()
    assert heads.split() == ["robot", "function", "mul", "add", "div", "total", "sincos", "change", "budget"]
    cells = re.split(r"  +", row)
    assert cells[:3] == ["elbow", "inverse_dynamics", str(count["mul"])]
    assert cells[3:5] == [f"{count['add'] - 2} -> {count['add']}", "0"]
    assert cells[5:7] == [f"{count['total'] - 2} -> {count['total']}", str(count["sincos"])]
    assert cells[7:] == ["worse", "mul 5000, total 10 over"]
    total = sum(each["total"] for each in lock.values())
    assert summary == f"1 robot, 2 functions, {total} operations; 1 changed"


def test_counts_against_the_lock_file_of_another_branch(project: Path, capsys: Capture) -> None:
    shutil.copy(LOCK, "ours.lock")
    worse_count()
    LOCK.rename("theirs.lock")
    shutil.copy("ours.lock", LOCK)
    assert main(["build", "--check"]) == 0
    assert main(["build", "--check", "--against", "theirs.lock"]) == 1
    assert "elbow: inverse_dynamics got worse: add " in capsys.readouterr().err
    assert main(["build", "--check", "--against", "no.lock"]) == 2
    assert "there is no lock file of this name; found no.lock" in capsys.readouterr().err


def test_junit(project: Path, capsys: Capture) -> None:
    worse_count()
    missing_file()
    assert main(["build", "--check", "--format", "junit", "-o", "out/report.xml"]) == 1
    assert "1 robot, 2 functions" in capsys.readouterr().out
    root = ElementTree.parse("out/report.xml").getroot()
    assert (root.tag, root.attrib) == ("testsuites", {"tests": "5", "failures": "2"})
    cases = {(case.get("classname"), case.get("name")): case for case in root.iter("testcase")}
    assert list(cases) == [
        ("elbow", "generated/elbow/elbow.h"),
        ("elbow", "generated/elbow/elbow.c"),
        ("elbow", "inverse_dynamics"),
        ("elbow", "gravity"),
        ("robodyn.lock", "up to date"),
    ]
    failures = {name: case.find("failure") for (_, name), case in cases.items()}
    assert {name for name, failure in failures.items() if failure is not None} == {
        "generated/elbow/elbow.c",
        "inverse_dynamics",
    }
    failure = failures["generated/elbow/elbow.c"]
    assert failure is not None
    assert failure.get("message") == "generated/elbow/elbow.c is missing"


def test_markdown(project: Path, capsys: Capture) -> None:
    worse_count()
    assert main(["build", "--check", "--format", "markdown"]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "### robodyn: robodyn.toml failed"
    assert lines[2].startswith("- elbow: inverse\\_dynamics got worse: add ")
    head, rule, row = (line.strip("|").split("|") for line in lines[4:7])
    assert len(head) == len(rule) == len(row) == 9
    assert re.fullmatch(r" \d+ -\\> \d+ ", row[5])
    assert main(["build"]) == 0
    capsys.readouterr()
    assert main(["build", "--check", "--format", "markdown"]) == 0
    assert capsys.readouterr().out.splitlines()[0] == "### robodyn: robodyn.toml passed"


def test_the_report_is_the_same_twice(project: Path, capsys: Capture) -> None:
    changed_file()
    reports = set()
    for _ in range(2):
        main(["build", "--check", "--json"])
        reports.add(capsys.readouterr().out)
    assert len(reports) == 1


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--format", "xml"], "unknown format 'xml'; expected one of text, json, junit, markdown"),
        (["--format", "junt"], "did you mean 'junit'?"),
        (["--format", "junit", "--json"], "--json is --format json"),
        (["--file", "no.toml"], "no.toml: there is no project file of this name"),
        (["--workers", "0"], "--workers"),
    ],
)
def test_options_that_are_refused(arguments: list[str], message: str, project: Path, capsys: Capture) -> None:
    before = tree(project)
    assert main(["build", "--check", *arguments]) == 2
    assert message in capsys.readouterr().err
    assert tree(project) == before
