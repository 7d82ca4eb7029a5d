"""``robodyn flops``: operation counts, compared with the thesis's and with a budget."""

from __future__ import annotations

from typing import Any

import click

from robodyn.errors import CheckError
from robodyn_cli.code_options import prune_option, tolerance
from robodyn_cli.counted import effect_lines, lines, pruning_lines, record
from robodyn_cli.decorators import option, robot_argument
from robodyn_cli.options import (
    functions_option,
    fuse_option,
    listed,
    load,
    model_options,
    options_of,
    search_options,
    with_fused,
)
from robodyn_cli.output import as_json, echo_json
from robodyn_cli.progress import messages
from robodyn_cli.searching import Search


@click.command()
@robot_argument
@functions_option("inverse_dynamics", "Functions to count, separated by commas, or all.")
@fuse_option
@option("--budget=KIND=N,...", "Maximum operations, e.g. mul=208,add=152,total=360.")
@model_options
@search_options
@prune_option
def command(
    robot: str,
    functions: str,
    fuse: tuple[str, ...],
    wrench: bool,
    budget: str | None,
    prune: str | None,
    **model: Any,
) -> None:
    """Count multiplications and additions, and check them against a budget.

    Every binary * is one multiplication (by constants, by 2 and squares too), every binary + or - one
    addition; unary minus and sine/cosine are free and have their own columns. For example,
    fc3_x = 4.8*(a3_x - 0.07*lam3_12) is two multiplications and one addition. Exits with 1 if a budget is
    exceeded. With several functions or --formulation all, --json prints a list.
    """
    from dataclasses import replace

    from robodyn.counts import Count, count, parse_budget
    from robodyn.dynamics.functions import FUNCTIONS, NoSuchFunction
    from robodyn.kernels.generate import maker
    from robodyn.optimize.programs import FORMULATIONS
    from robodyn.optimize.prune import Pruning

    limit = None if budget is None else parse_budget(budget)
    chosen = (
        with_fused(tuple(FUNCTIONS) if functions == "all" else listed(functions), fuse, wrench=wrench) or ()
    )
    every = model["formulation"] == "all"
    formulations = tuple(FORMULATIONS) if every else (model["formulation"],)
    options = options_of(chosen, {**model, "formulation": formulations[0]}, prune=tolerance(prune))
    described = load(robot, strict=model["strict"])
    search = Search(*(model[name] for name in ("budget_seconds", "seed", "objective", "keep")))
    options = search.applied(described, options, chosen)
    choices = [
        (f, form, replace(options, functions=(f,), formulation=form)) for form in formulations for f in chosen
    ]
    counts: list[tuple[str, str, Count]] = []
    prunings: dict[tuple[str, str], Pruning] = {}
    rigid: dict[tuple[str, str], Count | None] = {}
    with messages() as tell:
        for f, form, one in choices:
            programs = maker(described, one, tell)
            try:
                counts.append((f, form, count(programs.program(f))))
            except NoSuchFunction:
                if functions != "all":
                    raise
                continue
            rigid[f, form] = programs.rigid_count(f)
            prunings.update({(name, form): pruning for name, pruning in programs.prunings.items()})
    if as_json():
        records = [
            record(described, f, form, c, rigid.get((f, form)), prunings.get((f, form)))
            for f, form, c in counts
        ]
        echo_json(records if len(choices) > 1 or every or functions == "all" else records[0])
    else:
        click.echo(f"{described.name}: {described.title}" if described.title else described.name)
        many = len(formulations) > 1
        rows = [(f"{f}, {form}" if many else f, f, form, c) for f, form, c in counts]
        for line in lines(described, rows):
            click.echo(line)
        for f, form, c in counts:
            for line in effect_lines({f: c}, {f: rigid.get((f, form))}):
                click.echo(line)
        for line in pruning_lines(prunings):
            click.echo(line)
    if limit is not None:
        over = [f"{described.name} {f}: {text}" for f, _, c in counts for text in limit.exceeded(c)]
        if over:
            raise CheckError("; ".join(over), remedy="raise the budget or simplify the model")
