"""``robodyn doctor``: which programs and libraries are here, what each enables, how to get the others."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from robodyn.errors import ToolError
from robodyn_cli.choices import TOOLS
from robodyn_cli.decorators import flag, option
from robodyn_cli.options import listed
from robodyn_cli.output import WIDTH, as_json, echo_json, printable

if TYPE_CHECKING:
    from robodyn.doctor import ToolState


@click.command()
@option("--need=A,B", "Exit with 3 if one of these is missing, such as gcc,gappa.", TOOLS)
@flag("--all all_", "Show also what only robodyn's own tests use.")
def command(need: str | None, all_: bool) -> None:
    """Show which programs and libraries are here, what each enables, and how to get the others.

    All but the libraries that pip installs with robodyn are optional: what needs one says so. Exits with 3
    if such a library, a file of robodyn, or a tool of --need is missing; else with 0.
    """
    from robodyn.doctor import examine, known, named
    from robodyn.tools import Use

    tools = known()
    # Without a library that everything needs only those are known: it is missing, whatever --need names.
    all_are_known = any(tool.use is not Use.EVERYTHING for tool in tools)
    needed = [named(name) for name in listed(need or "")] if all_are_known else []
    tools = tuple(tool for tool in tools if all_ or tool.use is not Use.DEVELOPMENT or tool in needed)
    states = examine(tools)
    if as_json():
        echo_json({**_machine(), "tools": [state.to_dict() for state in states]})
    else:
        _print(states)
    missing = [
        state.tool
        for state in states
        if not state.works and (state.tool.use is Use.EVERYTHING or state.tool in needed)
    ]
    if missing:
        raise ToolError(
            f"missing: {', '.join(tool.name for tool in missing)}",
            remedy="; ".join(dict.fromkeys(tool.install for tool in missing)),
        )


def _machine() -> dict[str, Any]:
    """robodyn, Python and the system, as JSON has them; its data are looked for as well.

    Raises
    ------
    ToolError: data are missing from the installation.
    """
    import platform

    from robodyn.resources import data_dir
    from robodyn.toolchain.cache import default_root
    from robodyn.version import VERSION

    for data in ("robots", "templates"):
        data_dir(data)
    cache = default_root()
    return {
        "robodyn": VERSION,
        "python": platform.python_version(),
        "system": platform.platform(terse=True),
        "cache": None if cache is None else str(cache),
    }


def _print(states: Sequence[ToolState]) -> None:
    """A table for each use: a plus or a minus, name, version, and what it enables or how to get it."""
    machine = _machine()
    click.echo(f"robodyn {machine['robodyn']}, Python {machine['python']}, {machine['system']}")
    click.echo(f"compiled kernels are kept in {printable(machine['cache'] or 'a temporary folder')}")
    names = max(len(state.tool.name) for state in states)
    versions = max(len(state.version or "") for state in states)
    use = None
    for state in states:
        if state.tool.use is not use:
            use = state.tool.use
            click.echo(f"\n{click.style(use, bold=True)}")
        sign = click.style("+", fg="green") if state.works else click.style("-", fg="red")
        head = f"{state.tool.name:{names}}  {state.version or '':{versions}}"
        for k, line in enumerate(_lines(state, WIDTH - names - versions - 6)):
            click.echo(f"{sign if k == 0 else ' '} {head if k == 0 else '':{names + versions + 2}}  {line}")


def _lines(state: ToolState, width: int) -> list[str]:
    """What it enables, what is wrong with it, and how to get it, in lines of ``width`` columns."""
    import textwrap

    texts = [state.tool.enables]
    if state.fault is not None:
        texts.append(f"{printable(state.where or '')} does not work: {state.fault}")
    if not state.works:
        texts.append(state.tool.install)
    wrapped = (textwrap.wrap(text, width, break_long_words=False, break_on_hyphens=False) for text in texts)
    return [line for lines in wrapped for line in lines]
