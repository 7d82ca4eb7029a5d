"""MCAP: records one after the other, many of them packed in chunks.

Source: https://mcap.dev/spec. The index at the end is not used: a recording that was cut off has none, and
one may claim anything. What was written before the cut is read.
"""

from __future__ import annotations

import io
import os
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from robodyn.files import open_regular
from robodyn.logs.bags.storage import (
    CHUNK,
    LOOKED_AT,
    LOOKED_SIZE,
    MESSAGE,
    BadStorage,
    Topic,
    plain,
    unpacked,
)

MAGIC: Final = b"\x89MCAP0\r\n"
#: Largest definition of a type [bytes], most types and most topics.
DEFINITION, ENTRIES = 1 << 18, 1 << 14

_SCHEMA, _CHANNEL, _MESSAGE, _CHUNK, _DATA_END, _FOOTER = 3, 4, 5, 6, 15, 2
_RECORD = struct.Struct("<BQ")
_HEAD = struct.Struct("<HIQQ")


class McapFile:
    """An MCAP file at ``path``, which messages call ``file``."""

    def __init__(self, path: Path, file: str) -> None:
        self.path, self.file = path, file
        self.cut = ""
        self.schemas: dict[int, tuple[str, str, str]] = {}
        self.channels: dict[int, tuple[int, str, str]] = {}

    def topics(self) -> list[Topic]:
        """As :class:`~robodyn.logs.bags.storage.Storage` says."""
        counts: dict[int, int] = {}
        first: dict[int, list[bytes]] = {}
        for key, _, data in self._messages(None):
            counts[key] = counts.get(key, 0) + 1
            kept = first.setdefault(key, [])
            if len(kept) < LOOKED_AT and len(data) <= LOOKED_SIZE:
                kept.append(plain(bytes(data)))
        topics = []
        for key, (schema, name, encoding) in self.channels.items():
            kind, language, definition = self.schemas.get(schema, ("", "", ""))
            heads = tuple(first.get(key, ()))
            topics.append(Topic(key, name, kind, encoding, language, definition, counts.get(key, 0), heads))
        return topics

    def messages(self, keys: set[int]) -> Iterator[tuple[int, bytes]]:
        """As :class:`~robodyn.logs.bags.storage.Storage` says."""
        for _, time, data in self._messages(keys):
            yield time, plain(bytes(data))

    def _messages(self, keys: set[int] | None) -> Iterator[tuple[int, int, memoryview]]:
        """Channel, time [ns] and content of the messages; None: of all channels."""
        with io.BufferedReader(open_regular(self.path, "a recording, such as log.mcap", self.file)) as source:
            size = os.fstat(source.fileno()).st_size
            if source.read(len(MAGIC)) != MAGIC:
                raise BadStorage("no mark of MCAP at its start")
            while head := source.read(_RECORD.size):
                if len(head) < _RECORD.size:
                    self.cut = "in the head of a record"
                    return
                kind, length = _RECORD.unpack(head)
                if kind in (_FOOTER, _DATA_END):
                    return
                if source.tell() + length > size:
                    self.cut = f"at byte {size}, in a record of {length} bytes"
                    return
                if kind not in (_SCHEMA, _CHANNEL, _MESSAGE, _CHUNK):
                    source.seek(length, os.SEEK_CUR)
                    continue
                if length > CHUNK:
                    raise BadStorage(f"a record of {length} bytes, more than {CHUNK}")
                content = memoryview(source.read(length))
                if kind == _CHUNK:
                    yield from self._records(memoryview(_chunk(content)), keys)
                else:
                    yield from self._record(kind, content, keys)

    def _records(self, data: memoryview, keys: set[int] | None) -> Iterator[tuple[int, int, memoryview]]:
        """The messages of a chunk; types and topics in it are noted."""
        place, end = 0, len(data)
        unpack, head_size = _RECORD.unpack_from, _RECORD.size
        while place + head_size <= end:
            kind, length = unpack(data, place)
            place += head_size
            if place + length > end:
                raise BadStorage("a record beyond the end of its chunk")
            if kind in (_MESSAGE, _SCHEMA, _CHANNEL):
                yield from self._record(kind, data[place : place + length], keys)
            place += length

    def _record(
        self, kind: int, data: memoryview, keys: set[int] | None
    ) -> Iterator[tuple[int, int, memoryview]]:
        if kind == _MESSAGE:
            if len(data) < _HEAD.size or len(data) > MESSAGE:
                raise BadStorage(f"a message of {len(data)} bytes")
            channel, _, time, _ = _HEAD.unpack_from(data)
            if keys is None or channel in keys:
                yield channel, time, data[_HEAD.size :]
            return
        reader = _Reader(data)
        if len(self.schemas) + len(self.channels) > ENTRIES:
            raise BadStorage(f"more than {ENTRIES} types and topics")
        if kind == _SCHEMA:
            key, name, language = reader.number(2), reader.text(), reader.text()
            size = reader.number(4)
            text = reader.bytes(min(size, DEFINITION)).decode("utf-8", "replace")
            self.schemas.setdefault(key, (name, language, text if size <= DEFINITION else ""))
        else:
            key, schema = reader.number(2), reader.number(2)
            self.channels.setdefault(key, (schema, reader.text(), reader.text()))


def _chunk(data: memoryview) -> bytes:
    """The records in a chunk."""
    reader = _Reader(data)
    reader.bytes(16)
    size = reader.number(8)
    reader.bytes(4)
    compression, packed = reader.text(), reader.number(8)
    if size > CHUNK:
        raise BadStorage(f"a chunk of {size} bytes, more than {CHUNK}")
    content = reader.bytes(packed)
    records = unpacked(content, compression, size) if compression else content
    if len(records) != size:
        raise BadStorage(f"a chunk of {len(records)} bytes that claims {size}")
    return records


class _Reader:
    """Reads the fields of a record."""

    def __init__(self, data: memoryview) -> None:
        self.data, self.at = data, 0

    def bytes(self, count: int) -> bytes:
        if self.at + count > len(self.data):
            raise BadStorage("a field beyond the end of its record")
        self.at += count
        return bytes(self.data[self.at - count : self.at])

    def number(self, count: int) -> int:
        return int.from_bytes(self.bytes(count), "little")

    def text(self) -> str:
        return self.bytes(self.number(4)).decode("utf-8", "replace")
