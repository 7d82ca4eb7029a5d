"""Where the axes of an arm's joints lie, for formats that hold it against another description of it."""

from __future__ import annotations

from dataclasses import dataclass

from robodyn.packages.limits import REFERENCE_POSITIONS
from robodyn.robot.model import Robot
from robodyn.robot.values import Affine


@dataclass(frozen=True, slots=True)
class Axis:
    """Of a joint at ``position`` [rad or m]: ``origin`` [m], a point of it, and its ``direction``, a unit
    vector, along the axes of the world."""

    position: float
    origin: tuple[float, ...]
    direction: tuple[float, ...]


def axes_of(robot: Robot) -> tuple[Axis, ...]:
    """The axes of ``robot`` base to tip, at positions of no symmetry; none where run-time parameters decide
    where they lie."""
    from robodyn.simulate.kinematics import Kinematics

    if any(isinstance(x, Affine) for link in robot.links for x in (link.joint.a, link.joint.b, link.joint.d)):
        return ()
    q = [REFERENCE_POSITIONS[i % len(REFERENCE_POSITIONS)] for i in range(robot.n)]
    origins, rotations = Kinematics(robot, dict.fromkeys(robot.parameters, 1.0)).frames(q)
    return tuple(
        Axis(position, tuple(map(float, origin)), tuple(map(float, rotation[:, 2])))
        for position, origin, rotation in zip(q, origins, rotations, strict=True)
    )
