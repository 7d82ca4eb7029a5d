"""Arms of a simulated fleet moved by MuJoCo: bodies, friction and play are its own.

Friction is MuJoCo's ``damping`` and ``frictionloss``; play is a joint of its own between the motor and the
link, whose range is the gap. Torques of the motors come from the controller of
:class:`benchmarks.fleet.arm.Arm`, as actuators with a position and a velocity gain.
"""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from benchmarks.fleet.arm import Day, Numbers
from benchmarks.fleet.limits import CONTROL_PERIOD
from benchmarks.fleet.types import TrueType
from mujoco import rollout
from numpy.typing import NDArray

from robodyn.errors import InputError
from robodyn.logs.log import Log
from robodyn.robot.model import Joint, Robot
from robodyn.simulate.trajectories.trajectory import Trajectory

Floats = NDArray[np.float64]

_HEAD = """\
<mujoco>
<compiler angle="radian" inertiafromgeom="false" boundmass="0" boundinertia="0" balanceinertia="false"/>
<option gravity="{gravity}" timestep="{step!r}" integrator="Euler" iterations="30" tolerance="1e-12">
<flag contact="disable" eulerdamp="disable"/></option>
<worldbody>
"""
#: Along no axis of its body, so that MuJoCo takes no short cut past the numbers that are written over it.
_STAND_IN = '<inertial pos="0.1 0.2 0.3" quat="0.5 0.1 0.2 0.3" mass="1" diaginertia="1 1.1 1.2"/>'
#: Constraints as stiff as the step allows: times [s] and damping ratios, and how nearly rigid.
_STIFF = 'solref{0}="{1!r} 1" solimp{0}="0.99 0.999 1e-4"'


def moved(true: TrueType, day: Day, motion: Trajectory, cache: Path | None = None) -> Log:
    """What perfect sensors show of an arm of the type ``true`` on a ``day``; encoders are at the motors.

    Raises
    ------
    InputError: the day has an effect that is not written for MuJoCo; the arm runs away.
    """
    loose = None
    if day.coupler is not None:
        if "gap" not in day.coupler:
            raise InputError(f"{day.coupler.effect} is not written for MuJoCo")
        loose = day.coupler.joint
    arm = true.arm(Day(true.numbers), cache)
    follow, ahead = arm.reference(motion)
    model, data = _model(true.robot, loose)
    gap = day.coupler.number("gap", day.values) if day.coupler is not None else 0.0
    _write(model, data, day.numbers, loose, gap)
    model.actuator_biasprm[:, 1], model.actuator_biasprm[:, 2] = -arm.kp, -arm.kd
    control = ahead + arm.kp * follow.q + arm.kd * follow.qd
    motors = model.actuator_trnid[:, 0]
    data.qpos[:], data.qvel[:] = 0.0, 0.0
    data.qpos[motors], data.qvel[motors] = follow.q[0], follow.qd[0]
    state = np.empty(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
    mujoco.mj_getState(model, data, state, mujoco.mjtState.mjSTATE_FULLPHYSICS)
    _, sensors = rollout.rollout(model, data, state[None], control[None])
    every = round(1 / (CONTROL_PERIOD * true.rate))
    rows = sensors[0, ::every]
    if not np.isfinite(rows).all():
        raise InputError(f"{true.robot.name}: the simulation by MuJoCo runs away")
    q, qd, tau = np.split(rows, 3, axis=1)
    return Log(np.arange(len(rows)) / true.rate, q, qd, None, tau)


@lru_cache(maxsize=32)
def _model(robot: Robot, loose: int | None) -> tuple[mujoco.MjModel, mujoco.MjData]:
    """The arm, its joint ``loose`` (from 1) with play; what a unit has is written into it later."""
    step = CONTROL_PERIOD
    dry = _STIFF.format("friction", 2 * step)
    lines = [_HEAD.format(gravity=_text(float(g) for g in robot.base_gravity), step=step)]
    for i, link in enumerate(robot.links, 1):
        kind = "hinge" if link.joint.kind == "revolute" else "slide"
        rotation, position = _mounted(link.joint)
        place = f'pos="{_text(position)}" xyaxes="{_text([*rotation[:, 0], *rotation[:, 1]])}"'
        motor = f'<joint name="motor{i}" type="{kind}" axis="0 0 1" damping="1" frictionloss="1" {dry}/>'
        if i == loose:
            limit = _STIFF.format("limit", 2 * step)
            play = f'<joint name="play" type="{kind}" axis="0 0 1" range="-1 1" limited="true" {limit}/>'
            lines.append(
                f'<body {place}>{motor}<inertial pos="0 0 0" mass="1e-9" diaginertia="1e-12 1e-12 1e-12"/>'
            )
            lines.append(f'<body name="link{i}">{play}{_STAND_IN}')
        else:
            lines.append(f'<body name="link{i}" {place}>{motor}{_STAND_IN}')
    lines.append("</body>" * (robot.n + (loose is not None)) + "</worldbody><actuator>")
    joints = range(1, robot.n + 1)
    lines += [f'<general name="a{i}" joint="motor{i}" gainprm="1" biastype="affine"/>' for i in joints]
    lines.append("</actuator><sensor>")
    lines += [f'<jointpos joint="motor{i}"/>' for i in joints]
    lines += [f'<jointvel joint="motor{i}"/>' for i in joints]
    lines += [f'<actuatorfrc actuator="a{i}"/>' for i in joints]
    model = mujoco.MjModel.from_xml_string("\n".join([*lines, "</sensor></mujoco>"]))
    return model, mujoco.MjData(model)


def _mounted(joint: Joint) -> tuple[Floats, Floats]:
    """Rotation [3, 3] and position [3] of the joint's frame at 0 in the link before: Craig's rows."""
    ca, sa, ct, st = (float(x) for x in (joint.alpha.cos, joint.alpha.sin, joint.theta.cos, joint.theta.sin))
    turn = np.array([[1, 0, 0], [0, ca, -sa], [0, sa, ca]])
    numbers: list[Any] = [joint.a, joint.b, joint.d]
    return turn @ np.array([[ct, -st, 0], [st, ct, 0], [0, 0, 1]]), turn @ np.array(
        [float(x) for x in numbers]
    )


def _write(
    model: mujoco.MjModel, data: mujoco.MjData, numbers: Numbers, loose: int | None, gap: float
) -> None:
    """The ``numbers`` of a unit over the stand-ins."""
    for i in range(1, len(numbers.mass) + 1):
        xx, yy, zz, xy, xz, yz = numbers.inertia[i - 1]
        moments, axes = np.linalg.eigh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        axes[:, 0] *= np.linalg.det(axes)
        body, joint = model.body(f"link{i}").id, model.joint(f"motor{i}")
        mujoco.mju_mat2Quat(model.body_iquat[body], axes.ravel())
        model.body_mass[body], model.body_inertia[body] = numbers.mass[i - 1], moments
        model.body_ipos[body] = numbers.com[i - 1]
        (degree,) = joint.dofadr
        model.dof_armature[degree] = numbers.motor_inertia[i - 1]
        model.dof_damping[degree] = numbers.viscous[i - 1]
        model.dof_frictionloss[degree] = numbers.coulomb[i - 1]
    if loose is not None:
        model.jnt_range[model.joint("play").id] = [-gap / 2, gap / 2]
    mujoco.mj_resetData(model, data)
    mujoco.mj_setConst(model, data)


def _text(numbers: Any) -> str:
    return " ".join(repr(float(x)) for x in numbers)
