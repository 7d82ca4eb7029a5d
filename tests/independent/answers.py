"""What each function of the registry should give at a state, by the formulas of docs/functions.md."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

import casadi as ca
import numpy as np

from independent.reference import Array, Reference

State = Mapping[str, Array]
Answer = Callable[[Reference, State], tuple[Array, ...]]


def _state(at: State, *names: str) -> dict[str, Array]:
    return {name: at[name] for name in names}


def _value(name: str, expression: Callable[[Reference], ca.SX], *inputs: str) -> Answer:
    """An expression of the reference at some of the inputs."""
    return lambda arm, at: (arm.value(name, lambda: expression(arm), **_state(at, *inputs)),)


def _torques(*inputs: str) -> Answer:
    return lambda arm, at: (arm.inverse_dynamics(**_state(at, *inputs)),)


def _forward(*inputs: str) -> Answer:
    return lambda arm, at: (arm.accelerations(at["tau"], **_state(at, *inputs)),)


def _reactions(*inputs: str) -> Answer:
    def rows(arm: Reference) -> ca.SX:
        return ca.vertcat(*[ca.horzcat(force.T, moment.T) for force, moment in arm.reactions])

    return _value("reactions", rows, *inputs)


_pose = _value("tool", lambda arm: arm.tool[:3, :], "q")
_jacobian = _value("jacobian", lambda arm: arm.jacobian, "q")
_mass_matrix = _value("mass_matrix", lambda arm: arm.mass_matrix, "q")
_coriolis_matrix = _value("coriolis_matrix", lambda arm: arm.coriolis_matrix, "q", "qd")
_frames = _value("frames", lambda arm: ca.vertcat(*arm.frames), "q")
_symbols = _value("christoffel", lambda arm: ca.vertcat(*[ca.vertcat(*x) for x in arm.christoffel]), "q")


def _inverse(matrix: Array) -> Array:
    return np.asarray(np.linalg.inv(matrix), np.float64)


def _links(arm: Reference, at: State) -> tuple[Array, ...]:
    frames = _frames(arm, at)[0].reshape(arm.n, 4, 4)
    return frames[:, :3, 3], frames[:, :3, :3]


def _tool_jacobian(arm: Reference, at: State) -> tuple[Array, ...]:
    (jacobian,), (pose,) = _jacobian(arm, at), _pose(arm, at)
    return (np.vstack([pose[:, :3].T @ jacobian[:3], pose[:, :3].T @ jacobian[3:]]),)


def _lambda(arm: Reference, at: State) -> tuple[Array, ...]:
    (jacobian,), (matrix,) = _jacobian(arm, at), _mass_matrix(arm, at)
    return (jacobian @ np.linalg.solve(matrix, jacobian.T),)


def _motors(arm: Reference, at: State) -> Array:
    ratios = np.array([link["gear"]["ratio"] for link in arm.links])
    return np.asarray(arm.inverse_dynamics(**_state(at, "q", "qd", "qdd")) / ratios, np.float64)


def _currents(arm: Reference, at: State) -> tuple[Array, ...]:
    return (_motors(arm, at) / np.array([link["gear"]["torque_constant"] for link in arm.links]),)


def _inverse_slopes(arm: Reference, at: State) -> tuple[Array, ...]:
    moving = _state(at, "q", "qd", "qdd")
    return arm.slopes("q", **moving), arm.slopes("qd", **moving)


def _forward_slopes(arm: Reference, at: State) -> tuple[Array, ...]:
    """The derivative of what solves ``inverse dynamics (q, qd, qdd) = tau``."""
    moving = _state(at, "q", "qd")
    moving["qdd"] = arm.accelerations(at["tau"], **moving)
    inverse = _inverse(arm.slopes("qdd", **moving))
    return -inverse @ arm.slopes("q", **moving), -inverse @ arm.slopes("qd", **moving), inverse


ANSWERS: Final[dict[str, Answer]] = {
    "inverse_dynamics": _torques("q", "qd", "qdd"),
    "gravity": _torques("q"),
    "bias": _torques("q", "qd"),
    "mass_matrix": _mass_matrix,
    "inverse_mass_matrix": lambda arm, at: (_inverse(*_mass_matrix(arm, at)),),
    "forward_dynamics": _forward("q", "qd"),
    "christoffel_symbols": _symbols,
    "controller": lambda arm, at: (
        *_pose(arm, at),
        *_jacobian(arm, at),
        arm.inverse_dynamics(**_state(at, "q", "qd")),
        *_mass_matrix(arm, at),
    ),
    "coriolis_matrix": _coriolis_matrix,
    "inverse_dynamics_derivatives": _inverse_slopes,
    "forward_dynamics_derivatives": _forward_slopes,
    "kinetic_energy": _value("kinetic", lambda arm: arm.kinetic_of_links + arm.kinetic_of_motors, "q", "qd"),
    "potential_energy": _value("potential", lambda arm: arm.potential, "q"),
    "momentum": lambda arm, at: (_mass_matrix(arm, at)[0] @ at["qd"],),
    "coriolis": lambda arm, at: (_coriolis_matrix(arm, at)[0] @ at["qd"],),
    "momentum_observer_term": lambda arm, at: (
        _coriolis_matrix(arm, at)[0].T @ at["qd"] - arm.inverse_dynamics(q=at["q"]),
    ),
    "forward_kinematics": _pose,
    "link_poses": _links,
    "jacobian": _jacobian,
    "tool_jacobian": _tool_jacobian,
    "lambda_inverse": _lambda,
    "jacobian_dot_qd": _value("drift", lambda arm: arm.rate(arm.jacobian) @ arm.qd, "q", "qd"),
    "motor_torque": lambda arm, at: (_motors(arm, at),),
    "motor_current": _currents,
    "wrench_torques": lambda arm, at: (_jacobian(arm, at)[0].T @ at["w"],),
    "inverse_dynamics_with_wrench": _torques("q", "qd", "qdd", "w"),
    "gravity_with_wrench": _torques("q", "w"),
    "bias_with_wrench": _torques("q", "qd", "w"),
    "forward_dynamics_with_wrench": _forward("q", "qd", "w"),
    "joint_reactions": _reactions("q", "qd", "qdd"),
    "joint_reactions_with_wrench": _reactions("q", "qd", "qdd", "w"),
}
