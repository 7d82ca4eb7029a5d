"""Torques to 25 digits and more, by virtual work over exact rationals.

Nothing is shared with :mod:`robodyn.verify.reference`, not even the principle: frames are 4x4 transforms
``T_i`` in the base, differentiated twice in time; a link is its pseudo-inertia matrix ``J_i`` (the second
moments of its mass); and the torque of joint j is the work that all inertial and gravitational forces do
when joint j alone moves a little,

    tau_j = sum over i >= j of  trace(dT_i/dq_j J_i Tdd_i^T)  -  m_i g . (dT_i/dq_j c_i)

(J. J. Uicker 1965; R. Paul, Robot Manipulators, 6.60; the backward sum is J. M. Hollerbach's, 1980). Inputs
are rationals, so a double enters as exactly what it is; every operation is exact, and the only approximations
are sines and cosines, right to 1e-30.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from robodyn.robot.model import Link, Robot
from robodyn.robot.values import ZERO, circle_point
from robodyn.verify.numbers import Parameters, exact_value, filled

Matrix = list[list[Fraction]]
Number = int | float | Fraction

_ONE = Fraction(1)
_GRAIN = 1 << 120
#: Its fourth power is what a derivative neglects, and by so much it magnifies errors of torques.
_SLOPE_STEP = Fraction(1, 1 << 20)


def exact_torque(
    robot: Robot,
    q: Sequence[Number],
    qd: Sequence[Number],
    qdd: Sequence[Number],
    parameters: Parameters | None = None,
) -> list[Fraction]:
    """Inverse dynamics of one state, ``[n]`` each (rad or m, and per second): torques [N m or N].

    Right to about 1e-28 of the largest term. Smoothed friction (``rest_velocity``) is evaluated to the same.

    Raises
    ------
    InputError: a run-time parameter has no value.
    """
    values = filled(robot, parameters)
    n = robot.n
    speeds, rates = [Fraction(x) for x in qd], [Fraction(x) for x in qdd]
    T = [[Fraction(int(r == c)) for c in range(4)] for r in range(4)]
    Td, Tdd = _zeros(), _zeros()
    steps: list[Matrix] = []  # A_i
    slopes: list[Matrix] = []  # T_{i-1} dA_i/dq_i
    seconds: list[Matrix] = []  # d2T_i/dt2
    for link, position, v, a in zip(robot.links, q, speeds, rates, strict=True):
        A, A1, A2 = _step(link, Fraction(position), values)
        drive = _add(_scale(A2, v * v), _scale(A1, a))  # second derivative of A in time
        Tdd = _add(_add(_mul(Tdd, A), _scale(_mul(Td, A1), 2 * v)), _mul(T, drive))
        slopes.append(_mul(T, A1))
        Td = _add(_mul(Td, A), _scale(slopes[-1], v))
        T = _mul(T, A)
        steps.append(A)
        seconds.append(Tdd)
    gravity = [*robot.base_gravity, ZERO]
    D = _zeros()  # sum of A_{j+1..i} J_i Tdd_i^T over i >= j
    c = [ZERO] * 4  # sum of A_{j+1..i} m_i c_i
    tau = [ZERO] * n
    for j in reversed(range(n)):
        link = robot.links[j]
        J, first = _pseudo_inertia(link, values)
        D = _add(D, _mul(J, _transpose(seconds[j])))
        c = [x + y for x, y in zip(c, first, strict=True)]
        work = sum((_dot(row, column) for row, column in zip(slopes[j], _transpose(D), strict=True)), ZERO)
        tau[j] = work - _dot(gravity, [_dot(row, c) for row in slopes[j]])
        if robot.torque_side == "motor":
            joint = link.joint
            tau[j] += exact_value(joint.motor_inertia, values) * rates[j]
            tau[j] += exact_value(joint.viscous, values) * speeds[j]
            tau[j] += exact_value(joint.coulomb, values) * _way(speeds[j], robot.rest_velocity)
        D = _mul(steps[j], D)
        c = [_dot(row, c) for row in steps[j]]
    return tau


def exact_torque_slope(
    robot: Robot,
    q: Sequence[Number],
    qd: Sequence[Number],
    qdd: Sequence[Number],
    dq: Sequence[Number],
    dqd: Sequence[Number],
    parameters: Parameters | None = None,
) -> list[Fraction]:
    """Derivative of :func:`exact_torque` along the direction ``dq, dqd``, the accelerations constant; right
    to about 1e-25 of the largest term.

    By four torques without friction, whose difference formula is right to the fourth power of its step: with
    numbers of 28 digits that leaves more of them right than a double has. (Abramowitz and Stegun 25.3.6)
    """
    values = filled(robot, parameters)
    joints = [replace(link.joint, viscous=ZERO, coulomb=ZERO) for link in robot.links]
    links = tuple(replace(link, joint=joint) for link, joint in zip(robot.links, joints, strict=True))
    smooth = replace(robot, links=links)

    def torque(steps: int) -> list[Fraction]:
        at_q, at_qd = (
            [Fraction(x) + steps * _SLOPE_STEP * Fraction(d) for x, d in zip(xs, ds, strict=True)]
            for xs, ds in ((q, dq), (qd, dqd))
        )
        return exact_torque(smooth, at_q, at_qd, qdd, values)

    differences = zip(*(torque(steps) for steps in (1, -1, 2, -2)), strict=True)
    slopes = [(8 * (b - a) - (d - c)) / (12 * _SLOPE_STEP) for b, a, d, c in differences]
    for j, link in enumerate(robot.links if robot.torque_side == "motor" else ()):
        viscous, coulomb = (exact_value(x, values) for x in (link.joint.viscous, link.joint.coulomb))
        slopes[j] += Fraction(dqd[j]) * (viscous + coulomb * _way_slope(Fraction(qd[j]), robot.rest_velocity))
    return slopes


def exact_mass_matrix(
    robot: Robot, q: Sequence[Number], parameters: Parameters | None = None
) -> list[list[Fraction]]:
    """``[n, n]``: the torques of unit accelerations less those of none."""
    n = robot.n
    rest = [0] * n
    still = exact_torque(robot, q, rest, rest, parameters)
    columns = []
    for j in range(n):
        moving = exact_torque(robot, q, rest, [int(k == j) for k in range(n)], parameters)
        columns.append([x - y for x, y in zip(moving, still, strict=True)])
    return _transpose(columns)


def _step(link: Link, q: Fraction, values: Parameters) -> tuple[Matrix, Matrix, Matrix]:
    """A_i and its first and second derivative by the joint's variable."""
    joint = link.joint
    ca, sa = _grain(joint.alpha.cos), _grain(joint.alpha.sin)
    ct, st = _grain(joint.theta.cos), _grain(joint.theta.sin)
    a, b, d = (exact_value(x, values) for x in (joint.a, joint.b, joint.d))
    tilt = [[_ONE, ZERO, ZERO, a], [ZERO, ca, -sa, ca * b], [ZERO, sa, ca, sa * b], [ZERO] * 3 + [_ONE]]
    if joint.kind == "prismatic":
        slide = [[ct, -st, ZERO, ZERO], [st, ct, ZERO, ZERO], [ZERO, ZERO, _ONE, d + q], [ZERO] * 3 + [_ONE]]
        slide1 = [[ZERO] * 4, [ZERO] * 4, [ZERO, ZERO, ZERO, _ONE], [ZERO] * 4]
        return _mul(tilt, slide), _mul(tilt, slide1), _zeros()
    cq, sq = (_grain(x) for x in circle_point(q)) if q else (_ONE, ZERO)
    c, s = cq * ct - sq * st, sq * ct + cq * st
    turn = [[c, -s, ZERO, ZERO], [s, c, ZERO, ZERO], [ZERO, ZERO, _ONE, d], [ZERO] * 3 + [_ONE]]
    turn1 = [[-s, -c, ZERO, ZERO], [c, -s, ZERO, ZERO], [ZERO] * 4, [ZERO] * 4]
    turn2 = [[-c, s, ZERO, ZERO], [-s, -c, ZERO, ZERO], [ZERO] * 4, [ZERO] * 4]
    return _mul(tilt, turn), _mul(tilt, turn1), _mul(tilt, turn2)


def _pseudo_inertia(link: Link, values: Parameters) -> tuple[Matrix, list[Fraction]]:
    """J_i [4, 4] about the frame's origin and its last column, the first moments and the mass."""
    i = link.inertia
    xx, yy, zz = (exact_value(x, values) for x in (i.xx, i.yy, i.zz))
    xy, xz, yz = (exact_value(x, values) for x in (i.xy, i.xz, i.yz))
    half = (xx + yy + zz) / 2
    spread = [[half - xx, -xy, -xz], [-xy, half - yy, -yz], [-xz, -yz, half - zz]]
    m, com = exact_value(link.mass, values), [exact_value(x, values) for x in link.com]
    first = [m * x for x in com]
    J = [[spread[r][k] + first[r] * com[k] for k in range(3)] + [first[r]] for r in range(3)]
    return [*J, [*first, m]], [*first, m]


def _way(speed: Fraction, rest: Fraction | None) -> Fraction:
    """The sign of ``speed``, or tanh(speed / rest) to 30 digits."""
    if rest is None or speed == 0:
        return Fraction((speed > 0) - (speed < 0))
    x = abs(speed / rest)
    if x > 50:  # 1 - tanh(50) is 7e-44
        return Fraction(1 if speed > 0 else -1)
    halvings = 0
    while x > 1:
        x, halvings = x / 2, halvings + 1
    x = _grain(x, 4 * _GRAIN**2)
    term = total = _ONE
    for k in range(1, 64):  # exp(-2 x), 0 < 2 x <= 2: the last term is below 1e-69
        term = _grain(term * -2 * x / k, _GRAIN**2)
        total += term
    for _ in range(halvings):
        total = _grain(total * total, _GRAIN**2)
    result = (1 - total) / (1 + total)
    return _grain(result if speed > 0 else -result)


def _way_slope(speed: Fraction, rest: Fraction | None) -> Fraction:
    """The derivative of :func:`_way` by the speed; 0 where it has none."""
    return ZERO if rest is None else (1 - _way(speed, rest) ** 2) / rest


def _grain(x: Fraction, grain: int = _GRAIN) -> Fraction:
    """``x`` rounded to a multiple of ``1 / grain``: keeps the denominators powers of two (error 4e-37)."""
    return x if x.denominator == 1 else Fraction(round(x * grain), grain)


def _zeros() -> Matrix:
    return [[ZERO] * 4 for _ in range(4)]


def _transpose(A: Matrix) -> Matrix:
    return [list(column) for column in zip(*A, strict=True)]


def _add(A: Matrix, B: Matrix) -> Matrix:
    return [[x + y for x, y in zip(r, s, strict=True)] for r, s in zip(A, B, strict=True)]


def _scale(A: Matrix, factor: Fraction) -> Matrix:
    return [[factor * x for x in row] for row in A]


def _dot(a: Sequence[Fraction], b: Sequence[Fraction]) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True) if x and y), ZERO)


def _mul(A: Matrix, B: Matrix) -> Matrix:
    columns = _transpose(B)
    return [[_dot(row, column) for column in columns] for row in A]
