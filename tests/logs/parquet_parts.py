"""Parquet files taken apart and put together again, so that tests can write what no writer would.

Values of Thrift's compact protocol are plain: a struct is ``{number: (kind, value)}``, a list
``(kind, [values])``.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

BOOL, I32, I64, BINARY, LIST, STRUCT = 1, 5, 6, 8, 9, 12

Struct = dict[int, tuple[int, Any]]


@dataclass
class Page:
    """A page: its head, and its bytes as they stand in the file."""

    head: Struct
    body: bytes


@dataclass
class Parts:
    """A file: the footer, and the pages of each column of each group of rows."""

    footer: Struct
    pages: list[list[list[Page]]] = field(default_factory=list)

    @property
    def groups(self) -> list[Struct]:
        return self.footer[4][1][1]  # type: ignore[no-any-return]

    def columns(self, group: int) -> list[Struct]:
        """What the footer says of each column of a group (ColumnMetaData)."""
        return [chunk[3][1] for chunk in self.groups[group][1][1][1]]

    def claim(self, rows: int, *, file: bool = False, groups: bool = False, columns: bool = False) -> None:
        """Let the file, its first group, or all columns of that say that there are so many rows."""
        if file:
            put(self.footer, 3, rows)
        if groups:
            put(self.groups[0], 3, rows)
        for column in self.columns(0) if columns else []:
            put(column, 5, rows)

    def each_page(self, edit: Callable[[Page], None]) -> None:
        for page in (page for group in self.pages for column in group for page in column):
            edit(page)

    def data(self) -> bytes:
        """The bytes of the file, with places and sizes as they come to be."""
        out = io.BytesIO()
        out.write(b"PAR1")
        for k, group in enumerate(self.pages):
            for column, pages in zip(self.columns(k), group, strict=True):
                start = out.tell()
                for page in pages:
                    if page.head[1][1] == 2:
                        put(column, 11, out.tell())
                    elif page is next(each for each in pages if each.head[1][1] != 2):
                        put(column, 9, out.tell())
                    put(page.head, 3, len(page.body))
                    out.write(written(STRUCT, page.head) + page.body)
                put(column, 7, out.tell() - start)
        end = written(STRUCT, self.footer)
        return out.getvalue() + end + len(end).to_bytes(4, "little") + b"PAR1"


def put(struct: Struct, number: int, value: Any) -> None:
    """Give a field that is there another value."""
    struct[number] = (struct[number][0], value)


def taken_apart(data: bytes) -> Parts:
    length = int.from_bytes(data[-8:-4], "little")
    parts = Parts(_Reader(data[-8 - length : -8]).value(STRUCT))
    for k in range(len(parts.groups)):
        parts.pages.append([])
        for column in parts.columns(k):
            offsets = [column[number][1] for number in (9, 11) if number in column]
            place, end = min(offsets), min(offsets) + column[7][1]
            pages = []
            while place < end:
                reader = _Reader(data[place:end])
                head = reader.value(STRUCT)
                place += reader.at + head[3][1]
                pages.append(Page(head, data[place - head[3][1] : place]))
            parts.pages[-1].append(pages)
    return parts


class _Reader:
    def __init__(self, data: bytes) -> None:
        self.data, self.at = data, 0

    def take(self, count: int) -> bytes:
        self.at += count
        return self.data[self.at - count : self.at]

    def unsigned(self) -> int:
        value = shift = 0
        while True:
            byte = self.take(1)[0]
            value, shift = value | (byte & 127) << shift, shift + 7
            if byte < 128:
                return value

    def signed(self) -> int:
        value = self.unsigned()
        return (value >> 1) ^ -(value & 1)

    def value(self, kind: int) -> Any:
        if kind in (1, 2):
            return kind == 1
        if kind == 3:
            return self.take(1)
        if kind in (4, I32, I64):
            return self.signed()
        if kind == 7:
            return self.take(8)
        if kind == BINARY:
            return self.take(self.unsigned())
        if kind == LIST:
            head = self.take(1)[0]
            count = self.unsigned() if head >> 4 == 15 else head >> 4
            if head & 15 in (1, 2):
                return head & 15, [self.take(1) == b"\1" for _ in range(count)]
            return head & 15, [self.value(head & 15) for _ in range(count)]
        assert kind == STRUCT, kind
        found: Struct = {}
        last = 0
        while head := self.take(1)[0]:
            last = last + (head >> 4) if head >> 4 else self.signed()
            found[last] = (head & 15, self.value(head & 15))
        return found


def _unsigned(value: int) -> bytes:
    out = bytearray()
    while value > 127:
        out.append(value & 127 | 128)
        value >>= 7
    return bytes([*out, value])


def _signed(value: int) -> bytes:
    return _unsigned(value << 1 if value >= 0 else (-value << 1) - 1)


def written(kind: int, value: Any) -> bytes:
    if kind in (1, 2):
        return b""
    if kind in (3, 7):
        return bytes(value)
    if kind in (4, I32, I64):
        return _signed(value)
    if kind == BINARY:
        return _unsigned(len(value)) + bytes(value)
    if kind == LIST:
        inner, values = value
        head = bytes([len(values) << 4 | inner]) if len(values) < 15 else bytes([0xF0 | inner])
        count = b"" if len(values) < 15 else _unsigned(len(values))
        each = (
            (b"\1" if x else b"\2" for x in values)
            if inner in (1, 2)
            else (written(inner, x) for x in values)
        )
        return head + count + b"".join(each)
    assert isinstance(value, Mapping)
    out, last = b"", 0
    for number, (inner, each) in sorted(value.items()):
        tag = (1 if each else 2) if inner in (1, 2) else inner
        step = number - last
        out += bytes([step << 4 | tag]) if 0 < step < 16 else bytes([tag]) + _signed(number)
        out += written(inner, each)
        last = number
    return out + b"\0"
