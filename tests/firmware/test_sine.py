"""The kernel's sine and cosine in numpy: right to an ulp, NaN where there is no angle."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest

from firmware.folders import SCALARS
from robodyn.firmware.digest import kernel_sine
from robodyn.firmware.rounding import ACCURATE, FAR
from robodyn.firmware.states import DTYPE


def errors(scalar: Any, angles: np.ndarray) -> list[tuple[Any, Any]]:
    """Errors and units in the last place of sine and cosine."""
    found = []
    for name, exact in (("sin", mpmath.sin), ("cos", mpmath.cos)):
        for x, y in zip(angles, kernel_sine(scalar)[name](angles), strict=True):
            true = exact(mpmath.mpf(float(x)))
            found.append(
                (abs(mpmath.mpf(float(y)) - true), float(np.spacing(DTYPE[scalar](abs(float(true))))))
            )
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
