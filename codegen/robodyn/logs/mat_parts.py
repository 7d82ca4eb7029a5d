"""The parts of a MATLAB file of version 5: arrays of numbers, wherever they stand in structures and cells.

Source: MathWorks, MAT-File Format (2019), version 5. What is no array of numbers (objects, functions, text)
is stepped over; what claims more than the file has ends the reading of it.
"""

from __future__ import annotations

import math
import zlib
from collections.abc import Iterator
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

#: Bytes that one variable may unpack to, levels of structures in it, and parts of all.
UNPACKED, LEVELS, PARTS = 1 << 31, 16, 1 << 16
#: Elements of a cell or an array of structures that are looked into.
ELEMENTS: Final = 64

_COMPRESSED, _MATRIX, _INT32, _UINT32 = 15, 14, 5, 6
_CELL, _STRUCT, _OBJECT = 1, 2, 3
_NUMERIC: Final = range(6, 16)
_COMPLEX: Final = 0x08
_KINDS: Final = {
    1: "i1", 2: "u1", 3: "i2", 4: "u2", _INT32: "i4", _UINT32: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8",
}  # fmt: skip
_HEAD: Final = 128
_PIECE: Final = 1 << 16


class NotMat(ValueError):
    """The file is not one of MATLAB's, or contradicts itself."""


def variables(data: memoryview) -> Iterator[tuple[str, memoryview, str]]:
    """Name, unpacked content and byte order of each variable of a file, opened one after the other.

    Raises
    ------
    NotMat: the file has no such content, or unpacks to more than is read.
    """
    if len(data) < _HEAD:
        raise NotMat("the file ends in its header")
    order = {b"IM": "<", b"MI": ">"}.get(bytes(data[126:128]))
    if order is None:
        raise NotMat("no mark of the order of bytes in its header")
    place = _HEAD
    while place + 8 <= len(data):
        kind, size = np.frombuffer(data[place : place + 8], f"{order}u4").tolist()
        part = data[place + 8 : place + 8 + size]
        if len(part) < size:
            raise NotMat(f"a variable of {size} bytes, cut off after {len(part)}")
        place += 8 + size
        if kind == _COMPRESSED:
            part = _unpacked(part)
            kind, size = np.frombuffer(part[:8], f"{order}u4").tolist() if len(part) >= 8 else (0, 0)
            part = part[8 : 8 + size]
        if kind == _MATRIX:
            yield _name(part, order), part, order


def _unpacked(part: memoryview) -> memoryview:
    unpacker = zlib.decompressobj()
    pieces, size, rest = [], 0, bytes(part)
    while rest and not unpacker.eof:
        try:
            piece = unpacker.decompress(rest, _PIECE)
        except zlib.error as error:
            raise NotMat(f"a variable that cannot be unpacked: {error}") from None
        size += len(piece)
        if size > UNPACKED:
            raise NotMat(f"a variable that unpacks to more than {UNPACKED} bytes")
        pieces.append(piece)
        rest = unpacker.unconsumed_tail
    return memoryview(b"".join(pieces))


def arrays_of(name: str, content: memoryview, order: str) -> dict[str, NDArray[Any]]:
    """The arrays of numbers in a variable, by their paths: ``log.q`` is the field q of the structure log."""
    arrays: dict[str, NDArray[Any]] = {}
    _Reader(order, arrays).matrix(name, content, LEVELS)
    return arrays


def _name(content: memoryview, order: str) -> str:
    """The name of a variable; "" of those that have none, as objects."""
    reader = _Reader(order, {})
    try:
        flags = reader.element(content, 0)
        if int(np.frombuffer(flags[1][:4], f"{order}u4")[0]) & 0xFF not in (
            _CELL,
            _STRUCT,
            _OBJECT,
            *_NUMERIC,
        ):
            return ""
        dims = reader.element(content, flags[2])
        return bytes(reader.element(content, dims[2])[1]).decode("latin-1")
    except (NotMat, IndexError, ValueError):
        return ""


class _Reader:
    """Reads matrices into ``arrays``; ``order`` is that of the bytes."""

    def __init__(self, order: str, arrays: dict[str, NDArray[Any]]) -> None:
        self.order, self.arrays = order, arrays
        self.parts = 0

    def element(self, data: memoryview, place: int) -> tuple[int, memoryview, int]:
        """Kind and content of the element at ``place``, and where the next one begins."""
        if place + 8 > len(data):
            raise NotMat("the data end in an element")
        self.parts += 1
        if self.parts > PARTS:
            raise NotMat(f"more than {PARTS} parts")
        kind, size = np.frombuffer(data[place : place + 8], f"{self.order}u4").tolist()
        if kind >> 16:  # of up to four bytes, in the tag itself
            kind, size = kind & 0xFFFF, kind >> 16
            if size > 4:
                raise NotMat("a small element of more than four bytes")
            return kind, data[place + 4 : place + 4 + size], place + 8
        content = data[place + 8 : place + 8 + size]
        if len(content) < size:
            raise NotMat(f"an element of {size} bytes, cut off after {len(content)}")
        return kind, content, place + 8 + size + (-size % 8)

    def numbers(self, data: memoryview, place: int) -> tuple[NDArray[Any], int]:
        """The numbers of the element at ``place``, and where the next one begins."""
        kind, content, end = self.element(data, place)
        if kind not in _KINDS:
            raise NotMat(f"an element of kind {kind} where numbers should be")
        dtype = np.dtype(self.order + _KINDS[kind])
        return np.frombuffer(content[: len(content) // dtype.itemsize * dtype.itemsize], dtype), end

    def matrix(self, path: str, data: memoryview, depth: int) -> None:
        """Put the numbers in the matrix ``data`` into ``arrays`` under ``path``."""
        if not data:
            return
        if not depth:
            raise NotMat(f"structures nested more than {LEVELS} deep")
        flags, place = self.numbers(data, 0)
        if not len(flags):
            raise NotMat("a variable without flags")
        kind, complex_ = int(flags[0]) & 0xFF, int(flags[0]) >> 8 & _COMPLEX
        if kind not in (_CELL, _STRUCT, _OBJECT, *_NUMERIC):
            return
        dims, place = self.numbers(data, place)
        shape = [int(length) for length in dims]
        if not 1 <= len(shape) <= 32 or min(shape) < 0:
            raise NotMat("an array without dimensions")
        _, _, place = self.element(data, place)
        count = math.prod(shape)
        if kind in _NUMERIC:
            values, _ = self.numbers(data, place)
            if len(values) < count:
                raise NotMat(f"an array that claims {count} numbers, and has {len(values)}")
            if not complex_ and count > 1:
                self.arrays[path] = values[:count].reshape(shape, order="F")
        elif kind == _CELL:
            for k in range(min(count, ELEMENTS)):
                _, content, place = self.element(data, place)
                self.matrix(f"{path}.{k}", content, depth - 1)
        else:
            self.structures(path, data, place, count, depth, of_class=kind == _OBJECT)

    def structures(
        self, path: str, data: memoryview, place: int, count: int, depth: int, *, of_class: bool
    ) -> None:
        if of_class:
            _, _, place = self.element(data, place)
        lengths, place = self.numbers(data, place)
        _, text, place = self.element(data, place)
        length = int(lengths[0]) if len(lengths) else 0
        if length < 1:
            raise NotMat("a structure whose fields have no names")
        cut = [bytes(text[k : k + length]) for k in range(0, len(text), length)]
        names = [name.partition(b"\0")[0].decode("latin-1") for name in cut]
        for k in range(min(count, ELEMENTS)):
            for name in names:
                _, content, place = self.element(data, place)
                inner = f"{path}.{name}" if count == 1 else f"{path}.{k}.{name}"
                self.matrix(inner, content, depth - 1)
