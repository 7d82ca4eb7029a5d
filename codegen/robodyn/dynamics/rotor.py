"""Rotors, wherever they sit."""

from __future__ import annotations

from typing import Any, NamedTuple


class Rotor(NamedTuple):
    """A rotor: its inertia [kg m^2, kg], and the joints (from 0) whose rates add up to its own, each with a
    ratio."""

    inertia: Any
    rates: tuple[tuple[int, Any], ...]
