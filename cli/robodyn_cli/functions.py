"""``robodyn functions``: what kernels may compute."""

from __future__ import annotations

import click

from robodyn_cli.choices import FUNCTION_NAMES
from robodyn_cli.output import WIDTH, as_json, echo_json


@click.command()
@click.argument("name", type=FUNCTION_NAMES, metavar="[NAME]", required=False)
def command(name: str | None) -> None:
    """List the functions that kernels may have, or describe one of them.

    Those on request are written where --functions names them. Which of them an arm has, and which of their
    results, depends on its joints: "robodyn gen ROBOT" says which it has not, and why.
    """
    import textwrap

    from robodyn.dynamics.functions import FUNCTIONS, function_named

    chosen = [*FUNCTIONS.values()] if name is None else [function_named(name)]
    if as_json():
        rows = [
            {
                "name": each.name,
                "purpose": each.purpose,
                "by_default": each.by_default,
                "inputs": {array.name: array.text for array in each.inputs},
                "results": {array.name: array.text for array in each.results},
            }
            for each in chosen
        ]
        echo_json(rows if name is None else rows[0])
        return

    def say(text: str, indent: str) -> None:
        for line in textwrap.wrap(text, WIDTH, initial_indent=indent, subsequent_indent=f"{indent}  "):
            click.echo(line)

    for each in chosen:
        say(f"{each.name}: {each.purpose}{'' if each.by_default else ' (on request)'}", "")
        for role, arrays in (("takes", each.inputs), ("gives", each.results)) if name else ():
            for array in arrays:
                say(f"{role} {array.name}: {array.text}", "  ")
