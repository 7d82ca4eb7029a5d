"""Sums in units that save multiplications: what is saved, what is left, and what it does to rounding."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, reject, settings

from ir.programs import EXACT, Point, programs, results
from passes.programs import REAL
from robodyn import load
from robodyn.counts import count
from robodyn.ir import Graph, Program
from robodyn.ir.lowering import lower
from robodyn.optimize.programs import Choice, build
from robodyn.optimize.records.rounding import Rounding
from robodyn.passes import factor, fold, units
from robodyn.passes.unit_descent import Descent, Multiple, allowed

#: The prime that factors are compared by, and what no unit may be.
PRIME = (1 << 61) - 1
HUGE = 10**9


def expression(build_: Callable[..., list[Any]]) -> Program:
    """The program of what ``build_`` makes of a cosine and a sine, and of x, y, z and w."""
    graph = Graph()
    angle = graph.input("angle")
    inputs = [graph.input(name) for name in "xyzw"]
    return lower(graph, [("t", build_(graph.cos(angle), graph.sin(angle), *inputs))])


SAVING: dict[str, tuple[Callable[..., list[Any]], int, int]] = {
    "two sums": (lambda c, s, x, y, z, w: [c * (2 * x + 3 * y) + s * (2 * z + 7 * w)], 9, 8),
    "a chain": (lambda c, s, x, y, z, w: [5 * (c * (2 * x + 3 * y) + 7 * z)], 7, 6),
    "a product's factor": (lambda c, s, x, y, z, w: [2 * x * (3 * y + z), 2 * x * (3 * y + w)], 6, 6),
    "through a product": (lambda c, s, x, y, z, w: [x * (2 * y) + 2 * z], 4, 3),
    "through a quotient": (lambda c, s, x, y, z, w: [(2 * x) / (z + w) + 2 * y], 5, 4),
    "the same but for a factor": (lambda c, s, x, y, z, w: [x + 2 * y, c * (3 * x + 6 * y)], 6, 4),
    "with the other sign": (lambda c, s, x, y, z, w: [c * (2 * x - 3 * y) - s * (2 * z - 3 * w)], 9, 8),
    "beside constants": (lambda c, s, x, y, z, w: [c * (2 * x + 3) + s * (2 * y + 5)], 7, 6),
    "nothing": (lambda c, s, x, y, z, w: [c * x + s * y, 2 * z + 3 * w], 6, 6),
    "what is given away is needed": (lambda c, s, x, y, z, w: [x * (2 * y) + 2 * z, 2 * y], 4, 4),
}  # fmt: skip


@pytest.mark.parametrize("pattern", SAVING)
def test_constants_disappear_into_units(pattern: str) -> None:
    build_, before, least = SAVING[pattern]
    made = expression(build_)
    after = units(made)
    assert (count(made).total, count(after).total) == (before, least)
    assert (after is made) == (before == least)
    assert results(after, Point(1)) == results(made, Point(1))


@settings(deadline=None, max_examples=40)
@given(programs(EXACT))
def test_units_never_cost(made: Program) -> None:
    try:
        before, after = count(fold(made)).total, units(made)
    except ZeroDivisionError:
        reject()
    assert count(after).total <= before or count(after).total <= count(made).total
    assert count(units(after)).total == count(after).total


def test_real_programs_gain_beyond_factoring() -> None:
    gains = [count(factor(made)).total - count(units(factor(made))).total for made in REAL[::3]]
    assert min(gains) >= 0
    assert sum(gain > 0 for gain in gains) > len(gains) / 2


@pytest.mark.parametrize("constant", [Fraction(PRIME), Fraction(3, PRIME), Fraction(PRIME**2, 2)])
def test_a_constant_against_the_prime_is_left_alone(constant: Fraction) -> None:
    made = expression(lambda c, s, x, y, z, w: [c * (constant * x + 3 * y) + s * (5 * z + 7 * w)])
    assert units(made) is made


@pytest.mark.parametrize("size", [Fraction(HUGE), Fraction(1, HUGE), Fraction(3**3000, 2**4755)])
def test_units_stay_small_and_short(size: Fraction) -> None:
    """Sums do not leave the range of a float, and numbers of thousands of digits are not multiplied up."""
    assert not allowed(size)
    made = expression(lambda c, s, x, y, z, w: [c * (size * x + size * y) + z, c * (size * x + w)])
    descent = Descent([Multiple(0, size, {1: 1}), Multiple(1, Fraction(1), {1: -1})], [1], {})
    assert descent.units == {}
    assert results(units(made), Point(1)) == results(made, Point(1))


@pytest.mark.parametrize("function", ["inverse_dynamics", "mass_matrix"])
@pytest.mark.parametrize("name", ["ur10", "puma560_3dof"])
def test_rounding_grows_little(name: str, function: str) -> None:
    """The largest error that a result may have, by the a-priori bound, in all states that are looked at."""
    plain = factor(build(load(name, warn=lambda _: None), function, Choice()))
    after = units(plain)
    assert count(after).total < count(plain).total
    bound = Rounding(plain)
    for before, now in zip(bound._bounds(plain), bound._bounds(after), strict=True):
        for one, other in zip(before, now, strict=True):
            assert other <= 1.5 * one + 1e-300
