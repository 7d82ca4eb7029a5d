"""Logs as Parquet, through pyarrow, which only those need who want it."""

from __future__ import annotations

import io
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.files import open_regular
from robodyn.logs.columns import GROUPS, LARGEST, Layout, layout_of, too_large
from robodyn.logs.parquet_pages import Damaged, Footer, check_pages, read_footer
from robodyn.robot.names import shown
from robodyn.tools.libraries import PYARROW

Floats = NDArray[np.float64]

#: Rows that are read at once.
BATCH = 1 << 16
#: How much of a column is read at once [bytes].
BUFFER = 1 << 20


def write_parquet(names: Sequence[str], columns: Sequence[Floats]) -> bytes:
    """The bytes of a Parquet file of the ``columns`` [K].

    Raises
    ------
    ToolError: pyarrow is missing.
    """
    pyarrow, parquet = _pyarrow()
    table = pyarrow.table(dict(zip(names, columns, strict=True)))
    stream = io.BytesIO()
    parquet.write_table(table, stream, use_dictionary=False)
    return stream.getvalue()


def read_parquet(
    path: Path, file: str, n: int | None, groups: Sequence[str] = GROUPS
) -> tuple[Layout, dict[str, Floats]]:
    """The layout of the log at ``path``, and its ``groups``: ``t`` [K, 1], the others [K, n].

    ``file`` is what messages call it.

    Raises
    ------
    InputError: not such a log.
    ToolError: pyarrow is missing.
    OSError: the file cannot be read.
    """
    with _opened(path, file) as parts:
        pyarrow = parts[0]
        layout = layout_of(parts[1].schema_arrow.names, n, Place(file), groups)
        tables = _rows(pyarrow, *parts[1:], layout, file)
    pyarrow.default_memory_pool().release_unused()  # it keeps what it decoded pages in
    return layout, tables


def parquet_blocks(
    path: Path, file: str, n: int | None, groups: Sequence[str] = GROUPS
) -> tuple[Layout, Iterator[dict[str, Floats]]]:
    """As :func:`read_parquet`, block by block, however long the log is.

    Raises
    ------
    InputError, ToolError, OSError: as :func:`read_parquet`; of the rows when they are reached.
    """
    with _opened(path, file) as (_, opened, _, _):
        layout = layout_of(opened.schema_arrow.names, n, Place(file), groups)
    return layout, parquet_row_blocks(path, file, layout, gaps=False)


def parquet_columns(path: Path, file: str) -> tuple[tuple[str, ...], int]:
    """Names of the columns of numbers, "" for all others, and how many rows there are.

    Raises
    ------
    InputError, ToolError, OSError: as :func:`read_parquet`.
    """
    with _opened(path, file) as (pyarrow, opened, _, footer):
        kinds = zip(opened.schema_arrow.names, opened.schema_arrow.types, strict=True)
        names = tuple(name if _is_number(pyarrow, kind) else "" for name, kind in kinds)
        return names, footer.rows


def read_parquet_rows(path: Path, file: str, layout: Layout, names: Sequence[str]) -> dict[str, Floats]:
    """The groups of ``layout`` [K, m] of the columns called ``names``; a value that is missing is NaN.

    Raises
    ------
    InputError, ToolError, OSError: as :func:`read_parquet`.
    """
    with _opened(path, file) as parts:
        return _rows(parts[0], *parts[1:], layout, file, gaps=True)


def parquet_row_blocks(
    path: Path, file: str, layout: Layout, *, gaps: bool = True
) -> Iterator[dict[str, Floats]]:
    """The groups of ``layout`` [k, m], block by block; ``gaps``: whether values may be missing.

    Raises
    ------
    InputError, ToolError, OSError: as :func:`read_parquet`.
    """
    with _opened(path, file) as (pyarrow, opened, source, footer):
        wanted = _checked(pyarrow, opened, source, footer, layout, file)
        for _, columns in _batches(opened, wanted, footer.rows, file, gaps=gaps):
            tables, start = {}, 0
            for group, at in layout.groups.items():
                tables[group] = np.column_stack(columns[start : start + len(at)])
                start += len(at)
            yield tables
    pyarrow.default_memory_pool().release_unused()


@contextmanager
def _opened(path: Path, file: str) -> Iterator[tuple[Any, Any, IO[bytes], Footer]]:
    """pyarrow, the Parquet file, the file itself, and its footer; their errors become ours."""
    pyarrow, parquet = _pyarrow()
    with io.BufferedReader(open_regular(path, "a log, such as log.parquet", file)) as source:
        try:
            footer = read_footer(source, os.fstat(source.fileno()).st_size)
            # Buffered ahead, the whole file would be in memory beside its numbers; a column's pages all at
            # once where they are not buffered at all.
            with parquet.ParquetFile(source, pre_buffer=False, buffer_size=BUFFER) as opened:
                yield pyarrow, opened, source, footer
        except (pyarrow.ArrowException, OSError, ValueError) as error:
            if isinstance(error, OSError) and error.errno is not None:  # of the system, not of pyarrow
                raise
            if isinstance(error, MemoryError):
                raise MemoryError from None
            raise InputError(
                "the file is not Parquet, or damaged",
                where=Place(file),
                found=_first_line(error),
                remedy="write it again; text ends in .csv",
            ) from None


def _rows(
    pyarrow: Any,
    opened: Any,
    source: IO[bytes],
    footer: Footer,
    layout: Layout,
    file: str,
    *,
    gaps: bool = False,
) -> dict[str, Floats]:
    """The groups of ``layout``; ``gaps``: whether values may be missing."""
    if footer.rows > LARGEST // len(layout.wanted):
        raise too_large(layout, Place(file))
    wanted = _checked(pyarrow, opened, source, footer, layout, file)
    tables = {group: np.empty((footer.rows, len(at))) for group, at in layout.groups.items()}
    for rows, columns in _batches(opened, wanted, footer.rows, file, gaps=gaps):
        each = iter(columns)
        for table in tables.values():
            for i in range(table.shape[1]):
                table[rows, i] = next(each)
    return tables


def _checked(
    pyarrow: Any, opened: Any, source: IO[bytes], footer: Footer, layout: Layout, file: str
) -> list[str]:
    """Names of the columns of ``layout``, once what the file says of them has been held against itself."""
    _check_kinds(pyarrow, opened.schema_arrow, layout, file)
    wanted = [opened.schema_arrow.names[position] for position in layout.wanted]
    if not footer.rows:
        raise InputError("the log has no samples", where=Place(file), expected="a row a sample")
    size = os.fstat(source.fileno()).st_size
    for chunk in footer.chunks(wanted):
        check_pages(source, size, chunk)
    return wanted


def _is_number(pyarrow: Any, kind: Any) -> bool:
    return bool(pyarrow.types.is_floating(kind) or pyarrow.types.is_integer(kind))


def _check_kinds(pyarrow: Any, schema: Any, layout: Layout, file: str) -> None:
    """Refuse a ``layout`` with columns that are not of numbers."""
    for position in layout.wanted:
        kind = schema.types[position]
        if not _is_number(pyarrow, kind):
            raise InputError(
                f"the column {shown(schema.names[position])} is not of numbers",
                where=Place(file),
                found=str(kind),
                expected="double",
            )


def _batches(
    opened: Any, wanted: Sequence[str], rows: int, file: str, *, gaps: bool
) -> Iterator[tuple[slice, list[Floats]]]:
    """Which of the ``rows`` that a file is known to have, and the columns ``wanted`` of these."""
    start = 0
    for batch in opened.iter_batches(BATCH, columns=wanted):
        end = start + batch.num_rows
        if end > rows or any(len(batch.column(name)) != batch.num_rows for name in wanted):
            break
        columns = []
        for name in wanted:
            column = batch.column(name)
            if not gaps:
                _refuse_gaps(column, name, start, file)
            with np.errstate(invalid="ignore"):  # half floats that are no numbers
                columns.append(np.asarray(column.to_numpy(zero_copy_only=False), dtype=np.float64))
        yield slice(start, end), columns
        start = end
    if start != rows:
        raise Damaged(f"columns that end at row {start} of {rows}")


def _first_line(error: BaseException) -> str:
    """What pyarrow says, in one line that can be printed."""
    lines = str(error).strip().splitlines()
    text = lines[0].rstrip(".") if lines else type(error).__name__
    return text if text.isprintable() else ascii(text)[1:-1]


def _refuse_gaps(column: Any, name: str, start: int, file: str) -> None:
    if column.null_count:
        row = start + int(np.flatnonzero(column.is_null().to_numpy(zero_copy_only=False))[0])
        raise InputError(
            f"the column {shown(name)} has a row without a value",
            where=Place(file),
            found=f"null in row {row + 1}",
            remedy="where there is no value, write nan",
        )


def _pyarrow() -> tuple[Any, Any]:
    return PYARROW.load(), PYARROW.load("parquet")
