"""Specialise: inverse dynamics with no velocity or no acceleration is gravity or bias."""

from __future__ import annotations

from fractions import Fraction

from robodyn.ir.program import Input, Operand, Operation, Program

#: Inputs that are zero in each function.
_ZERO = {"gravity": ("qd", "qdd"), "bias": ("qdd",)}


def at_rest(inverse_dynamics: Program, function: str) -> Program:
    """The program of ``function`` (``gravity`` or ``bias``) out of that of the inverse dynamics: the same
    operations on zeros, for the passes to fold."""
    zero = _ZERO[function]

    def known(operand: Operand) -> Operand:
        return Fraction(0) if isinstance(operand, Input) and operand.is_of(*zero) else operand

    operations = tuple(
        Operation(op, tuple(map(known, args)), label) for op, args, label in inverse_dynamics.operations
    )
    outputs = tuple((name, tuple(map(known, elements))) for name, elements in inverse_dynamics.outputs)
    return Program(operations, outputs)
