"""Files of named arrays as recordings: arrays of one length are a stream, whatever the format."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
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


class ArraysRecording:
    """A ``file`` of arrays with the ``shapes``, by name; ``load`` reads some of them.

    Of an array with two axes the longer one is time; its columns are called ``NAME.0`` and so on. The stream
    of the longest arrays has no name.
    """

    notes: tuple[str, ...] = ()

    def __init__(
        self,
        file: str,
        format: str,
        shapes: Mapping[str, Sequence[int]],
        load: Callable[[set[str]], Mapping[str, NDArray[Any]]],
    ) -> None:
        self.file, self.format = file, format
        self._load = load
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
            table = np.empty((rows, len(names)))
            loaded = self._load({self._source[name][0] for name in names})
            for k, column in enumerate(names):
                name, j = self._source[column]
                with np.errstate(invalid="ignore"):
                    table[:, k] = _column(loaded[name], j)
            tables[group] = table
        return Table(tables)


def _column(array: NDArray[Any], j: int) -> NDArray[Any]:
    """Column ``j`` of ``array`` along its longer axis."""
    flat = array.reshape([length for length in array.shape if length != 1])
    if flat.ndim == 1:
        return flat
    return flat[:, j] if flat.shape[0] >= flat.shape[1] else flat[j]


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
