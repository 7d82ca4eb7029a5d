"""Torques to 25 digits and more, by virtual work over exact rationals.

Nothing is shared with :mod:`robodyn.verify.reference`, not even the principle: the torque of joint j is the
work that all inertial and gravitational forces beyond it do when joint j alone moves a little. All that lies
beyond then turns about the joint's axis, or slides along it, as one body, so that the work is that of the
moment or the force that the joint transmits (:mod:`robodyn.verify.free_bodies`, whose frames are 4x4
transforms differentiated twice in time, and whose links are pseudo-inertia matrices).

Inputs are rationals, so a double enters as exactly what it is; every operation is exact, and the only
approximations are sines and cosines, right to 1e-30.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from decimal import Decimal, localcontext
from fractions import Fraction

import numpy as np

from robodyn.robot.model import Robot
from robodyn.robot.values import ZERO
from robodyn.verify.free_bodies import joint_reactions
from robodyn.verify.numbers import Parameters, exact_value, filled

Number = int | float | Fraction

#: Digits of an exponential, some of which a small argument cancels.
_DIGITS = 80
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
    at, speeds, rates = (np.array([[Fraction(x) for x in row]], object) for row in (q, qd, qdd))
    (reactions,) = joint_reactions(robot, at, speeds, rates, None, values, exact=True)
    tau = []
    for link, transmitted, v, a in zip(robot.links, reactions, speeds[0], rates[0], strict=True):
        joint = link.joint
        tau.append(transmitted[2 if joint.kind == "prismatic" else 5])
        if robot.torque_side == "motor":
            tau[-1] += exact_value(joint.motor_inertia, values) * a
            tau[-1] += exact_value(joint.viscous, values) * v
            tau[-1] += exact_value(joint.coulomb, values) * _way(v, robot.rest_velocity)
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


def _way(speed: Fraction, rest: Fraction | None) -> Fraction:
    """The sign of ``speed``, or tanh(speed / rest) to 30 digits."""
    sign = Fraction((speed > 0) - (speed < 0))
    if rest is None or speed == 0:
        return sign
    x = abs(speed / rest)
    with localcontext(prec=_DIGITS):
        fading = (-2 * Decimal(x.numerator) / x.denominator).exp()
        return sign * Fraction((1 - fading) / (1 + fading))


def _way_slope(speed: Fraction, rest: Fraction | None) -> Fraction:
    """The derivative of :func:`_way` by the speed; 0 where it has none."""
    return ZERO if rest is None else (1 - _way(speed, rest) ** 2) / rest
