"""What commands about logs share: their options, the logs, the description's text, the output folder."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from robodyn.errors import InputError
from robodyn.outputs import check_outputs
from robodyn_cli import progress
from robodyn_cli.choices import FILE
from robodyn_cli.decorators import add_options, option
from robodyn_cli.output import printable, talk
from robodyn_cli.output_files import output_folder
from robodyn_cli.robot_files import load_robot, parameter_values

if TYPE_CHECKING:
    from robodyn.logs.log import Log
    from robodyn.logs.mapping import LogMap
    from robodyn.robot import Robot


Result = TypeVar("Result")


def _map_help() -> str:
    from robodyn.logs.formats import FORMATS

    suffixes = {suffix for each in FORMATS.values() for suffix in each.suffixes}
    ends = ", ".join(sorted(suffixes))
    return f"The same as --columns in a file (robodyn logs FILE -o MAP.yaml). Logs end in {ends}."


log_options = add_options(
    option("--map=MAP.yaml map_file", _map_help, FILE),
    option(
        "--columns=TEXT",
        'Which columns are what, in which unit: "q=joint_%d_pos[deg],tau=current_%d[A]".',
    ),
)
"""Adds ``--map`` and ``--columns``, passed as ``map_file`` and ``columns``, str or None."""


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


def spare_inputs(outputs: Iterable[Path], inputs: Sequence[str]) -> None:
    """Refuse to overwrite an input, as a second run on its own result would.

    Raises
    ------
    InputError: an output is an input.
    """
    for output in outputs:
        for source in inputs:
            if output.exists() and os.path.exists(source) and output.samefile(source):  # noqa: PTH110 (never raises)
                raise InputError(
                    f"{printable(output)} is an input and would be overwritten",
                    remedy="choose another name with -o",
                )


def read_all(
    robot: Robot, paths: Sequence[str], mapping: LogMap | None, shown: progress.Line
) -> tuple[list[Log], list[str]]:
    """The logs of ``robot`` at ``paths``, and their hashes; notes on them, and on those that are the same, go
    to stderr, progress to ``shown``.

    Raises
    ------
    InputError: a file is missing or no log.
    ToolError: the library for its format is missing.
    """
    from robodyn.logs.content import digest
    from robodyn.logs.log import read_log

    logs = []
    for path in paths:
        shown.tell(f"robodyn: reading {printable(path)}")
        logs.append(read_log(path, robot.n, mapping=mapping, robot=robot))
        for note in logs[-1].notes:
            talk(f"robodyn: note: {printable(Path(path).name)}: {note}")
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
    sources: list[Callable[[], Log]] = [[log].pop for log in logs]
    logs.clear()
    return sources


def outputs_for(robot: str, options: Mapping[str, Any], names: Sequence[str]) -> Path:
    """The folder of -o (``out``), in which files of these ``names`` can be written and are no inputs.

    Raises
    ------
    InputError, OutputError: they cannot, or are.
    """
    from robodyn.logs.content import input_files

    folder = output_folder(options["out"])
    inputs = [robot, *(str(file) for path in _paths(options) for file in input_files(path))]
    spare_inputs([folder / name for name in names], inputs)
    check_outputs(folder, names)
    return folder


def run_on_logs(
    work: Callable[..., Result],
    stages: Callable[[int, list[Log]], Mapping[str, float]],
    robot: str,
    given: Mapping[str, Any],
    **others: Any,
) -> Result:
    """What ``work`` (:func:`robodyn.diagnose.run.diagnose` or its like) says of the description ``robot`` and
    the logs of the options ``given`` (``logs``, ``validate``, ``map_file``, ``columns``, ``param``,
    ``strict``), while a line shows its ``stages``."""
    from robodyn.formats.loading import text_of

    described = load_robot(robot, strict=given["strict"])
    values = parameter_values(described, given["param"]) or None
    paths, count = _paths(given), len(given["logs"])
    with progress.line() as shown:
        mapping = log_map(given["map_file"], given["columns"])
        logs, hashes = read_all(described, paths, mapping, shown)
        costs = stages(described.n, logs)
        sources = handed_over(logs)
        with progress.countdown(shown, f"robodyn: {described.name}", costs) as tell:
            return work(
                described, sources[:count], sources[count] if len(sources) > count else None,
                text=text_of(robot), names=[printable(Path(path).name) for path in paths], hashes=hashes,
                parameters=values, progress=tell, **others,
            )  # fmt: skip


def _paths(options: Mapping[str, Any]) -> list[str]:
    validate = options["validate"]
    return [*options["logs"], *([] if validate is None else [validate])]
