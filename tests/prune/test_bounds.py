"""Bounds hold at every state, are close, and those of equal programs are next to nothing."""

from __future__ import annotations

import itertools
import math
import random
from fractions import Fraction

import numpy as np
import pytest

from prune.limited import damaged, random_limited
from robodyn.ir import Graph, Input, Program
from robodyn.ir.evaluate import evaluate_exact
from robodyn.kernels.generate import Options, program
from robodyn.optimize.polynomial import MOST, Bounded, constant
from robodyn.optimize.programs import Choice, build
from robodyn.optimize.prune.bounds import Expansions, proven_errors
from robodyn.optimize.prune.box import Box, box_of, draw, largest, values
from robodyn.optimize.prune.supremum import Terms, proven, waves_of
from robodyn.robot.values import circle_point

ROBOTS = [(seed, 1 + seed % 4) for seed in range(5)]
FAST = Options(optimize="fast")


def sampled(one: Program, other: Program, box: Box) -> list[float]:
    """The largest differences of two programs that are found."""
    return [float(x) for x in largest(lambda at: values(one, box, at) - values(other, box, at), box, seed=7)]


def peaks(made: Program, box: Box) -> list[float]:
    return [float(x) for x in np.abs(values(made, box, draw(box, 500, 3))).max(axis=1)]


@pytest.mark.parametrize(("seed", "joints"), ROBOTS)
def test_the_error_of_a_damaged_program_is_bounded_and_not_by_far(seed: int, joints: int) -> None:
    robot = random_limited(seed, joints)
    box = box_of(robot)
    made = program(robot, "inverse_dynamics", FAST)
    wrong = damaged(made, seed)
    book = build(robot, "inverse_dynamics", Choice("newton_euler", regroup=False, chains=False))
    for bound, peak in zip(proven_errors(book, made, box, [0.0] * joints), peaks(book, box), strict=True):
        assert bound <= 1e-7 * max(peak, 1.0)  # programs that are equal
    errors = sampled(wrong, made, box)
    bounds = proven_errors(made, wrong, box, [0.0] * joints)
    for bound, error, peak in zip(bounds, errors, peaks(made, box), strict=True):
        assert error <= bound + 1e-11 * peak
        assert bound <= 3 * error + 1e-7 * max(peak, 1.0)  # of use, too


@pytest.mark.parametrize("seed", [1, 3, 5])
def test_the_bound_holds_without_rounding(seed: int) -> None:
    """Rational states, sines and cosines as points of the circle, no floats in between."""
    robot = random_limited(seed, 3)
    assert robot.rest_velocity is None  # a hyperbolic tangent is no rational number
    box = box_of(robot)
    made = program(robot, "inverse_dynamics", FAST)
    wrong = damaged(made, seed)
    bounds = proven_errors(made, wrong, box, [0.0] * 3)
    chance = random.Random(seed)
    for _ in range(100):
        inputs = {}
        for x, (low, high) in box.ranges.items():
            inputs[x] = low + (high - low) * Fraction(chance.randint(0, 4), 4)
        points = {}
        for x in box.angles:
            t = Fraction(chance.randint(-40, 40), chance.randint(1, 20))
            points[x] = ((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t))
            inputs[x] = Fraction(0)
        (true,) = evaluate_exact(made, inputs, points, circle_point).values()
        (found_there,) = evaluate_exact(wrong, inputs, points, circle_point).values()
        for one, other, bound in zip(true, found_there, bounds, strict=True):
            assert abs(one - other) <= Fraction(bound)


def test_narrow_and_lopsided_ranges_are_kept_to() -> None:
    """The displacement of a prismatic joint lies where its limits say, not around zero."""
    graph = Graph()
    x = graph.input("q", 0)
    box = Box((), {Input("q", 0): (Fraction(1, 3), Fraction(2, 3))}, {})
    expansions = Expansions(graph, box)
    assert expansions.of(x).bound == pytest.approx(2 / 3)
    assert expansions.of(x).bound >= Fraction(2, 3)
    assert expansions.of(x - Fraction(1, 2)).bound == pytest.approx(1 / 6)
    square = expansions.of(x * x)
    assert 4 / 9 <= expansions.bound(square, 0.0) == pytest.approx(4 / 9)
    speed = graph.input("qd", 0)
    expansions = Expansions(graph, Box((), {Input("qd", 0): (Fraction(-3), Fraction(3))}, {}))
    error = expansions.of(speed * speed - 5)  # squares are known to be positive
    assert error.bound == pytest.approx(14)
    assert 5 <= expansions.bound(error, 0.0) == pytest.approx(5)


def test_an_offset_turns_the_wave() -> None:
    graph = Graph()
    q = graph.input("q", 0)
    box = Box((Input("q", 0),), {}, {})
    expansions = Expansions(graph, box)
    offset = Fraction(7, 10)
    turned = graph.sin(q + offset)
    c, s = circle_point(offset)
    by_hand = c * graph.sin(q) + s * graph.cos(q)
    assert expansions.difference(turned, by_hand).bound < 1e-14
    assert expansions.difference(graph.cos(q + offset), c * graph.cos(q) - s * graph.sin(q)).bound < 1e-14
    assert expansions.difference(turned, graph.sin(q)).bound == pytest.approx(2 * math.sin(0.35))


def test_rounding_is_counted() -> None:
    """A third is no float: the remainder holds the difference, and grows with every operation."""
    third = constant(Fraction(1, 3))
    assert abs(Fraction(third.terms[0].real) - Fraction(1, 3)) <= Fraction(third.rest)
    total = third
    for _ in range(50):
        total = total.plus(third).times(third)
    exact = Fraction(1, 3)
    for _ in range(50):
        exact = (exact + Fraction(1, 3)) / 3
    assert abs(Fraction(total.terms[0].real) - exact) <= Fraction(total.rest)
    assert total.rest < 1e-14
    large, small = (Bounded({0: complex(x)}, 0.0, 0) for x in (1e16, 1.25))
    back = large.plus(small).plus(large, -1)
    assert back.terms[0].real != 1.25  # it is gone
    assert abs(back.terms[0].real - 1.25) <= back.rest


def test_a_key_never_runs_over() -> None:
    x = Bounded({1: 1 + 0j}, 0.0, 1)
    power = x
    for _ in range(MOST - 1):
        power = power.times(x)
    assert set(power.terms) == {MOST}
    with pytest.raises(OverflowError):
        power.times(x)


# --- the largest sum of sizes of waves ----------------------------------------------------------------------


def some_terms(seed: int, angles: int, degree: int, monomials: int) -> Terms:
    """Random real polynomials: every c with its conjugate."""
    rng = random.Random(seed)
    terms: Terms = {}
    for m in range(monomials):
        for k in itertools.product(range(-degree, degree + 1), repeat=angles):
            if rng.random() < 0.4 and (k, m) not in terms:
                c = complex(rng.gauss(0, 1), rng.gauss(0, 1) if any(k) else 0.0)
                terms[k, m] = c
                terms[tuple(-x for x in k), m] = c.conjugate()
    return terms


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("kept", [1, 2, 3])
def test_the_largest_sum_lies_between_what_is_found_and_what_is_proven(seed: int, kept: int) -> None:
    terms = some_terms(seed, angles=2, degree=2, monomials=3)
    steps = np.linspace(0, 2 * math.pi, 121)
    parts = np.zeros((3, 121, 121), dtype=complex)
    for ((one, other), m), c in terms.items():
        parts[m] += c * np.exp(1j * (one * steps[:, None] + other * steps[None, :]))
    totals = np.abs(parts).sum(axis=0)
    waves = waves_of(terms, kept)
    grid = np.array([axis.ravel() for axis in np.meshgrid(steps, steps, indexing="ij")])
    if kept == 2:
        assert waves.at(grid) == pytest.approx(totals.ravel(), rel=1e-3)
    upper = proven(waves)
    assert totals.max() <= upper * (1 + 1e-12)
    if kept > 1:
        assert upper <= 1.03 * totals.max()


def test_a_bound_is_as_close_as_asked_for() -> None:
    wave: Terms = {((1, 0), 0): 0.5, ((-1, 0), 0): 0.5, ((0, 1), 1): -0.5j, ((0, -1), 1): 0.5j}
    waves = waves_of(wave, 2)  # |cos| + |sin| of two angles
    assert 2 <= proven(waves, close=1.001) <= 2.004
    assert 2 <= proven(waves, work=0) <= 2.0001  # the sizes alone
    assert proven(waves, threshold=2.5) <= 2.5
    both: Terms = {((1,), m): 0.5 if m else -0.5j for m in (0, 1)}
    both |= {((-1,), m): c.conjugate() for (_, m), c in list(both.items())}
    assert math.sqrt(2) <= proven(waves_of(both, 1), close=1.001) <= 1.002 * math.sqrt(2)
