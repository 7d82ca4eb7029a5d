"""How results are approached that cannot be written straight: a step, repeated a bounded number of times."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

#: What gives numbers of an arm at one state, a :class:`~robodyn.dynamics.state.Dynamics`.
Stage = Callable[[Any], Sequence[Any]]


@dataclass(frozen=True, slots=True)
class Iterative:
    """Results that are approached in ``most`` steps at most, from each of ``rows`` starts.

    ``start`` gives the states before the first step, one after another. ``step`` gives the state after the
    one in the input ``x``, whose first ``[n]`` numbers are the positions ``q`` at which it has the arm, and
    whose last one is more than 0 where nothing is left to do. ``finish`` gives the results, of all states in
    ``x``.
    """

    start: Stage
    step: Stage
    finish: Stage
    most: int
    rows: int = 1
