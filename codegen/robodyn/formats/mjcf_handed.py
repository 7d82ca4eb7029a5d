"""What MuJoCo is given of an MJCF file, what of it stands where in the files, and what its default classes
say: whether a geom is a mesh may stand in its class only."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from robodyn.errors import Place
from robodyn.formats.elements import Element

MESH: Final = "robodyn mesh "
"""Begins the name of a geom that was a mesh: a ball stands for it and is deleted before the model is made."""
_ZERO: Final = re.compile(r"[+-]?0*\.?0*([eE].*)?")
_MESH_NUMBER: Final = re.compile(f"{MESH}(\\d+);")


_NAMES: Final = re.compile(r"name|(child)?class|model|prefix|file|(joint|body|site)\d?")
"""Attributes whose words are names: one may be called "nan"."""


@dataclass(slots=True)
class InertiaRules:
    """What a model's ``<compiler>`` says of bodies that have both an inertia and shapes."""

    always_from_shapes: bool = False
    groups: tuple[int, int] = (0, 5)

    def read(self, compiler: Mapping[str, str]) -> None:
        """Take over what the attributes of a ``<compiler>`` say; what is wrong with them MuJoCo tells."""
        if "inertiafromgeom" in compiler:
            self.always_from_shapes = compiler["inertiafromgeom"] == "true"
        if groups := re.findall(r"[+-]?\d+", compiler.get("inertiagrouprange", "")):
            self.groups = (int(groups[0]), int(groups[-1]))


@dataclass(slots=True)
class Handed:
    """The text for MuJoCo, a line an element, and the place in the files of each of its lines.

    ``models``: texts of the models that it attaches, by the name of the file that it has for them; their
    lines are counted on from those of the text before. ``places``: those of bodies, joints and equalities by
    tag and name. What has no name has one here. ``rules``: of the meshes, by their numbers. ``settings``:
    place, name and text of what ``<option>`` and ``<flag>`` say. ``tendons``: places of active equations
    between tendons, with their words. ``warnings``: of files that are included.
    """

    text: str = ""
    models: dict[str, str] = field(default_factory=dict)
    lines: list[Place] = field(default_factory=list)
    places: dict[tuple[str, str], Place] = field(default_factory=dict)
    rules: list[InertiaRules] = field(default_factory=list)
    settings: list[tuple[Place, str, str]] = field(default_factory=list)
    tendons: list[tuple[Place, str]] = field(default_factory=list)
    warnings: list[tuple[Place, str]] = field(default_factory=list)

    def place(self, message: str, file: str) -> Place:
        """The place that a message of MuJoCo means by ``line 12``; the file if it names none."""
        hit = re.search(r"line (\d{1,9})", message)
        if hit and 0 < int(hit.group(1)) <= len(self.lines):
            return self.lines[int(hit.group(1)) - 1]
        return Place(file)

    def place_of(self, tag: str, name: str, file: str) -> Place:
        """The place of what has that name; a replica has the name of what it repeats, and more behind it."""
        ends = (name[:length] for length in range(len(name), 0, -1))
        return next((self.places[tag, end] for end in ends if (tag, end) in self.places), Place(file))

    def rules_of(self, geom: str) -> InertiaRules | None:
        """Those of a geom that stands for a mesh; None for any other."""
        hit = _MESH_NUMBER.search(geom)
        return self.rules[int(hit.group(1))] if hit else None


def names_of_nan(attributes: Mapping[str, str]) -> list[str]:
    """The names of those ``attributes`` among whose numbers is one that is none."""
    return [
        name
        for name, value in attributes.items()
        if not _NAMES.fullmatch(name) and any(word.strip("+-").lower() == "nan" for word in value.split())
    ]


def has_rotor(actuator: Element) -> bool:
    """Whether an actuator, or a default class of one, has inertia or damping."""
    words = " ".join(actuator.attributes.get(name, "") for name in ("armature", "damping"))
    return any(_ZERO.fullmatch(word) is None for word in words.split())


_TRACKED: Final = {"geom": ("type", "mesh", "hfield"), "equality": ("active",)}


class Classes:
    """What the default classes of one model say of the shapes of geoms, and whether equations are active.

    A class begins as a copy of the class around it, as that is when it comes: MuJoCo reads what a class says
    itself before the classes in it.
    """

    def __init__(self) -> None:
        self._values: dict[str, dict[str, str]] = {}
        self._root = "main"

    def read(self, default: Element) -> None:
        """Read a ``<default>`` of the model itself."""
        self._root = default.attributes.get("class", self._root)
        self._read(default, self._root, self._values.get(self._root, {}))

    def _read(self, default: Element, name: str, around: Mapping[str, str]) -> None:
        values = self._values[name] = dict(around)
        for tag, keys in _TRACKED.items():
            for stated in default.all(tag):
                values.update((key, stated.attributes[key]) for key in keys if key in stated.attributes)
        for inner in default.all("default"):
            self._read(inner, inner.attributes.get("class", ""), values)

    def of(self, element: Element, childclass: str = "") -> Mapping[str, str]:
        """Attributes of a geom in a body with that ``childclass``, or of an equation; of what it leaves to
        its class those above."""
        name = element.attributes.get("class") or childclass or self._root
        return {**self._values.get(name, {}), **element.attributes}


def is_mesh(attributes: Mapping[str, str]) -> bool:
    """Whether a geom takes its size from a mesh: it is one, or a shape that is fitted to one."""
    return "mesh" in attributes or attributes.get("type") in ("mesh", "sdf")


def is_height_field(attributes: Mapping[str, str]) -> bool:
    """Whether a geom is a height field."""
    return "hfield" in attributes or attributes.get("type") == "hfield"
