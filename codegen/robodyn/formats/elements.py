"""XML text to a tree of elements that know their line and column; nothing is interpreted yet.

The parser is expat. A file is untrusted: its size, its depth, and how many elements and attributes it has are
bounded, and a document type, the only place where XML defines entities, is refused, so that no entity is
expanded and no other file is read.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from xml.parsers import expat

from robodyn.errors import InputError, Place
from robodyn.files import MIB, label, read_bytes
from robodyn.formats.limits import ATTRIBUTES, DEPTH, ELEMENTS, FILE_MIB
from robodyn.formats.xml_text import xml_text
from robodyn.robot.names import shown

_NOT_XML = "the file is not XML"


@dataclass(frozen=True, slots=True)
class Element:
    """An element: its tag and attributes as written, its text without that of its children.

    ``line`` and ``column`` count from 1 and are those of its ``<``.
    """

    tag: str
    attributes: dict[str, str]
    children: tuple[Element, ...]
    text: str
    line: int
    column: int

    def all(self, tag: str) -> Iterator[Element]:
        """The children of that tag, in the order of the file."""
        return (child for child in self.children if child.tag == tag)

    def first(self, tag: str) -> Element | None:
        """The first child of that tag."""
        return next(self.all(tag), None)

    def walk(self) -> Iterator[Element]:
        """This element and all that are in it, in the order of the file."""
        stack = [self]
        while stack:
            element = stack.pop()
            yield element
            stack.extend(reversed(element.children))


@dataclass(frozen=True, slots=True)
class Document:
    """A file's name for messages, its text and its root element; ``warnings``: what of it is not XML by the
    letter, with the places."""

    file: str
    text: str
    root: Element
    warnings: tuple[tuple[Place, str], ...] = ()

    def place(self, element: Element, attribute: str = "") -> Place:
        """Where ``element`` begins, or where its ``attribute`` does if it can be told."""
        line, column = element.line, element.column
        if attribute in element.attributes:
            start = 0
            for _ in range(line - 1):
                start = self.text.index("\n", start) + 1
            start += column - 1
            word = re.compile(rf"\s({re.escape(attribute)})\s*=")
            hit = word.search(self.text, start, self.text.find(">", start))
            if hit:
                line += self.text.count("\n", start, hit.start(1))
                column = hit.start(1) - self.text.rfind("\n", 0, hit.start(1))
        return Place(self.file, line, column)


def read(path: str, expected: str, name: str | None = None) -> Document:
    """The document in the file ``path``; ``expected`` says what it should be, ``name`` what messages call it.

    Raises
    ------
    InputError: it cannot be read, is too large, or as :func:`parse`.
    """
    name = name or label(path)
    return parse(read_bytes(path, FILE_MIB * MIB, expected, name), name, expected)


def parse(data: bytes, file: str, expected: str = "XML") -> Document:
    """The document in ``data``, in the encoding that it declares, by default UTF-8.

    Raises
    ------
    InputError: not in its encoding, not XML, with a document type, too deep or too large; with the place.
    """
    xml = xml_text(data, file)
    if not xml.text.strip():
        raise InputError("the file is empty", where=Place(file), expected=expected)
    return Document(file, xml.text, _Builder(file, expected).build(xml.text), xml.warnings)


class _Builder:
    """What expat calls; elements are finished from the leaves to the root."""

    def __init__(self, file: str, expected: str) -> None:
        self.file, self.expected = file, expected
        self.parser = expat.ParserCreate("UTF-8")  # whatever its declaration says: the text is decoded
        self.parser.buffer_text = True
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = self.end
        self.parser.CharacterDataHandler = lambda text: self.open[-1][3].append(text)
        self.parser.StartDoctypeDeclHandler = self.doctype
        self.open: list[tuple[str, dict[str, str], list[Element], list[str], int, int]] = []
        self.top: list[Element] = []
        self.elements = 0

    def build(self, text: str) -> Element:
        try:
            self.parser.Parse(text, True)
        except expat.ExpatError as error:
            raise self.fault(_NOT_XML, expat.ErrorString(error.code)) from None
        except UnicodeEncodeError:
            raise InputError(_NOT_XML, where=Place(self.file), found="half of a surrogate pair") from None
        return self.top[0]  # expat refuses a document without an element

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        self.elements += 1
        if self.elements > ELEMENTS:
            raise self.fault("the file has too many elements", f"more than {ELEMENTS}")
        if len(self.open) >= DEPTH:
            raise self.fault("the elements are nested too deeply", f"more than {DEPTH} levels")
        if len(attributes) > ATTRIBUTES:
            raise self.fault("an element has too many attributes", f"{len(attributes)}, not {ATTRIBUTES}")
        line, column = self.parser.CurrentLineNumber, self.parser.CurrentColumnNumber + 1
        self.open.append((tag, attributes, [], [], line, column))

    def end(self, _: str) -> None:
        tag, attributes, children, texts, line, column = self.open.pop()
        siblings = self.open[-1][2] if self.open else self.top
        siblings.append(Element(tag, attributes, tuple(children), "".join(texts).strip(), line, column))

    def doctype(self, *_: object) -> None:
        remedy = "delete it: entities are not expanded"
        raise self.fault("the file has a document type", "<!DOCTYPE", remedy)

    def fault(self, what: str, found: str, remedy: str | None = None) -> InputError:
        where = Place(self.file, self.parser.CurrentLineNumber, self.parser.CurrentColumnNumber + 1)
        return InputError(what, where=where, found=found, expected=self.expected, remedy=remedy)


def tag_shown(element: Element) -> str:
    """``<tag>`` for a message."""
    return f"<{shown(element.tag)[1:-1]}>"
