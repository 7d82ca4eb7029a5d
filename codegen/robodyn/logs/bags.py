"""Files that messages of ROS 2 are stored in: MCAP, and rosbag2's databases. What topics they have, and the
messages one by one."""

from __future__ import annotations

import os
import struct
from collections.abc import Iterator
from contextlib import AbstractContextManager, closing
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any, Final, Protocol

from robodyn.tools.libraries import MCAP

#: Messages of a topic that are looked at to learn what it has, and the largest of them [bytes].
LOOKED_AT, LOOKED_SIZE = 24, 1 << 18

_ZSTD: Final = b"\x28\xb5\x2f\xfd"
_SCHEMA, _CHANNEL, _MESSAGE = 3, 4, 5
_RECORD = struct.Struct("<BQ")
_HEAD = struct.Struct("<HIQQ")


@dataclass(frozen=True, slots=True)
class Topic:
    """A topic of a file: its ``key`` there, ``name``, ``type`` of message, ``encoding``, ``definition`` and
    its ``language`` (ros2msg, ros2idl or none), how many messages it has, and the first of them."""

    key: int
    name: str
    type: str
    encoding: str
    language: str
    definition: str
    count: int
    first: tuple[bytes, ...]


class Storage(Protocol):
    """A file with messages; ``cut``: the byte at which it breaks off, 0 if it does not."""

    @property
    def cut(self) -> int: ...
    def topics(self) -> list[Topic]:
        """What is in it."""
        ...

    def messages(self, keys: set[int]) -> Iterator[tuple[int, bytes]]:
        """Time of recording [ns] and content of the messages of some topics, as they stand in the file."""
        ...


def _unpacked(message: bytes) -> bytes:
    """A message that may be compressed on its own: CDR never begins so."""
    if not message.startswith(_ZSTD):
        return message
    import zstandard  # comes with mcap

    content: bytes = zstandard.ZstdDecompressor().decompressobj().decompress(message)
    return content


class McapFile:
    """An MCAP file at ``path``. The index at its end is not used: a recording that was cut off has none, and
    what was written before the cut is read."""

    def __init__(self, path: Path) -> None:
        MCAP.load()
        self.path, self.cut = path, 0
        self._schemas: dict[int, Any] = {}
        self._channels: dict[int, Any] = {}

    def topics(self) -> list[Topic]:
        """As :class:`Storage` says."""
        counts: dict[int, int] = {}
        first: dict[int, list[bytes]] = {}
        for key, _, data in self._messages(None):
            counts[key] = counts.get(key, 0) + 1
            kept = first.setdefault(key, [])
            if len(kept) < LOOKED_AT and len(data) <= LOOKED_SIZE:
                kept.append(_unpacked(bytes(data)))
        topics = []
        for key, channel in self._channels.items():
            schema = self._schemas.get(channel.schema_id)
            name, language, text = (
                ("", "", b"") if schema is None else (schema.name, schema.encoding, schema.data)
            )
            topics.append(
                Topic(
                    key, channel.topic, name, channel.message_encoding, language,
                    text.decode("utf-8", "replace"), counts.get(key, 0), tuple(first.get(key, ())),
                )
            )  # fmt: skip
        return topics

    def messages(self, keys: set[int]) -> Iterator[tuple[int, bytes]]:
        """As :class:`Storage` says."""
        return ((time, _unpacked(bytes(data))) for _, time, data in self._messages(keys))

    def _messages(self, keys: set[int] | None) -> Iterator[tuple[int, int, bytes | memoryview]]:
        """Channel, time [ns] and content of the messages; None: of all channels."""
        from mcap.records import Channel, Chunk, DataEnd, Message, Schema
        from mcap.stream_reader import StreamReader, get_chunk_data_stream

        with self.path.open("rb") as source:
            size = os.fstat(source.fileno()).st_size
            try:
                for record in StreamReader(source, emit_chunks=True).records:
                    if isinstance(record, DataEnd):
                        return
                    if source.tell() == size:  # the last record may lack its end
                        break
                    if isinstance(record, Schema):
                        self._schemas.setdefault(record.id, record)
                    elif isinstance(record, Channel):
                        self._channels.setdefault(record.id, record)
                    elif isinstance(record, Message) and (keys is None or record.channel_id in keys):
                        yield record.channel_id, record.log_time, record.data
                    elif isinstance(record, Chunk):
                        stream, length = get_chunk_data_stream(record, validate_crc=True)
                        yield from self._of_chunk(memoryview(stream.read(length)), keys)
            except Exception:
                if source.tell() < size:
                    raise
            self.cut = size

    def _of_chunk(self, data: memoryview, keys: set[int] | None) -> Iterator[tuple[int, int, memoryview]]:
        """The messages of a chunk; mcap's own reader makes an object of each, at three times the cost."""
        from mcap.data_stream import ReadDataStream
        from mcap.records import Channel, Schema

        place = 0
        while place + _RECORD.size <= len(data):
            kind, length = _RECORD.unpack_from(data, place)
            place += _RECORD.size
            content = data[place : place + length]
            place += length
            if place > len(data):
                raise ValueError("a record beyond the end of its chunk")
            if kind == _MESSAGE:
                channel, _, time, _ = _HEAD.unpack_from(content)
                if keys is None or channel in keys:
                    yield channel, time, content[_HEAD.size :]
            elif kind in (_SCHEMA, _CHANNEL):
                read, records = (
                    (Schema.read, self._schemas) if kind == _SCHEMA else (Channel.read, self._channels)
                )
                record = read(ReadDataStream(BytesIO(content)))
                records.setdefault(record.id, record)


class Database:
    """rosbag2's database at ``path``: messages in a table of SQLite."""

    cut = 0

    def __init__(self, path: Path) -> None:
        beside = path.with_name(path.name + "-wal")
        # Nothing is written; what a recorder that died has left in its journal is read with the rest.
        mode = "mode=ro" if beside.is_file() and beside.stat().st_size else "mode=ro&immutable=1"
        self._uri = f"{path.absolute().as_uri()}?{mode}"

    def _opened(self) -> AbstractContextManager[Any]:
        import sqlite3

        return closing(sqlite3.connect(self._uri, uri=True))

    def topics(self) -> list[Topic]:
        """As :class:`Storage` says."""
        with self._opened() as connection:
            query = "SELECT name FROM sqlite_master WHERE type = 'table'"  # a view could run for ever
            tables = {name for (name,) in connection.execute(query)}
            if not {"topics", "messages"} <= tables:
                raise ValueError("no tables topics and messages: this is no recording of ROS 2")
            definitions: dict[str, tuple[str, str]] = {}
            if "message_definitions" in tables:
                query = "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions"
                definitions = {kind: (language, text) for kind, language, text in connection.execute(query)}
            topics = []
            query = "SELECT id, name, type, serialization_format FROM topics"
            for key, name, kind, encoding in connection.execute(query).fetchall():
                query = "SELECT count(*) FROM messages WHERE topic_id = ?"
                (count,) = connection.execute(query, (key,)).fetchone()
                query = "SELECT data FROM messages WHERE topic_id = ? AND length(data) <= ? LIMIT ?"
                heads = connection.execute(query, (key, LOOKED_SIZE, LOOKED_AT)).fetchall()
                language, text = definitions.get(kind, ("", ""))
                first = tuple(_unpacked(data) for (data,) in heads)
                topics.append(Topic(key, name, kind, encoding, language, text, count, first))
            return topics

    def messages(self, keys: set[int]) -> Iterator[tuple[int, bytes]]:
        """As :class:`Storage` says."""
        with self._opened() as connection:
            marks = ",".join("?" * len(keys))
            query = f"SELECT timestamp, data FROM messages WHERE topic_id IN ({marks}) ORDER BY id"
            for time, data in connection.execute(query, sorted(keys)):
                yield time, _unpacked(data)
