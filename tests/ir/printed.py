"""What test_program and test_fingerprint share."""

from __future__ import annotations

from fractions import Fraction

from robodyn.ir import Input, Label, Operation, Program

X, Y = Input("x", None), Input("y", None)
Q1, Q2 = Input("q", 0), Input("q", 1)


# --- data -------------------------------------------------------------------------------------------------


def small() -> Program:
    """``tau = [x q2 - 1/2 sin(q1), x]`` and a constant."""
    return Program(
        (
            Operation("sin", (Q1,), Label(1, "s", "")),
            Operation("mul", (X, Q2)),
            Operation("mul", (Fraction(1, 2), 0)),
            Operation("sub", (1, 2), Label(1, "tau", "", negative=True)),
        ),
        (("tau", (3, X)), ("M", (Fraction(-3, 4), 0))),
    )
