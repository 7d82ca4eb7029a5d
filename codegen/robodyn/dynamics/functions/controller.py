"""What a controller in the tool's space asks for at every sample, in one function."""

from __future__ import annotations

from dataclasses import replace

from robodyn.dynamics.functions.fusing import fused
from robodyn.dynamics.functions.kinematics import FUNCTIONS as KINEMATICS
from robodyn.dynamics.functions.standard import FUNCTIONS as STANDARD

_BY_NAME = {function.name: function for function in (*KINEMATICS, *STANDARD)}

FUNCTIONS = (
    replace(
        fused([_BY_NAME[part] for part in ("forward_kinematics", "jacobian", "bias", "mass_matrix")]),
        name="controller",
        purpose="pose and Jacobian of the tool, bias and mass matrix, which share their work",
    ),
)
