"""``robodyn tables``: compare the thesis's tables with recomputed figures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from robodyn.errors import InputError
from robodyn_cli.choices import FILE, TABLES
from robodyn_cli.decorators import option
from robodyn_cli.output import as_json, echo_json, printable, talk
from robodyn_cli.output_files import picture_file, write_file
from robodyn_cli.progress import messages

if TYPE_CHECKING:
    from robodyn.thesis.tables import Table


@click.command()
@click.argument("table_id", type=TABLES, metavar="[ID]", required=False)
@option(
    "--picture=FILE.svg",
    "Write a picture: of 2.9 what a joint costs, of 2.10 Figure 2.9 redrawn, of robots the counts.",
    FILE,
)
def command(table_id: str | None, picture: str | None) -> None:
    """Compare the thesis's tables with recomputed figures.

    ID is 1.1, 2.4, 2.6, 2.9, 2.10, 3.1, 3.3, 3.4, 3.5, 4.1, 4.2, 4.4, 4.5, 4.6, 4.8, equations (slips in
    equations and printed data), inverse (program D.1.3), friction (as tasks, section 4.5), schedules (Tables
    4.3, 4.7 and C.1 to C.15), claims (the headline claims) or robots (all bundled robots). The default is all
    tables. Every row has the printed figure, the recomputed one, a verdict (reproduced, differs, not
    recoverable) and a reason. --json prints an object {"id", "title", "rows", "notes"}, or a list of them
    without ID.
    """
    from robodyn.thesis.tables import TABLE_IDS, to_text

    ids = TABLE_IDS if table_id is None else (table_id,)
    target = None if picture is None else _picture_file(picture, ids)
    tables = []
    for one in ids:
        table = _made(one)
        tables.append(table.to_dict())
        if not as_json():
            click.echo(("" if one == ids[0] else "\n") + to_text(table), nl=False)
    if as_json():
        echo_json(tables if table_id is None else tables[0])
    if target is not None:
        write_file(target, _picture(ids))
        talk(f"robodyn: wrote {printable(target)}")


def _made(id: str) -> Table:
    """The table, while a line says which row it is at."""
    from robodyn.thesis.tables import make

    with messages() as tell:
        return make(id, lambda row: tell(f"{id}: {row}"))


def _picture(ids: tuple[str, ...]) -> str:
    """The picture of one table; with all of them that of 2.9."""
    from robodyn.thesis.tables import pictures

    if ids == ("2.10",):
        return pictures.figure_2_9_svg()
    return pictures.robots_svg() if ids == ("robots",) else pictures.operations_svg()


def _picture_file(text: str, ids: tuple[str, ...]) -> Path:
    """The path of the picture.

    Raises
    ------
    InputError: the name does not end in .svg, or the table has no picture.
    """
    if not {"2.9", "2.10", "robots"} & set(ids):
        raise InputError(
            "this table has no picture",
            found=ids[0],
            remedy="use robodyn tables 2.9, 2.10 (for Figure 2.9) or robots",
        )
    return picture_file(text)
