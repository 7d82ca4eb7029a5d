"""``robodyn tables``: the thesis's tables, printed figure, recomputed figure, verdict."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import click

from robodyn_cli.common import echo_json, json_option, printable, talk, write_files


@click.command()
@click.argument("table_id", metavar="[ID]", required=False)
@click.option("--picture", metavar="FILE.svg", help="Write Figure 2.9, redrawn from the counts, to FILE.svg.")
@json_option
def command(table_id: str | None, picture: str | None, as_json: bool) -> None:
    """Set the thesis's tables beside what robodyn recomputes.

    ID is 1.1, 2.9, 2.10, 3.3, 3.5, 4.2, 4.4, 4.5, 4.6, 4.8, schedules (Tables 4.3, 4.7 and C.1 to C.15),
    claims (the headline claims) or robots (all that are bundled); without it all are printed. For every row
    there is the printed figure, ours, counted by running what the row describes, a verdict (reproduced,
    differs, not recoverable) and the reason. With --json an object {"id", "title", "rows", "notes"} is
    printed, or a list of them without ID.
    """
    from robodyn.thesis.tables import TABLE_IDS, make, to_text

    ids = TABLE_IDS if table_id is None else (table_id,)
    target = None if picture is None else _picture_file(picture, ids)
    found = []
    for one in ids:
        table = make(one, _told(one))
        if as_json:
            found.append(table.to_dict())
            continue
        if one != ids[0]:
            click.echo()
        click.echo(to_text(table), nl=False)
    if as_json:
        echo_json(found if table_id is None else found[0])
    if target is not None:
        from robodyn.thesis.tables.picture import operations_svg

        write_files(target.parent, {target.name: operations_svg()})
        talk(f"robodyn: wrote {printable(target)}")


def _picture_file(text: str, ids: tuple[str, ...]) -> Path:
    """Where the picture goes.

    Raises
    ------
    InputError: the name does not end in .svg, or a table was asked for that has no picture.
    """
    from robodyn.errors import InputError

    if "2.9" not in ids:
        raise InputError(
            "there is no picture of this table", found=ids[0], remedy="ask for it with robodyn tables 2.9"
        )
    if not text.endswith(".svg") or text == ".svg":
        raise InputError("the picture is an SVG", found=repr(text), expected="a name that ends in .svg")
    return Path(text)


def _told(table: str) -> Callable[[str], None]:
    """Says on a terminal what is being worked on; nothing in a pipe."""
    if sys.stderr is None or not sys.stderr.isatty():
        return lambda _: None
    return lambda what: talk(f"robodyn: {table}: {what}")
