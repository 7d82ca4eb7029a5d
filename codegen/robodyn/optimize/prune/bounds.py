"""The largest error of a pruned program, proven: both programs expanded, their difference bounded."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from robodyn.errors import InputError
from robodyn.ir.graph import Graph, Node, Scalar
from robodyn.ir.key import children
from robodyn.ir.program import Input, Program
from robodyn.optimize.polynomial import BITS, MOST, Bounded, constant
from robodyn.optimize.prune.box import Box
from robodyn.optimize.prune.supremum import Terms, proven, waves_of
from robodyn.robot.values import circle_point

#: Rounding of the terms while squares are split, as a share of all of them.
_LOST = 2.0**-46


#: Numbers computed for one bound at most, by the number of angles looked at together.
_WORK = {2: 20_000_000, 3: 60_000_000}


#: Terms that are kept for the next time (some 100 bytes each), and terms of one value at most.
_REMEMBERED, _MOST_TERMS = 3_000_000, 30_000


class Expansions:
    """The values of a graph as polynomials on a box, each expanded once.

    ``sign`` and ``tanh`` are variables of their own within [-1, 1], whatever they are taken of.
    """

    def __init__(self, graph: Graph, box: Box) -> None:
        self.graph, self.box = graph, box
        self._field: dict[Any, int] = {x: BITS * i for i, x in enumerate(box.inputs)}
        self._polynomials: dict[int, Bounded] = {}
        self._first = len(graph.keys)
        self._terms = 0

    def of(self, value: Scalar) -> Bounded:
        """``value`` expanded."""
        if not isinstance(value, Node):
            return constant(Fraction(value))
        expansion = self.at(value.position)
        return expansion if value.sign > 0 else expansion.scaled(Fraction(-1))

    def at(self, root: int) -> Bounded:
        """The value at position ``root`` expanded."""
        if self._terms > _REMEMBERED:
            self._forget()
        cache, keys = self._polynomials, self.graph.keys
        stack = [root]
        while stack:
            p = stack[-1]
            if p in cache:
                stack.pop()
                continue
            key = keys[p]
            read = () if key[0] in ("sin", "cos", "sign", "tanh") else children(key)
            missing = [child for child in read if child not in cache]
            if missing:
                stack.extend(missing)
            else:
                cache[p] = self._operation(p, key)
                self._terms += len(cache[p].terms)
                if len(cache[p].terms) > _MOST_TERMS:
                    raise InputError(
                        "the arm has too many parameters for a proof of what pruning does to it",
                        found=f"more than {_MOST_TERMS} terms in one of its torques",
                        remedy="leave out --prune",
                    )
                stack.pop()
        return cache[root]

    def _forget(self) -> None:
        """Forget what was expanded of the positions that came after the first."""
        self._polynomials = {p: value for p, value in self._polynomials.items() if p < self._first}
        self._terms = sum(len(value.terms) for value in self._polynomials.values())

    def difference(self, one: Scalar, other: Scalar) -> Bounded:
        """``one - other``."""
        if one == other:
            return constant(Fraction(0))
        return self.of(one).plus(self.of(other), -1)

    def waves(self, error: Bounded) -> tuple[Terms, float]:
        """``error`` as waves of the angles, by (k, monomial of the other inputs), and what bounds the rest.

        Of squares half is a wave and the other half stays: x^2 is 1/2 give or take 1/2.
        """
        angles = len(self.box.angles)
        mask = (1 << BITS) - 1
        offset = sum((MOST + 1) << field for field in self._field.values())
        shifts = [self._field[x] for x in self.box.angles]
        squares = [self._field[x] for x in self.box.ranges]
        terms: Terms = {}
        for key, c in error.terms.items():
            digits = key + offset
            k = tuple([((digits >> shift) & mask) - MOST - 1 for shift in shifts])
            for shift in squares:
                if (digits >> shift) & mask == MOST + 3:  # the exponent is 2
                    c = c / 2
                    place = k, digits >> angles * BITS
                    terms[place] = terms.get(place, 0) + c
                    digits -= 2 << shift
                    break
            place = k, digits >> angles * BITS
            terms[place] = terms.get(place, 0) + c
        return terms, error.rest + _LOST * error.size

    def bound(
        self, error: Bounded, threshold: float, *, close: float = 1.01, hopeless: float = math.inf
    ) -> float:
        """A bound of ``error`` on the whole box, ``close`` times what it need be.

        Where two angles looked at together do not bring it down to ``threshold``, three are, unless
        it is above ``hopeless``.
        """
        best = error.bound
        terms, rest = self.waves(error)
        for angles, work in _WORK.items():
            waves = waves_of(terms, angles)
            target = threshold - rest if angles > 2 else 0.0
            best = min(best, proven(waves, target, work, close) + rest)
            if best <= threshold or best > hopeless or len(waves.degree) < angles:
                break
        return best

    def share(self, error: Bounded, budget: float) -> float:
        """A bound of ``error`` as a share of ``budget``, for a search: close where it is near 1."""
        best = error.bound
        if best > 0.3 * budget:
            best = min(best, self.bound(error, budget, close=1.05, hopeless=1.35 * budget))
        return best / budget

    def _operation(self, p: int, key: tuple[Any, ...]) -> Bounded:
        cache, op = self._polynomials, key[0]
        if op == "input":
            return self._input(key[1])
        if op == "const":
            return constant(key[1])
        if op == "add":
            return cache[key[1]].plus(cache[key[3]], key[2])
        if op == "scale":
            return cache[key[2]].scaled(key[1])
        if op == "mul":
            return cache[key[1]].times(cache[key[2]])
        if op in ("sin", "cos"):
            return self._circle(op, key[1])
        if op in ("sign", "tanh"):
            field = self._field.setdefault(p, BITS * len(self._field))
            return Bounded({1 << field: 1 + 0j}, 0.0, 1)
        raise InputError(
            "a program with divisions or roots cannot be pruned",
            found=op,
            remedy="choose another formulation",
        )

    def _input(self, x: Input) -> Bounded:
        low, high = self.box.ranges[x]
        middle = float((low + high) / 2)
        half = math.nextafter(float(max(high - Fraction(middle), Fraction(middle) - low)), math.inf)
        terms = {1 << self._field[x]: complex(half)}
        if middle:
            terms[0] = complex(middle)
        return Bounded(terms, 0.0, 1)

    def _circle(self, op: str, argument: int) -> Bounded:
        turns, offset = self._angle(argument)
        degree = max(map(abs, turns.values()), default=0)
        if degree > MOST:
            raise OverflowError("an angle of more turns than a key can tell apart")
        key = sum(m * (1 << self._field[x]) for x, m in turns.items())
        cosine = Bounded({key: 0.5 + 0j, -key: 0.5 + 0j} if key else {0: 1 + 0j}, 0.0, degree)
        sine = Bounded({key: -0.5j, -key: 0.5j} if key else {}, 0.0, degree)
        if not offset:
            return cosine if op == "cos" else sine
        c, s = circle_point(offset)
        if op == "cos":
            return cosine.scaled(c).plus(sine.scaled(s), -1)
        return sine.scaled(c).plus(cosine.scaled(s))

    def _angle(self, p: int) -> tuple[dict[Input, int], Fraction]:
        """The angle at ``p`` as whole multiples of joint angles plus a constant [rad]."""
        key = self.graph.keys[p]
        if key[0] == "input" and key[1] in self.box.angles:
            return {key[1]: 1}, Fraction(0)
        if key[0] == "const":
            return {}, key[1]
        if key[0] == "scale" and key[1].denominator == 1:
            turns, offset = self._angle(key[2])
            return {x: m * key[1].numerator for x, m in turns.items()}, key[1] * offset
        if key[0] == "add":
            turns, offset = self._angle(key[1])
            more, further = self._angle(key[3])
            total = dict(turns)
            for x, m in more.items():
                total[x] = total.get(x, 0) + key[2] * m
            return {x: m for x, m in total.items() if m}, offset + key[2] * further
        raise InputError("a sine of something that is no angle cannot be pruned", found=key[0])


def proven_errors(original: Program, pruned: Program, box: Box, threshold: Sequence[float]) -> list[float]:
    """For each output a bound of ``|pruned - original|`` over the whole ``box``, in exact arithmetic.

    Nothing is known here of how ``pruned`` came about. More effort goes into bounds above ``threshold``.
    """
    graph = Graph()
    true: Sequence[Scalar] = graph.replay(original)
    copies: Sequence[Scalar] = graph.replay(pruned)
    expansions = Expansions(graph, box)
    return [
        0.0 if one == other else expansions.bound(expansions.difference(one, other), limit)
        for one, other, limit in zip(copies, true, threshold, strict=True)
    ]
