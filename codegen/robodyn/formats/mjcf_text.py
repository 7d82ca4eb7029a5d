"""What of an MJCF file is handed to MuJoCo: elements and attributes that say something of links and joints.

Everything else (meshes, textures, plugins, sensors, settings of the simulation) is left out and listed, so
that MuJoCo opens no file and allocates nothing that an untrusted file asks for. Files that are included or
attached are read here (:mod:`robodyn.formats.mjcf_files`); MuJoCo is given their texts.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final
from xml.sax.saxutils import quoteattr

from robodyn.errors import InputError, Place
from robodyn.files import MIB
from robodyn.formats.elements import Document, Element, tag_shown
from robodyn.formats.elements_of import Entry, Table, table_of
from robodyn.formats.limits import DEPTH, ELEMENTS, FILE_MIB, LINKS
from robodyn.formats.mjcf_files import Files
from robodyn.formats.mjcf_handed import (
    MESH,
    Classes,
    Handed,
    InertiaRules,
    has_rotor,
    is_height_field,
    is_mesh,
    names_of_nan,
)
from robodyn.formats.tree import Leftovers
from robodyn.formats.unread import Unread, name_of
from robodyn.robot.names import TEXT_LENGTH, shown

#: Actuators of which MuJoCo is given the passive part.
_PASSIVE: Final = frozenset({"intvelocity", "pid", "damper", "cylinder", "muscle", "plugin"})
_NAMED: Final = frozenset({"body", "joint", "freejoint", "site", "connect", "weld"})
_BODIES: Final = frozenset({"worldbody", "body", "frame", "replicate"})
"""Elements that bodies, joints and sites stand in."""
_COUNT: Final = re.compile(r"\s*\d{1,99}\s*", re.ASCII)


def handed(
    document: Document, path: Path | None, leftovers: Leftovers, folders: Iterable[str] = ()
) -> Handed:
    """What MuJoCo is given of ``document``, which lies at ``path`` (None: nothing can be included).

    ``folders``: files in them may be read as well as those beside ``path`` and below it.

    Raises
    ------
    InputError: a file that is included is outside of the folders, missing or not XML, or an element makes
        bodies in a way that is not read.
    """
    task = _Task(Handed(), leftovers, Files(path, folders), table_of("MJCF"))
    first = _Writer(task, document, None if path is None else path.parent.resolve() / path.name)
    task.handed.text = first.write()
    waiting = first.attached()
    for writer in waiting:
        before = "\n" * len(task.handed.lines)
        task.handed.models[writer.file] = before + writer.write()
        waiting += writer.attached()
    return task.handed


@dataclass(slots=True)
class _Task:
    """What the writers of a file and of the models that it attaches share."""

    handed: Handed
    leftovers: Leftovers
    files: Files
    table: Table
    elements: int = 0
    characters: int = 0
    copies: int = 0
    models: int = 0

    def count(self, characters: int, weight: int, place: Place) -> None:
        """Count an element with so many characters, of which MuJoCo makes ``weight``.

        For each replica, and each model that is attached, MuJoCo goes through all elements that there are
        (0.5 us each, in version 4.0): the product is bounded by that of a tree's links, 12 s.
        """
        self.elements += weight
        self.characters += max(weight, 1) * characters
        if (
            self.elements > ELEMENTS
            or self.characters > FILE_MIB * MIB
            or self.copies * self.elements > LINKS**2
        ):
            raise InputError("with what it includes, the file is too large", where=place)


class _Writer:
    """Writes one model: a file with those that it includes.

    ``above``: the files of the models that attach it; ``file``: what MuJoCo calls it. ``prefixes``: what its
    names begin with wherever it is attached, and ``weight``: how many of each of its elements MuJoCo makes.
    """

    def __init__(
        self,
        task: _Task,
        document: Document,
        path: Path | None,
        above: tuple[Path, ...] = (),
        file: str = "",
    ) -> None:
        self._task, self._first, self.file = task, document, file
        self._folder = None if path is None else path.parent
        self._files = (*above, *([] if path is None else [path.resolve()]))
        self._included: set[Path] = set(self._files[-1:])
        self._documents: dict[int, Document] = {}
        self._texts: list[str] = []
        self._classes, self._rules = Classes(), InertiaRules()
        self._models: dict[str, _Writer] = {}
        self._motor_classes: list[Element] = []
        self._names = 0
        self._taken: set[str] = set()
        self.prefixes: list[str] = [] if above else [""]
        self.weight = 0 if above else 1

    def write(self) -> str:
        root = self._spliced(self._first.root, self._first, self._folder, 0)
        self._taken = {element.attributes.get("name", "") for element in root.walk()}
        Unread(self._task.table, self._task.leftovers, self._place).note(root, (root.tag,))
        motors = self._task.table.row_of(("actuator",))
        for default in root.all("default"):
            self._classes.read(default)
            self._motor_classes += [each for each in default.walk() if f"<{each.tag}>" in motors]
        self._element(root, (root.tag,), "", max(self.weight, 1))
        return "\n".join(self._texts) + "\n"

    def attached(self) -> list[_Writer]:
        """The models that this one attaches, once it is written."""
        return list(self._models.values())

    def _spliced(self, element: Element, document: Document, folder: Path | None, depth: int) -> Element:
        """``element`` with the content of files in the place of their ``<include>``."""
        if depth > DEPTH:
            raise InputError("with what it includes, the file is too large", where=document.place(element))
        children: list[Element] = []
        for child in element.children:
            if child.tag == "include":
                included, path = self._read(child, document, folder)
                root = self._spliced(included.root, included, path.parent, depth + 1)
                children += root.children
            else:
                children.append(self._spliced(child, document, folder, depth + 1))
        spliced = replace(element, children=tuple(children))
        self._documents[id(spliced)] = document
        return spliced

    def _read(self, include: Element, document: Document, folder: Path | None) -> tuple[Document, Path]:
        folders = [each for each in (self._folder, folder) if each is not None]
        included, path = self._task.files.read(include, document, folders)
        if path in self._included:
            where, name = document.place(include, "file"), include.attributes.get("file", "")
            raise InputError("the file is included twice", where=where, found=shown(name))
        self._included.add(path)
        self._task.handed.warnings += included.warnings
        return included, path

    def _place(self, element: Element, attribute: str = "") -> Place:
        return self._documents[id(element)].place(element, attribute)

    def _line(self, text: str, place: Place) -> None:
        self._texts.append(text)
        self._task.handed.lines.append(place)

    def _element(self, element: Element, tags: tuple[str, ...], childclass: str, weight: int) -> None:
        """Write ``element``, of which MuJoCo makes ``weight``, with what is in it; its tag is the last."""
        place, parent = self._place(element), "".join(tags[-2:-1])
        if element.tag == "replicate":
            weight *= self._count(element)
        if element.tag in ("replicate", "attach"):
            self._task.copies += weight
        row = self._task.table.row_of(tags)
        attributes = self._attributes(element, row)
        self._task.count(sum(map(len, attributes.values())), weight, place)
        for name in ("sep", "prefix"):
            if len(attributes.get(name, "")) > TEXT_LENGTH:
                where, expected = self._place(element, name), f"at most {TEXT_LENGTH} characters"
                raise InputError(f"{name} of {tag_shown(element)} is long", where=where, expected=expected)
        if element.tag in _NAMED and (parent in _BODIES or parent == "equality"):
            tag = "equality" if parent == "equality" else element.tag.removeprefix("free")
            attributes = {"name": self._new_name(tag, parent)} | attributes
            self._task.count(sum(map(len, self.prefixes)), 0, place)
            for prefix in self.prefixes:
                self._task.handed.places[tag, prefix + attributes["name"]] = place
        elif element.tag == "geom" and parent != "default" and is_mesh(self._classes.of(element, childclass)):
            attributes |= {"name": f"{MESH}{len(self._task.handed.rules)};", "type": "sphere", "size": "1"}
            self._task.handed.rules.append(self._rules)
        elif element.tag == "geom" and attributes.get("type") in ("mesh", "hfield", "sdf"):
            del attributes["type"]
        elif element.tag == "compiler":
            self._rules.read(attributes)
        elif element.tag in ("option", "flag") and self.weight:
            settings = [(self._place(element, name), name, text) for name, text in attributes.items()]
            self._task.handed.settings += settings
        elif element.tag == "attach":
            self._attach(attributes, weight)
        elif element.tag == "model":
            attributes["file"] = self._model(element)
        tag = "general" if element.tag in _PASSIVE else element.tag
        written = "".join(f" {name}={quoteattr(value)}" for name, value in attributes.items())
        self._line(f"<{tag}{written}>", place)
        childclass = attributes.get("childclass", childclass)
        for child in element.children:
            entry = row.get(f"<{child.tag}>")
            if entry is None or not entry.is_read:
                continue
            if not self._is_left_out(child, element.tag, childclass):
                self._element(child, (*tags, child.tag), childclass, weight)
                continue
            what = f"{tag_shown(child)} in {tag_shown(element)}"
            if element.tag == "equality" and self._classes.of(child).get("active") != "false":
                if self.weight:
                    self._task.handed.tendons.append((self._place(child), name_of(child) or what))
                continue
            self._task.leftovers.add(what, child.line, self._documents[id(child)].file)
            if "tendon" in child.attributes and any(map(has_rotor, (child, *self._motor_classes))):
                of = f"{child.tag} {child.attributes.get('name', '')}".strip()
                self._task.leftovers.changes_torques("tendon", of, self._place(child))
        self._line(f"</{tag}>", place)

    def _new_name(self, tag: str, parent: str) -> str:
        """A name for what has none, which nothing else has; replicas have a number more behind it."""
        while True:
            self._names += 1
            if f"{tag}{self._names}" not in self._taken:
                return f"{tag}{self._names}{'-' if parent == 'replicate' else ''}"

    def _count(self, replicate: Element) -> int:
        text = replicate.attributes.get("count", "1")
        if not _COUNT.fullmatch(text):
            raise InputError(
                "the count of <replicate> is no whole number",
                where=self._place(replicate, "count"),
                found=shown(text),
            )
        return max(int(text), 1)

    def _model(self, model: Element) -> str:
        """What MuJoCo is to call the file of a ``<model>``, which it attaches by name."""
        document = self._documents[id(model)]
        folders = [] if self._folder is None else [self._folder]
        attached, path = self._task.files.read(model, document, folders)
        if path in self._files:
            where = document.place(model, "file")
            raise InputError("the model attaches itself", where=where, found=shown(model.attributes["file"]))
        self._task.handed.warnings += attached.warnings
        self._task.models += 1
        writer = _Writer(self._task, attached, path, self._files, f"robodyn model {self._task.models}.xml")
        name = model.attributes.get("name", attached.root.attributes.get("model", ""))
        self._models.setdefault(name, writer)
        return writer.file

    def _attach(self, attributes: Mapping[str, str], weight: int) -> None:
        """Note where a model is attached; one that is not there MuJoCo refuses itself."""
        writer = self._models.get(attributes.get("model", ""))
        if writer is not None:
            writer.weight += weight
            writer.prefixes += [prefix + attributes.get("prefix", "") for prefix in self.prefixes]

    def _is_left_out(self, child: Element, parent: str, childclass: str) -> bool:
        """Whether an element of a known tag stands where it says nothing of links and joints."""
        if child.tag == "geom" and is_height_field(self._classes.of(child, childclass)):
            return parent != "default"
        if child.tag == "site" and parent != "default":
            return "name" not in child.attributes
        if parent == "equality":
            return child.tag == "tendon"
        return parent == "actuator" and not {"joint", "jointinparent"}.intersection(child.attributes)

    def _attributes(self, element: Element, row: Mapping[str, Entry]) -> dict[str, str]:
        """The attributes of ``element`` that are read, by its ``row`` of the table."""
        handed = {
            name: value for name, value in element.attributes.items() if name in row and row[name].is_read
        }
        for name in names_of_nan(handed):  # MuJoCo reads them, and writes a file that says so
            where = self._place(element, name)
            raise InputError(f"{name} of {tag_shown(element)} is not a number", where=where, found="nan")
        return handed
