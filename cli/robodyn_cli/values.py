"""Values of options: numbers, points, lines, NAME=VALUE; and the option ``--param`` of many commands."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

import click

from robodyn.errors import InputError
from robodyn_cli.decorators import option

if TYPE_CHECKING:
    _Type = click.ParamType[Any]
else:
    _Type = click.ParamType  # generic for type checkers only

Command = TypeVar("Command", bound=Callable[..., Any])


#: Blanks between two numbers, and not between a number and an operator: before one, or before a sign that
#: belongs to one, and not behind an operator.
_BLANKS = re.compile(r"(?<=[^-+*/(\s])\s+(?=[^-+*/)\s]|[-+]\S)")


class Numbers(_Type):
    """Numbers separated by commas, or by blanks where there is no comma, written as in a robot file
    (``pi/2``). ``sign`` restricts them: ``positive``, or ``size`` (not negative)."""

    name = "numbers"

    def __init__(self, sign: str = "any", *, single: bool = False) -> None:
        self.sign, self.single = sign, single

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        from robodyn.robot.numbers import parse_number

        if not isinstance(value, str):  # a default
            return value
        parts = [value] if self.single else _parts(value)
        try:
            values = tuple(float(parse_number(part)) for part in parts)
        except InputError as error:
            self.fail(str(error), param, ctx)
        for x in values:
            if (self.sign == "positive" and not x > 0) or (self.sign == "size" and x < 0):
                expected = "more than 0" if self.sign == "positive" else "0 or more"
                self.fail(f"{x:g} is not {expected}", param, ctx)
        return values[0] if self.single else values


def _parts(value: str) -> list[str]:
    return value.split(",") if "," in value else _BLANKS.split(value.strip())


class Line(_Type):
    """``x,y,z:x,y,z``, a line between two points; or its end only."""

    name = "line"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        points = [Numbers().convert(part, param, ctx) for part in value.split(":")]
        if not 1 <= len(points) <= 2 or any(len(point) != 3 for point in points):
            self.fail(f"{value!r} is neither x,y,z:x,y,z nor x,y,z (m)", param, ctx)
        return tuple(points)


class Argument(_Type):
    """``name=text``."""

    name = "argument"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        name, equals, text = value.partition("=")
        if not equals:
            self.fail(f"{value!r} is not NAME=VALUE", param, ctx)
        return name.strip(), text


class Parameter(Argument):
    """``name=value``, a number."""

    name = "parameter"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        name, text = super().convert(value, param, ctx)
        return name, Numbers(single=True).convert(text, param, ctx)


class Point(Numbers):
    """``x,y,z``."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        point = super().convert(value, param, ctx)
        if len(point) != 3:
            self.fail(f"{value!r} is not x,y,z", param, ctx)
        return point


def parameter_option(what: str = "") -> Callable[[Command], Command]:
    """Add ``--param``, passed on as ``param: tuple[tuple[str, float], ...]``; ``what`` it is of."""
    text = f"Value of a run-time parameter (SI units){what}; may be repeated."
    return option("--param=NAME=VALUE", text, Parameter(), multiple=True)


ONE, POSITIVE, SIZE = Numbers(single=True), Numbers("positive", single=True), Numbers("size", single=True)
SEVERAL, POSITIVES, SIZES = Numbers(), Numbers("positive"), Numbers("size")


def unique(pairs: Sequence[tuple[str, Any]], option: str) -> dict[str, Any]:
    """The values by name.

    Raises
    ------
    InputError: a name stands there twice.
    """
    names = [name for name, _ in pairs]
    twice = [name for name in names if names.count(name) > 1]
    if twice:
        raise InputError(
            f"{option} has two values of one name", found=twice[0], remedy="leave one of the two out"
        )
    return dict(pairs)
