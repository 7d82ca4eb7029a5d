"""What of an MJCF file is handed to MuJoCo: elements and attributes that say something of links and joints.

Everything else (meshes, textures, plugins, sensors, settings of the simulation) is left out and listed, so
that MuJoCo opens no file and allocates nothing that an untrusted file asks for. Files that are included are
read here, from the folder of the first one and below it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final
from xml.sax.saxutils import quoteattr

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.formats.elements import Document, Element, read, tag_shown
from robodyn.formats.limits import DEPTH, ELEMENTS, FILES_INCLUDED
from robodyn.formats.tree import Leftovers
from robodyn.robot.names import shown


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_TURN: Final = _words("quat axisangle xyaxes zaxis euler")
_ACTUATOR: Final = _words("name class joint gear ctrllimited ctrlrange forcelimited forcerange armature")
#: Elements that are handed on, with their attributes.
_KEPT: Final = {
    "mujoco": _words("model"),
    "compiler": _words(
        "autolimits boundmass boundinertia settotalmass balanceinertia coordinate angle eulerseq "
        "inertiafromgeom inertiagrouprange"
    ),
    "option": _words("gravity"),
    "default": _words("class"),
    "worldbody": _words(""),
    "body": _TURN | _words("name pos childclass"),
    "frame": _TURN | _words("name pos childclass"),
    "inertial": _TURN | _words("pos mass diaginertia fullinertia"),
    "joint": _words(
        "name class type pos axis springdamper limited actuatorfrclimited range actuatorfrcrange ref "
        "springref stiffness damping armature frictionloss joint1 joint2 polycoef active"
    ),
    "freejoint": _words("name"),
    "geom": _TURN | _words("name class type size fromto pos mass density shellinertia group"),
    "site": _TURN | _words("name class pos"),
    "equality": _words(""),
    "connect": _words("name class active body1 body2 anchor site1 site2"),
    "weld": _words("name class active body1 body2 relpose anchor site1 site2"),
    "actuator": _words(""),
    "general": _ACTUATOR | _words("gainprm gaintype biastype"),
    "motor": _ACTUATOR,
    "position": _ACTUATOR,
    "velocity": _ACTUATOR,
}
#: Elements that make bodies: without them the arm is another one.
_REFUSED: Final = frozenset({"replicate", "attach", "composite", "flexcomp"})
_WORDS: Final = {
    "asset": "meshes, textures and materials",
    "contact": "contact pairs",
    "sensor": "sensors",
    "keyframe": "keyframes",
    "visual": "settings of the display",
    "statistic": "settings of the display",
    "light": "lights",
    "camera": "cameras",
    "size": "sizes of memory",
    "tendon": "tendons",
    "extension": "plugins",
    "plugin": "plugins",
    "custom": "custom data",
    "deformable": "deformable bodies",
}
#: Attributes that say nothing of an arm.
_SILENT: Final = _words(
    "rgba material group user solref solimp solreflimit solimplimit solreffriction solimpfriction margin gap "
    "condim contype conaffinity friction priority solmix castshadow fitscale size type"
)
_NAMED: Final = frozenset({"body", "joint", "freejoint", "site", "connect", "weld"})
MESH: Final = "robodyn mesh "
"""Begins the name of a geom that was a mesh: a ball stands for it and is deleted before the model is made."""


@dataclass(slots=True)
class Handed:
    """The text for MuJoCo, a line an element, and the place in the files of each of its lines.

    ``places``: those of bodies, joints and equalities by tag and name. What has no name has one here.
    """

    text: str = ""
    lines: list[Place] = field(default_factory=list)
    places: dict[tuple[str, str], Place] = field(default_factory=dict)

    def place(self, message: str, file: str) -> Place:
        """The place that a message of MuJoCo means by ``line 12``; the file if it names none."""
        hit = re.search(r"line (\d{1,9})", message)
        if hit and 0 < int(hit.group(1)) <= len(self.lines):
            return self.lines[int(hit.group(1)) - 1]
        return Place(file)


def handed(document: Document, path: Path | None, leftovers: Leftovers) -> Handed:
    """What MuJoCo is given of ``document``, which lies at ``path`` (None: nothing can be included).

    Raises
    ------
    InputError: a file that is included is outside of the folder, missing or not XML, or an element makes
        bodies in a way that is not read.
    """
    return _Writer(document, path, leftovers).write()


class _Writer:
    def __init__(self, document: Document, path: Path | None, leftovers: Leftovers) -> None:
        self._first, self._leftovers = document, leftovers
        self._folder = None if path is None else path.parent.resolve()
        self._included: set[Path] = set() if path is None else {path.resolve()}
        self._handed, self._texts = Handed(), [""]
        self._texts.clear()
        self._meshes = self._elements = 0

    def write(self) -> Handed:
        self._element(self._first.root, self._first, "", 0)
        self._handed.text = "\n".join(self._texts) + "\n"
        return self._handed

    def _line(self, text: str, place: Place) -> None:
        self._texts.append(text)
        self._handed.lines.append(place)

    def _element(self, element: Element, document: Document, parent: str, depth: int) -> None:
        place = document.place(element)
        self._elements += 1
        if depth > DEPTH or self._elements > ELEMENTS:
            raise InputError("with what it includes, the file is too large", where=place)
        attributes = self._attributes(element, document)
        in_default = parent == "default"
        if element.tag in _NAMED and parent in ("body", "frame", "worldbody", "equality"):
            tag = "equality" if parent == "equality" else element.tag.removeprefix("free")
            attributes = {"name": f"{tag}{len(self._handed.places) + 1}"} | attributes
            self._handed.places[tag, attributes["name"]] = place
        elif element.tag == "geom" and not in_default and "mesh" in element.attributes:
            self._meshes += 1
            attributes |= {"name": f"{MESH}{self._meshes}", "type": "sphere", "size": "1"}
        elif element.tag == "geom" and in_default and attributes.get("type") in ("mesh", "hfield", "sdf"):
            del attributes["type"]
        written = "".join(f" {name}={quoteattr(value)}" for name, value in attributes.items())
        self._line(f"<{element.tag}{written}>", place)
        for child, inside in self._children(element, document):
            if child.tag in _REFUSED:
                raise InputError(
                    f"{tag_shown(child)} makes bodies in a way that is not read",
                    where=inside.place(child),
                    expected="<body> for each link",
                    remedy="save the compiled model (mj_saveLastXML) and import that",
                )
            if child.tag in _KEPT and not self._is_left_out(child, element.tag):
                self._element(child, inside, element.tag, depth + 1)
            else:
                what = _WORDS.get(child.tag) or f"{tag_shown(child)} in {tag_shown(element)}"
                self._leftovers.add(what, child.line, inside.file)
        self._line(f"</{element.tag}>", place)

    def _is_left_out(self, child: Element, parent: str) -> bool:
        """Whether an element of a known tag stands where it says nothing of links and joints."""
        if child.tag == "geom" and "hfield" in child.attributes:
            return True
        if child.tag == "site" and parent != "default":
            return "name" not in child.attributes
        if parent == "actuator":
            return "joint" not in child.attributes
        return child.tag == "joint" and parent not in ("body", "frame", "default", "equality")

    def _attributes(self, element: Element, document: Document) -> dict[str, str]:
        kept = _KEPT[element.tag]
        for name in element.attributes:
            if name not in kept and name not in _SILENT and not (element.tag == "geom" and name == "mesh"):
                what = f"{shown(name)} of {tag_shown(element)}"
                self._leftovers.add(what, element.line, document.file)
        return {name: value for name, value in element.attributes.items() if name in kept}

    def _children(self, element: Element, document: Document) -> Iterator[tuple[Element, Document]]:
        """The children, those of included files in the place of their ``<include>``."""
        for child in element.children:
            if child.tag == "include":
                included = self._read(child, document)
                yield from self._children(included.root, included)
            else:
                yield child, document

    def _read(self, include: Element, document: Document) -> Document:
        where = document.place(include, "file")
        name = include.attributes.get("file", "")
        if self._folder is None:
            raise InputError("a text that is no file cannot include others", where=where, found=shown(name))
        try:
            path = (self._folder / name).resolve()
        except (OSError, ValueError, RuntimeError):
            path = self._folder
        if not path.is_relative_to(self._folder) or path == self._folder:
            raise InputError(
                "the file that is included is outside of the folder",
                where=where,
                found=shown(name),
                expected="a file beside this one, or below it",
                remedy="copy it there",
            )
        if path in self._included or len(self._included) > FILES_INCLUDED:
            raise InputError(
                "the file is included twice" if path in self._included else "too many files are included",
                where=where,
                found=shown(name),
            )
        self._included.add(path)
        if not path.is_file():
            raise InputError("the file that is included is not there", where=where, found=shown(name))
        return read(str(path), "MJCF", label(path.relative_to(self._folder)))
