"""Where records are looked for, and what lies there besides."""

from __future__ import annotations

import os
import shutil
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from records.made import ELBOW, arm, better, fast, recorded
from robodyn import InputError
from robodyn.optimize.records import FOLDER, best_record
from robodyn.optimize.records.find import file_name
from robodyn.robot import Robot
from robodyn.search.improve import write_record

ROBOT = arm(ELBOW)
NAME = "elbow.inverse_dynamics.total.record"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with the record of the elbow."""
    found = tmp_path / FOLDER
    write_record(better(ROBOT), found)
    assert [path.name for path in found.iterdir()] == [NAME]
    return found


def look(robot: Robot, *folders: Path, objective: str = "total") -> str | None:
    found = best_record(robot, "inverse_dynamics", objective, folders)
    return None if found is None else found.text()


def test_a_record_is_found_by_parameters_and_not_by_names(folder: Path) -> None:
    text = better(ROBOT).text()
    assert look(ROBOT, folder) == text
    copy = replace(ROBOT, name="copy", title="", source="elsewhere")
    assert look(copy, folder) == text
    (folder / NAME).rename(folder / "anything at all.inverse_dynamics.total.record")
    assert look(ROBOT, folder) == text
    assert look(copy, folder) == text
    link = replace(ROBOT.links[0], mass=ROBOT.links[0].mass + Fraction(1, 10**9))
    assert look(replace(ROBOT, links=(link, *ROBOT.links[1:])), folder) is None
    assert best_record(ROBOT, "bias", "total", (folder,)) is None
    assert look(ROBOT, folder, objective="mul") is None
    assert look(ROBOT) is None


def test_the_first_folder_counts(folder: Path, tmp_path: Path) -> None:
    other = tmp_path / "other"
    text = write_record(recorded(ROBOT, fast(ROBOT)), other).read_text()
    assert text != better(ROBOT).text()
    assert look(ROBOT, other, folder) == text
    assert look(ROBOT, folder, other) == better(ROBOT).text()
    (folder / "a.inverse_dynamics.total.record").write_bytes(b"\xff\xfe\x00" * 100)  # another robot's damage
    for nowhere in (tmp_path / "nowhere", other / NAME, other / NAME / "below", Path("/dev/null")):
        assert look(ROBOT, nowhere, folder) == better(ROBOT).text()


@pytest.mark.parametrize(
    ("old", "new"), [(b"\ntau = ", b"\n\xfftau = "), (b"%3 = ", b"%4 = "), (b" mul ", b" m\x80l ")], ids=str
)
def test_damage_in_its_own_is(folder: Path, old: bytes, new: bytes) -> None:
    path = folder / NAME
    path.write_bytes(path.read_bytes().replace(old, new, 1))
    with pytest.raises(InputError, match=r"elbow\.inverse_dynamics\.total\.record:\d+: "):
        look(ROBOT, folder)


@pytest.mark.parametrize("what", ["pipe", "folder", "loop", "device", "huge"])
def test_what_is_no_file_is_passed_over(folder: Path, what: str) -> None:
    path = folder / NAME
    path.unlink()
    if what == "pipe":
        os.mkfifo(path)
    elif what == "folder":
        path.mkdir()
    elif what == "loop":
        path.symlink_to(path)
    elif what == "device":
        path.symlink_to("/dev/zero")
    else:
        with path.open("wb") as file:
            file.truncate(1 << 40)
    assert look(ROBOT, folder) is None
    write_record(better(ROBOT), folder / "more")
    shutil.move(folder / "more" / NAME, folder / f"z{NAME}")
    assert look(ROBOT, folder) == better(ROBOT).text()


@pytest.mark.parametrize("objective", ["weighted:cortex-m4", "mul"])
def test_objectives_make_plain_file_names(objective: str, tmp_path: Path) -> None:
    record = recorded(ROBOT, fast(ROBOT), objective=objective)
    path = write_record(record, tmp_path)
    assert path.name == file_name("elbow", "inverse_dynamics", objective)
    assert not set(path.name) & set(":/\\ ")
    assert look(ROBOT, tmp_path, objective=objective) == record.text()
    if objective != "mul":  # another name of the target
        assert look(ROBOT, tmp_path, objective="weighted:cortex-m4f") == record.text()
        assert look(ROBOT, tmp_path, objective="weighted:cortex-m7") is None


def test_two_robots_of_one_name_keep_their_records(tmp_path: Path) -> None:
    heavier = replace(ROBOT, gravity=(ROBOT.gravity[0], ROBOT.gravity[1], Fraction(-10)))
    for _ in range(2):
        for robot in (ROBOT, heavier):
            write_record(recorded(robot, fast(robot)), tmp_path)
    assert len(list(tmp_path.iterdir())) == 2
    for robot in (ROBOT, heavier):
        assert look(robot, tmp_path) == recorded(robot, fast(robot)).text()
