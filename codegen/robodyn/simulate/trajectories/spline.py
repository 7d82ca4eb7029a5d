"""Polynomials of degree five between knots, and the spline of least jerk through them.

The spline has four continuous derivatives. Of all curves through the knots with given velocity and
acceleration at both ends it has the least integral of squared jerk.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def hermite(knots: Floats, x: Floats, v: Floats, a: Floats, t: Floats) -> tuple[Floats, Floats, Floats]:
    """Values, first and second derivatives [K, n] at ``t`` [K] of the pieces of degree five that have the
    values ``x``, derivatives ``v`` and second derivatives ``a`` [m, n] at ``knots`` [m]."""
    i = np.clip(np.searchsorted(knots, t, side="right") - 1, 0, len(knots) - 2)
    h = (knots[i + 1] - knots[i])[:, None]
    s = (t - knots[i])[:, None] / h
    v0, v1, a0, a1 = v[i] * h, v[i + 1] * h, a[i] * h * h, a[i + 1] * h * h
    rest, slope, bend = x[i + 1] - x[i] - v0 - a0 / 2, v1 - v0 - a0, a1 - a0
    c3 = 10 * rest - 4 * slope + bend / 2
    c4 = -15 * rest + 7 * slope - bend
    c5 = 6 * rest - 3 * slope + bend / 2
    value = x[i] + s * (v0 + s * (a0 / 2 + s * (c3 + s * (c4 + s * c5))))
    first = (v0 + s * (a0 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h
    second = (a0 + s * (6 * c3 + s * (12 * c4 + s * 20 * c5))) / (h * h)
    return value, first, second


def least_jerk(knots: Floats, x: Floats, first: Floats, last: Floats) -> tuple[Floats, Floats]:
    """First and second derivatives [m, n] at ``knots`` [m] of the spline of least jerk through ``x`` [m, n].

    ``first`` and ``last`` [2, n] are derivative and second derivative at the ends.
    """
    from scipy.interpolate import make_interp_spline  # not at the top: it is slow to load

    # In the mean step as the unit of time the equations' coefficients are of like size.
    unit = (knots[-1] - knots[0]) / (len(knots) - 1)
    t = (knots - knots[0]) / unit
    ends = tuple([(1, rates[0] * unit), (2, rates[1] * unit**2)] for rates in (first, last))
    spline = make_interp_spline(t, x, k=5, bc_type=ends)
    v, a = spline(t, 1) / unit, spline(t, 2) / unit**2
    v[0], a[0], v[-1], a[-1] = first[0], first[1], last[0], last[1]
    return v, a


def end_rates(t: Floats, x: Floats, points: int = 7) -> tuple[Floats, Floats]:
    """Derivative and second derivative [2, n] at both ends, of the polynomial through the ``points`` samples
    there (fewer where there are fewer)."""
    k = min(points, len(t))
    rates = []
    for times, values in ((t[:k], x[:k]), (t[::-1][:k], x[::-1][:k])):
        scale = abs(times[-1] - times[0])
        powers = np.vander((times - times[0]) / scale, k, increasing=True)
        c = np.linalg.solve(powers, values - values[0])
        none = np.zeros_like(values[0])
        rates.append(np.stack([c[1] / scale, 2 * c[2] / scale**2 if k > 2 else none]))
    return rates[0], rates[1]
