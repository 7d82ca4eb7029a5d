"""Options shared by the commands that write kernels: numbers, sines, order of operations, style, pruning."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from fractions import Fraction
from typing import Any, TypeVar

import click

from robodyn_cli.choices import CONTRACTIONS, ORDERS, TRIGONOMETRY, TargetOption
from robodyn_cli.common import add_options
from robodyn_cli.options import scalar_option

Command = TypeVar("Command", bound=Callable[..., Any])


def code_options(*, lists: Mapping[str, str], target_help: str = "") -> Callable[[Command], Command]:
    """Add them, passed under their own names; ``target_help`` is further help of ``--target``, with names of
    targets out of ``lists`` (:class:`.TargetOption`)."""

    return add_options(
        scalar_option,
        click.option(
            "--trig",
            type=TRIGONOMETRY,
            metavar="HOW",
            default="libm",
            show_default=True,
            help="Sine and cosine: libm, builtin (no library; the default of rust and javascript), given (in "
            "sc).",
        ),
        click.option(
            "--order",
            type=ORDERS,
            metavar="ORDER",
            default="auto",
            show_default=True,
            help="Order of operations: recursion (textbook order), registers (few live values), or auto "
            "(registers unless sine and cosine are from libm).",
        ),
        click.option(
            "--contraction",
            type=CONTRACTIONS,
            metavar="HOW",
            help="Let C compilers fuse products and sums: off or on.  [default: as their flags say]",
        ),
        click.option(
            "--target",
            metavar="NAME",
            cls=TargetOption,
            lists=dict(lists),
            help="Defaults of scalar, trig, order, contraction and objective for a processor: {compiled}. "
            f"Every option given on the command line overrides them.{target_help}",
        ),
        click.option(
            "--misra",
            is_flag=True,
            help="Write C for MISRA C:2012: the same operations with explicit parentheses.",
        ),
        click.option(
            "--readable",
            is_flag=True,
            help="Write the recursion in the book's order (--optimize none, --order recursion), each line "
            "named after its link and quantity.",
        ),
    )


def prune_option(command: Command) -> Command:
    """Add ``--prune TOL``, passed to `command` as ``prune: str | None``."""
    return click.option(
        "--prune",
        metavar="TOL",
        help="Drop terms that cannot matter within the joint limits; the error of each torque stays below "
        "TOL (1% or 0.01) of the joint's peak torque. Inverse dynamics, bias and gravity only.",
    )(command)


def tolerance(prune: str | None) -> Fraction | None:
    """The tolerance of ``--prune``."""
    if prune is None:
        return None
    from robodyn.optimize.prune import parse_tolerance

    return parse_tolerance(prune)


@contextmanager
def pruning_progress() -> Iterator[Callable[[str], None]]:
    """Progress of the pruning: a line on a terminal, nothing in a pipe."""
    from robodyn_cli.progress import line

    with line() as shown:
        yield lambda text: shown.tell(f"robodyn: {text}")
