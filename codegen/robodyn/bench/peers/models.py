"""The arm as a model of Pinocchio, of MuJoCo, and as a function of CasADi."""

from __future__ import annotations

from typing import Any

import numpy as np

from robodyn.bench.peers.numbers import LinkNumbers, Numbers
from robodyn.bench.peers.textbook import inverse_dynamics


def pinocchio_model(arm: Numbers) -> Any:
    """A model of ``pin``: one joint about or along z a link, rotors as ``armature``."""
    import pinocchio as pin

    model = pin.Model()
    model.name = arm.name
    model.gravity = pin.Motion(arm.gravity, np.zeros(3))
    parent = 0
    for i, link in enumerate(arm.links):
        kind = pin.JointModelRZ() if link.revolute else pin.JointModelPZ()
        parent = model.addJoint(parent, kind, pin.SE3(link.rotation, link.position), f"joint{i + 1}")
        body = pin.Inertia(link.mass, link.com, link.inertia)
        model.appendBodyToJoint(parent, body, pin.SE3.Identity())
    model.armature = np.array([link.rotor for link in arm.links])
    return model


_HEAD = """<mujoco model="{name}">
<compiler angle="radian" autolimits="false"/>
<option gravity="{gravity}">
<flag contact="disable" constraint="disable" equality="disable" limit="disable" frictionloss="disable"
 actuation="disable"/>
</option>
<worldbody>
"""


def mujoco_model(arm: Numbers) -> Any:
    """A model of ``mujoco`` with nothing but the arm in it, contacts and constraints switched off.

    Its compiler refuses links without mass or that break the triangle inequality, though its arithmetic
    handles them: every link passes the compiler with a stand-in, and the link's own numbers are written over
    it.
    """
    import mujoco

    parts = [_HEAD.format(name=arm.name, gravity=_spelled(arm.gravity))]
    for link in arm.links:
        axes = _spelled([*link.rotation[:, 0], *link.rotation[:, 1]])
        kind = "hinge" if link.revolute else "slide"
        parts.append(
            f'<body pos="{_spelled(link.position)}" xyaxes="{axes}">'
            f'<joint type="{kind}" axis="0 0 1" armature="{link.rotor!r}"/>'
            '<inertial pos="0.1 0.2 0.3" quat="0.5 0.1 0.2 0.3" mass="1" diaginertia="1 1.1 1.2"/>\n'
        )
    text = "".join(parts) + "</body>" * arm.n + "</worldbody></mujoco>"
    model = mujoco.MjModel.from_xml_string(text)
    for body, link in enumerate(arm.links, 1):
        model.body_mass[body], model.body_ipos[body] = link.mass, link.com
        model.body_inertia[body], model.body_iquat[body] = _principal(link)
    total = model.body_mass.copy()
    for body in range(arm.n, 0, -1):
        total[body - 1] += total[body]
    model.body_subtreemass[:] = total
    return model


def _principal(link: LinkNumbers) -> tuple[Any, Any]:
    """Principal moments [3] and their axes as a quaternion [4]."""
    import mujoco

    moments, axes = np.linalg.eigh(link.inertia)
    if np.linalg.det(axes) < 0:
        axes[:, 0] = -axes[:, 0]
    turn = np.zeros(4)
    mujoco.mju_mat2Quat(turn, axes.ravel())
    return moments, turn


def _spelled(numbers: Any) -> str:
    return " ".join(repr(float(x)) for x in numbers)


def casadi_function(arm: Numbers, name: str = "inverse_dynamics") -> Any:
    """The textbook's recursion as a function of ``casadi`` over SX, equal nodes merged (``casadi.cse``)."""
    import casadi

    q, qd, qdd = (casadi.SX.sym(array, arm.n) for array in ("q", "qd", "qdd"))
    split = casadi.vertsplit
    tau = inverse_dynamics(arm, split(q), split(qd), split(qdd), casadi.sin, casadi.cos)
    return casadi.Function(name, [q, qd, qdd], [casadi.cse(casadi.vertcat(*tau))])
