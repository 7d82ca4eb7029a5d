"""Files of named arrays as recordings: arrays of one length are a stream, whatever the format."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.logs.columns import LARGEST
from robodyn.logs.recording import Stream, Table

Floats = NDArray[np.float64]

#: Most columns of an array, and of all of them.
WIDEST, COLUMNS = 4096, 1 << 16
#: Fewer rows are no samples but settings.
FEWEST = 2
#: Numbers that are read at once.
BLOCK = 1 << 20

Load = Callable[[set[str]], Mapping[str, Any]]


class ArraysRecording:
    """A ``file`` of arrays with the ``shapes``, by name; ``load`` reads some of them.

    Of an array with two axes the longer one is time; its columns are called ``NAME.0`` and so on. The stream
    of the longest arrays has no name. ``mapped`` opens some of them of which only what is sliced is read, and
    that only for as long as they are open.
    """

    notes: tuple[str, ...] = ()

    def __init__(
        self,
        file: str,
        format: str,
        shapes: Mapping[str, Sequence[int]],
        load: Load,
        mapped: Callable[[set[str]], AbstractContextManager[Mapping[str, Any]]] | None = None,
    ) -> None:
        self.file, self.format = file, format
        self._load, self._mapped, self._shapes = load, mapped, shapes
        self._source: dict[str, tuple[str, int]] = {}
        rows: dict[int, list[str]] = {}
        for name, shape in shapes.items():
            long = [length for length in shape if length != 1]
            wide = len(long) == 2
            if not 1 <= len(long) <= 2 or max(long) < FEWEST or (wide and min(long) > WIDEST):
                continue
            for j in range(min(long)) if wide else (0,):
                column = f"{name}.{j}" if wide else name
                rows.setdefault(max(long), []).append(column)
                self._source[column] = (name, j)
            if len(self._source) > COLUMNS:
                raise InputError(
                    "the file has too many columns", where=Place(file), found=f"more than {COLUMNS}"
                )
        longest = max(rows, default=0)
        self.streams = tuple(
            Stream("" if count == longest else f"{count} rows", "arrays", count, tuple(columns))
            for count, columns in sorted(rows.items(), reverse=True)
        )

    def read(self, stream: Stream, groups: Mapping[str, Sequence[str]], stamp: str | None) -> Table:
        """As :class:`~robodyn.logs.recording.Recording` says."""
        rows = stream.rows or 0
        columns = sum(map(len, groups.values()))
        if rows * columns > LARGEST:
            raise InputError(
                "the log is too long",
                where=Place(self.file),
                found=f"{rows} samples of {columns} columns",
                expected=f"at most {LARGEST} numbers",
                remedy="take a part of it, or fewer samples a second",
            )
        tables = {}
        for group, names in groups.items():
            loaded = self._load(self._arrays(names))
            tables[group] = self._columns(loaded, names, slice(0, rows))
        return Table(tables)

    def blocks(
        self, stream: Stream, groups: Mapping[str, Sequence[str]], stamp: str | None
    ) -> Iterator[Table]:
        """As :class:`~robodyn.logs.recording.Recording` says; arrays that are packed are unpacked whole."""
        wanted = {array for names in groups.values() for array in self._arrays(names)}
        whole = self._load(wanted) if self._mapped is None else None
        length = stream.rows or 0
        most = max(1, BLOCK * length // sum(math.prod(self._shapes[name]) for name in wanted))
        for start in range(0, length, most):
            rows = slice(start, min(start + most, length))
            # Mapped anew for each block: what has been read of a file is memory for as long as it is mapped.
            with nullcontext(whole) if self._mapped is None else self._mapped(wanted) as loaded:
                assert loaded is not None
                yield Table({group: self._columns(loaded, names, rows) for group, names in groups.items()})

    def _arrays(self, names: Sequence[str]) -> set[str]:
        """The arrays that columns are of."""
        return {self._source[name][0] for name in names}

    def _columns(self, loaded: Mapping[str, Any], names: Sequence[str], rows: slice) -> Floats:
        """The columns ``names`` [k, m] of some ``rows``."""
        parts = {array: _rows(loaded[array], rows) for array in self._arrays(names)}
        table = np.empty((rows.stop - rows.start, len(names)))
        for k, column in enumerate(names):
            name, j = self._source[column]
            with np.errstate(invalid="ignore"):
                table[:, k] = parts[name][:, j]
        return table


def _rows(array: Any, rows: slice) -> NDArray[Any]:
    """Some ``rows`` [k, m] of ``array`` along its longer axis."""
    long = [axis for axis, length in enumerate(array.shape) if length != 1]
    time = max(long, key=lambda axis: (array.shape[axis], -axis))
    index: list[int | slice] = [0] * len(array.shape)
    for axis in long:
        index[axis] = rows if axis == time else slice(None)
    part: NDArray[Any] = np.asarray(array[tuple(index)])
    if part.ndim == 1:
        return part[:, None]
    return part if time == long[0] else part.T


def is_numeric(dtype: np.dtype[Any]) -> bool:
    """Whether numbers of that kind can be samples."""
    return dtype.kind in "fiub"


def refuse_without_samples(recording: ArraysRecording, names: Iterable[str]) -> None:
    """Refuse a file in which no array has samples; ``names`` are those that it has.

    Raises
    ------
    InputError: always then.
    """
    if not recording.streams:
        listed = ", ".join(list(names)[:8])
        raise InputError(
            f"there are no samples in the {recording.format} file",
            where=Place(recording.file),
            found=listed or "no arrays of numbers",
            expected="arrays of numbers, a row a sample",
        )
