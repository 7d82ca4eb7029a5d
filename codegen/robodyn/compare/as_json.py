"""A comparison of two robots as JSON has it."""

from __future__ import annotations

from typing import Any

from robodyn.compare.robots import Comparison


def to_dict(comparison: Comparison) -> dict[str, Any]:
    """``comparison`` as ``robodyn diff --json`` prints it."""
    tool = None
    if comparison.tool is not None:
        tool = {"distance": comparison.tool[0], "angle": comparison.tool[1]}
    torques = None
    if comparison.torques is not None:
        torques = {
            "share": comparison.share,
            "largest": comparison.largest,
            "joints": list(comparison.torques),
        }
    return {
        "robots": list(comparison.names),
        "same": comparison.same,
        "differences": [
            {
                "group": each.group,
                "where": each.where or None,
                "what": each.what,
                "left": each.left,
                "right": each.right,
                "by": each.by,
                "unit": each.unit,
            }
            for each in comparison.differences
        ],
        "torques": torques,
        "tool": tool,
        "operations": None if comparison.operations is None else list(comparison.operations),
        "not_compared": list(comparison.not_compared),
    }
