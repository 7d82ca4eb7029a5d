"""Specialise: inverse dynamics with no velocity or no acceleration is gravity or bias."""

from __future__ import annotations

from fractions import Fraction

from robodyn.dynamics.functions import function_named
from robodyn.ir.program import Input, Operand, Operation, Program


def at_rest(inverse_dynamics: Program, function: str) -> Program:
    """The program of ``function`` (torques, such as ``gravity`` or ``bias``) out of that of the inverse
    dynamics: the same operations on zeros, for the passes to fold.

    Raises
    ------
    ValueError: it is something else.
    """
    zero = function_named(function).zeros
    if zero is None:
        raise ValueError(f"{function} is no torques of the recursion")

    def known(operand: Operand) -> Operand:
        return Fraction(0) if isinstance(operand, Input) and operand.is_of(*zero) else operand

    operations = tuple(
        Operation(op, tuple(map(known, args)), label) for op, args, label in inverse_dynamics.operations
    )
    outputs = tuple((name, tuple(map(known, elements))) for name, elements in inverse_dynamics.outputs)
    return Program(operations, outputs)
