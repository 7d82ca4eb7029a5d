"""JSON: lists of numbers, and lists of objects with numbers, wherever they stand in it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.files import parsed_json, read_bytes
from robodyn.logs.arrays import recording_of_arrays
from robodyn.logs.formats import LogFormat
from robodyn.logs.recording import Recording, damaged

#: Largest file [bytes]: what Python makes of it takes ten times as much.
SIZE: Final = 1 << 26
#: Most numbers in a row.
WIDTH: Final = 4096


def open_json(path: Path, file: str, gaps: bool) -> Recording:
    """The lists of numbers in the file at ``path``.

    Raises
    ------
    InputError: it is not JSON, too large, or has no samples.
    """
    try:
        data = parsed_json(read_bytes(path, SIZE, "a log in JSON", file))
    except ValueError as error:
        raise damaged(file, "JSON", error) from None
    arrays: dict[str, NDArray[Any]] = {}
    _collect("", data, arrays)
    shapes = {name: array.shape for name, array in arrays.items()}
    return recording_of_arrays(file, "JSON", shapes, arrays.__getitem__)


def _collect(path: str, value: Any, arrays: dict[str, NDArray[Any]]) -> None:
    """Put the lists in ``value`` into ``arrays``."""
    if isinstance(value, Mapping):
        for key, inner in value.items():
            _collect(f"{path}.{key}" if path else key, inner, arrays)
    elif isinstance(value, list) and len(value) > 1:
        rows = [dict(_numbers("", row)) for row in value]
        names = dict.fromkeys(name for row in (rows[0], rows[len(rows) // 2], rows[-1]) for name in row)
        for name in names:
            column = np.array([row.get(name, np.nan) for row in rows], dtype=np.float64)
            arrays[".".join(part for part in (path, name) if part) or "values"] = column
        if not names and isinstance(value[0], list):
            for k, inner in enumerate(value[:WIDTH]):
                _collect(f"{path}.{k}" if path else str(k), inner, arrays)


def _numbers(path: str, value: Any) -> Sequence[tuple[str, float]]:
    """The numbers in one row, with their paths; words are none."""
    if isinstance(value, (int, float)):
        return ((path, float(value)),)
    if value is None:
        return ((path, np.nan),) if path else ()
    pairs: list[tuple[str, float]] = []
    if isinstance(value, Mapping):
        parts = list(value.items())
    elif isinstance(value, list) and len(value) <= WIDTH:
        parts = [(str(k), inner) for k, inner in enumerate(value)]
    else:
        return ()
    for key, inner in parts:
        pairs += _numbers(f"{path}.{key}" if path else key, inner)
        if len(pairs) > WIDTH:
            return ()
    return pairs


# Python's own reader, of files of a bounded size: that needs no process of its own.
FORMAT = LogFormat("json", (".json",), "JSON", open_json, is_guarded=False)
