"""Where records lie: in a folder ``records`` beside the robot's file, and with the bundled robots."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from pathlib import Path

from robodyn.optimize.records.record import Record, header, parse_record
from robodyn.resources import RECORDS, data_dir, from_here
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot

#: The folder's name, beside the robot files.
FOLDER = RECORDS
_SUFFIX = ".record"
#: A file with more bytes is no record; a tenth of it holds an arm of 30 joints with full inertias.
_LARGEST = 2_000_000
#: Of so many files in a folder the fields are looked at, besides the one that is named after the robot.
_MOST_FILES = 1000
#: The fields of a record stand within so many characters.
_HEAD = 4000


def bundled_records() -> Path:
    """The folder of the records that come with robodyn."""
    return data_dir("robots") / FOLDER


def records_of_arms() -> Path:
    """The folder of those of arms in public files (examples/arms), which come with it as well."""
    return bundled_records() / "arms"


def folder_beside(robot: Robot) -> Path:
    """The folder of the records beside the file that ``robot`` was read from; the bundled one for a robot
    that came from no file."""
    return bundled_records() if robot.file is None else robot.file.parent / FOLDER


def file_name(robot: str, function: str, objective: str) -> str:
    """What the file of a record is called."""
    return f"{robot}.{function}.{_word(objective)}{_SUFFIX}"


def best_record(
    robot: Robot, function: str, objective: str = "total", folders: Sequence[Path] = ()
) -> Record | None:
    """The record of ``function`` of a robot with exactly these parameters, or None.

    ``folders`` are looked through first, then the one beside the robot's file, then the bundled records; the
    first one found counts. A record is found by its parameters and not by its file's name, so a copy of a
    robot has the same. The same arm in other frames has it too (:func:`.validation.adopted`).

    Raises
    ------
    InputError: a record of this robot is damaged.
    """
    wanted = identity(robot)
    for path, fields in _headers(robot, function, objective, folders):
        if fields["identity"] == wanted:
            return record_at(path)
    return None


def records_with_keys(
    robot: Robot, function: str, objective: str = "total", folders: Sequence[Path] = ()
) -> Iterator[tuple[str, Path]]:
    """Records of ``function`` of any robot, looked for where :func:`best_record` looks, each with the
    :func:`.function_key` that its head states."""
    for path, fields in _headers(robot, function, objective, folders):
        if "computes" in fields:
            yield fields["computes"], path


def _headers(
    robot: Robot, function: str, objective: str, folders: Sequence[Path]
) -> Iterator[tuple[Path, dict[str, str]]]:
    """The records of ``function`` for ``objective`` of any robot, and what their heads say."""
    for folder in dict.fromkeys((*folders, folder_beside(robot), bundled_records(), records_of_arms())):
        for spelling in _spellings(objective):
            for path in _candidates(folder, robot.name, function, spelling):
                fields = header(_read(path, _HEAD))
                if (fields.get("function"), fields.get("objective")) == (function, spelling):
                    yield path, fields


def record_at(path: Path) -> Record:
    """The record in ``path``.

    Raises
    ------
    InputError: it is damaged.
    """
    return parse_record(_read(path, _LARGEST), str(from_here(path)))


def identity_at(path: Path) -> str | None:
    """Which robot the record in ``path`` is of; None where there is no record."""
    return header(_read(path, _HEAD)).get("identity")


def _spellings(objective: str) -> tuple[str, ...]:
    """``objective``, and of one for a target with several names the others: records outlive a name."""
    kind, _, name = objective.partition(":")
    if not name:
        return (objective,)
    from robodyn.targets import target_named

    target = target_named(name)
    return tuple(f"{kind}:{spelling}" for spelling in (target.name, *target.aliases))


def _candidates(folder: Path, robot: str, function: str, objective: str) -> Iterator[Path]:
    likely = folder / file_name(robot, function, objective)
    yield likely
    try:
        named = folder.glob(f"*.{function}.{_word(objective)}{_SUFFIX}")
        others = sorted(itertools.islice(named, _MOST_FILES))
    except OSError:
        return
    yield from (path for path in others if path != likely)


def _read(path: Path, characters: int) -> str:
    """The beginning of a file; nothing of what is no file, or too large for a record."""
    try:
        if not path.is_file() or path.stat().st_size > _LARGEST:  # a pipe would wait for its writer
            return ""
        with path.open(encoding="utf-8", errors="replace") as file:
            return file.read(characters)
    except OSError:
        return ""


def _word(objective: str) -> str:
    """``weighted:cortex-m4f`` as a part of a file's name."""
    return "".join(letter if letter.isalnum() or letter in "-_" else "-" for letter in objective)
