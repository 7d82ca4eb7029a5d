"""Where an arm is while its program is looked into: exact rationals, points of the circle among them; and
fractions out of their residues."""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction

from robodyn.ir.evaluate import AngleForm, turn
from robodyn.ir.program import Input
from robodyn.robot.values import circle_point


class NoWalk(Exception):
    """The program has nothing that the walk could rewrite, or what it cannot read."""


def fraction(parts: Sequence[int], moduli: Sequence[int]) -> Fraction:
    """The fraction with these residues (P. S. Wang 1981: rational reconstruction by Euclid's algorithm).

    Raises
    ------
    NoWalk: there is none of the size that the moduli allow.
    """
    x, m = 0, 1
    for part, p in zip(parts, moduli, strict=True):
        x += m * ((part - x) * pow(m, -1, p) % p)
        m *= p
    # With 60 bits to spare a wrong fraction is out of the question.
    bound_bits = (m.bit_length() - 60) // 2
    (r0, s0), (r1, s1) = (m, 0), (x, 1)
    while r1.bit_length() > bound_bits:
        quotient = r0 // r1
        (r0, s0), (r1, s1) = (r1, s1), (r0 - quotient * r1, s0 - quotient * s1)
    if not s1 or s1.bit_length() > bound_bits:
        raise NoWalk("a constant is too large to recover")
    return Fraction(r1, s1)


class State:
    """Where the arm is: exact rationals for inputs and points of the circle for joint angles."""

    def __init__(self, chance: random.Random) -> None:
        self.chance = chance
        self.inputs: dict[Input, Fraction] = {}
        self.points: dict[Input, tuple[Fraction, Fraction]] = {}
        self.opaque: dict[tuple[str, object], Fraction] = {}

    def input(self, x: Input) -> Fraction:
        if x not in self.inputs:
            size = self.chance.randint(1 << 37, 3 << 39)
            self.inputs[x] = Fraction(size * self.chance.choice((-1, 1)), 1 << 39)
        return self.inputs[x]

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

    def other(self, op: str, key: object) -> Fraction:
        if (op, key) not in self.opaque:
            self.opaque[op, key] = Fraction(self.chance.randint(-(1 << 39), 1 << 39), 1 << 39)
        return self.opaque[op, key]

    def leaf(self, meaning: tuple[object, ...]) -> Fraction:
        """The value of a leaf: an input, a sine or cosine of an angle, or an opaque operation."""
        kind, what = meaning
        if isinstance(what, Input):
            return self.input(what)
        if kind in ("sin", "cos"):
            return self.angle(what)[kind == "sin"]  # type: ignore[arg-type]  # the form of an angle
        return self.other(str(kind), what)
