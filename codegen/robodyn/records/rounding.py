"""How much a record may lose to rounding: a program can be equal to the recursion and still be useless, as
``tau + (x + 1e20) - x - 1e20`` is.

The bound is the textbook's (N. Higham, Accuracy and Stability of Numerical Algorithms, chapter 3): each value
has a largest magnitude, all terms taken with the same sign, and each operation adds its own rounding to what
its operands bring. It holds wherever the inputs stay within the magnitudes given, not at samples only.
"""

from __future__ import annotations

import math
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
#: the largest may: the worst of the records that searches find loses half of this.
_FACTOR, _SHARE = 100.0, 0.1

#: Of each state the largest rounding error of each output.
Bounds = list[list[float]]


def precise(program: Program, allowed: Bounds) -> bool:
    """Whether ``program`` loses at most 100 times ``allowed``, what the recursion loses to rounding, output
    by output. Where one of the two overflows, the answer is no."""
    return all(map(_within, rounding_bounds(program), allowed))


def _within(errors: list[float], allowed: list[float]) -> bool:
    least = _SHARE * max(allowed, default=0.0)
    # Written so that NaN and infinity fail.
    return all(e <= _FACTOR * max(a, least) < math.inf for e, a in zip(errors, allowed, strict=True))


def rounding_bounds(program: Program) -> Bounds:
    """The largest rounding errors of the outputs in a double, at every state that is looked at."""
    leaves: list[Operand] = []
    place: dict[Operand, int] = {}

    def placed(operand: Operand) -> int:
        """Where the operand's size stands: leaves below zero, from the end."""
        if operand.__class__ is int:
            return operand
        if operand not in place:
            leaves.append(operand)
            place[operand] = -len(leaves)
        return place[operand]

    steps = [(op, placed(args[0]), placed(args[-1])) for op, args, _ in program.operations]
    results = [placed(operand) for operand in program.results()]
    angles = _angles(program)
    constants = {k: _constant(abs(x)) for k, x in enumerate(leaves) if isinstance(x, Fraction)}
    bounds = []
    for position, rate, acceleration in _STATES:
        sizes = {"q": position, "qd": rate, "qdd": acceleration}
        here = [constants.get(k, (0.0, 0.0)) for k in range(len(leaves))]
        for k, x in enumerate(leaves):
            if isinstance(x, Input):
                here[k] = (_TURN if x in angles else sizes[x.array] if x.is_of(*sizes) else 1.0), 0.0
        bounds.append(_run(steps, here, results))
    return bounds


def _run(
    steps: list[tuple[str, int, int]], leaves: list[tuple[float, float]], results: list[int]
) -> list[float]:
    """Errors of the results, of the sizes and errors of the leaves."""
    n = len(steps)
    sizes, errors = [0.0] * n, [0.0] * n
    for size, error in reversed(leaves):  # the first leaf stands last
        sizes.append(size)
        errors.append(error)
    for k, (op, i, j) in enumerate(steps):
        x, ex = sizes[i], errors[i]
        if op == "mul":
            y, ey = sizes[j], errors[j]
            size = sizes[k] = x * y
            errors[k] = x * ey + y * ex + ex * ey + _UNIT * size + _TINY
        elif op == "add" or op == "sub":
            size = sizes[k] = x + sizes[j]
            errors[k] = ex + errors[j] + _UNIT * size
        elif op == "neg":
            sizes[k], errors[k] = x, ex
        elif op == "div":  # by what the recursion divides by as well: as large there
            sizes[k], errors[k] = x, ex + errors[j] + _UNIT * x
        elif op == "sin" or op == "cos":
            sizes[k], errors[k] = 1.0, ex + _UNIT
        else:
            sizes[k], errors[k] = 1.0, _STEEP * ex + _UNIT
    return [errors[k] for k in results]


def _angles(program: Program) -> set[Operand]:
    """Inputs that reach a sine or cosine through sums."""
    reached: set[Operand] = set()
    stack: list[Operand] = [op.args[0] for op in program.operations if op.op in ("sin", "cos")]
    while stack:
        operand = stack.pop()
        if operand in reached:
            continue
        reached.add(operand)
        if operand.__class__ is int:
            stack.extend(program.operations[operand].args)
    return reached


def _constant(size: Fraction) -> tuple[float, float]:
    """A constant as a double, and how far that is from it."""
    try:
        near = float(size)
    except OverflowError:
        return math.inf, math.inf
    if not near or not 1e-290 < near < 1e290:
        return near, float(abs(Fraction(near) - size))
    return near, _UNIT * near
