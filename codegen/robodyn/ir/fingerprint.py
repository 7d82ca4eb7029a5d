"""Programs compared: their values at a random point of a finite field that nobody can know beforehand."""

from __future__ import annotations

import contextlib
import hashlib
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

from robodyn.ir.evaluate import AngleForm, Circle, angle_form, is_angle
from robodyn.ir.field import BITS, Field, Vanishes
from robodyn.ir.program import Input, Operand, Program


def fingerprint(
    program: Program,
    field: Field | str | int,
    constant_point: Callable[[Fraction], Circle],
) -> tuple[int, ...]:
    """The outputs at one random point of ``field``, or of the one drawn from a seed.

    Two programs that are the same rational function (of inputs, sines and cosines) agree at every
    point; two that differ agree with a probability of about their degree / 2^119. Exact as ``Fraction``s are,
    and a hundred times faster, so that every pass can be checked on every run. The angles of joints are
    random points of the circle group, so that sines of sums obey the addition theorems; a part of an angle,
    as in ``sin(q / 2)``, is an angle of its own. A sine of anything but multiples of inputs and all else that
    arithmetic does not have are random functions, as :meth:`~robodyn.ir.field.Field.opaque` has them.

    Raises
    ------
    ZeroDivisionError: a divisor is zero as a function.
    Vanishes: a constant has no place in the field, or that of zero.
    """
    if not isinstance(field, Field):
        field = Field(f"seed {field}")
    p = field.prime
    field.prepare(arg.denominator for arg in constants(program))
    variables: dict[Input, int] = {}
    powers: dict[AngleForm, tuple[int, int]] = {}
    forms: dict[int, AngleForm] = {}

    def variable(x: Input) -> int:
        if x not in variables:
            variables[x] = field.variable(x)
        return variables[x]

    def circle(operand: Operand) -> tuple[int, int]:
        form = angle_form(program, operand, forms)
        if form not in powers:
            terms, constant = form
            total = (1, 0)
            if constant:
                cosine, sine = constant_point(constant)
                total = (field.number(cosine), field.number(sine))
            for x, multiple in terms:
                part = field.angle(x, multiple.denominator)
                total = field.turn(total, field.multiple(part, multiple.numerator))
            powers[form] = total
        return powers[form]

    values: list[int] = []

    def value(operand: Operand) -> int:
        if isinstance(operand, int):
            return values[operand]
        if isinstance(operand, Input):
            return variable(operand)
        return field.number(operand)

    for op, args, _ in program.operations:
        if op in ("sin", "cos") and is_angle(program, args[0], forms):
            values.append(circle(args[0])[op == "sin"])
            continue
        x = value(args[0])
        if op == "add":
            x = x + value(args[1])
        elif op == "sub":
            x = x - value(args[1])
        elif op == "mul":
            x = x * value(args[1])
        elif op == "div":
            divisor = value(args[1])
            if not divisor:
                raise ZeroDivisionError("division by what is zero at a random point")
            x = x * pow(divisor, -1, p)
        elif op == "neg":
            x = -x
        else:
            x = field.opaque(op, x, *[value(arg) for arg in args[1:]])
        values.append(x % p)
    return tuple([value(operand) for operand in program.results()])


def constants(program: Program) -> Iterator[Fraction]:
    """Every constant that ``program`` reads."""
    for operation in program.operations:
        for arg in operation.args:
            if arg.__class__ is Fraction:
                yield arg
    for operand in program.results():
        if operand.__class__ is Fraction:
            yield operand


def digest(program: Program) -> bytes:
    """A hash of all that ``program`` computes: operations, constants, outputs; not of its labels."""
    lines: list[str] = []
    if program.iteration is not None:
        most = program.iteration.most
        start, step, program = program.parts()
        lines += [f"at most {most}", digest(start).hex(), digest(step).hex()]
    for op, args, _ in program.operations:
        lines.append(op)
        lines.extend([_word(arg) for arg in args])
    for name, elements in program.outputs:
        lines.append(f"= {name}")
        lines.extend([_word(operand) for operand in elements])
    return hashlib.blake2b("\n".join(lines).encode(), digest_size=32).digest()


def _word(operand: Operand) -> str:
    if operand.__class__ is int:
        return f"%{operand}"
    if operand.__class__ is Input:
        return f"{operand.array} {operand.index}"
    return f"{operand.numerator:x}/{operand.denominator:x}"  # type: ignore[union-attr]


#: So many primes in a row that divide a constant are no chance.
_DRAWS = 4


def in_drawn_field(
    decide: Callable[[Field], Any], *parts: bytes, prime_of: bytes | None = None, bits: int = BITS
) -> Any:
    """What ``decide`` makes of a field of so many ``bits`` that is drawn from ``parts``: all that whoever
    would like another answer could change. Where a constant vanishes in the field, the next one is taken.

    The first prime belongs to ``prime_of`` where that is given: comparisons that share it draw it but once.

    Raises
    ------
    Vanishes: constants vanish in field after field, which does not happen.
    """
    seed = b"".join(len(part).to_bytes(4, "big") + part for part in parts)
    for k in range(_DRAWS - 1):
        with contextlib.suppress(Vanishes):
            return decide(Field(seed + bytes((k,)), prime_of if k == 0 else None, bits=bits))
    return decide(Field(seed + bytes((_DRAWS - 1,)), bits=bits))


def agree(
    one: Program,
    other: Program,
    constant_point: Callable[[Fraction], Circle],
    *context: bytes,
    prime_of: bytes | None = None,
    bits: int = BITS,
) -> bool:
    """Whether two programs compute the same function, by their :func:`fingerprint` in a field of so many
    ``bits`` that is drawn from both and from ``context``; its prime from ``prime_of`` where that is given.

    Raises
    ------
    ZeroDivisionError: a divisor is zero as a function.
    """

    def same(field: Field) -> bool:
        return fingerprint(one, field, constant_point) == fingerprint(other, field, constant_point)

    parts = (digest(one), digest(other), *context)
    return bool(in_drawn_field(same, *parts, prime_of=prime_of, bits=bits))
