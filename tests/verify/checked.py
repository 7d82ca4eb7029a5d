"""What test_check and test_check_special_arms share."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from robodyn.ir.signature import Signature
from robodyn.robot.model import Robot
from robodyn.verify import Reference, VerifyReport, verify

INPUTS = {
    "inverse_dynamics": ("q", "qd", "qdd"),
    "gravity": ("q",),
    "bias": ("q", "qd"),
    "mass_matrix": ("q",),
    "forward_dynamics": ("q", "qd", "tau"),
}


class Stand:
    """In a compiled kernel's place: the reference of ``robot``, rounded to the kernel's type."""

    def __init__(
        self, robot: Robot, scalar: Any = "double", functions: tuple[str, ...] = tuple(INPUTS)
    ) -> None:
        self.model = robot
        self.robot, self.scalar, self.language = robot.name, scalar, "c"
        self.dtype = np.dtype(np.float64 if scalar == "double" else np.float32)
        self.functions = functions
        self.signatures = {f: self.signature(f) for f in functions}

    def signature(self, function: str) -> Signature:
        n = self.model.n
        inputs = tuple((name, n) for name in INPUTS[function])
        output = ("M", n * n) if function == "mass_matrix" else ("tau", n)
        return Signature(self.robot, function, inputs, (output,), self.model.parameters, self.scalar)

    def __getattr__(self, name: str) -> Callable[..., Any]:
        def call(*arrays: Any, params: Any = None) -> Any:
            return getattr(Reference(self.model, params), name)(*arrays).astype(self.dtype)

        return call


def check(robot: Robot, kernel: Any, **options: Any) -> VerifyReport:
    return verify(robot, kernel, **{"states": 40, "exact_states": 2, **options})
