"""What logs show of an arm's numbers: base parameters, each a number or a sum of several.

Columns of the weighted regressor that are sums of others show only with them. A pivoted QR factorisation
chooses a basis; each column beside it adds its number to those of the basis (Gautier 1991).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from robodyn.identify.fit import Fit
from robodyn.identify.limits import UNSEEN_SHARE
from robodyn.identify.plain import basis_of


@dataclass(frozen=True, slots=True)
class Combination:
    """A sum of numbers that logs show, SI: places of the ``terms`` in the fit and their factors, the first of
    which is 1; its ``value`` and standard error."""

    terms: tuple[tuple[int, float], ...]
    value: float
    stderr: float

    def expression(self, names: tuple[str, ...]) -> str:
        """Such as ``link1.mass + joint1.rotor_inertia.inertia``, of the ``names`` of all numbers."""
        text = ""
        for place, factor in self.terms:
            sign, size = (" - " if factor < 0 else " + "), f"{abs(factor):.6g}"
            text += (sign if text else "") + ("" if size == "1" else f"{size}*") + names[place]
        return text


def combinations_of(fit: Fit) -> tuple[Combination, ...]:
    """The base parameters that logs say more of than the description did."""
    H, sd, z = fit.solution.curvature, fit.unknowns.sd, fit.solution.z
    basis, others, factors = basis_of(H, fit.unknowns.free)
    seen = []
    for place, row in sorted(zip(basis.tolist(), factors, strict=True)):
        L = np.zeros(len(z))
        L[place], L[others] = 1.0, row
        error = float(np.sqrt(max(float(L @ fit.covariance @ L), 0.0)))
        if error < UNSEEN_SHARE * float(np.sqrt((L * sd) @ (L * sd))):
            terms = sorted(np.flatnonzero(L).tolist(), key=lambda k: k != place)
            seen.append(Combination(tuple((k, float(L[k])) for k in terms), float(L @ z), error))
    return tuple(seen)
