"""Where the numbers stand in a message: one walk over its definition, then numpy for all messages like it.

Messages are in CDR (OMG, Common Data Representation; DDSI-RTPS 9.4): values one after the other, each at a
multiple of its size, strings and sequences after their lengths. Messages of a topic mostly have the same
lengths, so that a number has the same place in all of them. A :class:`Plan` is what one message is like: the
lengths and names in it that others must share, and the places of its numbers.

rosbags reads CDR by running code that it writes out of the definitions in a file; here they stay data.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

#: Longest sequence of numbers whose elements are columns, and most columns of a message.
LONGEST, COLUMNS = 256, 8192
#: Levels of messages in each other, and plans that are remembered for one size of message.
DEPTH, PLANS = 16, 32

_BASE, _NAME, _ARRAY = 1, 2, 3  # and 4 of sequences, as rosbags counts them
_KINDS: Final = {
    "bool": "u1", "byte": "u1", "char": "u1", "octet": "u1", "int8": "i1", "uint8": "u1", "int16": "i2",
    "uint16": "u2", "int32": "i4", "uint32": "u4", "int64": "i8", "uint64": "u8", "float32": "f4",
    "float64": "f8",
}  # fmt: skip
_WORDS: Final = ("string", "wstring")
_TIMES: Final = ("builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration")
#: Sequences of words that name the elements of the sequences beside them.
_LABELS: Final = ("name", "names", "joint_names", "interface_names")


class NotCdr(ValueError):
    """A message that is not what its definition says."""


@dataclass(frozen=True, slots=True)
class Plan:
    """What a message is like: ``places`` of the bytes ``shared`` by all that are like it, ``columns`` (place,
    kind) by their paths, and ``stamps`` (place of the seconds, before the nanoseconds)."""

    order: str
    places: NDArray[np.intp]
    shared: NDArray[np.uint8]
    columns: Mapping[str, tuple[int, str]]
    stamps: Mapping[str, int]

    def numbers(self, messages: NDArray[np.uint8], place: int, kind: str) -> NDArray[Any]:
        """The numbers [B] of a ``kind`` at a ``place`` of messages [B, size] that are like this one."""
        dtype = np.dtype(self.order + kind)
        return np.ascontiguousarray(messages[:, place : place + dtype.itemsize]).view(dtype)[:, 0]

    def times(self, messages: NDArray[np.uint8], path: str) -> NDArray[np.int64]:
        """The stamps [B] at ``path`` [ns]."""
        place = self.stamps[path]
        parts = self.numbers(messages, place, "i4"), self.numbers(messages, place + 4, "u4")
        stamps: NDArray[np.int64] = parts[0].astype(np.int64) * 1_000_000_000 + parts[1]
        return stamps


def plan_of(message: bytes, name: str, definitions: Mapping[str, Any]) -> Plan:
    """What ``message`` of the type ``name`` is like.

    Raises
    ------
    NotCdr: it is not of that type, or that is unknown.
    """
    if len(message) < 4 or message[0] != 0 or message[1] > 1:
        raise NotCdr("no header of CDR at its start")
    walk = _Walk(message, "<" if message[1] else ">", definitions)
    walk.message("", name, DEPTH, ())
    places = [np.arange(start, end) for start, end in walk.shared]
    where = np.concatenate(places) if places else np.empty(0, np.intp)
    return Plan(walk.order, where, np.frombuffer(message, np.uint8)[where], walk.columns, walk.stamps)


class MessageReader:
    """Takes messages of the type ``name`` apart, as plans of earlier ones say: ``groups`` of columns, and a
    ``stamp``."""

    def __init__(
        self,
        name: str,
        definitions: Mapping[str, Any],
        groups: Mapping[str, Sequence[str]],
        stamp: str | None,
    ) -> None:
        self._name, self._definitions, self._groups, self._stamp = name, definitions, groups, stamp
        self._plans: dict[int, list[Plan]] = {}

    def rows(
        self, messages: list[bytes]
    ) -> tuple[NDArray[np.bool_], dict[str, NDArray[np.float64]], NDArray[np.int64]]:
        """Which messages have all columns; their numbers [B, m] by group, and their stamps [B]."""
        count = len(messages)
        is_sound, stamps = np.zeros(count, dtype=bool), np.zeros(count, dtype=np.int64)
        tables = {group: np.empty((count, len(names))) for group, names in self._groups.items()}
        sizes = np.fromiter(map(len, messages), np.int64, count)
        for size in np.unique(sizes).tolist():
            left = np.flatnonzero(sizes == size)
            table = np.frombuffer(b"".join([messages[k] for k in left.tolist()]), np.uint8)
            table = table.reshape(len(left), size)
            plans = self._plans.setdefault(size, [])
            tried = 0
            while len(left):
                if tried == len(plans):
                    plans.insert(0, plan_of(messages[int(left[0])], self._name, self._definitions))
                    del plans[PLANS:]
                    plan, tried = plans[0], len(plans)
                else:
                    plan, tried = plans[tried], tried + 1
                is_like = (table[:, plan.places] == plan.shared).all(axis=1)
                rows, part = left[is_like], table[is_like]
                if len(rows) and self._has_all(plan):
                    is_sound[rows] = True
                    for group, names in self._groups.items():
                        for k, name in enumerate(names):
                            tables[group][rows, k] = plan.numbers(part, *plan.columns[name])
                    if self._stamp is not None:
                        stamps[rows] = plan.times(part, self._stamp)
                left, table = left[~is_like], table[~is_like]
        return is_sound, tables, stamps

    def _has_all(self, plan: Plan) -> bool:
        is_stamped = self._stamp is None or self._stamp in plan.stamps
        return is_stamped and all(name in plan.columns for names in self._groups.values() for name in names)


@dataclass
class _Walk:
    """A walk through one message; ``at`` is the place that it has come to, ``shared`` are the bytes (start,
    end) of lengths and names."""

    data: bytes
    order: str
    definitions: Mapping[str, Any]
    at: int = 4
    shared: list[tuple[int, int]] = field(default_factory=list)
    columns: dict[str, tuple[int, str]] = field(default_factory=dict)
    stamps: dict[str, int] = field(default_factory=dict)

    def message(self, path: str, name: str, depth: int, labels: Sequence[str]) -> None:
        if name not in self.definitions:
            raise NotCdr(f"the type {name!a} is not defined")
        if not depth:
            raise NotCdr("messages nested too deeply")
        if name in _TIMES and path:
            self.stamps[path] = self.at - (self.at % -4)
        for member, kind in self.definitions[name][1]:
            words = self.value(f"{path}.{member}" if path else member, kind, depth, labels)
            if words is not None and member in _LABELS:
                labels = words

    def value(self, path: str, kind: Any, depth: int, labels: Sequence[str]) -> list[str] | None:
        """Walk over a value; of a sequence of words, the words."""
        form, what = int(kind[0]), kind[1]
        if form == _NAME:
            self.message(path, what, depth - 1, labels)
        elif form == _BASE:
            base = what[0] if isinstance(what, tuple) else what
            if base in _WORDS:
                self.word(base)
            elif base not in _KINDS:
                raise NotCdr(f"numbers of the unknown type {base!a}")
            else:
                place = self.take(int(_KINDS[base][1]), int(_KINDS[base][1]))
                if len(self.columns) < COLUMNS:
                    self.columns[path] = (place, _KINDS[base])
        else:
            element, limit = what
            return self.elements(path, element, limit if form == _ARRAY else self.length(), depth, labels)
        return None

    def elements(
        self, path: str, element: Any, count: int, depth: int, labels: Sequence[str]
    ) -> list[str] | None:
        if count > len(self.data):  # each takes a byte at least
            raise NotCdr(f"{path} claims {count} elements, beyond the end of the message")
        base = None
        if int(element[0]) == _BASE:
            base = element[1][0] if isinstance(element[1], tuple) else element[1]
        if base in _WORDS:
            words = [self.word(base) for _ in range(count)]
            self.shared += [each for each, _ in words]
            return [text for _, text in words]
        if base in _KINDS and count > LONGEST:
            size = int(_KINDS[base][1])
            self.take(count * size, size)
            return None
        names = labels if len(labels) == count == len(set(labels)) else range(count)
        for name in names:
            self.value(f"{path}.{name}", element, depth - 1 if base is None else depth, labels)
        return None

    def word(self, base: str) -> tuple[tuple[int, int], str]:
        """Where a word stands, and what it is."""
        count = self.length() * (2 if base == "wstring" else 1)
        place = self.take(count, 1)
        text = self.data[place : place + count].rstrip(b"\0").decode("utf-8", "replace")
        return (place, place + count), text

    def length(self) -> int:
        place = self.take(4, 4)
        self.shared.append((place, place + 4))
        return int.from_bytes(self.data[place : place + 4], "little" if self.order == "<" else "big")

    def take(self, size: int, multiple: int) -> int:
        """The place of the next ``size`` bytes, which begin at a ``multiple`` behind the head."""
        place = self.at + -(self.at - 4) % multiple
        self.at = place + size
        if self.at > len(self.data):
            raise NotCdr("the message ends before its last value")
        return place
