"""Polynomials of degree five between knots, and the spline of least jerk through them.

The spline has four continuous derivatives. Of all curves through the knots with given velocity and
acceleration at both ends it has the least integral of squared jerk, so its equations are symmetric and
positive definite, and block elimination needs no pivots.
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
    m, n = x.shape
    scale = (knots[-1] - knots[0]) / (m - 1)  # unit of time: the blocks are then of like size
    h = np.diff(knots) / scale
    inner = m - 2
    v, a = np.empty((m, n)), np.empty((m, n))
    v[0], a[0], v[-1], a[-1] = first[0], first[1], last[0], last[1]
    if inner:
        step = np.diff(x, axis=0)
        k1, k2, k3, k4 = (h[:, None, None] ** -p for p in (1.0, 2.0, 3.0, 4.0))
        # Rows: jump of the fourth derivative / 24, jump of the third / 6 with the sign that makes the whole
        # symmetric after the rows' own factors; unknowns (v, a) of a knot.
        below = _blocks(7 * k3, k2, -4 * k2, -k1 / 2)[:-1]
        above = _blocks(7 * k3, -k2, 4 * k2, -k1 / 2)[1:]
        own = (
            _blocks(8 * k3, -1.5 * k2, -6 * k2, 1.5 * k1)[:-1]
            + _blocks(8 * k3, 1.5 * k2, 6 * k2, 1.5 * k1)[1:]
        )
        jump = np.empty((inner, 2, n))
        jump[:, 0] = 15 * (step[:-1] * k4[:-1, 0] + step[1:] * k4[1:, 0])
        jump[:, 1] = 10 * (step[1:] * k3[1:, 0] - step[:-1] * k3[:-1, 0])
        ends = np.stack([first, last]) * np.array([scale, scale**2])[None, :, None]
        jump[0] -= below[0] @ ends[0]
        jump[-1] -= above[-1] @ ends[1]
        derivatives = _block_tridiagonal(below, own, above, jump)
        v[1:-1], a[1:-1] = derivatives[:, 0] / scale, derivatives[:, 1] / scale**2
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


def _blocks(vv: Floats, va: Floats, av: Floats, aa: Floats) -> Floats:
    """Blocks [K, 2, 2] of entries [K, 1, 1]."""
    blocks: Floats = np.block([[vv, va], [av, aa]])
    return blocks


def _block_tridiagonal(below: Floats, own: Floats, above: Floats, right: Floats) -> Floats:
    """Solution [K, 2, n] of a block tridiagonal system by odd-even reduction: half the unknowns at a time."""
    if len(own) == 1:
        return np.linalg.solve(own, right).astype(np.float64)
    below, above = below.copy(), above.copy()
    below[0] = above[-1] = 0
    odd = slice(1, None, 2)
    inverse = np.linalg.inv(own[odd])
    to_left, to_right, known = inverse @ below[odd], inverse @ above[odd], inverse @ right[odd]
    even = (len(own) + 1) // 2
    after = len(to_left)  # odd unknown k lies between the even ones k and k + 1
    own_left, own_right = below[2::2], above[: 2 * after : 2]
    before = even - 1
    new_own, new_right = own[::2].copy(), right[::2].copy()
    new_below, new_above = np.zeros_like(new_own), np.zeros_like(new_own)
    new_own[1:] -= own_left @ to_right[:before]
    new_right[1:] -= own_left @ known[:before]
    new_below[1:] = -own_left @ to_left[:before]
    new_own[:after] -= own_right @ to_left
    new_right[:after] -= own_right @ known
    new_above[:after] = -own_right @ to_right
    solution = np.empty_like(right)
    solution[::2] = _block_tridiagonal(new_below, new_own, new_above, new_right)
    solution[odd] = known - to_left @ solution[::2][:after]
    reach = solution[2::2]
    solution[odd][: len(reach)] -= to_right[: len(reach)] @ reach
    return solution
