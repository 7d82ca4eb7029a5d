"""Where an arm is while its program is looked into: exact rationals, points of the circle among them."""

from __future__ import annotations

import random
from fractions import Fraction

from robodyn.ir.evaluate import AngleForm, turn
from robodyn.ir.program import Input
from robodyn.robot.values import circle_point


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
