"""Frames of an SDF model: where links, joints and named frames are at the zero position of all joints."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from robodyn.formats.chain import Pose
from robodyn.formats.elements import Element
from robodyn.formats.quantities import Quantities
from robodyn.formats.rigid import composed
from robodyn.robot.names import shown

MODEL: Final = "__model__"
WORLD: Final = "world"


@dataclass(frozen=True, slots=True)
class _Frame:
    """What a file says of a frame: its element, what its pose is relative to by default, and what it is
    attached to (a link to itself)."""

    element: Element
    relative_to: str
    attached_to: str


class Frames:
    """All frames of one model."""

    def __init__(self, reader: Quantities, model: Element) -> None:
        self._reader = reader
        self._frames: dict[str, _Frame] = {}
        self._poses: dict[str, Pose] = {MODEL: Pose(), WORLD: Pose()}
        for element in model.children:
            name = element.attributes.get("name", "")
            if element.tag == "link":
                self._add(name, _Frame(element, MODEL, name))
            elif element.tag == "joint":
                child = element.first("child")
                link = "" if child is None else child.text
                self._add(name, _Frame(element, link, link))
            elif element.tag == "frame":
                to = element.attributes.get("attached_to") or MODEL
                self._add(name, _Frame(element, to, to))

    def _add(self, name: str, frame: _Frame) -> None:
        if name in self._frames or name in self._poses:
            raise self._reader.fail(
                frame.element,
                "two frames of the model have the same name",
                attribute="name",
                found=shown(name),
            )
        self._frames[name] = frame

    def pose(self, name: str, asker: Element) -> Pose:
        """The frame ``name`` in the model's frame; ``asker`` is the element that names it.

        Raises
        ------
        InputError: there is no such frame, or frames are relative to each other in a circle.
        """
        waiting: list[str] = []
        while name not in self._poses:
            if name in waiting or name not in self._frames:
                circle = "frames are relative to each other in a circle"
                what = circle if name in waiting else "there is no frame of this name"
                raise self._reader.fail(asker, what, found=shown(name))
            waiting.append(name)
            asker, name = self._frames[name].element, self._relative_to(name)
        pose = self._poses[name]
        for name in reversed(waiting):
            pose = composed(pose, self.stated(self._frames[name].element, f"the frame {shown(name)}"))
            self._poses[name] = pose
        return pose

    def is_on_model(self, name: str) -> bool:
        """Whether the frame ``name`` is attached to the model itself, or to the world, and to no link."""
        seen: set[str] = set()
        while name in self._frames and name not in seen:
            seen.add(name)
            name = self._frames[name].attached_to
        return name in (MODEL, WORLD)

    def link(self, name: str, asker: Element) -> str:
        """The link that the frame ``name`` is attached to, or the world."""
        seen: set[str] = set()
        while name != WORLD and not (name in self._frames and self._frames[name].attached_to == name):
            if name in seen or name not in self._frames:
                raise self._reader.fail(asker, "there is no link or frame of this name", found=shown(name))
            seen.add(name)
            name = self._frames[name].attached_to
            if name == MODEL:
                raise self._reader.fail(asker, "a frame of the model is no link", found=shown(name))
        return name

    def stated(self, element: Element, of: str) -> Pose:
        """The ``<pose>`` of an element as written; the identity where there is none."""
        pose = self._reader.one(element, "pose", of)
        if pose is None or not pose.text:
            return Pose()
        what = f"{of}: <pose>"
        if pose.attributes.get("rotation_format", "euler_rpy") == "quat_xyzw":
            x, y, z, i, j, k, w = self._reader.numbers(pose.text, 7, pose, "", what)
            try:
                return Pose.from_quaternion((x, y, z), (w, i, j, k))
            except ValueError:
                raise self._reader.fail(
                    pose, f"{what}: the quaternion is zero", found=shown(pose.text)
                ) from None
        x, y, z, *rpy = self._reader.numbers(pose.text, 6, pose, "", what)
        if pose.attributes.get("degrees", "").strip() in ("1", "true"):
            import math

            rpy = [math.radians(angle) for angle in rpy]
        return Pose.from_rpy((x, y, z), rpy)

    def _relative_to(self, name: str) -> str:
        frame = self._frames[name]
        pose = frame.element.first("pose")
        return (pose.attributes.get("relative_to") if pose is not None else None) or frame.relative_to
