"""Logs piece by piece: the samples of :func:`~robodyn.logs.log.read_log`, in memory that does not grow."""

from __future__ import annotations

import os
from collections.abc import Iterator

from robodyn.errors import InputError
from robodyn.logs.assemble import Block
from robodyn.logs.blocks import log_blocks
from robodyn.logs.log import Log, log_of_block
from robodyn.logs.mapping import LogMap
from robodyn.logs.streams import Mean
from robodyn.logs.windows import Rows, of_length
from robodyn.robot.model import Robot


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
    files that are not packed, no more than a few blocks are in memory. What :mod:`~robodyn.logs.assemble`
    says holds for streams of different times. ``notes`` stand in the piece where they become known,
    ``conditions`` are means over a piece (:func:`~robodyn.logs.streams.together` puts them together).

    Raises
    ------
    InputError: no such file, or not such a log; with file, line and column of what is wrong.
    ToolError: the library for its format is missing.
    """
    if most < 1:
        raise InputError("a piece of a log has one sample or more", found=f"most = {most}")
    notes: list[str] = []
    apart: dict[str, Mean] = {}
    began: float | None = None
    ignored: tuple[str, ...] = ()

    def rows() -> Iterator[Rows]:
        nonlocal began, ignored
        for block in log_blocks(source, n, mapping, robot, whole=False):
            notes.extend(block.notes)
            apart.update(block.apart)
            began = block.began if began is None else began
            ignored = block.ignored
            yield block.rows

    def piece(part: Rows) -> Log:
        log = log_of_block(Block(part, tuple(notes), began, dict(apart), ignored))
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
