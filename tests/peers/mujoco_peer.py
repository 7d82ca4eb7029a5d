"""A robot's dynamics by MuJoCo, from an MJCF text in which every number is a double to the last digit.

Q, Qd, Qdd and Tau are [N, n]; SI units. In the model of :func:`mujoco_model` contacts and constraints are
switched off and there are no springs or dampers, so that ``mj_inverse`` is rigid-body inverse dynamics and
nothing else; friction is added here. That of :func:`moving_model` is for ``mj_step``: it has the damping, dry
friction (a soft constraint) and springs of the joints, and the payload.

MuJoCo's compiler refuses links that its arithmetic could handle: without mass, without extent, or breaking
the triangle inequality. The refused links pass the compiler with a stand-in inertia, and their own numbers
are written into the compiled model.

Principal moments and axes are computed here: MuJoCo 3.2 diagonalises a ``fullinertia`` to six digits only.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import mujoco
import numpy as np

from peers.numbers import Array, armature, friction, inertia_tensor, number, placement
from robodyn.robot.model import EffectEntry, Inertia, Link, Robot
from robodyn.robot.values import Value

_HEAD = """\
<mujoco model="{name}">
  <compiler angle="radian" autolimits="false" inertiafromgeom="false" balanceinertia="false"
            boundmass="0" boundinertia="0"/>
  <option gravity="{gravity}" {option}>
    <flag contact="disable" constraint="{dry}" equality="disable" limit="disable" frictionloss="{dry}"
          actuation="disable" warmstart="disable"/>
  </option>
  <worldbody>
"""

_STAND_IN = (1.0, np.array([0.5, 0.1, 0.2, 0.3]), np.array([1.0, 1.1, 1.2]))
"""Mass, quaternion and principal moments, along no axis of the link: MuJoCo must not take a short cut that
the numbers written later do not allow."""


@dataclass(frozen=True, slots=True)
class Moving:
    """How a model moves: by Runge-Kutta's classic method with ``step`` [s].

    Dry friction is MuJoCo's soft constraint: what should stick loses its speed at the rate ``hardness`` [1/s]
    and creeps under load, the slower the larger that is. Above 2.8 / ``step`` it chatters.
    """

    step: float
    hardness: float = 1e6

    @property
    def option(self) -> str:
        """Attributes of MJCF's ``option``."""
        return (
            f'integrator="RK4" timestep="{self.step!r}" solver="Newton" iterations="200" tolerance="0"'
            ' jacobian="dense"'
        )


def moving_model(robot: Robot, moving: Moving) -> mujoco.MjModel:
    """The robot with its payload, and with damping, dry friction and springs of its joints, for ``mj_step``.

    Other effects it does not have.
    """
    for entry in robot.effects:
        assert entry.effect == "payload" or (entry.effect == "spring" and not entry.number("cubic"))
    model = mujoco_model(robot, moving)
    # Friction's regularisation goes by the inertia at the joint, of which the stand-ins know nothing.
    mujoco.mj_setConst(model, mujoco.MjData(model))
    return model


def motion(
    model: mujoco.MjModel,
    q: Array,
    qd: Array,
    torque: Callable[[float, Array, Array], Array],
    steps: int,
    every: int = 1,
) -> tuple[Array, Array]:
    """Positions and velocities [steps / every + 1, n]; a ``torque(t, q, qd)`` is held for ``every`` steps."""
    data = mujoco.MjData(model)
    data.qpos[:], data.qvel[:] = q, qd
    positions, velocities = [q], [qd]
    with _no_warnings():
        for k in range(0, steps, every):
            data.qfrc_applied[:] = torque(k * model.opt.timestep, data.qpos, data.qvel)
            mujoco.mj_step(model, data, every)
            positions.append(data.qpos.copy())
            velocities.append(data.qvel.copy())
    return np.array(positions), np.array(velocities)


def mujoco_model(robot: Robot, moving: Moving | None = None) -> mujoco.MjModel:
    """The robot as a compiled MuJoCo model; the inertia of links that its compiler refuses is put in."""
    try:
        return mujoco.MjModel.from_xml_string(_mjcf(robot, (), moving))
    except ValueError:
        refused = refusals(robot)
        if not refused:
            raise
    model = mujoco.MjModel.from_xml_string(_mjcf(robot, refused, moving))
    for i in refused:
        _write_inertia(model, i + 1, robot.links[i])
    mass = model.body_mass.copy()
    for body in range(model.nbody - 1, 0, -1):
        mass[body - 1] += mass[body]
    model.body_subtreemass[:] = mass
    return model


def refusals(robot: Robot) -> dict[int, str]:
    """Links (from 0) that MuJoCo's compiler refuses, each compiled by itself, with its words."""
    refused = {}
    for i, link in enumerate(robot.links):
        alone = Robot(name="alone", links=(link,))
        try:
            mujoco.MjModel.from_xml_string(_mjcf(alone, ()))
        except ValueError as error:
            refused[i] = str(error).splitlines()[0].removeprefix("Error: ")
    return refused


def torques(
    model: mujoco.MjModel, robot: Robot, Q: Array, Qd: Array, Qdd: Array, *, add_friction: bool = True
) -> Array:
    """Inverse dynamics [N, n]: ``mj_inverse``, and friction where the model has none of its own."""
    tau: list[Array] = []
    for data in _at(model, Q, Qd):
        data.qacc[:] = Qdd[len(tau)]
        mujoco.mj_inverse(model, data)
        tau.append(data.qfrc_inverse.copy())
    return np.array(tau) + friction(robot, Qd) if add_friction else np.array(tau)


def mass_matrix(model: mujoco.MjModel, robot: Robot, Q: Array) -> Array:
    """Mass matrix [N, n, n] by the composite rigid body algorithm, rotors on its diagonal."""
    matrices = []
    for data in _at(model, Q, np.zeros_like(Q)):
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        (getattr(mujoco, "mj_makeM", None) or mujoco.mj_crb)(model, data)
        M = np.zeros((robot.n, robot.n))
        try:
            mujoco.mj_fullM(model, data, M)
        except TypeError:  # before 4.0
            mujoco.mj_fullM(model, M, data.qM)
        matrices.append(M)
    return np.array(matrices)


def gravity(model: mujoco.MjModel, robot: Robot, Q: Array) -> Array:
    """Torque that holds the robot still [N, n]."""
    return bias(model, robot, Q, np.zeros_like(Q))


def bias(model: mujoco.MjModel, robot: Robot, Q: Array, Qd: Array) -> Array:
    """Torque at zero acceleration [N, n]: Coriolis, centrifugal, gravity and friction."""
    forces = []
    for data in _at(model, Q, Qd):
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_comVel(model, data)
        force = np.zeros(robot.n)
        mujoco.mj_rne(model, data, 0, force)
        forces.append(force)
    return np.array(forces) + friction(robot, Qd)


def forward_dynamics(model: mujoco.MjModel, robot: Robot, Q: Array, Qd: Array, Tau: Array) -> Array:
    """Accelerations [N, n] by ``mj_forward``; the mass matrix must not be singular."""
    drive = Tau - friction(robot, Qd)
    accelerations: list[Array] = []
    for data in _at(model, Q, Qd):
        data.qfrc_applied[:] = drive[len(accelerations)]
        mujoco.mj_forward(model, data)
        accelerations.append(data.qacc.copy())
    return np.array(accelerations)


@contextmanager
def _no_warnings() -> Iterator[None]:
    """Keep MuJoCo from writing MUJOCO_LOG.TXT where one runs: it warns of singular mass matrices.

    ``mj_inverse`` factors the mass matrix on its way, and does not use the factors.
    """
    handler = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(lambda _: None)
    try:
        yield
    finally:
        mujoco.set_mju_user_warning(handler)


def _at(model: mujoco.MjModel, Q: Array, Qd: Array) -> Iterator[mujoco.MjData]:
    """One MjData, in each state in turn."""
    data = mujoco.MjData(model)
    with _no_warnings():
        for q, qd in zip(Q, Qd, strict=True):
            data.qpos[:], data.qvel[:] = q, qd
            yield data


def _text(numbers: Iterable[float]) -> str:
    return " ".join(repr(float(x)) for x in numbers)


def _mjcf(robot: Robot, patched: Iterable[int], moving: Moving | None = None) -> str:
    """The MJCF text, with a stand-in inertia for the links ``patched`` (from 0)."""
    stand_ins = set(patched)
    option = 'integrator="Euler"' if moving is None else moving.option
    dry = "enable" if moving is not None and any(link.joint.coulomb for link in robot.links) else "disable"
    pull = _text(float(g) for g in robot.base_gravity)
    lines = [_HEAD.format(name=robot.name, gravity=pull, option=option, dry=dry)]
    rotors = armature(robot)
    for i, link in enumerate(robot.links):
        rotation, position = placement(link.joint)
        mass, turn, moments = _STAND_IN if i in stand_ins else _principal(link.mass, link.inertia)
        kind = "hinge" if link.joint.kind == "revolute" else "slide"
        held = "" if moving is None else _held(robot, i, moving)
        lines.append(
            f'<body pos="{_text(position)}" xyaxes="{_text([*rotation[:, 0], *rotation[:, 1]])}">\n'
            f'<joint type="{kind}" axis="0 0 1" armature="{float(rotors[i])!r}"{held}/>\n'
            f'<inertial pos="{_text(_com(link))}" quat="{_text(turn)}" mass="{mass!r}"'
            f' diaginertia="{_text(moments)}"/>\n'
        )
    if moving is not None:
        lines += [_payload(entry) for entry in robot.effects if entry.effect == "payload"]
    return "".join(lines) + "</body>\n" * robot.n + "</worldbody>\n</mujoco>\n"


def _held(robot: Robot, i: int, moving: Moving) -> str:
    """Attributes of joint ``i`` (from 0): what holds it back."""
    joint = robot.links[i].joint
    text = f' damping="{number(joint.viscous)!r}"'
    if joint.coulomb:
        text += (
            f' frictionloss="{number(joint.coulomb)!r}" solimpfriction="0.9999 0.9999 1 0.5 1"'
            f' solreffriction="-1 {-moving.hardness!r}"'
        )
    for entry in robot.effects_at(i + 1):
        if entry.effect == "spring":
            text += f' stiffness="{entry.number("stiffness")!r}" springref="{entry.number("rest")!r}"'
    return text


def _payload(entry: EffectEntry) -> str:
    inertia = entry["inertia"] if "inertia" in entry else Inertia()
    mass, turn, moments = _principal(entry["mass"], inertia)
    com = _text(number(c) for c in entry["com"])
    numbers = f'pos="{com}" quat="{_text(turn)}" mass="{mass!r}" diaginertia="{_text(moments)}"'
    return f"<body><inertial {numbers}/></body>\n"


def _com(link: Link) -> list[float]:
    return [number(c) for c in link.com]


def _principal(of: Value, inertia: Inertia) -> tuple[float, Array, Array]:
    """Mass, axes of inertia as a quaternion [4], and moments about them [3]."""
    moments, axes = np.linalg.eigh(inertia_tensor(inertia))
    if np.linalg.det(axes) < 0:
        axes[:, 0] = -axes[:, 0]
    turn = np.zeros(4)
    mujoco.mju_mat2Quat(turn, axes.ravel())
    return number(of), turn, moments


def _write_inertia(model: mujoco.MjModel, body: int, link: Link) -> None:
    """Write mass, centre and inertia of ``link`` over the stand-in's in the compiled model."""
    if model.body_simple[body] or model.body_sameframe[body]:
        raise AssertionError(f"body {body}: MuJoCo would take a short cut past the inertia written here")
    model.body_mass[body], model.body_iquat[body], model.body_inertia[body] = _principal(
        link.mass, link.inertia
    )
    model.body_ipos[body] = _com(link)
