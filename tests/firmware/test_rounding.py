"""The kernel's sine and cosine in numpy, right to an ulp; bounds of rounding errors of angles and choices."""

from __future__ import annotations

import math
from typing import Any

import mpmath
import numpy as np
import pytest

from emit.angles import SCALARS, TYPES, program
from firmware.folders import in_extended_precision
from robodyn.effects.scalars import arctangent, choose
from robodyn.firmware.digest import DTYPE, kernel_sine, outputs, program_inputs
from robodyn.firmware.rounding import ACCURATE, FAR, rounding_bounds
from robodyn.ir import Graph, Input
from robodyn.ir.lowering import lower


def errors(scalar: Any, angles: np.ndarray) -> list[tuple[Any, Any]]:
    """Errors and units in the last place of sine and cosine."""
    found = []
    for name, exact in (("sin", mpmath.sin), ("cos", mpmath.cos)):
        for x, y in zip(angles, kernel_sine(scalar)[name](angles), strict=True):
            true = exact(mpmath.mpf(float(x)))
            ulp = float(np.spacing(DTYPE[scalar](abs(float(true)))))
            found.append((abs(mpmath.mpf(float(y)) - true), ulp))
    return found


@pytest.mark.parametrize("scalar", SCALARS)
def test_right_to_an_ulp_where_the_bounds_say_so(scalar: Any) -> None:
    random = np.random.default_rng(5)
    reach = (np.pi, 32.0, ACCURATE[scalar] * 0.999)
    angles = np.concatenate([random.uniform(-r, r, 400) for r in reach] + [np.arange(-40, 41) * np.pi / 2])
    with mpmath.workdps(60):
        assert all(error <= ulp for error, ulp in errors(scalar, angles.astype(DTYPE[scalar])))


def test_beyond_floats_are_right_to_what_the_bounds_add() -> None:
    angles = np.random.default_rng(6).uniform(201, 6400, 1000).astype(np.float32)
    with mpmath.workdps(60):
        assert all(error <= ulp + FAR["float"] for error, ulp in errors("float", angles))


@pytest.mark.parametrize("scalar", SCALARS)
def test_what_is_no_angle_gives_nan(scalar: Any) -> None:
    x = np.array([np.inf, -np.inf, np.nan, 1e30], DTYPE[scalar])
    for name in ("sin", "cos"):
        assert np.isnan(kernel_sine(scalar)[name](x)).all()


@pytest.mark.parametrize("scalar", SCALARS)
def test_rounding_stays_within_its_bound(scalar: Any) -> None:
    q = np.random.default_rng(2).uniform(-3, 3, (1000, 3)).astype(TYPES[scalar])
    inputs = program_inputs({"q": q}, {})
    bounds = rounding_bounds(program(), inputs, scalar)["tau"]
    results = outputs(program(), {"q": q}, {}, scalar, kernel_sine(scalar))
    error = np.abs(results - in_extended_precision(program(), inputs))
    assert (error <= bounds).all()
    assert (error > bounds / 30).any()
    assert np.median(bounds) < 100 * np.finfo(TYPES[scalar]).eps


def test_bounds_are_large_where_an_angle_or_a_choice_may_jump() -> None:
    graph = Graph()
    x, y = graph.input("q", 0), graph.input("q", 1)
    values = [arctangent(y / 3 + x - y / 3, -1), choose(x + y / 3 - y / 3, 1, 5)]
    lowered = lower(graph, [("tau", values)])
    at = {Input("q", 0): np.array([0.0, 1.0]), Input("q", 1): np.array([1.0, 1.0])}
    bounds = rounding_bounds(lowered, at, "double")["tau"]
    assert (bounds[0] >= [2 * math.pi, 4]).all()
    assert (bounds[1] < 1e-14).all()
