"""The numbers of a chain, exactly."""

from __future__ import annotations

from fractions import Fraction

from robodyn.formats.chain import IDENTITY, Rotation
from robodyn.robot.numbers import shortest
from robodyn.robot.parts import Exact, Rows
from robodyn.robot.rotations import QUARTER_TURN, SAME


def vector(u: tuple[float, float, float]) -> Exact:
    """The decimals of ``u``."""
    x, y, z = map(shortest, u)
    return x, y, z


def rows(rotation: Rotation) -> Rows:
    """The entries of ``rotation``, whole where it turns axes into axes."""
    if rotation == IDENTITY:
        return SAME
    near = [[min((-1, 0, 1), key=lambda n: abs(entry - n)) for entry in row] for row in rotation]
    squared = all(
        abs(entry - whole) <= QUARTER_TURN
        for row, nearest in zip(rotation, near, strict=True)
        for entry, whole in zip(row, nearest, strict=True)
    )
    x, y, z = (tuple(map(Fraction, row)) for row in (near if squared else rotation))
    return x, y, z  # type: ignore[return-value]
