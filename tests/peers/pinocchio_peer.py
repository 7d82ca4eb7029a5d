"""A robot's dynamics by Pinocchio (PyPI ``pin``), which takes any inertia, physical or not.

Q, Qd, Qdd and Tau are [N, n]; SI units. Friction is added here, Pinocchio's algorithms know none.
"""

from __future__ import annotations

from functools import cache

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


@cache
def armature_honoured() -> dict[str, bool]:
    """Whether this Pinocchio's ``rnea``, ``crba`` and ``aba`` count ``model.armature``; tried on one joint.

    Releases before 3 had it in ``aba`` only. All three do in 3 and 4.
    """
    model = pin.Model()
    model.addJoint(0, pin.JointModelRZ(), pin.SE3.Identity(), "joint")
    model.appendBodyToJoint(1, pin.Inertia(1.0, np.zeros(3), np.eye(3)), pin.SE3.Identity())
    model.armature = np.ones(1)
    zero, one, data = np.zeros(1), np.ones(1), model.createData()
    return {
        "rnea": bool(abs(pin.rnea(model, data, zero, zero, one)[0] - 2) < 1e-12),
        "crba": bool(abs(pin.crba(model, data, zero)[0, 0] - 2) < 1e-12),
        "aba": bool(abs(pin.aba(model, data, zero, zero, one)[0] - 0.5) < 1e-12),
    }


def torques(model: pin.Model, robot: Robot, Q: Array, Qd: Array, Qdd: Array) -> Array:
    """Inverse dynamics [N, n]: recursive Newton-Euler, and friction."""
    data = model.createData()
    tau = np.array([pin.rnea(model, data, *state) for state in zip(Q, Qd, Qdd, strict=True)])
    if not armature_honoured()["rnea"]:
        tau += armature(robot) * Qdd
    return tau + friction(robot, Qd)


def mass_matrix(model: pin.Model, robot: Robot, Q: Array) -> Array:
    """Mass matrix [N, n, n] by the composite rigid body algorithm, rotors on its diagonal."""
    data = model.createData()
    M = np.array([np.triu(pin.crba(model, data, q)) for q in Q])
    M += np.triu(M, 1).swapaxes(1, 2)  # older releases fill the upper triangle only
    return M if armature_honoured()["crba"] else M + np.diag(armature(robot))


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
    drive = Tau - friction(robot, Qd)
    if not armature_honoured()["aba"]:
        rest = Tau - bias(model, robot, Q, Qd)
        qdd = np.linalg.solve(mass_matrix(model, robot, Q), rest[..., None])[..., 0]
        return np.asarray(qdd, dtype=np.float64)
    data = model.createData()
    return np.array([pin.aba(model, data, *state) for state in zip(Q, Qd, drive, strict=True)])
