"""The numbers of a robot with its run-time parameters filled in; all that the references share."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.robot.filling import without_values
from robodyn.robot.model import Robot
from robodyn.robot.values import Affine, Value

#: Values of run-time parameters by name, SI units.
Parameters = Mapping[str, float]


def exact_value(value: Value, parameters: Parameters) -> Fraction:
    """``value`` with the parameters filled in, exactly (a double is a rational)."""
    if isinstance(value, Affine):
        terms = (coefficient * Fraction(float(parameters[name])) for name, coefficient in value.terms)
        return value.constant + sum(terms, Fraction(0))
    return value


def real(value: Fraction) -> float:
    """``value`` as a double; infinite where it is beyond the largest one."""
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def filled(robot: Robot, parameters: Parameters | None) -> Parameters:
    """``parameters`` as a mapping that has every run-time parameter of ``robot``.

    Raises
    ------
    InputError: one is missing.
    """
    complaint = without_values(robot, parameters or {})
    if complaint is not None:
        raise complaint
    return parameters or {}


# Arrays may be complex: imaginary parts are what :meth:`.Reference.torque_slope` differentiates by. Signs and
# sizes are those of the real parts.


def sign(x: NDArray[Any]) -> NDArray[Any]:
    """-1, 0 or 1."""
    return np.asarray(np.sign(np.real(x)))


def size(x: NDArray[Any]) -> NDArray[Any]:
    """``|x|``."""
    return np.asarray(x * sign(x))


def length(x: NDArray[Any], y: NDArray[Any]) -> NDArray[Any]:
    """``sqrt(x^2 + y^2)``; where that is 0 it does not change either."""
    squares = x * x + y * y
    return np.sqrt(np.where(np.real(squares) > 0, squares, 0.0))
