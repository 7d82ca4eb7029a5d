"""Numbers, vectors and poses of XML attributes and texts, with the place of what is wrong."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import Final

from robodyn.errors import InputError
from robodyn.formats.chain import Pose, Vector, unit
from robodyn.formats.elements import Document, Element, tag_shown
from robodyn.formats.limits import GREATEST, SHORTEST_AXIS, UNIT_AXIS
from robodyn.formats.tree import Leftovers
from robodyn.robot.names import shown, text_fault

_NUMBER: Final = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\Z", re.ASCII)
_ENDLESS: Final = re.compile(r"[+-]?inf(inity)?\Z", re.ASCII | re.IGNORECASE)


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
            number, expected = (
                ("number", "a number") if count == 1 else ("numbers", f"{count}, separated by spaces")
            )
            raise self.fail(element, f"{what} must have {count} {number}", found, expected, attribute)
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
