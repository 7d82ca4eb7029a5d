"""Robots: the description, its reader and writer, and the bundled arms.

All but the model itself (reader, writer, schema, starter, rotor folding) is imported when it is first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from robodyn.robot.model import Comparison, Gear, Inertia, Joint, Limits, Link, Robot

if TYPE_CHECKING:
    from robodyn.robot.bundled import bundled_names, bundled_text, load
    from robodyn.robot.masses import fold_rotor
    from robodyn.robot.reader import DoubtfulRobot, read_bytes, read_text
    from robodyn.robot.schema import json_schema
    from robodyn.robot.starter import starter
    from robodyn.robot.writer import to_yaml

_LATER = {
    "DoubtfulRobot": "reader",
    "bundled_names": "bundled",
    "bundled_text": "bundled",
    "fold_rotor": "masses",
    "json_schema": "schema",
    "load": "bundled",
    "read_bytes": "reader",
    "read_text": "reader",
    "starter": "starter",
    "to_yaml": "writer",
}

__all__ = [
    "Comparison",
    "DoubtfulRobot",
    "Gear",
    "Inertia",
    "Joint",
    "Limits",
    "Link",
    "Robot",
    "bundled_names",
    "bundled_text",
    "fold_rotor",
    "json_schema",
    "load",
    "read_bytes",
    "read_text",
    "starter",
    "to_yaml",
]


def __getattr__(name: str) -> Any:
    if name in _LATER:
        value = getattr(importlib.import_module(f"{__name__}.{_LATER[name]}"), name)
        globals()[name] = value  # the module starter must not stand in for the function of its name
        return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
