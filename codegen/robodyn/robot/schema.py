"""The description's JSON Schema, so that editors complete and check a robot file, and a commented file to
begin with."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError
from robodyn.robot.effects import belongs, keys_of
from robodyn.robot.keys import EFFECTS, KNOTS, LINKS, REST_VELOCITY, ROBOT, Key
from robodyn.robot.names import PARAMETER_NAME_LENGTH, ROBOT_NAME_LENGTH, TEXT_LENGTH, check_robot_name
from robodyn.robot.numbers import LENGTH

Schema = dict[str, Any]

_LITERAL = r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][-+]?[0-9]+)?"
_NAME = f"[A-Za-z][A-Za-z0-9_]{{0,{PARAMETER_NAME_LENGTH - 1}}}"
_ARITHMETIC = rf"^(?:[-+*/() ]|pi\b|{_LITERAL})+$"
_WITH_NAMES = rf"^(?:[-+*/() ]|{_NAME}\b|{_LITERAL})+$"


def json_schema() -> Schema:
    """JSON Schema (2020-12) of the robot description, with descriptions and units.

    It is made from the table of keys and the catalogue of effects that the reader uses. What a schema cannot
    say (parameters that differ by case, tensors that no body has, effects that do not go together) is left to
    the reader.
    """
    schema: Schema = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "robodyn robot description",
        "description": "A serial arm, base to tip, in SI units.",
    }
    schema.update(_object(ROBOT))
    schema["$defs"] = {
        "arithmetic": {
            "type": "string",
            "maxLength": LENGTH,
            "pattern": _ARITHMETIC,
            "description": "Arithmetic with numbers, pi and + - * / ( ), such as -pi/2.",
        },
        "arithmetic_with_names": {
            "type": "string",
            "maxLength": LENGTH,
            "pattern": _WITH_NAMES,
            "description": "Arithmetic as above; a name becomes a run-time parameter of the kernels.",
        },
        "joint_effect": _effects(of_robot=False),
        "robot_effect": _effects(of_robot=True),
    }
    schema["$defs"].update({f"effect_{id}": _effect(id) for id in CATALOGUE})
    return schema


def _effects(*, of_robot: bool) -> Schema:
    ids = [id for id, effect in CATALOGUE.items() if belongs(effect, of_robot=of_robot)]
    return {
        "type": "object",
        "properties": {"effect": {"enum": ids}},
        "required": ["effect"],
        "oneOf": [{"$ref": f"#/$defs/effect_{id}"} for id in ids],
    }


def _effect(id: str) -> Schema:
    effect = CATALOGUE[id]
    schema = _object(keys_of(id))
    schema["properties"]["effect"] = {"const": id, "description": effect.title + "."}
    return {"title": effect.title, "description": effect.doc, **schema}


def _object(keys: tuple[Key, ...]) -> Schema:
    schema: Schema = {
        "type": "object",
        "properties": {key.name: _documented(key) for key in keys},
        "additionalProperties": False,
    }
    required = [key.name for key in keys if key.required]
    return {**schema, "required": required} if required else schema


def _documented(key: Key) -> Schema:
    description = key.doc + (f" [{key.unit}]" if key.unit else "")
    if key.names:
        description += " A name makes it a run-time parameter."
    if key.default:
        description += f" Default: {key.default}."
    return {"description": description, **_of_kind(key)}


def _of_kind(key: Key) -> Schema:
    if key.kind == "name":
        return {"type": "string", "pattern": f"^[A-Za-z][A-Za-z0-9_]{{0,{ROBOT_NAME_LENGTH - 1}}}$"}
    if key.kind == "text":
        # YAML makes a number of a bare 2.10: the reader takes the text as it stands.
        return {"type": ["string", "number"], "maxLength": TEXT_LENGTH}
    if key.kind == "texts":
        return {"type": "array", "items": {"type": ["string", "number"]}}
    if key.kind == "choice":
        return {"enum": list(key.choices)}
    if key.kind in ("number", "angle"):
        return {"anyOf": [*_number(key)["anyOf"], *({"const": word} for word in key.choices)]}
    if key.kind in ("vector", "angles", "range"):
        count = 2 if key.kind == "range" else 3
        return {"type": "array", "items": _number(key), "minItems": count, "maxItems": count}
    if key.kind == "group":
        return _object(key.members)
    if key.kind == "rest":
        with_velocity = [
            {
                "type": "object",
                "properties": {rule: _object(key.members)},
                "required": [rule],
                "additionalProperties": False,
            }
            for rule in key.choices[1:]
        ]
        example = {"smooth": {"velocity": float(REST_VELOCITY)}}
        return {"anyOf": [{"enum": list(key.choices)}, *with_velocity], "examples": ["exact", example]}
    if key.kind == "origins":
        return {"anyOf": [{"enum": list(key.choices)}, _object(key.members)]}
    if key.kind == "efficiency":
        return _share(key)
    if key.kind == "joint":
        return {"type": "integer", "minimum": 1, "maximum": LINKS}
    if key.kind in ("effects of a joint", "effects of the robot"):
        entry = "joint_effect" if key.kind == "effects of a joint" else "robot_effect"
        return {"type": "array", "items": {"$ref": f"#/$defs/{entry}"}, "maxItems": EFFECTS}
    return {"type": "array", "items": _object(key.members), "minItems": 1, "maxItems": LINKS}


def _share(key: Key) -> Schema:
    few, many = KNOTS
    knot: Schema = {
        "type": "array",
        "prefixItems": [_number(replace(key, sign="nonnegative")), _number(key)],
        "minItems": 2,
        "maxItems": 2,
    }
    table = {"type": "array", "items": knot, "minItems": few, "maxItems": many}
    return {"anyOf": [*_number(key)["anyOf"], table]}


def _number(key: Key) -> Schema:
    schema: Schema = {"type": "number"}
    if key.sign == "nonnegative":
        schema["minimum"] = 0
    elif key.sign == "nonzero":
        schema["not"] = {"const": 0}
    elif key.sign != "any":
        schema["exclusiveMinimum"] = 0
    if key.sign == "share":
        schema["maximum"] = 1
    text = "arithmetic_with_names" if key.names else "arithmetic"
    return {"anyOf": [schema, {"$ref": f"#/$defs/{text}"}]}


# --- a file to begin with ---------------------------------------------------------------------------------

_HEAD = """\
# A serial arm, base to tip, in SI units. Change the numbers; delete what you do not know.
# A number may be arithmetic with pi (-pi/2, 17*0.0254), or a name (mass: m_tool): a name becomes a
# run-time parameter of the generated kernels.
name: {name}                     # a C identifier; prefixes every emitted symbol
title: {title}
source: where the numbers come from
gravity: [0, 0, -9.81]           # in the base frame, m/s^2; with base in the world's
# base: {{xyz: [0, 0, 0.5], rpy: [pi, 0, 0]}}  # the base frame in the world: from a ceiling; rpy as in URDF
# confidence: unknown            # the inertial numbers of all links are a guess
# origin: {{inertial: measured}}   # where numbers come from: stated, measured, assumed or synthetic

# Modified (Craig) Denavit-Hartenberg frames: from frame i-1 turn alpha about x and go a along x, then
# turn theta about z and go d along z. Rows of standard DH: add the line "convention: sdh".
links:
"""
_FIRST = """\
  - name: link1
    joint: revolute              # or prismatic
    alpha: 0                     # alpha_{i-1}, rad
    a: 0                         # a_{i-1}, m
    # b: 0                       # along y behind alpha, m: short offsets where axes are nearly parallel
    d: 0.4                       # m; prismatic: constant added to q
    theta: 0                     # rad; revolute: constant added to q
    # pose: {xyz: [0, 0, 0.4], rpy: [0, 0, 0]}  # in place of these numbers: joint's frame in the one before
    mass: 8.0                    # kg
    com: [0, -0.02, -0.1]        # in the link's frame, m
    inertia: {xx: 0.05, yy: 0.05, zz: 0.03, xy: 0, xz: 0, yz: 0}  # about the centre of mass, kg m^2
    motor_inertia: 0.5           # rotor, reflected to the joint; kg m^2, prismatic kg
    gear: {ratio: 100, torque_constant: 0.12}                     # motor turns a joint turn; motor N m/A
    friction: {viscous: 1.0, coulomb: 2.0}                        # N m s/rad, N m
    limits: {position: [-pi, pi], velocity: 3.0, acceleration: 10.0, torque: 150}
    confidence: 0.1              # inertial numbers are right to about this share; or unknown
    # acknowledged: why          # implausible numbers stand as they are: no warning; --strict refuses
    # effects:                   # what the joint has beyond a rigid body
    #   - {effect: stribeck_friction, level: 2.0, static: 3.0, velocity: 0.05}  # in place of coulomb
    #   - {effect: transmission_loss, efficiency: 0.85}
"""
_MORE = """\
  - name: link{i}
    joint: revolute
    alpha: {alpha}
    a: {a}
    d: 0
    theta: 0
    mass: {mass}
    com: [0.15, 0, 0]
    inertia: {{xx: 0.01, yy: 0.04, zz: 0.04}}                         # entries left out are 0
    motor_inertia: 0.2
"""
_TAIL = """\

# tool: {xyz: [0, 0, 0.1], rpy: [0, 0, 0]}  # the tool's frame in the last link's
# torque_side: motor             # motor (default): rotor and friction are in the torque; or link
# friction_at_rest: exact        # or {smooth: {velocity: 1e-3}}, or {dead_band: {velocity: 1e-3}}
# effects:                       # of the whole robot
#   - {effect: payload, mass: m_load, com: [0, 0, 0.1]}
"""


def starter(name: str = "my_arm", joints: int = 2) -> str:
    """A commented description of a made-up arm, ending in a line break; it loads without a warning.

    Raises
    ------
    InputError: ``name`` is not a robot's name, or ``joints`` is not in 1 ... 100.
    """
    check_robot_name(name)
    if not 1 <= joints <= LINKS:
        raise InputError("the number of joints is out of range", found=str(joints), expected=f"1 to {LINKS}")
    title = f"An arm with {joints} joint" + ("s" if joints > 1 else "")
    parts = [_HEAD.format(name=name, title=title), _FIRST]
    for i in range(2, joints + 1):
        # A shoulder that turns the axis, then parallel joints: an arm in a plane.
        alpha, a = ("-pi/2", "0") if i == 2 else ("0", "0.3")
        mass = f"{max(8.0 / i, 0.1):.1f}"
        parts.append(_MORE.format(i=i, alpha=alpha, a=a, mass=mass))
    return "".join(parts) + _TAIL
