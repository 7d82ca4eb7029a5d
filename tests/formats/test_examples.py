"""The arms of examples/arms: what robodyn import writes, and listed with their sources."""

from __future__ import annotations

import importlib.metadata
import re
import shlex
from fractions import Fraction
from pathlib import Path

import pytest
from benchmarks.arms import FOLDER, MARK, row
from benchmarks.marked import part

from robodyn.robot import load
from robodyn_cli.main import main
from robodyn_testing import representative
from robodyn_testing.wanted import require_distribution

README = (FOLDER / "README.md").read_text(encoding="utf-8")
COMMANDS = [shlex.split(line)[1:] for line in re.findall(r"(?m)^robodyn import .*$", README)]
ARMS = sorted(FOLDER.glob("*.yaml"))
#: The folders of the commands, and the distributions that bring them.
ROOTS = {
    "$ERD": ("example-robot-data", "cmeel.prefix/share/example-robot-data/robots"),
    "$RTB": ("rtb-data", "rtbdata"),
    "$SUITE": ("robosuite", "robosuite/models/assets/robots"),
}


def test_every_arm_is_listed_and_comes_from_a_command() -> None:
    files = [path.name for path in ARMS]
    assert len(files) > 10
    table = README.partition("```sh")[0]
    assert sorted(re.findall(r"`(\w+\.yaml)`", table)) == files
    assert sorted(command[command.index("-o") + 1] for command in COMMANDS) == files


@pytest.mark.parametrize("path", ARMS, ids=lambda path: path.stem)
def test_an_arm_reads_without_a_doubt(path: Path) -> None:
    arm = load(path, strict=True)
    assert arm.name == path.stem
    assert sum(float(Fraction(str(link.mass))) for link in arm.links) > 0.3
    assert arm.account is not None
    assert "/tmp" not in path.read_text(encoding="utf-8")


#: Robosuite is too large to be installed in CI for its arms.
MARKS = {True: pytest.mark.slow, False: pytest.mark.thorough}


@pytest.mark.parametrize(
    "command",
    [pytest.param(command, id=command[-1], marks=MARKS["$SUITE" in command[1]]) for command in COMMANDS],
)
def test_an_arm_is_what_its_command_writes(command: list[str], tmp_path: Path) -> None:
    root, _, file = command[1].partition("/")
    package, folder = ROOTS[root]
    require_distribution(package)
    path = importlib.metadata.distribution(package).locate_file(f"{folder}/{file}")
    out = tmp_path / command[-1]
    assert main(["import", str(path), *command[2:-1], str(out)]) == 0
    assert out.read_text() == (FOLDER / command[-1]).read_text()


# The table of operations in examples/arms/README.md is what benchmarks/arms.py makes, row by row.

ROWS = part(README, MARK).splitlines()[2:]


def test_every_arm_has_a_row() -> None:
    assert [line.split("|")[1].strip() for line in ROWS] == [path.stem for path in ARMS]


@pytest.mark.parametrize("name", representative([path.stem for path in ARMS], "ur3", rest="slow"))
def test_a_row_is_what_is_counted(name: str) -> None:
    assert row(FOLDER / f"{name}.yaml") in ROWS
