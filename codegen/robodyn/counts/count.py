"""Counting a program's operations.

The thesis's convention: every binary ``*`` is one multiplication (by constants, by 2, squares too),
every binary ``+`` or ``-`` one addition. Unary minus and sine/cosine are free and shown apart. A worked
line: ``fc3_x = 4.8*(a3_x - 0.07*lam3_12)`` is two multiplications and one addition.

Budgets are the most operations that a kernel may have, for a CI job to hold.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import asdict, dataclass
from operator import itemgetter

from robodyn.errors import InputError
from robodyn.ir.program import Program


@dataclass(frozen=True, slots=True)
class Count:
    """Operations by kind. ``other`` are absolute values, signs, tanh, exp and pow,
    which friction may need, and the arctangents and choices of inverse kinematics."""

    mul: int = 0
    add: int = 0
    div: int = 0
    sqrt: int = 0
    neg: int = 0
    sincos: int = 0
    other: int = 0

    @property
    def total(self) -> int:
        """``mul + add + div + sqrt``."""
        return self.mul + self.add + self.div + self.sqrt

    def to_dict(self) -> dict[str, int]:
        """The kinds and the total, as ``flops --json`` prints them."""
        return {**asdict(self), "total": self.total}

    def __str__(self) -> str:
        kinds = [
            (self.mul, "multiplication"), (self.add, "addition"), (self.div, "division"),
            (self.sqrt, "square root"),
        ]  # fmt: skip
        text = ", ".join(
            f"{amount} {name}{'' if amount == 1 else 's'}"
            for k, (amount, name) in enumerate(kinds)
            if amount or k < 2
        )
        return f"{text} = {self.total}"


_KIND = {
    "mul": "mul", "add": "add", "sub": "add", "div": "div", "sqrt": "sqrt", "neg": "neg",
    "sin": "sincos", "cos": "sincos", "tanh": "other", "sign": "other", "abs": "other", "exp": "other",
    "pow": "other", "atan2": "other", "select": "other",
}  # fmt: skip


def count(program: Program) -> Count:
    """The operations of ``program``; at most, where it repeats a step."""
    totals: Counter[str] = Counter()
    for repeats, part in repeated(program):
        for op, times in Counter(map(itemgetter(0), part.operations)).items():
            totals[_KIND[op]] += repeats * times
    return Count(**totals)


def repeated(program: Program) -> list[tuple[int, Program]]:
    """The parts of ``program``, each with how often it runs at most."""
    iteration, parts = program.iteration, program.parts()
    if iteration is None:
        return [(1, program)]
    return list(zip((1, iteration.rows * iteration.most, 1), parts, strict=True))


KINDS = ("mul", "add", "div", "sqrt", "neg", "sincos", "other", "total")


@dataclass(frozen=True, slots=True)
class Budget:
    """Upper limits by kind, e.g. ``{"mul": 208, "total": 360}``."""

    limits: tuple[tuple[str, int], ...]

    def exceeded(self, count: Count) -> list[str]:
        """What of ``count`` is over its limit, in words; empty where the budget holds."""
        numbers = count.to_dict()
        return [
            f"{kind} {numbers[kind]} is {numbers[kind] - limit} over the budget of {limit}"
            for kind, limit in self.limits
            if numbers[kind] > limit
        ]


def parse_budget(text: str) -> Budget:
    """A budget from ``mul=208,add=152,total=360``; :class:`InputError` if it is not one."""
    limits: dict[str, int] = {}
    for part in text.split(","):
        kind, separator, digits = (piece.strip() for piece in part.partition("="))
        if (
            not separator
            or kind not in KINDS
            or not (digits.isascii() and digits.isdigit())
            or len(digits) > 9
        ):
            raise InputError(
                "not a budget",
                found=repr(part),
                expected=f"KIND=NUMBER with KIND one of {', '.join(KINDS)}",
                remedy="write it like mul=208,add=152,total=360",
            )
        if kind in limits:
            raise InputError(f"budget for {kind} given twice", found=repr(text), remedy="give each kind once")
        limits[kind] = int(digits)
    return Budget(tuple(limits.items()))
