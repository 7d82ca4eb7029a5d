"""Every key of the robot description, in one table: the reader and the JSON Schema are made from it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from robodyn.robot.account import PARTS
from robodyn.robot.names import ROBOT_NAME_LENGTH, TEXT_LENGTH
from robodyn.robot.origins import STATEABLE
from robodyn.robot.parts import UNKNOWN

Kind = Literal[
    "name",
    "text",
    "choice",
    "number",
    "angle",
    "vector",
    "angles",
    "range",
    "group",
    "list",
    "texts",
    "rest",
    "efficiency",
    "origins",
    "joint",
    "effects of a joint",
    "effects of the robot",
]
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

COMPARE = (
    Key("table", "text", 'Table of the thesis, such as "2.10".', required=True),
    Key("row", "text", "Row of that table, such as puma_6.", required=True),
)
INERTIA = tuple(
    Key(axes, "number", f"I{axes}, entry of the inertia tensor.", "kg m^2", names=True, default="0")
    for axes in ("xx", "yy", "zz", "xy", "xz", "yz")
)
LIMITS = (
    Key("position", "range", "Lowest and highest position.", "rad, prismatic m"),
    Key("velocity", "number", "Greatest speed.", "rad/s, prismatic m/s", sign="positive"),
    Key("acceleration", "number", "Greatest acceleration.", "rad/s^2, prismatic m/s^2", sign="positive"),
    Key("torque", "number", "Greatest torque.", "N m, prismatic N", sign="positive"),
)
FRICTION = (
    Key(
        "viscous",
        "number",
        "Viscous friction.",
        "N m s/rad, prismatic N s/m",
        names=True,
        sign="nonnegative",
        default="0",
    ),
    Key(
        "coulomb",
        "number",
        "Coulomb friction.",
        "N m, prismatic N",
        names=True,
        sign="nonnegative",
        default="0",
    ),
)
GEAR = (
    Key(
        "ratio",
        "number",
        "Turns of the motor for one turn of the joint; prismatic: angle of the motor for one metre. Negative "
        "where the motor turns the other way.",
        "1, prismatic rad/m",
        required=True,
        sign="nonzero",
    ),
    Key(
        "torque_constant",
        "number",
        "Torque of the motor, in front of the gear, for one ampere.",
        "N m/A",
        sign="positive",
    ),
)
PLACEMENT = (
    Key("xyz", "vector", "Origin of the frame.", "m", default="[0, 0, 0]"),
    Key(
        "rpy",
        "angles",
        "Roll, pitch and yaw as in URDF: turned about the fixed x, then y, then z.",
        "rad",
        default="[0, 0, 0]",
    ),
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


LINK = (
    Key("name", "text", "Name of the link.", default="link1, link2, ..."),
    Key(
        "joint",
        "choice",
        "Kind of the joint before the link.",
        required=True,
        choices=("revolute", "prismatic"),
    ),
    Key("alpha", "angle", "alpha_{i-1}: twist, about x of the frame before.", "rad", default="0"),
    Key("a", "number", "a_{i-1}: length, along x of the frame before.", "m", names=True, default="0"),
    Key(
        "b",
        "number",
        "Offset along y behind the twist; 0 in Denavit-Hartenberg rows. It keeps origins near the arm where "
        "two axes are nearly parallel.",
        "m",
        names=True,
        default="0",
    ),
    Key("d", "number", "d_i: offset, along z; prismatic: constant added to q.", "m", names=True, default="0"),
    Key("theta", "angle", "theta_i: angle, about z; revolute: constant added to q.", "rad", default="0"),
    Key(
        "pose",
        "group",
        "In place of the numbers above: the joint's frame in the frame before at q = 0; q is about or along "
        "its z axis. Frames turn about their z axes where rows need it, and all that stands in them too.",
        members=PLACEMENT,
    ),
    Key("mass", "number", "Mass of the link.", "kg", names=True, sign="nonnegative", default="0"),
    Key(
        "com", "vector", "Centre of mass [x, y, z] in the link's frame.", "m", names=True, default="[0, 0, 0]"
    ),
    Key(
        "inertia",
        "group",
        "Inertia tensor about the centre of mass, along the axes of the link's frame.",
        "kg m^2",
        members=INERTIA,
    ),
    Key(
        "motor_inertia",
        "number",
        "Rotor inertia reflected to the joint; it multiplies the joint's own acceleration only.",
        "kg m^2, prismatic kg",
        names=True,
        sign="nonnegative",
        default="0",
    ),
    Key("gear", "group", "What turns the motor's angle and current into the joint's.", members=GEAR),
    Key("limits", "group", "Limits of the joint.", members=LIMITS),
    _confidence("the link", "that of the robot"),
    _origin("the link and its joint", "that of the robot"),
    Key(
        "acknowledged",
        "text",
        "Why implausible numbers of this link stand as they are: one sentence. Loading then does not warn of "
        "them; --strict still refuses them.",
    ),
    Key("friction", "group", "Friction in the joint.", members=FRICTION),
    Key(
        "effects",
        "effects of a joint",
        "What this joint and its link have beyond a rigid body: friction, gear, elasticity, sensors.",
    ),
)
IMPORTED = (
    Key("file", "text", "Name of the file.", required=True),
    Key("format", "text", "Its format, such as URDF.", required=True),
    *(Key(part, "texts", text) for part, text in PARTS.items()),
)
ROBOT = (
    Key(
        "name",
        "name",
        f"A C identifier of at most {ROBOT_NAME_LENGTH} characters; it prefixes every emitted symbol.",
        required=True,
    ),
    Key("title", "text", f"One line of at most {TEXT_LENGTH} characters."),
    Key("source", "text", f"Where the numbers come from: one line of at most {TEXT_LENGTH} characters."),
    Key(
        "imported",
        "group",
        "The file that this was imported from, and what is not here.",
        members=IMPORTED,
    ),
    Key(
        "gravity",
        "vector",
        "Acceleration of free fall [x, y, z] in the base frame; with base in the world's.",
        "m/s^2",
        default="[0, 0, -9.81]",
    ),
    Key(
        "base",
        "group",
        "Where the base frame stands in the world; gravity is then in the world's frame.",
        members=PLACEMENT,
    ),
    _confidence("all links that do not state their own", "not stated; 0.1 where a number is needed"),
    _origin("all links that do not state their own", "stated; assumed where confidence is unknown"),
    Key("compare", "group", "The row of the thesis that this robot is set beside.", members=COMPARE),
    Key(
        "convention",
        "choice",
        "mdh: modified (Craig) Denavit-Hartenberg; sdh: standard, rows hold a_i and alpha_i, is converted. "
        "Bearings and contacts among the effects are meant in the modified frames either way.",
        choices=("mdh", "sdh"),
        default="mdh",
    ),
    Key(
        "links",
        "list",
        f"The links with their joints, base to tip, 1 to {LINKS}.",
        required=True,
        members=LINK,
    ),
    Key("tool", "group", "Where the tool's frame stands in the last link's frame.", members=PLACEMENT),
    Key(
        "standard_end",
        "group",
        "Of rows that were converted from standard DH: where the last link's standard frame stands in its "
        "modified one. link_poses are then those of the standard frames.",
        members=PLACEMENT,
    ),
    Key(
        "torque_side",
        "choice",
        "motor: the motor torque, reflected to the joint (rotor, friction in it); link: behind the gear.",
        choices=("motor", "link"),
        default="motor",
    ),
    Key(
        "friction_at_rest",
        "rest",
        "exact: sgn(0) = 0; smooth: {velocity: v}: tanh(qd/v) in place of the sign; "
        "dead_band: {velocity: v}: 0 in place of the sign below v.",
        choices=("exact", "smooth", "dead_band"),
        default="exact",
        members=(
            Key(
                "velocity",
                "number",
                "Speed over which the sign is smoothed, or below which it is 0.",
                "rad/s, prismatic m/s",
                sign="positive",
                default=REST_VELOCITY,
            ),
        ),
    ),
    Key(
        "effects",
        "effects of the robot",
        "Effects of the whole robot: payload, contacts, what holds for all joints.",
    ),
)
