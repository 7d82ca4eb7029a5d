"""Rational numbers by signed integers, so that a search hashes and compares them at no cost."""

from __future__ import annotations

from fractions import Fraction

from robodyn.optimize.tally import residue


class Numbers:
    """A table of rationals: ``k`` stands for one, ``-k`` for minus it, 1 for one; zero has no place."""

    def __init__(self) -> None:
        self._values: list[Fraction] = [Fraction(0), Fraction(1)]
        self._place: dict[Fraction, int] = {Fraction(1): 1}
        self._quotients: dict[tuple[int, int], int] = {}
        self._residues: dict[int, int] = {}

    def number(self, value: Fraction | int) -> int:
        """What stands for ``value``, which is not zero."""
        size = abs(Fraction(value))
        k = self._place.get(size)
        if k is None:
            k = self._place[size] = len(self._values)
            self._values.append(size)
        return k if value > 0 else -k

    def value(self, k: int) -> Fraction:
        """What ``k`` stands for."""
        return self._values[k] if k > 0 else -self._values[-k]

    def residue(self, k: int) -> int:
        """The size of what ``k`` stands for, in GF(2^61 - 1); never 0."""
        known = self._residues.get(abs(k))
        if known is None:
            known = self._residues[abs(k)] = residue(self._values[abs(k)])
        return known

    def quotient(self, k: int, l: int) -> int:
        """``k / l``."""
        if l == 1:
            return k
        known = self._quotients.get((k, l))
        if known is None:
            known = self._quotients[k, l] = self.number(self.value(k) / self.value(l))
        return known

    def sum(self, k: int, l: int) -> int:
        """``k + l``; 0 stands for zero."""
        total = self.value(k) + self.value(l)
        return self.number(total) if total else 0
