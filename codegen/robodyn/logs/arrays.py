"""Files of named arrays as recordings: arrays of one length are a stream, whatever the format."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.logs.recording import Groups, Recording, Stream
from robodyn.logs.windows import Rows

#: Most columns of an array, and of all of them.
WIDEST, COLUMNS = 4096, 1 << 16
#: Fewer rows are no samples but settings.
FEWEST = 2
#: Numbers that are read at once.
BLOCK = 1 << 20


def recording_of_arrays(
    file: str, format: str, shapes: Mapping[str, Sequence[int]], load: Callable[[str], Any]
) -> Recording:
    """The recording in a ``file`` of arrays with the ``shapes``, by name; ``load`` opens one of them,
    of which then some rows at a time are sliced.

    Of an array with two axes the longer one is time; its columns are called ``NAME.0`` and so on. The stream
    of the longest arrays has no name.

    Raises
    ------
    InputError: no array has samples, or they have too many columns.
    """
    source: dict[str, tuple[str, int]] = {}
    lengths: dict[int, list[str]] = {}
    for name, shape in shapes.items():
        long = [length for length in shape if length != 1]
        wide = len(long) == 2
        if not 1 <= len(long) <= 2 or max(long) < FEWEST or (wide and min(long) > WIDEST):
            continue
        for j in range(min(long)) if wide else (0,):
            column = f"{name}.{j}" if wide else name
            lengths.setdefault(max(long), []).append(column)
            source[column] = (name, j)
        if len(source) > COLUMNS:
            raise InputError("the file has too many columns", where=Place(file), found=f"more than {COLUMNS}")
    if not source:
        raise InputError(
            f"there are no samples in the {format} file",
            where=Place(file),
            found=", ".join(list(shapes)[:8]) or "no arrays of numbers",
            expected="arrays of numbers, a row a sample",
        )

    def parts(stream: Stream, groups: Groups, stamp: str | None) -> Iterator[Rows]:
        names = {source[column][0] for columns in groups.values() for column in columns}
        loaded = {name: load(name) for name in names}
        length = stream.rows or 0
        most = max(1, BLOCK * length // sum(math.prod(shapes[name]) for name in names))
        for start in range(0, length, most):
            rows = slice(start, min(start + most, length))
            tables = {name: _rows(array, rows) for name, array in loaded.items()}
            yield {
                group: np.column_stack([_column(tables, *source[column]) for column in columns])
                for group, columns in groups.items()
            }

    streams = tuple(
        Stream("" if count == max(lengths) else f"{count} rows", "arrays", count, tuple(columns))
        for count, columns in sorted(lengths.items(), reverse=True)
    )
    return Recording(file, format, streams, parts)


def is_numeric(dtype: np.dtype[Any]) -> bool:
    """Whether numbers of that kind can be samples."""
    return dtype.kind in "fiub"


def _column(tables: Mapping[str, NDArray[Any]], name: str, j: int) -> NDArray[np.float64]:
    with np.errstate(invalid="ignore"):
        return tables[name][:, j].astype(np.float64)


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
