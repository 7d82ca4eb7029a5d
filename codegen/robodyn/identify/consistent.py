"""Physical consistency: standard parameters of bodies that could be, and the best such fit.

A body's ten standard parameters belong to a distribution of mass if and only if its pseudo-inertia, a 4 x 4
matrix that is linear in them, is positive semidefinite; mass, principal moments and triangle inequalities
follow. A quadratic over that cone and some numbers that must not be negative is minimised by Newton's method
on a logarithmic barrier.

Source: Wensing, Kim, Slotine, RA-L 2018; Boyd and Vandenberghe, Convex Optimization (2004), ch. 11.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from robodyn.arrays import Floats, Indices


def _basis() -> Floats:
    """What each of ten parameters ``m mx my mz xx yy zz xy xz yz`` adds to the pseudo-inertia [10, 4, 4]."""
    E = np.zeros((10, 4, 4))
    E[0, 3, 3] = 1.0
    for k in range(3):
        E[1 + k, k, 3] = E[1 + k, 3, k] = 1.0
        E[4 + k, :3, :3] = 0.5 * np.eye(3)
        E[4 + k, k, k] -= 1.0
    for k, (a, b) in enumerate(((0, 1), (0, 2), (1, 2))):
        E[7 + k, a, b] = E[7 + k, b, a] = -1.0
    return E


BASIS = _basis()


def pseudo_inertia(phi: Floats) -> Floats:
    """The pseudo-inertia [..., 4, 4] of standard parameters [..., 10]."""
    return np.asarray(np.tensordot(phi, BASIS, axes=1))


@dataclass(frozen=True, slots=True, eq=False)
class Cone:
    """What parameters x [p] must obey: each of the ``bodies`` [B, 10] (their places) has a positive
    pseudo-inertia, and x at the places ``positive`` is not negative. ``units`` [B, 4, 4]: what
    pseudo-inertias are multiplied by, so that links of all sizes are alike."""

    bodies: Indices
    units: Floats
    positive: Indices

    @classmethod
    def of(cls, bodies: Sequence[Indices], sizes: Sequence[tuple[float, float]], positive: Indices) -> Cone:
        """The cone of ``bodies`` of these ``sizes``: mass [kg] and length [m]."""
        units = [np.array([1 / length] * 3 + [1.0]) / np.sqrt(mass) for mass, length in sizes]
        return cls(
            np.array(bodies, dtype=np.intp).reshape(-1, 10),
            np.array([np.outer(unit, unit) for unit in units]).reshape(-1, 4, 4),
            positive,
        )

    @property
    def degree(self) -> int:
        """How many eigenvalues and numbers the barrier holds above 0."""
        return int(4 * len(self.bodies) + len(self.positive))

    def matrices(self, x: Floats) -> Floats:
        """The pseudo-inertias [B, 4, 4] of ``x``, or of a step, in their units."""
        return pseudo_inertia(x[self.bodies]) * self.units

    def slopes(self, x: Floats) -> tuple[Floats, Floats]:
        """Gradient [p] and Hessian [p, p] of minus the logarithms of determinants and numbers."""
        gradient, hessian = np.zeros(len(x)), np.zeros((len(x), len(x)))
        if len(self.positive):
            at = x[self.positive]
            gradient[self.positive] -= 1 / at
            hessian[self.positive, self.positive] += 1 / at**2
        lower = np.linalg.inv(np.linalg.cholesky(self.matrices(x)))  # also of what is all but singular
        inverse = np.swapaxes(lower, 1, 2) @ lower
        products = inverse[:, None] @ (BASIS * self.units[:, None])
        flat = products.reshape(-1, 10, 16)
        turned = np.swapaxes(products, 2, 3).reshape(-1, 10, 16)
        curvature = flat @ np.swapaxes(turned, 1, 2)
        gradient[self.bodies] -= np.trace(products, axis1=2, axis2=3)
        hessian[self.bodies[:, :, None], self.bodies[:, None, :]] += curvature
        return gradient, hessian

    def contains(self, x: Floats) -> bool:
        """Whether ``x`` is inside in numbers of double precision, not by less than their rounding."""
        try:
            np.linalg.cholesky(self.matrices(x))
        except np.linalg.LinAlgError:
            return False
        return bool((x[self.positive] > 0).all())

    def reaches(self, x: Floats, step: Floats) -> Floats:
        """How fast a ``step`` from ``x`` changes the numbers above 0, each as a share of what it is: at a
        share s of the step they are ``1 + s * reaches`` times as large."""
        shares: list[Floats] = [step[self.positive] / x[self.positive]]
        lower = np.linalg.inv(np.linalg.cholesky(self.matrices(x)))
        turned = lower @ self.matrices(step) @ np.swapaxes(lower, 1, 2)
        shares.append(np.asarray(np.linalg.eigvalsh(turned).ravel()))
        return np.concatenate(shares)


def minimum(
    hessian: Floats, linear: Floats, cone: Cone, start: Floats, free: Indices, end: float = 1e-7
) -> Floats:
    """The x [p] inside ``cone`` that makes ``x' H x / 2 - linear' x`` smallest, from a ``start`` inside, by
    its ``free`` numbers alone, but for ``end`` (of the same unit)."""
    x = start.copy()
    slope = (hessian @ x - linear)[free]
    # What there is to gain at all sets the barrier's first weight.
    gain = 0.5 * float(slope @ solve_definite(hessian[np.ix_(free, free)], slope))
    mu = max(gain / max(cone.degree, 1), end)
    while True:
        for _ in range(40):
            gradient, curvature = cone.slopes(x)
            slope, push = hessian @ x - linear + mu * gradient, mu * curvature
            step = np.zeros(len(x))
            step[free] = -solve_definite((hessian + push)[np.ix_(free, free)], slope[free])
            promised = -float(slope @ step)
            if promised < 0.03 * mu:
                break
            share = _share(cone, x, step, mu, -promised, float(step @ hessian @ step))
            if not share:
                break
            x = x + share * step
        if mu <= end:
            return x
        mu = max(0.02 * mu, end)


def _share(cone: Cone, x: Floats, step: Floats, mu: float, descent: float, bend: float) -> float:
    """How far to go along a ``step``: inside, and down by a part of what it promises."""
    reaches = cone.reaches(x, step)
    plain = descent + mu * float(reaches.sum())  # the slope of the quadratic alone
    share = 0.99 / max(-float(reaches.min(initial=0.0)), 0.99)
    while share > 1e-10:
        change = share * plain + 0.5 * share**2 * bend - mu * float(np.log1p(share * reaches).sum())
        if change <= 0.1 * share * descent and cone.contains(x + share * step):
            return share
        share *= 0.5
    return 0.0


def to_unit_diagonal(matrix: Floats) -> tuple[Floats, Floats]:
    """A positive definite ``matrix`` [p, p] with rows and columns scaled to a unit diagonal, and by what [p].
    What rounding may take off its eigenvalues is added to them: numbers that only show together leave it
    singular."""
    unit = 1 / np.sqrt(np.diag(matrix))
    return matrix * np.outer(unit, unit) + len(unit) * np.finfo(float).eps * np.eye(len(unit)), unit


def solve_definite(matrix: Floats, right: Floats) -> Floats:
    """``matrix^-1 right``."""
    scaled, unit = to_unit_diagonal(matrix)
    return np.asarray(unit * np.linalg.solve(scaled, unit * right))


def inside(phi: Floats, mass: float, length: float, share: float) -> Floats:
    """Parameters [10] near ``phi`` whose pseudo-inertia is positive: its negative part cut off, and a
    ``share`` of a ball of ``mass`` and radius ``length`` added."""
    unit = np.array([length] * 3 + [1.0]) * np.sqrt(mass)
    matrix = pseudo_inertia(phi) / np.outer(unit, unit)
    values, vectors = np.linalg.eigh(matrix)
    matrix = (vectors * np.maximum(values, 0)) @ vectors.T + share * np.eye(4)
    return parameters_of(matrix * np.outer(unit, unit))


def parameters_of(matrix: Floats) -> Floats:
    """The standard parameters [10] of a pseudo-inertia [4, 4]."""
    moments = np.trace(matrix[:3, :3]) * np.eye(3) - matrix[:3, :3]
    entries: Sequence[float] = [
        matrix[3, 3], *matrix[:3, 3], *np.diag(moments), moments[0, 1], moments[0, 2], moments[1, 2],
    ]  # fmt: skip
    return np.array(entries)
