"""How much a record may lose to rounding: a program can be equal to the recursion and still be useless, as
``tau + (x + 1e20) - x - 1e20`` is.

The bound is the textbook's (N. Higham, Accuracy and Stability of Numerical Algorithms, chapter 3): each value
has a largest magnitude, all terms taken with the same sign, and each operation adds its own rounding to what
its operands bring. It holds wherever the inputs stay within the magnitudes given, not at samples only.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

from robodyn.ir.program import Input, Operand, Program

#: Unit roundoff and half the smallest number of a double: ratios are the same in single precision.
_UNIT, _TINY = 2.0**-53, 5e-324
#: A step of sgn and the like: what an error of their argument may do.
_STEEP = 1e6

#: Magnitudes of positions (of prismatic joints [m]; an angle is at most a turn [rad]), rates and
#: accelerations at which bounds are compared: nearly at rest, slow, fast, and far beyond any arm.
_STATES = ((0.01, 1e-3, 1e-3), (1.0, 1.0, 1.0), (1.0, 30.0, 1e3), (100.0, 1e3, 1e6))
_TURN = 2 * math.pi

#: A record may lose so many times what the recursion loses, and the torque of a small joint a share of what
#: the largest may: the worst of the records that searches find loses a fifth of this.
_FACTOR, _SHARE = 100.0, 0.1


def precise(program: Program, recursion: Program) -> bool:
    """Whether ``program`` loses at most 100 times what ``recursion`` loses to rounding, output by output.

    Where one of the two overflows, the answer is no.
    """
    angles = _angles(program) | _angles(recursion)
    return all(
        _within(_errors(program, angles, state), _errors(recursion, angles, state)) for state in _STATES
    )


def _within(errors: list[float], allowed: list[float]) -> bool:
    least = _SHARE * max(allowed, default=0.0)
    # Written so that NaN and infinity fail.
    return all(e <= _FACTOR * max(a, least) < math.inf for e, a in zip(errors, allowed, strict=True))


def _angles(program: Program) -> set[Input]:
    """Inputs that reach a sine or cosine through sums."""
    reached: set[Input] = set()
    stack: list[Operand] = [op.args[0] for op in program.operations if op.op in ("sin", "cos")]
    seen: set[int] = set()
    while stack:
        operand = stack.pop()
        if isinstance(operand, Input):
            reached.add(operand)
        elif isinstance(operand, int) and operand not in seen:
            seen.add(operand)
            stack.extend(program.operations[operand].args)
    return reached


def _errors(program: Program, angles: set[Input], state: tuple[float, float, float]) -> list[float]:
    """The largest rounding error of each output, in a double."""
    position, rate, acceleration = state
    inputs: Mapping[str, float] = {"q": position, "qd": rate, "qdd": acceleration, "tau": 1.0}
    sizes: list[tuple[float, float]] = []
    constants: dict[Fraction, tuple[float, float]] = {}

    def of(operand: Operand) -> tuple[float, float]:
        if isinstance(operand, int):
            return sizes[operand]
        if isinstance(operand, Input):
            return (_TURN if operand in angles else inputs.get(operand.array, 1.0)), 0.0
        if operand not in constants:
            constants[operand] = _constant(abs(operand))
        return constants[operand]

    for op, args, _ in program.operations:
        x, ex = of(args[0])
        if op == "neg":
            sizes.append((x, ex))
        elif op in ("add", "sub"):
            y, ey = of(args[1])
            sizes.append((x + y, ex + ey + _UNIT * (x + y)))
        elif op == "mul":
            y, ey = of(args[1])
            size = x * y
            sizes.append((size, x * ey + y * ex + ex * ey + _UNIT * size + _TINY))
        elif op == "div":  # by what the recursion divides by as well: as large there
            y, ey = of(args[1])
            sizes.append((x, ex + ey + _UNIT * x))
        elif op in ("sin", "cos"):
            sizes.append((1.0, ex + _UNIT))
        else:
            sizes.append((1.0, _STEEP * ex + _UNIT))
    return [of(operand)[1] for operand in program.results()]


def _constant(size: Fraction) -> tuple[float, float]:
    """A constant as a double, and how far that is from it."""
    try:
        near = float(size)
    except OverflowError:
        return math.inf, math.inf
    return near, float(abs(Fraction(near) - size))
