"""The functions of every kernel: torques, mass matrix, accelerations."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.functions.record import QD, QDD, TAU, Array, Derivative, Function, Pair, Q, Writing
from robodyn.dynamics.mass_matrix import Factored, factoring, solve_symmetric
from robodyn.dynamics.state import Dynamics, Vector
from robodyn.dynamics.vectors import flat, products

M = Array("M", "mass matrix", "kg m^2, kg m, kg", shape=("n", "n"))
M_INVERSE = Array("M_inverse", "inverse mass matrix", "1/(kg m^2), 1/(kg m), 1/kg", shape=("n", "n"))


def _torques(*zeros: str) -> Writing:
    def written(at: Dynamics) -> Sequence[Any]:
        return at.torques(*(at.rest if name in zeros else at.inputs[name] for name in ("qd", "qdd")))

    return written


_INVERSE_DYNAMICS, _BIAS, _GRAVITY = _torques(), _torques("qdd"), _torques("qd", "qdd")


def _gravity_by_weights(at: Dynamics) -> Sequence[Any]:
    """Of the links alone: drives of rigid arms add nothing at rest."""
    from robodyn.dynamics.weights import holding_torques, weighed

    return holding_torques(at, weighed(at.links(at.rest, at.rest)))


def _mass_matrix(at: Dynamics) -> Sequence[Any]:
    return flat(at.mass_matrix())


def _accelerates(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """``M x`` for a random ``x``: as telling as all columns of ``M``, at a fraction of the cost."""
    return products(result, x), torques_from_rest(at, x)


def torques_from_rest(at: Dynamics, x: Vector) -> list[Any]:
    """The torques of the accelerations ``x`` less those at rest."""
    torques = zip(at.torques(at.rest, x), at.torques(at.rest, at.rest), strict=True)
    return [moving - still for moving, still in torques]


def _forward_dynamics(at: Dynamics) -> Sequence[Any]:
    """``qdd = M^-1 (tau - h)``."""
    matrix = at.mass_matrix()
    bias = at.torques(at.inputs["qd"], at.rest)
    right = [tau - h for tau, h in zip(at.inputs["tau"], bias, strict=True)]
    return solve_symmetric(matrix, right, at.mark)


def _articulated(at: Dynamics) -> Sequence[Any]:
    """Without a mass matrix: what takes fewer operations for long arms."""
    from robodyn.dynamics.articulated import articulated_bodies

    return articulated_bodies(at.links(at.inputs["qd"], at.rest), at.inputs["tau"], at.mark)


def _needs_the_torques(at: Dynamics, result: Sequence[Any], _: Vector) -> Pair:
    """The torques that the accelerations need: to compare accelerations would measure the condition of the
    mass matrix instead."""
    return at.torques(at.inputs["qd"], result), at.inputs["tau"]


def _inverse(at: Dynamics) -> Sequence[Any]:
    return flat(Factored(at.mass_matrix(), at.mark).inverse())


def _inverse_by_responses(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.operational import inverse_mass_matrix_by_responses

    return flat(inverse_mass_matrix_by_responses(at))


def _undoes_the_matrix(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """The torques of the accelerations that the inverse makes of ``x``, less those at rest, are ``x``."""
    return torques_from_rest(at, products(result, x)), x


_BY_Q = Derivative("q", "inverse_dynamics_derivatives", "dtau_dq")
_BY_QD = Derivative("qd", "inverse_dynamics_derivatives", "dtau_dqd")


FUNCTIONS = (
    Function(
        "inverse_dynamics",
        "torques that give the accelerations qdd",
        (Q, QD, QDD),
        (TAU,),
        _INVERSE_DYNAMICS,
        expected=_INVERSE_DYNAMICS,
        by_default=True,
        zeros=(),
        derivatives=(_BY_Q, _BY_QD, Derivative("qdd", "mass_matrix", "M", affine=True)),
    ),
    Function(
        "gravity",
        "torques that hold the arm at rest",
        (Q,),
        (TAU,),
        _GRAVITY,
        expected=_GRAVITY,
        by_default=True,
        zeros=("qd", "qdd"),
        derivatives=(_BY_Q,),
        of_rigid_arms=(_gravity_by_weights,),
    ),
    Function(
        "bias",
        "torques at zero acceleration: Coriolis, centrifugal, gravity, friction",
        (Q, QD),
        (TAU,),
        _BIAS,
        expected=_BIAS,
        by_default=True,
        zeros=("qdd",),
        derivatives=(_BY_Q, _BY_QD),
    ),
    Function(
        "mass_matrix",
        "mass matrix, rotor inertias on its diagonal",
        (Q,),
        (M,),
        _mass_matrix,
        expected=_mass_matrix,
        condition=_accelerates,
        by_default=True,
    ),
    Function(
        "forward_dynamics",
        "accelerations that the torques tau give",
        (Q, QD, TAU),
        (QDD,),
        _forward_dynamics,
        in_coordinates=_forward_dynamics,
        condition=_needs_the_torques,
        by_default=True,
        parts=("bias", "mass_matrix"),
        solves=True,
        of_rigid_arms=(_articulated,),
        beside_parts=factoring,
        derivatives=tuple(
            Derivative(by, "forward_dynamics_derivatives", f"dqdd_d{by}") for by in ("q", "qd", "tau")
        ),
    ),
    Function(
        "inverse_mass_matrix",
        "inverse of the mass matrix, rotors included",
        (Q,),
        (M_INVERSE,),
        _inverse,
        in_coordinates=_inverse,
        condition=_undoes_the_matrix,
        parts=("mass_matrix",),
        solves=True,
        of_long_arms=(_inverse_by_responses,),
        beside_parts=lambda joints: 2 * factoring(joints),
    ),
)
