"""Slips in the thesis's equations and printed data: each as printed and right, tried against a reference.

``data/slips.yaml`` has them in words, since the thesis itself is not part of robodyn; only figures are as
printed. The modules here compute both forms. The slips were found by robodyn's authors on a scan of its text,
so that a wrong letter may be the scan's where no figure decides. Source: Dhanaraj 1990.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from robodyn.thesis.printed import data

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


def compare(
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


@dataclass(frozen=True, slots=True)
class Slip:
    """A slip at ``place``: what is ``printed`` and what is ``right``, in words; ``check`` computes both, or
    says why there is nothing to compute."""

    place: str
    printed: str
    right: str
    check: Callable[[], Comparison] | str


def slips(table: str = "equations") -> tuple[Slip, ...]:
    """The forms that a table tries, in the order of the text."""
    return tuple(_slip(**entry) for entry in data("slips")[table])


def slips_of(place: str) -> tuple[Slip, ...]:
    """The slips whose place begins so, named by the rest of it."""
    return tuple(
        replace(slip, place=slip.place.removeprefix(place))
        for slip in slips()
        if slip.place.startswith(place)
    )


def _slip(
    place: str, printed: str, right: str, by: str | None = None, of: tuple[Any, ...] = (), words: str = ""
) -> Slip:
    if by is None:
        return Slip(place, printed, right, words)
    module, _, function = by.partition(".")
    check = getattr(importlib.import_module(f"{__package__}.{module}"), function)
    return Slip(place, printed, right, partial(check, *of))
