"""URDF to a tree, as http://wiki.ros.org/urdf/XML and urdfdom read it; meshes are not opened.

Of transmissions the reduction of a gear and the rotor behind it are read.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final, get_args

from robodyn.formats.chain import Body, Pose
from robodyn.formats.elements import Document, Element, tag_shown
from robodyn.formats.elements_of import table_of
from robodyn.formats.quantities import Quantities, body_of, negative
from robodyn.formats.tree import JointLimits, Kind, Leftovers, Mimic, Tree, TreeJoint, TreeLink, checked, near
from robodyn.formats.unread import Unread
from robodyn.robot.names import shown

_KINDS: Final = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")


def read_tree(document: Document) -> Tree:
    """The tree of a document whose root is ``<robot>``.

    Raises
    ------
    InputError: something is missing, is no number, stands there twice, or names what is not there.
    """
    leftovers = Leftovers(document.file)
    reader = _Reader(document, leftovers)
    root = document.root
    Unread(table_of("URDF"), leftovers, document.place).note(root, (root.tag,))
    transmissions = Transmissions(reader, leftovers)
    links, joints = [], []
    for element in root.children:
        if element.tag == "link":
            links.append(reader.link(element))
        elif element.tag == "joint":
            joints.append(reader.joint(element))
        elif element.tag == "transmission":
            transmissions.read(element)
    if not links:
        macros = any(element.tag.startswith("xacro:") for element in root.walk())
        raise reader.fail(
            root,
            "the robot has no links",
            expected='elements <link name="..."> and <joint name="..." type="...">',
            remedy="this is a xacro file: name it .xacro" if macros else None,
        )
    return checked(
        Tree(
            root.attributes.get("name", ""),
            "URDF",
            document.file,
            tuple(links),
            transmissions.applied(tuple(joints)),
            unused=leftovers.unused(),
            physics=tuple(leftovers.physics),
        )
    )


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
        if "quat_xyzw" in origin.attributes:
            text = origin.attributes["quat_xyzw"]
            if self.document.root.attributes.get("version", "1.0") == "1.0":  # urdfdom passes over it there
                remedy = 'say so: <robot name="..." version="1.1">, or write rpy'
                raise self.fail(
                    origin,
                    f"{of}: quat_xyzw is of URDF 1.1",
                    attribute="quat_xyzw",
                    found="1.0",
                    remedy=remedy,
                )
            x, y, z, w = self.numbers(text, 4, origin, "quat_xyzw", f"{of}: quat_xyzw of <origin>")
            try:
                return Pose.from_quaternion(xyz, (w, x, y, z))
            except ValueError:
                raise self.fail(
                    origin, f"{of}: the quaternion is zero", attribute="quat_xyzw", found=shown(text)
                ) from None
        return Pose.from_rpy(xyz, self.vector(origin, "rpy", of, zero))

    def link(self, element: Element) -> TreeLink:
        name = self.name(element, "a link")
        of = f"link {shown(name)}"
        shape = element.first("visual") is not None or element.first("collision") is not None
        inertial = self.one(element, "inertial", of)
        if inertial is None:
            return TreeLink(name, self.place(element), None, shape)
        is_point = self.one(inertial, "inertia", of) is None
        return TreeLink(name, self.place(element), self.body(inertial, of), shape, is_point=is_point)

    def body(self, inertial: Element, of: str) -> Body:
        mass = self.number(self.must(inertial, "mass", of), "value", of, bad=negative)
        tensor = self.one(inertial, "inertia", of)
        if tensor is None:
            return Body(mass, self.origin(inertial, of).xyz)
        xx, yy, zz = (self.number(tensor, key, of) for key in ("ixx", "iyy", "izz"))
        xy, xz, yz = (self.number(tensor, key, of, 0.0) for key in ("ixy", "ixz", "iyz"))
        return body_of(mass, self.origin(inertial, of), (xx, yy, zz, xy, xz, yz))

    def joint(self, element: Element) -> TreeJoint:
        name = self.name(element, "a joint")
        of = f"joint {shown(name)}"
        word = self.required(element, "type", of)
        if word not in _KINDS:
            raise self.fail(
                element,
                f"{of}: the type is unknown",
                attribute="type",
                found=shown(word),
                expected=", ".join(_KINDS),
            )
        kind: Kind = next(kind for kind in get_args(Kind) if kind == word)
        parent = self.name(self.must(element, "parent", of), f"the parent of {of}", "link")
        child = self.name(self.must(element, "child", of), f"the child of {of}", "link")
        axis = self.one(element, "axis", of)
        direction = (1.0, 0.0, 0.0)
        if axis is not None and kind not in ("fixed", "floating"):
            direction = self.axis(axis, self.vector(axis, "xyz", of, direction), "xyz", of)
        dynamics, mimic = self.one(element, "dynamics", of), self.one(element, "mimic", of)
        return TreeJoint(
            name,
            kind,
            parent,
            child,
            self.place(element),
            origin=self.origin(element, of),
            axis=direction,
            limits=self.limits(element, kind, of),
            damping=self.dynamics(dynamics, "damping", of),
            friction=self.dynamics(dynamics, "friction", of),
            armature=self.dynamics(dynamics, "armature", of),
            mimic=self.mimic(mimic, of) if mimic else None,
        )

    def dynamics(self, dynamics: Element | None, name: str, of: str) -> float | None:
        """A number in ``<dynamics>``; None where it is not stated."""
        if dynamics is None or name not in dynamics.attributes:
            return None
        return self.number(dynamics, name, of, bad=negative)

    def limits(self, element: Element, kind: Kind, of: str) -> JointLimits:
        limit = self.one(element, "limit", of)
        if limit is None:
            return JointLimits()
        velocity, acceleration, effort = (
            self.limit(limit, key, of) for key in ("velocity", "acceleration", "effort")
        )
        if kind not in ("revolute", "prismatic"):
            return JointLimits(None, None, velocity, acceleration, effort)
        lower = self.limit(limit, "lower", of) if "lower" in limit.attributes else 0.0
        upper = self.limit(limit, "upper", of) if "upper" in limit.attributes else 0.0
        return JointLimits(lower, upper, velocity, acceleration, effort)

    def mimic(self, mimic: Element, of: str) -> Mimic:
        return Mimic(
            self.name(mimic, f"the joint that {of} follows", "joint"),
            self.number(mimic, "multiplier", of, 1.0),
            self.number(mimic, "offset", of, 0.0),
        )


_SIMPLE: Final = "SimpleTransmission"
_REDUCTION: Final = "mechanicalReduction"
_MOTOR_INERTIA: Final = "motorInertia"
_RATIO, _ROTOR = "drake:gear_ratio", "drake:rotor_inertia"


class Transmissions:
    """Collects what transmissions say of joints: those between one motor and one joint."""

    def __init__(self, reader: Quantities, leftovers: Leftovers) -> None:
        self._reader, self._leftovers = reader, leftovers
        self._ratios: dict[str, float] = {}
        self._armatures: dict[str, float] = {}
        self._elements: dict[str, Element] = {}
        self._with_rotor: dict[str, Element] = {}

    def read(self, element: Element) -> None:
        """Take what one ``<transmission>`` says."""
        joints = [joint.attributes.get("name", "") for joint in element.all("joint")]
        actuators = list(element.all("actuator"))
        kind = element.first("type")
        word = element.attributes.get("type", "") if kind is None else kind.text
        if len(joints) != 1 or len(actuators) > 1 or (word and not word.endswith(_SIMPLE)):
            self._leftovers.add("transmissions of more than one motor and one joint", element.line)
            if any(part.tag in (_MOTOR_INERTIA, _ROTOR) for part in element.walk()):
                of = f"transmission {element.attributes.get('name', '')}"
                self._leftovers.changes_torques("transmission", of, self._reader.place(element))
            return
        (joint,) = joints
        self._elements.setdefault(joint, element)
        for part in element.walk():
            if part.tag == _REDUCTION:
                self._ratio(part, joint, part.text, "")
            elif part.tag == _RATIO:
                self._ratio(part, joint, part.attributes.get("value", ""), "value")
            elif part.tag == _MOTOR_INERTIA:
                what = f"joint {shown(joint)}: {tag_shown(part)}"
                (rotor,) = self._reader.numbers(part.text, 1, part, "", what)
                self._rotor(element, part, joint, rotor)
            elif part.tag == _ROTOR:
                rotor = self._reader.number(part, "value", f"joint '{joint}'", bad=negative)
                self._rotor(element, part, joint, rotor)

    def _rotor(self, transmission: Element, part: Element, joint: str, value: float) -> None:
        """Take the rotor inertia; that of a second motor of the joint, even an equal one, is refused."""
        if self._with_rotor.setdefault(joint, transmission) is not transmission:
            raise self._reader.fail(
                part,
                f"joint {shown(joint)}: {tag_shown(part)} is stated by two transmissions",
                found=f"{value:g} after {self._armatures[joint]:g}",
                expected="one motor for a joint",
                remedy="state the sum of their inertias in one of the transmissions",
            )
        self._state(self._armatures, part, joint, value)

    def _ratio(self, part: Element, joint: str, text: str, attribute: str) -> None:
        what = f"joint '{joint}': {tag_shown(part)}"
        (ratio,) = self._reader.numbers(text, 1, part, attribute, what)
        if ratio in (0.0, 1.0):
            self._leftovers.add(f"reductions of {ratio:g}", part.line)
            return
        self._state(self._ratios, part, joint, ratio)

    def _state(self, values: dict[str, float], part: Element, joint: str, value: float) -> None:
        """Take ``value`` for the ``joint``; another one before it is refused."""
        if values.setdefault(joint, value) != value:
            raise self._reader.fail(
                part,
                f"joint {shown(joint)}: {tag_shown(part)} is stated twice",
                found=f"{value:g} after {values[joint]:g}",
                expected="one value for a joint",
            )

    def applied(self, joints: tuple[TreeJoint, ...]) -> tuple[TreeJoint, ...]:
        """The joints with their ratios, and rotor inertias reflected through them; transmissions of joints
        that are not there are noted."""
        names = dict.fromkeys(joint.name for joint in joints)
        for name, element in self._elements.items():
            if name not in names:
                of = f"joint {name}; {near(name, names, 'joint')}"
                self._leftovers.changes_torques("transmission", of, self._reader.place(element))
        return tuple(self._with_transmission(joint) for joint in joints)

    def _with_transmission(self, joint: TreeJoint) -> TreeJoint:
        ratio, rotor = self._ratios.get(joint.name), self._armatures.get(joint.name)
        if ratio is not None:
            joint = replace(joint, ratio=ratio)
        if rotor is not None:
            joint = replace(joint, armature=(joint.armature or 0.0) + rotor * (ratio or 1.0) ** 2)
        return joint
