"""Files that commands about logs share: the logs themselves, the description's text, the output folder."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from robodyn.errors import InputError
from robodyn_cli import progress
from robodyn_cli.common import printable, talk
from robodyn_cli.log_options import read_logs

if TYPE_CHECKING:
    from robodyn.logs.log import Log
    from robodyn.logs.mapping import LogMap
    from robodyn.robot import Robot


def result_folder(text: str) -> Path:
    """The folder of ``-o``, which need not exist yet.

    Raises
    ------
    InputError: the text is empty, or a file is there.
    """
    if not text:
        raise InputError("the path after -o is empty", remedy="use -o . for this folder")
    folder = Path(text)
    if folder.exists() and not folder.is_dir():
        raise InputError(
            f"cannot write to {printable(folder)}", found="a file", remedy="choose another path with -o"
        )
    return folder


def spare_inputs(outputs: Iterable[Path], inputs: Sequence[str]) -> None:
    """Refuse to overwrite an input, as a second run on its own result would.

    Raises
    ------
    InputError: an output is an input.
    """
    for output in outputs:
        for source in inputs:
            if output.exists() and Path(source).exists() and output.samefile(source):
                raise InputError(
                    f"{printable(output)} is an input and would be overwritten",
                    remedy="choose another folder with -o",
                )


def read_all(
    robot: Robot, paths: Sequence[str], mapping: LogMap | None, shown: progress.Line
) -> tuple[list[Log], list[str]]:
    """The logs of ``robot`` at ``paths``, and their hashes; a word on those that are the same.

    Raises
    ------
    InputError: a file is missing or no log.
    """
    from robodyn.logs.content import digest

    logs = read_logs(robot, paths, mapping, shown.tell)
    hashes = [digest(path) for path in paths]
    for k, path in enumerate(paths):
        if hashes[k] in hashes[:k]:
            shown.clear()
            first = printable(paths[hashes.index(hashes[k])])
            talk(f"robodyn: warning: {printable(path)} is identical to {first} and adds no evidence")
    return logs, hashes


def handed_over(logs: list[Log]) -> list[Callable[[], Log]]:
    """What hands over each of the ``logs``, once. The list is emptied: nothing keeps a long log in memory
    once it was looked at."""
    several: list[Callable[[], Log]] = [[log].pop for log in logs]
    logs.clear()
    return several


def description_of(spec: str) -> str:
    """The text of the robot description ``spec``, of an arm in another format the YAML that it imports to."""
    from robodyn.formats.loading import text_of

    return text_of(spec)
