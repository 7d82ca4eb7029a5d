"""Rotors, wherever they sit."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple


class Rotor(NamedTuple):
    """A rotor: its inertia [kg m^2, kg], and the joints (from 0) whose rates add up to its own, each with a
    ratio."""

    inertia: Any
    rates: tuple[tuple[int, Any], ...]


def with_rotors(torques: Sequence[Any], rotors: Iterable[Rotor], qdd: Sequence[Any]) -> list[Any]:
    """Joint ``torques`` [n] and what accelerates ``rotors`` at the joints' accelerations ``qdd`` [n]."""
    total = list(torques)
    for rotor in rotors:
        acceleration = sum(ratio * qdd[joint] for joint, ratio in rotor.rates)
        for joint, ratio in rotor.rates:
            total[joint] = total[joint] + ratio * (rotor.inertia * acceleration)
    return total
