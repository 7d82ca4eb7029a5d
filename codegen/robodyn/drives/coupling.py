"""Drives with a state: motors that run ahead of their links, and stateful effects."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from robodyn.drives.drive import Acting, JointDrive, Layer, Rates
from robodyn.effects.effect import Coupler, Memory
from robodyn.effects.scalars import exponential, is_duration, is_finite, is_zero, magnitude, sign, updated_if


class TwistState(NamedTuple):
    """How far a motor is ahead of its link [rad or m], and the first and second rates of that."""

    twist: Any
    rate: Any
    acceleration: Any


def link_rates(layer: Layer, measured: Rates, states: Mapping[int, TwistState]) -> Rates:
    """The links' motion where encoders may sit on the motors: places are the measured ones less the twist of
    before, rates the measured ones.

    Differences of the twist would be a loop: they make the torque of which they are, times the arm's inertia
    over the stiffness and the square of the step, and that grows without end.
    """
    q = list(measured.q)
    for i, drive in enumerate(layer.joints):
        if drive.coupler is not None and drive.coupler.values["encoder"] == "motor":
            q[i] = q[i] - states[i].twist
    return Rates(q, list(measured.qd), list(measured.qdd), measured.direction)


def next_twist(drive: JointDrive, passed: Any, before: TwistState, dt: Any) -> TwistState:
    """The twist ``dt`` later under the torque ``passed`` on; ``dt`` 0 sets it to rest.

    Rates are differences over ``dt``; damping lets the twist follow its value at rest exponentially. Where
    something is infinite or no number, or ``dt`` negative, all stays as it was before.
    """
    assert drive.coupler is not None
    coupler = coupler_of(drive.coupler)
    values = drive.coupler.values
    moving = sign(dt)
    # Not 0: what is divided by it or divides it is multiplied by 0 where dt is.
    span = magnitude(dt) + (1 - magnitude(moving))
    per_second = moving / span
    twist = coupler.twist(values, passed)
    lag = coupler.lag(values, passed)
    if not is_zero(lag):
        twist = twist + (before.twist - twist) * (exponential(-(span / lag)) * moving)
    rate = (twist - before.twist) * per_second
    acceleration = (rate - before.rate) * per_second * moving
    good = is_finite(magnitude(twist) + magnitude(rate) + magnitude(acceleration)) * is_duration(dt)
    return TwistState(
        updated_if(good, twist, before.twist),
        updated_if(good, rate, before.rate),
        updated_if(good, acceleration, before.acceleration),
    )


def motor_rates(layer: Layer, measured: Rates, states: Mapping[int, TwistState]) -> Rates:
    """The motors' motion: the links' and the twist."""
    q, qd, qdd = list(measured.q), list(measured.qd), list(measured.qdd)
    for i, drive in enumerate(layer.joints):
        if drive.coupler is not None and drive.coupler.values["encoder"] == "link":
            state = states[i]
            q[i], qd[i], qdd[i] = q[i] + state.twist, qd[i] + state.rate, qdd[i] + state.acceleration
    return Rates(q, qd, qdd, measured.direction)


def coupler_of(acting: Acting) -> Coupler:
    """The coupler of an effect that is one."""
    assert acting.effect.coupler is not None
    return acting.effect.coupler


def memory_of(acting: Acting) -> Memory:
    """The memory of an effect that has one."""
    assert acting.effect.memory is not None
    return acting.effect.memory
