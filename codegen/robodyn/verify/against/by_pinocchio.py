"""A URDF as Pinocchio reads it: torques, mass matrix and frames by its algorithms."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.dom.minidom import Element

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.robot.model import Robot
from robodyn.tools.libraries import PINOCCHIO
from robodyn.verify.against.arm import Follower, Frames, PeerArm, Resting, joints_in_file, title_of

#: What joints are called here: Pinocchio refuses one that is called as a link is.
_PREFIX = "joint "


@dataclass(frozen=True, slots=True)
class PinocchioFile:
    """The model of the URDF at ``path``; ``expanded``: of what its macros expand to."""

    path: Path
    pinocchio: Any
    model: Any
    followers: Mapping[str, Follower]
    expanded: bool

    @classmethod
    def read(cls, path: Path, robot: Element, expanded: bool = False) -> PinocchioFile:
        """The model of the element ``robot``.

        Raises
        ------
        InputError: Pinocchio refuses it.
        ToolError: Pinocchio is not installed.
        """
        pinocchio = PINOCCHIO.load(where=Place(label(path)))
        followers = {}
        try:
            for joint in robot.getElementsByTagName("joint"):
                name = joint.getAttribute("name")
                for mimic in joint.getElementsByTagName("mimic"):
                    leader = mimic.getAttribute("joint")
                    offset, factor = (mimic.getAttribute(key) for key in ("offset", "multiplier"))
                    followers[name] = Follower(leader, (float(offset or 0), float(factor or 1)))
                    mimic.setAttribute("joint", _PREFIX + leader)
                joint.setAttribute("name", _PREFIX + name)
            model = pinocchio.buildModelFromXML(robot.toxml())
        except (ValueError, RuntimeError) as error:
            raise InputError(
                "Pinocchio refuses the file",
                where=Place(label(path)),
                found=" ".join(str(error).split())[:300],
            ) from None
        return cls(path, pinocchio, model, followers, expanded)

    def arm(self, robot: Robot, locks: Mapping[str, float]) -> PinocchioArm:
        """The joints of ``robot``; others are at ``locks`` [rad or m], or where :class:`Resting` says."""
        return PinocchioArm(self, robot, locks)

    def joints(self) -> dict[str, int]:
        """Names and indices of the joints that turn or slide."""
        model = self.model
        return {
            model.names[i].removeprefix(_PREFIX): i
            for i in range(1, model.njoints)
            if model.joints[i].nv == 1
        }


class PinocchioArm(PeerArm):
    """See :class:`PeerArm`. A URDF has no gravity: Pinocchio takes the robot's."""

    springs, rotors = False, False
    gears: Mapping[int, float] = {}

    def __init__(self, file: PinocchioFile, robot: Robot, locks: Mapping[str, float]) -> None:
        self._pin, self._model = file.pinocchio, file.model.copy()
        all_joints = file.joints()
        self.joints = joints_in_file(robot, all_joints, locks, label(file.path))
        title = title_of("Pinocchio", self._pin.__version__, label(file.path))
        self.title = f"{title}, expanded by xacro" if file.expanded else title
        gravity = [float(g) for g in robot.gravity]
        self._model.gravity.linear = np.array(gravity)
        self.not_compared = {
            "gravity": f"a URDF states none; both have that of {robot.name}, {gravity} m/s^2",
            "gears and rotors": "Pinocchio reads no transmissions of a URDF",
        }
        self._data = self._model.createData()
        model = self._model
        ranges = {}
        for name, i in all_joints.items():
            q = model.joints[i].idx_q
            bounded = model.joints[i].nq == 1
            lower, upper = model.lowerPositionLimit[q], model.upperPositionLimit[q]
            ranges[name] = (float(lower), float(upper)) if bounded and lower <= upper else (-np.inf, np.inf)
        resting = Resting(ranges, file.followers, locks)
        self._rest = self._pin.neutral(model)
        for name, i in all_joints.items():
            self._place(self._rest, i, resting.position(name))
        self._indices = [all_joints[name] for name in self.joints]
        self._dofs = [int(model.joints[i].idx_v) for i in self._indices]

    def _place(self, configuration: Floats, joint: int, position: float) -> None:
        there = self._model.joints[joint]
        if there.nq == 2:  # a joint without limits, on the circle
            configuration[there.idx_q : there.idx_q + 2] = np.cos(position), np.sin(position)
        else:
            configuration[there.idx_q] = position

    def _configuration(self, q: Floats) -> Floats:
        whole = self._rest.copy()
        for joint, position in zip(self._indices, q, strict=True):
            self._place(whole, joint, float(position))
        return np.asarray(whole)

    def torques(self, q: Floats, qd: Floats, qdd: Floats) -> Floats:
        model, tau = self._model, np.empty(q.shape)
        damping, dry = model.damping[self._dofs], model.upperDryFrictionLimit[self._dofs]
        for k in range(len(q)):
            speeds, rates = np.zeros((2, model.nv))
            speeds[self._dofs], rates[self._dofs] = qd[k], qdd[k]
            rigid = self._pin.rnea(model, self._data, self._configuration(q[k]), speeds, rates)
            tau[k] = rigid[self._dofs] + damping * qd[k] + dry * np.sign(qd[k])
        return tau

    def mass_matrix(self, q: Floats) -> Floats:
        matrices = []
        for positions in q:
            upper = np.triu(self._pin.crba(self._model, self._data, self._configuration(positions)))
            matrices.append((upper + np.triu(upper, 1).T)[np.ix_(self._dofs, self._dofs)])
        return np.array(matrices)

    def frames(self, q: Floats) -> Frames:
        model, data = self._model, self._data
        below = set(model.subtrees[self._indices[-1]])
        body = self._pin.FrameType.BODY
        ends = {i: f.name for i, f in enumerate(model.frames) if f.type == body and f.parentJoint in below}
        links, tips = [], []
        for positions in q:
            self._pin.framesForwardKinematics(model, data, self._configuration(positions))
            links.append([data.oMi[i].homogeneous[:3] for i in self._indices])
            tips.append([data.oMf[i].homogeneous[:3] for i in ends])
        by_link, by_tip = np.array(links), np.array(tips)
        tips_by_name = {name: by_tip[:, i] for i, name in enumerate(ends.values())}
        return Frames([by_link[:, i] for i in range(len(self._indices))], tips_by_name)
