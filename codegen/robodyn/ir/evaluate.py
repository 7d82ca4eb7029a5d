"""Evaluation of a program over any scalar, and its fingerprint in a finite field."""

from __future__ import annotations

import functools
import hashlib
import math
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from robodyn.ir.program import Input, Operand, Program

#: Functions over float; give others for other scalars.
REAL_FUNCTIONS: dict[str, Callable[..., Any]] = {
    "sin": math.sin,
    "cos": math.cos,
    "sqrt": math.sqrt,
    "tanh": math.tanh,
    "sign": lambda x: (x > 0) - (x < 0),
    "abs": abs,
    "exp": math.exp,
    "pow": math.pow,
}


def evaluate(
    program: Program,
    inputs: Mapping[Input, Any],
    *,
    number: Callable[[Fraction], Any] = float,
    functions: Mapping[str, Callable[..., Any]] = REAL_FUNCTIONS,
) -> dict[str, list[Any]]:
    """Run ``program`` on ``inputs``; the outputs by name.

    ``number`` turns a constant into the scalar in use (``float``, ``Fraction``, ``sympy.Rational``...);
    ``functions`` has ``sin cos sqrt tanh sign abs exp pow`` over that scalar, those that the program needs.
    """
    values: list[Any] = []

    def value(operand: Operand) -> Any:
        if isinstance(operand, int):
            return values[operand]
        if isinstance(operand, Input):
            return inputs[operand]
        return number(operand)

    for op, args, _ in program.operations:
        x = value(args[0])
        if op == "add":
            values.append(x + value(args[1]))
        elif op == "sub":
            values.append(x - value(args[1]))
        elif op == "mul":
            values.append(x * value(args[1]))
        elif op == "div":
            values.append(x / value(args[1]))
        elif op == "neg":
            values.append(-x)
        elif op == "pow":
            values.append(functions[op](x, value(args[1])))
        else:
            values.append(functions[op](x))
    return {name: [value(operand) for operand in elements] for name, elements in program.outputs}


AngleForm = tuple[tuple[tuple[Input, int | Fraction], ...], Fraction]


def angle_form(program: Program, operand: Operand, known: dict[int, AngleForm] | None = None) -> AngleForm:
    """The argument of a sine or cosine as multiples of inputs plus a constant [rad].

    ``known`` remembers the forms of operations from call to call.
    """
    if isinstance(operand, Fraction):
        return (), operand
    if isinstance(operand, Input):
        return ((operand, 1),), Fraction(0)
    if known is not None and operand in known:
        return known[operand]
    op, args, _ = program.operations[operand]
    factors: tuple[int | Fraction, ...]
    if op == "mul" and isinstance(args[0], Fraction):
        factors, args = (_whole(args[0]),), args[1:]
    elif op in ("add", "sub", "neg"):
        factors = {"add": (1, 1), "sub": (1, -1), "neg": (-1,)}[op]
    else:
        raise ValueError(f"{op} in the argument of a sine")
    total: dict[Input, int | Fraction] = {}
    constant = Fraction(0)
    for factor, arg in zip(factors, args, strict=True):
        terms, rest = angle_form(program, arg, known)
        constant += factor * rest
        for name, multiple in terms:
            total[name] = _whole(total.get(name, 0) + factor * multiple)
    form = tuple(sorted((name, m) for name, m in total.items() if m)), constant
    if known is not None:
        known[operand] = form
    return form


def is_angle(program: Program, operand: Operand, known: dict[int, AngleForm] | None = None) -> bool:
    """Whether ``operand`` has an :func:`angle_form`."""
    try:
        angle_form(program, operand, known)
    except ValueError:
        return False
    return True


def _whole(x: int | Fraction) -> int | Fraction:
    """``x`` as an integer if it is one."""
    return x.numerator if isinstance(x, Fraction) and x.denominator == 1 else x


Circle = tuple[Any, Any]


def turn(first: Circle, second: Circle) -> Circle:
    """The point of the circle whose angle is the sum of two angles, each as (cos, sin)."""
    (c, s), (e, f) = first, second
    return c * e - s * f, s * e + c * f


def evaluate_exact(
    program: Program,
    inputs: Mapping[Input, Fraction],
    points: Mapping[Input, Circle],
    constant_point: Callable[[Fraction], Circle],
) -> dict[str, list[Fraction]]:
    """Run ``program`` on rationals, without rounding.

    ``points`` gives for each joint angle a rational point (cos, sin) of the unit circle, and
    ``constant_point`` the one for a constant angle; sines and cosines of sums follow exactly.
    """
    known: dict[int, AngleForm] = {}
    arguments = [op.args[0] for op in program.operations if op.op in ("sin", "cos")]
    forms = iter([angle_form(program, argument, known) for argument in arguments])

    def point() -> Circle:
        terms, constant = next(forms)
        total: Circle = constant_point(constant) if constant else (Fraction(1), Fraction(0))
        for name, multiple in terms:
            if isinstance(multiple, Fraction):
                raise ValueError(f"the sine of {multiple} {name} has no exact value")
            c, s = points[name]
            for _ in range(abs(multiple)):
                total = turn(total, (c, s if multiple > 0 else -s))
        return total

    def sign(x: Fraction) -> Fraction:
        return Fraction((x > 0) - (x < 0))

    functions: dict[str, Callable[[Any], Any]] = {
        "sin": lambda _: point()[1],
        "cos": lambda _: point()[0],
        "sign": sign,
        "abs": abs,
    }
    return evaluate(program, inputs, number=lambda x: x, functions=functions)


#: A Mersenne prime: the field in which programs are compared.
PRIME = (1 << 61) - 1


@functools.lru_cache(maxsize=1 << 14)
def _place(numerator: int, denominator: int) -> int:
    """A rational in the field. Remembered: a program is looked at before and after the passes, at several
    points, and an inverse takes as long as dozens of additions."""
    return numerator * pow(denominator, -1, PRIME) % PRIME


def fingerprint(
    program: Program,
    seed: int,
    constant_point: Callable[[Fraction], Circle],
) -> tuple[int, ...]:
    """The outputs at one random point of GF(2^61 - 1), where every rational constant has its place.

    Two programs that are the same rational function (of inputs, sines and cosines) agree at every
    point; two that differ agree with a probability of about degree / 2^61. Exact as ``Fraction``s are,
    and a hundred times faster, so that every pass can be checked on every run. Angles are exponents in
    the circle group, so that sines of sums obey the addition theorems; a sine of anything but
    multiples of inputs, sqrt, exp, pow, tanh, sign and abs are random functions (tanh and sign odd, abs
    even) with their own values at zero. :class:`ZeroDivisionError` where a divisor is zero as a function.
    """

    def random(name: str) -> int:
        digest = hashlib.blake2b(f"{seed} {name}".encode(), digest_size=16).digest()
        return int.from_bytes(digest, "little") % PRIME

    def variable(x: Input) -> int:
        return random(f"{x.array} {x.index}") % (1 << 40)

    def number(x: Fraction) -> int:
        return _place(x.numerator, x.denominator)

    def angle(x: Input, parts: int) -> int:
        return variable(x) if parts == 1 else random(f"{x.array} {x.index} / {parts}") % (1 << 40)

    t = random("circle")
    inverse = pow(1 + t * t, -1, PRIME)
    base = ((1 - t * t) * inverse % PRIME, 2 * t * inverse % PRIME)
    powers: dict[AngleForm, tuple[int, int]] = {}
    forms: dict[int, AngleForm] = {}

    def circle(operand: Operand) -> tuple[int, int]:
        form = angle_form(program, operand, forms)
        if form not in powers:
            terms, constant = form
            exponent = sum(m.numerator * angle(name, m.denominator) for name, m in terms)
            c, s = base if exponent >= 0 else (base[0], -base[1])
            exponent = abs(exponent)
            total = (1, 0)
            if constant:
                cosine, sine = constant_point(constant)
                total = (number(cosine), number(sine))
            while exponent:
                if exponent & 1:
                    total = ((total[0] * c - total[1] * s) % PRIME, (total[1] * c + total[0] * s) % PRIME)
                c, s = (c * c - s * s) % PRIME, 2 * s * c % PRIME
                exponent >>= 1
            powers[form] = total
        return powers[form]

    values: list[int] = []

    def value(operand: Operand) -> int:
        if isinstance(operand, int):
            return values[operand]
        if isinstance(operand, Input):
            return variable(operand)
        return number(operand)

    for op, args, _ in program.operations:
        if op in ("sin", "cos") and is_angle(program, args[0], forms):
            values.append(circle(args[0])[op == "sin"] % PRIME)
            continue
        x = value(args[0])
        if op == "add":
            x = x + value(args[1])
        elif op == "sub":
            x = x - value(args[1])
        elif op == "mul":
            x = x * value(args[1])
        elif op == "div":
            divisor = value(args[1]) % PRIME
            if not divisor:
                raise ZeroDivisionError("division by what is zero at a random point")
            x = x * pow(divisor, -1, PRIME)
        elif op == "neg":
            x = -x
        elif op in ("sqrt", "exp"):
            x = random(f"{op} {x % PRIME}") if x % PRIME else int(op == "exp")
        elif op == "pow":
            x = random(f"pow {x % PRIME} {value(args[1]) % PRIME}") if x % PRIME else 0
        elif op in ("abs", "cos"):
            y = min(x % PRIME, -x % PRIME)
            x = random(f"{op} {y}") if y else int(op == "cos")
        else:
            y = min(x % PRIME, -x % PRIME)
            x = random(f"{op} {y}") * (1 if y == x else -1) if y else 0
        values.append(x % PRIME)
    return tuple(value(operand) % PRIME for operand in program.results())
