"""Ranges of a proof: the limits in the robot's file, unless other ones are given."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterator
from fractions import Fraction

from robodyn.errors import InputError
from robodyn.robot.model import Limits, Robot
from robodyn.robot.names import shown
from robodyn.robot.numbers import NumberError, parse_number

Range = tuple[Fraction, Fraction]

#: What a range may be given for, and how it is called in a robot's file.
ARRAYS = {"q": "position", "qd": "velocity", "qdd": "acceleration"}
_EXPECTED = "for example qd=3,qdd=10 or q2=-pi/2:pi/2: q, qd or qdd, a joint or none, and a bound or LOW:HIGH"
_EXAMPLES = {"q": "pi", "qd": "3", "qdd": "10"}
_KEY = re.compile(r"(qdd|qd|q)([1-9][0-9]{0,3})?\Z")


def with_ranges(robot: Robot, text: str | None) -> Robot:
    """``robot`` with the limits of ``text`` (``qd=3,qdd2=10,q=-pi/2:pi/2``) in place of its own.

    Raises
    ------
    InputError: it does not say what a range is, or a joint is left without one.
    """
    limits = [link.joint.limits for link in robot.links]
    for array, joint, (low, high) in () if text is None else _entries(text):
        if joint is not None and joint > robot.n:
            raise InputError(
                "a range for a joint that is not there",
                found=f"{array}{joint}",
                expected=f"a joint from 1 to {robot.n} of {robot.name}",
            )
        for i in range(robot.n) if joint is None else (joint - 1,):
            limits[i] = _changed(limits[i], array, low, high)
    _refuse_missing(robot, limits)
    links = tuple(
        dataclasses.replace(link, joint=dataclasses.replace(link.joint, limits=limit))
        for link, limit in zip(robot.links, limits, strict=True)
    )
    return dataclasses.replace(robot, links=links)


def _changed(limits: Limits, array: str, low: Fraction, high: Fraction) -> Limits:
    if array == "q":
        return dataclasses.replace(limits, position=(low, high))
    if low != -high:
        raise InputError(
            f"the range of {array} is not the same to both sides",
            found=f"{float(low):g} to {float(high):g}",
            expected="one bound of the size, as limits of speeds and accelerations are",
        )
    if array == "qd":
        return dataclasses.replace(limits, velocity=high)
    return dataclasses.replace(limits, acceleration=high)


def _refuse_missing(robot: Robot, limits: list[Limits]) -> None:
    for array, key in ARRAYS.items():
        lacking = [str(i) for i, limit in enumerate(limits, 1) if getattr(limit, key) is None]
        if lacking:
            raise InputError(
                f"{robot.name}: no proof without ranges",
                found=f"no limit of {key} at joint{'s' * (len(lacking) > 1)} {', '.join(lacking)}",
                remedy=f"write it in the robot's file, or give --ranges {array}={_EXAMPLES[array]}",
            )


def _entries(text: str) -> Iterator[tuple[str, int | None, Range]]:
    for part in text.split(","):
        key, equals, value = part.partition("=")
        if not equals:
            raise InputError("a range cannot be read", found=shown(part), expected=_EXPECTED)
        match = _KEY.match(key.strip())
        if match is None:
            raise InputError("a range of something unknown", found=shown(key.strip()), expected=_EXPECTED)
        yield match[1], int(match[2]) if match[2] else None, _range(value)


def _range(text: str) -> Range:
    low, colon, high = text.partition(":")
    try:
        first = parse_number(low)
        pair = (first, parse_number(high)) if colon else (-first, first)
    except NumberError as error:
        raise InputError(
            f"a range cannot be read: {error.what}", found=shown(text), expected=_EXPECTED
        ) from None
    if not pair[0] <= pair[1]:
        raise InputError(
            "a range is empty" if colon else "a bound is below zero",
            found=shown(text.strip()),
            expected="the smaller number first" if colon else "its size",
        )
    return pair
