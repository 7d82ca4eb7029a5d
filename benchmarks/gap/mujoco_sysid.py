"""MuJoCo's own identification (``mujoco.sysid``) on the fitted samples of real logs.

Its parameters are taken (pseudo-inertias of the bodies, which stay physical; armature, damping and friction
loss of the joints) and its optimiser. By default its residual compares simulated positions with measured
ones, from which an arm driven by logged torques runs away within a second; here it compares torques of
``mj_inverse`` along the same filtered motion as everybody's.
"""

from __future__ import annotations

import contextlib
import importlib
import io
from collections.abc import Sequence
from typing import Any

import mujoco
import numpy as np
from benchmarks.gap.arm import mount, plain, tensor
from benchmarks.gap.recordings import Floats, Motion

from robodyn.robot.model import Robot

#: So many of the fitted samples are used, evenly.
SAMPLES = 1000
#: Iterations at most, in each of the rounds; after the first, weights are those of the residuals.
ITERATIONS = 30
ROUNDS = 2
#: A point mass becomes a ball of this radius [m]: logarithms of its inertia are wanted.
_BALL = 0.05


def fit(robot: Robot, motions: Sequence[Motion]) -> tuple[Floats, ...]:
    """Residuals [K, n] of each of ``motions``, by the model that was fitted to their fitted samples."""
    sysid: Any = importlib.import_module("mujoco.sysid")
    q, qd, qdd, tau = (
        np.concatenate([getattr(m, name)[m.fitted] for m in motions]) for name in ("q", "qd", "qdd", "tau")
    )
    every = max(1, len(q) // SAMPLES)
    q, qd, qdd, tau = q[::every], qd[::every], qdd[::every], tau[::every]
    spec = mujoco.MjSpec.from_string(_xml(robot))
    parameters = _parameters(robot, spec, qd, tau)
    weights = 1 / np.sqrt((tau**2).mean(axis=0))
    model = sysid.apply_param_modifiers(parameters, spec)
    for _ in range(ROUNDS):
        scale = weights.copy()

        def residual(x: Floats, current: Any, scale: Floats = scale) -> tuple[list[Floats], None, None]:
            columns = x.reshape(len(x), -1)
            rows = []
            for column in columns.T:
                current.update_from_vector(column)
                left = torque(sysid.apply_param_modifiers(current, spec), q, qd, qdd) - tau
                rows.append((left * scale).ravel())
            return [np.array(rows).T if x.ndim > 1 else rows[0]], None, None

        with contextlib.redirect_stdout(io.StringIO()):  # its optimiser prints every iteration
            parameters, _ = sysid.optimize(
                parameters, residual, verbose=False, max_iters=ITERATIONS, x_scale="jac"
            )
        model = sysid.apply_param_modifiers(parameters, spec)
        weights = 1 / np.sqrt(((torque(model, q, qd, qdd) - tau) ** 2).mean(axis=0))
    return tuple(m.tau - torque(model, m.q, m.qd, m.qdd) for m in motions)


def torque(model: Any, q: Floats, qd: Floats, qdd: Floats) -> Floats:
    """Torques [K, n] of the compiled ``model``, friction and rotors included."""
    data = mujoco.MjData(model)
    result = np.empty_like(q)
    for k in range(len(q)):
        data.qpos[:], data.qvel[:], data.qacc[:] = q[k], qd[k], qdd[k]
        mujoco.mj_inverse(model, data)
        result[k] = data.qfrc_inverse
    return result


def _xml(robot: Robot) -> str:
    gravity = " ".join(repr(float(g)) for g in robot.base_gravity)
    lines = [
        '<mujoco><compiler angle="radian" autolimits="false" balanceinertia="true"/>',
        f'<option gravity="{gravity}"><flag contact="disable" limit="disable"/></option><worldbody>',
    ]
    for k, link in enumerate(robot.links):
        rotation, place = mount(link.joint)
        axes = " ".join(map(repr, map(float, [*rotation[:, 0], *rotation[:, 1]])))
        mass = max(plain(link.mass), 0.1)
        i = tensor(link.inertia) + 0.4 * mass * _BALL**2 * np.eye(3)
        full = " ".join(repr(float(i[a])) for a in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))
        com = " ".join(repr(plain(c)) for c in link.com)
        kind = "hinge" if link.joint.kind == "revolute" else "slide"
        lines.append(
            f'<body name="b{k}" pos="{" ".join(map(repr, map(float, place)))}" xyaxes="{axes}">'
            f'<joint name="j{k}" type="{kind}" axis="0 0 1"/>'
            f'<inertial pos="{com}" mass="{mass!r}" fullinertia="{full}"/>'
        )
    return "".join([*lines, "</body>" * robot.n, "</worldbody></mujoco>"])


def _parameters(robot: Robot, spec: Any, qd: Floats, tau: Floats) -> Any:
    sysid: Any = importlib.import_module("mujoco.sysid")
    parameters = sysid.ParameterDict()
    model = spec.compile()
    size, speed = np.sqrt((tau**2).mean(axis=0)), np.sqrt((qd**2).mean(axis=0))
    for k, link in enumerate(robot.links):
        parameters.add(
            sysid.body_inertia_param(
                spec, model, f"b{k}", sysid.InertiaType.Pseudo, stretch_bound_mult=np.array([0.02, 50.0]),
                mass_bound_mult=np.array([0.02, 50.0]), shear_bound_off=np.array([-2.0, 2.0]),
                modifier=_body_setter(f"b{k}"),
            )
        )  # fmt: skip
        rotor = max(plain(link.joint.motor_inertia), 1e-3 * size[k])
        starts = {"damping": 0.05 * size[k] / speed[k], "frictionloss": 0.05 * size[k]}
        if robot.torque_side != "link":
            starts["armature"] = rotor
        for name, start in starts.items():
            parameters.add(
                sysid.Parameter(f"{name}{k}", start, 0.0, 100 * start, modifier=_setter(f"j{k}", name))
            )
    return parameters


def _body_setter(body: str) -> Any:
    """As ``mujoco.sysid`` writes a pseudo-inertia, but by principal axes: MuJoCo 4.0 does not compile what
    its own function leaves of a body without geometry."""
    pi_from_theta = importlib.import_module("mujoco.sysid._src.model_modifier").pi_from_theta

    def modify(spec: Any, parameter: Any) -> None:
        part, pi = spec.body(body), pi_from_theta(parameter.value)
        com = pi[1:4] / pi[0]
        about_com = pi[4:].reshape(3, 3) - pi[0] * (com @ com * np.eye(3) - np.outer(com, com))
        moments, axes = np.linalg.eigh(about_com)
        if np.linalg.det(axes) < 0:
            axes[:, 0] = -axes[:, 0]
        turn = np.zeros(4)
        mujoco.mju_mat2Quat(turn, axes.ravel())
        part.mass, part.ipos, part.iquat, part.inertia = pi[0], com, turn, moments
        part.fullinertia = np.full(6, np.nan)

    return modify


def _setter(joint: str, name: str) -> Any:
    def modify(spec: Any, parameter: Any) -> None:
        part = spec.joint(joint)
        value = float(parameter.value[0])
        setattr(part, name, np.full((3, 1), value) if name == "damping" else value)

    return modify
