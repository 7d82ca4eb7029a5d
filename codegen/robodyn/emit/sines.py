"""Sines and cosines of a function for our own sine and cosine: those of the joint angles in one loop."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from robodyn.emit.spelling import Spelling
from robodyn.emit.statements import Apply, Body, Expression, Statement
from robodyn.ir.program import Input, Operand, Program
from robodyn.passes.dce import kept

#: Names of the local arrays, as arrays of inputs; no value of a program is called so.
ANGLES, SINES, COSINES = "angles", "sines", "cosines"

#: What an angle is made with.
_SUMS = ("add", "sub", "mul", "neg")


@dataclass(frozen=True, slots=True)
class Together:
    """A body whose sines and cosines of joint angles come first.

    ``sums`` are the statements that the angles need, ``angles`` the distinct angles, as many as the loop
    has turns; ``body`` reads ``sines[k]`` and ``cosines[k]``. ``later`` are the arguments of the other
    sines, known only as the body goes on: pair ``k`` is ``later{k}[0..1]``.
    """

    sums: tuple[Statement, ...]
    angles: tuple[Expression, ...]
    body: Body
    later: dict[str, Expression]


def together(body: Body, lanes: int) -> Together:
    """``body`` with one call a distinct angle; from three angles on as many as fill ``lanes`` at a time."""
    made = {s.name: s.expression for s in body.statements}
    first: dict[Expression, int] = {}
    later: dict[Expression, str] = {}
    needed: set[str] = set()
    statements: list[Statement] = []
    for statement in body.statements:
        found = statement.expression
        if not (isinstance(found, Apply) and found.op in ("sin", "cos")):
            statements.append(statement)
            continue
        (angle,) = found.args
        names = _of_positions(angle, made)
        if names is None:
            pair = Input(later.setdefault(angle, f"later{len(later) + 1}"), int(found.op == "cos"))
        else:
            needed |= names
            pair = Input(SINES if found.op == "sin" else COSINES, first.setdefault(angle, len(first)))
        statements.append(replace(statement, expression=pair))
    angles = list(first)
    while len(angles) > 2 and len(angles) % lanes:
        angles.append(Fraction(0))
    return Together(
        tuple(s for s in body.statements if s.name in needed),
        tuple(angles),
        replace(body, statements=tuple(s for s in statements if s.name not in needed)),
        {name: angle for angle, name in later.items()},
    )


def _of_positions(angle: Expression, made: dict[str, Expression]) -> set[str] | None:
    """The statements that ``angle`` needs if it is known from positions and parameters alone."""
    needed: set[str] = set()
    stack = [angle]
    while stack:
        expression = stack.pop()
        if isinstance(expression, str):
            if expression not in needed:
                needed.add(expression)
                stack.append(made[expression])
        elif isinstance(expression, Apply):
            if expression.op not in _SUMS:
                return None
            stack.extend(expression.args)
        elif not _is_position(expression):
            return None
    return needed


def _is_position(operand: Input | Fraction) -> bool:
    """Whether the caller gives it with the positions: a constant, a run-time parameter, a position."""
    return isinstance(operand, Fraction) or operand.index is None or operand.array == "q"


def angles_first(program: Program) -> Program:
    """``program`` with the sums that are angles of sines and cosines before all else."""
    operations = program.operations
    from_positions: list[bool] = []
    for op, args, _ in operations:
        known = (from_positions[x] if isinstance(x, int) else _is_position(x) for x in args)
        from_positions.append(op in _SUMS and all(known))
    wanted: set[int] = set()
    stack: list[Operand] = [op.args[0] for op in operations if op.op in ("sin", "cos")]
    while stack:
        operand = stack.pop()
        if isinstance(operand, int) and from_positions[operand] and operand not in wanted:
            wanted.add(operand)
            stack.extend(operations[operand].args)
    rest = (i for i in range(len(operations)) if i not in wanted)
    return kept(program, [*sorted(wanted), *rest])


def c_lines(body: Body, lanes: int, name: str, spelling: Spelling) -> list[str]:
    """The statements of ``body`` as lines of C, its sines and cosines by ``NAME_sincos_``."""
    found = together(body, lanes)
    real, size = f"{name}_real", len(found.angles)

    def line(statement: Statement) -> list[str]:
        text = f"const {real} {statement.name} = {spelling.text(statement.expression)};"
        return spelling.wrapped(text, "    ")

    def pair(array: str, angle: Expression) -> list[str]:
        call = f"{name}_sincos_({spelling.text(angle)}, &{array}[0], &{array}[1]);"
        return [f"    {real} {array}[2];", *spelling.wrapped(call, "    ")]

    lines = _lines(found.sums, line, "/* %s */")
    if size:
        angles = ", ".join(spelling.text(angle) for angle in found.angles)
        lines += spelling.wrapped(f"const {real} {ANGLES}[{size}] = {{{angles}}};", "    ")
        lines += [f"    {real} {SINES}[{size}];", f"    {real} {COSINES}[{size}];"]
        call = f"{name}_sincos_({ANGLES}[i], &{SINES}[i], &{COSINES}[i]);"
        if size > 1:
            lines += [f"    for (int i = 0; i < {size}; ++i) {{", "        " + call, "    }"]
        else:
            lines.append("    " + call.replace("[i]", "[0]"))
    return lines + _lines(found.body.statements, line, "/* %s */", found.later, pair)


def fortran_lines(body: Body, lanes: int, name: str, spelling: Spelling) -> tuple[list[str], list[str]]:
    """The same in Fortran, and the local arrays as a declaration has them."""
    found = together(body, lanes)

    def line(statement: Statement) -> list[str]:
        return spelling.wrapped(f"{statement.name} = {spelling.text(statement.expression)}", "    ")

    def pair(array: str, angle: Expression) -> list[str]:
        call = f"call {name}_sincos({spelling.text(angle)}, {array}(1), {array}(2))"
        return spelling.wrapped(call, "    ")

    lines = _lines(found.sums, line, "! %s")
    for i, angle in enumerate(found.angles):
        lines += spelling.wrapped(f"{spelling.element(ANGLES, i)} = {spelling.text(angle)}", "    ")
    arrays = [f"{pair}(2)" for pair in found.later]
    if found.angles:
        lines.append(f"    call {name}_sincos({ANGLES}, {SINES}, {COSINES})")
        arrays += [f"{array}({len(found.angles)})" for array in (ANGLES, SINES, COSINES)]
    return lines + _lines(found.body.statements, line, "! %s", found.later, pair), arrays


def _lines(
    statements: Sequence[Statement],
    line: Callable[[Statement], list[str]],
    comment: str,
    later: Mapping[str, Expression] | None = None,
    pair: Callable[[str, Expression], list[str]] | None = None,
) -> list[str]:
    """``statements`` with their headings, and each pair of ``later`` before the first that reads it."""
    lines: list[str] = []
    waiting = dict(later or {})
    for statement in statements:
        if statement.heading:
            lines.append("    " + comment % statement.heading)
        read = statement.expression
        if pair is not None and isinstance(read, Input) and read.array in waiting:
            lines += pair(read.array, waiting.pop(read.array))
        lines += line(statement)
    return lines
