"""What a program computes: a short text by which a record is found, and names for its values.

Programs of one function have the same text (:func:`function_key`), however they are written. A record is
found by it for a robot whose frames and numbers are others and whose function is the same. It is no proof:
the point is fixed, so that a program can be written for it. What is found is compared afterwards in fields
that nobody chooses (:mod:`robodyn.optimize.records.validation`).
"""

from __future__ import annotations

import hashlib
from dataclasses import replace
from typing import Final

from robodyn.ir.field import Field
from robodyn.ir.fingerprint import digest, fingerprint, in_drawn_field
from robodyn.ir.program import Label, Program
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


def labelled(program: Program, recursion: Program) -> Program:
    """``program`` with the labels that ``recursion`` has for the same values, each once; its own go."""
    result: Program = in_drawn_field(
        lambda field: _labelled(program, recursion, field), digest(program), digest(recursion)
    )
    return result


def _labelled(program: Program, recursion: Program, field: Field) -> Program:
    names: dict[int, Label] = {}
    for value, operation in zip(_values(recursion, field), recursion.operations, strict=True):
        if operation.label is not None:
            names.setdefault(value, operation.label)
    used: set[Label] = set()
    operations = []
    for value, operation in zip(_values(program, field), program.operations, strict=True):
        label = names.get(value)
        if label is None and value and (opposite := names.get(field.prime - value)) is not None:
            label = opposite.flipped()
        if label is not None and label._replace(negative=False) in used:
            label = None
        if label is not None:
            used.add(label._replace(negative=False))
        operations.append(operation._replace(label=label))
    return replace(program, operations=tuple(operations), origin=None)


def _values(program: Program, field: Field) -> tuple[int, ...]:
    """The value of each operation at a random point of ``field``."""
    everything = replace(program, outputs=(("all", tuple(range(len(program.operations)))),), origin=None)
    return fingerprint(everything, field, circle_point)
