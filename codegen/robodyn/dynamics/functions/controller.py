"""What a controller in the tool's space asks for at every sample, in one function."""

from __future__ import annotations

from dataclasses import replace

from robodyn.dynamics.functions.fusing import fused
from robodyn.dynamics.functions.kinematics import FUNCTIONS as KINEMATICS
from robodyn.dynamics.functions.standard import FUNCTIONS as STANDARD

_KNOWN = {function.name: function for function in (*KINEMATICS, *STANDARD)}
_PARTS = ("forward_kinematics", "jacobian", "bias", "mass_matrix")

FUNCTIONS = (
    replace(
        fused([_KNOWN[part] for part in _PARTS]),
        name="controller",
        purpose="pose and Jacobian of the tool, bias and mass matrix, which share their work",
    ),
)
