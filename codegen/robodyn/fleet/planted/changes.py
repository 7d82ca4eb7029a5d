"""What is planted in a unit: an effect of the catalogue that begins on a day, or was there from the first."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.fleet.result import Shape

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Change:
    """``effects`` at a ``joint`` (from 1; None: of the whole arm) that are planted in a unit, of a ``kind``.

    From ``begin`` [s since 1970; None: from before the first log] on they grow for ``growth`` [s] (0: at
    once) to their full ``size``; ``parameters`` is what they come to then, for people. ``draw`` is the seed
    of what else there is to draw of them."""

    kind: str
    effects: tuple[str, ...]
    joint: int | None
    begin: float | None
    growth: float
    size: float
    parameters: Mapping[str, float | str]
    draw: int = 0

    @property
    def shape(self) -> Shape:
        """How it comes."""
        if self.begin is None:
            return "always"
        return "drift" if self.growth else "step"

    def level(self, date: float) -> float:
        """How much of it is there on a ``date`` [s since 1970], from 0 to 1."""
        if self.begin is None:
            return 1.0
        if not self.growth:
            return float(date >= self.begin)
        return float(np.clip((date - self.begin) / self.growth, 0.0, 1.0))


@dataclass(frozen=True, slots=True)
class Window:
    """When a change may begin: ``earliest`` to ``latest`` [s since 1970]; by ``end`` it has its full size."""

    earliest: float
    latest: float
    end: float


def window(dates: Floats, growth: float) -> Window | None:
    """When a change that grows for ``growth`` [s] or more may begin in a unit with logs on ``dates`` [K]: not
    before its second log, and so that its last two show it in full. None: there is no such time."""
    earliest, end = float(dates[1]), float(dates[-2])
    latest = end - growth
    return Window(earliest, latest, end) if latest > earliest else None


def when(dates: Floats, growth: tuple[float, float], rng: np.random.Generator) -> tuple[float, float]:
    """When a change begins [s since 1970] and how long it grows [s], ``growth`` from least to most; ``dates``
    have a :func:`window` for it."""
    open_ = window(dates, growth[0])
    assert open_ is not None
    begin = float(round(rng.uniform(open_.earliest, open_.latest)))
    most = min(growth[1], open_.end - begin)
    return begin, float(round(rng.uniform(growth[0], most))) if most else 0.0
