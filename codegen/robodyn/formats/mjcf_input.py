"""What MuJoCo is given of an MJCF file: its text, what of it stands where in the files, what its default
classes say, and which files it may include or attach."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.formats.elements import Document, Element, read
from robodyn.formats.limits import FILES_INCLUDED
from robodyn.robot.names import shown

MESH: Final = "robodyn mesh "
"""Begins the name of a geom that was a mesh: a ball stands for it and is deleted before the model is made."""
_MESH_NUMBER: Final = re.compile(f"{MESH}(\\d+);")
_TRACKED: Final = {"geom": ("type", "mesh", "hfield"), "equality": ("active",)}


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
class ModelText:
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
        is_line = hit and 0 < int(hit.group(1)) <= len(self.lines)
        return self.lines[int(hit.group(1)) - 1] if hit and is_line else Place(file)

    def place_of(self, tag: str, name: str, file: str) -> Place:
        """The place of what has that name; a replica has the name of what it repeats, and more behind it."""
        ends = (name[:length] for length in range(len(name), 0, -1))
        return next((self.places[tag, end] for end in ends if (tag, end) in self.places), Place(file))

    def rules_of(self, geom: str) -> InertiaRules | None:
        """Those of a geom that stands for a mesh; None for any other."""
        hit = _MESH_NUMBER.search(geom)
        return self.rules[int(hit.group(1))] if hit else None


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


class Files:
    """The files beside the MJCF file ``top`` and below it, and those in ``folders``; None: no file at all."""

    def __init__(self, top: Path | None, folders: Iterable[str] = ()) -> None:
        self._roots = (
            [] if top is None else [top.parent.resolve(), *(Path(each).resolve() for each in folders)]
        )
        self._count = 0

    def read(self, element: Element, document: Document, folders: Iterable[Path]) -> tuple[Document, Path]:
        """The document that ``file`` of ``element`` names, and its path.

        ``folders``: a relative path counts from the first of them in which there is such a file. As in
        MuJoCo they are the folder of the model's own file, and that of the file in which ``element`` stands.

        Raises
        ------
        InputError: it is outside of the folders that may be read, missing, one too many or not XML.
        """
        where, name = document.place(element, "file"), element.attributes.get("file", "")
        if not self._roots:
            raise InputError("a text that is no file cannot include others", where=where, found=shown(name))
        for folder in dict.fromkeys(folders):
            try:
                path = (folder / name).resolve()
            except (OSError, ValueError, RuntimeError):
                path = folder
            if not any(path.is_relative_to(root) and path != root for root in self._roots):
                raise InputError(
                    "the file that is included is outside of the folder",
                    where=where,
                    found=shown(name),
                    expected="a file beside this one, or below it",
                    remedy="copy it there, or state the folder that may be read: --arg 'find NAME=FOLDER'",
                )
            if path.is_file():
                break
        else:
            raise InputError("the file that is included is not there", where=where, found=shown(name))
        self._count += 1
        if self._count > FILES_INCLUDED:
            raise InputError("too many files are included", where=where, found=shown(name))
        return read(str(path), "MJCF", label(os.path.relpath(path, self._roots[0]))), path
