"""Text and Parquet as recordings: one stream, the table."""

from __future__ import annotations

import io
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from robodyn.errors import InputError, Place
from robodyn.files import open_regular
from robodyn.logs.columns import Layout
from robodyn.logs.csv_file import read_dialect, read_rows, row_blocks
from robodyn.logs.parquet_file import parquet_columns, parquet_row_blocks, read_parquet_rows
from robodyn.logs.recording import Stream, Table


class CsvRecording:
    """A table of text."""

    format = "text"
    notes: tuple[str, ...] = ()

    def __init__(self, path: Path, file: str) -> None:
        self.path, self.file = path, file
        self.dialect = replace(read_dialect(path, file), empty=True)
        columns = tuple(dict.fromkeys(self.dialect.names))
        self.streams = (Stream("", "table", None, columns, self.dialect.units),)

    def read(self, stream: Stream, groups: Mapping[str, Sequence[str]], stamp: str | None) -> Table:
        """As :class:`~robodyn.logs.recording.Recording` says."""
        return Table(read_rows(self.path, self.file, self._layout(groups), self.dialect))

    def blocks(
        self, stream: Stream, groups: Mapping[str, Sequence[str]], stamp: str | None
    ) -> Iterator[Table]:
        """As :class:`~robodyn.logs.recording.Recording` says."""
        layout = self._layout(groups)
        for block in row_blocks(self.path, self.file, layout, self.dialect):
            yield Table(block.groups(layout))

    def _layout(self, groups: Mapping[str, Sequence[str]]) -> Layout:
        names = self.dialect.names
        wanted = {name for group in groups.values() for name in group}
        twice = sorted(name for name in wanted if names.count(name) > 1)
        if twice:
            raise InputError(
                "the log has two columns with the same name",
                where=Place(self.file, max(1, self.dialect.line - 1)),
                found=", ".join(twice[:8]),
                remedy="delete or rename all but one",
            )
        return _layout(names, groups)

    def rough_rows(self) -> int | None:
        """About how many rows it has: its size by the length of its first ones."""
        with io.BufferedReader(open_regular(self.path, "a log", self.file)) as source:
            size = os.fstat(source.fileno()).st_size
            head = source.read(1 << 16)
        lines = head.count(b"\n")
        return round(size * lines / len(head)) if head else None


class ParquetRecording:
    """A table in Parquet."""

    format = "Parquet"
    notes: tuple[str, ...] = ()

    def __init__(self, path: Path, file: str) -> None:
        self.path, self.file = path, file
        names, rows = parquet_columns(path, file)
        self.streams = (Stream("", "table", rows, names),)

    def read(self, stream: Stream, groups: Mapping[str, Sequence[str]], stamp: str | None) -> Table:
        """As :class:`~robodyn.logs.recording.Recording` says."""
        layout = _layout(stream.columns, groups)
        return Table(read_parquet_rows(self.path, self.file, layout, stream.columns))

    def blocks(
        self, stream: Stream, groups: Mapping[str, Sequence[str]], stamp: str | None
    ) -> Iterator[Table]:
        """As :class:`~robodyn.logs.recording.Recording` says."""
        for tables in parquet_row_blocks(self.path, self.file, _layout(stream.columns, groups)):
            yield Table(tables)


def _layout(names: Sequence[str], groups: Mapping[str, Sequence[str]]) -> Layout:
    at = {name: k for k, name in enumerate(names)}
    places = {group: tuple(at[name] for name in columns) for group, columns in groups.items()}
    return Layout(0, len(names), places, ())
