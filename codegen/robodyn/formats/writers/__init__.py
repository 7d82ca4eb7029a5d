"""Descriptions to files of other formats, one module a format; and the XML that they write: indented,
escaped, numbers in their shortest form, the same bytes for the same elements."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

_ESCAPES: Final = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"}
#: What no XML 1.0 document may hold, whatever the escape; and white space that readers would replace.
_ILLEGAL: Final = re.compile("[^\x20-\x7e\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


@dataclass(frozen=True, slots=True)
class Tag:
    """An element: attributes in order, and either elements or text in it."""

    name: str
    attributes: tuple[tuple[str, str], ...] = ()
    children: tuple[Tag, ...] = ()
    text: str = ""

    def lines(self, depth: int = 0) -> Iterator[str]:
        """The element as indented lines."""
        space = "  " * depth
        opening = self.name + "".join(f' {key}="{escaped(value)}"' for key, value in self.attributes)
        if self.children:
            yield f"{space}<{opening}>"
            for child in self.children:
                yield from child.lines(depth + 1)
            yield f"{space}</{self.name}>"
        elif self.text:
            yield f"{space}<{opening}>{escaped(self.text)}</{self.name}>"
        else:
            yield f"{space}<{opening}/>"


def tag(name: str, /, *children: Tag | None, **attributes: str | None) -> Tag:
    """An element; what is None is left out, and an underscore behind an attribute's name is too."""
    pairs = ((key.rstrip("_"), value) for key, value in attributes.items())
    return Tag(
        name,
        tuple((key, value) for key, value in pairs if value is not None),
        tuple(child for child in children if child is not None),
    )


def leaf(name: str, text: str, /, **attributes: str) -> Tag:
    """An element with a text."""
    return Tag(name, tuple(attributes.items()), (), text)


def document(root: Tag, comments: Iterable[str]) -> str:
    """The text of a document with lines of comment at its head."""
    head = ['<?xml version="1.0" encoding="utf-8"?>']
    head += [f"<!-- {commented(line)} -->" for line in comments if line]
    return "\n".join([*head, *root.lines()]) + "\n"


def legal(text: str) -> str:
    """``text`` with an underscore for every character that XML cannot hold, or not as it is."""
    return _ILLEGAL.sub("_", text)


def escaped(text: str) -> str:
    """``text`` as it stands in an attribute or between tags."""
    return "".join(_ESCAPES.get(c, c) for c in legal(text))


def commented(text: str) -> str:
    """``text`` as it stands in a comment, which two hyphens would end."""
    return re.sub("-(?=-|$)", "- ", legal(text)).strip()


def decimal(x: float) -> str:
    """The shortest text of the double ``x``; whole numbers without a point."""
    return f"{x:.0f}" if x.is_integer() and abs(x) < 1e15 else repr(x)


def decimals(numbers: Sequence[float]) -> str:
    """Numbers, separated by spaces."""
    return " ".join(decimal(x + 0.0) for x in numbers)  # -0.0 + 0.0 is 0.0
