"""Second encoders in a file of their own: ``arm.csv+arm_secondary.csv``."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.logs.columns import Layout
from robodyn.logs.limits import SAME_TIME
from robodyn.logs.mapping import JOINTS as MOST_JOINTS
from robodyn.logs.mapping import Channel, LogMap
from robodyn.logs.recording import Recording

Floats = NDArray[np.float64]


def split_pair(name: str) -> tuple[str, str | None]:
    """The two files that ``name`` stands for: ``A+B`` is A and B, unless a file is called so."""
    if "+" not in name or Path(name).exists():
        return name, None
    places = [k for k, mark in enumerate(name) if mark == "+"]
    # A plus may be part of a file's name: the parts that are there are meant.
    for k in places:
        if Path(name[:k]).is_file() and Path(name[k + 1 :]).is_file():
            return name[:k], name[k + 1 :]
    first = next((k for k in places if Path(name[:k]).exists()), places[0])
    return name[:first], name[first + 1 :]


def files_of(name: str) -> tuple[str, ...]:
    """The paths of the file or files that ``name`` stands for."""
    first, second = split_pair(name)
    return (first,) if second is None else (first, second)


def with_second(mapping: LogMap, recording: Recording, file: str) -> LogMap:
    """``mapping`` with the second encoders in the second ``file``, the ``recording``: as it says, else
    ``ql1`` and so on.

    Raises
    ------
    InputError: there are no such columns.
    """
    channel = mapping.groups.get("ql")
    if channel is None:
        columns = {column for stream in recording.streams for column in stream.columns}
        joints = tuple(j for j in range(1, MOST_JOINTS) if f"ql{j}" in columns)
        if not joints:
            raise InputError(
                "the file lacks columns of second encoders",
                where=Place(recording.file),
                found="no ql1, ql2, ...",
                expected="one of them or more, or a map with ql",
            )
        channel = Channel(tuple(f"ql{j}" for j in joints), Place(recording.file), joints=joints)
    return replace(mapping, groups={**mapping.groups, "ql": replace(channel, file=file)})


def spread(columns: Floats, layout: Layout) -> Floats:
    """``columns`` [K, m] of the joints that have a second encoder as [K, n], NaN for all others."""
    if len(layout.linked) == layout.n:
        return columns
    ql = np.full((len(columns), layout.n), np.nan)
    ql[:, list(layout.linked)] = columns
    return ql


class Joining:
    """Puts the columns of second encoders in the ``file`` beside those of a log, row by row."""

    def __init__(self, file: str) -> None:
        self._file = file
        self._near: float | None = None
        self._rows = 0
        self._in_first, self._in_second = np.array(False), np.array(False)

    def joined(self, t: Floats, ql: Floats | None, times: Floats, second: Floats) -> Floats:
        """``second`` [K, n], at its ``times`` [K], beside the next rows of a log, of the times ``t`` [K],
        that has the columns ``ql`` itself.

        Raises
        ------
        InputError: the times are not the same, or a joint's column is in both files.
        """
        steps = np.diff(t)
        steps = steps[steps > 0]
        if self._near is None:
            self._near = SAME_TIME * float(np.median(steps)) if len(steps) else 0.0
        apart = np.flatnonzero(~(np.abs(times - t) <= self._near) & ~(np.isnan(times) & np.isnan(t)))
        if len(apart):
            k = int(apart[0])
            raise InputError(
                "the two files are not of the same times",
                where=Place(self._file),
                found=f"t = {times[k]:.9g} s in row {self._rows + k + 1}",
                expected=f"{t[k]:.9g} s, as in the first file",
                remedy="write both at the same times",
            )
        self._rows += len(t)
        if ql is None:
            return second
        self._in_first = self._in_first | ~np.isnan(ql).all(axis=0)
        self._in_second = self._in_second | ~np.isnan(second).all(axis=0)
        both = np.flatnonzero(self._in_first & self._in_second)
        if len(both):
            raise InputError(
                "a joint has two second encoders",
                where=Place(self._file),
                found=f"ql{both[0] + 1} in both files",
                remedy="delete one of the columns",
            )
        return np.where(np.isnan(ql), second, ql)


def not_as_many(file: str, rows: int, beside: int) -> InputError:
    """What to say of a second ``file`` with other ``rows`` than the first has."""
    return InputError(
        "the two files are not of the same samples",
        where=Place(file),
        found=f"{rows} rows",
        expected=f"{beside}, as in the first file",
        remedy="write both at the same times",
    )
