"""Energies, momentum and what belongs to them: ``C qd``, and the term of the momentum observer."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.functions.record import QD, Array, Function, Pair, Q
from robodyn.dynamics.functions.standard import torques_from_rest
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.state import Dynamics, Vector
from robodyn.dynamics.vectors import HALF, inner

T = Array("E_kin", "kinetic energy", "J", shape=())
V = Array("E_pot", "potential energy, 0 at the origin of the base frame", "J", shape=())
P = Array("momentum", "generalised momentum M qd", "kg m^2/s", "kg m/s")
C_QD = Array("cqd", "Coriolis and centrifugal torques C qd", "N m", "N")
BETA = Array("beta", "C^T qd - g", "N m", "N")


# --- kinetic energy ---------------------------------------------------------------------------------------


def _kinetic(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.momenta import kinetic_energy

    links = at.links(at.inputs["qd"], at.rest, "inertia")
    return [kinetic_energy(links, at.rotors(), at.mark)]


def _half_the_square(at: Dynamics) -> Sequence[Any]:
    """``qd^T M qd / 2``, every entry of ``M`` read once."""
    qd, matrix = at.inputs["qd"], at.mass_matrix()
    energy: Any = 0
    for i, rate in enumerate(qd):
        momentum = HALF * matrix[i][i] * rate
        for j in range(i):
            momentum = momentum + matrix[i][j] * qd[j]
        energy = energy + momentum * rate
    return [energy]


def _work(at: Dynamics) -> Sequence[Any]:
    """``qd`` times half the momentum that torques show."""
    return [sum(HALF * rate * p for rate, p in zip(at.inputs["qd"], _momentum_by_torques(at), strict=True))]


# --- potential energy -------------------------------------------------------------------------------------


def _potential(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.weights import potential_inward, weighed

    return [potential_inward(weighed(at.links(at.rest, at.rest)), at.mark)]


def _potential_outward(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.weights import potential_outward, weighed

    return [potential_outward(weighed(at.links(at.rest, at.rest)), at.mark)]


def _heights(at: Dynamics) -> Sequence[Any]:
    """Link by link, by the heights of the centres of mass as they are described."""
    from robodyn.dynamics.reference import energies

    return [energies(at.arm, at.motion(at.rest, at.rest))[1]]


# --- momentum ---------------------------------------------------------------------------------------------


def _momentum(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.momenta import momenta

    return momenta(at.links(at.inputs["qd"], at.rest, "inertia"), at.rotors(), at.mark)[0]


def _as_torques(at: Dynamics) -> Sequence[Any]:
    """The torques that accelerate the links by ``qd`` from rest."""
    return at.inertial_torques(at.rest, at.inputs["qd"])


def _matrix_times_rates(at: Dynamics) -> Sequence[Any]:
    return [inner(row, at.inputs["qd"]) for row in at.mass_matrix()]


def _momentum_by_torques(at: Dynamics) -> list[Any]:
    return torques_from_rest(at, at.inputs["qd"])


# --- Coriolis ---------------------------------------------------------------------------------------------


def _coriolis(at: Dynamics) -> Sequence[Any]:
    return at.inertial_torques(at.inputs["qd"], at.rest)


def _bias_less_the_rest(at: Dynamics) -> Sequence[Any]:
    """The bias without gravity and friction."""
    qd = at.inputs["qd"]
    bias, gravity, motion = at.torques(qd, at.rest), at.torques(at.rest, at.rest), at.motion(qd, at.rest)
    return [
        h - g - joint_torque(at.arm, i, motion, 0, at.mark)
        for i, (h, g) in enumerate(zip(bias, gravity, strict=True))
    ]


def _rates_of_energies(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """Along a random ``x``, by Lagrange's equations: what the momentum gains while positions follow the
    rates, less the slope of the kinetic energy. ``x . p(qd)`` is ``T(qd + x) - T(qd) - T(x)``."""
    qd = at.inputs["qd"]
    both = [rate + step for rate, step in zip(qd, x, strict=True)]
    gain = _slope(at, both, qd) - _slope(at, qd, qd) - _slope(at, x, qd)
    return [inner(x, result)], [gain - _slope(at, qd, x)]


# --- momentum observer ------------------------------------------------------------------------------------


def _observer_term(at: Dynamics) -> Sequence[Any]:
    from robodyn.dynamics.momenta import momenta

    _, slope = momenta(at.links(at.inputs["qd"], at.rest, "inertia"), (), at.mark)
    return [x - g for x, g in zip(slope, at.torques(at.rest, at.rest), strict=True)]


def _observer_by_weights(at: Dynamics) -> Sequence[Any]:
    """The same with what holds the links alone: drives of rigid arms add nothing at rest."""
    from robodyn.dynamics.momenta import momenta
    from robodyn.dynamics.weights import holding_torques, weighed

    links = at.links(at.inputs["qd"], at.rest, "inertia")
    _, slope = momenta(links, (), at.mark)
    return [x - g for x, g in zip(slope, holding_torques(at, weighed(links)), strict=True)]


def _slopes_less_gravity(at: Dynamics) -> Sequence[Any]:
    """Derivatives of the kinetic energy by each position, less what holds the arm at rest."""
    qd, gravity = at.inputs["qd"], at.torques(at.rest, at.rest)
    units = [[int(i == j) for i in range(len(qd))] for j in range(len(qd))]
    return [_slope(at, qd, unit) - g for unit, g in zip(units, gravity, strict=True)]


def _slope_along(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """The same along a random ``x``."""
    still = at.torques(at.rest, at.rest)
    return [inner(x, result)], [_slope(at, at.inputs["qd"], x) - inner(x, still)]


def _slope(at: Dynamics, rates: Vector, x: Vector) -> Any:
    """The derivative of the kinetic energy at ``rates`` by the positions along ``x``."""
    from robodyn.dynamics.dual import moving_along, slopes
    from robodyn.dynamics.reference import energies

    still = at.spread(at.rest)
    motion = moving_along(at.arm, at.motion(rates, at.rest), at.spread(x), still, still)
    (slope,) = slopes(energies(at.arm, motion)[:1])
    return slope


FUNCTIONS = (
    Function(
        "kinetic_energy",
        "kinetic energy of links and rotors",
        (Q, QD),
        (T,),
        _kinetic,
        expected=_work,
        parts=("mass_matrix",),
        by_parts=_half_the_square,
        small=(_half_the_square,),
    ),
    Function(
        "potential_energy",
        "potential energy of the links in gravity, 0 at the origin of the base frame",
        (Q,),
        (V,),
        _potential,
        expected=_heights,
        others=(_potential_outward,),
        drives=False,
    ),
    Function(
        "momentum",
        "generalised momentum M qd, rotors included",
        (Q, QD),
        (P,),
        _momentum,
        expected=_momentum_by_torques,
        parts=("mass_matrix",),
        by_parts=_matrix_times_rates,
        others=(_as_torques,),
        small=(_matrix_times_rates,),
    ),
    Function(
        "coriolis",
        "Coriolis and centrifugal torques C qd: the bias without gravity and friction",
        (Q, QD),
        (C_QD,),
        _coriolis,
        expected=_coriolis,
        condition=_rates_of_energies,
        parts=("bias", "gravity"),
        by_parts=_bias_less_the_rest,
        drives=False,
    ),
    Function(
        "momentum_observer_term",
        "C^T qd - g: dp/dt of p = M qd is tau + C^T qd - g - friction",
        (Q, QD),
        (BETA,),
        _observer_term,
        expected=_slopes_less_gravity,
        condition=_slope_along,
        of_rigid_arms=(_observer_by_weights,),
    ),
)
