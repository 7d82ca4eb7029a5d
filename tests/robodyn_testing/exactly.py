"""Numbers that are compared with a tuple of other types."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from robodyn.robot.values import Value


def exactly(*numbers: Any) -> tuple[Any, ...]:
    """``numbers`` as a tuple of any types: a ``Fraction`` may equal an ``int``, which mypy takes to be
    impossible where each stands in a tuple."""
    return numbers


def constant(value: Value) -> float:
    """A number of a robot as a float, where no run-time parameter is in it."""
    assert isinstance(value, Fraction)
    return float(value)
