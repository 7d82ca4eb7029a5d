"""Robots: the description, its reader and writer, and the bundled arms.

All but the model itself (reader, writer, schema, starter, rotor folding) is imported when it is first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from robodyn.robot.model import Comparison, Gear, Inertia, Joint, Limits, Link, Robot

if TYPE_CHECKING:
    from robodyn.robot.bundled import bundled_names, bundled_text, load
    from robodyn.robot.folding import fold_rotor
    from robodyn.robot.reader import DoubtfulRobot, read_bytes, read_text
    from robodyn.robot.schema import json_schema, starter
    from robodyn.robot.writer import to_yaml

_LATER = {
    "bundled": ("bundled_names", "bundled_text", "load"),
    "folding": ("fold_rotor",),
    "reader": ("DoubtfulRobot", "read_bytes", "read_text"),
    "schema": ("json_schema", "starter"),
    "writer": ("to_yaml",),
}

__all__ = [
    "Comparison", "DoubtfulRobot", "Gear", "Inertia", "Joint", "Limits", "Link", "Robot", "bundled_names",
    "bundled_text", "fold_rotor", "json_schema", "load", "read_bytes", "read_text", "starter", "to_yaml",
]  # fmt: skip


def __getattr__(name: str) -> Any:
    for module, names in _LATER.items():
        if name in names:
            return getattr(importlib.import_module(f"{__name__}.{module}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
