"""From the units of a log's columns to SI units at the joints."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.logs.mapping import NUMBERS, Channel
from robodyn.logs.units import Unit, UnknownUnit, scaled, unit_of
from robodyn.robot.model import Robot
from robodyn.robot.names import shown
from robodyn.robot.values import PI

Floats = NDArray[np.float64]

#: The SI units of each group; N, m of a prismatic joint.
SI = {"t": "s", "q": "rad", "ql": "rad", "qd": "rad/s", "qdd": "rad/s^2", "tau": "N m"}
SI_PRISMATIC = {"t": "s", "q": "m", "ql": "m", "qd": "m/s", "qdd": "m/s^2", "tau": "N"}
#: A log whose times begin later [s] has dates for times: they count from the first sample instead.
DATES = 1e6


def convert(x: Floats, channel: Channel, group: str, joint: int, stated: str, robot: Robot | None) -> None:
    """Bring the column ``x`` [K] of ``joint`` (from 0) to SI units, in place.

    ``stated``: the unit that the file itself states, which the map's goes before.

    Raises
    ------
    InputError: the unit is not one of the group, or a number that it needs is nowhere.
    """
    prismatic = robot is not None and robot.links[joint].joint.kind == "prismatic"
    unit = _unit(channel, group, stated, prismatic=prismatic)
    factor = _factor(channel, group, joint, unit, robot, prismatic=prismatic)
    zero, offset = channel.number("zero", joint), channel.number("offset", joint)
    bits = channel.number("bits", joint)
    if bits:
        x[x >= 2.0 ** (int(bits) - 1)] -= 2.0 ** int(bits)
    if zero:
        x -= float(zero)
    scaled(x, factor * (channel.number("sign", joint) or 1))
    if offset:
        x += float(offset)


def seconds(x: Floats, channel: Channel, stated: str, origin: float | None = None) -> float | None:
    """Bring times ``x`` [K] to seconds, in place; dates count from the first sample, whose reading this
    returns: 0 where times are no dates, None where none of them is finite.

    ``origin``: what it has returned for earlier samples of the same stream.

    Raises
    ------
    InputError: the unit is none of time.
    """
    unit = _unit(channel, "t", stated, prismatic=False)
    factor = channel.number("factor", 0)
    if unit.kind == "ticks" and factor is None:
        raise _needs(channel, "t", unit, "factor", "seconds to a tick")
    factor = unit.factor * (factor or 1)
    zero, offset = channel.number("zero", 0), channel.number("offset", 0)
    if zero:
        x -= float(zero)
        origin = 0.0
    finite = x[np.isfinite(x)]
    if origin is None and len(finite):
        first = float(finite[0])
        origin = first if abs(first * float(factor)) > DATES else 0.0
    if origin:
        x -= origin
    scaled(x, factor * (channel.number("sign", 0) or 1))
    if offset:
        x += float(offset)
    return origin


def date_of(origin: float, channel: Channel, stated: str) -> float:
    """The ``origin`` of times in seconds."""
    factor = _unit(channel, "t", stated, prismatic=False).factor * (channel.number("factor", 0) or 1)
    return origin * float(factor)


def of_stamps(stamps: NDArray[np.int64], origin: int) -> Floats:
    """Seconds of ``stamps`` [K] in nanoseconds; dates count from ``origin`` [ns]."""
    if abs(origin) > DATES * 1e9:
        stamps = stamps - origin
    t: Floats = stamps / 1e9
    return t


def _unit(channel: Channel, group: str, stated: str, *, prismatic: bool) -> Unit:
    # A motor's angle drives a slide as well: the gear is then in rad/m.
    slide = prismatic and ("gear" in channel.numbers or "gear" in channel.of_robot)
    text = channel.unit
    if not text and stated:
        text = stated
    if not text:
        ticks = "counts_per_turn" in channel.numbers
        raw = "factor" in channel.numbers and group != "t"
        default = (SI_PRISMATIC if prismatic and not slide else SI)[group]
        text = f"ticks{SI[group][3:]}" if ticks else "raw" if raw else default
    try:
        unit = unit_of(text, group, prismatic=prismatic and not slide)
        if prismatic and not slide and unit.kind == "angle":
            raise UnknownUnit(
                "a prismatic joint has a gear between its motor and itself", text, "gear: rad/m"
            )
        return unit
    except UnknownUnit as error:
        remedy = None
        if not channel.unit and stated:
            remedy = f"that is what the file states: say the unit in the map, {group}: {{unit: ...}}"
        raise InputError(
            f"{group}: {error.what}",
            where=channel.place,
            found=shown(error.text),
            expected=error.expected,
            remedy=remedy,
        ) from None


def _factor(
    channel: Channel, group: str, joint: int, unit: Unit, robot: Robot | None, *, prismatic: bool
) -> Fraction:
    """SI units at the joint to a unit of the column."""
    gear = _of(channel, "gear", joint, robot)
    factor = unit.factor
    scale = channel.number("factor", joint)
    if unit.kind == "raw":
        if scale is None:
            raise _needs(channel, group, unit, "factor", NUMBERS["factor"])
    elif unit.kind == "ticks":
        counts = channel.number("counts_per_turn", joint)
        if counts is None and scale is None:
            raise _needs(channel, group, unit, "counts_per_turn", NUMBERS["counts_per_turn"])
        if counts is not None:
            factor = factor * 2 * PI / counts
    elif unit.kind == "current":
        constant = _of(channel, "torque_constant", joint, robot)
        if constant is None:
            constant = _described(robot, joint, "torque_constant")
            gear = gear if gear is not None else _described(robot, joint, "ratio")
        if constant is None:
            raise _needs(channel, group, unit, "torque_constant", NUMBERS["torque_constant"])
        factor = factor * constant
    elif unit.kind == "share":
        rated = channel.number("rated", joint)
        if rated is None:
            raise _needs(channel, group, unit, "rated", NUMBERS["rated"])
        factor = factor * rated
    if scale is not None:
        factor = factor * scale
    if gear is not None:
        factor = factor * gear if group == "tau" else factor / gear
    return factor


def _of(channel: Channel, key: str, joint: int, robot: Robot | None) -> Fraction | None:
    """The value at ``key``: the map's, or the description's where the map says so."""
    if key not in channel.of_robot:
        return channel.number(key, joint)
    value = _described(robot, joint, "ratio" if key == "gear" else key)
    if value is None:
        raise InputError(
            f"the description has no {key} for joint {joint + 1}",
            where=channel.place,
            found=f"{key}: robot",
            remedy=f"write gear: {{ratio: ..., torque_constant: ...}} at its link, or a number for {key}",
        )
    return value


def _described(robot: Robot | None, joint: int, key: str) -> Fraction | None:
    """``ratio`` or ``torque_constant`` of the gear that the description has for ``joint``, if it has one."""
    gear = None if robot is None else robot.links[joint].joint.gear
    if gear is None:
        return None
    return gear.ratio if key == "ratio" else gear.torque_constant


def _needs(channel: Channel, group: str, unit: Unit, key: str, meaning: str) -> InputError:
    where: Place = channel.place
    return InputError(
        f"{group} in {unit.name} needs a number",
        where=where,
        found=f"no {key}",
        expected=f"{key}: {meaning}",
        remedy=f"write {group}: {{columns: ..., unit: {unit.name}, {key}: ...}} in a map",
    )
