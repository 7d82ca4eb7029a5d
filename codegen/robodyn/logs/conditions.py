"""Conditions under which a log was recorded, out of its own columns: means over all of it."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError
from robodyn.logs.mapping import Channel, LogMap
from robodyn.logs.recording import Recording
from robodyn.logs.resolve import Source, sources
from robodyn.robot.names import shown

Floats = NDArray[np.float64]

#: Temperatures, which become degC: by what a reading is multiplied, and what is added then.
_TEMPERATURES: Final = {
    "degC": (1.0, 0.0), "C": (1.0, 0.0), "°C": (1.0, 0.0), "K": (1.0, -273.15),
    "degF": (5 / 9, -160 / 9), "°F": (5 / 9, -160 / 9),
}  # fmt: skip

#: What names a column a joint.
_PATTERN: Final = re.compile(r"%(0[1-9])?d|%s|[0-9]\.\.")


@dataclass(frozen=True, slots=True)
class Mean:
    """A mean that can be taken piece by piece: the ``total`` of ``count`` finite readings."""

    total: float = 0.0
    count: int = 0

    @property
    def value(self) -> float:
        """The mean; NaN of no readings."""
        return self.total / self.count if self.count else math.nan

    def __add__(self, other: Mean) -> Mean:
        return Mean(self.total + other.total, self.count + other.count)


def together(pieces: Iterable[Mapping[str, Mean]]) -> dict[str, Mean]:
    """The means of a whole log from those of its ``pieces``."""
    means: dict[str, Mean] = {}
    for piece in pieces:
        for name, mean in piece.items():
            means[name] = means[name] + mean if name in means else mean
    return means


def mean_of(readings: Floats) -> Mean:
    """The mean of ``readings`` [K, m]."""
    finite = readings[np.isfinite(readings)]
    return Mean(float(np.sum(finite)), len(finite))


def readings_in(columns: Floats, channel: Channel, columns_of: Sequence[Source]) -> Floats:
    """Readings [K, m] of a condition out of its ``columns``: temperatures in degC, all else as it is logged.

    Raises
    ------
    InputError: the map names a unit that is not known.
    """
    if channel.unit and channel.unit not in _TEMPERATURES:
        raise InputError(
            "the unit of a condition is unknown",
            where=channel.place,
            found=shown(channel.unit),
            expected="degC, degF or K",
            remedy="leave the unit out: all but temperatures counts as it is logged",
        )
    readings = np.empty_like(columns)
    for k, source in enumerate(columns_of):
        unit = channel.unit or source.stream.units.get(source.column, "")
        factor, offset = _TEMPERATURES.get(unit, (1.0, 0.0))
        readings[:, k] = columns[:, k] * factor + offset
    return readings


def condition_sources(
    recording: Recording, mapping: LogMap, name: str, channel: Channel, n: int
) -> tuple[Source, ...]:
    """The columns of the condition ``name``: as many as the map lists, or as its pattern has joints.

    Raises
    ------
    InputError: there are none.
    """
    several = len(channel.columns) > 1
    joints = n if not several and _PATTERN.search(channel.columns[0]) else len(channel.columns)
    return sources(recording, mapping, name, channel, joints)
