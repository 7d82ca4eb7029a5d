"""numpy's files as recordings: ``.npz`` and ``.npy``. Nothing is unpickled."""

from __future__ import annotations

import math
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import IO, Any, Literal

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.files import open_regular
from robodyn.logs.arrays import ArraysRecording, is_numeric, refuse_without_samples
from robodyn.logs.columns import LARGEST
from robodyn.logs.recording import damaged

#: Most arrays of a file, and the largest header of one [bytes].
MEMBERS, HEADER = 4096, 1 << 14
_EXPECTED = "a log, such as log.npz"
#: Of zip archives: the length of the head before each file, but for its name and more [bytes], and a flag.
_LOCAL, _ENCRYPTED = 30, 1


def open_npz(path: Path, file: str) -> ArraysRecording:
    """The arrays in the file at ``path``.

    Raises
    ------
    InputError: it is not one of numpy's files, or has no samples.
    OSError: the file cannot be read.
    """
    shapes: dict[str, tuple[int, ...]] = {}
    with _members(path, file) as members:
        packed = any(member.place is None for member in members)
        for member in members:
            with member.open() as source:
                head = _head(source, member)
            for field, part in _fields(member.name, head.kind):
                if is_numeric(part):
                    shapes[field] = head.shape

    def load(names: set[str]) -> dict[str, NDArray[Any]]:
        arrays = {}
        with _members(path, file) as members:
            for member in members:
                if not (wanted := _wanted(names, member.name)):
                    continue
                with member.open() as source:
                    size = _head(source, member).size
                if size > 8 * LARGEST:
                    raise InputError(
                        "the log is too long",
                        where=Place(file),
                        found=f"{member.name!a} with {size} bytes",
                        expected=f"at most {8 * LARGEST}",
                        remedy="take a part of it, or write it with numpy.savez, which packs nothing",
                    )
                with member.open() as source:
                    array = np.lib.format.read_array(source, allow_pickle=False, max_header_size=HEADER)
                arrays.update(_fields_of(array, member.name, wanted))
        return arrays

    @contextmanager
    def mapped(names: set[str]) -> Iterator[dict[str, NDArray[Any]]]:
        arrays = {}
        with _members(path, file) as members:
            for member in members:
                if wanted := _wanted(names, member.name):
                    arrays.update(_fields_of(member.mapped(path), member.name, wanted))
        yield arrays

    recording = ArraysRecording(file, "npz", shapes, load, None if packed else mapped)
    refuse_without_samples(recording, shapes)
    return recording


def _wanted(names: set[str], name: str) -> list[str]:
    """Which of ``names`` are the array called ``name``, or fields of it."""
    return [field for field in names if field == name or field.startswith(f"{name}.")]


def _fields_of(array: NDArray[Any], name: str, wanted: list[str]) -> dict[str, NDArray[Any]]:
    """The array called ``name``, or its fields, by the names ``wanted``."""
    return {field: array if field == name else array[field[len(name) + 1 :]] for field in wanted}


def _fields(name: str, kind: np.dtype[Any]) -> Iterator[tuple[str, np.dtype[Any]]]:
    """The arrays that one of records stands for, or the array itself."""
    if kind.fields is None:
        yield name, kind
    else:
        yield from ((f"{name}.{field}", part[0]) for field, part in kind.fields.items())


@dataclass(frozen=True, slots=True)
class _Head:
    """What an array says of itself: its ``shape``, its ``kind`` of numbers, which axis its bytes go along
    (``fortran``: the first), and where they begin behind it."""

    shape: tuple[int, ...]
    fortran: bool
    kind: np.dtype[Any]
    end: int

    @property
    def size(self) -> int:
        """How many bytes it takes."""
        return math.prod(self.shape) * self.kind.itemsize


@dataclass(frozen=True, slots=True)
class _Member:
    """An array of a file: its ``name``, its ``size`` unpacked [bytes], what opens it, and its ``place`` in
    the file; None where it is packed."""

    name: str
    size: int
    open: Callable[[], IO[bytes]]
    place: int | None

    def mapped(self, path: Path) -> NDArray[Any]:
        """The array in the file at ``path``, of which only what is used is read. Checksums are not held
        against it."""
        assert self.place is not None
        with self.open() as source:
            head = _head(source, self)
        order: Literal["C", "F"] = "F" if head.fortran else "C"
        return np.memmap(path, head.kind, "r", self.place + head.end, head.shape, order)


def _head(source: IO[bytes], member: _Member) -> _Head:
    """What the array says that ``source`` begins with.

    Raises
    ------
    ValueError: there is none, or it claims more than it has.
    """
    version = np.lib.format.read_magic(source)
    read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
    shape, fortran, kind = read(source, max_header_size=HEADER)
    if kind.hasobject:
        raise ValueError(f"{member.name!a} has Python objects, which are not read")
    head = _Head(shape, fortran, kind, source.tell())
    if head.size > member.size:
        raise ValueError(f"{member.name!a} claims {head.size} bytes, and has {member.size}")
    return head


@contextmanager
def _members(path: Path, file: str) -> Iterator[list[_Member]]:
    """The arrays of a file."""
    try:
        with open_regular(path, _EXPECTED, file) as raw, _buffered(raw) as source:
            start = source.read(6)
            source.seek(0)
            if start == b"\x93NUMPY":
                size = path.stat().st_size

                def plain() -> IO[bytes]:
                    return path.open("rb")

                yield [_Member("array", size, plain, 0)]
                return
            with zipfile.ZipFile(source) as archive:
                listed = archive.infolist()
                if len(listed) > MEMBERS:
                    raise ValueError(f"{len(listed)} arrays, more than {MEMBERS}")
                yield [
                    _Member(
                        one.filename.removesuffix(".npy"),
                        one.file_size,
                        partial(archive.open, one),
                        _place(source, one),
                    )
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


def _place(source: IO[bytes], one: zipfile.ZipInfo) -> int | None:
    """Where the bytes of a file in an archive begin, if they stand there as they are."""
    if one.compress_type != zipfile.ZIP_STORED or one.flag_bits & _ENCRYPTED:
        return None
    source.seek(one.header_offset)
    head = source.read(_LOCAL)
    return one.header_offset + _LOCAL + sum(int.from_bytes(head[k : k + 2], "little") for k in (26, 28))


def _buffered(raw: Any) -> Any:
    import io

    return io.BufferedReader(raw)
