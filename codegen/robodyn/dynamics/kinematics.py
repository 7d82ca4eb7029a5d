"""Forward kinematics, the geometric Jacobian and its time derivative, over any scalar.

Source: Craig, Introduction to Robotics, 3.6 (frames), 5.6 to 5.8 (velocities, Jacobian). The time
derivative of a column of the Jacobian follows from the rates of its joint axis and of its lever arm.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.arm import Arm, Motion
from robodyn.dynamics.vectors import BASE, ZERO, Frame, Vector, cross, minus, plus, scaled
from robodyn.effects.scalars import is_zero

#: Rows of scalars.
Matrix = list[list[Any]]


def frames(arm: Arm, motion: Motion, base: Frame = BASE) -> list[Frame]:
    """Frames of the links [n] of ``arm`` at the state ``motion``. ``base`` is the base frame of the arm in
    the frame of the results (by default the same)."""
    poses = []
    last = base
    for body, c, s, d in zip(arm.bodies, motion.c, motion.s, motion.d, strict=True):
        x = last.x
        y = plus(scaled(body.cos_alpha, last.y), scaled(body.sin_alpha, last.z))
        z = minus(scaled(body.cos_alpha, last.z), scaled(body.sin_alpha, last.y))
        origin = plus(last.origin, scaled(body.a, x), scaled(d, z))
        if not is_zero(body.b):
            origin = plus(origin, scaled(body.b, y))
        last = Frame(origin, plus(scaled(c, x), scaled(s, y)), minus(scaled(c, y), scaled(s, x)), z)
        poses.append(last)
    return poses


def jacobian(arm: Arm, placed: Sequence[Frame], point: Vector = ZERO, link: int | None = None) -> Matrix:
    """Geometric Jacobian [6, n] of ``point`` [m] in the frame of ``link`` (1..n, by default the last).

    Column j is the velocity of the point (three rows) and the angular velocity of the link (three rows) at a
    unit rate of joint j, in base axes. ``placed`` are the links' :func:`frames`.
    """
    last = len(placed) if link is None else link
    tip = placed[last - 1].place(point)
    linear: list[Vector] = []
    angular: list[Vector] = []
    for body, frame in zip(arm.bodies[:last], placed, strict=False):
        linear.append(cross(frame.z, minus(tip, frame.origin)) if body.revolute else frame.z)
        angular.append(frame.z if body.revolute else ZERO)
    return _matrix(linear, angular, len(placed))


def jacobian_rate(
    arm: Arm, placed: Sequence[Frame], qd: Sequence[Any], point: Vector = ZERO, link: int | None = None
) -> Matrix:
    """Time derivative [6, n] of :func:`jacobian` at the joint rates ``qd`` [n] (rad/s or m/s)."""
    last = len(placed) if link is None else link
    tip = placed[last - 1].place(point)
    w: Vector = ZERO
    v: Vector = ZERO
    parent = BASE
    carriers = []  # angular velocity of the link before joint j, velocity of the origin of frame j
    for body, frame, rate in zip(arm.bodies[:last], placed, qd, strict=False):
        v = plus(v, cross(w, minus(frame.origin, parent.origin)))
        carrier_w = w
        if body.revolute:
            w = plus(w, scaled(rate, frame.z))
        else:
            v = plus(v, scaled(rate, frame.z))
        carriers.append((carrier_w, v))
        parent = frame
    tip_velocity = plus(v, cross(w, minus(tip, parent.origin)))
    linear: list[Vector] = []
    angular: list[Vector] = []
    for body, frame, (carrier_w, velocity) in zip(arm.bodies[:last], placed, carriers, strict=False):
        axis_rate = cross(carrier_w, frame.z)
        if body.revolute:
            lever, lever_rate = minus(tip, frame.origin), minus(tip_velocity, velocity)
            linear.append(plus(cross(axis_rate, lever), cross(frame.z, lever_rate)))
            angular.append(axis_rate)
        else:
            linear.append(axis_rate)
            angular.append(ZERO)
    return _matrix(linear, angular, len(placed))


def _matrix(linear: Sequence[Vector], angular: Sequence[Vector], n: int) -> Matrix:
    """The Jacobian [6, n] from its columns; those of joints beyond the link are zero."""
    zeros = [0] * (n - len(linear))
    return [[u[axis] for u in half] + zeros for half in (linear, angular) for axis in range(3)]
