"""``robodyn effects``: the catalogue of effects beyond the rigid arm."""

from __future__ import annotations

import click

from robodyn_cli.choices import EFFECTS
from robodyn_cli.decorators import at_most_one, flag
from robodyn_cli.output import as_json, echo_json


@click.command()
@click.argument("id", type=EFFECTS, metavar="[ID]", required=False)
@flag("--markdown", "Print the whole page (docs/effects.md).")
@flag("--latex", "Print the equations as LaTeX.")
def command(id: str | None, markdown: bool, latex: bool) -> None:
    """List the effects of the catalogue, or describe one of them."""
    from robodyn.effects.catalogue import CATALOGUE, effect
    from robodyn.report import effects as report

    at_most_one({"--markdown": markdown, "--latex": latex, "--json": as_json()})
    chosen = CATALOGUE if id is None else {id: effect(id)}
    if as_json():
        pages = [report.data(each) for each in chosen.values()]
        echo_json(pages if id is None else pages[0])
    elif latex:
        click.echo(report.latex(chosen), nl=False)
    elif markdown or id is not None:
        click.echo(report.page(chosen), nl=False)
    else:
        width = max(map(len, chosen))
        for each in chosen.values():
            keys = ", ".join(p.name for p in each.parameters)
            click.echo(f"{each.id:{width}}  {each.title}: {keys}")
