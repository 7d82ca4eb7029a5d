"""Which functions an arm need not have, by docs/: whatever else is refused counts as missing."""

from __future__ import annotations

from typing import Any, Final

from independent import drives
from independent.arms import Arm

SOLVING: Final = {
    "forward_dynamics",
    "forward_dynamics_derivatives",
    "forward_dynamics_with_wrench",
    "inverse_mass_matrix",
    "lambda_inverse",
}
LOADED: Final = {"load_dependent_friction", "transmission_loss"}
"""Their torques depend on the accelerations in ways that are not affine."""
LINEAR: Final = {
    "viscous_friction", "coulomb_friction", "rotor_inertia", "inertial_error", "payload", "base_tilt",
    "external_contact", "torque_bias", "torque_gain", "time_delay", "encoder_offset", "torque_saturation",
}  # fmt: skip
"""In base parameters, or in no kernel."""


def allowed(function: str, arm: Arm) -> bool:
    effects = {entry["effect"] for _, entry in drives.entries(arm).all}
    named = any(isinstance(link[key], str) for link in arm["links"] for key in ("a", "d"))
    if function in SOLVING or function.endswith("_with_wrench"):
        return bool(effects & LOADED)
    if function in ("regressor", "inverse_dynamics_from_parameters"):
        return named or not effects <= LINEAR
    if function in ("motor_torque", "motor_current"):
        return arm.get("torque_side") == "link"
    return named and "inverse_kinematics" in function


def gives_a_reason(refusal: Any) -> bool:
    """Says more than that it is refused."""
    return "; found " in refusal or "; expected " in refusal
