"""SDF to a tree, as http://sdformat.org/spec says, versions 1.4 to 1.12; meshes are not opened."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Final

from robodyn.formats.chain import Body, Pose, Spring, Vector, transposed, turned
from robodyn.formats.elements import Document, Element, tag_shown
from robodyn.formats.limits import GREATEST
from robodyn.formats.quantities import Quantities, body_of, negative, used, what_of
from robodyn.formats.rigid import composed, tidy
from robodyn.formats.sdf_frames import INSIDE, MODEL, WORLD, Frames, Scope
from robodyn.formats.sdf_models import ChosenModel, choose_model
from robodyn.formats.tree import (
    JointLimits,
    Kind,
    Leftovers,
    Mimic,
    Tree,
    TreeJoint,
    TreeLink,
    checked,
)
from robodyn.robot.names import shown

_KINDS: Final[dict[str, Kind]] = {
    "revolute": "revolute",
    "continuous": "continuous",
    "prismatic": "prismatic",
    "fixed": "fixed",
    "ball": "ball",
    "universal": "universal",
    "revolute2": "universal",
    "screw": "screw",
    "gearbox": "other",
}
_POSE: Final = used("relative_to degrees rotation_format")
_USED: Final = {
    "model": used("name placement_frame canonical_link", "link joint frame model pose static"),
    "link": used("name", "inertial pose"),
    "inertial": used("", "pose mass inertia"),
    "inertia": used("", "ixx iyy izz ixy ixz iyz"),
    "joint": used("name type", "pose parent child axis"),
    "axis": used("", "xyz limit dynamics mimic use_parent_model_frame"),
    "xyz": used("expressed_in"),
    "limit": used("", "lower upper effort velocity"),
    "dynamics": used("", "damping friction spring_stiffness spring_reference"),
    "mimic": used("joint", "multiplier offset reference"),
    "frame": used("name attached_to", "pose"),
    "pose": _POSE,
}
_WORDS: Final = {
    "visual": "visual geometry",
    "collision": "collision geometry",
    "sensor": "sensors",
    "plugin": "plugins",
    "material": "materials",
    "self_collide": "settings of the simulation",
    "gravity": "whether a link has weight",
    "physics": "settings of the simulation",
    "light": "lights",
}


def read_tree(document: Document, model: str = "") -> Tree:
    """The tree of a document whose root is ``<sdf>``: that of the model ``model``, by default the only one.

    Of several models it is by default the only one that has joints that move. The world is the tree's root.
    What is in a model in the model is called ``MODEL::NAME``, as the format calls it.

    Raises
    ------
    InputError: something is missing, is no number, stands there twice, or names what is not there; or which
        model is meant is not clear.
    """
    leftovers = Leftovers(document.file)
    reader = _Reader(document, leftovers)
    chosen = choose_model(reader, document.root, model)
    gravity: Vector = (0.0, 0.0, -9.81)
    if chosen.around.tag == "world":
        stated = reader.one(chosen.around, "gravity", "the world")
        gravity = (0.0, 0.0, -9.8) if stated is None else reader.three(stated, "the gravity")
    read = {"world", "model", "gravity", "frame"}
    for part in (document.root, *document.root.all("world")):
        for child in part.children:
            if child.tag not in read:
                leftovers.add(what_of(child, part, _WORDS), child.line)
    return checked(replace(reader.tree(chosen, gravity), remarks=chosen.remarks))


@dataclass(slots=True)
class _Parts:
    """What was read of a model and the models in it; ``static``: whether the model of a link is."""

    links: list[TreeLink] = field(default_factory=list)
    joints: list[TreeJoint] = field(default_factory=list)
    static: dict[str, bool] = field(default_factory=dict)


class _Reader(Quantities):
    def one(self, element: Element, tag: str, of: str) -> Element | None:
        child = super().one(element, tag, of)
        if child is not None and child.tag in _USED:
            self.note_unused(child, _USED, _WORDS)
        return child

    def tree(self, chosen: ChosenModel, gravity: Vector) -> Tree:
        frames = Frames(self, chosen.around, chosen.name)
        parts = _Parts()
        self.model(chosen.model, Scope(frames, chosen.name + INSIDE), parts)
        hung = {joint.child for joint in parts.joints}
        for link in parts.links:
            if link.name not in hung:
                static = parts.static[link.name]
                parts.joints.append(
                    TreeJoint(
                        f"{link.name} ({'static' if static else 'free'})",
                        "fixed" if static else "floating",
                        WORLD,
                        link.name,
                        link.where,
                        frames.pose_in_root(link.name, chosen.model),
                    )
                )
        at = frames.root_in_world(chosen.model)
        joints = [self._in_world(joint, at) for joint in parts.joints]
        world = TreeLink(WORLD, self.place(chosen.model))
        name = self.name(chosen.model, "the model")
        links = (world, *parts.links)
        notes = self.leftovers
        tree = Tree(name, "SDF", self.document.file, links, tuple(joints), gravity, unused=notes.unused())
        return replace(tree, physics=tuple(notes.physics))

    def model(self, model: Element, frames: Scope, parts: _Parts, static: bool = False) -> None:
        """Add what is in a model, and in the models in it, to ``parts``."""
        name = self.name(model, "the model")
        self.note_unused(model, _USED, _WORDS)
        self._note_physics(model, f"model {name}")
        for inner in model.all("include"):
            raise self.fail(
                inner,
                f"{tag_shown(inner)} in a model is not read",
                expected="<link>, <joint> and <model>",
                remedy="put the model itself in its place (gz sdf -p FILE)",
            )
        old = self._version() < (1, 5)
        static = static or ((flag := model.first("static")) is not None and flag.text in ("1", "true"))
        for element in model.all("link"):
            parts.links.append(self.link(element, frames))
            parts.static[parts.links[-1].name] = static
        parts.joints += [self.joint(element, frames, old) for element in model.all("joint")]
        for element in model.all("frame"):
            self._attach(element, frames, parts)
        for element in model.all("model"):
            name = self.name(element, "a model")
            frames.pose(name, element)
            self.model(element, frames.inside(name), parts, static)

    def _attach(self, element: Element, frames: Scope, parts: _Parts) -> None:
        """A frame on a link as a link without body that is fixed to it, so that it can be the tip."""
        name = self.name(element, "a frame")
        self.note_unused(element, _USED, _WORDS)
        link, where = frames.link(name, element), self.place(element)
        pose = tidy(composed(frames.pose_of(link, element).inverse(), frames.pose(name, element)))
        name = frames.name(name)
        parts.links.append(TreeLink(name, where))
        parts.joints.append(TreeJoint(f"{name} (frame)", "fixed", link, name, where, pose))

    @staticmethod
    def _in_world(joint: TreeJoint, at: Pose) -> TreeJoint:
        """A joint to the world, which the model's own pose moves."""
        return replace(joint, origin=composed(at, joint.origin)) if joint.parent == WORLD else joint

    def _version(self) -> tuple[int, ...]:
        text = self.document.root.attributes.get("version", "1.12")
        parts = text.split(".")[:2]
        if not all(part.isascii() and part.isdigit() and len(part) < 4 for part in parts):
            raise self.fail(
                self.document.root, "the version is not one", attribute="version", found=shown(text)
            )
        return tuple(map(int, parts))

    def value(self, parent: Element | None, tag: str, of: str, default: float | None) -> float | None:
        """The number in a child; ``default`` where there is none."""
        child = None if parent is None else self.one(parent, tag, of)
        if child is None:
            return default
        return self.numbers(child.text, 1, child, "", f"{of}: <{tag}>")[0]

    def positive(self, parent: Element | None, tag: str, of: str, default: float = 0.0) -> float:
        """As :meth:`value`, not below 0."""
        value = self.value(parent, tag, of, default)
        assert value is not None
        if parent is not None and negative(value):
            raise self.fail(parent, f"{of}: <{tag}> is negative", found=f"{value:g}")
        return value

    def three(self, element: Element, of: str) -> Vector:
        x, y, z = self.numbers(element.text, 3, element, "", of)
        return (x, y, z)

    def link(self, element: Element, frames: Scope) -> TreeLink:
        name = self.name(element, "a link")
        of = f"link {shown(name)}"
        self.note_unused(element, _USED, _WORDS)
        frames.pose(name, element)
        self._note_physics(element, f"link {name}")
        shape = element.first("visual") is not None or element.first("collision") is not None
        inertial = self.one(element, "inertial", of)
        if inertial is None or inertial.attributes.get("auto", "").strip() in ("1", "true"):
            return TreeLink(frames.name(name), self.place(element), None, shape)
        by_default = inertial.first("mass") is None or inertial.first("inertia") is None
        body = self.body(inertial, frames.frames, of)
        return TreeLink(frames.name(name), self.place(element), body, shape, by_default)

    def _note_physics(self, element: Element, of: str) -> None:
        """Note what of a link changes torques and is not modelled."""
        inertial = element.first("inertial")
        for name, parent, nothing in (
            ("gravity", element, ("1", "true")),
            ("enable_wind", element, ("0", "false")),
            ("velocity_decay", element, ("",)),
            ("fluid_added_mass", inertial, ()),
        ):
            child = None if parent is None else parent.first(name)
            acts = child is not None and child.text.strip() not in nothing
            if name == "velocity_decay" and child is not None:
                acts = any(part.text.strip("0. ") for part in child.children)
            if child is not None and acts:
                self.leftovers.changes_torques(name, of, self.place(child))

    def body(self, inertial: Element, frames: Frames, of: str) -> Body:
        """The numbers that are left out are 1 on the diagonal and 0 beside it, as the format says."""
        mass = self.positive(inertial, "mass", of, 1.0)
        tensor = self.one(inertial, "inertia", of)
        diagonal = [self.value(tensor, key, of, 1.0) or 0.0 for key in ("ixx", "iyy", "izz")]
        beside = [self.value(tensor, key, of, 0.0) or 0.0 for key in ("ixy", "ixz", "iyz")]
        xx, yy, zz, xy, xz, yz = *diagonal, *beside
        return body_of(mass, frames.stated(inertial, of), (xx, yy, zz, xy, xz, yz))

    def joint(self, element: Element, frames: Scope, old: bool) -> TreeJoint:
        name = self.name(element, "a joint")
        of = f"joint {shown(name)}"
        self.note_unused(element, _USED, _WORDS)
        word = self.required(element, "type", of)
        kind = _KINDS.get(word)
        if kind is None:
            raise self.fail(
                element,
                f"{of}: the type is unknown",
                attribute="type",
                found=shown(word),
                expected=", ".join(_KINDS),
            )
        parent, child = (self.end(element, role, frames, of) for role in ("parent", "child"))
        here = frames.pose(name, element)
        before, behind = frames.pose_of(parent, element), frames.pose_of(child, element)
        axis = self.one(element, "axis", of)
        return TreeJoint(
            frames.name(name),
            kind,
            parent,
            child,
            self.place(element),
            tidy(composed(before.inverse(), here)),
            tidy(composed(here.inverse(), behind)),
            self.direction(axis, here, frames, old, of) if axis is not None else (0.0, 0.0, 1.0),
            limits=self.limits(axis, of),
            damping=self.dynamics(axis, "damping", of),
            friction=self.dynamics(axis, "friction", of),
            mimic=self.mimic(axis, frames, of),
            spring=self.spring(axis, of),
        )

    def end(self, joint: Element, role: str, frames: Scope, of: str) -> str:
        """The link of the frame that a joint names as its parent or child."""
        child = self.one(joint, role, of)
        if child is None or not child.text:
            raise self.fail(child or joint, f"{of}: there is no <{role}>")
        return frames.link(child.text, child)

    def direction(self, axis: Element, here: Pose, frames: Scope, old: bool, of: str) -> Vector:
        """The axis in the joint's frame, at ``here`` in the model's."""
        xyz = self.one(axis, "xyz", of)
        if xyz is None:
            return (0.0, 0.0, 1.0)
        vector = self.axis(xyz, self.three(xyz, f"{of}: <xyz>"), "", of)
        flag = axis.first("use_parent_model_frame")
        frame = xyz.attributes.get("expressed_in") or ""
        if not frame and (old or (flag is not None and flag.text in ("1", "true"))):
            frame = MODEL
        if not frame:
            return vector
        rotation = frames.pose(frame, xyz).rotation
        return tidy(Pose(turned(transposed(here.rotation), turned(rotation, vector)))).xyz

    def limits(self, axis: Element | None, of: str) -> JointLimits:
        limit = None if axis is None else self.one(axis, "limit", of)
        if limit is None:
            return JointLimits()
        lower, upper, velocity, effort = (
            self.end_of(limit, tag, of) for tag in ("lower", "upper", "velocity", "effort")
        )
        unlimited = [value if value is not None and value >= 0 else None for value in (velocity, effort)]
        return JointLimits(lower, upper, unlimited[0], None, unlimited[1])

    def end_of(self, limit: Element, tag: str, of: str) -> float | None:
        child = self.one(limit, tag, of)
        if child is None:
            return None
        value = self.limit_text(child.text, child, "", f"{of}: <{tag}>")
        return value if value is not None and abs(value) < GREATEST else None

    def dynamics(self, axis: Element | None, tag: str, of: str) -> float:
        dynamics = None if axis is None else axis.first("dynamics")
        return self.positive(dynamics, tag, of)

    def spring(self, axis: Element | None, of: str) -> Spring | None:
        dynamics = None if axis is None else axis.first("dynamics")
        stiffness, rest = (
            self.value(dynamics, tag, of, 0.0) or 0.0 for tag in ("spring_stiffness", "spring_reference")
        )
        return Spring(stiffness, rest) if stiffness else None

    def mimic(self, axis: Element | None, frames: Scope, of: str) -> Mimic | None:
        mimic = None if axis is None else self.one(axis, "mimic", of)
        if mimic is None:
            return None
        factor, offset, reference = (
            self.value(mimic, tag, of, default) or 0.0
            for tag, default in (("multiplier", 1.0), ("offset", 0.0), ("reference", 0.0))
        )
        leader = frames.name(self.required(mimic, "joint", of))
        return Mimic(leader, factor, offset - factor * reference)
