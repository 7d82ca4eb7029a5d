"""Options shared by the commands that write kernels: numbers, sines, order of operations, style, pruning."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, TypeVar

from robodyn_cli.choices import CONTRACTIONS, ORDERS, TARGETS, TRIGONOMETRY
from robodyn_cli.decorators import add_options, flag, option
from robodyn_cli.options import scalar_option

Command = TypeVar("Command", bound=Callable[..., Any])


def code_options(*, firmware: bool = False) -> Callable[[Command], Command]:
    """Add them, passed under their own names; with ``firmware``, ``--target`` is of images as well."""

    def target() -> str:
        from robodyn.targets import compiled_targets, firmware_targets

        text = (
            "Defaults of scalar, trig, order, contraction and objective for a processor: "
            f"{', '.join(target.name for target in compiled_targets())}. "
            "Every option given on the command line overrides them."
        )
        images = ", ".join(target.name for target in firmware_targets())
        of_images = (
            f"processors of the images, separated by commas: {images}.  [default with --firmware: all]"
        )
        return f"{text} With --firmware: {of_images}" if firmware else text

    return add_options(
        scalar_option,
        option(
            "--trig=HOW",
            "Sine and cosine: libm, builtin (no library; default of rust, javascript, cuda), given (in sc).",
            TRIGONOMETRY,
            default="libm",
        ),
        option(
            "--order=ORDER",
            "Order of operations: recursion (textbook order), registers (few live values), or auto "
            "(registers unless sine and cosine are from libm).",
            ORDERS,
            default="auto",
        ),
        option(
            "--contraction=HOW",
            "Let C compilers fuse products and sums: off or on.  [default: as their flags say]",
            CONTRACTIONS,
        ),
        option("--target=NAME", target, TARGETS),
        flag("--misra", "Write C for MISRA C:2012: the same operations with explicit parentheses."),
        flag(
            "--readable",
            "Write the recursion in the book's order (--optimize none, --order recursion), each line named "
            "after its link and quantity.",
        ),
    )


#: Adds ``--prune TOL``, passed as ``prune: str | None``.
prune_option = option(
    "--prune=TOL",
    "Drop terms that cannot matter within the joint limits; the error of each torque stays below TOL "
    "(1% or 0.01) of the joint's peak torque. Inverse dynamics, bias and gravity only.",
)


def tolerance(prune: str | None) -> Fraction | None:
    """The tolerance of ``--prune``."""
    if prune is None:
        return None
    from robodyn.optimize.prune import parse_tolerance

    return parse_tolerance(prune)
