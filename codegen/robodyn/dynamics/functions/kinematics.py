"""Kinematics: where the tool is, and how it moves."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.functions.record import Array, Dynamics, Function, Q
from robodyn.dynamics.poses import flat, placed, rows_of, tool_axes, tool_place
from robodyn.dynamics.transforms import IDENTITY_4, product, transform

POSITION = Array("position", "origin of the tool in the world", "m", shape=(3,))
ROTATION = Array("rotation", "turns vectors of the tool's frame into the world's", "", shape=(3, 3))


def _forward_kinematics(at: Dynamics) -> Sequence[Any]:
    arm = placed(at)
    axes = tool_axes(at, arm)
    at.cheapest([flat(axes)])
    return [*tool_place(at, arm), *flat(rows_of(axes))]


def _by_transforms(at: Dynamics) -> Sequence[Any]:
    """The product of all transforms, entry by entry."""
    T = _poses(at)[-1]
    return [*(row[3] for row in T[:3]), *(x for row in T[:3] for x in row[:3])]


def _poses(at: Dynamics) -> list[Any]:
    """Transforms [4, 4] of the links, and of the tool."""
    arm, motion = at.arm, at.motion(at.rest, at.rest)
    ends = [
        tuple((*row, p) for row, p in zip(f.rotation(), f.origin, strict=True)) for f in (arm.base, arm.tool)
    ]
    base, tool = (product(IDENTITY_4, (*rows, (0, 0, 0, 1))) for rows in ends)
    poses, last = [], base
    for body, c, s, d in zip(arm.bodies, motion.c, motion.s, motion.d, strict=True):
        last = product(last, transform(body, c, s, d))
        poses.append(last)
    return [*poses, product(last, tool)]


FUNCTIONS = (
    Function(
        "forward_kinematics",
        "position and rotation of the tool",
        (Q,),
        (POSITION, ROTATION),
        _forward_kinematics,
        expected=_by_transforms,
        geometric=True,
    ),
)
