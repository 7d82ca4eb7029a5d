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


def _expression(name: str, *inputs: str) -> Answer:
    """A property of the reference at some of the inputs."""
    return lambda arm, at: (arm.value(name, lambda: getattr(arm, name), **_state(at, *inputs)),)


def _torques(*inputs: str) -> Answer:
    return lambda arm, at: (arm.inverse_dynamics(**_state(at, *inputs)),)


def _inverse(matrix: Array) -> Array:
    return np.asarray(np.linalg.inv(matrix), np.float64)


def _gravity(arm: Reference, at: State) -> Array:
    return arm.inverse_dynamics(q=at["q"])


def _kinetic(arm: Reference, at: State) -> tuple[Array, ...]:
    energy = arm.value(
        "kinetic", lambda: arm.kinetic_of_links + arm.kinetic_of_motors, **_state(at, "q", "qd")
    )
    return (energy,)


def _momentum(arm: Reference, at: State) -> tuple[Array, ...]:
    return (arm.value("mass_matrix", lambda: arm.mass_matrix, q=at["q"]) @ at["qd"],)


def _pose(arm: Reference, at: State) -> tuple[Array, ...]:
    return (arm.value("tool", lambda: arm.tool[:3, :], q=at["q"]),)


def _links(arm: Reference, at: State) -> tuple[Array, ...]:
    frames = arm.value("frames", lambda: ca.vertcat(*arm.frames), q=at["q"]).reshape(arm.n, 4, 4)
    return frames[:, :3, 3], frames[:, :3, :3]


def _tool_jacobian(arm: Reference, at: State) -> tuple[Array, ...]:
    jacobian, back = _jacobian(arm, at), _pose(arm, at)[0][:, :3].T
    return (np.vstack([back @ jacobian[:3], back @ jacobian[3:]]),)


def _jacobian(arm: Reference, at: State) -> Array:
    return arm.value("jacobian", lambda: arm.jacobian, q=at["q"])


def _drift(arm: Reference, at: State) -> tuple[Array, ...]:
    return (arm.value("drift", lambda: arm.rate(arm.jacobian) @ arm.qd, **_state(at, "q", "qd")),)


def _mass(arm: Reference, at: State) -> Array:
    return arm.value("mass_matrix", lambda: arm.mass_matrix, q=at["q"])


def _lambda(arm: Reference, at: State) -> tuple[Array, ...]:
    jacobian = _jacobian(arm, at)
    return (jacobian @ np.linalg.solve(_mass(arm, at), jacobian.T),)


def _coriolis(arm: Reference, at: State) -> Array:
    return arm.value("coriolis_matrix", lambda: arm.coriolis_matrix, **_state(at, "q", "qd"))


def _symbols(arm: Reference, at: State) -> tuple[Array, ...]:
    rows = [ca.vertcat(*block) for block in arm.christoffel]
    return (arm.value("christoffel", lambda: ca.vertcat(*rows), q=at["q"]).reshape(arm.n, arm.n, arm.n),)


def _motors(arm: Reference, at: State) -> Array:
    ratios = np.array([link["gear"]["ratio"] for link in arm.links])
    return np.asarray(arm.inverse_dynamics(**_state(at, "q", "qd", "qdd")) / ratios, np.float64)


def _currents(arm: Reference, at: State) -> tuple[Array, ...]:
    return (_motors(arm, at) / np.array([link["gear"]["torque_constant"] for link in arm.links]),)


def _forward(*inputs: str) -> Answer:
    return lambda arm, at: (arm.accelerations(at["tau"], **_state(at, *inputs)),)


def _reactions(*inputs: str) -> Answer:
    def rows(arm: Reference) -> ca.SX:
        return ca.vertcat(*[ca.horzcat(force.T, moment.T) for force, moment in arm.reactions])

    return lambda arm, at: (arm.value("reactions", lambda: rows(arm), **_state(at, *inputs)),)


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
    "gravity": lambda arm, at: (_gravity(arm, at),),
    "bias": _torques("q", "qd"),
    "mass_matrix": lambda arm, at: (_mass(arm, at),),
    "inverse_mass_matrix": lambda arm, at: (_inverse(_mass(arm, at)),),
    "forward_dynamics": _forward("q", "qd"),
    "christoffel_symbols": _symbols,
    "controller": lambda arm, at: (
        *_pose(arm, at),
        _jacobian(arm, at),
        arm.inverse_dynamics(**_state(at, "q", "qd")),
        _mass(arm, at),
    ),
    "coriolis_matrix": lambda arm, at: (_coriolis(arm, at),),
    "inverse_dynamics_derivatives": _inverse_slopes,
    "forward_dynamics_derivatives": _forward_slopes,
    "kinetic_energy": _kinetic,
    "potential_energy": _expression("potential", "q"),
    "momentum": _momentum,
    "coriolis": lambda arm, at: (_coriolis(arm, at) @ at["qd"],),
    "momentum_observer_term": lambda arm, at: (_coriolis(arm, at).T @ at["qd"] - _gravity(arm, at),),
    "forward_kinematics": _pose,
    "link_poses": _links,
    "jacobian": lambda arm, at: (_jacobian(arm, at),),
    "tool_jacobian": _tool_jacobian,
    "lambda_inverse": _lambda,
    "jacobian_dot_qd": _drift,
    "motor_torque": lambda arm, at: (_motors(arm, at),),
    "motor_current": _currents,
    "wrench_torques": lambda arm, at: (_jacobian(arm, at).T @ at["w"],),
    "inverse_dynamics_with_wrench": _torques("q", "qd", "qdd", "w"),
    "gravity_with_wrench": _torques("q", "w"),
    "bias_with_wrench": _torques("q", "qd", "w"),
    "forward_dynamics_with_wrench": _forward("q", "qd", "w"),
    "joint_reactions": _reactions("q", "qd", "qdd"),
    "joint_reactions_with_wrench": _reactions("q", "qd", "qdd", "w"),
}
