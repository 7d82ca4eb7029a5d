"""A program as the walk sees it: leaves, and operations over them, every value known by its residues.

A *leaf* is whatever the algebra does not look into: an input, a sine or cosine of joint angles, the sign
of a velocity. Operations with a constant become ``scale`` (one multiplication) and ``offset`` (one
addition), whose constants are quotients and differences of values and need not be stored.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal, localcontext
from fractions import Fraction

from robodyn.ir.evaluate import AngleForm, angle_form, turn
from robodyn.ir.program import Input, Operand, Program
from robodyn.robot.values import circle_point
from robodyn.search.modular import fraction_of_residues

#: Operations of the walk, as the C code numbers them.
LEAF, ADD, MUL, SCALE, OFFSET = range(5)
#: Points at which values are known modulo the first prime, and modulo each of the others.
POINTS, FURTHER = 3, 2
#: The primes are 2^61 less these.
BELOW = (
    1, 31, 45, 229, 259, 283, 339, 391, 403, 465, 531, 579, 675, 759, 799, 819, 829, 843, 859, 939, 985,
    1015, 1153, 1195, 1215, 1281, 1299, 1351, 1371, 1425, 1489, 1525, 1533, 1543, 1609, 1621, 1669, 1741,
    1753, 1813, 1845, 1849, 1855, 1863, 1869, 1909, 1921, 1923,
)  # fmt: skip
STATES = 12

#: Digits of the truth: what a pair of doubles holds, and some to spare.
_DIGITS = 45

_OPAQUE = frozenset(("sin", "cos", "sqrt", "tanh", "sign", "div"))


class NoWalk(Exception):
    """The program has nothing that the walk could rewrite, or what it cannot read."""


def fraction(parts: Sequence[int], moduli: Sequence[int]) -> Fraction:
    """The fraction with these residues; :class:`NoWalk` where there is none of the size that they allow."""
    value = fraction_of_residues(parts, moduli)
    if value is None:
        raise NoWalk("a constant is too large to recover")
    return value


class State:
    """Where the arm is: exact rationals for inputs and points of the circle for joint angles."""

    def __init__(self, chance: random.Random) -> None:
        self.chance = chance
        self.numbers: dict[tuple[object, ...], Fraction] = {}
        self.points: dict[Input, tuple[Fraction, Fraction]] = {}

    def angle(self, form: AngleForm) -> tuple[Fraction, Fraction]:
        terms, constant = form
        total = circle_point(constant) if constant else (Fraction(1), Fraction(0))
        for x, multiple in terms:
            if isinstance(multiple, Fraction):
                raise ValueError(f"the sine of {multiple} {x} has no exact value")
            if x not in self.points:
                t = Fraction(self.chance.randint(-(3 << 37), 3 << 37), 1 << 37)
                self.points[x] = ((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t))
            c, s = self.points[x]
            for _ in range(abs(multiple)):
                total = turn(total, (c, s if multiple > 0 else -s))
        return total

    def leaf(self, meaning: tuple[object, ...]) -> Fraction:
        """The value of a leaf: an input, a sine or cosine of an angle, or an opaque operation."""
        kind, what = meaning
        if kind in ("sin", "cos"):
            return self.angle(what)[kind == "sin"]  # type: ignore[arg-type]  # the form of an angle
        if meaning not in self.numbers:
            chance = self.chance
            if kind == "input":
                size = chance.randint(1 << 37, 3 << 39) * chance.choice((-1, 1))
            else:
                size = chance.randint(-(1 << 39), 1 << 39)
            self.numbers[meaning] = Fraction(size, 1 << 39)
        return self.numbers[meaning]


@dataclass(frozen=True, slots=True)
class Row:
    """``+-(a + sign b)``, ``+-(a b)``, ``k a`` or ``sign a + c``; operands are rows."""

    op: int
    a: int = 0
    b: int = 0
    sign: int = 1


@dataclass(frozen=True, slots=True)
class Network:
    """Rows, leaves first, and what is known of them.

    ``residues`` [rows, POINTS + FURTHER (primes - 1)], ``truth`` [rows, STATES] as pairs of doubles whose sum
    is right to 30 digits; ``outputs``: for each element of the results a row and a sign, or a constant.
    """

    program: Program
    leaves: tuple[Operand, ...]
    rows: tuple[Row, ...]
    residues: tuple[tuple[int, ...], ...]
    truth: tuple[tuple[tuple[float, float], ...], ...]
    outputs: tuple[tuple[int, int] | Fraction, ...]
    primes: int

    @property
    def targets(self) -> list[int]:
        """The rows that outputs need, each once, leaves left out."""
        targets = dict.fromkeys(out[0] for out in self.outputs if not isinstance(out, Fraction))
        return [row for row in targets if row >= len(self.leaves)]


Part = tuple[int, int] | Fraction
"""A row and a sign, or a constant."""


def network(programs: Sequence[Program], *, seed: int = 1) -> Network:
    """``programs``, all of which compute the same, as one network; the rows of the first come first.

    Only what the first needs is alive at the start; its outputs are the network's.
    """
    building = _Building(programs[0], _primes_for(programs), seed)
    with localcontext() as context:
        context.prec = _DIGITS
        outputs, *_ = [building.replay(program) for program in programs]
    return Network(
        programs[0],
        tuple(building.leaf_operands),
        tuple(building.rows),
        tuple(building.residues),
        tuple(tuple(_split(x) for x in row) for row in building.truth),
        tuple(outputs),
        building.primes,
    )


class _Building:
    """A network on its way: rows, what is known of them, and which value is which row."""

    def __init__(self, first: Program, primes: int, seed: int) -> None:
        self.primes = primes
        width = POINTS + FURTHER * (primes - 1)
        self.moduli = [
            (1 << 61) - BELOW[0 if r < POINTS else 1 + (r - POINTS) // FURTHER] for r in range(width)
        ]
        self.point = [r if r < POINTS else (r - POINTS) % FURTHER for r in range(width)]
        chance = random.Random(f"network {seed}")
        self.states = [State(chance) for _ in range(STATES)]
        self.leaves: dict[tuple[object, ...], tuple[int, int]] = {}
        self.leaf_operands: list[Operand] = []
        self.rows: list[Row] = []
        self.residues: list[tuple[int, ...]] = []
        self.truth: list[list[Decimal]] = []
        self.known: dict[int, int] = {}
        with localcontext() as context:
            context.prec = _DIGITS
            forms: dict[int, AngleForm] = {}
            for operand in _algebra(first):
                self._leaf(_meaning(first, operand, forms), operand)

    def _leaf(self, meaning: tuple[object, ...], operand: Operand) -> None:
        if meaning in self.leaves:
            return
        values = [state.leaf(meaning) for state in self.states]
        residues = tuple(_modulo(values[k], p) for k, p in zip(self.point, self.moduli, strict=True))
        self.leaves[meaning] = self._row(Row(LEAF), residues, [_decimal(x) for x in values])
        if len(self.rows) > len(self.leaf_operands):  # else it is a known one or minus that, as sin(-q) is
            self.leaf_operands.append(operand)

    def _row(self, row: Row, residues: tuple[int, ...], truth: list[Decimal]) -> tuple[int, int]:
        """The row of a value, a new one where no row has it."""
        key = min(residues[0], self.moduli[0] - residues[0])
        at = self.known.get(key)
        if at is None:
            self.known[key] = at = len(self.rows)
            self.rows.append(row)
            self.residues.append(residues)
            self.truth.append(truth)
        return at, 1 if self.residues[at][0] == residues[0] else -1

    def replay(self, program: Program) -> list[Part]:
        """The rows of ``program``; those of its outputs."""
        forms: dict[int, AngleForm] = {}
        places: dict[int, Part] = {}

        def value(operand: Operand) -> Part:
            if isinstance(operand, Fraction):
                return operand
            if isinstance(operand, Input):
                return self.leaves[_meaning(program, operand, forms)]
            return places[operand]

        for i, (op, args, _) in enumerate(program.operations):
            if op in _OPAQUE:
                meaning = _meaning(program, i, forms)
                if meaning in self.leaves:
                    places[i] = self.leaves[meaning]
                continue
            try:
                operands = [value(arg) for arg in args]
            except KeyError:  # only angles need it
                continue
            if op == "neg":
                places[i] = self._product(operands[0], Fraction(-1))
            elif op == "mul":
                places[i] = self._product(*operands)
            else:
                first, second = operands
                places[i] = self._sum(first, second if op == "add" else self._product(second, Fraction(-1)))
        return [value(operand) for operand in program.results()]

    def _product(self, x: Part, y: Part) -> Part:
        if isinstance(x, Fraction):
            if isinstance(y, Fraction):
                return x * y
            x, y = y, x
        i, s = x
        if isinstance(y, Fraction):
            if y in (0, 1, -1):
                return (i, s * int(y)) if y else Fraction(0)
            own = zip(self.residues[i], self.moduli, strict=True)
            residues = tuple(s * u * _modulo(y, p) % p for u, p in own)
            return self._row(Row(SCALE, i), residues, [s * u * _decimal(y) for u in self.truth[i]])
        j, t = y
        both = zip(self.residues[i], self.residues[j], self.moduli, strict=True)
        residues = tuple(u * v % p for u, v, p in both)
        truth = [u * v for u, v in zip(self.truth[i], self.truth[j], strict=True)]
        at, sign = self._row(Row(MUL, i, j), residues, truth)
        return at, sign * s * t

    def _sum(self, x: Part, y: Part) -> Part:
        if isinstance(x, Fraction):
            if isinstance(y, Fraction):
                return x + y
            x, y = y, x
        i, s = x
        if isinstance(y, Fraction):
            if not y:
                return x
            own = zip(self.residues[i], self.moduli, strict=True)
            residues = tuple((s * u + _modulo(y, p)) % p for u, p in own)
            return self._row(Row(OFFSET, i, 0, s), residues, [s * u + _decimal(y) for u in self.truth[i]])
        j, t = y
        both = zip(self.residues[i], self.residues[j], self.moduli, strict=True)
        residues = tuple((s * u + t * v) % p for u, v, p in both)
        if not residues[0]:
            return Fraction(0)
        if residues[0] == residues[1] == residues[2]:  # the same at every point, as sin^2 + cos^2 is
            return fraction([residues[0], *residues[POINTS::FURTHER]], [*dict.fromkeys(self.moduli)])
        truth = [s * u + t * v for u, v in zip(self.truth[i], self.truth[j], strict=True)]
        return self._row(Row(ADD, i, j, s * t), residues, truth)


def _meaning(program: Program, operand: Operand, forms: dict[int, AngleForm]) -> tuple[object, ...]:
    """What a leaf is, in whichever program: an input, a sine of some angle, an opaque operation."""
    if isinstance(operand, Input):
        return ("input", operand)
    assert isinstance(operand, int)
    op, args, _ = program.operations[operand]
    if op in ("sin", "cos"):
        return (op, angle_form(program, args[0], forms))
    return (op, args)


def _modulo(x: Fraction, p: int) -> int:
    return x.numerator * pow(x.denominator, -1, p) % p


def _decimal(x: Fraction) -> Decimal:
    return Decimal(x.numerator) / Decimal(x.denominator)


def _primes_for(programs: Sequence[Program]) -> int:
    """How many primes recover constants that are products of a few of the programs' own."""
    numbers = {
        x for program in programs for op in program.operations for x in op.args if isinstance(x, Fraction)
    }
    bits = max((x.numerator.bit_length() + x.denominator.bit_length() for x in numbers), default=1)
    return min(max(16, (10 * bits + 600) // 61), len(BELOW))


def _split(x: Decimal) -> tuple[float, float]:
    high = float(x)
    return high, float(x - Decimal(high))


def _algebra(program: Program) -> list[Operand]:
    """The leaves: inputs and opaque operations that additions and multiplications of the outputs read."""
    operands: dict[Operand, None] = {}
    stack: list[Operand] = [operand for operand in program.results() if not isinstance(operand, Fraction)]
    seen: set[int] = set()
    while stack:
        operand = stack.pop()
        if isinstance(operand, Input):
            operands[operand] = None
        elif isinstance(operand, int) and operand not in seen:
            seen.add(operand)
            op, args, _ = program.operations[operand]
            if op in _OPAQUE:
                operands[operand] = None
            else:
                stack.extend(arg for arg in args if not isinstance(arg, Fraction))

    def rank(operand: Operand) -> tuple[int, object]:
        return (1, operand) if isinstance(operand, int) else (0, str(operand))

    return sorted(operands, key=rank)
