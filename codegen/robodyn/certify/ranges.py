"""Ranges of a proof: the limits in the robot's file, unless other ones are given."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterator
from fractions import Fraction

from robodyn.errors import InputError, Place
from robodyn.robot import document
from robodyn.robot.model import Limits, Robot
from robodyn.robot.names import shown
from robodyn.robot.numbers import NumberError, parse_number

Range = tuple[Fraction, Fraction]

#: What a range may be given for, and how it is called in a robot's file.
ARRAYS = {"q": "position", "qd": "velocity", "qdd": "acceleration"}
_EXPECTED = "for example qd=3,qdd=10 or q2=-pi/2:pi/2: q, qd or qdd, a joint or none, and a bound or LOW:HIGH"
_EXAMPLES = {"q": "pi", "qd": "3", "qdd": "10"}
_KEY = re.compile(r"(qdd|qd|q)([1-9][0-9]{0,3})?\Z")


def with_ranges(robot: Robot, text: str | None, file: bytes | None = None) -> Robot:
    """``robot`` with the limits of ``text`` (``qd=3,qdd2=10,q=-pi/2:pi/2``) or of a YAML ``file``, whose name
    ``text`` then is, in place of its own.

    Raises
    ------
    InputError: neither says what a range is, or a joint is left without one.
    """
    entries: list[tuple[str, int | None, Range, Place | None]] = []
    if file is not None:
        entries = list(_of_file(file, text or "<ranges>"))
    elif text is not None:
        entries = list(_of_text(text))
    limits = [link.joint.limits for link in robot.links]
    for array, joint, (low, high), place in entries:
        if joint is not None and joint > robot.n:
            raise InputError(
                "a range for a joint that is not there",
                where=place,
                found=f"{array}{joint}",
                expected=f"a joint from 1 to {robot.n} of {robot.name}",
            )
        for i in range(robot.n) if joint is None else (joint - 1,):
            limits[i] = _changed(limits[i], array, low, high, place)
    _refuse_missing(robot, limits)
    links = tuple(
        dataclasses.replace(link, joint=dataclasses.replace(link.joint, limits=limit))
        for link, limit in zip(robot.links, limits, strict=True)
    )
    return dataclasses.replace(robot, links=links)


def _changed(limits: Limits, array: str, low: Fraction, high: Fraction, place: Place | None) -> Limits:
    if array == "q":
        return dataclasses.replace(limits, position=(low, high))
    if low != -high:
        raise InputError(
            f"the range of {array} is not the same to both sides",
            where=place,
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


def _of_text(text: str) -> Iterator[tuple[str, int | None, Range, None]]:
    for part in text.split(","):
        key, equals, value = part.partition("=")
        if not equals:
            raise InputError("a range cannot be read", found=shown(part), expected=_EXPECTED)
        array, joint = _key(key.strip(), None)
        yield array, joint, _range(value, None), None


def _of_file(data: bytes, file: str) -> Iterator[tuple[str, int | None, Range, Place]]:
    root = document.compose(document.decode(data, file), file)
    if not isinstance(root, document.Mapping):
        raise InputError(
            "ranges are a mapping", where=Place(file, root.line, root.column), expected=_EXPECTED
        )
    for key, node in root.entries:
        place = Place(file, key.line, key.column)
        array, joint = _key(key.text, place)
        if isinstance(node, document.Sequence) and joint is None:
            for i, item in enumerate(node.items, 1):
                at = Place(file, item.line, item.column)
                yield array, i, _range(_word(item, at), at), at
        else:
            at = Place(file, node.line, node.column)
            yield array, joint, _range(_word(node, at), at), at


def _word(node: document.Node, place: Place) -> str:
    if not isinstance(node, document.Scalar):
        raise InputError(
            "a range cannot be read",
            where=place,
            found=document.describe(node),
            expected="a bound or LOW:HIGH; for all joints a list of them",
        )
    return node.text


def _key(text: str, place: Place | None) -> tuple[str, int | None]:
    match = _KEY.match(text)
    if match is None:
        raise InputError("a range of something unknown", where=place, found=shown(text), expected=_EXPECTED)
    return match[1], int(match[2]) if match[2] else None


def _range(text: str, place: Place | None) -> Range:
    low, colon, high = text.partition(":")
    try:
        first = parse_number(low)
        pair = (first, parse_number(high)) if colon else (-first, first)
    except NumberError as error:
        raise InputError(
            f"a range cannot be read: {error.what}", where=place, found=shown(text), expected=_EXPECTED
        ) from None
    if not pair[0] <= pair[1]:
        raise InputError(
            "a range is empty" if colon else "a bound is below zero",
            where=place,
            found=shown(text.strip()),
            expected="the smaller number first" if colon else "its size",
        )
    return pair
