"""What a joint adds to the torque of its link: rotor inertia and friction."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm, Motion
from robodyn.dynamics.state import Rotor
from robodyn.dynamics.vectors import Mark
from robodyn.effects.scalars import is_zero, sign, tangent
from robodyn.ir.program import Label


def smoothed_sign(velocity: Any, rest_velocity: Any | None, dead_band: Any | None = None) -> Any:
    """sgn(velocity) with sgn 0 = 0; tanh(velocity / rest_velocity); or 0 within the dead band."""
    if rest_velocity is not None:
        return tangent(velocity / rest_velocity)
    if dead_band is not None:
        twice = sign(velocity - dead_band) + sign(velocity + dead_band)
        return Fraction(twice, 2) if isinstance(twice, int) else twice / 2
    return sign(velocity)


def friction_slope(arm: Arm, i: int, qd: Any) -> Any:
    """Derivative [N m s/rad, N s/m] of the friction of joint ``i`` (from 0) by its velocity; that of the sign
    is taken to be 0."""
    body, total = arm.bodies[i], 0
    if not is_zero(body.viscous):
        total = total + body.viscous
    if not is_zero(body.coulomb) and arm.rest_velocity is not None:
        share = tangent(qd / arm.rest_velocity)
        total = total + (body.coulomb / arm.rest_velocity) * (1 - share * share)
    return total


def joint_torque(arm: Arm, i: int, motion: Motion, torque: Any, mark: Mark) -> Any:
    """Torque [N m or N] of joint ``i`` (from 0): ``torque`` of the links, rotor and friction added."""
    body = arm.bodies[i]
    qd, qdd = motion.qd[i], motion.qdd[i]
    total = torque
    if not is_zero(body.motor_inertia):
        # The reflected rotor turns with its own joint only: N^2 J on the diagonal, not in Izz.
        total = total + body.motor_inertia * qdd
    if not is_zero(qd):
        if not is_zero(body.viscous):
            total = total + body.viscous * qd
        if not is_zero(body.coulomb):
            total = total + body.coulomb * smoothed_sign(qd, arm.rest_velocity, arm.dead_band)
    return mark(total, Label(i + 1, "tau", ""))


def rotors_of(arm: Arm) -> list[Rotor]:
    """The rotors of ``arm`` that have inertia, each turning with its own joint."""
    return [
        Rotor(body.motor_inertia, ((i, 1),))
        for i, body in enumerate(arm.bodies)
        if not is_zero(body.motor_inertia)
    ]
