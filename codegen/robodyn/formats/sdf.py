"""SDF to a tree, as http://sdformat.org/spec says, versions 1.4 to 1.12; meshes are not opened."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Final

from robodyn.errors import Place
from robodyn.formats.chain import Body, Pose, Spring, Vector, transposed, turned
from robodyn.formats.elements import Document, Element
from robodyn.formats.elements_of import table_of
from robodyn.formats.limits import GREATEST, NAMES_SHOWN
from robodyn.formats.quantities import Quantities, body_of, negative
from robodyn.formats.rigid import composed, tidy
from robodyn.formats.sdf_frames import INSIDE, MODEL, WORLD, ChosenModel, Frames, Scope, choose_model
from robodyn.formats.tree import (
    JointLimits,
    Kind,
    Leftovers,
    Mimic,
    Tree,
    TreeJoint,
    TreeLink,
    checked,
    names,
)
from robodyn.formats.unread import Unread
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
        physics = chosen.around.first("physics")  # it holds gravity in SDF 1.4 and 1.5
        stated = reader.one(chosen.around, "gravity", "the world") or (physics and physics.first("gravity"))
        gravity = (0.0, 0.0, -9.8) if stated is None else reader.three(stated, "the gravity")
    unread = Unread(table_of("SDF"), leftovers, document.place)
    unread.note(_without_others(document.root, chosen), (document.root.tag,))
    tree = reader.tree(chosen, gravity)
    return checked(replace(tree, remarks=(*chosen.remarks, *tree.remarks)))


def _without_others(element: Element, chosen: ChosenModel) -> Element:
    """``element``, in which the chosen model is, without the models around and beside that one."""
    if element is chosen.model:
        return element
    children = [
        _without_others(child, chosen) if any(each is chosen.model for each in child.walk()) else child
        for child in element.children
        if child.tag not in ("model", "world") or any(each is chosen.model for each in child.walk())
    ]
    inside = [child for child in children if child.tag == "model"]
    return replace(element, children=tuple(inside if element.tag == "model" else children))


@dataclass(slots=True)
class _Parts:
    """What was read of a model and the models in it; ``static``: whether the model of a link is;
    ``weightless``: where it says that a link has no weight."""

    links: list[TreeLink] = field(default_factory=list)
    joints: list[TreeJoint] = field(default_factory=list)
    static: dict[str, bool] = field(default_factory=dict)
    weightless: dict[str, Place] = field(default_factory=dict)


def _moves(link: str, above: dict[str, TreeJoint]) -> bool:
    """Whether a joint moves the ``link``; one that is free is the base, which does not move."""
    passed: set[str] = set()
    while link in above and link not in passed:
        passed.add(link)
        if above[link].kind not in ("fixed", "floating"):
            return True
        link = above[link].parent
    return False


class _Reader(Quantities):
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
        links = (world, *parts.links)
        notes = self.leftovers
        above = {joint.child: joint for joint in joints}
        for name, where in parts.weightless.items():
            if any(gravity) and _moves(name, above):
                notes.changes_torques("gravity", f"link {name}", where)
        name = self.name(chosen.model, "the model")
        tree = Tree(name, "SDF", self.document.file, links, tuple(joints), gravity, unused=notes.unused())
        defaults = [link.name for link in parts.links if link.assumed and _moves(link.name, above)]
        words = "not stated, and by the format 1 kg or 1 kg m^2"
        remarks = (f"{words}: {names(defaults, NAMES_SHOWN)}",) if defaults else ()
        return replace(tree, physics=tuple(notes.physics), remarks=remarks)

    def model(self, model: Element, frames: Scope, parts: _Parts, static: bool = False) -> None:
        """Add what is in a model, and in the models in it, to ``parts``."""
        name = self.name(model, "the model")
        old = self._version() < (1, 5)
        static = static or ((flag := model.first("static")) is not None and self.truth(flag.text, flag))
        for element in model.all("link"):
            parts.links.append(self.link(element, frames))
            link = parts.links[-1].name
            parts.static[link] = static
            weight = element.first("gravity")
            if weight is not None and not self.truth(weight.text, weight):
                parts.weightless[link] = self.place(weight)
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

    def positive(self, parent: Element | None, tag: str, of: str) -> float | None:
        """The number in a child, not below 0; None where there is none."""
        value = self.value(parent, tag, of, None)
        if parent is not None and value is not None and negative(value):
            raise self.fail(parent, f"{of}: <{tag}> is negative", found=f"{value:g}")
        return value

    def three(self, element: Element, of: str) -> Vector:
        x, y, z = self.numbers(element.text, 3, element, "", of)
        return (x, y, z)

    def link(self, element: Element, frames: Scope) -> TreeLink:
        name = self.name(element, "a link")
        of = f"link {shown(name)}"
        frames.pose(name, element)
        shape = element.first("visual") is not None or element.first("collision") is not None
        inertial = self.one(element, "inertial", of)
        if inertial is not None and self.truth(inertial.attributes.get("auto", "0"), inertial, "auto"):
            return TreeLink(frames.name(name), self.place(element), None, True)
        by_default = inertial is None or inertial.first("mass") is None or inertial.first("inertia") is None
        body = self.body(inertial, frames.frames, of)
        return TreeLink(frames.name(name), self.place(element), body, shape, by_default)

    def body(self, inertial: Element | None, frames: Frames, of: str) -> Body:
        """The numbers that are left out are 1 on the diagonal and 0 beside it, as the format says."""
        stated = self.positive(inertial, "mass", of)
        mass = 1.0 if stated is None else stated
        tensor = None if inertial is None else self.one(inertial, "inertia", of)
        diagonal = [self.value(tensor, key, of, 1.0) or 0.0 for key in ("ixx", "iyy", "izz")]
        beside = [self.value(tensor, key, of, 0.0) or 0.0 for key in ("ixy", "ixz", "iyz")]
        xx, yy, zz, xy, xz, yz = *diagonal, *beside
        pose = Pose() if inertial is None else frames.stated(inertial, of)
        where = None if inertial is None else inertial.first("pose")
        if where is not None and where.attributes.get("relative_to"):
            what = f"{of}: the pose of <inertial> is in the link's frame"
            raise self.fail(where, what, attribute="relative_to", remedy="leave relative_to out")
        return body_of(mass, pose, (xx, yy, zz, xy, xz, yz))

    def joint(self, element: Element, frames: Scope, old: bool) -> TreeJoint:
        name = self.name(element, "a joint")
        of = f"joint {shown(name)}"
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
        rotor, ratio = (
            self.value(element, tag, of, None) for tag in ("drake:rotor_inertia", "drake:gear_ratio")
        )
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
            armature=None if rotor is None else rotor * (ratio or 1.0) ** 2,
            ratio=None if ratio in (0.0, 1.0) else ratio,
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
        if not frame and (old if flag is None else self.truth(flag.text, flag)):
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

    def dynamics(self, axis: Element | None, tag: str, of: str) -> float | None:
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
