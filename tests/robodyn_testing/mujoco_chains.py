"""A chain that was read out of MJCF against MuJoCo, which reads the same file."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn.formats.serial import Serial
from robodyn_testing import require_module
from robodyn_testing.chains import WorldDynamics


def check_chain(mujoco: Any, model: Any, serial: Serial, tip: str, positions: Mapping[str, float]) -> None:
    """Torques, mass matrix and tip of a chain are those of the compiled ``model``, in which the body ``tip``
    is its tip; joints beside it are at ``positions``."""
    data = mujoco.MjData(model)
    own: Any = WorldDynamics(serial.chain)
    draw = np.random.default_rng(1)
    joints = [model.joint(joint.name) for joint in serial.chain.joints]
    columns = [int(joint.dofadr[0]) for joint in joints]
    for _ in range(3):
        q, qd, qdd = draw.uniform(-2, 2, (3, len(joints)))
        data.qpos[:] = model.qpos0
        data.qvel[:] = data.qacc[:] = 0
        for name, value in positions.items():
            data.qpos[model.joint(name).qposadr[0]] = value
        for joint, values in zip(joints, zip(q, qd, qdd, strict=True), strict=True):
            data.qpos[joint.qposadr[0]] = values[0]
            data.qvel[joint.dofadr[0]], data.qacc[joint.dofadr[0]] = values[1:]
        for step in (mujoco.mj_kinematics, mujoco.mj_comPos, mujoco.mj_makeM, mujoco.mj_comVel):
            step(model, data)  # and no more: a mass matrix near to singular is not to be factored
        torques = np.zeros(model.nv)
        mujoco.mj_rne(model, data, 1, torques)
        torques += model.dof_armature * data.qacc
        scale = abs(torques[columns]).max()
        assert own.torques(q, qd, qdd) == pytest.approx(torques[columns], rel=0, abs=1e-12 * scale)
        whole = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, whole)
        expected = whole[np.ix_(columns, columns)]
        assert own.mass_matrix(q) == pytest.approx(expected, rel=0, abs=1e-12 * abs(expected).max())
        body = data.body(tip)
        assert own.tip(q)[:3, 3] == pytest.approx(body.xpos, rel=0, abs=1e-13)
        assert np.ravel(own.tip(q)[:3, :3]) == pytest.approx(body.xmat, rel=0, abs=1e-13)


def torques_of_file(path: Path, states: Any) -> Any:
    """``M qacc + bias - passive + friction`` of the model that MuJoCo makes of the file, for each of the
    ``states`` ``q, qd, qdd``."""
    mujoco = require_module("mujoco")
    model = mujoco.MjModel.from_xml_path(str(path))
    data, torques = mujoco.MjData(model), []
    off = int(mujoco.mjtDisableBit.mjDSBL_FRICTIONLOSS) | int(mujoco.mjtDisableBit.mjDSBL_CONSTRAINT)
    friction = np.zeros(model.nv) if model.opt.disableflags & off else model.dof_frictionloss
    for q, qd, qdd in states:
        data.qpos[:], data.qvel[:] = q, qd
        mujoco.mj_forward(model, data)
        full = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, full)
        torques.append(full @ qdd + data.qfrc_bias - data.qfrc_passive + friction * np.sign(qd))
    return np.array(torques)
