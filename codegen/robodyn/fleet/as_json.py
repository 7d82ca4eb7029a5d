"""A fleet's result as ``fleet.json`` has it, and the JSON Schema of that file."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from datetime import UTC, datetime
from types import NoneType, UnionType
from typing import Any, Final, Literal, Union, get_args, get_origin, get_type_hints

from robodyn.fleet.result import (
    Claim,
    Feature,
    FleetResult,
    Look,
    NotObserved,
    OddLog,
    Reading,
    TypeResult,
    UnitResult,
    Unused,
)

#: Fields that are points in time.
DAYS: Final = frozenset({"since", "since_interval", "until", "first", "last", "date"})


def document(result: FleetResult) -> dict[str, Any]:
    """``result`` of plain values: the fields of its dataclasses by their names, but readings as columns.

    Points in time are ISO 8601, UTC, to the second. What is no number (NaN, infinity) is None.
    """
    plain = _plain(result)
    assert isinstance(plain, dict)
    return plain


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

DESCRIPTIONS: Final[Mapping[type, Mapping[str, str]]] = {
    FleetResult: {
        "name": "The fleet's name.",
        "types": "What units of a type have in common.",
        "units": "Units, by type and name.",
        "unused": "Logs that were not used.",
        "not_observed": "Joints of which the logs say too little for a change to be told.",
        "odd_logs": "Logs that are off from all others of their unit and program: single ones, no changes.",
        "first_to_look_at": "Units to look at, the most urgent first.",
        "false_names": "The share of all named units that are healthy, on average, at most.",
    },
    TypeResult: {
        "name": "The type's name.",
        "joints": "Joints of its arms.",
        "units": "How many units there are.",
        "logs": "How many of their logs were used.",
        "programs": "How many programs of motion these are of.",
        "features": "The numbers that each log of the type shows.",
        "account": "Where the numbers of its description come from, and what of its file is not in it.",
    },
    Feature: {
        "name": "Its name, unique within the type.",
        "effects": "Ids of the catalogue: what they do together. None: what no effect explains.",
        "joint": "The joint, from 1; null: the whole arm.",
        "unit": "The unit of measurement.",
        "mean": "The mean of the type.",
        "between_units": "Standard deviation from unit to unit.",
        "between_logs": "Standard deviation from log to log of one unit.",
        "slopes": "Change with a condition, by its name, a unit of the condition.",
        "logs": "How many logs show it.",
    },
    UnitResult: {
        "type": "The type's name.",
        "unit": "The unit's name.",
        "logs": "How many of its logs were used.",
        "first": "The first of them.",
        "last": "The last of them.",
        "claims": "What is peculiar to it, the surest first.",
        "readings": "By feature: what each log shows.",
        "now": "By feature: value after pooling, and its standard error.",
        "unusual": "By feature: standard deviations that are as rare by chance; negative: less than usual.",
        "diagnosis": "The page of its diagnosis, relative to this file; null: there is none.",
    },
    Claim: {
        "effects": "Ids of the catalogue, or program_change, clock; of several, what they do together. "
        "None: no effect explains it.",
        "joint": "The joint, from 1; null: the whole arm.",
        "feature": "The type's feature that shows it.",
        "shape": "How it came: gradually, at once, or so in all logs.",
        "since": "The day from which on it is so; null: in all logs.",
        "since_interval": "Days between which the change was, in 95 of 100 cases.",
        "until": "The day from which on a drift has not grown; null: it still does, or it was none.",
        "size": "How much more there is than there was, or than its siblings have.",
        "stderr": "The standard error of the size.",
        "unit": "The unit of measurement of both.",
        "share": "The size as a share of what there was; null where that was nothing.",
        "p": "How often chance alone makes a unit look as odd, over all features and days.",
        "q": "The share of healthy units among all that are named and no less sure.",
    },
    Reading: {
        "date": "Days of the logs.",
        "value": "What each shows, without what conditions do.",
        "stderr": "Standard errors.",
        "program": "The program of motion of each log, from 1 within the type.",
    },
    Unused: {
        "source": "The log, as the fleet names it.",
        "type": "The type's name.",
        "unit": "The unit's name.",
        "why": "Why it was not used.",
    },
    NotObserved: {
        "type": "The type's name.",
        "unit": "The unit's name.",
        "joint": "The joint, from 1; null: all of the arm.",
        "reason": "Why no change can be told.",
        "record": "What to record.",
    },
    OddLog: {
        "type": "The type's name.",
        "unit": "The unit's name.",
        "source": "The log, as the fleet names it.",
        "date": "When it was recorded.",
        "feature": "The type's feature in which it is off most.",
    },
    Look: {
        "type": "The type's name.",
        "unit": "The unit's name.",
        "why": "Why to look at it.",
        "action": "What to do.",
        "record": "What to record next.",
    },
}
"""What each field is, by the class that has it."""


def fleet_schema() -> Schema:
    """The schema of ``fleet.json``."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "fleet.json",
        "description": "What robodyn fleet writes of a fleet.",
        **_of_class(FleetResult),
    }


def _of_class(kind: type) -> Schema:
    hints = get_type_hints(kind)
    properties = {
        each.name: {"description": DESCRIPTIONS[kind][each.name], **_of(hints[each.name], each.name)}
        for each in fields(kind)
    }
    return _object(properties)


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
    if origin in (Union, UnionType):
        (some,) = (part for part in parts if part is not NoneType)
        return _or_null(_of(some, field))
    if origin is Literal:
        return {"enum": list(parts)}
    if field == "readings":
        return {"type": "object", "additionalProperties": _columns_of_readings()}
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


def _columns_of_readings() -> Schema:
    """Readings: lists of one length."""
    hints = get_type_hints(Reading)
    return _object(
        {
            each.name: {
                "description": DESCRIPTIONS[Reading][each.name],
                "type": "array",
                "items": _of(hints[each.name], each.name),
            }
            for each in fields(Reading)
        }
    )


def _or_null(schema: Schema) -> Schema:
    kind = schema.get("type")
    if kind is None or "prefixItems" in schema:
        return {"anyOf": [schema, {"type": "null"}]}
    return schema if "null" in kind else {**schema, "type": [kind, "null"]}
