"""A robot as the writers of other formats take it: frames as xyz and rpy, floats, names that are unique.

Frame i is the description's: its z axis is the joint's. Numbers are the doubles of the description's.

For pictures there is a cylinder along each link to the next joint, and one about each joint. They weigh
nothing.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Final

from robodyn.errors import InputError
from robodyn.formats.chain import Body, ChainJoint, Vector, lumped
from robodyn.formats.conversion import spring_of
from robodyn.formats.limits import PICTURE_HUB, PICTURE_RADIUS
from robodyn.formats.tree import Mimic
from robodyn.formats.writers import legal
from robodyn.robot.account import account_lines
from robodyn.robot.masses import unknown_masses
from robodyn.robot.model import AXES, EffectEntry, Inertia, Link, Robot
from robodyn.robot.names import shown
from robodyn.robot.parts import Placement
from robodyn.robot.rotations import about_x, about_z, placement, product
from robodyn.robot.values import Value


@dataclass(frozen=True, slots=True)
class Cylinder:
    """A cylinder about z of its ``frame``, which is its middle; ``radius`` and ``length`` in m."""

    frame: Frame
    radius: float
    length: float


def cylinders(parts: Parts) -> list[tuple[Cylinder, ...]]:
    """The cylinders of the base, then of each link, in their frames."""
    radius = _round(PICTURE_RADIUS * parts.size)
    ends = [joint.frame.xyz for joint in parts.joints] + [(parts.tool or Frame()).xyz]
    hub = Cylinder(Frame(), _round(PICTURE_HUB * radius), _round(2 * PICTURE_HUB * radius))
    pictures = []
    for index, (x, y, z) in enumerate(ends):
        picture = [hub] if index and radius else []
        if radius and math.hypot(x, y, z) > radius:  # from the origin to the next frame
            middle = (_round(x / 2), _round(y / 2), _round(z / 2))
            pitch, yaw = math.atan2(math.hypot(x, y), z), math.atan2(y, x)
            frame = Frame(middle, (0.0, _round(pitch), _round(yaw)))
            picture.append(Cylinder(frame, radius, _round(math.hypot(x, y, z))))
        pictures.append(tuple(picture))
    return pictures


def _round(x: float) -> float:
    """A picture needs four digits; more would only make the file long."""
    return float(f"{x:.4g}")


#: Names of the entries of a tensor in URDF and SDF, in the order of a body's.
TENSOR: Final = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
#: Names that mean something in one of the formats or in what reads it.
_RESERVED: Final = {"world", "base", "tool", "base_joint", "tool_joint", "universe", "root_joint"}


@dataclass(frozen=True, slots=True)
class Frame:
    """A frame in its parent: origin [m], and URDF's roll, pitch, yaw [rad]."""

    xyz: Vector = (0.0, 0.0, 0.0)
    rpy: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class PartJoint(ChainJoint):
    """A joint, about or along z of its ``frame``; ``mass_is_known``: whether a mass of 0 is one; ``mimic``:
    what it follows."""

    frame: Frame = field(default_factory=Frame)
    mass_is_known: bool = True
    mimic: Mimic | None = None

    @property
    def word(self) -> str:
        """Its kind, as URDF and SDF call it."""
        free = self.limits.position is None and self.kind == "revolute"
        return "continuous" if free else self.kind


@dataclass(frozen=True, slots=True)
class Parts:
    """A robot, base to tip. ``base``: the base frame in the world, None where they are the same; ``tool``: in
    the last link's frame, None where nothing is stated; ``size``: how far frames are apart in all [m].

    ``left_out``: what no other format states, as words.
    """

    name: str
    comments: tuple[str, ...]
    gravity: Vector
    base: Frame | None
    tool: Frame | None
    joints: tuple[PartJoint, ...]
    size: float
    left_out: tuple[str, ...]


def parts_of(robot: Robot) -> Parts:
    """The parts of ``robot``, which has no run-time parameters.

    Raises
    ------
    InputError: it has some, or a joint follows several others.
    """
    if robot.parameters:
        raise InputError(
            f"{robot.name} has run-time parameters, and other formats have none",
            found=", ".join(robot.parameters),
            expected="a number for each",
            remedy=" ".join(f"--param {name}=VALUE" for name in robot.parameters),
        )
    unknown = unknown_masses(robot)
    names = _unique([link.name for link in robot.links], _RESERVED)
    links = _unique([f"{name}_link" for name in names], _RESERVED.union(names))
    springs = {entry.joint: spring for entry in robot.effects if (spring := spring_of(entry)) is not None}
    loads = [entry for entry in robot.effects if entry.definition.traits.body]
    bodies = [_body(link.mass, link.com, link.inertia) for link in robot.links]
    bodies[-1] = lumped([bodies[-1], *(_load(entry) for entry in loads)])
    mimics = _mimics(robot, names)
    joints = [
        PartJoint(
            names[i],
            links[i],
            link.joint.kind,
            body=bodies[i],
            limits=link.joint.limits,
            viscous=_float(link.joint.viscous),
            coulomb=_float(link.joint.coulomb),
            motor_inertia=_float(link.joint.motor_inertia),
            gear=link.joint.gear,
            spring=springs.get(i + 1),
            frame=_frame_of(link),
            mass_is_known=i + 1 not in unknown,
            mimic=mimics.get(i),
        )
        for i, link in enumerate(robot.links)
    ]
    tool = _placed(robot.tool)
    frames = [joint.frame for joint in joints] + [tool or Frame()]
    return Parts(
        robot.name,
        (robot.title, robot.source, *account_lines(robot)),
        _floats(robot.gravity),
        _placed(robot.base),
        tool,
        tuple(joints),
        math.fsum(math.hypot(*frame.xyz) for frame in frames),
        tuple(_left_out(robot, loads)),
    )


def _mimics(robot: Robot, names: list[str]) -> dict[int, Mimic]:
    """What each joint (from 0) that follows others follows in the end, a joint that is commanded."""
    if not robot.couplings:
        return {}
    from robodyn.robot.coupling import transmission_of

    at, mimics = transmission_of(robot), {}
    for joint in {coupling.joint - 1 for coupling in robot.couplings}:
        if len(at.rows[joint]) != 1:
            leaders = ", ".join(names[at.commanded[k]] for k in at.rows[joint])
            raise InputError(
                f"the joint {shown(names[joint])} follows {leaders or 'none in the end'}",
                found=f"{len(at.rows[joint])} joints",
                expected="one joint: a file in another format has no words for more",
                remedy="leave that coupling out; what moves the joint is for the program that reads the file",
            )
        ((k, ratio),) = at.rows[joint].items()
        mimics[joint] = Mimic(names[at.commanded[k]], float(ratio), float(at.offsets[joint]))
    return mimics


def _unique(names: Iterable[str], reserved: Iterable[str]) -> list[str]:
    """``names`` as the formats can have them, none of them twice or ``reserved``: a number is added.

    Characters that XML has no place for become underscores, and so do colons (SDF's scopes) and slashes
    (ROS's and MuJoCo's); white space around a name is left out.
    """
    taken, chosen = set(reserved), []
    for name in names:
        plain = re.sub(r"[:/]|^__|__$", "_", legal(name).strip()) or "joint"
        numbered = itertools.chain([plain], (f"{plain}_{count}" for count in itertools.count(2)))
        chosen.append(next(each for each in numbered if each not in taken))
        taken.add(chosen[-1])
    return chosen


def _left_out(robot: Robot, loads: list[EffectEntry]) -> Iterable[str]:
    places: dict[str, list[str]] = {}
    for entry in robot.effects:
        if entry not in loads and spring_of(entry) is None:
            place = "the whole robot" if entry.joint is None else robot.links[entry.joint - 1].name
            places.setdefault(entry.effect, []).append(place)
    yield from (f"{effect}: {', '.join(where)}" for effect, where in places.items())
    if robot.torque_side == "link":
        yield "torque_side: link (in the file, rotors and friction are in the torque)"
    if robot.rest_velocity is not None or robot.dead_band is not None:
        yield "friction_at_rest"
    gears = {link.name: link.joint.gear for link in robot.links}
    if constants := [name for name, gear in gears.items() if gear and gear.torque_constant is not None]:
        yield "torque constants: " + ", ".join(constants)
    if any(link.confidence is not None for link in robot.links):
        yield "confidence"
    if joints := unknown_masses(robot):
        yield f"that the mass or inertia of joint {', '.join(map(str, joints))} is unknown"


def _frame_of(link: Link) -> Frame:
    """A row of modified DH as xyz and rpy; the angle itself where there is only one."""
    joint = link.joint
    c, s = joint.alpha.cos, joint.alpha.sin
    a, b, d = (_fraction(value) for value in (joint.a, joint.b, joint.d))
    xyz = (a, c * b - s * d, s * b + c * d)
    if joint.theta.quarter == 0:
        rpy = (joint.alpha.radians, 0.0, 0.0)
    elif joint.alpha.quarter == 0:
        rpy = (0.0, 0.0, joint.theta.radians)
    else:
        turn = product(about_x(joint.alpha), about_z(joint.theta))
        return replace(_placed(placement(turn, xyz, 1.0)) or Frame(), xyz=_floats(xyz))
    return Frame(_floats(xyz), rpy)


def _placed(frame: Placement | None) -> Frame | None:
    if frame is None:
        return None
    roll, pitch, yaw = (angle.radians for angle in frame.rpy)
    return Frame(_floats(frame.xyz), (roll, pitch, yaw))


def _body(mass: Value, com: tuple[Value, Value, Value], inertia: Inertia) -> Body:
    xx, yy, zz, xy, xz, yz = (_float(getattr(inertia, axes)) for axes in AXES)
    return Body(_float(mass), _floats(com), (xx, yy, zz, xy, xz, yz))


def _load(entry: EffectEntry) -> Body:
    return _body(entry["mass"], entry["com"], entry["inertia"] if "inertia" in entry else Inertia())


def _fraction(value: Value) -> Fraction:
    assert isinstance(value, Fraction)
    return value


def _float(value: Value) -> float:
    return float(_fraction(value))


def _floats(values: Iterable[Value]) -> Vector:
    x, y, z = map(_float, values)
    return (x, y, z)
