"""The option ``--prune``: parsing, progress on a terminal, and results."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from fractions import Fraction
from typing import TYPE_CHECKING, Any, TypeVar

import click

if TYPE_CHECKING:
    from robodyn.optimize.prune import Pruning

Command = TypeVar("Command", bound=Callable[..., Any])


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


def with_pruning(record: dict[str, Any], pruning: Pruning | None) -> dict[str, Any]:
    """A count's record with the object ``prune``, if its function was pruned."""
    return record if pruning is None else {**record, "prune": pruning.to_dict()}


def pruning_lines(prunings: Mapping[Any, Pruning]) -> list[str]:
    """Lines about the pruning errors, for people."""
    if not prunings:
        return []
    from robodyn.optimize.prune import notes_of

    return list(notes_of(tuple(prunings.values())))
