"""Numbers, vectors and poses of XML attributes and texts, with the place of what is wrong."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.formats.chain import Body, Pose, Rotation, Vector, transposed
from robodyn.formats.elements import Document, Element, tag_shown
from robodyn.formats.limits import GREATEST, SHORTEST_AXIS, UNIT_AXIS
from robodyn.formats.tree import Leftovers
from robodyn.robot.names import shown, text_fault

_NUMBER: Final = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\Z", re.ASCII)
_ENDLESS: Final = re.compile(r"[+-]?inf(inity)?\Z", re.ASCII | re.IGNORECASE)


class Quantities:
    """Reads the values of one document; whatever is wrong is an :class:`InputError` with its place."""

    def __init__(self, document: Document, leftovers: Leftovers) -> None:
        self.document, self.leftovers = document, leftovers

    def one(self, element: Element, tag: str, of: str) -> Element | None:
        """The child of that tag, of which there is one at most."""
        children = list(element.all(tag))
        if len(children) > 1:
            remedy = f"delete one; the first is in line {children[0].line}"
            raise self.fail(children[1], f"{of} has <{tag}> twice", remedy=remedy)
        return children[0] if children else None

    def place(self, element: Element, attribute: str = "") -> Place:
        return self.document.place(element, attribute)

    def fail(
        self,
        element: Element,
        what: str,
        *,
        attribute: str = "",
        found: str | None = None,
        expected: str | None = None,
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
        fault = "is empty" if not text else text_fault(text)
        if fault:
            raise self.fail(
                element,
                f"the name of {of} {fault}",
                attribute=attribute,
                found=shown(text),
                expected="a name",
            )
        return text

    def number(
        self,
        element: Element,
        attribute: str,
        of: str,
        default: float | None = None,
        bad: Callable[[float], str | None] | None = None,
    ) -> float:
        """The number in an attribute; without ``default`` it may not be missing; ``bad`` says its fault."""
        if default is not None and attribute not in element.attributes:
            return default
        text = self.required(element, attribute, of)
        value = self._number(text, element, attribute, f"{of}: {attribute} of {tag_shown(element)}")
        fault = bad(value) if bad else None
        if fault:
            what = f"{of}: {attribute} of {tag_shown(element)} {fault}"
            raise self.fail(element, what, attribute=attribute, found=shown(text.strip()))
        return value

    def numbers(
        self, text: str, count: int, element: Element, attribute: str, what: str
    ) -> tuple[float, ...]:
        """``count`` numbers, separated by white space."""
        words = text.split(None, count)
        if len(words) != count:
            raise self.fail(
                element,
                f"{what} must have {count} {'number' if count == 1 else 'numbers'}",
                attribute=attribute,
                found=shown(" ".join(text.split())) if words else "nothing",
                expected=f"{count}, separated by spaces" if count > 1 else "a number",
            )
        return tuple(self._number(word, element, attribute, what) for word in words)

    def truth(self, text: str, element: Element, attribute: str = "") -> bool:
        """A truth value, as SDF has it: whatever the case of its letters."""
        word = text.strip().lower()
        if word not in ("true", "false", "1", "0"):
            raise self.fail(
                element,
                f"{attribute or tag_shown(element)} is no truth value",
                attribute=attribute,
                found=shown(text),
                expected="true, false, 1 or 0",
            )
        return word in ("true", "1")

    def vector(self, element: Element, attribute: str, of: str, default: Vector) -> Vector:
        """Three numbers in an attribute."""
        text = element.attributes.get(attribute)
        if text is None:
            return default
        x, y, z = self.numbers(text, 3, element, attribute, f"{of}: {attribute} of {tag_shown(element)}")
        return (x, y, z)

    def limit(self, element: Element, attribute: str, of: str) -> float | None:
        """A limit in an attribute: None where it is missing, infinite or beyond everything."""
        text = element.attributes.get(attribute)
        return None if text is None else self.limit_text(text, element, attribute, f"{of}: {attribute}")

    def limit_text(self, text: str, element: Element, attribute: str, what: str) -> float | None:
        """As :meth:`limit`, of a text."""
        word = text.strip()
        if _ENDLESS.match(word) or (_NUMBER.match(word) and abs(float(word)) > GREATEST):
            return None
        return self._number(word, element, attribute, what)

    def axis(self, element: Element, numbers: Vector, attribute: str, of: str) -> Vector:
        """The unit vector along ``numbers``; as it stands where it is one already."""
        length = math.hypot(*numbers)
        if length < SHORTEST_AXIS:
            raise self.fail(
                element, f"{of}: the axis has no direction", attribute=attribute, found="a zero vector"
            )
        if abs(length - 1) > UNIT_AXIS:
            self.leftovers.add("the length of an axis that is not a unit vector", element.line)
        return unit(numbers)

    def _number(self, text: str, element: Element, attribute: str, what: str) -> float:
        word = text.strip()
        if not _NUMBER.match(word):
            seen = shown(word) if word else "nothing"
            raise self.fail(
                element,
                f"{what} is not a number",
                attribute=attribute,
                found=seen,
                expected="a decimal number",
            )
        value = float(word)
        if abs(value) > GREATEST:
            raise self.fail(
                element,
                f"{what} is too large",
                attribute=attribute,
                found=shown(word),
                expected=f"at most {GREATEST:g}",
            )
        return value


def unit(numbers: Vector) -> Vector:
    """``numbers`` at length 1. One along x, y or z has its exact entries."""
    x, y, z = numbers
    length = math.hypot(x, y, z)
    if length == 1.0:
        return (x, y, z)
    return (x / length, y / length, z / length)


def negative(value: float) -> str | None:
    """What is wrong with a mass or a damping below 0."""
    return "is negative" if value < 0 else None


def body_of(mass: float, pose: Pose, inertia: tuple[float, float, float, float, float, float]) -> Body:
    """The body whose centre of mass is the origin of ``pose`` and whose tensor is along the axes of it."""
    return Body(mass, pose.xyz, turned_inertia(pose.rotation, inertia))


def turned_inertia(
    rotation: Rotation, inertia: tuple[float, float, float, float, float, float]
) -> tuple[float, float, float, float, float, float]:
    """``R I R^T``, ``xx yy zz xy xz yz``; turned by quarters, entries change their places and signs only."""
    from robodyn.formats.chain import product

    xx, yy, zz, xy, xz, yz = inertia
    tensor: Rotation = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    a, b, c = product(product(rotation, tensor), transposed(rotation))
    return (a[0], b[1], c[2], a[1], a[2], b[2])
