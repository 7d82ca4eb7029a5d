"""YAML text to a tree of nodes that know their line and column; nothing is interpreted yet.

The tree is built from the parser's events, by a loop and not by recursion, so that a hostile file can
neither exhaust the stack nor grow: depth, number of nodes and size after aliases are bounded. A scalar
keeps its raw text: YAML 1.1 would read ``yes`` as true, ``1:30`` as 90, ``010`` as 8 and ``1e-3`` as text.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from robodyn.errors import InputError, Place
from robodyn.files import decoded
from robodyn.robot.names import shown

#: Largest file that is read [bytes].
FILE_SIZE = 1 << 20
#: Deepest nesting of lists and mappings; the format itself needs 7.
DEPTH = 32
#: Largest number of nodes, aliases expanded; 100 links with everything stated need about 6000.
NODES = 100_000

# What YAML does not allow in a file: control characters (and NUL), lone surrogates, non-characters.
_FORBIDDEN = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x84\x86-\x9f\ud800-\udfff\ufffe\uffff]")


@dataclass(frozen=True, slots=True)
class Scalar:
    """A word, number or text as written; ``verbatim``: its characters stand in the file one by one."""

    text: str
    line: int
    column: int
    plain: bool
    verbatim: bool
    size: int = 1


@dataclass(frozen=True, slots=True)
class Sequence:
    """A list."""

    items: tuple[Node, ...]
    line: int
    column: int
    size: int


@dataclass(frozen=True, slots=True)
class Mapping:
    """A mapping in the order of the file; keys are unique."""

    entries: tuple[tuple[Scalar, Node], ...]
    line: int
    column: int
    size: int


Node: TypeAlias = Scalar | Sequence | Mapping


def describe(node: Node) -> str:
    """``node`` for the "found" of a message."""
    if isinstance(node, Sequence):
        return f"a list of {len(node.items)}" if node.items else "an empty list"
    if isinstance(node, Mapping):
        return "a mapping" if node.entries else "an empty mapping"
    return shown(node.text) if node.text or not node.plain else "nothing"


def decode(data: bytes, file: str) -> str:
    """The text of a file: UTF-8, with or without byte order mark.

    Raises
    ------
    InputError: the file is too large or not UTF-8; with the place of the first wrong byte.
    """
    if len(data) > FILE_SIZE:
        found, expected = "more than 1 MiB", "a robot description of at most 1 MiB"
        raise InputError("the file is too large", where=Place(file), found=found, expected=expected)
    return decoded(data, file)


def compose(text: str, file: str) -> Node:
    """The root node of the one YAML document in ``text``.

    Raises
    ------
    InputError: not YAML, empty, several documents, duplicate keys, tags, too deep or too large.
    """
    import yaml  # not at the top: whoever takes a Robot from elsewhere does not pay for it

    text = text.removeprefix("\ufeff")
    if len(text) > FILE_SIZE:
        decode(b" " * (FILE_SIZE + 1), file)
    bad = _FORBIDDEN.search(text)
    if bad:
        line = text.count("\n", 0, bad.start()) + 1
        raise InputError(
            "the file contains a character that text does not have",
            where=Place(file, line, bad.start() - text.rfind("\n", 0, bad.start())),
            found=f"U+{ord(bad.group()):04X}",
            expected="printable text",
            remedy="delete it; is this a text file?",
        )
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        root = _Builder(file).build(yaml.parse(text, Loader=loader))
    except yaml.YAMLError as error:
        raise _not_yaml(error, text, file) from None
    if root is None:
        remedy = "robodyn new writes a starter file"
        raise InputError(
            "the file is empty", where=Place(file, 1, 1), expected="a robot description", remedy=remedy
        )
    return root


def _not_yaml(error: Exception, text: str, file: str) -> InputError:
    """The parser's complaint as one line."""
    mark = getattr(error, "problem_mark", None) or getattr(error, "context_mark", None)
    problem = getattr(error, "problem", None) or getattr(error, "reason", None) or "cannot be read"
    if mark is None:
        return InputError(f"not valid YAML: {problem}", where=Place(file))
    lines = text.splitlines()
    line = lines[mark.line] if mark.line < len(lines) else ""
    if line[mark.column : mark.column + 1] == "\t" or "\t" in line[: len(line) - len(line.lstrip())]:
        remedy = "indent with spaces, not tabs"
    elif "mapping values are not allowed" in problem:
        remedy = "put text that contains ': ' in quotes, and each key on a line of its own"
    elif "could not find expected ':'" in problem:
        remedy = "every key is followed by a colon and a space"
    else:
        remedy = "check the indentation, and that every bracket and quote is closed"
    context = getattr(error, "context", None)
    return InputError(
        f"not valid YAML: {problem}" + (f" ({context})" if context else ""),
        where=Place(file, mark.line + 1, mark.column + 1),
        remedy=remedy,
    )


@dataclass(slots=True)
class _Open:
    """A list or mapping whose end has not been met; ``mark``: where PyYAML has its beginning."""

    mark: Any
    anchor: str | None
    is_mapping: bool
    children: list[Node] = field(default_factory=list)
    keys: dict[str, Scalar] = field(default_factory=dict)


class _Builder:
    """Builds the tree from events; ``anchors`` hold finished nodes, so that none can contain itself."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.stack: list[_Open] = []
        self.anchors: dict[str, Node] = {}
        self.root: Node | None = None
        self.count = 0

    def build(self, events: Iterable[Any]) -> Node | None:
        from yaml import events as kinds

        documents = 0
        for event in events:
            mark = event.start_mark
            if isinstance(event, kinds.ScalarEvent):
                self._finish(self._scalar(event), event.anchor, mark)
            elif isinstance(event, (kinds.MappingStartEvent, kinds.SequenceStartEvent)):
                self._refuse_tag(event)
                if len(self.stack) == DEPTH:
                    what = "lists and mappings are nested too deep"
                    raise self._error(mark, what, expected=f"at most {DEPTH} levels")
                self.stack.append(_Open(mark, event.anchor, isinstance(event, kinds.MappingStartEvent)))
            elif isinstance(event, (kinds.MappingEndEvent, kinds.SequenceEndEvent)):
                self._close()
            elif isinstance(event, kinds.AliasEvent):
                self._alias(event)
            elif isinstance(event, kinds.DocumentStartEvent):
                documents += 1
                if documents > 1:
                    what, remedy = "a second YAML document begins here", "put each robot in a file of its own"
                    raise self._error(mark, what, expected="one robot a file", remedy=remedy)
        return self.root

    def _error(self, mark: Any, what: str, **more: str | None) -> InputError:
        """That of what begins at ``mark``, which counts from 0; ``more``: the other parts of the error."""
        return InputError(what, where=Place(self.file, mark.line + 1, mark.column + 1), **more)

    def _refuse_tag(self, event: Any) -> None:
        tag = getattr(event, "tag", None)
        if tag is not None:
            found, what = shown(tag.replace("tag:yaml.org,2002:", "!!")), "YAML tags are not used here"
            raise self._error(event.start_mark, what, found=found, remedy="delete the tag")

    def _scalar(self, event: Any) -> Scalar:
        self._refuse_tag(event)
        start, end, text = event.start_mark, event.end_mark, event.value
        plain = event.style is None or event.style == ""
        marks = 0 if plain else 2
        verbatim = start.line == end.line and end.column - start.column - marks == len(text)
        return Scalar(text, start.line + 1, start.column + 1, plain, verbatim)

    def _alias(self, event: Any) -> None:
        node = self.anchors.get(event.anchor)
        if node is None:
            inside = any(open_.anchor == event.anchor for open_ in self.stack)
            name, fault = event.anchor[:40], "contains itself" if inside else "has no anchor before it"
            expected = f"an &{name} that ends before this line"
            what = f"the alias *{name} {fault}"
            raise self._error(event.start_mark, what, expected=expected, remedy="write the value out")
        self._finish(node, None, event.start_mark)

    def _finish(self, node: Node, anchor: str | None, mark: Any) -> None:
        """A node is complete: it goes to its parent, and under its anchor."""
        self.count += 1
        if self.count > NODES:
            raise self._too_large(mark)
        if anchor is not None:
            self.anchors[anchor] = node
        if not self.stack:
            self.root = node
            return
        parent = self.stack[-1]
        if not parent.is_mapping or len(parent.children) < len(parent.keys):
            parent.children.append(node)
            return
        if not isinstance(node, Scalar):
            raise self._error(mark, "a key must be a word", found=describe(node))
        if node.text in parent.keys:
            what = f"the key {shown(node.text)} stands here a second time"
            first = f"the first in line {parent.keys[node.text].line}"
            raise self._error(mark, what, found=first, remedy="delete one of the two")
        parent.keys[node.text] = node

    def _close(self) -> None:
        done = self.stack.pop()
        size = 1 + len(done.keys) + sum(child.size for child in done.children)
        if size > NODES:
            raise self._too_large(done.mark)
        place = (done.mark.line + 1, done.mark.column + 1, size)
        node: Node = Sequence(tuple(done.children), *place)
        if done.is_mapping:
            node = Mapping(tuple(zip(done.keys.values(), done.children, strict=True)), *place)
        self._finish(node, done.anchor, done.mark)

    def _too_large(self, mark: Any) -> InputError:
        expected = f"at most {NODES} values, aliases written out"
        return self._error(mark, "the description is too large", expected=expected)
