"""The numbers of a robot with its run-time parameters filled in; all that the references share."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

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
