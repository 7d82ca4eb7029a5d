"""Logs as Parquet, through pyarrow, which only those need who want it."""

from __future__ import annotations

import importlib
import io
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place, ToolError
from robodyn.robot.names import shown
from robodyn.simulate.log_columns import Layout, layout_of

Floats = NDArray[np.float64]

#: Rows that are read at once.
BATCH = 1 << 16


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


def read_parquet(path: Path, file: str, n: int | None) -> tuple[Layout, dict[str, Floats]]:
    """The layout of the log at ``path``, and its groups: ``t`` [K, 1], the others [K, n].

    ``file`` is what messages call it.

    Raises
    ------
    InputError: not such a log.
    ToolError: pyarrow is missing.
    OSError: the file cannot be read.
    """
    pyarrow, parquet = _pyarrow()
    try:
        with parquet.ParquetFile(path) as source:
            names, types = source.schema_arrow.names, source.schema_arrow.types
            layout = layout_of(names, n, Place(file))
            for position in layout.wanted:
                kind = types[position]
                if not pyarrow.types.is_floating(kind) and not pyarrow.types.is_integer(kind):
                    raise InputError(
                        f"the column {shown(names[position])} is not of numbers",
                        where=Place(file),
                        found=str(kind),
                        expected="double",
                    )
            rows = source.metadata.num_rows
            if not rows:
                raise InputError("the log has no samples", where=Place(file), expected="a row a sample")
            tables = {group: np.empty((rows, len(at))) for group, at in layout.groups.items()}
            start = 0
            wanted = [names[position] for position in layout.wanted]
            for batch in source.iter_batches(BATCH, columns=wanted):
                for group, at in layout.groups.items():
                    for i, position in enumerate(at):
                        column = batch.column(names[position])
                        _refuse_gaps(column, names[position], start, file)
                        tables[group][start : start + len(column), i] = column.to_numpy(zero_copy_only=False)
                start += batch.num_rows
    except pyarrow.ArrowException as error:
        raise InputError(
            "the file is not Parquet", where=Place(file), found=str(error), remedy="text ends in .csv"
        ) from None
    return layout, tables


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
    try:
        return importlib.import_module("pyarrow"), importlib.import_module("pyarrow.parquet")
    except ImportError:
        raise ToolError(
            "Parquet needs pyarrow, which is not installed", remedy="pip install 'robodyn[all]'"
        ) from None
