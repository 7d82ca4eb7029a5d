"""What may be missing: for each entry of the catalogue the columns that it would add to the torques.

Friction of the drive is evaluated by the definitions themselves at unit parameters, where they are linear;
what is not linear in a parameter has a grid of values. Columns are torques [K, n], at the full rate or the
coarse one, unfiltered."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Final

from robodyn.diagnose.select.library.candidate import Candidate, Context, Hints
from robodyn.diagnose.select.library.context import context_of
from robodyn.diagnose.select.library.elastic import behind, elastic
from robodyn.diagnose.select.library.friction import (
    bearing,
    bristles,
    friction,
    loads,
    loss,
    power_law,
    stribeck,
)
from robodyn.diagnose.select.library.position import conservative, ripple
from robodyn.diagnose.select.library.sensors import clipped, saturation, sensor
from robodyn.diagnose.select.library.several import coupling, whole

__all__ = ["Candidate", "Context", "Hints", "again", "candidates", "context_of"]

_AGAIN: Final[Mapping[str, Callable[[Context, int, Mapping[str, float]], Candidate]]] = {
    "stribeck_friction": stribeck,
    "presliding_hysteresis": bristles,
    "transmission_loss": loss,
    "power_law_friction": power_law,
    "load_dependent_friction": bearing,
    "torque_ripple": ripple,
    "torque_saturation": clipped,
    "joint_elasticity": behind,
    "backlash": behind,
}


def candidates(c: Context) -> Iterator[Candidate]:
    """Everything that the catalogue has and a log can show."""
    for j in range(c.n):
        yield from friction(c, j)
        yield from loads(c, j)
        yield from conservative(c, j)
        yield from elastic(c, j)
        yield from sensor(c, j)
        yield from saturation(c, j)
    for j in range(c.n):
        for k in range(j):
            yield from coupling(c, j, k)
    yield from whole(c)


def again(c: Context, candidate: Candidate, given: Mapping[str, float]) -> Candidate:
    """``candidate`` in the context ``c`` with other values of what is not linear."""
    assert candidate.joint is not None
    return _AGAIN[candidate.effect](c, candidate.joint - 1, given)
