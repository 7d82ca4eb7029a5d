"""The JSON Schema and the starter file: both agree with the reader."""

from __future__ import annotations

import re
from pathlib import Path
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


TEXTS = yaml.safe_load(Path(__file__).with_name("schema.yaml").read_text(encoding="utf-8"))


def test_what_the_reader_takes_the_schema_takes() -> None:
    for text in TEXTS["taken"]:
        read_text(text)
        assert _problems(text) == [], text


def test_what_the_schema_refuses_the_reader_refuses() -> None:
    for text in TEXTS["refused"]:
        assert _problems(text) != [], text
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
