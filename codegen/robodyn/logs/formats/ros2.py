"""Recordings of ROS 2, MCAP or rosbag2's databases: topics as streams, messages as rows."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.files import read_text
from robodyn.logs.bags import Database, McapFile, Storage, Topic
from robodyn.logs.cdr import NotCdr, Plan, plan_of
from robodyn.logs.formats import LogFormat
from robodyn.logs.recording import RECEIVED, STAMPS, Groups, Recording, Stream
from robodyn.logs.windows import Rows
from robodyn.tools.libraries import ROSBAGS

#: Messages that are taken apart at once, and plans that are remembered for one size of message.
BATCH, PLANS = 4096, 32
#: Files of a folder.
FILES: Final = 1000
_STAMP: Final = "header.stamp"
_SUFFIXES: Final = (".mcap", ".db3")


@dataclass(frozen=True, slots=True)
class _Channel:
    """A topic in the files that have it: its keys in each, and the definition of its type."""

    topic: Topic
    keys: list[tuple[Storage, set[int]]]
    definitions: Mapping[str, Any]


def open_ros2(path: Path, file: str, gaps: bool) -> Recording:
    """The recording at ``path``: an MCAP file, a database of rosbag2, or a folder with some of them.

    Raises
    ------
    InputError: there are no messages.
    """
    paths = _files(path, file) if path.is_dir() else [path]
    is_mcap = paths[0].suffix.lower() == ".mcap"
    channels: dict[str, _Channel] = {}
    counts: dict[str, int] = {}
    first: dict[str, list[bytes]] = {}
    notes = []
    for each in paths:
        storage: Storage = McapFile(each) if each.suffix.lower() == ".mcap" else Database(each)
        for topic in storage.topics():
            name = topic.name
            channel = channels.setdefault(name, _Channel(topic, [], _definitions(topic)))
            if channel.topic.type != topic.type:
                notes.append(f"{name}: messages of another type, {topic.type}, left out")
                continue
            channel.keys.append((storage, {topic.key}))
            counts[name] = counts.get(name, 0) + topic.count
            first.setdefault(name, []).extend(topic.first)
        if storage.cut:
            notes.append(f"{each.name}: cut off at byte {storage.cut}; what stands before it is read")
    streams = tuple(
        _stream(channel, counts[name], first[name]) for name, channel in channels.items() if counts.get(name)
    )
    format = "MCAP" if is_mcap else "rosbag2"
    if not streams:
        raise InputError(f"there are no messages in the {format} file", where=Place(file))

    def parts(stream: Stream, groups: Groups, stamp: str | None) -> Iterator[Rows]:
        return _parts(channels[stream.name], groups, None if stamp == RECEIVED else stamp)

    return Recording(file, format, streams, parts, tuple(notes))


def _parts(channel: _Channel, groups: Groups, stamp: str | None) -> Iterator[Rows]:
    """The messages of ``channel`` that have all columns."""
    reader = _Reader(channel, groups, stamp)
    for times, messages in _batches(channel):
        is_sound, tables, stamps = reader.rows(messages)
        yield {
            **{group: table[is_sound] for group, table in tables.items()},
            RECEIVED: times[is_sound],
            STAMPS: times[is_sound] if stamps is None else stamps[is_sound],
        }


def _batches(channel: _Channel) -> Iterator[tuple[NDArray[np.int64], list[bytes]]]:
    """Times [ns] and contents of the messages of ``channel``."""
    times: list[int] = []
    messages: list[bytes] = []
    for storage, keys in channel.keys:
        for time, data in storage.messages(keys):
            times.append(time if time < 1 << 63 else 0)
            messages.append(data)
            if len(messages) == BATCH:
                yield np.array(times, dtype=np.int64), messages
                times, messages = [], []
    if messages:
        yield np.array(times, dtype=np.int64), messages


class _Reader:
    """Takes messages of a channel apart, as plans of earlier ones say."""

    def __init__(self, channel: _Channel, groups: Groups, stamp: str | None) -> None:
        self.channel, self.groups, self.stamp = channel, groups, stamp
        self.wanted = [name for names in groups.values() for name in names]
        self.plans: dict[int, list[Plan]] = {}

    def rows(
        self, messages: list[bytes]
    ) -> tuple[NDArray[np.bool_], dict[str, NDArray[np.float64]], NDArray[np.int64] | None]:
        """Which messages have all columns; their numbers [B, m] by group, and their stamps [B]."""
        count = len(messages)
        sound = np.zeros(count, dtype=bool)
        tables = {group: np.empty((count, len(names))) for group, names in self.groups.items()}
        stamps = np.zeros(count, dtype=np.int64) if self.stamp is not None else None
        sizes = np.fromiter(map(len, messages), np.int64, count)
        for size in np.unique(sizes).tolist():
            left = np.flatnonzero(sizes == size)
            table = np.frombuffer(b"".join([messages[k] for k in left.tolist()]), np.uint8)
            table = table.reshape(len(left), size)
            known = self.plans.setdefault(size, [])
            tried = 0
            while len(left):
                if tried < len(known):
                    plan = known[tried]
                    tried += 1
                else:
                    plan = plan_of(messages[int(left[0])], self.channel.topic.type, self.channel.definitions)
                    known.insert(0, plan)
                    del known[PLANS:]
                    tried = len(known)
                like = plan.fits(table)
                at = left[like]
                if len(at) and self._has(plan):
                    part = table[like]
                    sound[at] = True
                    for group, names in self.groups.items():
                        for k, name in enumerate(names):
                            tables[group][at, k] = plan.numbers(part, name)
                    if stamps is not None and self.stamp is not None:
                        stamps[at] = plan.times(part, self.stamp)
                left, table = left[~like], table[~like]
        return sound, tables, stamps

    def _has(self, plan: Plan) -> bool:
        stamped = self.stamp is None or self.stamp in plan.stamps
        return stamped and all(name in plan.columns for name in self.wanted)


def _stream(channel: _Channel, count: int, first: Sequence[bytes]) -> Stream:
    """The stream of a topic: the columns of its first messages. One that cannot be read has none."""
    topic = channel.topic
    columns: dict[str, None] = {}
    stamps: dict[str, None] = {}
    times = []
    for message in first:
        try:
            plan = plan_of(message, topic.type, channel.definitions)
        except NotCdr:
            continue
        columns.update(dict.fromkeys(plan.columns))
        stamps.update(dict.fromkeys(plan.stamps))
        if _STAMP in plan.stamps:
            data = np.frombuffer(message, np.uint8)[None, :]
            times.append(int(plan.times(data, _STAMP)[0]))
    own = [_STAMP] if any(times) and (len(set(times)) > 1 or len(times) < 2) else []
    others = [name for name in stamps if name not in own]
    return Stream(
        topic.name, topic.type, count, tuple(columns), stamps=(*own, RECEIVED, *others)
    )  # fmt: skip


def _definitions(topic: Topic) -> Mapping[str, Any]:
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


def _files(folder: Path, file: str) -> list[Path]:
    """The files of a recording in a folder, in their order."""
    listed = _listed(folder)
    if not listed:
        names = [path for path in folder.iterdir() if path.suffix.lower() in _SUFFIXES and path.is_file()]
        listed = sorted(names, key=_by_number)
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


def _by_number(path: Path) -> list[tuple[int, str]]:
    """bag_2.db3 before bag_10.db3."""
    return [(int(part[:18]), "") if part.isdecimal() else (0, part) for part in re.split(r"(\d+)", path.name)]


def _listed(folder: Path) -> list[Path]:
    """The files that metadata.yaml lists, and that are there."""
    from robodyn.robot import document

    about = folder / "metadata.yaml"
    if not about.is_file():
        return []
    try:
        node = document.compose(read_text(about, 1 << 20, "metadata of a recording"), str(about))
    except InputError:
        return []
    for key in ("rosbag2_bagfile_information", "relative_file_paths"):
        entries = node.entries if isinstance(node, document.Mapping) else ()
        node = next((value for name, value in entries if name.text == key), node)
    items = node.items if isinstance(node, document.Sequence) else ()
    names = [PurePath(item.text).name for item in items if isinstance(item, document.Scalar)]
    paths = [folder / name for name in names]
    return paths if all(path.is_file() and path.suffix.lower() in _SUFFIXES for path in paths) else []


FORMAT = LogFormat("ros2", _SUFFIXES, "a recording of ROS 2", open_ros2, library=ROSBAGS, folders=True)
