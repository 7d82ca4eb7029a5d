"""numpy's files, ``.npz`` and ``.npy``: arrays. Nothing is unpickled."""

from __future__ import annotations

import zipfile
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import IO, Any, Literal

import numpy as np
from numpy.typing import NDArray

from robodyn.logs.arrays import is_numeric, recording_of_arrays
from robodyn.logs.formats import LogFormat
from robodyn.logs.recording import Recording

Load = Callable[[], NDArray[Any]]


def open_npz(path: Path, file: str, gaps: bool) -> Recording:
    """The arrays in the file at ``path``.

    Raises
    ------
    InputError: they have no samples.
    """
    shapes: dict[str, tuple[int, ...]] = {}
    loads: dict[str, tuple[Load, str]] = {}
    for name, shape, kind, load in _arrays(path):
        for field, part in (kind.fields or {"": (kind, 0)}).items():
            if is_numeric(part[0]):
                column = f"{name}.{field}" if field else name
                shapes[column], loads[column] = shape, (load, field)

    def array(column: str) -> NDArray[Any]:
        load, field = loads[column]
        return load()[field] if field else load()

    return recording_of_arrays(file, "npz", shapes, array)


def _arrays(path: Path) -> Iterator[tuple[str, tuple[int, ...], np.dtype[Any], Load]]:
    """Name, shape and kind of the arrays in a file, and what loads each: mapped where it is not packed."""
    if not zipfile.is_zipfile(path):
        array = np.lib.format.open_memmap(path, mode="r")  # refuses what would have to be unpickled
        yield "array", array.shape, array.dtype, lambda: array
        return
    archive = zipfile.ZipFile(path)
    for member in archive.infolist():
        if not member.filename.endswith(".npy"):
            continue
        with archive.open(member) as source:
            shape, is_fortran, kind = _head(source)
            behind = source.tell()
        order: Literal["C", "F"] = "F" if is_fortran else "C"
        if kind.hasobject:
            raise ValueError(f"{member.filename!a} has Python objects, which are not read")

        load: Load = partial(_unpacked, archive, member)
        if member.compress_type == zipfile.ZIP_STORED and not member.flag_bits & 1:
            load = partial(np.memmap, path, kind, "r", _place(path, member) + behind, shape, order)
        yield member.filename.removesuffix(".npy"), shape, kind, load


def _unpacked(archive: zipfile.ZipFile, member: zipfile.ZipInfo) -> NDArray[Any]:
    with archive.open(member) as source:
        return np.asarray(np.lib.format.read_array(source, allow_pickle=False))


def _head(source: IO[bytes]) -> tuple[tuple[int, ...], bool, np.dtype[Any]]:
    """Shape, order and kind of the array that ``source`` begins with."""
    version = np.lib.format.read_magic(source)
    read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
    return read(source)


def _place(path: Path, member: zipfile.ZipInfo) -> int:
    """Where the bytes of a ``member`` begin: behind a head of 30 bytes, its name and more."""
    with path.open("rb") as source:
        source.seek(member.header_offset)
        head = source.read(30)
    return member.header_offset + 30 + sum(int.from_bytes(head[k : k + 2], "little") for k in (26, 28))


FORMAT = LogFormat(
    "npz", (".npz", ".npy"), "of numpy's", open_npz,
    remedy="write it with numpy.savez(file, t=t, q=q, tau=tau)",
)  # fmt: skip
