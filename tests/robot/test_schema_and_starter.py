"""The JSON Schema and the starter file: both agree with the reader."""

from __future__ import annotations

import re
from typing import Any

import pytest
import yaml

from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError
from robodyn.robot import bundled_names, bundled_text, json_schema, read_text, starter
from robodyn.robot.keys import FRICTION, INERTIA, LIMITS, LINK, ROBOT
from robodyn_testing import require_module

jsonschema = require_module("jsonschema")


def _problems(text: str) -> list[str]:
    validator = jsonschema.Draft202012Validator(json_schema())
    return [error.message for error in validator.iter_errors(yaml.safe_load(text))]


@pytest.mark.parametrize("name", bundled_names())
def test_bundled_robots_satisfy_it(name: str) -> None:
    assert _problems(bundled_text(name)) == []


def test_it_documents_every_key_with_its_unit() -> None:
    schema = json_schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    link = schema["properties"]["links"]["items"]["properties"]
    for keys, properties in (
        (ROBOT, schema["properties"]),
        (LINK, link),
        (INERTIA, link["inertia"]["properties"]),
        (LIMITS, link["limits"]["properties"]),
        (FRICTION, link["friction"]["properties"]),
    ):
        assert [key.name for key in keys] == list(properties)
        for key in keys:
            assert key.unit in properties[key.name]["description"]
    assert schema["required"] == ["name", "links"]
    assert schema["properties"]["links"]["items"]["required"] == ["joint"]


LINK1 = "name: arm\nlinks:\n  - joint: revolute\n    "
SLIDE = "name: arm\nlinks: [{joint: prismatic}]\n"


@pytest.mark.parametrize(
    "text",
    [
        LINK1 + "alpha: -pi/2\n    d: 17*0.0254\n    mass: m_tool\n    a: 1e-3",
        LINK1 + "com: [0, x, (1 + 2)*pi]",
        LINK1 + "inertia: {xx: 1, yz: -i_yz}",
        LINK1 + "limits: {position: [-pi, pi], velocity: 3}",
        LINK1 + "confidence: 1",
        LINK1 + "inertia: {xx: i_x}\n    acknowledged: why",
        LINK1 + "effects: []",
        LINK1 + "b: 1e-3",
        SLIDE + "base: {rpy: [pi, 0, 0]}\ntool: {xyz: [0, 0, 1/2]}",
        LINK1 + "effects: [{effect: transmission_loss, efficiency: 1/2}, {effect: spring, stiffness: -k}]",
        LINK1 + "effects: [{effect: transmission_loss, efficiency: [[0, 0.5], [1, 1]], rated_torque: 9}]",
        SLIDE + "effects: [{effect: time_delay, delay: 1e-3}]",
        SLIDE + "effects: [{effect: payload, mass: m, inertia: {xx: 1}}]",
        SLIDE + "friction_at_rest: {dead_band: {velocity: 1e-2}}",
        SLIDE + "friction_at_rest: dead_band",
        "name: arm\ntitle: 2.10\nlinks: [{joint: prismatic}]\nfriction_at_rest: exact",
        SLIDE + "friction_at_rest: {smooth: {velocity: 1e-3}}",
        SLIDE + "convention: sdh\ntorque_side: link",
        "name: arm\ncompare: {table: 2.10, row: puma_6}\nlinks: [{joint: prismatic}]",
    ],
)
def test_what_the_reader_takes_the_schema_takes(text: str) -> None:
    read_text(text)
    assert _problems(text) == []


@pytest.mark.parametrize(
    "text",
    [
        "name: arm",
        "links: [{joint: revolute}]",
        "name: arm\nlinks: []",
        "name: 5arm\nlinks: [{joint: revolute}]",
        "name: arm\nlinks: [{joint: fixed}]",
        "name: arm\nlinks: [{}]",
        LINK1 + "mass: -1",
        LINK1 + "masss: 1",
        LINK1 + "alpha: twist",
        LINK1 + "mass: 2**3 ^ 1",
        LINK1 + "mass: __import__('os')",
        LINK1 + "com: [1, 2]",
        LINK1 + "inertia: [1, 2, 3]",
        LINK1 + "confidence: 2",
        LINK1 + "limits: {velocity: 0}",
        LINK1 + "effects: [{effect: spring}]",
        LINK1 + "effects: [spring]",
        LINK1 + "b: [1]",
        SLIDE + "base: {rpy: [pi, 0]}",
        SLIDE + "tool: {xyz: [0, 0, z]}",
        SLIDE + "tool: [0, 0, 1]",
        LINK1 + "effects: [{stiffness: 1}]",
        LINK1 + "effects: [{effect: springs, stiffness: 1}]",
        LINK1 + "effects: [{effect: spring, stiffness: 1, damping: 1}]",
        LINK1 + "effects: [{effect: payload, mass: 1}]",
        LINK1 + "effects: [{effect: viscous_friction, coefficient: -1}]",
        LINK1 + "effects: [{effect: torque_bias, bias: b}]",
        LINK1 + "effects: [{effect: transmission_loss, efficiency: 1.1}]",
        LINK1 + "effects: [{effect: transmission_loss, efficiency: [[0, 1]], rated_torque: 1}]",
        LINK1 + "effects: [{effect: transmission_loss, efficiency: [[0, 0], [1, 1]], rated_torque: 1}]",
        LINK1 + "effects: [{effect: transmission_loss, interpolation: square}]",
        LINK1 + "effects: [{effect: motor_coupling, with: 0}]",
        SLIDE + "effects: [{effect: spring, stiffness: 1}]",
        SLIDE + "effects: [{effect: payload, mass: 1, com: [0, 0]}]",
        SLIDE + "friction_at_rest: {dead_band: {velocity: 0}}",
        "name: arm\ngravity: [0, 0, g]\nlinks: [{joint: revolute}]",
        SLIDE + "torque_side: gear",
        SLIDE + "friction_at_rest: {sharp: 1}",
    ],
)
def test_what_the_schema_refuses_the_reader_refuses(text: str) -> None:
    assert _problems(text) != []
    with pytest.raises(InputError):
        read_text(text)


def test_it_documents_every_effect_with_its_parameters_and_units() -> None:
    schema = json_schema()
    lists = schema["properties"]["effects"], schema["properties"]["links"]["items"]["properties"]["effects"]
    offered = {id for one in lists for id in _deep(schema, one["items"])["properties"]["effect"]["enum"]}
    assert offered == set(CATALOGUE)
    for id, effect in CATALOGUE.items():
        properties = schema["$defs"][f"effect_{id}"]["properties"]
        assert list(properties) == ["effect", *effect.names]
        for parameter in effect.parameters:
            told = properties[parameter.name]["description"]
            assert parameter.doc in told
            assert all(unit in told for unit in (parameter.unit, parameter.linear_unit or "") if unit != "1")


def _deep(schema: dict[str, Any], one: dict[str, Any]) -> dict[str, Any]:
    deep: dict[str, Any] = schema["$defs"][one["$ref"].rpartition("/")[2]]
    return deep


@pytest.mark.parametrize("joints", [1, 2, 3, 7, 100])
def test_a_starter_loads_without_a_warning(joints: int) -> None:
    text = starter("my_arm", joints)
    robot = read_text(text, strict=True)
    assert robot.name == "my_arm"
    assert robot.n == joints
    assert _problems(text) == []
    assert text.endswith("\n")
    assert max(map(len, text.splitlines())) <= 110


def test_what_a_starter_hints_at_is_right_and_every_key_is_there() -> None:
    for key in (*LINK, *ROBOT):
        # Without what nobody states by hand.
        if key.name not in ("compare", "covariance", "imported", "standard_end"):
            assert f"{key.name}:" in starter(), key.name
    text = re.sub(r"# (?=(  - \{)?effect)", "", starter())
    robot = read_text(text, strict=True)
    assert [entry.effect for entry in robot.effects] == ["stribeck_friction", "transmission_loss", "payload"]
    assert _problems(text) == []


@pytest.mark.parametrize(
    "arguments",
    [("x; system()", 2), ("double", 2), ("math", 2), ("", 2), ("arm", 0), ("arm", 101), ("arm", -1)],
)
def test_a_starter_refuses_bad_arguments(arguments: tuple[Any, ...]) -> None:
    with pytest.raises(InputError):
        starter(*arguments)
