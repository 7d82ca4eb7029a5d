"""Dynamics of a chain of axes by plain Newton-Euler in numpy, and of the same file as Pinocchio reads it."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.formats.chain import Body, Chain, Pose, about_axis

Array = NDArray[np.float64]
_PREFIX = "joint "


def homogeneous(pose: Pose) -> Array:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = pose.rotation, pose.xyz
    return matrix


def tensor(body: Body) -> Array:
    xx, yy, zz, xy, xz, yz = body.inertia
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


class WorldDynamics:
    """The chain in the world's frame: every vector along the world's axes, moments about joints' origins."""

    def __init__(self, chain: Chain) -> None:
        self.chain = chain

    def frames(self, q: Array) -> list[Array]:
        frame, frames = homogeneous(self.chain.base), []
        for joint, position in zip(self.chain.joints, q, strict=True):
            frame = frame @ homogeneous(joint.pose)
            step = np.eye(4)
            if joint.kind == "revolute":
                step[:3, :3] = about_axis(joint.axis, float(position))
            else:
                step[:3, 3] = position * np.array(joint.axis)
            frame = frame @ step
            frames.append(frame)
        return frames

    def tip(self, q: Array) -> Array:
        matrix: Array = self.frames(q)[-1] @ homogeneous(self.chain.tool)
        return matrix

    def torques(self, q: Array, qd: Array, qdd: Array) -> Array:
        frames = self.frames(q)
        w, wd, v = np.zeros(3), np.zeros(3), -np.array(self.chain.gravity)
        before = homogeneous(self.chain.base)[:3, 3]
        forces, moments, axes, origins = [], [], [], []
        for joint, frame, rate, acceleration in zip(self.chain.joints, frames, qd, qdd, strict=True):
            axis, origin = frame[:3, :3] @ joint.axis, frame[:3, 3]
            arm = origin - before
            v = v + np.cross(wd, arm) + np.cross(w, np.cross(w, arm))
            if joint.kind == "revolute":
                wd = wd + acceleration * axis + np.cross(w, rate * axis)
                w = w + rate * axis
            else:
                v = v + acceleration * axis + 2 * np.cross(w, rate * axis)
            c = frame[:3, :3] @ joint.body.com
            inertia = frame[:3, :3] @ tensor(joint.body) @ frame[:3, :3].T
            forces.append(joint.body.mass * (v + np.cross(wd, c) + np.cross(w, np.cross(w, c))))
            moments.append(inertia @ wd + np.cross(w, inertia @ w) + np.cross(origin + c, forces[-1]))
            axes.append(axis)
            origins.append(origin)
            before = origin
        tau = np.zeros(len(q))
        force, moment = np.zeros(3), np.zeros(3)
        for i in reversed(range(len(q))):
            force, moment = force + forces[i], moment + moments[i]
            joint = self.chain.joints[i]
            about = moment - np.cross(origins[i], force)
            tau[i] = axes[i] @ (about if joint.kind == "revolute" else force)
            tau[i] += joint.motor_inertia * qdd[i]
        return tau

    def mass_matrix(self, q: Array) -> Array:
        n, rest = len(q), np.zeros(len(q))
        gravity = self.torques(q, rest, rest)
        return np.array([self.torques(q, rest, unit) - gravity for unit in np.eye(n)]).T


class PinocchioArm:
    """The chain of the joints ``names`` of a URDF text as Pinocchio reads it; others locked at ``positions``.

    Pinocchio does not take joints that are called as links are: here they have a name of their own.
    """

    def __init__(
        self, pinocchio: Any, text: str, names: list[str], positions: Mapping[str, float], gravity: Any
    ) -> None:
        self.pin, self.names = pinocchio, names
        root = ElementTree.fromstring(text)
        for element in root.iter():
            for key in {"joint": ("name",), "mimic": ("joint",)}.get(element.tag, ()):
                element.set(key, _PREFIX + element.get(key, ""))
        whole = pinocchio.buildModelFromXML(ElementTree.tostring(root, encoding="unicode"))
        configuration = pinocchio.neutral(whole)
        for name, value in positions.items():
            if whole.existJointName(_PREFIX + name) and name not in names:
                self._place(whole, configuration, _PREFIX + name, value)
        kept = [_PREFIX + name for name in names]
        others = [i for i in range(1, whole.njoints) if whole.names[i] not in kept]
        self.model = pinocchio.buildReducedModel(whole, others, configuration)
        assert [self.model.names[i] for i in range(1, self.model.njoints)] == kept
        self.model.gravity.linear = np.array(gravity)
        self.data = self.model.createData()

    @staticmethod
    def _place(model: Any, configuration: Array, name: str, value: float) -> None:
        joint = model.joints[model.getJointId(name)]
        if joint.nq == 2:
            configuration[joint.idx_q : joint.idx_q + 2] = np.cos(value), np.sin(value)
        else:
            configuration[joint.idx_q] = value

    def configuration(self, q: Array) -> Array:
        whole: Array = self.pin.neutral(self.model)
        for i, value in enumerate(q, 1):
            self._place(self.model, whole, self.model.names[i], float(value))
        return whole

    def torques(self, q: Array, qd: Array, qdd: Array) -> Array:
        return np.array(self.pin.rnea(self.model, self.data, self.configuration(q), qd, qdd))

    def mass_matrix(self, q: Array) -> Array:
        upper = np.triu(self.pin.crba(self.model, self.data, self.configuration(q)))
        return np.array(upper + np.triu(upper, 1).T)

    def tip(self, q: Array, link: str) -> Array:
        self.pin.framesForwardKinematics(self.model, self.data, self.configuration(q))
        return np.array(self.data.oMf[self.model.getFrameId(link)].homogeneous)
