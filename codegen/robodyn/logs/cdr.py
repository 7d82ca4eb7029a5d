"""Where the numbers stand in a message: one walk over its definition, then numpy for all messages like it.

Messages are in CDR (OMG, Common Data Representation; DDSI-RTPS 9.4): values one after the other, each at a
multiple of its size, strings and sequences after their lengths. Messages of a topic mostly have the same
lengths, so that a number has the same place in all of them. A :class:`Plan` is what one message is like: the
lengths and names in it that others must share, and the places of its numbers.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

#: Longest sequence of numbers whose elements are columns, and most columns of a message.
LONGEST, COLUMNS = 256, 8192
#: Levels of messages in each other.
DEPTH: Final = 16

_BASE, _NAME, _ARRAY, _SEQUENCE = 1, 2, 3, 4
_KINDS: Final = {
    "bool": "u1", "byte": "u1", "char": "u1", "octet": "u1", "int8": "i1", "uint8": "u1", "int16": "i2",
    "uint16": "u2", "int32": "i4", "uint32": "u4", "int64": "i8", "uint64": "u8", "float32": "f4",
    "float64": "f8",
}  # fmt: skip
_TIMES: Final = ("builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration")
#: Sequences of words that name the elements of the sequences beside them.
_LABELS: Final = ("name", "names", "joint_names", "interface_names")


class NotCdr(ValueError):
    """A message that is not what its definition says."""


@dataclass(frozen=True)
class Plan:
    """What a message of ``size`` bytes is like: ``words`` (place, bytes) that others share if they are like
    it, ``columns`` (place, kind) by their paths, and ``stamps`` (places of seconds and nanoseconds)."""

    size: int
    order: str
    words: tuple[tuple[int, bytes], ...]
    columns: Mapping[str, tuple[int, str]]
    stamps: Mapping[str, tuple[int, int]]

    @cached_property
    def _shared(self) -> tuple[NDArray[np.intp], NDArray[np.uint8]]:
        places = [np.arange(place, place + len(word)) for place, word in self.words]
        text = np.frombuffer(b"".join(word for _, word in self.words), np.uint8)
        return np.concatenate(places) if places else np.empty(0, np.intp), text

    def fits(self, messages: NDArray[np.uint8]) -> NDArray[np.bool_]:
        """Which of the ``messages`` [B, size] are like this one."""
        places, text = self._shared
        like: NDArray[np.bool_] = (messages[:, places] == text).all(axis=1)
        return like

    def numbers(self, messages: NDArray[np.uint8], path: str) -> NDArray[Any]:
        """The numbers [B] at ``path`` of messages that are like this one."""
        place, kind = self.columns[path]
        dtype = np.dtype(self.order + kind)
        return np.ascontiguousarray(messages[:, place : place + dtype.itemsize]).view(dtype)[:, 0]

    def times(self, messages: NDArray[np.uint8], path: str) -> NDArray[np.int64]:
        """The stamps [B] at ``path`` [ns]."""
        parts = []
        for place, kind in zip(self.stamps[path], ("i4", "u4"), strict=True):
            part = np.ascontiguousarray(messages[:, place : place + 4]).view(self.order + kind)[:, 0]
            parts.append(part.astype(np.int64))
        stamps: NDArray[np.int64] = parts[0] * 1_000_000_000 + parts[1]
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
    return Plan(len(message), walk.order, tuple(walk.words), walk.columns, walk.stamps)


@dataclass
class _Walk:
    """A walk through one message; ``at`` is the place that it has come to."""

    data: bytes
    order: str
    definitions: Mapping[str, Any]
    at: int = 4
    words: list[tuple[int, bytes]] = field(default_factory=list)
    columns: dict[str, tuple[int, str]] = field(default_factory=dict)
    stamps: dict[str, tuple[int, int]] = field(default_factory=dict)

    def message(self, path: str, name: str, depth: int, labels: Sequence[str]) -> None:
        if name not in self.definitions:
            raise NotCdr(f"the type {name!a} is not defined")
        if not depth:
            raise NotCdr("messages nested too deeply")
        start = -(-(self.at - 4) // 4) * 4 + 4
        if name in _TIMES and path:
            self.stamps[path] = (start, start + 4)
        own = labels
        for member, kind in self.definitions[name][1]:
            inner = f"{path}.{member}" if path else member
            words = self.value(inner, kind, depth, own)
            if words is not None and member in _LABELS:
                own = words

    def value(self, path: str, kind: Any, depth: int, labels: Sequence[str]) -> list[str] | None:
        """Walk over a value; of a sequence of words, the words."""
        form, what = int(kind[0]), kind[1]
        if form == _BASE:
            base = what[0] if isinstance(what, tuple) else what
            if base in ("string", "wstring"):
                self.string(base, keep=False)
            else:
                self.column(path, _kind(base))
            return None
        if form == _NAME:
            self.message(path, what, depth - 1, labels)
            return None
        element, limit = what
        if form == _ARRAY:
            count = int(limit)
        elif form == _SEQUENCE:
            count = self.length()
        else:
            raise NotCdr(f"a definition of the unknown form {form}")
        return self.elements(path, element, count, depth, labels)

    def elements(
        self, path: str, element: Any, count: int, depth: int, labels: Sequence[str]
    ) -> list[str] | None:
        names = labels if len(labels) == count and len(set(labels)) == count else None
        base = element[1][0] if isinstance(element[1], tuple) else element[1]
        if int(element[0]) == _BASE and base not in ("string", "wstring"):
            kind = _kind(base)
            size = int(kind[1])
            if count:
                self.align(size)
            if self.at + count * size > len(self.data):
                raise NotCdr(f"{path} claims {count} numbers, beyond the end of the message")
            if count <= LONGEST:
                for k in range(count):
                    self.column(f"{path}.{names[k] if names else k}", kind)
            else:
                self.at += count * size
            return None
        if count > len(self.data):  # each takes a byte at least
            raise NotCdr(f"{path} claims {count} elements, beyond the end of the message")
        if int(element[0]) == _BASE:
            return [self.string(base, keep=True) for _ in range(count)]
        for k in range(count):
            self.value(f"{path}.{names[k] if names else k}", element, depth - 1, labels)
        return None

    def column(self, path: str, kind: str) -> None:
        size = int(kind[1])
        self.align(size)
        if self.at + size > len(self.data):
            raise NotCdr(f"the message ends before {path}")
        if len(self.columns) < COLUMNS:
            self.columns[path] = (self.at, kind)
        self.at += size

    def string(self, base: str, *, keep: bool) -> str:
        count = self.length() * (2 if base == "wstring" else 1)
        text = self.data[self.at : self.at + count]
        if len(text) < count:
            raise NotCdr("the message ends in a word")
        if keep:
            self.words.append((self.at, text))
        self.at += count
        return text.rstrip(b"\0").decode("utf-8", "replace")

    def length(self) -> int:
        self.align(4)
        word = self.data[self.at : self.at + 4]
        if len(word) < 4:
            raise NotCdr("the message ends before a length")
        self.words.append((self.at, word))
        self.at += 4
        return int.from_bytes(word, "little" if self.order == "<" else "big")

    def align(self, size: int) -> None:
        self.at += -(self.at - 4) % size


def _kind(base: str) -> str:
    if base not in _KINDS:
        raise NotCdr(f"numbers of the unknown type {base!a}")
    return _KINDS[base]
