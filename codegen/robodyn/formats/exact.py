"""Vectors, rotations and tensors of exact numbers, and how they are rounded in the end."""

from __future__ import annotations

import math
from fractions import Fraction

from robodyn.formats.chain import IDENTITY, Rotation
from robodyn.formats.limits import DECIMALS, NOISE, NOTHING, QUARTER_TURN
from robodyn.robot.numbers import shortest
from robodyn.robot.parts import Exact, Placement, Rows
from robodyn.robot.values import PI, ZERO, Angle, angle, quarter_turns

_ONE = Fraction(1)
SAME: Rows = ((_ONE, ZERO, ZERO), (ZERO, _ONE, ZERO), (ZERO, ZERO, _ONE))


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


def transposed(R: Rows) -> Rows:
    """``R^T``."""
    (a, b, c), (d, e, f), (g, h, i) = R
    return (a, d, g), (b, e, h), (c, f, i)


def applied(R: Rows, u: Exact) -> Exact:
    """``R u``."""
    x, y, z = (row[0] * u[0] + row[1] * u[1] + row[2] * u[2] for row in R)
    return x, y, z


def product(L: Rows, R: Rows) -> Rows:
    """``L R``."""
    columns = transposed(R)
    x, y, z = (applied(columns, row) for row in L)
    return x, y, z


def about_x(turn: Angle) -> Rows:
    """The rotation about x."""
    c, s = turn.cos, turn.sin
    return (_ONE, ZERO, ZERO), (ZERO, c, -s), (ZERO, s, c)


def about_y(turn: Angle) -> Rows:
    """The rotation about y."""
    c, s = turn.cos, turn.sin
    return (c, ZERO, s), (ZERO, _ONE, ZERO), (-s, ZERO, c)


def about_z(turn: Angle) -> Rows:
    """The rotation about z."""
    c, s = turn.cos, turn.sin
    return (c, -s, ZERO), (s, c, ZERO), (ZERO, ZERO, _ONE)


def turned_tensor(R: Rows, entries: tuple[Fraction, ...]) -> tuple[Fraction, ...]:
    """``R I R^T`` of a symmetric tensor by its entries ``xx yy zz xy xz yz``."""
    xx, yy, zz, xy, xz, yz = entries
    tensor: Rows = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    whole = product(product(R, tensor), transposed(R))
    return whole[0][0], whole[1][1], whole[2][2], whole[0][1], whole[0][2], whole[1][2]


def near_quarter(radians: float, within: float) -> Angle:
    """The angle of ``radians``; a multiple of pi/2 where it is ``within`` [rad] of one; -pi < angle <= pi."""
    quarter = round(radians / (math.pi / 2))
    if abs(radians - quarter * (math.pi / 2)) <= within:
        return quarter_turns((quarter + 1) % 4 - 1)
    return angle(tidy(Fraction(math.remainder(radians, 2 * math.pi)), 1.0))


def direction(x: Fraction, y: Fraction, within: float) -> Angle:
    """The angle from the x axis to the point ``x, y``."""
    return near_quarter(math.atan2(y, x), within)


def summed(one: Angle, other: Angle) -> Angle:
    """The sum of both, whole quarters where both are."""
    if one.quarter is not None and other.quarter is not None:
        return quarter_turns((one.quarter + other.quarter + 1) % 4 - 1)
    total = _radians(one) + _radians(other)
    return near_quarter(float(total - 2 * PI * round(total / (2 * PI))), QUARTER_TURN)


def _radians(turn: Angle) -> Fraction:
    return Fraction(turn.radians) if turn.quarter is None else PI / 2 * turn.quarter


def tidy(x: Fraction, size: float) -> Fraction:
    """``x`` as a short decimal: 0 where it is nothing beside ``size``; the decimal of few places that is this
    but for rounding; else the shortest that is the same double."""
    value = float(x)
    if abs(value) <= NOTHING * size:
        return ZERO
    short = shortest(value)
    decimal = Fraction(round(x * 10**DECIMALS), 10**DECIMALS)
    return short if short == x or abs(decimal - x) > Fraction(NOISE * size) else decimal


def placement(R: Rows, origin: Exact, size: float, within: float = QUARTER_TURN) -> Placement | None:
    """The frame with the rotation ``R`` at ``origin`` [m], of an arm of ``size`` [m]; None: the parent frame.

    Yaw first, then pitch of what is left, then roll: near pitch +-pi/2 yaw alone means little, but all three
    together are right.
    """
    yaw = (
        direction(R[0][0], R[1][0], within) if max(abs(R[0][0]), abs(R[1][0])) > within else quarter_turns(0)
    )
    left = product(about_z(-yaw), R)
    pitch = direction(left[0][0], -left[2][0], within)
    left = product(about_y(-pitch), left)
    roll = direction(left[1][1], left[2][1], within)
    x, y, z = (tidy(entry, size) for entry in origin)
    frame = Placement((x, y, z), (roll, pitch, yaw))
    return None if frame.xyz == (ZERO, ZERO, ZERO) and frame.rotation == SAME else frame
