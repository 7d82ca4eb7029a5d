"""Names for a program not written like the recursion: values that are its quantities are called so."""

from __future__ import annotations

from dataclasses import replace

from robodyn.ir.field import Field
from robodyn.ir.fingerprint import digest, fingerprint, in_drawn_field
from robodyn.ir.program import Label, Program
from robodyn.robot.values import circle_point


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
