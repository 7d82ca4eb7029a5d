"""What of an MJCF file is handed to MuJoCo: elements and attributes that say something of links and joints.

Everything else (meshes, textures, plugins, sensors, settings of the simulation) is left out and listed, so
that MuJoCo opens no file and allocates nothing that an untrusted file asks for. Files that are included or
attached are read here; MuJoCo is given their texts.
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
from robodyn.formats.elements_of import Entry, Table, Unread, name_of, table_of
from robodyn.formats.limits import DEPTH, ELEMENTS, FILE_MIB, LINKS
from robodyn.formats.mjcf_input import MESH, Classes, Files, InertiaRules, ModelText
from robodyn.formats.tree import Leftovers
from robodyn.robot.names import TEXT_LENGTH, shown

#: Actuators of which MuJoCo is given the passive part.
_PASSIVE: Final = frozenset({"intvelocity", "pid", "damper", "cylinder", "muscle", "plugin"})
_WITH_NAMES: Final = frozenset({"body", "joint", "freejoint", "site", "connect", "weld"})
#: Elements that bodies, joints and sites stand in.
_BODIES: Final = frozenset({"worldbody", "body", "frame", "replicate"})
_COUNT: Final = re.compile(r"\s*\d{1,99}\s*", re.ASCII)
_ZERO: Final = re.compile(r"[+-]?0*\.?0*([eE].*)?")
#: Attributes whose words are names: one may be called "nan".
_NAMES: Final = re.compile(r"name|(child)?class|model|prefix|file|(joint|body|site)\d?")


def model_text(
    document: Document, path: Path | None, leftovers: Leftovers, folders: Iterable[str] = ()
) -> ModelText:
    """What MuJoCo is given of ``document``, which lies at ``path`` (None: nothing can be included).

    ``folders``: files in them may be read as well as those beside ``path`` and below it.

    Raises
    ------
    InputError: a file that is included is outside of the folders, missing or not XML, or an element makes
        bodies in a way that is not read.
    """
    task = _Task(ModelText(), leftovers, Files(path, folders), table_of("MJCF"))
    first = _Writer(task, document, None if path is None else path.parent.resolve() / path.name)
    task.output.text = first.write()
    waiting = list(first.models.values())
    for writer in waiting:
        before = "\n" * len(task.output.lines)
        task.output.models[writer.file] = before + writer.write()
        waiting += writer.models.values()
    return task.output


@dataclass(slots=True)
class _Task:
    """What the writers of a file and of the models that it attaches share."""

    output: ModelText
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
        is_long = self.elements > ELEMENTS or self.characters > FILE_MIB * MIB
        if is_long or self.copies * self.elements > LINKS**2:
            raise InputError("with what it includes, the file is too large", where=place)


class _Writer:
    """Writes one model: a file with those that it includes.

    ``above``: the files of the models that attach it; ``file``: what MuJoCo calls it. ``prefixes``: what its
    names begin with wherever it is attached, and ``weight``: how many of each of its elements MuJoCo makes.
    ``models``: those that it attaches, by name.
    """

    def __init__(
        self, task: _Task, document: Document, path: Path | None, above: tuple[Path, ...] = (), file: str = ""
    ) -> None:
        self._task, self._output, self._first, self.file = task, task.output, document, file
        self._folder = None if path is None else path.parent
        self._files = (*above, *([] if path is None else [path.resolve()]))
        self._included: set[Path] = set(self._files[-1:])
        self._documents: dict[int, Document] = {}
        self._texts: list[str] = []
        self._classes, self._rules = Classes(), InertiaRules()
        self._motor_classes: list[Element] = []
        self._names = 0
        self.models: dict[str, _Writer] = {}
        self.prefixes: list[str] = [] if above else [""]
        self.weight = 0 if above else 1

    def write(self) -> str:
        root = self._spliced(self._first.root, self._first, self._folder, 0)
        self._taken = {element.attributes.get("name", "") for element in root.walk()}
        Unread(self._task.table, self._task.leftovers, self._place).note(root)
        motors = self._task.table.row_of(("actuator",))
        for default in root.all("default"):
            self._classes.read(default)
            self._motor_classes += [each for each in default.walk() if f"<{each.tag}>" in motors]
        self._element(root, (root.tag,), "", max(self.weight, 1))
        return "\n".join(self._texts) + "\n"

    def _spliced(self, element: Element, document: Document, folder: Path | None, depth: int) -> Element:
        """``element`` with the content of files in the place of their ``<include>``."""
        if depth > DEPTH:
            raise InputError("with what it includes, the file is too large", where=document.place(element))
        children: list[Element] = []
        for child in element.children:
            if child.tag != "include":
                children.append(self._spliced(child, document, folder, depth + 1))
                continue
            included, path = self._read(child, document, folder)
            if path in self._included:
                where, found = document.place(child, "file"), shown(child.attributes.get("file", ""))
                raise InputError("the file is included twice", where=where, found=found)
            self._included.add(path)
            children += self._spliced(included.root, included, path.parent, depth + 1).children
        spliced = replace(element, children=tuple(children))
        self._documents[id(spliced)] = document
        return spliced

    def _read(self, element: Element, document: Document, folder: Path | None) -> tuple[Document, Path]:
        """The document of the file that ``element`` names, and its path."""
        folders = [each for each in (self._folder, folder) if each is not None]
        included, path = self._task.files.read(element, document, folders)
        self._output.warnings += included.warnings
        return included, path

    def _place(self, element: Element, attribute: str = "") -> Place:
        return self._documents[id(element)].place(element, attribute)

    def _element(self, element: Element, tags: tuple[str, ...], childclass: str, weight: int) -> None:
        """Write ``element``, of which MuJoCo makes ``weight``, with what is in it; its tag is the last."""
        place, parent = self._place(element), "".join(tags[-2:-1])
        if element.tag == "replicate":
            weight *= self._replicas(element)
        if element.tag in ("replicate", "attach"):
            self._task.copies += weight
        row = self._task.table.row_of(tags)
        attributes = self._attributes(element, row)
        self._task.count(sum(map(len, attributes.values())), weight, place)
        if element.tag in _WITH_NAMES and (parent in _BODIES or parent == "equality"):
            tag = "equality" if parent == "equality" else element.tag.removeprefix("free")
            attributes = {"name": self._new_name(tag, parent)} | attributes
            self._task.count(sum(map(len, self.prefixes)), 0, place)
            for prefix in self.prefixes:
                self._output.places[tag, prefix + attributes["name"]] = place
        elif element.tag == "geom" and parent != "default" and self._is_mesh(element, childclass):
            attributes |= {"name": f"{MESH}{len(self._output.rules)};", "type": "sphere", "size": "1"}
            self._output.rules.append(self._rules)
        elif element.tag == "geom" and attributes.get("type") in ("mesh", "hfield", "sdf"):
            del attributes["type"]
        elif element.tag == "compiler":
            self._rules.read(attributes)
        elif element.tag in ("option", "flag") and self.weight:
            settings = [(self._place(element, name), name, text) for name, text in attributes.items()]
            self._output.settings += settings
        elif element.tag == "attach" and attributes.get("model", "") in self.models:
            writer = self.models[attributes.get("model", "")]
            writer.weight += weight
            writer.prefixes += [prefix + attributes.get("prefix", "") for prefix in self.prefixes]
        elif element.tag == "model":
            attributes["file"] = self._model(element)
        tag = "general" if element.tag in _PASSIVE else element.tag
        words = "".join(f" {name}={quoteattr(value)}" for name, value in attributes.items())
        self._line(f"<{tag}{words}>", place)
        childclass = attributes.get("childclass", childclass)
        for child in element.children:
            entry = row.get(f"<{child.tag}>")
            if entry is None or not entry.is_read:
                continue
            if self._is_left_out(child, element.tag, childclass):
                self._leave_out(child, element)
            else:
                self._element(child, (*tags, child.tag), childclass, weight)
        self._line(f"</{tag}>", place)

    def _line(self, text: str, place: Place) -> None:
        self._texts.append(text)
        self._output.lines.append(place)

    def _new_name(self, tag: str, parent: str) -> str:
        """A name for what has none, which nothing else has; replicas have a number more behind it."""
        while True:
            self._names += 1
            if f"{tag}{self._names}" not in self._taken:
                return f"{tag}{self._names}{'-' if parent == 'replicate' else ''}"

    def _replicas(self, replicate: Element) -> int:
        text = replicate.attributes.get("count", "1")
        if not _COUNT.fullmatch(text):
            where, what = self._place(replicate, "count"), "the count of <replicate> is no whole number"
            raise InputError(what, where=where, found=shown(text))
        return max(int(text), 1)

    def _model(self, model: Element) -> str:
        """What MuJoCo is to call the file of a ``<model>``, which it attaches by name; one that is not there
        MuJoCo refuses itself."""
        document = self._documents[id(model)]
        attached, path = self._read(model, document, None)
        if path in self._files:
            where, found = document.place(model, "file"), shown(model.attributes["file"])
            raise InputError("the model attaches itself", where=where, found=found)
        self._task.models += 1
        writer = _Writer(self._task, attached, path, self._files, f"robodyn model {self._task.models}.xml")
        name = model.attributes.get("name", attached.root.attributes.get("model", ""))
        self.models.setdefault(name, writer)
        return writer.file

    def _is_mesh(self, geom: Element, childclass: str) -> bool:
        """Whether a geom takes its size from a mesh: it is one, or a shape that is fitted to one."""
        attributes = self._classes.of(geom, childclass)
        return "mesh" in attributes or attributes.get("type") in ("mesh", "sdf")

    def _is_left_out(self, child: Element, parent: str, childclass: str) -> bool:
        """Whether an element of a known tag stands where it says nothing of links and joints."""
        if child.tag == "geom" and parent != "default":
            attributes = self._classes.of(child, childclass)  # height fields
            return "hfield" in attributes or attributes.get("type") == "hfield"
        if child.tag == "site" and parent != "default":
            return "name" not in child.attributes
        if parent == "equality":
            return child.tag == "tendon"
        return parent == "actuator" and not {"joint", "jointinparent"}.intersection(child.attributes)

    def _leave_out(self, child: Element, element: Element) -> None:
        """Note what stands in ``element`` and is not handed to MuJoCo."""
        what = f"{tag_shown(child)} in {tag_shown(element)}"
        if element.tag == "equality" and self._classes.of(child).get("active") != "false":
            if self.weight:
                self._output.tendons.append((self._place(child), name_of(child) or what))
            return
        self._task.leftovers.add(what, child.line, self._documents[id(child)].file)
        if "tendon" in child.attributes and any(map(_has_rotor, (child, *self._motor_classes))):
            of = f"{child.tag} {child.attributes.get('name', '')}".strip()
            self._task.leftovers.changes_torques("tendon", of, self._place(child))

    def _attributes(self, element: Element, row: Mapping[str, Entry]) -> dict[str, str]:
        """The attributes of ``element`` that are read, by its ``row`` of the table."""
        attributes = {
            name: text for name, text in element.attributes.items() if name in row and row[name].is_read
        }
        for name, text in attributes.items():
            fault = expected = ""
            if not _NAMES.fullmatch(name) and any(word.strip("+-").lower() == "nan" for word in text.split()):
                # MuJoCo reads it, and writes a file that says so.
                fault, expected = "is not a number", "a number"
            elif name in ("sep", "prefix") and len(text) > TEXT_LENGTH:
                fault, expected = "is long", f"at most {TEXT_LENGTH} characters"
            if fault:
                where, what = self._place(element, name), f"{name} of {tag_shown(element)} {fault}"
                raise InputError(what, where=where, found=shown(text), expected=expected)
        return attributes


def _has_rotor(actuator: Element) -> bool:
    """Whether an actuator, or a default class of one, has inertia or damping."""
    words = " ".join(actuator.attributes.get(name, "") for name in ("armature", "damping"))
    return any(_ZERO.fullmatch(word) is None for word in words.split())
