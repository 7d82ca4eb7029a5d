"""Logs piece by piece: the samples of :func:`~robodyn.logs.log.read_log`, in memory that does not grow."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import replace
from typing import Final

from robodyn.errors import InputError
from robodyn.files import label
from robodyn.logs.assemble import Arrays
from robodyn.logs.conditions import Mean
from robodyn.logs.formats import open_recording, readable
from robodyn.logs.in_pieces import assemble_pieces
from robodyn.logs.log import Log, UsualTable, log_of_arrays, map_for, usual_tables
from robodyn.logs.mapping import LogMap
from robodyn.logs.second_file import Joining, not_as_many, split_pair
from robodyn.logs.streams import CONDITION
from robodyn.logs.windows import Rows, cut, joined_rows, length_of, of_length
from robodyn.robot.model import Robot

#: What the times are called beside groups of columns.
_TIMES: Final = "times"


def pieces(
    source: str | os.PathLike[str],
    n: int | None = None,
    *,
    mapping: LogMap | None = None,
    robot: Robot | None = None,
    most: int,
) -> Iterator[Log]:
    """The log in the file ``source`` in order, ``most`` samples at a time; a short one is one piece.

    Samples, units and refusals are those of :func:`~robodyn.logs.log.read_log`, which has the parameters; a
    refusal comes when what is wrong is reached. A log may be of any length: of tables, bags, HDF5 and numpy's
    files that are not packed, no more than a few blocks are in memory. What :mod:`~robodyn.logs.in_pieces`
    says holds for streams of different times. ``notes`` stand in the piece where they become known,
    ``conditions`` are means over a piece (:func:`~robodyn.logs.conditions.together` puts them together).

    Raises
    ------
    InputError: no such file, or not such a log; with file, line and column of what is wrong.
    ToolError: the library for its format is missing.
    """
    if most < 1:
        raise InputError("a piece of a log has one sample or more", found=f"most = {most}")
    n = robot.n if n is None and robot is not None else n
    if n is not None and n < 1:
        raise InputError("a log is of one joint or more", found=f"n = {n}")
    name, second = split_pair(os.fspath(source))
    file = label(name)
    with readable(file):
        tables = usual_tables(name, second, n) if mapping is None else None
        if tables is not None:
            first, links = tables
            ignored = first.layout.ignored
            blocks = first.blocks() if links is None else _joined(first.blocks(), links)
        else:
            recording = open_recording(name)
            ignored = ()
            blocks = assemble_pieces(
                recording, map_for(recording, second, mapping, robot), n, robot, open_recording
            )
        yield from _logs(blocks, ignored, most)


def _joined(blocks: Iterator[Arrays], links: UsualTable) -> Iterator[Arrays]:
    """The ``blocks`` with the second encoders in ``links``."""
    file = links.recording.file
    tables: Iterator[Rows] = ({"t": each.t, "ql": each.groups["ql"]} for each in links.blocks())
    rows = 0
    waiting: Rows | None = None
    joining = Joining(file)
    for arrays in blocks:
        parts = [waiting] if waiting else []
        count = sum(map(length_of, parts))
        while count < len(arrays.t) and (part := next(tables, None)) is not None:
            parts.append(part)
            count += length_of(part)
        if count < len(arrays.t):
            raise not_as_many(file, rows + count, rows + len(arrays.t) + sum(len(each.t) for each in blocks))
        together = joined_rows(parts)
        waiting = cut(together, len(arrays.t))
        beside = cut(together, 0, len(arrays.t))
        rows += len(arrays.t)
        ql = joining.joined(arrays.t, arrays.groups.get("ql"), beside["t"], beside["ql"])
        yield replace(arrays, groups={**arrays.groups, "ql": ql})
    more = sum(map(length_of, [*([waiting] if waiting else []), *tables]))
    if more:
        raise not_as_many(file, rows + more, rows)


def _logs(blocks: Iterator[Arrays], ignored: tuple[str, ...], most: int) -> Iterator[Log]:
    """The rows of ``blocks``, ``most`` at a time."""
    notes: list[str] = []
    apart: dict[str, Mean] = {}
    began: list[float | None] = [None]

    def rows() -> Iterator[Rows]:
        for block in blocks:
            notes.extend(block.notes)
            apart.update(block.apart)
            began[0] = block.began if began[0] is None else began[0]
            readings = {CONDITION + name: each for name, each in block.readings.items()}
            yield {_TIMES: block.t, **block.groups, **readings}

    def piece(part: Rows) -> Log:
        groups = {name: each for name, each in part.items() if not name.startswith((_TIMES, CONDITION))}
        readings = {
            name.removeprefix(CONDITION): each for name, each in part.items() if name.startswith(CONDITION)
        }
        log = log_of_arrays(
            Arrays(part[_TIMES], groups, tuple(notes), began[0], readings, dict(apart)), ignored
        )
        notes.clear()
        apart.clear()
        return log

    last: Rows | None = None  # kept back: what comes after it may have notes
    for part in of_length(rows(), most):
        if last is not None:
            yield piece(last)
        last = part
    assert last is not None
    yield piece(last)
