"""Options that ``gen``, ``flops`` and ``verify`` share: which model, how optimised."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

import click

if TYPE_CHECKING:
    from robodyn.robot import Robot

Command = TypeVar("Command", bound=Callable[..., Any])


def model_options(command: Command) -> Command:
    """Add the options that choose the model and how it is optimised."""
    for option in reversed(
        (
            click.option(
                "--formulation",
                metavar="F",
                default="modified_newton_euler",
                show_default=True,
                help="modified_newton_euler (lambda matrix), newton_euler, balafoutis, kane, lagrange_3x3, "
                "lagrange_4x4 or lagrange.",
            ),
            click.option(
                "--optimize",
                metavar="LEVEL",
                default="fast",
                show_default=True,
                help="none (the recursion as the book has it) or fast.",
            ),
            click.option("--no-regroup", is_flag=True, help="Leave out base-parameter regrouping."),
            click.option(
                "--engine",
                metavar="NAME",
                default="graph",
                show_default=True,
                help="graph, or sympy: the same model through sympy, as a cross-check.",
            ),
            click.option(
                "--fold-rotor",
                is_flag=True,
                help="Fold rotor inertias into Izz of the links, as the thesis does.",
            ),
            click.option("--strict", is_flag=True, help="Refuse physically doubtful numbers."),
        )
    ):
        command = option(command)
    return command


def load(robot: str, *, strict: bool, fold_rotor: bool) -> Robot:
    """The robot that the options name; doubts about its numbers go to stderr."""
    from robodyn_cli.common import load_robot

    found = load_robot(robot, strict=strict)
    if fold_rotor:
        from robodyn.robot import fold_rotor as fold

        found = fold(found)
    return found


def listed(text: str) -> tuple[str, ...]:
    """``a,b`` as ``("a", "b")``."""
    return tuple(part.strip() for part in text.split(",") if part.strip())
