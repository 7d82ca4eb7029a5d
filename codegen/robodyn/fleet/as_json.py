"""A fleet's result as ``fleet.json`` has it, and the JSON Schema of that file."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from datetime import UTC, datetime
from types import NoneType, UnionType
from typing import Annotated, Any, Final, Literal, Union, get_args, get_origin, get_type_hints

from robodyn.fleet.result import FleetResult, Reading

#: Fields that are points in time.
DAYS: Final = frozenset({"since", "since_interval", "until", "first", "last", "date"})


def document(result: FleetResult) -> dict[str, Any]:
    """``result`` of plain values: the fields of its dataclasses by their names, but readings as columns.

    Points in time are ISO 8601, UTC, to the second. What is no number (NaN, infinity) is None.
    """
    return dict(_plain(result))


def text(document: Mapping[str, Any]) -> str:
    """A ``document`` as text: types, units, logs and so on a line each, so that a fleet of any size can be
    searched and compared by lines; the same bytes from the same result."""
    parts = [f"{json.dumps(key)}: {_lines(value)}" for key, value in document.items()]
    return "{\n" + ",\n".join(parts) + "\n}\n"


def day(seconds: float) -> str:
    """A point in time [s since 1970] as ISO 8601."""
    return datetime.fromtimestamp(round(seconds), UTC).isoformat().replace("+00:00", "Z")


def _lines(value: Any) -> str:
    if isinstance(value, list) and value:
        return "[\n" + ",\n".join(_dumped(each) for each in value) + "\n]"
    return _dumped(value)


def _dumped(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def _plain(value: Any, key: str = "") -> Any:
    if isinstance(value, float):
        if not math.isfinite(value):
            return None
        return day(value) if key in DAYS else value
    if is_dataclass(value):
        return {each.name: _plain(getattr(value, each.name), each.name) for each in fields(value)}
    if isinstance(value, Mapping):
        if key == "readings":
            return {name: _columns(several) for name, several in value.items()}
        return {name: _plain(each) for name, each in value.items()}
    if isinstance(value, tuple | list):
        return [_plain(each, key) for each in value]
    return value


def _columns(readings: Sequence[Reading]) -> dict[str, list[Any]]:
    """Readings as columns, which take a third of the room."""
    names = [each.name for each in fields(Reading)]
    return {name: [_plain(getattr(reading, name), name) for reading in readings] for name in names}


# --- the JSON Schema --------------------------------------------------------------------------------------


Schema = dict[str, Any]


def fleet_schema() -> Schema:
    """The schema of ``fleet.json``."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "fleet.json",
        "description": "What robodyn fleet writes of a fleet.",
        **_of_class(FleetResult),
    }


def _of_class(kind: type) -> Schema:
    hints = get_type_hints(kind, include_extras=True)
    return _object({name: _of(hint, name) for name, hint in hints.items()})


def _object(properties: Mapping[str, Schema]) -> Schema:
    return {
        "type": "object",
        "properties": dict(properties),
        "required": list(properties),
        "additionalProperties": False,
    }


def _of(hint: Any, field: str) -> Schema:
    """The schema of a type; ``field`` is whose it is."""
    origin, parts = get_origin(hint), get_args(hint)
    if origin is Annotated:
        return {"description": parts[1], **_of(parts[0], field)}
    if origin in (Union, UnionType):
        (some,) = (part for part in parts if part is not NoneType)
        schema = _of(some, field)
        if "prefixItems" in schema:
            return {"anyOf": [schema, {"type": "null"}]}
        return schema if "null" in schema["type"] else {**schema, "type": [schema["type"], "null"]}
    if origin is Literal:
        return {"enum": list(parts)}
    if field == "readings":
        columns = {
            name: {"description": one.pop("description"), "type": "array", "items": one}
            for name, one in _of_class(Reading)["properties"].items()
        }
        return {"type": "object", "additionalProperties": _object(columns)}
    if origin is tuple:
        if Ellipsis in parts:
            return {"type": "array", "items": _of(parts[0], field)}
        items = [_of(part, field) for part in parts]
        return {"type": "array", "prefixItems": items, "items": False, "minItems": len(items)}
    if isinstance(origin, type) and issubclass(origin, Mapping):
        return {"type": "object", "additionalProperties": _of(parts[1], "")}
    if is_dataclass(hint) and isinstance(hint, type):
        return _of_class(hint)
    if hint is float:
        return {"type": "string", "format": "date-time"} if field in DAYS else {"type": ["number", "null"]}
    return {"type": {int: "integer", str: "string"}[hint]}
