"""Parquet, through pyarrow: a table."""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.logs.formats import LogFormat
from robodyn.logs.recording import Groups, Recording, Stream
from robodyn.logs.windows import Rows
from robodyn.robot.names import shown
from robodyn.tools.libraries import PYARROW

#: Rows that are read at once.
BATCH: Final = 1 << 16


def open_parquet(path: Path, file: str, gaps: bool) -> Recording:
    """The table in the file at ``path``.

    Raises
    ------
    InputError: it has no rows.
    """
    pyarrow, parquet = PYARROW.load(), PYARROW.load("parquet")
    # Buffered ahead, the whole file would be in memory beside its numbers.
    opened = parquet.ParquetFile(path, pre_buffer=False, buffer_size=1 << 20)
    names, kinds = tuple(opened.schema_arrow.names), opened.schema_arrow.types
    numeric = [pyarrow.types.is_floating(kind) or pyarrow.types.is_integer(kind) for kind in kinds]
    rows = opened.metadata.num_rows

    def parts(stream: Stream, groups: Groups, stamp: str | None) -> Iterator[Rows]:
        wanted = [name for group in groups.values() for name in group]
        for name in wanted:
            if not numeric[names.index(name)]:
                raise InputError(
                    f"the column {shown(name)} is not of numbers",
                    where=Place(file),
                    found=str(kinds[names.index(name)]),
                    expected="double",
                )
        if not rows:
            raise InputError("the log has no samples", where=Place(file), expected="a row a sample")
        start = 0
        for batch in opened.iter_batches(BATCH, columns=wanted):
            read = {name: _numbers(batch.column(name), name, start, file, gaps) for name in wanted}
            start += batch.num_rows
            yield {
                group: np.column_stack([read[name] for name in columns]) for group, columns in groups.items()
            }
        if start != rows:
            raise ValueError(f"columns that end at row {start} of {rows}")

    columns = tuple(name if is_number else "" for name, is_number in zip(names, numeric, strict=True))
    return Recording(file, "Parquet", (Stream("", "table", rows, columns),), parts, names=names)


def _numbers(column: Any, name: str, start: int, file: str, gaps: bool) -> Floats:
    """The numbers of a ``column``, the first of them in the row ``start``; NaN where there is no value."""
    if not gaps and column.null_count:
        row = start + int(np.flatnonzero(column.is_null().to_numpy(zero_copy_only=False))[0])
        raise InputError(
            f"the column {shown(name)} has a row without a value",
            where=Place(file),
            found=f"null in row {row + 1}",
            remedy="where there is no value, write nan",
        )
    with np.errstate(invalid="ignore"):  # half floats that are no numbers
        return np.asarray(column.to_numpy(zero_copy_only=False), dtype=np.float64)


def write_parquet(names: Sequence[str], columns: Sequence[Floats]) -> bytes:
    """The bytes of a Parquet file of the ``columns`` [K].

    Raises
    ------
    ToolError: pyarrow is missing.
    """
    pyarrow, parquet = PYARROW.load(), PYARROW.load("parquet")
    stream = io.BytesIO()
    parquet.write_table(pyarrow.table(dict(zip(names, columns, strict=True))), stream, use_dictionary=False)
    return stream.getvalue()


FORMAT = LogFormat(
    "parquet", (".parquet", ".pq"), "Parquet", open_parquet, library=PYARROW, is_table=True,
    remedy="write it again; text ends in .csv",
)  # fmt: skip
