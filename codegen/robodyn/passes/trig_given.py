"""Sines and cosines given by the caller: an array ``sc`` takes the place of ``q``.

A change of interface rather than a pass: the program afterwards reads ``sc`` and calls no sine.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from robodyn.ir.evaluate import angle_form, is_angle
from robodyn.ir.program import Input, Operand, Operation, Program
from robodyn.passes.order import dce

#: One element of ``sc``: "cos" or "sin" of multiples of joint angles plus a constant [rad], or
#: "q", a prismatic joint's displacement.
AngleInput = tuple[str, tuple[tuple[Input, int | Fraction], ...], Fraction]


def given_layout(programs: Sequence[Program]) -> tuple[AngleInput, ...]:
    """What ``sc`` holds for all of ``programs``: sines and cosines, then displacements, by joint."""
    angles: set[AngleInput] = set()
    for program in programs:
        for op, args, _ in program.operations:
            if op in ("sin", "cos") and _of_positions(program, args[0]):
                angles.add((op, *angle_form(program, args[0])))
        angles.update(("q", ((x, 1),), Fraction(0)) for x in _displacements(program))
    return tuple(sorted(angles, key=lambda g: (g[0] == "q", g[1], g[2], g[0])))


def _of_positions(program: Program, operand: Operand) -> bool:
    """Whether ``operand`` is an angle that the caller knows: what a kernel remembers is not his."""
    return is_angle(program, operand) and all(x.is_of("q") for x, _ in angle_form(program, operand)[0])


def _displacements(program: Program) -> list[Input]:
    """Joint variables that are read other than as angles."""
    displacements: dict[Input, None] = {}
    seen: set[int] = set()
    stack: list[Operand] = list(program.results())
    while stack:
        operand = stack.pop()
        if isinstance(operand, Input) and operand.is_of("q"):
            displacements[operand] = None
        elif isinstance(operand, int) and operand not in seen:
            seen.add(operand)
            operation = program.operations[operand]
            if operation.op not in ("sin", "cos") or not _of_positions(program, operation.args[0]):
                stack.extend(operation.args)
    return list(displacements)


def trig_given(program: Program, layout: Sequence[AngleInput]) -> Program:
    """``program`` with the elements of ``layout`` read from ``sc``."""
    place = {angle: Input("sc", k) for k, angle in enumerate(layout)}
    values: list[Operand] = []
    operations: list[Operation] = []

    def moved(operand: Operand) -> Operand:
        if isinstance(operand, int):
            return values[operand]
        if isinstance(operand, Input) and operand.is_of("q"):
            return place.get(("q", ((operand, 1),), Fraction(0)), operand)
        return operand

    for op, args, label in program.operations:
        if op in ("sin", "cos") and _of_positions(program, args[0]):
            values.append(place[(op, *angle_form(program, args[0]))])
            continue
        operations.append(Operation(op, tuple(map(moved, args)), label))
        values.append(len(operations) - 1)
    outputs = tuple((name, tuple(map(moved, elements))) for name, elements in program.outputs)
    return dce(Program(tuple(operations), outputs))


def describe(angle: AngleInput) -> str:
    """``cos(q2 + q3)``, or ``q3`` for a displacement."""
    kind, terms, constant = angle
    if kind == "q":
        return str(terms[0][0])
    factors = [m if isinstance(m, int) else float(m) for _, m in terms]
    words = [str(x) if m == 1 else f"{m!r}*{x}" for m, (x, _) in zip(factors, terms, strict=True)]
    text = " + ".join(words).replace("+ -", "- ")
    if constant:
        text += f" {'-' if constant < 0 else '+'} {abs(float(constant))!r}"
    return f"{kind}({text})"
