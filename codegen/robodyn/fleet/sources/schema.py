"""The keys of ``fleet.toml``: of what kind their values are, by which the file is read, and as JSON Schema,
for editors that complete and check TOML files."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import date
from typing import Any, Final

from robodyn.errors import InputError
from robodyn.fleet.limits import LONGEST_FORMAT, LONGEST_NAME
from robodyn.fleet.sources.manifest import COLUMNS
from robodyn.project.tables import Key, Tables, shown

Schema = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Kind:
    """What values are: whether one ``is_one``, and the same as a part of a ``schema``; what the values of a
    table are, where they may have any names (``inner``)."""

    is_one: Callable[[Any], bool]
    schema: Schema
    inner: Kind | None = None


def _is_text(value: Any) -> bool:
    return isinstance(value, str) and value != "" and "\0" not in value


def _is_name(value: Any) -> bool:
    return _is_text(value) and bool(value.strip()) and len(value) <= LONGEST_NAME


def _is_number(value: Any) -> bool:
    return type(value) in (int, float) and abs(value) < sys.float_info.max  # a whole number may have any size


def _list_of(one: Kind) -> Kind:
    return Kind(
        lambda value: isinstance(value, list) and all(map(one.is_one, value)),
        {"type": "array", "items": one.schema},
    )


def _table_of(one: Kind) -> Kind:
    return Kind(
        lambda value: isinstance(value, dict) and all(map(one.is_one, value.values())),
        {"type": "object", "additionalProperties": one.schema},
        one,
    )


def _either(one: Kind, other: Kind) -> Kind:
    return Kind(lambda value: one.is_one(value) or other.is_one(value), {"oneOf": [one.schema, other.schema]})


_TEXT: Final = Kind(_is_text, {"type": "string", "minLength": 1})
_NAME: Final = Kind(_is_name, {"type": "string", "minLength": 1, "maxLength": LONGEST_NAME, "pattern": r"\S"})
_NUMBERS: Final = _table_of(Kind(_is_number, {"type": "number"}))
_CONDITIONS: Final = Kind(
    lambda value: _NUMBERS.is_one(value) and not set(value) & set(COLUMNS),
    {**_NUMBERS.schema, "propertyNames": {"not": {"enum": list(COLUMNS)}}},
    _NUMBERS.inner,
)
_DATE: Final = Kind(
    lambda value: isinstance(value, str | date), {"type": "string", "maxLength": LONGEST_FORMAT}
)
_OF_NAMES: Final = Kind(
    lambda value: _table_of(_TEXT).is_one(value) and set(value) <= set(COLUMNS),
    {"type": "object", "properties": dict.fromkeys(COLUMNS, _TEXT.schema), "additionalProperties": False},
)
_ZONE: Final = "of dates that state none: UTC, an offset such as +02:00, or a name such as Europe/Berlin"
TOP: Final = {
    "name": (_NAME, "what the fleet is called  [default: its folder's name]"),
    "timezone": (_TEXT, f"{_ZONE}  [default: UTC]"),
    "types": (_table_of(Kind(lambda value: isinstance(value, dict), {})), "a table for each type of arms"),
    "logs": (_list_of(Kind(lambda value: isinstance(value, dict), {})), "a table for each place of logs"),
}
OF_TYPE: Final = {
    "robot": (_TEXT, "the description: a path as seen from this file's folder, or a bundled robot  "
              "[default: the name of this table]"),
    "map": (_TEXT, "the map of the logs (docs/logs.md), as seen from this file's folder"),
    "columns": (_TEXT, "the same in one line: t=time[ms],q=joint_%d_pos[deg],tau=i_%d[A]"),
    "parameters": (_NUMBERS, "values of the description's run-time parameters, SI units"),
}  # fmt: skip
_OF_BOTH: Final = {
    "exclude": (_either(_TEXT, _list_of(_TEXT)), "patterns of paths that are left out, with all in them"),
    "type": (_NAME, "the type of logs for which nothing else says it"),
    "unit": (_NAME, "the unit of logs for which nothing else says it"),
    "date": (_DATE, "how dates are written: as Python's strptime, unix, or unix_ms; log: the times in the "
             "log are dates; or a date that holds for all of them  [default: ISO 8601]"),
    "timezone": (_TEXT, f"{_ZONE}  [default: that of the file]"),
}  # fmt: skip
OF_FILES: Final = {
    "files": (_TEXT, "a pattern of paths: logs/{type}/{unit}/{date}.csv; any other field is a condition, "
              "* any text, ** any folders"),
    **_OF_BOTH,
    "conditions": (_CONDITIONS, "numbers by name: conditions that hold for all of these logs"),
}  # fmt: skip
OF_MANIFEST: Final = {
    "manifest": (_TEXT, "a table of logs: CSV with a line of names"),
    **_OF_BOTH,
    "columns": (_OF_NAMES, "what its columns are called, where not source, type, unit and date"),
    "conditions": (_either(_list_of(_TEXT), _table_of(_TEXT)),
                   "its columns with conditions: a list, or a table of columns by conditions  "
                   "[default: all other columns]"),
}  # fmt: skip


def check_table(tables: Tables, at: tuple[Key, ...], keys: Mapping[str, tuple[Kind, str]]) -> None:
    """Hold the table at a key to the ``keys`` that it may have.

    Raises
    ------
    InputError: it has another, or the value of one is of another kind; with its place.
    """
    tables.check_keys(at, keys)
    for name, value in tables.table(*at).items():
        kind, words = keys[name]
        if kind.is_one(value):
            continue
        wrong: tuple[Key, ...] = (name,)
        if kind.inner is not None and isinstance(value, dict):
            bad = [key for key in value if not kind.inner.is_one(value[key])]
            wrong, value = (name, *bad[:1]), value[bad[0]] if bad else value
        where = tables.places.of(*at, *wrong)
        what = f"{wrong[-1]} is not what it may be"
        raise InputError(what, where=where, found=shown(value), expected=words)


def fleet_file_schema() -> Schema:
    """The schema of the file."""
    types = {"minProperties": 1, "propertyNames": _NAME.schema, "additionalProperties": {
        **_table(OF_TYPE), "not": {"required": ["map", "columns"]},
    }}  # fmt: skip
    logs = {"minItems": 1, "items": {"oneOf": [_table(OF_FILES, "files"), _table(OF_MANIFEST, "manifest")]}}
    schema = _table(TOP, "types", "logs")
    schema["properties"]["types"] |= types
    schema["properties"]["logs"] |= logs
    head = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "fleet.toml"}
    return {**head, **schema}


def _table(keys: Mapping[str, tuple[Kind, str]], *required: str) -> Schema:
    return {
        "type": "object",
        "properties": {name: {**kind.schema, "description": words} for name, (kind, words) in keys.items()},
        "additionalProperties": False,
        "required": list(required),
    }
