"""What the commands share: arguments, output, and writing files whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, TypeVar

import click

from robodyn.errors import InputError

if TYPE_CHECKING:
    from robodyn.robot import Robot

Command = TypeVar("Command", bound=Callable[..., Any])


def robot_argument(command: Command) -> Command:
    """Add the argument ROBOT, passed to `command` as ``robot: str``; it is not looked at here."""
    return click.argument("robot", metavar="ROBOT")(command)


def json_option(command: Command) -> Command:
    """Add the flag ``--json``, passed to `command` as ``as_json: bool``."""
    return click.option("--json", "as_json", is_flag=True, help="Print the data as JSON on stdout.")(command)


def echo_json(obj: object) -> None:
    """Print `obj` on stdout as indented JSON; keys keep their order, and NaN is refused (ValueError)."""
    import json

    click.echo(json.dumps(obj, indent=2, ensure_ascii=False, allow_nan=False))


def talk(text: str) -> None:
    """Print `text` on stderr: for the person who watches, not for the program that reads stdout."""
    click.echo(text, err=True)


def load_robot(robot: str, *, strict: bool = False) -> Robot:
    """Load ROBOT, a path or a bundled name; doubts about its numbers go to stderr, one line each.

    Raises
    ------
    InputError: there is no such robot, the file is wrong, or `strict` and there are doubts.
    """
    from robodyn.robot import load

    return load(robot, strict=strict, warn=lambda text: talk(f"robodyn: warning: {text}"))


def write_files(folder: Path, files: Mapping[str, str]) -> list[Path]:
    """Write `files` (path relative to `folder` -> text), each whole or not at all; return their paths.

    All are written under temporary names beside their places first, and take their names only when all of
    them are there. On an error the temporary files, and the folders made for them, are removed again.

    Raises
    ------
    InputError: the system refused, or something that is not a file is in the way.
    """
    targets = [folder / name for name in files]
    new_folders = _missing_folders(target.parent for target in targets)
    temporary: list[Path] = []
    path = folder
    try:
        for path, text in zip(targets, files.values(), strict=True):
            if path.exists() and not path.is_file():
                raise InputError(
                    f"cannot write {path}", found="something that is not a file there", remedy=_ELSEWHERE
                )
            path.parent.mkdir(parents=True, exist_ok=True)
            temporary.append(path.with_name(f".{path.name}.{os.getpid()}.tmp"))
            temporary[-1].write_text(text, encoding="utf-8", newline="\n")
        for path, source in zip(targets, temporary, strict=True):
            source.replace(path)
    except BaseException as error:
        _remove(temporary, new_folders)
        if isinstance(error, OSError):
            reason = error.strerror or str(error)
            raise InputError(f"cannot write {path}: {reason}", remedy=_ELSEWHERE) from error
        raise
    return targets


_ELSEWHERE: Final = "choose another place with -o, or make room there"


def _missing_folders(folders: Iterable[Path]) -> list[Path]:
    """The folders, and the ones above them, that do not exist yet: deepest first."""
    missing = {level for folder in folders for level in (folder, *folder.parents) if not level.exists()}
    return sorted(missing, key=lambda level: len(level.parts), reverse=True)


def _remove(temporary: list[Path], folders: list[Path]) -> None:
    for path in temporary:
        path.unlink(missing_ok=True)
    for folder in folders:
        if folder.is_dir() and not any(folder.iterdir()):
            folder.rmdir()


def compare_files(folder: Path, files: Mapping[str, str]) -> list[str]:
    """The names among `files` (path relative to `folder` -> text) that are missing there or differ, in order.

    Bytes are compared, so line endings count. Other files in the folder are not looked at.
    """
    return [name for name, text in files.items() if _read(folder / name) != text.encode("utf-8")]


def _read(path: Path) -> bytes | None:
    try:
        return path.read_bytes()
    except OSError:
        return None
