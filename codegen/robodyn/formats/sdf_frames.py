"""Frames of an SDF file: where links, joints, models and named frames are when all joints are at zero.

The world and each model have names of their own for their frames; from outside it is ``model::frame``. Here
frames are told apart by their names from the world, ``arm::gripper::finger``. Semantics: SDFormat 1.7 and
later, http://sdformat.org/tutorials?tut=pose_frame_semantics.

Which of several models is read is decided here too (:func:`choose_model`).
"""

from __future__ import annotations

import math
from collections.abc import Container, Iterator
from dataclasses import dataclass, replace
from typing import Final

from robodyn.formats.chain import Pose, composed
from robodyn.formats.elements import Element, Quantities
from robodyn.formats.tree import names, near
from robodyn.robot.names import shown

MODEL: Final = "__model__"
WORLD: Final = "world"
INSIDE: Final = "::"


@dataclass(frozen=True, slots=True)
class _Frame:
    """What a file says of a frame: its element, the frame that its pose is relative to, the one that it is
    attached to (a link to itself), and the one of a model that its pose places, by default its own."""

    element: Element
    relative_to: str
    attached_to: str
    placed: str


class Frames:
    """All frames of the models in ``world``, which may be a ``<world>`` or the ``<sdf>`` around a model.

    Poses are those in the model ``root``, whose name is one from the world, as if it stood in the world's
    origin; :meth:`root_in_world` says where it stands.
    """

    def __init__(self, reader: Quantities, world: Element, root: str) -> None:
        self._reader, self._root = reader, root
        self._frames: dict[str, _Frame] = {}
        self._steps: dict[str, Pose] = {}
        self._poses: dict[str, Pose] = {root: Pose(), WORLD: Pose()}
        self._add_all(world, "")

    def _add_all(self, scope: Element, prefix: str) -> None:
        """Add the frames in a model or the world; ``prefix`` is what their names begin with."""
        parent = prefix.removesuffix(INSIDE) or WORLD
        for element in scope.children:
            name = prefix + element.attributes.get("name", "")
            if element.tag == "link":
                self._add(prefix, _Frame(element, parent, name, name))
            elif element.tag == "joint":
                child = element.first("child")
                link = absolute("" if child is None else child.text, prefix)
                self._add(prefix, _Frame(element, link, link, name))
            elif element.tag == "frame":
                to = absolute(element.attributes.get("attached_to") or MODEL, prefix)
                self._add(prefix, _Frame(element, to, to, name))
            elif element.tag == "model":
                inside = name + INSIDE
                placed = absolute(element.attributes.get("placement_frame") or MODEL, inside)
                self._add(prefix, _Frame(element, parent, _canonical_link(element, inside), placed))
                self._add_all(element, inside)

    def _add(self, prefix: str, frame: _Frame) -> None:
        own_name = frame.element.attributes.get("name", "")
        name = prefix + own_name
        if name in self._frames or name.rpartition(INSIDE)[2] in (MODEL, WORLD):
            if not name.startswith(self._root + INSIDE):
                return  # of a model that is not read: the first one counts
            what = "two frames of the model have the same name"
            raise self._reader.fail(frame.element, what, shown(own_name), attribute="name")
        pose = frame.element.first("pose")
        words = {} if pose is None else pose.attributes
        stated = words.get("relative_to") or words.get("frame")  # so called before SDF 1.7
        self._frames[name] = replace(frame, relative_to=absolute(stated, prefix)) if stated else frame

    def pose(self, name: str, asker: Element) -> Pose:
        """The frame ``name`` in the frame of the root; ``asker`` is the element that names it.

        Raises
        ------
        InputError: there is no such frame, or frames are relative to each other in a circle.
        """
        path = self._path(name, asker, self._poses)
        pose = self._poses[self._frames[path[-1]].relative_to if path else name]
        for step in reversed(path):
            pose = self._poses[step] = composed(pose, self._step(step))
        return pose

    def pose_in_root(self, name: str, asker: Element) -> Pose:
        """As :meth:`pose`, of a name from the root."""
        return self.pose(absolute(name, self._root + INSIDE), asker)

    def root_in_world(self, asker: Element) -> Pose:
        """The frame of the root in the world."""
        return self._between(WORLD, self._root, asker)

    def _between(self, outer: str, name: str, asker: Element) -> Pose:
        """The frame ``name`` in the frame ``outer``, which its pose is relative to, or that of another is."""
        pose = Pose()
        for step in reversed(self._path(name, asker, {outer})):
            pose = composed(pose, self._step(step))
        return pose

    def _path(self, name: str, asker: Element, ends: Container[str]) -> list[str]:
        """``name``, the frame that its pose is relative to, and so on; the next one would be in ``ends``."""
        path: dict[str, None] = {}
        while name not in ends:
            if name in path or name not in self._frames:
                circle = "frames are relative to each other in a circle"
                what = circle if name in path else "there is no frame of this name"
                raise self._reader.fail(asker, what, shown(self.name(name)))
            path[name] = None
            asker, name = self._frames[name].element, self._frames[name].relative_to
        return list(path)

    def _step(self, name: str) -> Pose:
        """A frame in the one that its pose is relative to."""
        if name not in self._steps:
            frame = self._frames[name]
            pose = self.stated(frame.element, f"the frame {shown(self.name(name))}")
            if frame.placed != name:
                pose = composed(pose, self._between(name, frame.placed, frame.element).inverse())
            self._steps[name] = pose
        return self._steps[name]

    def link(self, name: str, asker: Element) -> str:
        """The link that the frame ``name`` is attached to, or the world."""
        passed: set[str] = set()
        while name != WORLD and not (name in self._frames and self._frames[name].attached_to == name):
            if name in passed or name not in self._frames:
                what = "there is no link or frame of this name"
                raise self._reader.fail(asker, what, shown(self.name(name)))
            passed.add(name)
            name = self._frames[name].attached_to
        return name

    def name(self, name: str) -> str:
        """``name``, which counts from the world, as it is from the root."""
        return MODEL if name == self._root else name.removeprefix(self._root + INSIDE)

    def stated(self, element: Element, of: str) -> Pose:
        """The ``<pose>`` of an element as written; the identity where there is none."""
        reader, what = self._reader, f"{of}: <pose>"
        pose = reader.one(element, "pose", of)
        if pose is None or not pose.text:
            return Pose()
        rotation = pose.attributes.get("rotation_format", "euler_rpy")
        if rotation == "quat_xyzw":
            x, y, z, *_ = reader.numbers(pose.text, 7, pose, "", what)
            return reader.quaternion(" ".join(pose.text.split()[3:]), pose, "", (x, y, z), what)
        if rotation != "euler_rpy":
            what += ": the format of the rotation is unknown"
            raise reader.fail(pose, what, shown(rotation), "euler_rpy or quat_xyzw", "rotation_format")
        x, y, z, *rpy = reader.numbers(pose.text, 6, pose, "", what)
        if reader.truth(pose.attributes.get("degrees", "0"), pose, "degrees"):
            rpy = [math.radians(angle) for angle in rpy]
        return Pose.from_rpy((x, y, z), rpy)


@dataclass(frozen=True, slots=True)
class Scope:
    """The frames as a model sees them whose frames' names begin with ``prefix``."""

    frames: Frames
    prefix: str

    def pose(self, name: str, asker: Element) -> Pose:
        """As :meth:`Frames.pose`, of a name in this model."""
        return self.frames.pose(absolute(name, self.prefix), asker)

    def link(self, name: str, asker: Element) -> str:
        """The link that a frame of this model is attached to, or the world; its name is one from the root."""
        return self.frames.name(self.frames.link(absolute(name, self.prefix), asker))

    def pose_of(self, link: str, asker: Element) -> Pose:
        """As :meth:`pose`, of a link that :meth:`link` answered."""
        return self.frames.pose_in_root(link, asker)

    def name(self, name: str) -> str:
        """What is called ``name`` in this model, as it is from the root."""
        return self.frames.name(absolute(name, self.prefix))

    def inside(self, model: str) -> Scope:
        """As the model of that name in this one sees them."""
        return Scope(self.frames, f"{self.prefix}{model}{INSIDE}")


def absolute(name: str, prefix: str) -> str:
    """The frame that is called ``name`` in the scope whose frames begin with ``prefix``, from the world."""
    if name == WORLD:
        return WORLD
    if name == MODEL:
        return prefix.removesuffix(INSIDE) or WORLD
    return (prefix + name).removesuffix(INSIDE + MODEL)


def _canonical_link(model: Element, prefix: str) -> str:
    """The link that stands for a model: the one that it names, else its first one, else its first model's."""
    if stated := model.attributes.get("canonical_link"):
        return absolute(stated, prefix)
    if link := model.first("link"):
        return prefix + link.attributes.get("name", "")
    inner = model.first("model")
    return (
        prefix
        if inner is None
        else _canonical_link(inner, prefix + inner.attributes.get("name", "") + INSIDE)
    )


@dataclass(frozen=True, slots=True)
class ChosenModel:
    """A model, its name from the world, the ``<world>`` or ``<sdf>`` that it is in, and why it was chosen."""

    model: Element
    name: str
    around: Element
    remarks: tuple[str, ...] = ()


def choose_model(reader: Quantities, root: Element, name: str = "") -> ChosenModel:
    """The model of that name, which may be one in another, ``OUTER::INNER``; without a name the only one that
    there is, or else the only one that has joints that move: a floor is no arm.

    Raises
    ------
    InputError: there is none, or several of which any could be meant.
    """
    models = [
        ChosenModel(model, model.attributes.get("name", "?"), around)
        for around in (root, *root.all("world"))
        for model in around.all("model")
    ]
    if not models:
        raise reader.fail(root, "the file has no model", expected="<model>")
    if name:
        inside = [each for model in models for each in _with_models_inside(model)]
        matches = [each for each in inside if each.name == name]
        if not matches:
            expected = near(name, (each.name for each in inside), "model")
            raise reader.fail(root, "there is no model of that name", shown(name), expected)
        if len(matches) > 1:
            raise reader.fail(matches[1].model, "two models have that name", shown(name))
        return matches[0]
    arms = [each for each in models if _has_joints_that_move(reader, each.model)]
    if len(models) > 1 and len(arms) != 1:
        found, expected = names(each.name for each in models), "one, or one whose joints move"
        remedy = "choose one with --model NAME (from Python: model=NAME)"
        raise reader.fail(models[1].model, "the file has several models", found, expected, remedy=remedy)
    if len(models) == 1:
        return models[0]
    (arm,) = arms
    others = names(each.name for each in models if each is not arm)
    remark = f"the model {shown(arm.name)} is read, the only one with joints that move; not read: {others}"
    return replace(arm, remarks=(remark,))


def _with_models_inside(chosen: ChosenModel) -> Iterator[ChosenModel]:
    yield chosen
    for model in chosen.model.all("model"):
        name = f"{chosen.name}{INSIDE}{model.attributes.get('name', '?')}"
        yield from _with_models_inside(ChosenModel(model, name, chosen.around))


def _has_joints_that_move(reader: Quantities, model: Element) -> bool:
    static = model.first("static")
    if static is not None and reader.truth(static.text, static):
        return False
    return any(each.tag == "joint" and each.attributes.get("type") != "fixed" for each in model.walk())
