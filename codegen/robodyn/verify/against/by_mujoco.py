"""An MJCF file as MuJoCo reads it: torques, mass matrix and frames by its engine's steps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.robot.model import Robot
from robodyn.tools.libraries import MUJOCO, quiet_mujoco
from robodyn.verify.against.arm import (
    NAMELESS,
    Follower,
    Frames,
    PeerArm,
    Resting,
    joints_in_file,
    title_of,
)


@dataclass(frozen=True, slots=True)
class MujocoFile:
    """A compiled model of the file at ``path``; ``bare``: without its meshes."""

    path: Path
    mujoco: Any
    model: Any
    bare: bool = False

    @classmethod
    def read(cls, path: Path) -> MujocoFile:
        """The model in the file; meshes, and all that it includes, read by MuJoCo itself. Where a mesh is not
        there, MuJoCo reads the file without shapes that are meshes.

        Raises
        ------
        InputError: MuJoCo refuses it, or needs a mesh that is not there.
        ToolError: MuJoCo is not installed.
        """
        mujoco = MUJOCO.load(where=Place(label(path)))
        with quiet_mujoco(mujoco):
            return cls._read(path, mujoco)

    @classmethod
    def _read(cls, path: Path, mujoco: Any) -> MujocoFile:
        try:
            return cls(path, mujoco, mujoco.MjModel.from_xml_path(str(path)))
        except (ValueError, mujoco.FatalError) as error:
            refused = InputError(
                "MuJoCo refuses the file", where=Place(label(path)), found=" ".join(str(error).split())[:300]
            )
            if "opening file" not in str(error):
                raise refused from None
        try:
            spec = mujoco.MjSpec.from_file(str(path))
            for body in spec.bodies[1:]:
                of_meshes = any(geom.meshname for geom in body.geoms)
                if of_meshes and (spec.compiler.inertiafromgeom == 1 or not body.explicitinertial):
                    raise refused
            for part in (*(geom for geom in spec.geoms if geom.meshname), *spec.meshes):
                spec.delete(part)
            return cls(path, mujoco, spec.compile(), bare=True)
        except (ValueError, mujoco.FatalError):
            raise refused from None

    def arm(self, robot: Robot, locks: Mapping[str, float]) -> MujocoArm:
        """The joints of ``robot``; others are at ``locks`` [rad or m], or where :class:`Resting` says."""
        return MujocoArm(self, robot, locks)

    def joints(self) -> dict[str, int]:
        """Names and indices of the joints that turn or slide."""
        kinds = (int(self.mujoco.mjtJoint.mjJNT_HINGE), int(self.mujoco.mjtJoint.mjJNT_SLIDE))
        return {
            self.model.joint(i).name or f"{NAMELESS}{i}": i
            for i in range(self.model.njnt)
            if int(self.model.jnt_type[i]) in kinds
        }

    def equations(self) -> list[int]:
        """The indices of those that are active."""
        bits = self.mujoco.mjtDisableBit
        if self.model.opt.disableflags & (bits.mjDSBL_EQUALITY | bits.mjDSBL_CONSTRAINT):
            return []
        return [i for i in range(self.model.neq) if self.model.eq_active0[i]]

    def followers(self) -> dict[str, Follower]:
        """Joints that equations hold: at one position, or where others put them."""
        model, names = self.model, {i: name for name, i in self.joints().items()}
        followers = {}
        for i in self.equations():
            joint, leader = int(model.eq_obj1id[i]), int(model.eq_obj2id[i])
            if int(model.eq_type[i]) != int(self.mujoco.mjtEq.mjEQ_JOINT):
                continue
            start = float(model.qpos0[model.jnt_qposadr[joint]])
            shift = float(model.qpos0[model.jnt_qposadr[leader]]) if leader >= 0 else 0.0
            powers = np.polynomial.Polynomial(model.eq_data[i][: 5 if leader >= 0 else 1])
            moved = start + powers(np.polynomial.Polynomial([-shift, 1.0]))
            followers[names[joint]] = Follower(names.get(leader, ""), tuple(np.atleast_1d(moved.coef)))
        return followers


class MujocoArm(PeerArm):
    """See :class:`PeerArm`. Torques are ``M qacc + qfrc_bias - qfrc_passive``, and ``frictionloss`` against
    the motion: what MuJoCo's forward dynamics is of without contacts, limits and other constraints."""

    springs, rotors = True, True

    def __init__(self, file: MujocoFile, robot: Robot, locks: Mapping[str, float]) -> None:
        self._mujoco, self._model = file.mujoco, file.model
        self._data = self._mujoco.MjData(self._model)
        all_joints = file.joints()
        self.joints = joints_in_file(robot, all_joints, locks, label(file.path))
        self.title = title_of("MuJoCo", self._mujoco.__version__, label(file.path))
        model = self._model
        ranges = {
            name: tuple(map(float, model.jnt_range[i])) if model.jnt_limited[i] else (-np.inf, np.inf)
            for name, i in all_joints.items()
        }
        resting = Resting(ranges, file.followers(), locks)  # type: ignore[arg-type]
        self._rest = np.array(model.qpos0)
        for name, i in all_joints.items():
            self._rest[model.jnt_qposadr[i]] = resting.position(name)
        self._indices = [all_joints[name] for name in self.joints]
        self._positions = [int(model.jnt_qposadr[i]) for i in self._indices]
        self._dofs = [int(model.jnt_dofadr[i]) for i in self._indices]
        self._friction = np.array(model.dof_frictionloss[self._dofs])
        bits = self._mujoco.mjtDisableBit
        if model.opt.disableflags & (bits.mjDSBL_FRICTIONLOSS | bits.mjDSBL_CONSTRAINT):
            self._friction[:] = 0
        self.gears = self._gears()
        joint = int(self._mujoco.mjtEq.mjEQ_JOINT)
        others = sum(int(model.eq_type[i]) != joint for i in file.equations())
        reason = {f"constraints of the file ({others})": "they have no part in inverse dynamics"}
        self.not_compared = reason if others else {}
        if file.bare:
            self.not_compared["meshes"] = "some are not there; no inertia is theirs"

    def _gears(self) -> dict[int, float]:
        model, driven = self._model, self._mujoco.mjtTrn.mjTRN_JOINT
        gears: dict[int, list[float]] = {}
        for i in range(model.nu):
            joint = int(model.actuator_trnid[i][0])
            if int(model.actuator_trntype[i]) == int(driven) and joint in self._indices:
                gears.setdefault(self._indices.index(joint), []).append(float(model.actuator_gear[i][0]))
        return {joint: ratios[0] for joint, ratios in gears.items() if len(ratios) == 1}

    def _states(self, q: Floats, qd: Floats) -> Iterator[int]:
        """Every state in turn, everything that depends on positions and velocities computed. No step factors
        the mass matrix, which may be near to singular."""
        mujoco, model, data = self._mujoco, self._model, self._data
        for k in range(len(q)):
            data.qpos[:], data.qvel[:] = self._rest, 0
            data.qpos[self._positions], data.qvel[self._dofs] = q[k], qd[k]
            for step in (mujoco.mj_kinematics, mujoco.mj_comPos, mujoco.mj_tendon, mujoco.mj_makeM):
                step(model, data)
            mujoco.mj_transmission(model, data)
            mujoco.mj_fwdVelocity(model, data)
            yield k

    def _times_mass_matrix(self, qdd: Floats) -> Floats:
        whole, product = np.zeros((2, self._model.nv))
        whole[self._dofs] = qdd
        self._mujoco.mj_mulM(self._model, self._data, product, whole)
        return np.asarray(product[self._dofs])

    def torques(self, q: Floats, qd: Floats, qdd: Floats) -> Floats:
        tau = np.empty(q.shape)
        for k in self._states(q, qd):
            forces = (self._data.qfrc_bias - self._data.qfrc_passive)[self._dofs]
            tau[k] = self._times_mass_matrix(qdd[k]) + forces + self._friction * np.sign(qd[k])
        return tau

    def mass_matrix(self, q: Floats) -> Floats:
        n = q.shape[1]
        matrix = np.empty((len(q), n, n))
        for k in self._states(q, np.zeros_like(q)):
            matrix[k] = [self._times_mass_matrix(unit) for unit in np.eye(n)]
        return matrix

    def frames(self, q: Floats) -> Frames:
        model, data = self._model, self._data
        bodies = [int(model.jnt_bodyid[i]) for i in self._indices]
        ends = [int(model.body_jntadr[b] + model.body_jntnum[b]) - 1 for b in bodies]
        below = [b for b in range(model.nbody) if self._hangs_on(b, bodies[-1])]
        sites = [s for s in range(model.nsite) if int(model.site_bodyid[s]) in below]
        links = np.empty((len(bodies), len(q), 3, 4))
        tips = {model.body(b).name or f"body {b}": np.empty((len(q), 3, 4)) for b in below}
        tips |= {f"site {model.site(s).name or s}": np.empty((len(q), 3, 4)) for s in sites}
        for k in self._states(q, np.zeros_like(q)):
            placed = [(data.xpos[b], data.xmat[b]) for b in (*bodies, *below)]
            placed += [(data.site_xpos[s], data.site_xmat[s]) for s in sites]
            for frame, (place, turn) in zip((*links, *tips.values()), placed, strict=True):
                frame[k, :, :3], frame[k, :, 3] = turn.reshape(3, 3), place
        whole = [
            links[i] if end == joint else None
            for i, (end, joint) in enumerate(zip(ends, self._indices, strict=True))
        ]
        return Frames(whole, tips)

    def _hangs_on(self, body: int, other: int) -> bool:
        while body > other:
            body = int(self._model.body_parentid[body])
        return body == other
