"""An arm as a MuJoCo model that ``mj_step`` moves: links, payload, rotors, dry friction; no contacts.

Every body is compiled with a stand-in inertia, and its own numbers are written into the compiled model: the
compiler refuses massless links and such that break the triangle inequality.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from peers.numbers import Array, inertia_tensor, number, placement
from robodyn.robot.model import Inertia, Robot
from robodyn.robot.values import Value

_HEAD = """\
<mujoco>
  <compiler angle="radian" autolimits="false" inertiafromgeom="false" balanceinertia="false"
            boundmass="0" boundinertia="0"/>
  <option gravity="{gravity}" timestep="{step!r}" integrator="Euler">
    <flag contact="disable" equality="disable" limit="disable" actuation="disable" warmstart="disable"
          eulerdamp="disable" sensor="disable"/>
  </option>
  <worldbody>
"""

# Along no axis of the body: MuJoCo must not take a short cut that the numbers written later do not allow.
_STAND_IN = '<inertial pos="0.1 0.2 0.3" quat="0.5 0.1 0.2 0.3" mass="1" diaginertia="1 1.1 1.2"/>'

#: Dry friction stops a joint by half its speed a step, short of what would chatter; the largest share of a
#: constraint's force that MuJoCo knows (at 10 rad/s^2, a joint that is held creeps by 5e-7 rad/s).
_STOP, _HARD = 0.5, 0.9999


@dataclass(frozen=True, slots=True)
class Solid:
    """A rigid body: ``inertia`` [3, 3] (kg m^2) about its centre ``com`` [3] (m), and its mass [kg]."""

    mass: float
    com: Array
    inertia: Array


@dataclass(frozen=True, slots=True)
class Tool:
    """What swings from the last link: a body that turns freely about ``axis``, with ``damping`` [N m s]."""

    solid: Solid
    axis: tuple[float, float, float]
    damping: float


def build_model(
    robot: Robot, step: float, motors: Sequence[int] = (), tool: Tool | None = None
) -> mujoco.MjModel:
    """The arm with its payload. Degrees of freedom: the joints; a rotor of its own for each joint of
    ``motors`` (from 0), whose joint then has none; the ``tool``."""
    lines = [_HEAD.format(gravity=_text(float(g) for g in robot.base_gravity), step=step)]
    solids = []
    rotors = [number(link.joint.motor_inertia) for link in robot.links]
    for i, link in enumerate(robot.links):
        rotation, position = placement(link.joint)
        kind = "hinge" if link.joint.kind == "revolute" else "slide"
        rotor = 0.0 if i in motors else rotors[i]
        lines.append(
            f'<body pos="{_text(position)}" xyaxes="{_text([*rotation[:, 0], *rotation[:, 1]])}">\n'
            f'<joint type="{kind}" axis="0 0 1" armature="{rotor!r}"/>\n{_STAND_IN}\n'
        )
        solids.append(_solid(link.mass, link.com, link.inertia))
    loads = [entry for entry in robot.effects if entry.effect == "payload"]
    for load in loads:
        inertia = load["inertia"] if "inertia" in load else Inertia()
        lines.append(f"<body>{_STAND_IN}</body>\n")
        solids.append(_solid(load["mass"], load["com"], inertia))
    swinging = ""
    if tool:
        axis = f'axis="{_text(tool.axis)}" damping="{tool.damping!r}"'
        swinging = f'<body><joint type="hinge" {axis}/>{_STAND_IN}</body>\n'
        solids.append(tool.solid)
    # Degrees of freedom number with the bodies; the rotors come before the tool's only if the tool is last.
    motor_text = "".join(
        f'<body pos="0 0 {10 + i}"><joint type="hinge" axis="0 0 1" armature="{rotors[i]!r}"/>'
        '<inertial pos="0 0 0" mass="1e-9" diaginertia="1e-12 1e-12 1e-12"/></body>\n'
        for i in motors
    )
    text = "".join([*lines, swinging, "</body>\n" * robot.n, motor_text, "</worldbody>\n</mujoco>\n"])
    model = mujoco.MjModel.from_xml_string(text)
    for body, solid in enumerate(solids, 1):
        _write(model, body, solid)
    mass = model.body_mass.copy()
    for body in range(model.nbody - 1, 0, -1):
        parent = model.body_parentid[body]
        mass[parent] += mass[body]
    model.body_subtreemass[:] = mass
    model.dof_solref[:] = 0.0, -_STOP / step
    model.dof_solimp[:, :2] = _HARD
    return model


def _solid(mass: Value, com: Iterable[Value], inertia: Inertia) -> Solid:
    return Solid(number(mass), np.array([number(c) for c in com]), inertia_tensor(inertia))


def _write(model: mujoco.MjModel, body: int, solid: Solid) -> None:
    """The numbers of ``solid`` over the stand-in's in the compiled model."""
    if model.body_simple[body] or model.body_sameframe[body]:
        raise AssertionError(f"body {body}: MuJoCo would take a short cut past the inertia written here")
    moments, axes = np.linalg.eigh(solid.inertia)
    if np.linalg.det(axes) < 0:
        axes[:, 0] = -axes[:, 0]
    turn = np.zeros(4)
    mujoco.mju_mat2Quat(turn, axes.ravel())
    model.body_mass[body], model.body_ipos[body] = solid.mass, solid.com
    model.body_iquat[body], model.body_inertia[body] = turn, moments


def _text(numbers: Iterable[float]) -> str:
    return " ".join(repr(float(x)) for x in numbers)
