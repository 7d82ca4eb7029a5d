"""URDF to a tree, as http://wiki.ros.org/urdf/XML and urdfdom read it; meshes are not opened.

Of transmissions the reduction of a gear and the rotor behind it are read.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from robodyn.formats.chain import Body, Pose, body_of
from robodyn.formats.elements import Document, Element, Quantities, tag_shown
from robodyn.formats.elements_of import Unread, table_of
from robodyn.formats.tree import JointLimits, Leftovers, Mimic, Tree, TreeJoint, TreeLink, checked, near
from robodyn.robot.names import shown

_KINDS: Final = {
    kind: kind for kind in ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
}


def read_tree(document: Document) -> Tree:
    """The tree of a document whose root is ``<robot>``.

    Raises
    ------
    InputError: something is missing, is no number, stands there twice, or names what is not there.
    """
    leftovers = Leftovers(document.file)
    reader = _Reader(document, leftovers)
    root = document.root
    Unread(table_of("URDF"), leftovers, document.place).note(root)
    links = [reader.link(element) for element in root.all("link")]
    joints = [reader.joint(element) for element in root.all("joint")]
    transmissions = _Transmissions(reader, leftovers)
    for element in root.all("transmission"):
        transmissions.read(element)
    if not links:
        macros = any(element.tag.startswith("xacro:") for element in root.walk())
        raise reader.fail(
            root,
            "the robot has no links",
            expected='elements <link name="..."> and <joint name="..." type="...">',
            remedy="this is a xacro file: name it .xacro" if macros else None,
        )
    name, joints = root.attributes.get("name", ""), transmissions.applied(joints)
    tree = Tree(name, "URDF", document.file, tuple(links), tuple(joints))
    return checked(replace(tree, unused=leftovers.unused(), physics=tuple(leftovers.physics)))


class _Reader(Quantities):
    def must(self, element: Element, tag: str, of: str) -> Element:
        child = self.one(element, tag, of)
        if child is None:
            raise self.fail(element, f"{of}: {tag_shown(element)} has no <{tag}>")
        return child

    def origin(self, element: Element, of: str) -> Pose:
        origin = self.one(element, "origin", of)
        if origin is None:
            return Pose()
        zero = (0.0, 0.0, 0.0)
        xyz = self.vector(origin, "xyz", of, zero)
        text = origin.attributes.get("quat_xyzw")
        if text is None:
            return Pose.from_rpy(xyz, self.vector(origin, "rpy", of, zero))
        if self.document.root.attributes.get("version", "1.0") == "1.0":  # urdfdom passes over it there
            what = f"{of}: quat_xyzw is of URDF 1.1"
            remedy = 'say so: <robot name="..." version="1.1">, or write rpy'
            raise self.fail(origin, what, "1.0", attribute="quat_xyzw", remedy=remedy)
        return self.quaternion(text, origin, "quat_xyzw", xyz, f"{of}: quat_xyzw of <origin>")

    def link(self, element: Element) -> TreeLink:
        name = self.name(element, "a link")
        of = f"link {shown(name)}"
        shape = element.first("visual") is not None or element.first("collision") is not None
        inertial = self.one(element, "inertial", of)
        if inertial is None:
            return TreeLink(name, self.place(element), None, shape)
        mass = self.number(self.must(inertial, "mass", of), "value", of, least=0)
        pose, tensor = self.origin(inertial, of), self.one(inertial, "inertia", of)
        if tensor is None:
            return TreeLink(name, self.place(element), Body(mass, pose.xyz), shape, is_point=True)
        xx, yy, zz = (self.number(tensor, key, of) for key in ("ixx", "iyy", "izz"))
        xy, xz, yz = (self.number(tensor, key, of, 0.0) for key in ("ixy", "ixz", "iyz"))
        return TreeLink(name, self.place(element), body_of(mass, pose, (xx, yy, zz, xy, xz, yz)), shape)

    def joint(self, element: Element) -> TreeJoint:
        name = self.name(element, "a joint")
        of = f"joint {shown(name)}"
        kind = self.kind(element, of, _KINDS)
        parent, child = (
            self.name(self.must(element, role, of), f"the {role} of {of}", "link")
            for role in ("parent", "child")
        )
        axis, dynamics, mimic = (self.one(element, tag, of) for tag in ("axis", "dynamics", "mimic"))
        direction = (1.0, 0.0, 0.0)
        if axis is not None and kind not in ("fixed", "floating"):
            direction = self.axis(axis, self.vector(axis, "xyz", of, direction), "xyz", of)
        damping, friction, armature = (
            self.number(dynamics, word, of, least=0) if dynamics and word in dynamics.attributes else None
            for word in ("damping", "friction", "armature")
        )
        return TreeJoint(
            name,
            kind,
            parent,
            child,
            self.place(element),
            origin=self.origin(element, of),
            axis=direction,
            limits=self.limits(element, kind, of),
            damping=damping,
            friction=friction,
            armature=armature,
            mimic=self.mimic(mimic, of) if mimic else None,
        )

    def limits(self, element: Element, kind: str, of: str) -> JointLimits:
        limit = self.one(element, "limit", of)
        if limit is None:
            return JointLimits()
        ends: dict[str, float | None] = (
            {"lower": 0.0, "upper": 0.0} if kind in ("revolute", "prismatic") else {}
        )
        for word in (*ends, "velocity", "acceleration", "effort"):
            if word in limit.attributes:
                ends[word] = self.limit(limit.attributes[word], limit, word, f"{of}: {word}")
        return JointLimits(**ends)

    def mimic(self, mimic: Element, of: str) -> Mimic:
        leader = self.name(mimic, f"the joint that {of} follows", "joint")
        return Mimic(leader, self.number(mimic, "multiplier", of, 1.0), self.number(mimic, "offset", of, 0.0))


_REDUCTION: Final = "mechanicalReduction"
_MOTOR_INERTIA: Final = "motorInertia"
_RATIO, _ROTOR = "drake:gear_ratio", "drake:rotor_inertia"


class _Transmissions:
    """Collects what transmissions say of joints: those between one motor and one joint."""

    def __init__(self, reader: Quantities, leftovers: Leftovers) -> None:
        self._reader, self._leftovers = reader, leftovers
        self._ratios: dict[str, float] = {}
        self._rotors: dict[str, float] = {}
        self._elements: dict[str, Element] = {}
        self._with_rotor: dict[str, Element] = {}

    def read(self, element: Element) -> None:
        """Take what one ``<transmission>`` says."""
        joints = [joint.attributes.get("name", "") for joint in element.all("joint")]
        actuators = list(element.all("actuator"))
        kind = element.first("type")
        word = element.attributes.get("type", "") if kind is None else kind.text
        if len(joints) != 1 or len(actuators) > 1 or (word and not word.endswith("SimpleTransmission")):
            self._leftovers.add("transmissions of more than one motor and one joint", element.line)
            if any(part.tag in (_MOTOR_INERTIA, _ROTOR) for part in element.walk()):
                of = f"transmission {element.attributes.get('name', '')}"
                self._leftovers.changes_torques("transmission", of, self._reader.place(element))
            return
        self._elements.setdefault(joints[0], element)
        for part in element.walk():
            if part.tag in (_REDUCTION, _RATIO, _MOTOR_INERTIA, _ROTOR):
                self._number(element, part, joints[0])

    def _number(self, transmission: Element, part: Element, joint: str) -> None:
        """Take a reduction, or a rotor inertia; another one of the joint before it, and the rotor of a second
        motor, even an equal one, are refused."""
        what = f"joint {shown(joint)}: {tag_shown(part)}"
        attribute = "value" if part.tag in (_RATIO, _ROTOR) else ""
        text = self._reader.required(part, "value", f"joint {shown(joint)}") if attribute else part.text
        (value,) = self._reader.numbers(text, 1, part, attribute, what)
        values, fault, remedy = self._ratios, "twice", None
        if part.tag in (_MOTOR_INERTIA, _ROTOR):
            values = self._rotors
            if value < 0:
                raise self._reader.fail(part, f"{what} is negative", f"{value:g}", attribute=attribute)
            if self._with_rotor.setdefault(joint, transmission) is not transmission:
                fault = "by two transmissions"
                remedy = "state the sum of their inertias in one of the transmissions"
        elif value in (0.0, 1.0):
            self._leftovers.add(f"reductions of {value:g}", part.line)
            return
        if remedy or values.setdefault(joint, value) != value:
            what, found = f"{what} is stated {fault}", f"{value:g} after {values[joint]:g}"
            expected = "one motor for a joint" if remedy else "one value for a joint"
            raise self._reader.fail(part, what, found, expected, remedy=remedy)

    def applied(self, joints: list[TreeJoint]) -> list[TreeJoint]:
        """The joints with their ratios, and rotor inertias reflected through them; transmissions of joints
        that are not there are noted."""
        names = dict.fromkeys(joint.name for joint in joints)
        for name, element in self._elements.items():
            if name not in names:
                of = f"joint {name}; {near(name, names, 'joint')}"
                self._leftovers.changes_torques("transmission", of, self._reader.place(element))
        return [self._with_transmission(joint) for joint in joints]

    def _with_transmission(self, joint: TreeJoint) -> TreeJoint:
        ratio, rotor = self._ratios.get(joint.name), self._rotors.get(joint.name)
        if rotor is not None:
            joint = replace(joint, armature=(joint.armature or 0.0) + rotor * (ratio or 1.0) ** 2)
        return joint if ratio is None else replace(joint, ratio=ratio)
