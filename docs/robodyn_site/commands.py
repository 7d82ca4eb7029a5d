"""A page for each command: its help, from the command itself."""

from __future__ import annotations

import re
from typing import Final

import click

from robodyn_cli.main import COMMANDS, EPILOG, cli
from robodyn_site.markdown import code, definitions, fenced, page, plain, table
from robodyn_site.outside import ROOT

FOLDER: Final = "commands"


def pages() -> dict[str, str]:
    """The pages of the commands, and their index."""
    return {f"{FOLDER}/index.md": _index()} | {f"{FOLDER}/{name}.md": of_command(name) for name in COMMANDS}


def of_command(name: str) -> str:
    """The page of one command."""
    command = cli.get_command(click.Context(cli), name)
    assert command is not None
    context = click.Context(command, info_name=f"robodyn {name}")
    paragraphs = (command.help or "").replace("\b\n", "").split("\n\n")
    records = [parameter.get_help_record(context) for parameter in command.params]
    return page(
        f"# robodyn {name}",
        *(plain(" ".join(paragraph.split())) for paragraph in paragraphs),
        fenced(f"robodyn {name} {' '.join(command.collect_usage_pieces(context))}"),
        "## Options",
        definitions(
            (code(option), plain(" ".join(text.split()))) for option, text in filter(None, records) if text
        ),
        _seen_in(name),
    )


def _index() -> str:
    rows = ((f"[`{name}`]({name}.md)", plain(short)) for name, short in COMMANDS.items())
    paragraphs = (cli.help or "").split("\n\n")[1:]
    return page(
        "# Commands",
        "Each page has what `robodyn COMMAND --help` prints, and the documents that use the command.",
        table(("command", "what it does"), rows),
        *(plain(" ".join(paragraph.split())) for paragraph in paragraphs),
        plain(" ".join(EPILOG.split())),
    )


def _seen_in(name: str) -> str:
    """Links to the documents in which the command is run."""
    run = re.compile(rf"^ *\$ robodyn {name}\b", re.MULTILINE)
    links = []
    for path in sorted([*(ROOT / "docs").glob("*.md"), *(ROOT / "docs" / "tutorials").glob("*.md")]):
        text = path.read_text(encoding="utf-8")
        if run.search(text):
            title = text.partition("\n")[0].lstrip("# ")
            links.append(f"- [{title}](../{path.relative_to(ROOT / 'docs').as_posix()})")
    return "\n".join(["## In use", "", *links]) if links else ""
