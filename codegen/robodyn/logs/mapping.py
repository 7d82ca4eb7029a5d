"""Maps: which column of a file is what, in which unit. As a YAML file, or as one line of text."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping
from collections.abc import Sequence as Words
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Final, NoReturn

from robodyn.errors import InputError, Place
from robodyn.files import label, read_text
from robodyn.robot import document
from robodyn.robot.document import Node, Scalar, Sequence, describe
from robodyn.robot.names import shown
from robodyn.robot.numbers import NumberError, parse_number

#: Largest map [bytes], and most joints that a list in it is for.
SIZE: Final = 1 << 20
JOINTS: Final = 999

GROUPS: Final = ("t", "q", "qd", "qdd", "tau", "ql")
#: Keys with a number, or one for each joint, and what each is.
NUMBERS: Final = {
    "sign": "1 or -1",
    "zero": "the reading, in the column's unit, that means 0",
    "offset": "what is added in the end, in SI units at the joint",
    "factor": "SI units, at the motor's or the joint's side, to a raw unit",
    "gear": "turns of the motor to a turn of the joint (rad/m of a prismatic one)",
    "torque_constant": "N m/A at the motor",
    "rated": "N m or N that the shares are of, at the motor's side if there is a gear",
    "counts_per_turn": "ticks to a turn",
    "bits": "bits of whole numbers that have a sign, and were recorded without it",
}
#: What numbers must be, and what is said of others.
_CHECKS: Final[dict[str, tuple[Callable[[Fraction], bool], str, str | None]]] = {
    "sign": (lambda x: abs(x) == 1, "a sign is 1 or -1", None),
    "bits": (lambda x: x.denominator == 1 and 2 <= x <= 64, "this is no number of bits", "8, 16 or 32"),
    "rate": (lambda x: x > 0, "the rate is not positive", "samples a second [Hz]"),
}
#: These may also be the word robot: as the description has it.
OF_ROBOT: Final = ("gear", "torque_constant")
_KEYS: Final = ("column", "columns", "unit", "joints", "file", "rate", *NUMBERS)
_TOP: Final = (*GROUPS, "joints", "topic", "conditions")
_UNIT = re.compile(r"(?P<name>.*?)\s*\[(?P<unit>[^\[\]]*)\]\Z", re.DOTALL)
_INDEX = re.compile(r"\s*(%d|%s|[0-9]+|:)\s*\Z")


@dataclass(frozen=True, slots=True)
class Channel:
    """A group of columns: how they are called, and how their numbers become SI units at the joint.

    ``columns``: one pattern, with %d for the number of a joint or %s for its name, or a name a joint, ""
    where a joint has none. ``numbers``: values of :data:`NUMBERS`, one or one a joint; ``of_robot``: which of
    them are the description's. ``joints`` (from 1): of which joints the columns are, where not of all.
    ``file``: a second file, where %s is the log's path without its ending. ``rate`` [Hz]: of t, where there
    is no column of times.
    """

    columns: tuple[str, ...]
    place: Place
    unit: str = ""
    numbers: Mapping[str, tuple[Fraction, ...]] = field(default_factory=dict)
    of_robot: frozenset[str] = frozenset()
    joints: tuple[int, ...] = ()
    file: str = ""
    rate: Fraction | None = None

    def number(self, key: str, joint: int) -> Fraction | None:
        """The value at ``key`` of the ``joint`` (from 0); None where there is none."""
        values = self.numbers.get(key)
        if values is None:
            return None
        return values[0] if len(values) == 1 else values[joint]


@dataclass(frozen=True, slots=True)
class LogMap:
    """What the columns of a log are: ``groups`` of channels, the ``joints``' names base to tip, the ``topic``
    that columns without one are of, and ``conditions`` of which the log's mean counts, by their names."""

    groups: Mapping[str, Channel]
    joints: tuple[str, ...] = ()
    topic: str = ""
    conditions: Mapping[str, Channel] = field(default_factory=dict)

    @property
    def is_usual(self) -> bool:
        """Whether it says nothing of the arm's columns: they have the usual names."""
        return not (self.groups or self.joints or self.topic)


def read_map(path: str | os.PathLike[str]) -> LogMap:
    """The map in the YAML file ``path``.

    Raises
    ------
    InputError: there is none, or it is not a map; with file, line and column.
    """
    name = label(path)
    return map_of_text(read_text(path, SIZE, "a map, such as map.yaml", name), name)


def map_of_text(text: str, file: str = "<text>") -> LogMap:
    """The map that the YAML ``text`` of ``file`` says.

    Raises
    ------
    InputError: as :func:`read_map`.
    """
    if not text.strip():
        raise InputError("the map is empty", where=Place(file), expected="q: joint_%d_pos[deg]")
    return _Reader(file).map(document.compose(text, file))


def map_of_columns(text: str, file: str = "--columns") -> LogMap:
    """The map that one line says: ``t=time[ms],q=joint_%d_pos[deg],tau=-current_%d[A]``.

    Raises
    ------
    InputError: it does not; with the column.
    """
    groups: dict[str, Channel] = {}
    position = 0
    for part in _split(text):
        where = Place(file, 1, position + len(part) - len(part.lstrip()) + 1)
        position += len(part) + 1
        group, sign, columns = part.partition("=")
        group = group.strip()
        if not sign or not columns.strip():
            expected = "q=NAME[UNIT], with %d for the number of the joint"
            what = "a group of columns has no name"
            raise InputError(what, where=where, found=shown(part.strip()), expected=expected)
        if group not in GROUPS:
            what = "there is no such group of columns"
            raise InputError(what, where=where, found=shown(group), expected=_listed(GROUPS))
        if group in groups:
            raise InputError("the group stands here a second time", where=where, found=group)
        groups[group] = _channel(columns.strip(), where)
    return LogMap(groups)


def _split(text: str) -> Iterator[str]:
    """The parts of ``text`` between commas outside of brackets."""
    depth, start = 0, 0
    for k, mark in enumerate(text):
        depth += (mark == "[") - (mark == "]")
        if mark == "," and depth <= 0:
            yield text[start:k]
            start = k + 1
    yield text[start:]


def _channel(text: str, where: Place) -> Channel:
    """``-NAME[UNIT]``: the minus and the unit may be left out."""
    numbers: dict[str, tuple[Fraction, ...]] = {}
    if text.startswith("-"):
        numbers["sign"] = (Fraction(-1),)
        text = text[1:].lstrip()
    match = _UNIT.match(text)
    if match is None or _INDEX.match(match["unit"]):
        return Channel((text,), where, numbers=numbers)
    return Channel((match["name"],), where, match["unit"].strip(), numbers)


def _listed(words: tuple[str, ...]) -> str:
    return ", ".join(words[:-1]) + " or " + words[-1]


class _Reader:
    """Reads the nodes of a map; every complaint has its place in the ``file``."""

    def __init__(self, file: str) -> None:
        self.file = file

    def place(self, node: Node, offset: int = 0) -> Place:
        return Place(self.file, node.line, node.column + offset)

    def fail(self, node: Node, what: str, **more: str | None) -> NoReturn:
        raise InputError(what, where=self.place(node), **more)

    def entries(self, node: Node, what: str, example: str) -> Iterator[tuple[Scalar, Node]]:
        if not isinstance(node, document.Mapping):
            self.fail(node, f"{what} must be a mapping", found=describe(node), expected=example)
        yield from node.entries

    def known(self, node: Node, keys: tuple[str, ...], what: str) -> Iterator[tuple[str, Node]]:
        for key, value in self.entries(node, what, "NAME: VALUE"):
            if key.text not in keys:
                self.fail(key, f"{what} has no such key", found=shown(key.text), expected=_listed(keys))
            yield key.text, value

    def map(self, node: Node) -> LogMap:
        groups: dict[str, Channel] = {}
        more: dict[str, Any] = {}
        for key, value in self.known(node, _TOP, "the map"):
            if key == "joints":
                more[key] = self.words(value)
                self.refuse_twice(value, more[key])
            elif key == "topic":
                more[key] = self.word(value)
            elif key == "conditions":
                more[key] = self.conditions(value)
            else:
                groups[key] = self.group(value, key)
        if not groups and not any(more.values()):
            self.fail(node, "the map says nothing", expected="q: joint_%d_pos[deg]")
        return LogMap(groups, **more)

    def conditions(self, node: Node) -> dict[str, Channel]:
        """Columns of conditions by name: a pattern, a list, or one of these with a unit."""
        conditions = {}
        for key, value in self.entries(node, "conditions", "NAME: COLUMN"):
            channel = self.group(value, f"the condition {key.text}")
            if channel.numbers or channel.of_robot or channel.joints or channel.file:
                self.fail(value, "a condition has columns and a unit only", expected="motor_temp_%d[degC]")
            conditions[key.text] = channel
        return conditions

    def group(self, node: Node, group: str) -> Channel:
        where = self.place(node)
        if isinstance(node, Scalar):
            return _channel(self.word(node), where)
        if isinstance(node, Sequence):
            return Channel(self.names(node, group), where)
        more: dict[str, Any] = {}
        numbers: dict[str, tuple[Fraction, ...]] = {}
        of_robot: set[str] = set()
        for key, value in self.known(node, _KEYS, group):
            if key in ("column", "columns"):
                if "columns" in more:
                    self.fail(value, f"{group} has both column and columns", remedy="delete one of them")
                more["columns"] = self.names(value, group)
            elif key in ("unit", "file"):
                more[key] = self.word(value)
            elif key == "joints":
                more[key] = self.joints(value)
            elif key == "rate":
                if group != "t":
                    self.fail(value, "only t has a rate", found=group)
                more[key] = self.numbers(value, key)[0]
            elif key in OF_ROBOT and isinstance(value, Scalar) and value.text == "robot":
                of_robot.add(key)
            else:
                numbers[key] = self.numbers(value, key)
        more = {"columns": (), **more}
        channel = Channel(place=where, numbers=numbers, of_robot=frozenset(of_robot), **more)
        if bool(channel.columns) == (channel.rate is not None):
            one = "column: NAME, or rate: HZ" if group == "t" else "columns: NAME_%d"
            self.fail(node, f"{group} needs a column" + (" or a rate" if group == "t" else ""), expected=one)
        sound = {
            "t": ("sign", "zero", "offset", "factor"),
            "tau": ("sign", "zero", "offset", "factor", "bits", "gear", "torque_constant", "rated"),
        }.get(group, ("sign", "zero", "offset", "factor", "bits", "gear", "counts_per_turn"))
        for key in (*numbers, *of_robot):
            if key not in sound:
                found = f"{key}: {NUMBERS[key]}"
                self.fail(node, f"{group} has no {key}", found=found, expected=_listed(sound))
        if channel.joints and len(channel.columns) > 1 and len(channel.columns) != len(channel.joints):
            counts = f"{len(channel.columns)} columns and {len(channel.joints)} joints"
            self.fail(node, f"{group} has another number of columns than of joints", found=counts)
        return channel

    def refuse_twice(self, node: Node, joints: Words[object]) -> None:
        if len(set(joints)) < len(joints):
            self.fail(node, "a joint stands here twice", found=", ".join(map(str, joints[:9])))

    def word(self, node: Node) -> str:
        if not isinstance(node, Scalar) or not node.text.strip():
            self.fail(node, "there is no name here", found=describe(node), expected="a name")
        return node.text

    def items(self, node: Node, what: str, expected: str) -> tuple[Node, ...]:
        if not isinstance(node, Sequence) or not 1 <= len(node.items) <= JOINTS:
            self.fail(node, what, found=describe(node), expected=expected)
        return node.items

    def words(self, node: Node) -> tuple[str, ...]:
        return tuple(map(self.word, self.items(node, "this is no list of names", "[name, name, ...]")))

    def names(self, node: Node, group: str) -> tuple[str, ...]:
        """Names of columns: a pattern, or a list, in which null is a joint without one."""
        if isinstance(node, Scalar):
            return (self.word(node),)
        names = []
        for item in self.items(node, "these are no columns", "a name, or a list of them"):
            is_null = isinstance(item, Scalar) and item.plain and item.text in ("", "~", "null")
            if is_null and group != "ql":
                self.fail(item, f"every joint has a column of {group}", found="null", expected="a name")
            names.append("" if is_null else self.word(item))
        return tuple(names)

    def joints(self, node: Node) -> tuple[int, ...]:
        joints = []
        for item in self.items(node, "this is no list of names", "[name, name, ...]"):
            text = self.word(item)
            if not text.isascii() or not text.isdigit() or not 1 <= int(text[:4]) <= JOINTS:
                self.fail(item, "this is not the number of a joint", found=shown(text), expected="1, 2, ...")
            joints.append(int(text))
        self.refuse_twice(node, joints)
        return tuple(joints)

    def numbers(self, node: Node, key: str) -> tuple[Fraction, ...]:
        if not isinstance(node, Sequence):
            return (self.one(node, key),)
        items = self.items(node, f"{key} has no number", "a number, or one a joint")
        return tuple(self.one(item, key) for item in items)

    def one(self, node: Node, key: str) -> Fraction:
        if not isinstance(node, Scalar):
            self.fail(node, f"{key} is not a number", found=describe(node), expected=NUMBERS.get(key, "Hz"))
        try:
            value = parse_number(node.text)
        except NumberError as error:
            offset = error.position if node.verbatim else 0
            raise InputError(
                f"{key}: {error.what}",
                where=self.place(node, offset + (not node.plain)),
                found=error.found,
                expected=error.expected,
                remedy=error.remedy,
            ) from None
        if key in _CHECKS and not _CHECKS[key][0](value):
            self.fail(node, _CHECKS[key][1], found=node.text, expected=_CHECKS[key][2])
        if key in ("factor", "gear", "torque_constant", "rated", "counts_per_turn") and value == 0:
            self.fail(node, f"{key} is 0", expected=NUMBERS[key])
        return value
