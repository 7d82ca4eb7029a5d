"""What a program computes, as a short text: programs of one function have the same, however they are written.

A record is found by it for a robot whose frames and numbers are others and whose function is the same. It is
no proof: the point is fixed, so that a program can be written for it. What is found is compared afterwards in
fields that nobody chooses (:mod:`robodyn.optimize.records.validation`).
"""

from __future__ import annotations

import hashlib
from typing import Final

from robodyn.ir.field import Field
from robodyn.ir.fingerprint import fingerprint
from robodyn.ir.program import Program
from robodyn.robot.values import circle_point

#: Field and point are drawn from this; other words make all keys in files worthless.
_SEED: Final = "robodyn record 1"


def function_key(program: Program, less: Program | None = None) -> str | None:
    """A hash of what ``program``, ``less`` another one with the same outputs, gives at one random point of a
    finite field: 32 hexadecimal digits.

    None where it has no value there: a divisor or a constant vanishes.
    """
    field = Field(_SEED)
    try:
        values = fingerprint(program, field, circle_point)
        if less is not None:
            other = fingerprint(less, field, circle_point)
            values = tuple((x - y) % field.prime for x, y in zip(values, other, strict=True))
    except (ValueError, ArithmeticError):
        return None
    outputs = " ".join(f"{name} {len(elements)}" for name, elements in program.outputs)
    return hashlib.sha256(f"{outputs}: {values}".encode()).hexdigest()[:32]
