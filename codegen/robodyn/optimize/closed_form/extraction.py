"""Common factors of a system of polynomials, taken out one after another until nothing is saved.

Two kinds of factors are looked for: sums of two terms that stand, up to a common factor, in several places
(or have a factor in common in one), and products of two variables, or of a constant and a variable, that do.
A factor becomes a variable; sums of three terms arise from sums of two. Source of the idea: kernels and cubes
of multi-level logic (Brayton and McMullen 1982; Rajski and Vasudevamurthi 1992), carried to polynomials by
Hosangadi, Fallah and Kastner 2006.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from robodyn.optimize.polynomial import Monomial
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


#: Coefficients by monomials; a coefficient stands in a table (:class:`Numbers`).
Terms = dict[Monomial, int]
#: ``m + ratio n``: two monomials without a common variable; a constant is the second.
Sum = tuple[Monomial, Monomial, int]
#: ``x y``, or ``|k| x`` as ``(-|k|, x)``.
Product = tuple[int, int]
Factor = Sum | Product
#: A pair of terms as a place of a sum: the sum, the common factor, whether the first term stands first in
#: it, operations saved there.
Place = tuple[Sum, Monomial, bool, int]


@dataclass(slots=True)
class System:
    """Variables by their polynomials; those below ``first`` are leaves."""

    first: int
    polynomials: dict[int, Terms]
    outputs: tuple[int, ...]

    def copy(self) -> System:
        """A copy that may be changed."""
        return System(self.first, {v: dict(p) for v, p in self.polynomials.items()}, self.outputs)

    def cost(self) -> int:
        """Operations, each polynomial written out as it stands."""
        return sum(cost_of(p) for p in self.polynomials.values())


def cost_of(terms: Terms) -> int:
    """Operations of a sum of products."""
    return max(0, len(terms) - 1) + sum(term_cost(m, k) for m, k in terms.items())


def term_cost(m: Monomial, k: int) -> int:
    """Multiplications of a product."""
    return len(m) - (k == 1 or k == -1) if m else 0


@dataclass(frozen=True, slots=True)
class Taste:
    """What a search likes beside operations saved: ``noise`` is the spread of chance; ``sums`` and
    ``constants`` are added to the gain of factors that are sums, or a constant and a variable."""

    noise: float = 0.0
    sums: float = 0.0
    constants: float = 0.0


class Memory:
    """What searches over one system share: equal factors are one variable in all of them."""

    def __init__(self, system: System, numbers: Numbers) -> None:
        self.numbers = numbers
        #: How much more a factor is liked than its gain says.
        self.weights: dict[Factor, float] = {}
        #: Operations of each sum that was met.
        self.costs: dict[Sum, int] = {}
        self._names: dict[Factor, int] = {}
        self._places: dict[tuple[Monomial, int, Monomial, int], Place] = {}
        self._products: dict[tuple[Monomial, int], tuple[Product, ...]] = {}
        self._next = max(system.polynomials) + 1

    def name(self, factor: Factor) -> int:
        """The variable that is ``factor``."""
        known = self._names.get(factor)
        if known is None:
            known = self._names[factor] = self._next
            self._next += 1
        return known

    def place(self, m: Monomial, k: int, n: Monomial, l: int) -> Place:
        """The sum that the terms ``k m`` and ``l n`` are, up to a factor."""
        key = (m, k, n, l)
        known = self._places.get(key)
        if known is None:
            known = self._places[key] = place_of(m, k, n, l, self.numbers)
            self.costs[known[0]] = sum_cost(known[0])
        return known

    def products(self, m: Monomial, k: int) -> tuple[Product, ...]:
        """Products of two in the term ``k m``."""
        key = (m, abs(k))
        known = self._products.get(key)
        if known is None:
            known = self._products[key] = products_of(m, k)
        return known


class Extraction:
    """One search over a system, which it changes."""

    def __init__(self, system: System, taste: Taste, chance: random.Random, memory: Memory) -> None:
        self.system, self.taste, self.chance, self.memory = system, taste, chance, memory
        #: Pairs of terms looked at: how long the search took, on any machine.
        self.work = 0
        #: The factors taken, in order.
        self.taken: list[Factor] = []
        self._entries: dict[Factor, int] = {}
        self._own: dict[int, Factor] = {}
        #: Operations saved by each factor, its own taken off while it is no variable yet.
        self._sums: dict[Sum, int] = {}
        self._products: dict[Product, int] = {}
        for v, terms in system.polynomials.items():
            items = list(terms.items())
            terms.clear()
            for m, k in items:
                self._insert(v, m, k)

    def run(self) -> System:
        """The system with every factor taken out that saves something."""
        while True:
            choice = self._choice()
            if choice is None:
                return self.system
            self.taken.append(choice)
            if len(choice) == 2:
                self._take_product(choice)
            else:
                self._take_sum(choice)

    # -- what there is ---------------------------------------------------------------------------
    def _choice(self) -> Factor | None:
        """The factor that is liked best among those that save something."""
        chance, weights, noise = self.chance.random, self.memory.weights, self.taste.noise
        best: Factor | None = None
        top = -1e9
        self.work += (len(self._sums) + len(self._products)) // 8
        extra = self.taste.sums
        for pair, gain in [item for item in self._sums.items() if item[1] > 0]:
            liking = gain + noise * chance() + extra + weights.get(pair, 0.0)
            if liking > top:
                best, top = pair, liking
        extra = self.taste.constants
        for product, gain in [item for item in self._products.items() if item[1] > 0]:
            liking = gain + noise * chance() + weights.get(product, 0.0)
            if product[0] < 0:
                liking += extra
            if liking > top:
                best, top = product, liking
        return best

    def _insert(self, v: int, m: Monomial, k: int) -> None:
        """Add ``k m`` to the polynomial of ``v``."""
        terms = self.system.polynomials[v]
        if m in terms:
            k = self.memory.numbers.sum(terms[m], k)
            self._remove(v, m)
            if not k:
                return
        self._count(v, m, k, 1)
        terms[m] = k

    def _remove(self, v: int, m: Monomial) -> int:
        """Take the term with ``m`` out of the polynomial of ``v``; its coefficient."""
        k = self.system.polynomials[v].pop(m)
        self._count(v, m, k, -1)
        return k

    def _count(self, v: int, m: Monomial, k: int, sense: int) -> None:
        """Count the factors that the term ``k m`` makes with the others of the polynomial of ``v``."""
        sums, products, entries, own = self._sums, self._products, self._entries, self._own.get(v)
        memory = self.memory
        place = memory.place
        self.work += len(self.system.polynomials[v]) + 3
        for n, l in self.system.polynomials[v].items():
            pair, _, _, gain = place(m, k, n, l) if m < n else place(n, l, m, k)
            if pair != own:
                known = sums.get(pair)
                if known is None:
                    known = 0 if pair in entries else -memory.costs[pair]
                sums[pair] = known + sense * gain
        for product in memory.products(m, k):
            if product != own:
                sofar = products.get(product)
                if sofar is None:
                    sofar = 0 if product in entries else -1
                products[product] = sofar + sense

    # -- taking out ------------------------------------------------------------------------------
    def _define(self, factor: Factor, terms: Terms) -> int:
        """A variable that is ``factor``."""
        d = self._entries[factor] = self.memory.name(factor)
        self._own[d] = factor
        self.system.polynomials[d] = {}
        for m, k in terms.items():
            self._insert(d, m, k)
        return d

    def _take_sum(self, pair: Sum) -> None:
        d = self._entries.get(pair)
        if d is None:
            m, n, ratio = pair
            d = self._define(pair, {m: 1, n: ratio})
            self._sums[pair] += self.memory.costs[pair]
        for v, terms in self.system.polynomials.items():
            if v == d or len(terms) < 2:
                continue
            for m, n, common, k in list(self._places(pair, terms)):
                if m in terms and n in terms:
                    self._remove(v, m)
                    self._remove(v, n)
                    self._insert(v, tuple(sorted((*common, d))), k)

    def _places(self, pair: Sum, terms: Terms) -> Iterator[tuple[Monomial, Monomial, Monomial, int]]:
        """Where ``pair`` stands in ``terms``: two monomials, their common factor, the coefficient."""
        items = list(terms.items())
        place = self.memory.place
        self.work += len(items) * len(items) // 4
        for i, (m, k) in enumerate(items):
            for n, l in items[:i]:
                places, common, ordered, _ = place(m, k, n, l) if m < n else place(n, l, m, k)
                if places == pair:
                    yield m, n, common, k if ordered == (m < n) else l

    def _take_product(self, product: Product) -> None:
        x, y = product
        d = self._entries.get(product)
        if d is None:
            d = self._define(product, {(y,): -x} if x < 0 else {product: 1})
            self._products[product] += 1
        for v, terms in self.system.polynomials.items():
            if v == d:
                continue
            for m in [m for m, k in terms.items() if product in self.memory.products(m, k)]:
                k = self._remove(v, m)
                rest = list(m)
                rest.remove(y)
                if x < 0:
                    k = 1 if k > 0 else -1
                else:
                    rest.remove(x)
                self._insert(v, tuple(sorted((*rest, d))), k)


def sum_cost(pair: Sum) -> int:
    """Operations of ``m + ratio n``."""
    m, n, ratio = pair
    return len(m) + term_cost(n, ratio)


def place_of(m: Monomial, k: int, n: Monomial, l: int, numbers: Numbers) -> Place:
    """The sum that the terms ``k m`` and ``l n`` are, up to a factor; a constant stands last in it."""
    rest = list(n)
    base = []
    own = []
    for v in m:
        if v in rest:
            rest.remove(v)
            base.append(v)
        else:
            own.append(v)
    a, b = tuple(own), tuple(rest)
    common = tuple(base)
    ordered = bool(a) and (not b or a < b)
    pair = (a, b, numbers.quotient(l, k)) if ordered else (b, a, numbers.quotient(k, l))
    saved = term_cost(m, k) + term_cost(n, l) + 1 - term_cost((*common, 0), k if ordered else l)
    return pair, common, ordered, saved


def products_of(m: Monomial, k: int) -> tuple[Product, ...]:
    """Products of two in the term ``k m``."""
    products: dict[Product, None] = dict.fromkeys((m[i], m[j]) for j in range(len(m)) for i in range(j))
    if k != 1 and k != -1:
        products.update(dict.fromkeys((-abs(k), v) for v in m))
    return tuple(products)
