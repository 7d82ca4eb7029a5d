"""Streams that are read in pieces: put in order, cut to length, and interpolated at the times of others,
each with no more in memory than it needs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.logs.limits import APART

#: Columns [k] or [k, m] of the same rows, by name.
Rows = Mapping[str, NDArray[Any]]

#: Rows that may have come too early or too late by so many places.
WINDOW: Final = 1 << 16
#: Windows of one stream that are in memory while another's times are waited for.
WAITING: Final = 64


def length_of(rows: Rows) -> int:
    """How many there are."""
    return len(next(iter(rows.values())))


def joined_rows(parts: list[Rows]) -> Rows:
    """The rows of ``parts``, one part after the other."""
    if len(parts) == 1:
        return parts[0]
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def cut(rows: Rows, start: int, end: int | None = None) -> Rows:
    """The rows from ``start`` on, before ``end``."""
    return {name: array[start:end] for name, array in rows.items()}


def of_length(parts: Iterator[Rows], most: int) -> Iterator[Rows]:
    """The rows of ``parts``, ``most`` at a time; the last may be fewer."""
    waiting: list[Rows] = []
    count = 0
    for part in parts:
        waiting.append(part)
        count += length_of(part)
        while count >= most:
            rows = joined_rows(waiting)
            yield {name: np.ascontiguousarray(array) for name, array in cut(rows, 0, most).items()}
            count -= most
            waiting = [cut(rows, most)]
    if count:
        yield joined_rows(waiting)


def in_order(parts: Iterator[Rows], key: str, window: int, file: str) -> Iterator[Rows]:
    """The rows of ``parts`` by rising ``key``, equal ones as they stood: what sorting all of them gives.

    Raises
    ------
    InputError: a row comes later by more than ``window`` places.
    """
    waiting: list[Rows] = []
    count = 0
    last: Any = None  # of the rows that have been handed on

    def in_turn() -> Rows:
        rows = joined_rows(waiting)
        values = rows[key]
        if last is not None and values.min() < last:
            raise InputError(
                "the rows are too far out of order to be read in pieces",
                where=Place(file),
                found=f"a row that is late by more than {window} rows",
                remedy="sort the file by time, or take a part of it that can be read at once",
            )
        if (np.diff(values) >= 0).all():
            return rows
        order = np.argsort(values, kind="stable")
        return {name: array[order] for name, array in rows.items()}

    for part in parts:
        waiting.append(part)
        count += length_of(part)
        if count < 2 * window:
            continue
        rows = in_turn()
        yield cut(rows, 0, count - window)
        last = rows[key][count - window - 1]
        waiting, count = [cut(rows, count - window)], window
    if count:
        yield in_turn()


class Interpolation:
    """The columns of ``parts``, which have ``times`` [k] and ``columns`` [k, m], at any times that mostly
    rise; ``step``: the median between their own times, ``width``: how many columns. Rows may be late by a
    ``window``."""

    def __init__(self, parts: Iterator[Rows], step: float, width: int, window: int, file: str) -> None:
        sound = ({name: array[np.isfinite(part["times"])] for name, array in part.items()} for part in parts)
        self._parts = in_order(sound, "times", window, file)
        self._step, self._window, self._file = step, window, file
        self._rows: Rows = {"times": np.empty(0), "columns": np.empty((0, width))}
        self._is_dropped = False

    def at(self, t: Floats) -> Floats:
        """The columns [k, m] at ``t`` [k]: NaN before, behind, and where their times are further apart than
        :data:`APART` steps.

        Raises
        ------
        InputError: ``t`` goes back, or ahead, by more than is in memory.
        """
        finite = t[np.isfinite(t)]
        if len(finite):
            self._reach(float(finite.max()))
            if self._is_dropped and finite.min() <= self._rows["times"][0]:
                raise self._refusal("times that go back")
        times, columns = self._rows["times"], self._rows["columns"]
        result = np.full((len(t), columns.shape[1]), np.nan)
        if len(times):
            for k in range(columns.shape[1]):
                result[:, k] = np.interp(t, times, columns[:, k], left=np.nan, right=np.nan)
        if len(times) > 1:
            after = np.clip(np.searchsorted(times, t), 1, len(times) - 1)
            result[np.diff(times)[after - 1] > APART * self._step] = np.nan
        if len(finite):  # what lies before by more than a window is not needed any more
            before = int(np.searchsorted(times, float(finite.max()))) - 1 - self._window
            if before > 0:
                self._rows, self._is_dropped = cut(self._rows, before), True
        return result

    def _reach(self, t: float) -> None:
        """Read on until there is a row after ``t``, or no more."""
        waiting = [self._rows]
        count = length_of(self._rows)
        while not len(waiting[-1]["times"]) or waiting[-1]["times"][-1] <= t:
            part = next(self._parts, None)
            if part is None:
                break
            waiting.append(part)
            count += length_of(part)
            if count > WAITING * self._window:
                raise self._refusal("times that leap ahead")
        self._rows = joined_rows(waiting)

    def _refusal(self, what: str) -> InputError:
        return InputError(
            "streams cannot be brought to one time in pieces",
            where=Place(self._file),
            found=what,
            expected="times that rise",
            remedy="correct the times, or take a part of it that can be read at once",
        )
