"""What both peers need of a robot: its numbers as floats, and what sits in its joints."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from robodyn.robot.model import AXES, Inertia, Joint, Robot
from robodyn.robot.values import Affine, Value

Array = NDArray[np.float64]


def number(value: Value) -> float:
    """The value as the nearest double; a run-time parameter has none and raises ValueError."""
    if isinstance(value, Affine):
        raise ValueError(f"a peer needs numbers: found the run-time parameters {value.terms}")
    return float(value)


def placement(joint: Joint) -> tuple[Array, Array]:
    """Rotation [3, 3] and position [3] of the joint's frame at q = 0 in the frame of the link before it.

    Rot(x, alpha) Trans(x, a) Rot(z, theta) Trans(z, d): what turns or slides with q comes after all four,
    about or along the same z, so for either kind of joint this is where it is mounted.
    """
    ca, sa = float(joint.alpha.cos), float(joint.alpha.sin)
    ct, st = float(joint.theta.cos), float(joint.theta.sin)
    rot_x = np.array([[1, 0, 0], [0, ca, -sa], [0, sa, ca]], dtype=np.float64)
    rot_z = np.array([[ct, -st, 0], [st, ct, 0], [0, 0, 1]], dtype=np.float64)
    position = rot_x @ [number(joint.a), number(joint.b), number(joint.d)]
    return rot_x @ rot_z, position


def inertia_tensor(inertia: Inertia) -> Array:
    """The tensor about the centre of mass [3, 3], kg m^2."""
    xx, yy, zz, xy, xz, yz = (number(getattr(inertia, axes)) for axes in AXES)
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def armature(robot: Robot) -> Array:
    """Rotor inertia that the joint torque has to move [n]: none where torque is the link's."""
    if robot.torque_side == "link":
        return np.zeros(robot.n)
    return np.array([number(link.joint.motor_inertia) for link in robot.links])


def friction(robot: Robot, Qd: Array) -> Array:
    """Friction [N, n] at joint velocities ``Qd`` [N, n]; none where torque is the link's."""
    if robot.torque_side == "link":
        return np.zeros_like(Qd)
    viscous = np.array([number(link.joint.viscous) for link in robot.links])
    coulomb = np.array([number(link.joint.coulomb) for link in robot.links])
    rest = robot.rest_velocity
    direction: Array = np.sign(Qd) if rest is None else np.tanh(Qd / float(rest))
    total: Array = viscous * Qd + coulomb * direction
    return total
