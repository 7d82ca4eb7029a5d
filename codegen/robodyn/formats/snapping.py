"""Right angles that a file writes with few digits: which they are, for a report before they are snapped."""

from __future__ import annotations

import math
from dataclasses import dataclass

from robodyn.formats.limits import NEAR_RIGHT_ANGLE
from robodyn.robot.model import Robot
from robodyn.robot.values import Angle


@dataclass(frozen=True, slots=True)
class NearRightAngle:
    """An angle of a description that is nearly a multiple of pi/2: whose it is, what it is [rad], and the
    multiple."""

    where: str
    radians: float
    quarter: int

    @property
    def error(self) -> float:
        """By how much the multiple is missed [rad]."""
        return self.radians - self.quarter * math.pi / 2


def near_right_angles(robot: Robot, within: float = NEAR_RIGHT_ANGLE) -> tuple[NearRightAngle, ...]:
    """The angles of ``robot``, base to tip, that are ``within`` [rad] of a multiple of pi/2 and not it."""
    angles: list[tuple[str, Angle]] = []
    if robot.base is not None:
        angles += [(f"base: {word}", turn) for word, turn in _named(robot.base.rpy)]
    for link in robot.links:
        angles += [(f"{link.name}: alpha", link.joint.alpha), (f"{link.name}: theta", link.joint.theta)]
    if robot.tool is not None:
        angles += [(f"tool: {word}", turn) for word, turn in _named(robot.tool.rpy)]
    near = []
    for where, turn in angles:
        quarter = round(turn.radians / (math.pi / 2))
        if turn.quarter is None and abs(turn.radians - quarter * (math.pi / 2)) <= within:
            near.append(NearRightAngle(where, turn.radians, quarter))
    return tuple(near)


def _named(rpy: tuple[Angle, Angle, Angle]) -> list[tuple[str, Angle]]:
    return list(zip(("roll", "pitch", "yaw"), rpy, strict=True))
