"""The description's JSON Schema, so that editors complete and check a robot file, and a commented file to
begin with."""

from __future__ import annotations

import re
from dataclasses import replace
from string import Template
from typing import Any

from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError
from robodyn.resources import data_dir
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
    if key.kind in ("vector", "angles", "range"):
        count = 2 if key.kind == "range" else 3
        return {"type": "array", "items": _number(key), "minItems": count, "maxItems": count}
    if key.kind in ("effects of a joint", "effects of the robot"):
        entry = "joint_effect" if key.kind == "effects of a joint" else "robot_effect"
        return {"type": "array", "items": {"$ref": f"#/$defs/{entry}"}, "maxItems": EFFECTS}
    words = {"enum": list(key.choices)}
    with_velocity = [
        {"type": "object", "properties": {rule: _object(key.members)}, "required": [rule],
         "additionalProperties": False}
        for rule in key.choices[1:]
    ]  # fmt: skip
    examples = ["exact", {"smooth": {"velocity": float(REST_VELOCITY)}}]
    numbers = {"anyOf": [*_number(key)["anyOf"], *({"const": word} for word in key.choices)]}
    # YAML makes a number of a bare 2.10: the reader takes texts as they stand.
    schemas: dict[str, Schema] = {
        "name": {"type": "string", "pattern": f"^[A-Za-z][A-Za-z0-9_]{{0,{ROBOT_NAME_LENGTH - 1}}}$"},
        "text": {"type": ["string", "number"], "maxLength": TEXT_LENGTH},
        "texts": {"type": "array", "items": {"type": ["string", "number"]}},
        "choice": words,
        "number": numbers,
        "angle": numbers,
        "group": _object(key.members),
        "rest": {"anyOf": [words, *with_velocity], "examples": examples},
        "origins": {"anyOf": [words, _object(key.members)]},
        "efficiency": _share(key),
        "joint": {"type": "integer", "minimum": 1, "maximum": LINKS},
        "list": {"type": "array", "items": _object(key.members), "minItems": 1, "maxItems": LINKS},
    }
    return schemas[key.kind]


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
    text = (data_dir("templates") / "starter.txt").read_text(encoding="utf-8")
    first, another, end = re.split(r"%%.*\n", text)
    parts = [Template(first).substitute(name=name, title=title)]
    for i in range(2, joints + 1):
        # A shoulder that turns the axis, then parallel joints: an arm in a plane.
        alpha, a = ("-pi/2", "0") if i == 2 else ("0", "0.3")
        parts.append(Template(another).substitute(i=i, alpha=alpha, a=a, mass=f"{max(8.0 / i, 0.1):.1f}"))
    return "".join(parts) + end
