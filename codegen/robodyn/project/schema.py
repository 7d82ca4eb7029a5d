"""The JSON Schema of ``robodyn.toml``, for editors that complete keys and mark mistakes in TOML files."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from robodyn.counts.count import KINDS
from robodyn.project.keys import LARGEST_BUDGET, Key, Keys

Schema = dict[str, Any]


def project_schema(keys: Keys, formats: Iterable[str]) -> Schema:
    """The schema of a project whose options are ``keys``, and whose packages may be of ``formats``."""
    options = {name: _of_key(key) for name, key in keys.kernels.items()}
    own: dict[str, Schema] = {
        "robot": {
            "type": "string",
            "minLength": 1,
            "description": "The description: a path as seen from this file's folder, or a bundled robot. "
            "Without it: the name of this table.",
        },
        "output": {
            "type": "string",
            "minLength": 1,
            "description": "The folder of the kernels.  [default: generated/ and the name of this table]",
        },
        "budgets": {
            "type": "object",
            "description": "By function the most operations, by kind.",
            "additionalProperties": _table(dict.fromkeys(KINDS, _COUNT)),
        },
        "packages": _packages(keys, tuple(formats)),
    }
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "robodyn.toml",
        **_table(
            {
                "options": {"description": "Options of all robots.", **_table(options)},
                "robots": {
                    "description": "A table for each robot.",
                    "type": "object",
                    "minProperties": 1,
                    "additionalProperties": _table(own | options),
                },
            }
        ),
        "required": ["robots"],
    }


_COUNT = {"type": "integer", "minimum": 0, "exclusiveMaximum": LARGEST_BUDGET}


def _packages(keys: Keys, formats: tuple[str, ...]) -> Schema:
    own = {name: _of_key(key) for name, key in keys.packages.items()}
    own["output"] = {
        "type": "string",
        "minLength": 1,
        "description": "The folder of the package.  [default: packages/, the name of the robot's table, "
        "/ and the format]",
    }
    return {
        "description": "Packages of the robot (robodyn package): formats, or a table with options for each.",
        "oneOf": [
            {"type": "array", "uniqueItems": True, "items": {"enum": list(formats)}},
            _table(dict.fromkeys(formats, _table(own))),
        ],
    }


def _table(keys: Mapping[str, Schema]) -> Schema:
    return {"type": "object", "properties": dict(keys), "additionalProperties": False}


def _of_key(key: Key) -> Schema:
    if key.flag:
        return {"type": "boolean", "description": key.help()}
    if key.words is not None:
        return {"enum": list(key.words()), "description": key.help()}
    if key.several or key.listed:
        several = {"type": "array", "minItems": 1, "items": {"type": "string", "minLength": 1}}
        return {"oneOf": [{"type": "string"}, several], "description": key.help()}
    return {"type": ["string", "number"], "description": key.help()}
