"""Typed values out of the nodes of a description, each checked, each error with its place."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import NoReturn, cast

from robodyn.errors import InputError, Place
from robodyn.robot import numbers
from robodyn.robot.account import Origin
from robodyn.robot.document import Mapping, Node, Scalar, Sequence, describe
from robodyn.robot.keys import SIGNS, Key, allowed, expectation
from robodyn.robot.names import shown, text_fault, unprintable_fault
from robodyn.robot.parts import UNKNOWN, Confidence, Vector
from robodyn.robot.rotations import ONE_TURN
from robodyn.robot.values import ZERO, Angle, Value, angle

# Plain words by which YAML means that nothing stands there.
_NOTHING = ("", "~", "null", "Null", "NULL")


class Source:
    """The file that is read, and what holds for all of it: run-time names, and the way of doubts."""

    def __init__(self, file: str, strict: bool, warn: Callable[[str], object]) -> None:
        self.file = file
        self.strict = strict
        self.warn = warn
        self.names: dict[str, tuple[str, Place]] = {}
        self.effects = 0

    def place(self, node: Node, offset: int = 0) -> Place:
        """The place of ``node``, or of a character of a scalar where the text stands there one by one."""
        if isinstance(node, Scalar) and node.verbatim and offset:
            return Place(self.file, node.line, node.column + offset + (not node.plain))
        return Place(self.file, node.line, node.column)

    def fail(self, node: Node, what: str, **more: str | None) -> NoReturn:
        """Raise an InputError at ``node``; ``more``: what was found and expected, and the remedy."""
        raise InputError(what, where=self.place(node), **more)

    def doubt(self, node: Node, what: str, remedy: str) -> None:
        """A number that physics hardly allows: a warning, with ``strict`` an InputError."""
        error = InputError(what, where=self.place(node), remedy=remedy)
        if self.strict:
            raise error
        self.warn(str(error))

    def note(self, node: Node, what: str, remedy: str) -> None:
        """Something that is right but hardly meant: a warning, also with ``strict``."""
        self.warn(str(InputError(what, where=self.place(node), remedy=remedy)))

    def name(self, name: str, place: Place) -> None:
        """Note a run-time parameter; two names that Fortran cannot tell apart are refused."""
        first, before = self.names.setdefault(name.lower(), (name, place))
        if first != name:
            what = "two run-time parameters differ only by case, which Fortran does not see"
            found = f"{shown(name)} after {shown(first)} in line {before.line}"
            remedy = "write both alike, or choose another name"
            raise InputError(what, where=place, found=found, remedy=remedy)


class Section:
    """One mapping of the file, read with its table of keys.

    ``label`` says for messages whose it is: "link 3"; "" for the whole description.
    """

    def __init__(self, source: Source, label: str, node: Node, table: tuple[Key, ...]) -> None:
        self.source = source
        self.label = label
        self.node = node
        self.keys = {key.name: key for key in table}
        self.doubt_count = 0
        self.values: dict[str, Node] = {}
        example = ", ".join(f"{key.name}: ..." for key in table[:3])
        whole = label or "the description"
        if isinstance(node, Scalar) and node.plain and node.text in _NOTHING:
            source.fail(
                node, f"{whole} has no value", expected=f"{{{example}}}", remedy="fill it in or leave it out"
            )
        if not isinstance(node, Mapping):
            source.fail(node, f"{whole} must be a mapping", found=describe(node), expected=f"{{{example}}}")
        for key, value in node.entries:
            if key.text not in self.keys:
                self._unknown(key)
            self.values[key.text] = value
        for name, known in self.keys.items():
            if known.required and name not in self.values:
                self.source.fail(
                    node, self.path(f"the key '{name}' is missing"), expected=f"{name}: {expectation(known)}"
                )

    def _unknown(self, key: Scalar) -> NoReturn:
        known = list(self.keys)
        word = key.text.lower()
        if key.text == "<<":
            remedy = "merge keys are not supported: write the keys out"
        else:
            near = [name for name, one in self.keys.items() if word in (name, *one.others)]
            near = near or [name for name in [_folded(word)] if name in self.keys]
            near = near or difflib.get_close_matches(word, known, 1)
            remedy = f"did you mean '{near[0]}'?" if near else "delete it, or put it where it belongs"
        expected, found = f"one of {', '.join(known)}", shown(key.text)
        self.source.fail(key, self.path("unknown key"), found=found, expected=expected, remedy=remedy)

    def doubt(self, node: Node, what: str, remedy: str) -> None:
        """As :meth:`Source.doubt`; no warning where the section acknowledges its doubts."""
        self.doubt_count += 1
        if self.source.strict or "acknowledged" not in self.values:
            self.source.doubt(node, what, remedy)

    def path(self, name: str) -> str:
        """``link 3: mass``, for messages."""
        return f"{self.label}: {name}" if self.label else name

    def scalar(self, name: str) -> Scalar | None:
        """The scalar at ``name``; None where the key is left out."""
        node = self.values.get(name)
        return None if node is None else self._word(node, self.keys[name], self.path(name))

    def _word(self, node: Node, key: Key, path: str) -> Scalar:
        expected = expectation(key)
        if not isinstance(node, Scalar):
            self.source.fail(node, f"{path} must be a single value", found=describe(node), expected=expected)
        if node.plain and node.text in _NOTHING:
            self.source.fail(
                node, f"{path} has no value", expected=expected, remedy="fill it in or leave the key out"
            )
        return node

    def text(self, name: str) -> str:
        """Free text on one line; "" where the key is left out. Line breaks become spaces."""
        node = self.scalar(name)
        return "" if node is None else self._line(node, self.path(name), text_fault)

    def full_text(self, name: str) -> str:
        """As :meth:`text`, where it is stated it is not empty."""
        text = self.text(name)
        if not text and name in self.values:
            what = f"{self.path(name)} is empty"
            self.source.fail(self.values[name], what, expected="text, or no such key")
        return text

    def texts(self, name: str) -> tuple[str, ...]:
        """Lines of text, as long as they may be; none where the key is left out."""
        nodes = self.items(name) or ()
        paths = (f"{self.path(name)} {i}" for i in range(1, len(nodes) + 1))
        return tuple(
            self._line(self._word(node, self.keys[name], path), path, unprintable_fault)
            for node, path in zip(nodes, paths, strict=True)
        )

    def _line(self, node: Scalar, path: str, fault_of: Callable[[str], str | None]) -> str:
        text = " ".join(line.strip() for line in node.text.splitlines()).strip()
        fault = fault_of(text)
        if fault:
            self.source.fail(node, f"{path} {fault}", found=shown(text), remedy="shorten it or clean it up")
        return text

    def choice(self, name: str) -> str | None:
        """One of the key's choices; None where it is left out."""
        node = self.scalar(name)
        if node is None:
            return None
        if node.text not in self.keys[name].choices:
            near = difflib.get_close_matches(node.text.lower(), self.keys[name].choices, 1)
            what, expected = f"{self.path(name)} is unknown", " or ".join(self.keys[name].choices)
            remedy = f"did you mean '{near[0]}'?" if near else None
            self.source.fail(node, what, found=describe(node), expected=expected, remedy=remedy)
        return node.text

    def section(self, name: str) -> Section | None:
        """The mapping at ``name``; None where the key is left out."""
        node = self.values.get(name)
        if node is None:
            return None
        return Section(self.source, self.path(name), node, self.keys[name].members)

    def items(self, name: str, count: int | None = None) -> tuple[Node, ...] | None:
        """The entries of the list at ``name``, ``count`` of them; None where the key is left out."""
        node = self.values.get(name)
        if node is None:
            return None
        count_fits = isinstance(node, Sequence) and count in (None, len(node.items))
        if not isinstance(node, Sequence) or not count_fits:
            what = f"have {count} entries" if isinstance(node, Sequence) else "be a list"
            expected = expectation(self.keys[name])
            self.source.fail(node, f"{self.path(name)} must {what}", found=describe(node), expected=expected)
        return node.items

    def number(self, name: str) -> Value:
        """A number that may be a run-time parameter; 0 where the key is left out."""
        node = self.values.get(name)
        return ZERO if node is None else self._number(node, self.keys[name], self.path(name))

    def constant(self, name: str) -> Fraction | None:
        """A number known now; None where the key is left out."""
        value = self.number(name) if name in self.values else None
        assert value is None or isinstance(value, Fraction)
        return value

    def confidence(self, name: str) -> Confidence:
        """A share, or the word ``unknown``; None where the key is left out."""
        node = self.values.get(name)
        if isinstance(node, Scalar) and node.text == UNKNOWN:
            return UNKNOWN
        return self.constant(name)

    def origins(self, name: str) -> dict[str, Origin]:
        """The origin of each group of numbers that the key states, a word for all or a mapping."""
        key, node = self.keys[name], self.values.get(name)
        if isinstance(node, Mapping):
            section = Section(self.source, self.path(name), node, key.members)
            words = {group: section.choice(group) for group in section.values}
        else:
            words = dict.fromkeys((member.name for member in key.members), self.choice(name))
        return {group: cast(Origin, word) for group, word in words.items() if word}

    def vector(self, name: str) -> Vector | None:
        """Three numbers; None where the key is left out."""
        if name not in self.values:
            return None
        x, y, z = (self._number(*entry) for entry in self._entries(name, "xyz"))
        return x, y, z

    def range(self, name: str) -> tuple[Fraction, Fraction] | None:
        """Lowest and highest; None where the key is left out."""
        items = self.items(name, 2)
        if items is None:
            return None
        low, high = (self._constant(node, self.keys[name], self.path(name)) for node in items)
        if low >= high:
            found = f"[{numbers.brief(low)}, {numbers.brief(high)}]"
            order = "[lowest, highest] with lowest < highest"
            self.source.fail(self.values[name], f"{self.path(name)} is empty", found=found, expected=order)
        return low, high

    def angle(self, name: str) -> Angle:
        """A constant angle [rad]; 0 where the key is left out. More than one turn is doubted."""
        node = self.values.get(name)
        return angle(ZERO) if node is None else self._angle(node, self.keys[name], self.path(name))

    def angles(self, name: str) -> tuple[Angle, Angle, Angle]:
        """Three constant angles [rad]; 0 where the key is left out."""
        if name not in self.values:
            return angle(ZERO), angle(ZERO), angle(ZERO)
        roll, pitch, yaw = (self._angle(*entry) for entry in self._entries(name, ("roll", "pitch", "yaw")))
        return roll, pitch, yaw

    def _entries(self, name: str, words: Iterable[str]) -> list[tuple[Node, Key, str]]:
        """The three entries at ``name`` with the key and a path for messages; ``words`` call them."""
        items = zip(self.items(name, 3) or (), words, strict=True)
        return [(node, self.keys[name], f"{self.path(name)} {word}") for node, word in items]

    def _angle(self, node: Node, key: Key, path: str) -> Angle:
        value = self._parse(node, key, path).value
        assert isinstance(value, Fraction)
        text = numbers.brief(value)
        if abs(value) > 1_000_000:
            example = "an angle in rad, such as -pi/2"
            self.source.fail(node, f"{path} is no angle", found=f"{text} rad", expected=example)
        if abs(value) > ONE_TURN:
            remedy = f"angles are in rad: write {text}*pi/180 if degrees are meant"
            self.doubt(node, f"{path} = {text} rad is more than one turn", remedy)
        return angle(value)

    def _parse(self, node: Node, key: Key, path: str) -> numbers.Number:
        scalar = self._word(node, key, path)
        try:
            value = numbers.parse(scalar.text, names=key.names)
        except numbers.NumberError as error:
            raise InputError(
                f"{path}: {error.what}",
                where=self.source.place(scalar, error.position),
                found=error.found,
                expected=expectation(key) if key.choices else error.expected,
                remedy=error.remedy,
            ) from None
        for name, position in value.names:
            self.source.name(name, self.source.place(scalar, position))
        return value

    def _constant(self, node: Node, key: Key, path: str) -> Fraction:
        value = self._number(node, key, path)
        assert isinstance(value, Fraction)  # no names there
        return value

    def _number(self, node: Node, key: Key, path: str) -> Value:
        read = self._parse(node, key, path)
        # pi is irrational: elsewhere than in an angle the double is what counts.
        value = numbers.rounded(read.value) if read.has_pi else read.value
        if isinstance(value, Fraction) and not allowed(value, key.sign):
            what, expected = SIGNS[key.sign]
            expected += "".join(f", or {word}" for word in key.choices)
            unit = f" {key.unit.partition(',')[0]}" if key.unit else ""
            self.source.fail(
                node, f"{path} {what}", found=numbers.brief(value) + unit, expected=expected.format(unit=unit)
            )
        return value


def _folded(word: str) -> str | None:
    """The key that takes the effect ``word``, if there is such an effect."""
    from robodyn.effects.catalogue import CATALOGUE  # a file that is right does without it

    fold = CATALOGUE[word].traits.fold if word in CATALOGUE else None
    return fold.key if fold is not None else None
