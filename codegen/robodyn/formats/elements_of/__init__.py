"""Every element and attribute of a format, and what it is to a reader: the tables beside this module.

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
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Final, Literal

Kind = Literal["used", "torques", "none", "silent", "refused"]
Tags = tuple[str, ...]
#: The formats that have a table, as they are called.
FORMATS: Final = ("URDF", "SDF", "MJCF")
_HEAD: Final = re.compile(r"\[(.*)\] ?(.*)")


@dataclass(frozen=True, slots=True)
class Entry:
    """What an element or attribute is: its kind; ``physics``: the name by which it, or what of it is not
    modelled, is refused, but where it says only ``neutral`` words; ``words`` for lists; ``source``: who has
    it, where that is not the format."""

    kind: Kind
    physics: str = ""
    neutral: tuple[str, ...] = ()
    words: str = ""
    source: str = ""

    @property
    def is_read(self) -> bool:
        return self.kind in ("used", "torques")


class Table:
    """The table of one format: for each path of tags the entries by name, ``<tag>`` or attribute."""

    def __init__(self, title: str, text: str) -> None:
        self.title = title
        self.rows: dict[Tags, dict[str, Entry]] = {}
        heads: list[Tags] = []
        source = kind = ""
        for line in filter(str.strip, text.splitlines()):
            if line.startswith("#"):
                continue
            if hit := _HEAD.fullmatch(line):
                heads, source = list(_paths(hit[1])), hit[2]
            else:
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


def _paths(head: str) -> Iterator[Tags]:
    """``{a,b}/c`` as a/c and b/c."""
    choices = (step.strip("{}").split(",") for step in head.split("/"))
    yield from itertools.product(*choices)


def _entry(text: str, source: str) -> Entry:
    head, _, words = text.partition(": ")
    name, _, neutral = head.partition(" unless ")
    if name in ("none", "silent"):
        return Entry("none" if name == "none" else "silent", words=words, source=source)
    if name == "used":
        return Entry("used", source=source)
    if name.split()[0] == "torques":
        return Entry("torques", name.removeprefix("torques").strip(), source=source)
    return Entry("refused", name, tuple(neutral.split()), source=source)


@cache
def table_of(title: str) -> Table:
    """The table of the format of that ``title``, one of :data:`FORMATS`."""
    file = Path(__file__).with_name(f"{title.lower()}.txt")
    return Table(title, file.read_text(encoding="utf-8"))
