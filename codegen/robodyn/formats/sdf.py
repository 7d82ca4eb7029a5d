"""SDF to a tree, as http://sdformat.org/spec says, versions 1.4 to 1.12; meshes are not opened."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from robodyn.errors import Place
from robodyn.formats.chain import Body, Pose, Spring, Vector, body_of, composed, tidy, transposed, turned
from robodyn.formats.elements import Document, Element, Quantities
from robodyn.formats.elements_of import Unread, table_of
from robodyn.formats.limits import GREATEST
from robodyn.formats.sdf_frames import INSIDE, MODEL, WORLD, ChosenModel, Frames, Scope, choose_model
from robodyn.formats.tree import JointLimits, Leftovers, Mimic, Tree, TreeJoint, TreeLink, checked, names
from robodyn.robot.names import shown

_KINDS: Final = {
    **{kind: kind for kind in ("revolute", "continuous", "prismatic", "fixed", "ball", "universal")},
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
    chosen = choose_model(Quantities(document, leftovers), document.root, model)
    root = _without_others(document.root, chosen)
    Unread(table_of("SDF"), leftovers, document.place).note(root)
    return checked(_Reader(document, leftovers, chosen).tree())


def _without_others(element: Element, chosen: ChosenModel) -> Element:
    """``element``, in which the chosen model is, without the models around and beside that one."""
    if element is chosen.model:
        return element
    children = []
    for child in element.children:
        if any(each is chosen.model for each in child.walk()):
            children.append(_without_others(child, chosen))
        elif child.tag not in ("model", "world") and element.tag != "model":
            children.append(child)
    return replace(element, children=tuple(children))


class _Reader(Quantities):
    """Reads the chosen model and the models in it."""

    def __init__(self, document: Document, leftovers: Leftovers, chosen: ChosenModel) -> None:
        super().__init__(document, leftovers)
        self.chosen, self.frames = chosen, Frames(self, chosen.around, chosen.name)
        self.links: list[TreeLink] = []
        self.joints: list[TreeJoint] = []
        self.static: set[str] = set()
        self.weightless: dict[str, Place] = {}
        version = document.root.attributes.get("version", "1.12")
        parts = version.split(".")[:2]
        if not all(part.isascii() and part.isdigit() and len(part) < 4 for part in parts):
            raise self.fail(document.root, "the version is not one", shown(version), attribute="version")
        self.is_old = tuple(map(int, parts)) < (1, 5)

    def tree(self) -> Tree:
        chosen = self.chosen
        gravity = self.gravity()
        self.model(chosen.model, Scope(self.frames, chosen.name + INSIDE), False)
        hung = {joint.child for joint in self.joints}
        for link in self.links:
            if link.name not in hung:
                word, kind = ("static", "fixed") if link.name in self.static else ("free", "floating")
                pose = self.frames.pose_in_root(link.name, chosen.model)
                name = f"{link.name} ({word})"
                self.joints.append(TreeJoint(name, kind, WORLD, link.name, link.where, pose))
        # The model's own pose moves the joints to the world.
        at = self.frames.root_in_world(chosen.model)
        joints = [
            replace(joint, origin=composed(at, joint.origin)) if joint.parent == WORLD else joint
            for joint in self.joints
        ]
        above = {joint.child: joint for joint in joints}
        for name, where in self.weightless.items():
            if any(gravity) and _moves(name, above):
                self.leftovers.changes_torques("gravity", f"link {name}", where)
        defaults = [link.name for link in self.links if link.assumed and _moves(link.name, above)]
        words = "not stated, and by the format 1 kg or 1 kg m^2"
        return Tree(
            self.name(chosen.model, "the model"),
            "SDF",
            self.document.file,
            (TreeLink(WORLD, self.place(chosen.model)), *self.links),
            tuple(joints),
            gravity,
            unused=self.leftovers.unused(),
            remarks=(*chosen.remarks, *([f"{words}: {names(defaults)}"] if defaults else [])),
            physics=tuple(self.leftovers.physics),
        )

    def gravity(self) -> Vector:
        """That of the world around the model; in SDF 1.4 and 1.5 its physics hold it."""
        around = self.chosen.around
        if around.tag != "world":
            return (0.0, 0.0, -9.81)
        physics = around.first("physics")
        stated = self.one(around, "gravity", "the world") or (physics and physics.first("gravity"))
        return self.three(stated, "the gravity") if stated else (0.0, 0.0, -9.8)

    def model(self, model: Element, scope: Scope, static: bool) -> None:
        """Add what is in a model, and in the models in it."""
        self.name(model, "the model")
        static = static or ((flag := model.first("static")) is not None and self.truth(flag.text, flag))
        for element in model.all("link"):
            self.links.append(self.link(element, scope))
            link = self.links[-1].name
            self.static.update([link] if static else [])
            weight = element.first("gravity")
            if weight is not None and not self.truth(weight.text, weight):
                self.weightless[link] = self.place(weight)
        self.joints += [self.joint(element, scope) for element in model.all("joint")]
        for element in model.all(
            "frame"
        ):  # a link without body that is fixed to one, so that it can be the tip
            name, where = self.name(element, "a frame"), self.place(element)
            link = scope.link(name, element)
            pose = tidy(composed(scope.pose_of(link, element).inverse(), scope.pose(name, element)))
            name = scope.name(name)
            self.links.append(TreeLink(name, where))
            self.joints.append(TreeJoint(f"{name} (frame)", "fixed", link, name, where, pose))
        for element in model.all("model"):
            name = self.name(element, "a model")
            scope.pose(name, element)
            self.model(element, scope.inside(name), static)

    def value(self, parent: Element | None, tag: str, of: str, least: float | None = None) -> float | None:
        """The number in a child, not below ``least``; None where there is none."""
        child = self.one(parent, tag, of)
        if child is None or parent is None:
            return None
        (value,) = self.numbers(child.text, 1, child, "", f"{of}: <{tag}>")
        if least is not None and value < least:
            raise self.fail(parent, f"{of}: <{tag}> is negative", f"{value:g}")
        return value

    def values(self, parent: Element | None, tags: str, of: str, default: float = 0.0) -> list[float]:
        """The numbers in several children, ``default`` where there is none."""
        stated = [self.value(parent, tag, of) for tag in tags.split()]
        return [default if value is None else value for value in stated]

    def three(self, element: Element, of: str) -> Vector:
        x, y, z = self.numbers(element.text, 3, element, "", of)
        return (x, y, z)

    def link(self, element: Element, scope: Scope) -> TreeLink:
        name = self.name(element, "a link")
        of = f"link {shown(name)}"
        scope.pose(name, element)
        shape = element.first("visual") is not None or element.first("collision") is not None
        inertial = self.one(element, "inertial", of)
        if inertial is not None and self.truth(inertial.attributes.get("auto", "0"), inertial, "auto"):
            return TreeLink(scope.name(name), self.place(element), None, True)
        by_default = inertial is None or inertial.first("mass") is None or inertial.first("inertia") is None
        return TreeLink(scope.name(name), self.place(element), self.body(inertial, of), shape, by_default)

    def body(self, inertial: Element | None, of: str) -> Body:
        """The numbers that are left out are 1 on the diagonal and 0 beside it, as the format says."""
        mass = self.value(inertial, "mass", of, least=0)
        tensor = self.one(inertial, "inertia", of)
        xx, yy, zz = self.values(tensor, "ixx iyy izz", of, 1.0)
        xy, xz, yz = self.values(tensor, "ixy ixz iyz", of)
        pose = Pose() if inertial is None else self.frames.stated(inertial, of)
        where = None if inertial is None else inertial.first("pose")
        if where is not None and where.attributes.get("relative_to"):
            what, remedy = f"{of}: the pose of <inertial> is in the link's frame", "leave relative_to out"
            raise self.fail(where, what, attribute="relative_to", remedy=remedy)
        return body_of(1.0 if mass is None else mass, pose, (xx, yy, zz, xy, xz, yz))

    def joint(self, element: Element, scope: Scope) -> TreeJoint:
        name = self.name(element, "a joint")
        of = f"joint {shown(name)}"
        kind = self.kind(element, of, _KINDS)
        ends: list[str] = []
        for role in ("parent", "child"):
            end = self.one(element, role, of)
            if end is None or not end.text:
                raise self.fail(end or element, f"{of}: there is no <{role}>")
            ends.append(scope.link(end.text, end))
        here = scope.pose(name, element)
        (parent, child), (before, behind) = ends, (scope.pose_of(end, element) for end in ends)
        axis = self.one(element, "axis", of)
        dynamics = None if axis is None else axis.first("dynamics")
        rotor, ratio = (self.value(element, tag, of) for tag in ("drake:rotor_inertia", "drake:gear_ratio"))
        stiffness, rest = self.values(dynamics, "spring_stiffness spring_reference", of)
        return TreeJoint(
            scope.name(name),
            kind,
            parent,
            child,
            self.place(element),
            tidy(composed(before.inverse(), here)),
            tidy(composed(here.inverse(), behind)),
            self.direction(axis, here, scope, of),
            limits=self.limits(axis, of),
            damping=self.value(dynamics, "damping", of, least=0),
            friction=self.value(dynamics, "friction", of, least=0),
            armature=None if rotor is None else rotor * (ratio or 1.0) ** 2,
            ratio=None if ratio in (0.0, 1.0) else ratio,
            mimic=self.mimic(axis, scope, of),
            spring=Spring(stiffness, rest) if stiffness else None,
        )

    def direction(self, axis: Element | None, here: Pose, scope: Scope, of: str) -> Vector:
        """The axis in the joint's frame, at ``here`` in the model's."""
        xyz = self.one(axis, "xyz", of)
        if axis is None or xyz is None:
            return (0.0, 0.0, 1.0)
        vector = self.axis(xyz, self.three(xyz, f"{of}: <xyz>"), "", of)
        flag = axis.first("use_parent_model_frame")
        frame = xyz.attributes.get("expressed_in") or ""
        if not frame and (self.is_old if flag is None else self.truth(flag.text, flag)):
            frame = MODEL
        if not frame:
            return vector
        rotation = scope.pose(frame, xyz).rotation
        return tidy(Pose(turned(transposed(here.rotation), turned(rotation, vector)))).xyz

    def limits(self, axis: Element | None, of: str) -> JointLimits:
        limit = self.one(axis, "limit", of)
        ends: dict[str, float | None] = {}
        for tag in ("lower", "upper", "velocity", "effort"):
            child = self.one(limit, tag, of)
            value = None if child is None else self.limit(child.text, child, "", f"{of}: <{tag}>")
            least = -GREATEST if tag in ("lower", "upper") else 0.0
            ends[tag] = value if value is not None and least <= value and abs(value) < GREATEST else None
        return JointLimits(**ends)

    def mimic(self, axis: Element | None, scope: Scope, of: str) -> Mimic | None:
        mimic = self.one(axis, "mimic", of)
        if mimic is None:
            return None
        (factor,) = self.values(mimic, "multiplier", of, 1.0)
        offset, reference = self.values(mimic, "offset reference", of)
        leader = scope.name(self.required(mimic, "joint", of))
        return Mimic(leader, factor, offset - factor * reference)


def _moves(link: str, above: dict[str, TreeJoint]) -> bool:
    """Whether a joint moves the ``link``; one that is free is the base, which does not move."""
    passed: set[str] = set()
    while link in above and link not in passed:
        passed.add(link)
        if above[link].kind not in ("fixed", "floating"):
            return True
        link = above[link].parent
    return False
