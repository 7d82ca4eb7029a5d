"""How far a printed form and the right one are from a reference."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

#: What rounding may leave of a difference, as a share of the reference's largest value.
ROUNDING: Final = 1e-12


@dataclass(frozen=True, slots=True)
class Comparison:
    """Largest differences of the ``printed`` form and of the ``right`` one to a reference, in ``unit``.

    ``against``: the reference. ``tolerance``: up to which difference a form agrees; what rounding leaves, or
    half a unit of the last digit where the reference itself is printed.
    """

    printed: float
    right: float
    unit: str
    against: str
    tolerance: float

    @property
    def printed_agrees(self) -> bool:
        """Whether what is printed is right."""
        return self.printed <= self.tolerance

    @property
    def right_agrees(self) -> bool:
        """Whether what is said to be right is."""
        return self.right <= self.tolerance


def compared(
    printed: ArrayLike,
    right: ArrayLike,
    reference: ArrayLike,
    unit: str,
    against: str,
    tolerance: float | None = None,
) -> Comparison:
    """The comparison of arrays of one shape; ``tolerance`` is :data:`ROUNDING` of the reference by
    default."""
    truth = np.asarray(reference, dtype=np.float64)

    def off(values: Any) -> float:
        return float(np.abs(np.asarray(values, dtype=np.float64) - truth).max())

    if tolerance is None:
        tolerance = ROUNDING * max(1.0, float(np.abs(truth).max()))
    return Comparison(off(printed), off(right), unit, against, tolerance)
