"""Rotations of exact numbers: their angles, tensors that they turn, how what comes out is rounded, and angles
that were probably meant as degrees."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from robodyn.robot.numbers import brief, rounded, shortest
from robodyn.robot.parts import Exact, Inertia, JointKind, Limits, Placement, Rows, Vector
from robodyn.robot.values import PI, ZERO, Angle, angle, quarter_turns

QUARTER_TURN: float = 1e-11
"""[rad] An angle of a file this near to a multiple of pi/2 is that multiple, which was written with 12 digits
(1.57079632679 is off by 4.9e-12)."""

ONE_TURN: float = 6.2832
"""[rad] Angles beyond it are doubted: they were probably meant as degrees."""

SIX_TURNS: float = 40.0
"""[rad] Limits of a joint beyond it are doubted, if they are multiples of 5: as degrees are."""

MANY_TURNS: float = 720.0
"""[rad] Limits beyond it are no degrees either: no limits at all, probably."""

NOTHING: float = 1e-12
"""[share] Beside the arm's reach (of a tensor: its trace) a smaller number is 0."""

NOISE: float = 1e-15
"""[share] So much of the arm's reach sums of rounded numbers may be off: a decimal this near is meant."""

DECIMALS: int = 12
"""[decimal places] Of a decimal that is meant."""

WRITTEN: int = 17
"""[decimal places] Programs write doubles below 10 with so many; sums of such numbers are not rounded."""

_ONE = Fraction(1)
SAME: Rows = ((_ONE, ZERO, ZERO), (ZERO, _ONE, ZERO), (ZERO, ZERO, _ONE))


@dataclass(frozen=True, slots=True)
class Twist:
    """A rotation as ``Rz(phi) Rx(alpha) Rz(theta)``; with ``parallel`` z axes phi is 0, and may be any other
    angle that theta makes up for."""

    phi: Angle
    alpha: Angle
    theta: Angle
    parallel: bool


def limits_doubt(limits: Limits, kind: JointKind) -> str | None:
    """What is doubtful about the limits of position of a joint: whole degrees in the place of radians; or
    None."""
    if kind == "prismatic" or limits.position is None:
        return None
    low, high = limits.position
    if SIX_TURNS < max(-low, high) <= MANY_TURNS and low % 5 == 0 and high % 5 == 0:
        return f"{brief(low)} to {brief(high)} rad are more than six turns"
    return None


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


def turned_vector(R: Rows, u: Vector, *, exact: bool) -> Vector:
    """``R u``, rounded to double where it is not to be ``exact``: at other than right angles cosines are good
    to 1e-30 only, and their digits are of no use."""
    x, y, z = (row[0] * u[0] + row[1] * u[1] + row[2] * u[2] for row in R)
    return (x, y, z) if exact else (rounded(x), rounded(y), rounded(z))


def turned_inertia(R: Rows, inertia: Inertia, *, exact: bool) -> Inertia:
    """``R I R^T``, rounded as by :func:`turned_vector`."""
    i = inertia
    half = [
        turned_vector(R, column, exact=True)
        for column in ((i.xx, i.xy, i.xz), (i.xy, i.yy, i.yz), (i.xz, i.yz, i.zz))
    ]
    x, y, z = (turned_vector(R, row, exact=exact) for row in zip(*half, strict=True))
    return Inertia(xx=x[0], yy=y[1], zz=z[2], xy=x[1], xz=x[2], yz=y[2])


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
    but for rounding; itself where files write so many places; else the shortest that is the same double."""
    value = float(x)
    if abs(value) <= NOTHING * size:
        return ZERO
    short = shortest(value)
    decimal = Fraction(round(x * 10**DECIMALS), 10**DECIMALS)
    meant = abs(decimal - x) <= Fraction(NOISE * size) and shortest(float(decimal)) == decimal
    if meant and short != x:
        return decimal
    return x if 10**WRITTEN % x.denominator == 0 and abs(x) < 10 else short


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


def twist_of(R: Rows, within: float) -> Twist:
    """The angles of ``R``, multiples of pi/2 where they are ``within`` [rad] of them.

    Each is taken from what the ones before leave of ``R``: where z axes are nearly parallel, phi alone means
    little, and theta makes up for it.
    """
    sine = math.hypot(R[0][2], R[1][2])
    if sine <= within:
        alpha = quarter_turns(0 if R[2][2] > 0 else 2)
        phi = quarter_turns(0)
    else:
        alpha = near_quarter(math.atan2(sine, R[2][2]), within)
        phi = direction(-R[1][2], R[0][2], within)
    left = product(about_x(-alpha), product(about_z(-phi), R))
    return Twist(phi, alpha, direction(left[0][0], left[1][0], within), sine <= within)
