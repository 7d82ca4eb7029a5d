"""How one link moves, along one set of axes: angular velocity and acceleration, lambda, and their products.

Which of the equal ways each quantity is worked out in, a :class:`~robodyn.optimize.variant.LinkVariant` says.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from robodyn.dynamics.vectors import Mark
from robodyn.ir.program import Label
from robodyn.optimize.lazy import Components, Lazy, named
from robodyn.optimize.moments import Rates
from robodyn.optimize.variant import LinkVariant

#: Products of two components of w by 10 j + k, j <= k, and what the thesis calls them.
_PRODUCTS = {0: "xx", 1: "xy", 2: "zx", 11: "yy", 12: "yz", 22: "zz"}


def rates_along(
    i: int,
    how: LinkVariant,
    w: Components,
    turning: Components,
    a: Components,
    w0: Components,
    carried: Components,
    above: Components,
    rate: Any,
    mark: Mark,
) -> Rates:
    """The motion along one set of axes; ``w0`` along those in which the link begins to turn. ``turning``
    is the angular acceleration from that of what carries the link, ``carried`` that alone."""
    alpha: Components
    # One product for w_y w_z and w_z w_y; the thesis's k is (yz, zx, xy).
    products = Lazy(lambda jk: mark(w[jk // 10] * w[jk % 10], Label(i + 1, "ww", _PRODUCTS[jk])))

    def product(j: int, k: int) -> Any:
        return products[10 * min(j, k) + max(j, k)]

    def third(k: int) -> Any:
        """The third column, ``w_k w_z + (alpha x z)_k``."""
        if how.column == "turned":
            return above[k]
        if how.column == "carried":  # what the link's own rate adds to both cancels
            return w[k] * w0[2] + (carried[1] if k == 0 else -carried[0])
        return product(k, 2) + (alpha[1] if k == 0 else -alpha[0])

    def entry(index: int) -> Any:
        if index in (11, 22):
            other = 1 if index == 11 else 0
            return -(product(other, other) + product(2, 2))
        if index == 33:  # the part of w across the axis is the carrier's
            return -(w0[0] * w0[0] + w0[1] * w0[1])
        if index in (12, 21):
            return product(0, 1) + (alpha[2] if index == 21 else -alpha[2])
        if index in (13, 23):
            return third(0 if index == 13 else 1)
        k = 0 if index == 31 else 1
        if how.row == "own":
            return product(k, 2) + (-alpha[1] if k == 0 else alpha[0])
        if how.row == "carried":
            return w[k] * (w[2] + rate) + (-carried[1] if k == 0 else carried[0])
        return w[k] * (2 * w[2]) - lam[13 if k == 0 else 23]

    lam = Lazy(lambda index: mark(entry(index), Label(i + 1, "lam", str(index))))
    alpha = named(turning, mark, i + 1, "alpha")
    if how.alpha == "column" and how.column != "own":

        def from_column(k: int) -> Any:
            if k == 2:
                return turning[2]
            return product(1, 2) - lam[23] if k == 0 else lam[13] - product(0, 2)

        alpha = named(Lazy(from_column), mark, i + 1, "alpha")
    return Rates(w, alpha, lam, a, product)


def angular_acceleration(
    carried: Components, w: Components, rate: Any, acceleration: Any
) -> Callable[[int], Any]:
    """Angular acceleration of a link that turns about z at ``rate`` on what carries it."""

    def component(k: int) -> Any:
        if k == 2:
            return carried[2] + acceleration
        if not rate:
            return carried[k]
        return carried[0] + w[1] * rate if k == 0 else carried[1] - w[0] * rate

    return component
