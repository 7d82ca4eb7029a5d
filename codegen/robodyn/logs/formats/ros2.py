"""Recordings of ROS 2, MCAP or rosbag2's databases: topics as streams, messages as rows."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, closing
from dataclasses import dataclass, field
from pathlib import Path, PurePath
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.files import read_text
from robodyn.logs.cdr import MessageReader, NotCdr, plan_of
from robodyn.logs.formats import LogFormat
from robodyn.logs.recording import RECEIVED, STAMPS, Groups, Recording, Stream
from robodyn.logs.windows import Rows
from robodyn.tools.libraries import MCAP, ROSBAGS

#: Messages that are taken apart at once; messages of a topic that are looked at to learn what it has, and the
#: largest of them [bytes].
BATCH, LOOKED_AT, LOOKED_SIZE = 4096, 24, 1 << 18
#: Files of a folder.
FILES: Final = 1000
_STAMP: Final = "header.stamp"
_SUFFIXES: Final = (".mcap", ".db3")
_ZSTD: Final = b"\x28\xb5\x2f\xfd"


@dataclass(slots=True)
class _Topic:
    """A topic of a file: its ``key`` there, ``name``, ``type`` of message, ``encoding``, ``definition`` and
    its ``language`` (ros2msg, ros2idl or none), how many messages it has, and the first of them."""

    key: int
    name: str
    type: str
    encoding: str
    language: str
    definition: str
    count: int
    first: Sequence[bytes]


@dataclass(slots=True)
class _Channel:
    """A topic in the ``files`` that have it, with its key in each: its ``type`` of message and the
    ``definitions`` of that, and of all files how many messages they have, and the first of each."""

    type: str
    definitions: Mapping[str, Any]
    files: list[tuple[_McapFile | _Database, int]] = field(default_factory=list)
    count: int = 0
    first: list[bytes] = field(default_factory=list)


def open_ros2(path: Path, file: str, gaps: bool) -> Recording:
    """The recording at ``path``: an MCAP file, a database of rosbag2, or a folder with some of them.

    Raises
    ------
    InputError: there are no messages.
    """
    paths = _files(path, file) if path.is_dir() else [path]
    channels: dict[str, _Channel] = {}
    notes = []
    for each in paths:
        storage = _McapFile(each) if each.suffix.lower() == ".mcap" else _Database(each)
        for topic in storage.topics():
            if topic.name not in channels:
                channels[topic.name] = _Channel(topic.type, _definitions(topic))
            channel = channels[topic.name]
            if channel.type != topic.type:
                notes.append(f"{topic.name}: messages of another type, {topic.type}, left out")
                continue
            channel.files.append((storage, topic.key))
            channel.count += topic.count
            channel.first += topic.first
        if storage.cut:
            notes.append(f"{each.name}: cut off at byte {storage.cut}; what stands before it is read")
    streams = tuple(_stream(name, channel) for name, channel in channels.items() if channel.count)
    format = "MCAP" if paths[0].suffix.lower() == ".mcap" else "rosbag2"
    if not streams:
        raise InputError(f"there are no messages in the {format} file", where=Place(file))

    def parts(stream: Stream, groups: Groups, stamp: str | None) -> Iterator[Rows]:
        channel = channels[stream.name]
        own = None if stamp == RECEIVED else stamp
        reader = MessageReader(channel.type, channel.definitions, groups, own)
        for times, messages in _batches(channel):
            is_sound, tables, stamps = reader.rows(messages)
            yield {
                **{group: table[is_sound] for group, table in tables.items()},
                RECEIVED: times[is_sound],
                STAMPS: (times if own is None else stamps)[is_sound],
            }

    return Recording(file, format, streams, parts, tuple(notes))


def _batches(channel: _Channel) -> Iterator[tuple[NDArray[np.int64], list[bytes]]]:
    """Times [ns] and contents of the messages of ``channel``."""
    times: list[int] = []
    messages: list[bytes] = []
    for storage, key in channel.files:
        for time, data in storage.messages(key):
            times.append(time if time < 1 << 63 else 0)
            messages.append(data)
            if len(messages) == BATCH:
                yield np.array(times, dtype=np.int64), messages
                times, messages = [], []
    if messages:
        yield np.array(times, dtype=np.int64), messages


def _stream(name: str, channel: _Channel) -> Stream:
    """The stream of a topic: the columns of its first messages. One that cannot be read has none."""
    columns: dict[str, None] = {}
    stamps: dict[str, None] = {}
    times = []
    for message in channel.first:
        try:
            plan = plan_of(message, channel.type, channel.definitions)
        except NotCdr:
            continue
        columns.update(dict.fromkeys(plan.columns))
        stamps.update(dict.fromkeys(plan.stamps))
        if _STAMP in plan.stamps:
            times.append(int(plan.times(np.frombuffer(message, np.uint8)[None, :], _STAMP)[0]))
    own = [_STAMP] if any(times) and (len(set(times)) > 1 or len(times) < 2) else []
    others = [each for each in stamps if each not in own]
    return Stream(name, channel.type, channel.count, tuple(columns), stamps=(*own, RECEIVED, *others))


def _definitions(topic: _Topic) -> Mapping[str, Any]:
    """Definitions of the types of a topic: those of the file, on top of the usual ones."""
    typesys = ROSBAGS.load("typesys")
    usual: dict[str, Any] = dict(typesys.get_typestore(typesys.Stores.LATEST).fielddefs)
    if topic.encoding != "cdr":
        return {}
    try:
        if topic.language == "ros2msg":
            usual.update(typesys.get_types_from_msg(topic.definition, topic.type))
        elif topic.language in ("ros2idl", "omgidl"):
            for part in re.split(r"(?m)^=+\n", topic.definition):
                text = part.partition("\n")[2] if part.startswith("IDL:") else part
                if text.strip():
                    usual.update(typesys.get_types_from_idl(text))
    except Exception as error:  # of the parser; the usual definitions may do
        if isinstance(error, MemoryError):
            raise
    return usual


# --- files ------------------------------------------------------------------------------------------------


def _files(folder: Path, file: str) -> list[Path]:
    """The files of a recording in a folder, in their order: as metadata.yaml lists them, else by number,
    bag_2.db3 before bag_10.db3."""

    def by_number(path: Path) -> list[tuple[int, str]]:
        parts = re.split(r"(\d+)", path.name)
        return [(int(part[:18]), "") if part.isdecimal() else (0, part) for part in parts]

    listed = _listed(folder)
    if not listed:
        inside = [path for path in folder.iterdir() if path.suffix.lower() in _SUFFIXES and path.is_file()]
        listed = sorted(inside, key=by_number)
    if not listed:
        packed = [path.name for path in folder.iterdir() if path.suffix == ".zstd"]
        raise InputError(
            "there is no recording in the folder",
            where=Place(file),
            found=packed[0] if packed else None,
            expected="MCAP or .db3 files, with metadata.yaml or without",
            remedy="unpack it: zstd -d" if packed else None,
        )
    return listed[:FILES]


def _listed(folder: Path) -> list[Path]:
    """The files that metadata.yaml lists, and that are there."""
    from robodyn.robot import document

    metadata = folder / "metadata.yaml"
    if not metadata.is_file():
        return []
    try:
        node = document.compose(read_text(metadata, 1 << 20, "metadata of a recording"), str(metadata))
    except InputError:
        return []
    for key in ("rosbag2_bagfile_information", "relative_file_paths"):
        entries = node.entries if isinstance(node, document.Mapping) else ()
        node = next((value for name, value in entries if name.text == key), node)
    items = node.items if isinstance(node, document.Sequence) else ()
    paths = [folder / PurePath(item.text).name for item in items if isinstance(item, document.Scalar)]
    return paths if all(path.is_file() and path.suffix.lower() in _SUFFIXES for path in paths) else []


class _McapFile:
    """An MCAP file; ``cut``: the byte at which it breaks off, 0 if it does not. The index at its end is not
    used: a recording that was cut off has none, and what was written before the cut is read."""

    def __init__(self, path: Path) -> None:
        MCAP.load()
        self._path, self.cut = path, 0
        self._schemas: dict[int, Any] = {}
        self._channels: dict[int, Any] = {}

    def topics(self) -> Iterator[_Topic]:
        """What is in it."""
        counts: dict[int, int] = {}
        first: dict[int, list[bytes]] = {}
        for message in self._messages():
            key = message.channel_id
            counts[key] = counts.get(key, 0) + 1
            kept = first.setdefault(key, [])
            if len(kept) < LOOKED_AT and len(message.data) <= LOOKED_SIZE:
                kept.append(_unpacked(message.data))
        for key, channel in self._channels.items():
            schema = self._schemas.get(channel.schema_id)
            kind, language, text = (schema and (schema.name, schema.encoding, schema.data)) or ("", "", b"")
            yield _Topic(
                key, channel.topic, kind, channel.message_encoding, language,
                text.decode("utf-8", "replace"), counts.get(key, 0), first.get(key, ()),
            )  # fmt: skip

    def messages(self, key: int) -> Iterator[tuple[int, bytes]]:
        """Time of recording [ns] and content of the messages of a topic, as they stand in the file."""
        messages = (each for each in self._messages() if each.channel_id == key)
        return ((each.log_time, _unpacked(each.data)) for each in messages)

    def _messages(self) -> Iterator[Any]:
        from mcap.records import Channel, Chunk, DataEnd, Message, Schema
        from mcap.stream_reader import StreamReader, breakup_chunk

        with self._path.open("rb") as source:
            size = os.fstat(source.fileno()).st_size
            try:
                for record in StreamReader(source, emit_chunks=True).records:
                    if isinstance(record, DataEnd):
                        return
                    if source.tell() == size:  # the last record may lack its end
                        break
                    records = [record]
                    if isinstance(record, Chunk):
                        records = breakup_chunk(record, validate_crc=True)
                    for each in records:
                        if isinstance(each, Message):
                            yield each
                        elif isinstance(each, Schema):
                            self._schemas.setdefault(each.id, each)
                        elif isinstance(each, Channel):
                            self._channels.setdefault(each.id, each)
            except Exception:
                if source.tell() < size:
                    raise
            self.cut = size


class _Database:
    """rosbag2's database at ``path``: messages in a table of SQLite."""

    cut = 0

    def __init__(self, path: Path) -> None:
        journal = path.with_name(path.name + "-wal")
        # Nothing is written; what a recorder that died has left in its journal is read with the rest.
        mode = "mode=ro" if journal.is_file() and journal.stat().st_size else "mode=ro&immutable=1"
        self._uri = f"{path.absolute().as_uri()}?{mode}"

    def _opened(self) -> AbstractContextManager[Any]:
        import sqlite3

        return closing(sqlite3.connect(self._uri, uri=True))

    def topics(self) -> Iterator[_Topic]:
        """What is in it."""
        with self._opened() as connection:
            query = "SELECT name FROM sqlite_master WHERE type = 'table'"  # a view could run for ever
            tables = {name for (name,) in connection.execute(query)}
            if not {"topics", "messages"} <= tables:
                raise ValueError("no tables topics and messages: this is no recording of ROS 2")
            definitions: dict[str, tuple[str, str]] = {}
            if "message_definitions" in tables:
                query = "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions"
                definitions = {kind: (language, text) for kind, language, text in connection.execute(query)}
            query = "SELECT id, name, type, serialization_format FROM topics"
            for key, name, kind, encoding in connection.execute(query).fetchall():
                query = "SELECT count(*) FROM messages WHERE topic_id = ?"
                (count,) = connection.execute(query, (key,)).fetchone()
                query = "SELECT data FROM messages WHERE topic_id = ? AND length(data) <= ? LIMIT ?"
                heads = connection.execute(query, (key, LOOKED_SIZE, LOOKED_AT)).fetchall()
                first = [_unpacked(data) for (data,) in heads]
                yield _Topic(key, name, kind, encoding, *definitions.get(kind, ("", "")), count, first)

    def messages(self, key: int) -> Iterator[tuple[int, bytes]]:
        """Time of recording [ns] and content of the messages of a topic, as they stand in the file."""
        with self._opened() as connection:
            query = "SELECT timestamp, data FROM messages WHERE topic_id = ? ORDER BY id"
            for time, data in connection.execute(query, (key,)):
                yield time, _unpacked(data)


def _unpacked(message: bytes) -> bytes:
    """A message that may be compressed on its own: CDR never begins so."""
    if not message.startswith(_ZSTD):
        return message
    import zstandard  # comes with mcap

    content: bytes = zstandard.ZstdDecompressor().decompressobj().decompress(message)
    return content


FORMAT = LogFormat("ros2", _SUFFIXES, "a recording of ROS 2", open_ros2, library=ROSBAGS, folders=True)
