"""A robot's dynamics by Pinocchio (PyPI ``pin``), which takes any inertia, physical or not.

Q, Qd, Qdd and Tau are [N, n]; SI units. Friction is added here, Pinocchio's algorithms know none.
"""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from peers.numbers import Array, armature, friction, inertia_tensor, number, placement
from robodyn.robot.model import Robot

__all__ = ["bias", "forward_dynamics", "gravity", "mass_matrix", "pinocchio_model", "torques"]


def pinocchio_model(robot: Robot) -> pin.Model:
    """The robot as a Pinocchio model: one joint about or along z a link, rotors as ``armature``."""
    model = pin.Model()
    model.name = robot.name
    model.gravity = pin.Motion(np.array([float(g) for g in robot.base_gravity]), np.zeros(3))
    parent = 0
    for link in robot.links:
        kind = pin.JointModelRZ() if link.joint.kind == "revolute" else pin.JointModelPZ()
        parent = model.addJoint(parent, kind, pin.SE3(*placement(link.joint)), link.name)
        com = np.array([number(c) for c in link.com])
        body = pin.Inertia(number(link.mass), com, inertia_tensor(link.inertia))
        model.appendBodyToJoint(parent, body, pin.SE3.Identity())
    model.armature = armature(robot)
    return model


def torques(model: pin.Model, robot: Robot, Q: Array, Qd: Array, Qdd: Array) -> Array:
    """Inverse dynamics [N, n]: recursive Newton-Euler, and friction."""
    data = model.createData()
    tau = [pin.rnea(model, data, *state) for state in zip(Q, Qd, Qdd, strict=True)]
    return np.array(tau) + friction(robot, Qd)


def mass_matrix(model: pin.Model, robot: Robot, Q: Array) -> Array:
    """Mass matrix [N, n, n] by the composite rigid body algorithm, rotors on its diagonal."""
    data = model.createData()
    M: Array = np.array([np.triu(pin.crba(model, data, q)) for q in Q])
    return M + np.triu(M, 1).swapaxes(1, 2)  # older releases fill the upper triangle only


def gravity(model: pin.Model, robot: Robot, Q: Array) -> Array:
    """Torque that holds the robot still [N, n]."""
    data = model.createData()
    return np.array([pin.computeGeneralizedGravity(model, data, q) for q in Q])


def bias(model: pin.Model, robot: Robot, Q: Array, Qd: Array) -> Array:
    """Torque at zero acceleration [N, n]: Coriolis, centrifugal, gravity and friction."""
    data = model.createData()
    nle = np.array([pin.nonLinearEffects(model, data, *state) for state in zip(Q, Qd, strict=True)])
    return nle + friction(robot, Qd)


def forward_dynamics(model: pin.Model, robot: Robot, Q: Array, Qd: Array, Tau: Array) -> Array:
    """Accelerations [N, n] by the articulated body algorithm; the mass matrix must not be singular."""
    drive, data = Tau - friction(robot, Qd), model.createData()
    return np.array([pin.aba(model, data, *state) for state in zip(Q, Qd, drive, strict=True)])
