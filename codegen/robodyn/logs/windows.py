"""Streams that are read in pieces: put in order, cut to length, and interpolated at the times of others,
each with no more in memory than it needs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.logs.limits import APART

Floats = NDArray[np.float64]
#: Columns [k] or [k, m] of the same rows, by name.
Rows = Mapping[str, NDArray[Any]]

#: Rows that may have come too early or too late by so many places.
WINDOW: Final = 1 << 16
#: Rows of one stream that are in memory while another's times are waited for.
MOST_WAITING: Final = 1 << 22


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


def in_order(parts: Iterator[Rows], key: str, file: str) -> Iterator[Rows]:
    """The rows of ``parts`` by rising ``key``, equal ones as they stood: what sorting all of them gives.

    Raises
    ------
    InputError: a row comes later by more than :data:`WINDOW` places.
    """
    window = WINDOW
    waiting: list[Rows] = []
    count = 0
    last = None  # of the rows that have been handed on
    for part in parts:
        waiting.append(part)
        count += length_of(part)
        if count < 2 * window:
            continue
        rows = _sorted(joined_rows(waiting), key, last, file)
        yield cut(rows, 0, count - window)
        last = rows[key][count - window - 1]
        waiting, count = [cut(rows, count - window)], window
    if count:
        yield _sorted(joined_rows(waiting), key, last, file)


def _sorted(rows: Rows, key: str, last: Any, file: str) -> Rows:
    values = rows[key]
    if last is not None and values.min() < last:
        raise InputError(
            "the rows are too far out of order to be read in pieces",
            where=Place(file),
            found=f"a row that is late by more than {WINDOW} rows",
            remedy="sort the file by time, or take a part of it that can be read at once",
        )
    if (np.diff(values) >= 0).all():
        return rows
    order = np.argsort(values, kind="stable")
    return {name: array[order] for name, array in rows.items()}


def interpolated(times: Floats, columns: Floats, t: Floats, step: float) -> Floats:
    """``columns`` [K, m] at ``t`` [L], between their rising ``times`` [K]: NaN before, behind, and where
    these are further apart than :data:`APART` times ``step``."""
    if not len(times):
        return np.full((len(t), columns.shape[1]), np.nan)
    result = np.empty((len(t), columns.shape[1]))
    for k in range(columns.shape[1]):
        result[:, k] = np.interp(t, times, columns[:, k], left=np.nan, right=np.nan)
    steps = np.diff(times)
    if len(steps):
        after = np.clip(np.searchsorted(times, t), 1, len(times) - 1)
        result[steps[after - 1] > APART * step] = np.nan
    return result


class Interpolation:
    """The columns of ``parts``, which have ``times`` [k] and ``columns`` [k, m], at any times that mostly
    rise; ``step``: the usual one between their own times, ``width``: how many columns."""

    def __init__(self, parts: Iterator[Rows], step: float, width: int, file: str) -> None:
        sound = ({name: array[np.isfinite(part["times"])] for name, array in part.items()} for part in parts)
        self._parts = in_order(sound, "times", file)
        self._step, self._file = step, file
        self._rows: Rows = {"times": np.empty(0), "columns": np.empty((0, width))}
        self._dropped = False

    def at(self, t: Floats) -> Floats:
        """The columns [k, m] at ``t`` [k], as :func:`interpolated` has them.

        Raises
        ------
        InputError: ``t`` goes back, or ahead, by more than is in memory.
        """
        finite = t[np.isfinite(t)]
        if len(finite):
            self._reach(float(finite.max()))
            if self._dropped and finite.min() <= self._rows["times"][0]:
                raise self._refusal("times that go back")
        columns = interpolated(self._rows["times"], self._rows["columns"], t, self._step)
        if len(finite):
            self._drop(float(finite.max()))
        return columns

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
            if count > MOST_WAITING:
                raise self._refusal("times that leap ahead")
        self._rows = joined_rows(waiting)

    def _drop(self, t: float) -> None:
        """Forget what lies before ``t`` by more than a window."""
        before = int(np.searchsorted(self._rows["times"], t)) - 1 - WINDOW
        if before > 0:
            self._rows, self._dropped = cut(self._rows, before), True

    def _refusal(self, what: str) -> InputError:
        return InputError(
            "streams cannot be brought to one time in pieces",
            where=Place(self._file),
            found=what,
            expected="times that rise",
            remedy="correct the times, or take a part of it that can be read at once",
        )
