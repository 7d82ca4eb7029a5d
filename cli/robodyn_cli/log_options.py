"""How logs are named and read, for every command that takes them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from robodyn_cli.choices import FILE
from robodyn_cli.common import printable, talk

if TYPE_CHECKING:
    from robodyn.logs.log import Log
    from robodyn.logs.mapping import LogMap
    from robodyn.robot import Robot

Command = TypeVar("Command", bound=Callable[..., Any])


def log_options(command: Command) -> Command:
    """Add ``--map`` and ``--columns``, passed to `command` as ``map_file`` and ``columns``, str or None."""
    command = click.option(
        "--columns",
        metavar="TEXT",
        help='Which columns are what, in which unit: "q=joint_%d_pos[deg],tau=current_%d[A]".',
    )(command)
    return click.option(
        "--map",
        "map_file",
        type=FILE,
        metavar="MAP.yaml",
        help="The same as a file (robodyn logs FILE -o MAP.yaml).",
    )(command)


def log_map(map_file: str | None, columns: str | None) -> LogMap | None:
    """The map that the options say; ``--columns`` goes before ``--map``. None if there is neither.

    Raises
    ------
    InputError: one of them is not a map.
    """
    if map_file is None and columns is None:
        return None
    from dataclasses import replace

    from robodyn.logs.mapping import map_of_columns, read_map

    if map_file is None:
        return map_of_columns(columns or "")
    mapping = read_map(map_file)
    if columns is None:
        return mapping
    return replace(mapping, groups={**mapping.groups, **map_of_columns(columns).groups})


def read_logs(
    robot: Robot,
    sources: Sequence[str],
    mapping: LogMap | None,
    tell: Callable[[str], object] = lambda _: None,
) -> list[Log]:
    """The logs of ``robot`` in the files ``sources``; notes on them go to stderr, progress to ``tell``.

    Raises
    ------
    InputError: a file is not such a log.
    ToolError: the library for its format is missing.
    """
    from robodyn.logs.log import read_log

    logs = []
    for source in sources:
        tell(f"robodyn: reading {printable(source)}")
        logs.append(read_log(source, robot.n, mapping=mapping, robot=robot))
        for note in logs[-1].notes:
            talk(f"robodyn: note: {printable(Path(source).name)}: {note}")
    return logs
