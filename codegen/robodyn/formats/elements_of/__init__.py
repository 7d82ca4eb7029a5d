"""Every element and attribute of a format, and what it is to a reader: the tables beside this module; and
what a file says and no reader uses, by its table.

A table is text. ``[path]`` begins what is known of an element: of the elements whose path of tags ends in
``path``, the longest such path counts; ``{a,b}`` stands for either, and what follows the bracket says whose
elements these are where the format's authors do not list them. Then one line a kind, ``kind | names``, with
elements as ``<tag>`` and attributes without brackets:

- ``used``: read; it says nothing of torques by itself (names, limits);
- ``torques``: read, and torques depend on it; ``torques NAME``: what the reader cannot model of it is refused
  by that name of :data:`~robodyn.formats.tree.PHYSICS`;
- ``NAME``: refused by that name; ``NAME unless WORDS``: not where it says only these words or numbers, for an
  element also ``attribute=word``;
- ``none``: of no effect on torques, and listed; ``none: WORDS`` says as what;
- ``silent``: of no effect, and not worth a line (colours, contact).

``*`` and ``<*>`` are any attribute and element. An element without a path here has what it stands in.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Final

from robodyn.errors import Place
from robodyn.formats.elements import Element, tag_shown
from robodyn.formats.tree import Leftovers
from robodyn.robot.names import shown

Tags = tuple[str, ...]
#: The formats that have a table, as they are called.
FORMATS: Final = ("URDF", "SDF", "MJCF")
_HEAD: Final = re.compile(r"\[(.*)\] ?(.*)")
_NAMES: Final = ("name", "reference", "joint", "plugin")


@dataclass(frozen=True, slots=True)
class Entry:
    """What an element or attribute is: its kind (used, torques, none, silent or refused); ``physics``: the
    name by which it, or what of it is not modelled, is refused, but where it says only ``neutral`` words;
    ``words`` for lists; ``source``: who has it, where that is not the format."""

    kind: str
    physics: str = ""
    neutral: tuple[str, ...] = ()
    words: str = ""
    source: str = ""

    @property
    def is_read(self) -> bool:
        return self.kind in ("used", "torques")

    def is_neutral(self, text: str, element: Element) -> bool:
        """Whether what is refused says nothing here: only neutral words, or a neutral attribute."""
        if any(f"{name}={value.strip()}" in self.neutral for name, value in element.attributes.items()):
            return True
        words = text.lower().split()
        return bool(words) and all(word in self.neutral or _number(word) in self.neutral for word in words)


class Table:
    """The table of one format: for each path of tags the entries by name, ``<tag>`` or attribute."""

    def __init__(self, title: str, text: str) -> None:
        self.title = title
        self.rows: dict[Tags, dict[str, Entry]] = {}
        heads: list[Tags] = []
        source = kind = ""
        for line in text.splitlines():
            if hit := _HEAD.fullmatch(line):
                heads = list(itertools.product(*(step.strip("{}").split(",") for step in hit[1].split("/"))))
                source = hit[2]
            elif line.strip() and not line.startswith("#"):
                if " | " in line and not line.startswith(" "):
                    kind, _, line = line.partition(" | ")
                for head in heads:
                    row = self.rows.setdefault(head, {})
                    row.update(dict.fromkeys(line.split(), _entry(kind, source)))
        self._longest = max(map(len, self.rows))

    def path_of(self, tags: Tags) -> Tags | None:
        """The longest path in the table that ``tags`` ends in."""
        ends = (tags[start:] for start in range(max(len(tags) - self._longest, 0), len(tags)))
        return next((end for end in ends if end in self.rows), None)

    def row_of(self, tags: Tags) -> dict[str, Entry]:
        """The entries of an element with these ``tags``, by name."""
        return self.rows.get(self.path_of(tags) or (), {})


def _entry(text: str, source: str) -> Entry:
    head, _, words = text.partition(": ")
    name, _, neutral = head.partition(" unless ")
    kind, _, physics = name.partition(" ")
    if kind in ("none", "silent", "used", "torques"):
        return Entry(kind, physics, words=words, source=source)
    return Entry("refused", name, tuple(neutral.split()), source=source)


@cache
def table_of(title: str) -> Table:
    """The table of the format of that ``title``, one of :data:`FORMATS`."""
    file = Path(__file__).with_name(f"{title.lower()}.txt")
    return Table(title, file.read_text(encoding="utf-8"))


class Unread:
    """Goes through elements and notes in ``leftovers`` what of them the reader of ``table`` does not use.

    ``place`` says where an element, or an attribute of it, stands.
    """

    def __init__(self, table: Table, leftovers: Leftovers, place: Callable[[Element, str], Place]) -> None:
        self._table, self._leftovers, self._place = table, leftovers, place

    def note(self, root: Element) -> None:
        """Note what is in the ``root`` of a document."""
        tags = (root.tag,)
        self._element(root, tags, self._table.path_of(tags) or (), "", "")

    def _element(self, element: Element, tags: Tags, path: Tags, of: str, below: str) -> None:
        """``below``: "" among elements that are read, "none" in one of no effect, "silent" in what stands
        in it as it could elsewhere (a link of an actor), where only what is unknown is noted."""
        of = name_of(element) or of
        row = self._table.rows.get(path, {})
        for attribute, text in element.attributes.items():
            if not attribute.startswith("xmlns"):
                entry = row.get(attribute) or row.get("*")
                what = f"{shown(attribute)} of {tag_shown(element)}"
                self._item(entry, what, text, element, attribute, of, below)
        for child in element.children:
            entry = row.get(f"<{child.tag}>") or row.get("<*>")
            what = f"{tag_shown(child)} in {tag_shown(element)}"
            self._item(entry, what, child.text, child, "", of, below)
            if entry is None or "<*>" in row:
                continue
            inside = self._table.path_of((*tags, child.tag))
            state = below
            if not entry.is_read and not below:
                state = "none"
            elif below and inside and inside[: len(path)] != path:
                state = "silent"
            self._element(child, (*tags, child.tag), inside or path, of, state)

    def _item(
        self, entry: Entry | None, what: str, text: str, element: Element, attribute: str, of: str, below: str
    ) -> None:
        if entry is None or (entry.kind == "none" and not below):
            words = entry.words or what if entry else f"unknown to {self._table.title}: {what}"
            self._leftovers.add(words, element.line, self._place(element, "").file)
        elif entry.kind == "refused" and below != "silent" and not entry.is_neutral(text, element):
            where = self._place(element, attribute)
            self._leftovers.changes_torques(entry.physics, name_of(element) or of or what, where)


def _number(word: str) -> str:
    """A number as the table has it, ``0`` for ``-0.00``."""
    try:
        return f"{float(word) + 0.0:g}"
    except ValueError:
        return word


def name_of(element: Element) -> str:
    """What an element is called, with its tag; "" without a name."""
    names = (element.attributes[name] for name in _NAMES if name in element.attributes)
    name = next(names, "")
    return f"{element.tag} {name}" if name else ""
