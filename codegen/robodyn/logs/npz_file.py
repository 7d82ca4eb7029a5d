"""numpy's files as recordings: ``.npz`` and ``.npy``. Nothing is unpickled."""

from __future__ import annotations

import math
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError
from robodyn.files import open_regular
from robodyn.logs.arrays import ArraysRecording, is_numeric, refuse_without_samples
from robodyn.logs.columns import LARGEST
from robodyn.logs.recording import damaged

#: Most arrays of a file, and the largest header of one [bytes].
MEMBERS, HEADER = 4096, 1 << 14
_EXPECTED = "a log, such as log.npz"


def open_npz(path: Path, file: str) -> ArraysRecording:
    """The arrays in the file at ``path``.

    Raises
    ------
    InputError: it is not one of numpy's files, or has no samples.
    OSError: the file cannot be read.
    """
    shapes: dict[str, tuple[int, ...]] = {}
    with _members(path, file) as members:
        for name, size, opened in members:
            with opened() as source:
                shape, kind = _head(source, size, name)
            for field, part in _fields(name, kind):
                if is_numeric(part):
                    shapes[field] = shape

    def load(names: set[str]) -> dict[str, NDArray[Any]]:
        arrays = {}
        with _members(path, file) as members:
            for name, size, opened in members:
                wanted = [field for field in names if field == name or field.startswith(f"{name}.")]
                if not wanted:
                    continue
                with opened() as source:
                    _head(source, size, name)
                with opened() as source:
                    array = np.lib.format.read_array(source, allow_pickle=False, max_header_size=HEADER)
                for field in wanted:
                    arrays[field] = array if field == name else array[field[len(name) + 1 :]]
        return arrays

    recording = ArraysRecording(file, "npz", shapes, load)
    refuse_without_samples(recording, shapes)
    return recording


def _fields(name: str, kind: np.dtype[Any]) -> Iterator[tuple[str, np.dtype[Any]]]:
    """The arrays that one of records stands for, or the array itself."""
    if kind.fields is None:
        yield name, kind
    else:
        yield from ((f"{name}.{field}", part[0]) for field, part in kind.fields.items())


def _head(source: IO[bytes], size: int, name: str) -> tuple[tuple[int, ...], np.dtype[Any]]:
    """Shape and kind of the array that ``source`` of ``size`` bytes begins with.

    Raises
    ------
    ValueError: there is none, or it claims more than it has.
    """
    version = np.lib.format.read_magic(source)
    read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
    shape, _, kind = read(source, max_header_size=HEADER)
    if kind.hasobject:
        raise ValueError(f"{name!a} has Python objects, which are not read")
    needed = math.prod(shape) * kind.itemsize
    if needed > size:
        raise ValueError(f"{name!a} claims {needed} bytes, and has {size}")
    if needed > 8 * LARGEST:
        raise ValueError(f"{name!a} has {needed} bytes, more than is read")
    return shape, kind


@contextmanager
def _members(path: Path, file: str) -> Iterator[list[tuple[str, int, Any]]]:
    """The arrays of a file: name, size unpacked [bytes], and what opens it."""
    try:
        with open_regular(path, _EXPECTED, file) as raw, _buffered(raw) as source:
            start = source.read(6)
            source.seek(0)
            if start == b"\x93NUMPY":
                size = path.stat().st_size

                def plain() -> IO[bytes]:
                    return path.open("rb")

                yield [("array", size, plain)]
                return
            with zipfile.ZipFile(source) as archive:
                listed = archive.infolist()
                if len(listed) > MEMBERS:
                    raise ValueError(f"{len(listed)} arrays, more than {MEMBERS}")
                yield [
                    (one.filename.removesuffix(".npy"), one.file_size, _opener(archive, one))
                    for one in listed
                    if one.filename.endswith(".npy")
                ]
    except (zipfile.BadZipFile, ValueError, EOFError, RuntimeError, KeyError) as error:
        if isinstance(error, RecursionError):
            raise damaged(file, "of numpy's", "values nested too deeply") from None
        raise damaged(
            file, "of numpy's", error, "write it with numpy.savez(file, t=t, q=q, tau=tau)"
        ) from None
    except Exception as error:  # zlib, lzma and struct each have errors of their own
        if isinstance(error, (OSError, MemoryError, InputError)):
            raise
        raise damaged(file, "of numpy's", error) from None


def _opener(archive: zipfile.ZipFile, one: zipfile.ZipInfo) -> Any:
    return lambda: archive.open(one)


def _buffered(raw: Any) -> Any:
    import io

    return io.BufferedReader(raw)
