"""Units of a system's variables, chosen so that constants become 1.

Each variable may be computed as a multiple of itself. A term whose constant is then +-1 costs one
multiplication less; a scaled leaf or output costs one more. Which terms may have constant 1 together is a
system of equations, linear in logarithms; the largest part of it that agrees with itself is looked for by
exchange: one more equation is granted first, and of the others what then still can be.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.optimize.closed_form.extraction import Numbers, System
from robodyn.optimize.tally import PRIME

#: Exponents of scales.
Powers = dict[int, int]


@dataclass(frozen=True, slots=True)
class Wish:
    """``constant * product of scale[v] ** exponent = +-1``: what a term, a leaf or an output would like.
    ``residue`` is the constant in GF(2^61 - 1), where the search takes place."""

    powers: Powers
    constant: Fraction
    residue: int


def wishes_of(system: System, numbers: Numbers) -> list[Wish]:
    """All wishes; each one granted saves a multiplication."""
    wishes = []
    read: set[int] = set()
    for u, terms in system.polynomials.items():
        for m, k in terms.items():
            read.update(m)
            if m:
                powers: Powers = {u: 1}
                for v in m:
                    powers[v] = powers.get(v, 0) - 1
                wishes.append(Wish(powers, numbers.value(k), numbers.residue(k)))
    ends = [v for v in sorted(read) if v < system.first] + list(dict.fromkeys(system.outputs))
    wishes.extend(Wish({v: 1}, Fraction(1), 1) for v in ends)
    return wishes


class Scales:
    """Scales as products of powers of free ones, with rational constants or (``exact=False``) residues.
    Signs make no difference and are dropped."""

    def __init__(self, *, exact: bool) -> None:
        self.exact = exact
        self.solved: dict[int, tuple[Powers, Any]] = {}

    def grant(self, wish: Wish) -> bool:
        """Make ``wish`` come true if that can be; whether it does."""
        powers, constant = self._reduced(wish)
        if not powers:
            return bool(constant == 1)
        if constant == 1:  # a root of 1 is 1
            common = math.gcd(*powers.values())
            powers = {v: e // common for v, e in powers.items()}
        pivot = next((v for v, e in powers.items() if e in (1, -1)), None)
        if pivot is None:
            return False
        e = powers.pop(pivot)
        own = {v: -e * f for v, f in powers.items()}
        value = self._power(constant, -e)
        for v, (there, factor) in self.solved.items():
            f = there.pop(pivot, 0)
            if f:
                for w, g in own.items():
                    there[w] = there.get(w, 0) + f * g
                    if not there[w]:
                        del there[w]
                self.solved[v] = (there, self._times(factor, self._power(value, f)))
        self.solved[pivot] = (own, value)
        return True

    def _reduced(self, wish: Wish) -> tuple[Powers, Any]:
        """``wish`` in free scales."""
        total: Powers = {}
        constant: Any = abs(wish.constant) if self.exact else min(wish.residue, PRIME - wish.residue)
        for v, e in wish.powers.items():
            known = self.solved.get(v)
            if known is None:
                total[v] = total.get(v, 0) + e
                continue
            for w, f in known[0].items():
                total[w] = total.get(w, 0) + e * f
            if known[1] != 1:
                constant = self._times(constant, self._power(known[1], e))
        return {v: e for v, e in total.items() if e}, constant

    def _times(self, x: Any, y: Any) -> Any:
        if self.exact:
            return x * y
        z = x * y % PRIME
        return min(z, PRIME - z)

    def _power(self, x: Any, e: int) -> Any:
        if x == 1:
            return x
        return x**e if self.exact else pow(x, e, PRIME)


def granted(wishes: Iterable[Wish]) -> list[Wish]:
    """Those of ``wishes`` that come true if each in turn is granted if it can be."""
    scales = Scales(exact=False)
    return [wish for wish in wishes if scales.grant(wish)]


@dataclass(slots=True)
class Scaling:
    """A search for the scales of one system; it may go on later."""

    system: System
    wishes: list[Wish]
    best: list[Wish]
    unscaled: int

    @classmethod
    def of(cls, system: System, numbers: Numbers) -> Scaling:
        """The start: every constant that is 1 stays 1."""
        wishes = wishes_of(system, numbers)
        true = [wish for wish in wishes if abs(wish.constant) == 1]
        rest = [wish for wish in wishes if abs(wish.constant) != 1]
        products = system.cost() - len(rest)
        return cls(system, wishes, granted(true + rest), products)

    @property
    def cost(self) -> int:
        """Operations of the system so scaled."""
        return self.unscaled + len(self.wishes) - len(self.best)

    @property
    def work(self) -> int:
        """What one exchange takes."""
        return 12 * len(self.wishes) + len(self.wishes) ** 2 // 12

    def improve(self, chance: random.Random, rounds: int) -> None:
        """Try ``rounds`` exchanges."""
        for _ in range(rounds):
            taken = set(map(id, self.best))
            true = list(self.best)
            rest = [wish for wish in self.wishes if id(wish) not in taken]
            if not rest:
                return
            chance.shuffle(true)
            chance.shuffle(rest)
            first = 1 if chance.random() < 0.8 else 2
            scaled = granted(rest[:first] + true + rest[first:])
            if len(scaled) >= len(self.best):
                self.best = scaled

    def scales(self) -> dict[int, Fraction]:
        """The scale of each variable that has one."""
        scales = Scales(exact=True)
        for wish in self.best:
            scales.grant(wish)
        return {v: constant for v, (_, constant) in scales.solved.items() if constant != 1}
