"""The keys of ``fleet.toml``, and its JSON Schema, for editors that complete and check TOML files."""

from __future__ import annotations

from typing import Any, Final

from robodyn.fleet.limits import LONGEST_FORMAT, LONGEST_NAME
from robodyn.fleet.sources.manifest import COLUMNS

Schema = dict[str, Any]


def _text(words: str, **more: Any) -> Schema:
    return {"type": "string", "minLength": 1, **more, "description": words}


def _name(words: str) -> Schema:
    return _text(words, maxLength=LONGEST_NAME)


def _by_name(values: Schema, words: str) -> Schema:
    return {"type": "object", "additionalProperties": values, "description": words}


def _table(keys: dict[str, Schema], *required: str) -> Schema:
    return {
        "type": "object",
        "properties": keys,
        "additionalProperties": False,
        **({"required": list(required)} if required else {}),
    }


_ZONE: Final = "Of dates that state none: UTC, an offset such as +02:00, or a name such as Europe/Berlin."
_TEXTS: Final[Schema] = {"type": "array", "items": {"type": "string", "minLength": 1}}
_NUMBER: Final[Schema] = {"type": "number"}
OF_TYPE: Final = {
    "robot": _text(
        "The description: a path as seen from this file's folder, or a bundled robot.  "
        "[default: the name of this table]"
    ),
    "map": _text("The map of the logs (docs/logs.md), as seen from this file's folder."),
    "columns": _text("The same in one line: t=time[ms],q=joint_%d_pos[deg],tau=i_%d[A]."),
    "parameters": _by_name(_NUMBER, "Values of the description's run-time parameters, SI units."),
}
_OF_BOTH: Final = {
    "exclude": {
        "description": "Patterns of paths that are left out, with all that is in them.",
        "oneOf": [{"type": "string", "minLength": 1}, _TEXTS],
    },
    "type": _name("The type of logs for which nothing else says it."),
    "unit": _name("The unit of logs for which nothing else says it."),
    "date": {
        "description": "How dates are written: as Python's strptime, unix, or unix_ms; log: the times in the "
        "log are dates; or a date that holds for all of them.  [default: ISO 8601]",
        "type": "string",
        "maxLength": LONGEST_FORMAT,
    },
    "timezone": _text(f"{_ZONE}  [default: that of the file]"),
}
OF_FILES: Final = {
    "files": _text(
        "A pattern of paths: logs/{type}/{unit}/{date}.csv; any other field is a condition, "
        "* any text, ** any folders."
    ),
    **_OF_BOTH,
    "conditions": _by_name(_NUMBER, "Conditions that hold for all of these logs."),
}
OF_MANIFEST: Final = {
    "manifest": _text("A table of logs: CSV with a line of names."),
    **_OF_BOTH,
    "columns": {
        **_table(dict.fromkeys(COLUMNS, _text("The name of the column."))),
        "description": "What its columns are called, where not source, type, unit and date.",
    },
    "conditions": {
        "description": "Its columns with conditions: a list, or a table of columns by conditions.  "
        "[default: all other columns]",
        "oneOf": [_TEXTS, {"type": "object", "additionalProperties": {"type": "string", "minLength": 1}}],
    },
}
TOP: Final[dict[str, Schema]] = {
    "name": _name("What the fleet is called.  [default: its folder's name]"),
    "timezone": _text(f"{_ZONE}  [default: UTC]"),
    "types": {
        "description": "A table for each type of arms that are built alike.",
        "type": "object",
        "minProperties": 1,
        "propertyNames": {"maxLength": LONGEST_NAME},
        "additionalProperties": {**_table(OF_TYPE), "not": {"required": ["map", "columns"]}},
    },
    "logs": {
        "description": "Where the logs are: a table for each pattern of paths or manifest.",
        "type": "array",
        "minItems": 1,
        "items": {"oneOf": [_table(OF_FILES, "files"), _table(OF_MANIFEST, "manifest")]},
    },
}


def fleet_file_schema() -> Schema:
    """The schema of the file."""
    head = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "fleet.toml"}
    return {**head, **_table(TOP, "types", "logs")}
