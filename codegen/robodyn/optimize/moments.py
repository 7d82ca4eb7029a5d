"""How one link moves, along one set of axes, and the force at its origin and the moment about it, in each of
the forms that a variant may ask for.

All take the link's motion along some axes (:class:`Rates`) and its moments of mass along the same axes, and
hand back vectors that are worked out on demand. Which of the equal ways each quantity is worked out in, a
:class:`~robodyn.optimize.variant.LinkVariant` says.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from robodyn.dynamics.arm import Symmetric
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.vectors import Mark
from robodyn.ir.program import Label
from robodyn.optimize.gauge import Point
from robodyn.optimize.lazy import NOTHING, Components, Lazy, added, lever, named, weighted
from robodyn.optimize.variant import LinkVariant


@dataclass(frozen=True, slots=True)
class Rates:
    """The motion of a link along some axes: angular velocity ``w`` and acceleration ``alpha``, ``lam`` (11 to
    33), which takes a position to its acceleration, and the acceleration ``a`` of the origin less gravity.
    ``product`` hands out ``w_j w_k``, named once."""

    w: Components
    alpha: Components
    lam: Lazy
    a: Components
    product: Callable[[int, int], Any]


Wrench = tuple[Components, Components]


def lumped(lump: Lump, at: Rates, form: str) -> Wrench:
    """``F = m a + lambda h`` and ``n = h x a`` plus the moment of the second moments, in ``form``."""
    h, k = lump.first, lump.second
    force = Lazy(
        lambda j: lump.mass * at.a[j] + row_times(at.lam, j, h) if lump.mass else row_times(at.lam, j, h)
    )
    if form == "inertia":
        turning = inertia_moment(lump.inertia(), at)
    elif form == "second_moment":
        turning = second_moment_moment(k, at.lam)
    else:
        even = (k.xx, k.yy, k.zz)["xyz".index(form[-1])]
        rest = second_moment_moment(
            Symmetric(k.xx - even, k.yy - even, k.zz - even, k.xy, k.xz, k.yz), at.lam
        )
        turning = added(scaled(2 * even, at.alpha), rest)
    return force, added(turning, lever(h, at.a))


def scaled(factor: Any, u: Components) -> Lazy:
    """``factor * u``."""
    return Lazy(lambda k: factor * u[k] if factor else 0)


def row_times(lam: Lazy, j: int, h: Components) -> Any:
    """Row ``j`` (from 0) of ``lambda h``."""
    row = 10 * j + 11
    return weighted((h[0], h[1], h[2]), lam, (row, row + 1, row + 2))


def second_moment_moment(k: Symmetric, lam: Lazy) -> Lazy:
    """The integral of ``r x lambda r``: the antisymmetric part of ``lambda K``."""

    def component(j: int) -> Any:
        if j == 0:
            total = weighted((k.yy, -k.zz), lam, (32, 23))
            crossed, other = ((k.yz, 33, 22), (k.xy, -k.xz, 31, 21))
        elif j == 1:
            total = weighted((k.zz, -k.xx), lam, (13, 31))
            crossed, other = ((k.xz, 11, 33), (k.yz, -k.xy, 12, 32))
        else:
            total = weighted((k.xx, -k.yy), lam, (21, 12))
            crossed, other = ((k.xy, 22, 11), (k.xz, -k.yz, 23, 13))
        if crossed[0]:
            total = total + crossed[0] * (lam[crossed[1]] - lam[crossed[2]])
        return total + weighted(other[:2], lam, other[2:])

    return Lazy(component)


def inertia_moment(inertia: Symmetric, at: Rates) -> Lazy:
    """Euler's equation with ``D`` and ``k``: ``I alpha + w x (I w)`` (the thesis's eq. 2.41)."""
    i = inertia
    rows = ((i.xx, i.xy, i.xz), (i.xy, i.yy, i.yz), (i.xz, i.yz, i.zz))

    def component(j: int) -> Any:
        b, c = (j + 1) % 3, (j + 2) % 3
        total = weighted(rows[j], at.alpha)
        for factor, one, other in ((rows[c][c] - rows[b][b], b, c), (rows[j][c], j, b), (-rows[j][b], j, c)):
            if factor:
                total = total + factor * at.product(one, other)
        if rows[b][c]:
            total = total + rows[b][c] * (at.product(b, b) - at.product(c, c))
        return total

    return Lazy(component)


def with_point(point: Point, r: Components, at: Rates) -> Wrench:
    """An isotropic body and a point mass at ``r``, whose acceleration is ``a + lambda r``."""
    pull = Lazy(lambda j: point.mass * (at.a[j] + row_times(at.lam, j, r)))
    force = Lazy(lambda j: pull[j] + point.rest * at.a[j] if point.rest else pull[j])
    return force, added(scaled(2 * point.second, at.alpha), lever(r, pull))


def spin(inertia: Any, at: Rates) -> Wrench:
    """A body that only resists to turn about z, with ``inertia`` [kg m^2]; it takes no force."""

    def component(j: int) -> Any:
        if j == 2:
            return inertia * at.alpha[2]
        momentum = inertia * at.w[2]
        return momentum * at.w[1] if j == 0 else -(momentum * at.w[0])

    return NOTHING, Lazy(component)


def spin_about(inertia: Any, axis: Components, w: Components, alpha: Components, qd: Any, qdd: Any) -> Wrench:
    """The same about ``axis``, on a carrier of ``w`` and ``alpha``; its torque is the moment along the axis,
    index 3 of the moment that is handed back."""

    def component(j: int) -> Any:
        if j == 3:
            return inertia * (weighted((axis[0], axis[1], axis[2]), alpha) + qdd)
        if j == 4:
            return inertia * (weighted((axis[0], axis[1], axis[2]), w) + qd)
        b, c = (j + 1) % 3, (j + 2) % 3
        across = weighted((axis[c], -axis[b] if axis[b] else 0), w, (b, c))
        return moment[3] * axis[j] + moment[4] * across if axis[j] else moment[4] * across

    moment = Lazy(component)
    return NOTHING, moment


def wrist(
    point: Point, inertia: Any, way: Any, axis: Components, at: Rates, qd: Any, qdd: Any
) -> tuple[Components, Lazy]:
    """The last two links at once, along axes in which ``axis``, in their x-y plane, is the last joint's but
    for its sign ``way``: an isotropic body with a point mass on the axis, and a spin about it.

    ``lambda`` takes the axis to ``w (w . axis) + alpha x axis - (w . w) axis``, and the spin needs the same
    ``w . axis``. Index 3 of the moment is the torque of the last joint.
    """
    w, alpha = at.w, at.alpha
    x, y = axis[0], axis[1]
    turning = Lazy(lambda j: weighted((x, y), (w, alpha)[j], (0, 1)))  # w . axis, alpha . axis

    def of_axis(j: int) -> Any:
        """``lambda axis``."""
        along = turning[0] * w[j]
        if j == 2:
            return along + (alpha[0] * y - alpha[1] * x)
        across = -(alpha[2] * y) if j == 0 else alpha[2] * x
        square = at.product(0, 0) + at.product(1, 1) + at.product(2, 2)
        return along + across - square * axis[j]

    pull = Lazy(lambda j: point.mass * (at.a[j] + point.distance * of_axis(j)))
    force = Lazy(lambda j: pull[j] + point.rest * at.a[j] if point.rest else pull[j])

    def component(j: int) -> Any:
        if j == 3:
            return inertia * (way * turning[1] + qdd)
        if j == 4:  # angular momentum of the spin
            return inertia * (way * turning[0] + qd)
        torque, momentum = way * moment[3], way * moment[4]
        even = 2 * point.second * alpha[j] if point.second else 0
        if j == 2:
            moved = x * (point.distance * pull[1]) - y * (point.distance * pull[0])
            return moved + momentum * (w[0] * y - w[1] * x) + even
        both = point.distance * pull[2] - momentum * w[2]
        return (y * both + torque * x if j == 0 else torque * y - x * both) + even

    moment = Lazy(component)
    return force, moment


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
