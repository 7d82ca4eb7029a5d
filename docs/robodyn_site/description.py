"""The keys of a robot's description, from the JSON Schema that ``robodyn schema`` prints."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

from robodyn.robot import json_schema
from robodyn_site.markdown import code, fenced, page, plain, table

PATH: Final = "description.md"
_TITLES: Final = {"": "The robot", "links[]": "A link"}
Schema = Mapping[str, Any]


def pages() -> dict[str, str]:
    """One page."""
    return {PATH: of_schema(json_schema())}


def of_schema(schema: Schema) -> str:
    """A table of keys for each object of the schema; effects have pages of their own."""
    return page(
        "# Keys of a description",
        "Every key that the description of a robot may have, in YAML. An editor that is given the JSON "
        "Schema completes and checks them; `robodyn new` writes a commented file to start from, and "
        "[Describe a robot](describe-a-robot.md) explains one.",
        fenced("robodyn schema > robodyn.schema.json\nrobodyn new crane --joints 3", "sh"),
        "Numbers may be arithmetic (`-pi/2`); where a key says so, a name in them becomes an argument of the "
        "kernels.",
        *_objects("", schema),
    )


def _objects(path: str, schema: Schema) -> Iterator[str]:
    properties: Mapping[str, Schema] = schema["properties"]
    required = schema.get("required", ())
    yield f"## {_TITLES.get(path) or code(path)}"
    rows = [_row(name, below, name in required) for name, below in properties.items()]
    yield table(("key", "what", "values"), rows)
    for name, below in properties.items():
        inner, mark = (below["items"], "[]") if below.get("type") == "array" else (below, "")
        if "properties" in inner:
            yield from _objects(f"{path}.{name}{mark}".lstrip("."), inner)


def _row(name: str, schema: Schema, required: bool) -> tuple[str, str, str]:
    what = plain(schema.get("description", ""))
    return code(name), what + (" **Required.**" if required else ""), _values(schema)


def _values(schema: Schema) -> str:
    if "$ref" in schema:
        name = schema["$ref"].rpartition("/")[2]
        return "[effects](effects.md)" if name.endswith("_effect") else "arithmetic"
    if "enum" in schema:
        return ", ".join(code(str(value)) for value in schema["enum"])
    if "anyOf" in schema or "oneOf" in schema:
        choices = [_values(choice) for choice in schema.get("anyOf", schema.get("oneOf"))]
        return " or ".join(dict.fromkeys(choices))
    kind = schema.get("type", "")
    if kind == "array":
        least, most = schema.get("minItems"), schema.get("maxItems")
        size = f" of {least}" if least == most and least is not None else ""
        return f"list{size}: {_values(schema['items'])}"
    if kind == "object":
        return "keys, see below" if "properties" in schema else "keys"
    if "const" in schema:
        return code(str(schema["const"]))
    if "minimum" in schema:
        return f"{kind}, {schema['minimum']} or more"
    if "exclusiveMinimum" in schema:
        return f"{kind} above {schema['exclusiveMinimum']}"
    return kind if isinstance(kind, str) else " or ".join(kind)
