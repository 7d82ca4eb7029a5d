"""Every function as a user of a symbolic tool writes it, over the tool's scalars.

The recursion is that of :mod:`benchmarks.peers.textbook`; the mass matrix is that of composite bodies,
accelerations come of its factors, derivatives of the tool's own differentiation. Of a function that can be
written in several ways each is tried, and the one with the fewest operations counts.
"""

from __future__ import annotations

from collections.abc import Callable

from benchmarks.functions import dynamics, kinematics
from benchmarks.functions.state import State, Values, flat

Writing = Callable[[State], Values | None]
#: Every function, and the ways to write it.
NATURAL: dict[str, tuple[Writing, ...]] = {
    "inverse_dynamics": (dynamics.inverse_dynamics,),
    "gravity": (dynamics.gravity,),
    "bias": (dynamics.bias,),
    "mass_matrix": (lambda at: flat(dynamics.mass_matrix(at)), dynamics.mass_matrix_by_torques),
    "forward_dynamics": (dynamics.forward_dynamics, dynamics.forward_dynamics_by_solver),
    "joint_reactions": (dynamics.joint_reactions,),
    "coriolis_matrix": (dynamics.coriolis_matrix,),
    "inverse_dynamics_derivatives": (dynamics.inverse_dynamics_derivatives,),
    "forward_dynamics_derivatives": (
        dynamics.forward_dynamics_derivatives,
        dynamics.forward_dynamics_differentiated,
    ),
    "kinetic_energy": (
        dynamics.kinetic_energy,
        dynamics.kinetic_energy_by_matrix,
        dynamics.kinetic_energy_by_momentum,
    ),
    "potential_energy": (dynamics.potential_energy,),
    "momentum": (dynamics.momentum, dynamics.momentum_by_matrix),
    "coriolis": (dynamics.coriolis,),
    "momentum_observer_term": (
        dynamics.momentum_observer_term,
        dynamics.observer_by_momentum,
        dynamics.observer_by_matrix,
    ),
    "forward_kinematics": (kinematics.forward_kinematics,),
    "link_poses": (kinematics.link_poses,),
    "jacobian": (lambda at: flat(kinematics.jacobian(at)),),
    "tool_jacobian": (kinematics.tool_jacobian, kinematics.tool_jacobian_inwards),
    "jacobian_dot_qd": (kinematics.jacobian_dot_qd, kinematics.drift_differentiated),
    "inverse_mass_matrix": (dynamics.inverse_mass_matrix, dynamics.inverse_by_solver),
    "lambda_inverse": (dynamics.lambda_inverse, dynamics.lambda_inverse_by_columns),
}
