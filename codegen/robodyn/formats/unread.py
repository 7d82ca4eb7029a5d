"""What a file says and no reader uses, from the table of its format: of no effect, refused, or unknown."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from robodyn.errors import Place
from robodyn.formats.elements import Element, tag_shown
from robodyn.formats.elements_of import Entry, Table
from robodyn.formats.tree import Leftovers
from robodyn.robot.names import shown

_ANY = {True: "<*>", False: "*"}
_NAMES = ("name", "reference", "joint", "plugin")


class Unread:
    """Goes through elements and notes in ``leftovers`` what of them the reader of ``table`` does not use.

    ``place`` says where an element, or an attribute of it, stands.
    """

    def __init__(self, table: Table, leftovers: Leftovers, place: Callable[[Element, str], Place]) -> None:
        self._table, self._leftovers, self._place = table, leftovers, place

    def note(self, element: Element, tags: tuple[str, ...], of: str = "") -> None:
        """Note what is in ``element``, which is in elements of the other ``tags``, its own the last one."""
        self._element(element, tags, self._table.path_of(tags), of)

    def _element(
        self, element: Element, tags: tuple[str, ...], path: tuple[str, ...] | None, of: str, below: str = ""
    ) -> None:
        """``below``: "" among elements that are read, "none" in one of no effect, "silent" in what stands
        in it as it could elsewhere (a link of an actor), where only what is unknown is noted."""
        of = name_of(element) or of
        row = self._table.rows.get(path, {}) if path else {}
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
            elif below and inside and inside[: len(path or ())] != path:
                state = "silent"
            self._element(child, (*tags, child.tag), inside or path, of, state)

    def _item(
        self, entry: Entry | None, what: str, text: str, element: Element, attribute: str, of: str, below: str
    ) -> None:
        if entry is None or (entry.kind == "none" and not below):
            words = entry.words or what if entry else f"unknown to {self._table.title}: {what}"
            self._leftovers.add(words, element.line, self._place(element, "").file)
        elif entry.kind == "refused" and below != "silent" and not _is_neutral(entry, text, element):
            where = self._place(element, attribute)
            self._leftovers.changes_torques(entry.physics, name_of(element) or of or what, where)


def _is_neutral(entry: Entry, text: str, element: Element) -> bool:
    """Whether what is refused says nothing here: only neutral words, or a neutral attribute."""
    stated = {f"{name}={value.strip()}" for name, value in element.attributes.items()}
    if stated.intersection(entry.neutral):
        return True
    words = text.lower().split()
    return bool(words) and all(word in entry.neutral or _number(word) in entry.neutral for word in words)


def _number(word: str) -> str:
    """A number as the table has it, ``0`` for ``-0.00``."""
    try:
        return f"{float(word) + 0.0:g}"
    except ValueError:
        return word


def name_of(element: Element) -> str:
    """What an element is called, with its tag; "" without a name."""
    names: Iterator[str] = (element.attributes[name] for name in _NAMES if name in element.attributes)
    name = next(names, "")
    return f"{element.tag} {name}" if name else ""
