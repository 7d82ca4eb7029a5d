"""Which format a file is in, and what opens it."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.logs.recording import Recording

PARQUET: Final = (".parquet", ".pq")
NUMPY: Final = (".npz", ".npy")
MATLAB: Final = (".mat", ".h5", ".hdf5")
BAGS: Final = (".mcap", ".db3")
JSON: Final = (".json",)


def is_table(path: str | os.PathLike[str]) -> bool:
    """Whether the file is a table, in text or Parquet, by its name."""
    name = os.fspath(path).lower()
    return not name.endswith((*NUMPY, *MATLAB, *BAGS, *JSON)) and not Path(path).is_dir()


def open_recording(path: str | os.PathLike[str]) -> Recording:
    """Look into the file ``path``: by its ending Parquet, npz, MATLAB, MCAP, rosbag2 (or its folder), JSON;
    all others are text.

    Raises
    ------
    InputError: there is no such file, or it is damaged.
    ToolError: the library for its format is missing.
    """
    file, place = label(path), Path(path)
    name = file.lower()
    with readable(file):
        if place.is_dir() or name.endswith(BAGS):
            from robodyn.logs.bags.recording import open_bag

            return open_bag(place, file)
        if name.endswith(PARQUET):
            from robodyn.logs.text_tables import ParquetRecording

            return ParquetRecording(place, file)
        if name.endswith(NUMPY):
            from robodyn.logs.npz_file import open_npz

            return open_npz(place, file)
        if name.endswith(MATLAB):
            from robodyn.logs.mat_file import open_mat

            return open_mat(place, file)
        if name.endswith(JSON):
            from robodyn.logs.json_file import open_json

            return open_json(place, file)
        from robodyn.logs.text_tables import CsvRecording

        return CsvRecording(place, file)


@contextmanager
def readable(file: str) -> Iterator[None]:
    """What the system says of ``file`` becomes an error of ours.

    Raises
    ------
    InputError: it cannot be read, or does not fit into memory.
    """
    try:
        yield
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise InputError("the log cannot be read", where=Place(file), found=reason.lower()) from None
    except MemoryError:
        raise InputError(
            "the log does not fit into memory",
            where=Place(file),
            remedy="take a part of it, or fewer samples a second",
        ) from None
