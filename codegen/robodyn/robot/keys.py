"""Every key of the robot description, in one table: the reader and the JSON Schema are made from it. What may
stand at a key: bounds of numbers, and the words that messages have for it."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from robodyn.robot.account import PARTS, STATEABLE
from robodyn.robot.names import ROBOT_NAME_LENGTH, TEXT_LENGTH
from robodyn.robot.parts import AXES, UNKNOWN

Kind = Literal[
    "name", "text", "texts", "choice", "number", "angle", "vector", "angles", "range", "group", "list",
    "rest", "efficiency", "origins", "joint", "effects of a joint", "effects of the robot",
]  # fmt: skip
Sign = Literal["any", "nonzero", "nonnegative", "positive", "share"]


@dataclass(frozen=True, slots=True)
class Key:
    """One key: what may stand there, in which unit, and what is assumed where it is left out.

    ``names``: a run-time parameter may stand for the number. ``default`` is the text of the assumed
    value, for people; ``members`` are the keys of a group or of each entry of a list. ``choices`` are the
    words that may stand there, of a number those that may stand in its place.
    """

    name: str
    kind: Kind
    doc: str
    unit: str = ""
    required: bool = False
    names: bool = False
    sign: Sign = "any"
    default: str = ""
    choices: tuple[str, ...] = ()
    members: tuple[Key, ...] = ()


#: Most links a robot may have.
LINKS = 100
#: The numbers that lead from one link's frame to the next, if no pose does.
ROW = ("alpha", "a", "b", "d", "theta")
#: Most effects a robot may have, all lists together.
EFFECTS = 1000
#: Fewest and most knots of a table of efficiencies.
KNOTS = (2, 64)
#: The velocity of ``smooth`` and of ``dead_band`` where none is given.
REST_VELOCITY = "1e-3"

#: Bounds of a number: what is said of one that breaks them, and what was expected.
SIGNS = {
    "nonzero": ("is 0", "any number but 0"),
    "nonnegative": ("is negative", "0{unit} or more"),
    "positive": ("is not positive", "more than 0{unit}"),
    "share": ("is not a share", "more than 0 and at most 1"),
}
#: What other formats call our keys.
OTHER_NAMES = {
    other: name
    for name, others in {
        "joint": "type kind joint_type",
        "mass": "m weight",
        "com": "r cog center_of_mass centre_of_mass",
        "theta": "offset",
        "motor_inertia": "armature jm imotor",
        **{axes: f"i{axes} {axes[::-1]}" for axes in AXES},
        "links": "joints",
        "gravity": "g",
        "torque": "effort",
        "viscous": "damping",
        "convention": "dh",
        "base": "mount",
        "tool": "tcp flange",
        "xyz": "translation position_xyz",
        "rpy": "rotation",
    }.items()
    for other in others.split()
}


def _argument(name: str, doc: str, unit: str, sign: Sign = "any") -> Key:
    """A number that may be a run-time parameter, 0 where it is left out."""
    return Key(name, "number", doc, unit, names=True, sign=sign, default="0")


def _group(name: str, doc: str, members: tuple[Key, ...], unit: str = "") -> Key:
    return Key(name, "group", doc, unit, members=members)


COMPARE = (
    Key("table", "text", 'Table of the thesis, such as "2.10".', required=True),
    Key("row", "text", "Row of that table, such as puma_6.", required=True),
)
INERTIA = tuple(_argument(axes, f"I{axes}, entry of the inertia tensor.", "kg m^2") for axes in AXES)
LIMITS = (
    Key("position", "range", "Lowest and highest position.", "rad, prismatic m"),
    Key("velocity", "number", "Greatest speed.", "rad/s, prismatic m/s", sign="positive"),
    Key("acceleration", "number", "Greatest acceleration.", "rad/s^2, prismatic m/s^2", sign="positive"),
    Key("torque", "number", "Greatest torque.", "N m, prismatic N", sign="positive"),
)
FRICTION = (
    _argument("viscous", "Viscous friction.", "N m s/rad, prismatic N s/m", "nonnegative"),
    _argument("coulomb", "Coulomb friction.", "N m, prismatic N", "nonnegative"),
)
_RATIO = (
    "Turns of the motor for one turn of the joint; prismatic: angle of the motor for one metre. Negative "
    "where the motor turns the other way."
)
_TORQUE_CONSTANT = "Torque of the motor, in front of the gear, for one ampere."
GEAR = (
    Key("ratio", "number", _RATIO, "1, prismatic rad/m", required=True, sign="nonzero"),
    Key("torque_constant", "number", _TORQUE_CONSTANT, "N m/A", sign="positive"),
)
_RPY = "Roll, pitch and yaw as in URDF: turned about the fixed x, then y, then z."
PLACEMENT = (
    Key("xyz", "vector", "Origin of the frame.", "m", default="[0, 0, 0]"),
    Key("rpy", "angles", _RPY, "rad", default="[0, 0, 0]"),
)

#: Groups of numbers that have one origin: what they are.
_GROUPS = {
    "geometry": "DH numbers or pose.",
    "inertial": "Mass, centre of mass, inertia.",
    "motor_inertia": "Rotor inertia.",
    "friction": "Friction in the joint.",
    "limits": "Limits of the joint.",
}


def _confidence(of: str, default: str) -> Key:
    return Key(
        "confidence",
        "number",
        f"The inertial numbers of {of} are right to about this share; unknown: they are a guess.",
        sign="share",
        default=default,
        choices=(UNKNOWN,),
    )


def _origin(of: str, default: str) -> Key:
    return Key(
        "origin",
        "origins",
        f"Where the numbers of {of} come from: one word for all, or one for each group of them. What a "
        "description leaves out is absent, and every output says so.",
        default=default,
        choices=STATEABLE,
        members=tuple(
            Key(group, "choice", words, choices=(*STATEABLE, "absent") if group == "inertial" else STATEABLE)
            for group, words in _GROUPS.items()
        ),
    )


_B = (
    "Offset along y behind the twist; 0 in Denavit-Hartenberg rows. It keeps origins near the arm where two "
    "axes are nearly parallel."
)
_POSE = (
    "In place of the numbers above: the joint's frame in the frame before at q = 0; q is about or along its "
    "z axis. Frames turn about their z axes where rows need it, and all that stands in them too."
)
_COM = "Centre of mass [x, y, z] in the link's frame."
_INERTIA = "Inertia tensor about the centre of mass, along the axes of the link's frame."
_MOTOR_INERTIA = "Rotor inertia reflected to the joint; it multiplies the joint's own acceleration only."
_ACKNOWLEDGED = (
    "Why implausible numbers of this link stand as they are: one sentence. Loading then does not warn of "
    "them; --strict still refuses them."
)
_EFFECTS = "What this joint and its link have beyond a rigid body: friction, gear, elasticity, sensors."
_KINDS = ("revolute", "prismatic")
LINK = (
    Key("name", "text", "Name of the link.", default="link1, link2, ..."),
    Key("joint", "choice", "Kind of the joint before the link.", required=True, choices=_KINDS),
    Key("alpha", "angle", "alpha_{i-1}: twist, about x of the frame before.", "rad", default="0"),
    _argument("a", "a_{i-1}: length, along x of the frame before.", "m"),
    _argument("b", _B, "m"),
    _argument("d", "d_i: offset, along z; prismatic: constant added to q.", "m"),
    Key("theta", "angle", "theta_i: angle, about z; revolute: constant added to q.", "rad", default="0"),
    _group("pose", _POSE, PLACEMENT),
    _argument("mass", "Mass of the link.", "kg", "nonnegative"),
    Key("com", "vector", _COM, "m", names=True, default="[0, 0, 0]"),
    _group("inertia", _INERTIA, INERTIA, "kg m^2"),
    _argument("motor_inertia", _MOTOR_INERTIA, "kg m^2, prismatic kg", "nonnegative"),
    _group("gear", "What turns the motor's angle and current into the joint's.", GEAR),
    _group("limits", "Limits of the joint.", LIMITS),
    _confidence("the link", "that of the robot"),
    _origin("the link and its joint", "that of the robot"),
    Key("acknowledged", "text", _ACKNOWLEDGED),
    _group("friction", "Friction in the joint.", FRICTION),
    Key("effects", "effects of a joint", _EFFECTS),
)
IMPORTED = (
    Key("file", "text", "Name of the file.", required=True),
    Key("format", "text", "Its format, such as URDF.", required=True),
    *(Key(part, "texts", text) for part, text in PARTS.items()),
)
_NAME = f"A C identifier of at most {ROBOT_NAME_LENGTH} characters; it prefixes every emitted symbol."
_SOURCE = f"Where the numbers come from: one line of at most {TEXT_LENGTH} characters."
_GRAVITY = "Acceleration of free fall [x, y, z] in the base frame; with base in the world's."
_BASE = "Where the base frame stands in the world; gravity is then in the world's frame."
_CONVENTION = (
    "mdh: modified (Craig) Denavit-Hartenberg; sdh: standard, rows hold a_i and alpha_i, is converted. "
    "Bearings and contacts among the effects are meant in the modified frames either way."
)
_STANDARD_END = (
    "Of rows that were converted from standard DH: where the last link's standard frame stands in its "
    "modified one. link_poses are then those of the standard frames."
)
_SIDE = "motor: the motor torque, reflected to the joint (rotor, friction in it); link: behind the gear."
_REST = (
    "exact: sgn(0) = 0; smooth: {velocity: v}: tanh(qd/v) in place of the sign; dead_band: {velocity: v}: 0 "
    "in place of the sign below v."
)
_RULES = ("exact", "smooth", "dead_band")
_VELOCITY = Key(
    "velocity",
    "number",
    "Speed over which the sign is smoothed, or below which it is 0.",
    "rad/s, prismatic m/s",
    sign="positive",
    default=REST_VELOCITY,
)
_LINKS = f"The links with their joints, base to tip, 1 to {LINKS}."
_OF_ALL = "Effects of the whole robot: payload, contacts, what holds for all joints."
_ALL_LINKS = "all links that do not state their own"
ROBOT = (
    Key("name", "name", _NAME, required=True),
    Key("title", "text", f"One line of at most {TEXT_LENGTH} characters."),
    Key("source", "text", _SOURCE),
    _group("imported", "The file that this was imported from, and what is not here.", IMPORTED),
    Key("gravity", "vector", _GRAVITY, "m/s^2", default="[0, 0, -9.81]"),
    _group("base", _BASE, PLACEMENT),
    _confidence(_ALL_LINKS, "not stated; 0.1 where a number is needed"),
    _origin(_ALL_LINKS, "stated; assumed where confidence is unknown"),
    _group("compare", "The row of the thesis that this robot is set beside.", COMPARE),
    Key("convention", "choice", _CONVENTION, choices=("mdh", "sdh"), default="mdh"),
    Key("links", "list", _LINKS, required=True, members=LINK),
    _group("tool", "Where the tool's frame stands in the last link's frame.", PLACEMENT),
    _group("standard_end", _STANDARD_END, PLACEMENT),
    Key("torque_side", "choice", _SIDE, choices=("motor", "link"), default="motor"),
    Key("friction_at_rest", "rest", _REST, choices=_RULES, default="exact", members=(_VELOCITY,)),
    Key("effects", "effects of the robot", _OF_ALL),
)


def allowed(value: Fraction, sign: Sign) -> bool:
    """Whether ``value`` is within the bounds that ``sign`` names."""
    if sign == "any":
        return True
    if sign == "nonnegative":
        return value >= 0
    if sign == "nonzero":
        return value != 0
    return value > 0 and (sign == "positive" or value <= 1)


def expectation(key: Key) -> str:
    """What should stand at ``key``, for the "expected" of a message."""
    if key.kind == "choice":
        return " or ".join(key.choices)
    unit = f" [{key.unit}]" if key.unit else ""
    words = {
        "name": "a name",
        "text": "text",
        "number": " or ".join(["a number" + (", or a name" if key.names else ""), *key.choices]),
        "angle": "an angle, such as -pi/2",
        "vector": "three numbers [x, y, z]",
        "angles": "three angles [roll, pitch, yaw]",
        "range": "[lowest, highest]",
        "list": "a list",
        "texts": "a list of lines of text",
        "group": "a mapping",
        "rest": "exact, or smooth: {velocity: 1e-3}, or dead_band: {velocity: 1e-3}",
        "efficiency": "a number, or a table [[load fraction, efficiency], ...]",
        "origins": f"{' or '.join(key.choices)}, or a mapping such as {{inertial: synthetic}}",
        "joint": "the number of a joint",
        "effects of a joint": "a list of effects, such as [{effect: backlash, gap: 1e-3}]",
        "effects of the robot": "a list of effects, such as [{effect: payload, mass: 2}]",
    }
    return words[key.kind] + unit
