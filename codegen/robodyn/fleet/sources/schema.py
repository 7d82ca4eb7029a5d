"""The JSON Schema of ``fleet.toml``, for editors that complete keys and mark mistakes in TOML files."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from robodyn.fleet.limits import LONGEST_FORMAT, LONGEST_NAME
from robodyn.fleet.sources.manifest import COLUMNS

Schema = dict[str, Any]

_TEXT: Final[Schema] = {"type": "string", "minLength": 1}
_NAME: Final[Schema] = {**_TEXT, "maxLength": LONGEST_NAME}
_NUMBERS: Final[Schema] = {"type": "object", "additionalProperties": {"type": "number"}}
_ZONE: Final = "Of dates that state none: UTC, an offset such as +02:00, or a name such as Europe/Berlin."


def fleet_file_schema() -> Schema:
    """The schema of the file."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "fleet.toml",
        **_table(
            {
                "name": {**_NAME, "description": "What the fleet is called.  [default: its folder's name]"},
                "timezone": {**_TEXT, "description": f"{_ZONE}  [default: UTC]"},
                "types": {
                    "description": "A table for each type of arms that are built alike.",
                    "type": "object",
                    "minProperties": 1,
                    "propertyNames": {"maxLength": LONGEST_NAME},
                    "additionalProperties": {**_table(_OF_TYPE), "not": {"required": ["map", "columns"]}},
                },
                "logs": {
                    "description": "Where the logs are: a table for each pattern of paths or manifest.",
                    "type": "array",
                    "minItems": 1,
                    "items": {"oneOf": [_table(_OF_FILES, "files"), _table(_OF_MANIFEST, "manifest")]},
                },
            },
            "types",
            "logs",
        ),
    }


def _table(keys: Mapping[str, Schema], *required: str) -> Schema:
    table: Schema = {"type": "object", "properties": dict(keys), "additionalProperties": False}
    return {**table, "required": list(required)} if required else table


_OF_TYPE: Final[dict[str, Schema]] = {
    "robot": {
        **_TEXT,
        "description": "The description: a path as seen from this file's folder, or a bundled robot.  "
        "[default: the name of this table]",
    },
    "map": {**_TEXT, "description": "The map of the logs (docs/logs.md), as seen from this file's folder."},
    "columns": {**_TEXT, "description": "The same in one line: t=time[ms],q=joint_%d_pos[deg],tau=i_%d[A]."},
    "parameters": {**_NUMBERS, "description": "Values of the description's run-time parameters, SI units."},
}
_OF_BOTH: Final[dict[str, Schema]] = {
    "exclude": {
        "description": "Patterns of paths that are left out, with all that is in them.",
        "oneOf": [_TEXT, {"type": "array", "items": _TEXT}],
    },
    "type": {**_NAME, "description": "The type of logs for which nothing else says it."},
    "unit": {**_NAME, "description": "The unit of logs for which nothing else says it."},
    "date": {
        "description": "How dates are written: as Python's strptime, unix, or unix_ms; log: the times in the "
        "log are dates; or a date that holds for all of them.  [default: ISO 8601]",
        "type": "string",
        "maxLength": LONGEST_FORMAT,
    },
    "timezone": {**_TEXT, "description": f"{_ZONE}  [default: that of the file]"},
}
_OF_FILES: Final[dict[str, Schema]] = {
    "files": {
        **_TEXT,
        "description": "A pattern of paths: logs/{type}/{unit}/{date}.csv; any other field is a condition, "
        "* any text, ** any folders.",
    },
    **_OF_BOTH,
    "conditions": {**_NUMBERS, "description": "Conditions that hold for all of these logs."},
}
_OF_MANIFEST: Final[dict[str, Schema]] = {
    "manifest": {
        **_TEXT,
        "description": "A list of logs: CSV with a line of names, or lines of JSON (.jsonl, .ndjson).",
    },
    **_OF_BOTH,
    "columns": {
        "description": "What its columns are called, where not source, type, unit and date.",
        **_table(dict.fromkeys(COLUMNS, _TEXT)),
    },
    "conditions": {
        "description": "Its columns with conditions: a list, or a table of columns by conditions.  "
        "[default: all other columns]",
        "oneOf": [
            {"type": "array", "items": {"type": "string"}},
            {"type": "object", "additionalProperties": {"type": "string"}},
        ],
    },
}
