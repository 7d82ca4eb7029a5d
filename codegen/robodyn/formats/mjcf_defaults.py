"""Default classes, as MuJoCo resolves them: whether a geom is a mesh may stand in its class only."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from robodyn.formats.elements import Element

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
