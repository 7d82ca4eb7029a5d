"""A description in numbers for peers that have no friction: torques, mass matrix, pose of the tool."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from robodyn.robot.model import Robot
from robodyn.robot.numbers import shortest
from robodyn.robot.parts import Placement
from robodyn.robot.values import ZERO, Value
from robodyn.verify.reference import Reference

Array = NDArray[np.float64]


class RigidArm:
    """``robot`` with its rotors (or without: ``rotors``), and without friction and other effects but loads.

    ``gravity`` [m/s^2] in the world takes the place of the description's.
    """

    def __init__(self, robot: Robot, rotors: bool = True, gravity: Sequence[float] | None = None) -> None:
        links = []
        for link in robot.links:
            joint = replace(link.joint, viscous=ZERO, coulomb=ZERO)
            links.append(replace(link, joint=joint if rotors else replace(joint, motor_inertia=ZERO)))
        loads = tuple(entry for entry in robot.effects if entry.definition.traits.body)
        self.robot = replace(robot, links=tuple(links), effects=loads, torque_side="motor")
        if gravity is not None:
            x, y, z = map(shortest, gravity)
            self.robot = replace(self.robot, gravity=(x, y, z))
        self._reference = Reference(self.robot)

    def torques(self, q: Array, qd: Array, qdd: Array) -> Array:
        return np.array(self._reference.inverse_dynamics(q, qd, qdd))

    def mass_matrix(self, q: Array) -> Array:
        return np.array(self._reference.mass_matrix(q))

    def tip(self, q: Array) -> Array:
        """Pose [4, 4] of the tool in the world: rows of modified DH multiplied up."""
        pose = _placed(self.robot.base)
        for link, position in zip(self.robot.links, q, strict=True):
            joint = link.joint
            turns = joint.kind == "revolute"
            x, z = np.eye(4), np.eye(4)
            c, s = float(joint.alpha.cos), float(joint.alpha.sin)
            x[1:3, 1:3] = [[c, -s], [s, c]]
            x[:3, 3] = x[:3, :3] @ [real(joint.a), real(joint.b), 0.0]
            angle = joint.theta.radians + (position if turns else 0.0)
            z[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
            z[2, 3] = real(joint.d) + (0.0 if turns else position)
            pose = pose @ x @ z
        matrix: Array = pose @ _placed(self.robot.tool)
        return matrix


def real(value: Value) -> float:
    """A number of a description without run-time parameters."""
    return float(value)  # type: ignore[arg-type]


def _placed(frame: Placement | None) -> Array:
    matrix = np.eye(4)
    if frame is not None:
        matrix[:3, :3] = np.array(frame.rotation, dtype=float)
        matrix[:3, 3] = np.array(frame.xyz, dtype=float)
    return matrix
