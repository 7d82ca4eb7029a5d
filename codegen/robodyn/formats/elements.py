"""XML text to a tree of elements that know their line and column; and numbers, vectors and poses out of their
attributes and texts, with the place of what is wrong.

The parser is expat. A file is untrusted: its size, its depth, and how many elements and attributes it has are
bounded, and a document type, the only place where XML defines entities, is refused, so that no entity is
expanded and no other file is read.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final
from xml.parsers import expat

from robodyn.errors import InputError, Place
from robodyn.files import MIB, label, read_bytes
from robodyn.formats.chain import Pose, Vector, unit
from robodyn.formats.limits import ATTRIBUTES, DEPTH, ELEMENTS, FILE_MIB, GREATEST, SHORTEST_AXIS, UNIT_AXIS
from robodyn.formats.tree import Leftovers
from robodyn.formats.xml_text import xml_text
from robodyn.robot.names import shown, text_fault

_NOT_XML = "the file is not XML"
_NUMBER: Final = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\Z", re.ASCII)
_ENDLESS: Final = re.compile(r"[+-]?inf(inity)?\Z", re.ASCII | re.IGNORECASE)


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


class Quantities:
    """Reads the values of one document; whatever is wrong is an :class:`InputError` with its place."""

    def __init__(self, document: Document, leftovers: Leftovers) -> None:
        self.document, self.leftovers, self.place = document, leftovers, document.place

    def one(self, element: Element | None, tag: str, of: str) -> Element | None:
        """The child of that tag, of which there is one at most."""
        children = [] if element is None else list(element.all(tag))
        if len(children) > 1:
            remedy = f"delete one; the first is in line {children[0].line}"
            raise self.fail(children[1], f"{of} has <{tag}> twice", remedy=remedy)
        return children[0] if children else None

    def fail(
        self,
        element: Element,
        what: str,
        found: str | None = None,
        expected: str | None = None,
        attribute: str = "",
        remedy: str | None = None,
    ) -> InputError:
        """The error that ``what`` is wrong at ``element`` or its ``attribute``."""
        where = self.place(element, attribute)
        return InputError(what, where=where, found=found, expected=expected, remedy=remedy)

    def required(self, element: Element, attribute: str, of: str) -> str:
        """The text of an attribute that may not be missing."""
        text = element.attributes.get(attribute)
        if text is None:
            what = f"{of}: {tag_shown(element)} has no '{attribute}'"
            raise self.fail(element, what, expected=f'{attribute}="..."')
        return text

    def name(self, element: Element, of: str, attribute: str = "name") -> str:
        """The name of something: not empty, no control characters, of a length that messages can show."""
        text = self.required(element, attribute, of).strip()
        if fault := text_fault(text) if text else "is empty":
            raise self.fail(element, f"the name of {of} {fault}", shown(text), "a name", attribute)
        return text

    def kind(self, element: Element, of: str, kinds: dict[str, str]) -> str:
        """What of ``kinds`` the type of a joint is."""
        word = self.required(element, "type", of)
        if word not in kinds:
            raise self.fail(element, f"{of}: the type is unknown", shown(word), ", ".join(kinds), "type")
        return kinds[word]

    def number(
        self,
        element: Element,
        attribute: str,
        of: str,
        default: float | None = None,
        least: float = -math.inf,
    ) -> float:
        """The number in an attribute, not below ``least``; without ``default`` it may not be missing."""
        if default is not None and attribute not in element.attributes:
            return default
        what, text = f"{of}: {attribute} of {tag_shown(element)}", self.required(element, attribute, of)
        value = self._number(text, element, attribute, what)
        if value < least:
            raise self.fail(element, f"{what} is negative", shown(text.strip()), attribute=attribute)
        return value

    def numbers(
        self, text: str, count: int, element: Element, attribute: str, what: str
    ) -> tuple[float, ...]:
        """``count`` numbers, separated by white space."""
        words = text.split(None, count)
        if len(words) != count:
            found = shown(" ".join(text.split())) if words else "nothing"
            expected = "a number" if count == 1 else f"{count}, separated by spaces"
            what += f" must have {count} number{'s' if count > 1 else ''}"
            raise self.fail(element, what, found, expected, attribute)
        return tuple(self._number(word, element, attribute, what) for word in words)

    def truth(self, text: str, element: Element, attribute: str = "") -> bool:
        """A truth value, as SDF has it: whatever the case of its letters."""
        word = text.strip().lower()
        if word not in ("true", "false", "1", "0"):
            what = f"{attribute or tag_shown(element)} is no truth value"
            raise self.fail(element, what, shown(text), "true, false, 1 or 0", attribute)
        return word in ("true", "1")

    def vector(self, element: Element, attribute: str, of: str, default: Vector) -> Vector:
        """Three numbers in an attribute."""
        text = element.attributes.get(attribute)
        if text is None:
            return default
        x, y, z = self.numbers(text, 3, element, attribute, f"{of}: {attribute} of {tag_shown(element)}")
        return (x, y, z)

    def quaternion(
        self, xyzw: str, element: Element, attribute: str, origin: Sequence[float], what: str
    ) -> Pose:
        """The pose with that ``origin`` [m] and the quaternion in the text ``xyzw``."""
        x, y, z, w = self.numbers(xyzw, 4, element, attribute, what)
        try:
            return Pose.from_quaternion(origin, (w, x, y, z))
        except ValueError:
            found = shown(xyzw)
            raise self.fail(element, f"{what}: the quaternion is zero", found, attribute=attribute) from None

    def limit(self, text: str, element: Element, attribute: str, what: str) -> float | None:
        """A limit in a text: None where it is infinite or beyond everything."""
        word = text.strip()
        if _ENDLESS.match(word) or (_NUMBER.match(word) and abs(float(word)) > GREATEST):
            return None
        return self._number(word, element, attribute, what)

    def axis(self, element: Element, numbers: Vector, attribute: str, of: str) -> Vector:
        """The unit vector along ``numbers``; as it stands where it is one already."""
        length = math.hypot(*numbers)
        if length < SHORTEST_AXIS:
            what = f"{of}: the axis has no direction"
            raise self.fail(element, what, "a zero vector", attribute=attribute)
        if abs(length - 1) > UNIT_AXIS:
            self.leftovers.add("the length of an axis that is not a unit vector", element.line)
        return unit(numbers)

    def _number(self, text: str, element: Element, attribute: str, what: str) -> float:
        word = text.strip()
        if not _NUMBER.match(word):
            found, expected = shown(word) if word else "nothing", "a decimal number"
            raise self.fail(element, f"{what} is not a number", found, expected, attribute)
        value = float(word)
        if abs(value) > GREATEST:
            expected = f"at most {GREATEST:g}"
            raise self.fail(element, f"{what} is too large", shown(word), expected, attribute)
        return value
