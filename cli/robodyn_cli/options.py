"""Options shared by ``gen``, ``flops`` and ``verify``: the model and its optimisation."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

import click

from robodyn.errors import InputError
from robodyn_cli.choices import ENGINES, FORMULATIONS, LEVELS, OBJECTIVES, SCALARS, SEVERAL_FUNCTIONS
from robodyn_cli.decorators import add_options, flag, option

if TYPE_CHECKING:
    from robodyn.kernels.generate import Options
    from robodyn.robot import Robot

Command = TypeVar("Command", bound=Callable[..., Any])


model_options = add_options(
    option(
        "--formulation=F",
        "Formulation: modified_newton_euler (lambda matrix), newton_euler, newton_euler_base, orin, "
        "balafoutis, kane, lagrange_3x3, lagrange_4x4 or lagrange.",
        FORMULATIONS,
        default="modified_newton_euler",
    ),
    option(
        "--optimize=LEVEL",
        "Optimisation: none (textbook recursion), fast, record (the best known program for exactly this "
        "arm, else fast), search (formulation variants) or full (also algebraic identities).",
        LEVELS,
        default="record",
    ),
    flag("--no-regroup", "Do not regroup to base parameters."),
    option(
        "--engine=NAME",
        "Engine: graph, or sympy as a cross-check (slower, no smaller, without records and searches).",
        ENGINES,
        default="graph",
    ),
    flag("--strict", "Refuse physically implausible values."),
)
"""Add the options that select the model and its optimisation."""


#: Adds ``--scalar``, passed as ``scalar: str``.
scalar_option = option("--scalar=TYPE", "Scalar type: double or float.", SCALARS, default="double")


def _objectives() -> str:
    from robodyn.targets import all_targets

    return (
        "Objective of record, search and full: total, mul, fma (fused multiply-adds), depth "
        f"(longest chain), sincos, or weighted:TARGET ({', '.join(target.name for target in all_targets())})."
    )


search_options = add_options(
    option("--budget-seconds=S", "Time limit of search and full.", float),
    option("--seed=N", "Seed of search and full.", int, default=0),
    option("--objective=WHAT", _objectives, OBJECTIVES, default="total"),
    flag("--keep", "Save the result in the folder records beside ROBOT."),
)
"""Add the options of a search: time budget, seed, objective, and whether to save the result."""


def load(robot: str, *, strict: bool) -> Robot:
    """The robot that the options name; warnings about implausible values go to stderr.

    Raises
    ------
    InputError: the robot cannot be read, or ``--engine sympy`` is to take records or to search.
    """
    from robodyn_cli.robot_files import load_robot

    _check_engine()
    return load_robot(robot, strict=strict)


#: Levels that only the graph engine has.
_OF_GRAPH = ("record", "search", "full")


def _check_engine() -> None:
    """Say, or refuse if it was asked for, that ``--engine sympy`` neither takes records nor searches."""
    context = click.get_current_context()
    level = context.params.get("optimize")
    if context.params.get("engine") != "sympy" or level not in _OF_GRAPH:
        return
    from click.core import ParameterSource

    from robodyn_cli.output import talk

    if context.get_parameter_source("optimize") is not ParameterSource.DEFAULT:
        raise InputError(
            f"--optimize {level} needs the graph engine: sympy builds the recursion itself",
            found=f"--engine sympy --optimize {level}",
            expected="--optimize none or fast with --engine sympy",
            remedy="remove one of them",
        )
    talk(f"robodyn: note: --engine sympy takes no record ({level} is the default level): --optimize fast")


def listed(text: str) -> tuple[str, ...]:
    """``a,b`` as ``("a", "b")``."""
    return tuple(part.strip() for part in text.split(",") if part.strip())


def functions_option(default: str | None = None, text: str | None = None) -> Callable[[Command], Command]:
    """Add ``--functions``, passed to the command as ``functions: str | None``, names separated by commas;
    without ``default`` those that are written by default. ``text`` is the help."""
    without = "" if default else "  [default: all but those on request]"

    what = text or f"Functions, separated by commas, or all that ROBOT has.{without}"
    return option(
        "--functions --function=A,B functions",
        f'{what}  "robodyn functions" lists them.',
        SEVERAL_FUNCTIONS,
        multiple=True,
        default=None if default is None else (default,),
        show_default=default or False,
        callback=_joined,
    )


fuse_option = add_options(
    option(
        "--fuse=A,B",
        "Write A_and_B as well, which gives the results of both (or of more) and shares their work. "
        "Without --functions nothing else is written.",
        SEVERAL_FUNCTIONS,
        multiple=True,
    ),
    flag(
        "--wrench",
        "Torques, accelerations and forces in the joints with a wrench on the tool as a further input: the "
        "functions ..._with_wrench in place of those without.",
    ),
)
"""Adds ``--fuse`` and ``--wrench``, passed as ``fuse: tuple[str, ...]`` and ``wrench: bool``, see
:func:`with_fused`."""


def with_fused(
    functions: Sequence[str] | None, fuse: Sequence[str], *, wrench: bool
) -> tuple[str, ...] | None:
    """``functions``, and those that ``--fuse`` asks for, with a ``wrench`` if there is one; None where
    nothing is asked for."""
    from robodyn.dynamics.functions.fusing import AND

    if functions is None and not fuse and not wrench:
        return None
    if wrench:
        from robodyn.dynamics.functions import by_default, pushed

        functions = [pushed(name) for name in functions or (() if fuse else by_default())]
        fuse = [",".join(pushed(name) for name in listed(text)) for text in fuse]
    for text in fuse:
        if len(listed(text)) < 2:
            raise InputError(
                "one function alone cannot be fused",
                found=f"--fuse {text}",
                expected="two or more: --fuse a,b",
            )
    return (*(functions or ()), *(AND.join(listed(text)) for text in fuse))


def _joined(ctx: click.Context, param: click.Parameter, value: tuple[str, ...] | None) -> str | None:
    """``--functions a --functions b,c`` as ``a,b,c``."""
    return ",".join(value) if value else None


def one_function(functions: str) -> str:
    """The one function of ``--functions``, for commands that work on one at a time.

    Raises
    ------
    InputError: there are several, or none.
    """
    names = listed(functions)
    if len(names) != 1:
        raise InputError(
            "this command works on one function at a time",
            found=f"--functions {functions}",
            expected="one function",
            remedy="run it once for each",
        )
    return names[0]


def options_of(
    functions: Sequence[str] | None, model: Mapping[str, Any], *, target: str | None = None, **others: Any
) -> Options:
    """The options of the kernels of ``functions`` as those of :data:`model_options`, in ``model``, say; of
    the rest, what ``others`` lack is as fits the ``target``."""
    from robodyn.kernels.generate import Options

    for name in ("formulation", "optimize", "engine"):
        others[name] = model[name]
    others |= {"regroup": not model["no_regroup"], "functions": functions and tuple(functions)}
    return Options(**others) if target is None else Options.for_target(target, **others)
