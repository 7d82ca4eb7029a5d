"""``robodyn diff``: two robots beside each other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from robodyn.errors import CheckError
from robodyn_cli.choices import COMPARED, ROBOTS
from robodyn_cli.decorators import option
from robodyn_cli.output import printable, show, wrapped
from robodyn_cli.robot_files import load_robot
from robodyn_cli.values import parameter_option

if TYPE_CHECKING:
    from robodyn.compare.robots import Comparison, Difference


@click.command()
@click.argument("left", type=ROBOTS, metavar="ROBOT")
@click.argument("right", type=ROBOTS, metavar="ROBOT")
@option(
    "--tolerance=SHARE",
    "Share by which numbers may differ (angles: rad); default: 1e-9.",
    click.FloatRange(0, 1),
)
@option("--ignore=WHAT,...", "Leave differences out: names, limits, links, ...", COMPARED)
@parameter_option(" of both")
def command(
    left: str,
    right: str,
    tolerance: float | None,
    ignore: str | None,
    param: Sequence[tuple[str, float]],
) -> None:
    """Compare two robots: numbers, frames, torques, operation counts.

    Joints correspond by their order. Links and axes are compared where they are at the zero position, so that
    the choice of frames does not matter; torques and tool poses at random states within the limits of the
    first robot. Exits 1 if anything differs.
    """
    from robodyn.compare import TOLERANCE
    from robodyn.compare.robots import compare

    comparison = compare(
        load_robot(left),
        load_robot(right),
        tolerance=TOLERANCE if tolerance is None else tolerance,
        ignore=[word for word in (ignore or "").replace(" ", "").split(",") if word],
        parameters=dict(param) or None,
    )
    show(
        comparison.to_dict,
        lambda: (*(line for text in _lines(comparison) for line in wrapped(text)), *_summary(comparison)),
    )
    if not comparison.same:
        groups = ", ".join(dict.fromkeys(difference.group for difference in comparison.differences))
        raise CheckError(f"{printable(left)} and {printable(right)} differ", found=groups)


def _lines(comparison: Comparison) -> list[str]:
    """A line for each difference; the same one at several joints on one line."""
    places: dict[str, list[str]] = {}
    heads: dict[str, str] = {}
    for difference in comparison.differences:
        text = _text(difference)
        heads[text] = difference.group
        places.setdefault(text, []).extend([difference.where] if difference.where else [])
    return [
        f"{heads[text]}: {', '.join(joints)}: {text}" if joints else f"{heads[text]}: {text}"
        for text, joints in places.items()
    ]


def _text(difference: Difference) -> str:
    unit = f" {difference.unit}" if difference.unit else ""
    apart = "" if difference.by is None else f" (by {difference.by:.3g}{unit})"
    if difference.left is None and difference.right is None:
        return f"{difference.what}{apart}"
    both = " -> ".join(_value(value) for value in (difference.left, difference.right))
    return f"{difference.what} {both}{unit}{apart}"


def _value(value: Any) -> str:
    if value is None:
        return "nothing"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_value, value)) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{name}: {_value(part)}" for name, part in value.items()) + "}"
    return str(value)


def _summary(comparison: Comparison) -> list[str]:
    lines = []
    if comparison.operations is not None:
        one, other = comparison.operations
        lines.append(f"operations of the inverse dynamics: {one} and {other}")
    if comparison.share is not None:
        lines.append(
            f"torques: within {comparison.share:.1e} of the largest, {comparison.largest:.4g} N m or N"
        )
    if comparison.tool is not None:
        distance, angle = comparison.tool
        lines.append(f"tool: within {distance:.1e} m and {angle:.1e} rad")
    lines += [f"not compared: {text}" for text in comparison.not_compared]
    if comparison.same:
        lines.append(f"nothing {'that was compared ' if comparison.not_compared else ''}differs")
    return lines
