"""A recording of ROS 2: its topics as streams, its messages as rows."""

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
from robodyn.logs.bags.cdr import NotCdr, Plan, plan_of
from robodyn.logs.bags.mcap import McapFile
from robodyn.logs.bags.sqlite import Database
from robodyn.logs.bags.storage import BadStorage, Storage, Topic, needed
from robodyn.logs.columns import LARGEST
from robodyn.logs.recording import RECEIVED, Stream, Table, damaged
from robodyn.logs.windows import Rows, in_order

Floats = NDArray[np.float64]

#: Messages that are taken apart at once, and plans that are remembered for one size of message.
BATCH, PLANS = 4096, 32
#: Files of a folder.
FILES: Final = 1000
_STAMP: Final = "header.stamp"
#: Beside groups of columns: the stamps of messages.
_STAMPS: Final = "stamps"


def open_bag(path: Path, file: str) -> BagRecording:
    """The recording at ``path``: an MCAP file, a database of rosbag2, or a folder with some of them.

    Raises
    ------
    InputError: it is none, or damaged.
    ToolError: rosbags is missing.
    """
    paths = _files(path, file) if path.is_dir() else [path]
    needed("rosbags.typesys")
    return BagRecording(paths, file)


@dataclass(frozen=True, slots=True)
class _Channel:
    """A topic in the files that have it: keys by the place of the file, and the definition of its type."""

    topic: Topic
    keys: dict[int, set[int]]
    definitions: Mapping[str, Any]


class BagRecording:
    """The topics in the files ``paths``, which messages call ``file``."""

    def __init__(self, paths: Sequence[Path], file: str) -> None:
        self.file = file
        self.format = "MCAP" if paths[0].suffix.lower() == ".mcap" else "rosbag2"
        self._storages: list[Storage] = []
        self._channels: dict[str, _Channel] = {}
        counts: dict[str, int] = {}
        first: dict[str, list[bytes]] = {}
        notes = []
        try:
            for k, path in enumerate(paths):
                kind = McapFile if path.suffix.lower() == ".mcap" else Database
                storage: Storage = kind(path, file)
                self._storages.append(storage)
                for topic in storage.topics():
                    name = topic.name
                    if name not in self._channels:
                        self._channels[name] = _Channel(topic, {}, _definitions(topic))
                    channel = self._channels[name]
                    if channel.topic.type != topic.type:
                        notes.append(f"{name}: messages of another type, {topic.type}, left out")
                        continue
                    channel.keys.setdefault(k, set()).add(topic.key)
                    counts[name] = counts.get(name, 0) + topic.count
                    first.setdefault(name, []).extend(topic.first)
                if storage.cut:
                    notes.append(f"{path.name}: cut off {storage.cut}; what stands before it is read")
        except BadStorage as error:
            raise damaged(file, self.format, error) from None
        self.streams = tuple(
            _stream(channel, counts[name], first[name])
            for name, channel in self._channels.items()
            if counts.get(name)
        )
        self.notes = tuple(notes)
        if not self.streams:
            raise InputError(f"there are no messages in the {self.format} file", where=Place(file))

    def read(self, stream: Stream, groups: Mapping[str, Sequence[str]], stamp: str | None) -> Table:
        """As :class:`~robodyn.logs.recording.Recording` says."""
        rows, width = stream.rows or 0, sum(map(len, groups.values())) + 2
        if rows > LARGEST // width:
            raise InputError(
                "the log is too long",
                where=Place(self.file),
                found=f"{rows} messages of {width} columns",
                expected=f"at most {LARGEST} numbers",
            )
        tables = {group: np.empty((rows, len(names))) for group, names in groups.items()}
        stamps, received = np.empty(rows, np.int64), np.empty(rows, np.int64)
        filled = 0
        for part in self._parts(stream, groups, stamp):
            end = filled + len(part[RECEIVED])
            for group, table in tables.items():
                table[filled:end] = part[group]
            received[filled:end], stamps[filled:end] = part[RECEIVED], part[_STAMPS]
            filled = end
        for table in tables.values():
            table.resize((filled, table.shape[1]), refcheck=False)
        stamps, received = stamps[:filled], received[:filled]
        if (np.diff(received) < 0).any():  # several writers: as they were recorded
            order = np.argsort(received, kind="stable")
            stamps = stamps[order]
            tables = {group: table[order] for group, table in tables.items()}
        return Table(tables, stamps, rows - filled)

    def blocks(
        self, stream: Stream, groups: Mapping[str, Sequence[str]], stamp: str | None
    ) -> Iterator[Table]:
        """As :class:`~robodyn.logs.recording.Recording` says."""
        skipped = stream.rows or 0
        for rows in in_order(self._parts(stream, groups, stamp), RECEIVED, self.file):
            skipped -= len(rows[RECEIVED])
            yield Table({group: rows[group] for group in groups}, rows[_STAMPS])
        nothing = {group: np.empty((0, len(names))) for group, names in groups.items()}
        yield Table(nothing, np.empty(0, np.int64), skipped)

    def _parts(
        self, stream: Stream, groups: Mapping[str, Sequence[str]], stamp: str | None
    ) -> Iterator[Rows]:
        """The messages of ``stream`` that have all columns, as they stand in the file: ``groups`` [k, m],
        when they were received, and their stamps [k] in ns."""
        channel = self._channels[stream.name]
        reader = _Reader(channel, groups, None if stamp == RECEIVED else stamp)
        try:
            for times, messages in self._batches(channel, stream.rows or 0):
                sound, tables, own = reader.rows(messages)
                yield {
                    **{group: table[sound] for group, table in tables.items()},
                    RECEIVED: times[sound],
                    _STAMPS: own[sound] if own is not None else times[sound],
                }
        except (BadStorage, NotCdr) as error:
            raise damaged(self.file, self.format, f"{stream.name}: {error}") from None

    def _batches(self, channel: _Channel, rows: int) -> Iterator[tuple[NDArray[np.int64], list[bytes]]]:
        """Times [ns] and contents of the messages of ``channel``, ``rows`` of them at most."""
        times: list[int] = []
        messages: list[bytes] = []
        for k, keys in channel.keys.items():
            for time, data in self._storages[k].messages(keys):
                times.append(time if time < 1 << 63 else 0)
                messages.append(data)
                rows -= 1
                if rows < 0:
                    raise BadStorage("more messages than there were")
                if len(messages) == BATCH:
                    yield np.array(times, dtype=np.int64), messages
                    times, messages = [], []
        if messages:
            yield np.array(times, dtype=np.int64), messages


class _Reader:
    """Takes messages of a channel apart, as plans of earlier ones say."""

    def __init__(self, channel: _Channel, groups: Mapping[str, Sequence[str]], stamp: str | None) -> None:
        self.channel, self.groups, self.stamp = channel, groups, stamp
        self.wanted = [name for names in groups.values() for name in names]
        self.plans: dict[int, list[Plan]] = {}

    def rows(
        self, messages: list[bytes]
    ) -> tuple[NDArray[np.bool_], dict[str, Floats], NDArray[np.int64] | None]:
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
    typesys = needed("rosbags.typesys")
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
        ends = (".mcap", ".db3")
        names = [path for path in folder.iterdir() if path.suffix.lower() in ends and path.is_file()]
        listed = sorted(
            names, key=lambda path: [int(x) if x.isdigit() else x for x in re.split(r"(\d+)", path.name)]
        )
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
    return paths if all(path.is_file() and path.suffix.lower() in (".mcap", ".db3") for path in paths) else []
