"""CSV and any other text: a table, a line a sample."""

from __future__ import annotations

import io
import os
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from robodyn.errors import InputError, Place
from robodyn.files import open_regular
from robodyn.logs.columns import Layout
from robodyn.logs.csv_file import read_dialect, row_blocks
from robodyn.logs.formats import LogFormat
from robodyn.logs.recording import Groups, Recording, Stream
from robodyn.logs.windows import Rows


def open_text(path: Path, file: str, gaps: bool) -> Recording:
    """The table in the text at ``path``.

    Raises
    ------
    InputError: it is not text.
    OSError: the file cannot be read.
    """
    dialect = replace(read_dialect(path, file), empty=gaps)
    names = dialect.names
    line = max(1, dialect.line - 1)

    def parts(stream: Stream, groups: Groups, stamp: str | None) -> Iterator[Rows]:
        wanted = {name for group in groups.values() for name in group}
        twice = sorted(name for name in wanted if names.count(name) > 1)
        if twice:
            raise InputError(
                "the log has two columns with the same name",
                where=Place(file, line),
                found=", ".join(twice[:8]),
                remedy="delete or rename all but one",
            )
        at = {name: k for k, name in enumerate(names)}
        places = {group: tuple(at[name] for name in columns) for group, columns in groups.items()}
        return row_blocks(path, file, Layout(0, len(names), places, ()), dialect)

    with io.BufferedReader(open_regular(path, "a log", file)) as source:
        size, head = os.fstat(source.fileno()).st_size, source.read(1 << 16)
    stream = Stream("", "table", None, tuple(dict.fromkeys(names)), dialect.units)
    return Recording(
        file, "text", (stream,), parts, (), names, line, dialect.named,
        round(size * head.count(b"\n") / len(head)) if head else None,
    )  # fmt: skip


FORMAT = LogFormat("text", (".csv", ".txt", ".tsv"), "text", open_text, is_guarded=False, is_table=True)
