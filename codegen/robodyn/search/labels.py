"""Names for what a search has found: a value that is a quantity of the recursion is called by its name."""

from __future__ import annotations

from dataclasses import replace

from robodyn.ir.evaluate import PRIME, fingerprint
from robodyn.ir.program import Label, Program
from robodyn.robot.values import circle_point


def labelled(program: Program, recursion: Program) -> Program:
    """``program`` with the labels that ``recursion`` has for the same values, each once; its own go."""
    names: dict[int, Label] = {}
    for value, operation in zip(_values(recursion), recursion.operations, strict=True):
        if operation.label is not None:
            names.setdefault(value, operation.label)
    used: set[Label] = set()
    operations = []
    for value, operation in zip(_values(program), program.operations, strict=True):
        label = names.get(value)
        if label is None and value and (opposite := names.get(PRIME - value)) is not None:
            label = opposite.flipped()
        if label is not None and label._replace(negative=False) in used:
            label = None
        if label is not None:
            used.add(label._replace(negative=False))
        operations.append(operation._replace(label=label))
    return replace(program, operations=tuple(operations), origin=None)


def _values(program: Program) -> tuple[int, ...]:
    """The value of each operation at a random point of the field."""
    everything = replace(program, outputs=(("all", tuple(range(len(program.operations)))),), origin=None)
    return fingerprint(everything, 7, circle_point)
