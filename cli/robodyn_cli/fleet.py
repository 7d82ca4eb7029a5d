"""``robodyn fleet``: which arms of a fleet differ from their siblings, since when and in what."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Any, Final

import click

from robodyn.errors import InputError
from robodyn.outputs import check_outputs, write_files
from robodyn.tools.libraries import DISTRIBUTED, PYARROW
from robodyn_cli import progress
from robodyn_cli.choices import FILE, FOLDER
from robodyn_cli.decorators import flag, option
from robodyn_cli.log_files import spare_inputs
from robodyn_cli.output import as_json, echo_document, printable, talk
from robodyn_cli.output_files import output_folder
from robodyn_cli.values import POSITIVE

if TYPE_CHECKING:
    from robodyn.cluster import Security
    from robodyn.fleet.result import FleetResult
    from robodyn.fleet.sources.fleet import Fleet

_DATA, _TABLE, _PAGE = "fleet.json", "fleet.parquet", "index.html"
#: The word for a proposal, in the place of a fleet.
_INIT: Final = "init"
#: Pages of units that are in memory together.
_PAGES: Final = 100


@click.command()
@click.argument("fleet", type=FILE, metavar="FLEET")
@click.argument("folder", type=FOLDER, metavar="[FOLDER]", required=False)
@option("-o --output --out=DIR out", "Output folder.", FOLDER)
@option(
    "--on=WHERE",
    "Where the work runs: here (in this process), local[:N] (N processes of this machine; without N "
    "one for each core), or dask://HOST:PORT (a scheduler of Dask).  [default: local, or here without Dask]",
)
@option(
    "--diagnose", "Units that get a full diagnosis of their logs.", ["named", "all", "none"], default="named"
)
@option(
    "--false-names=SHARE",
    "Share of the named units of the whole fleet that may be healthy on average.  [default: 0.05]",
    POSITIVE,
)
@option("--tls-ca=FILE", "Certificate that signs the scheduler's (PEM).", FILE)
@option("--tls-cert=FILE", "Own certificate for dask:// (PEM).", FILE)
@option("--tls-key=FILE", "Its key (PEM).  [default: in the file of --tls-cert]", FILE)
@flag("--no-parquet", "Do not write fleet.parquet, which needs pyarrow.")
def command(
    fleet: str, folder: str | None, out: str | None, on: str | None, no_parquet: bool, **options: Any
) -> None:
    """Find the arms of a fleet that differ from their siblings or have changed.

    FLEET is a file such as fleet.toml, which says what types of arms there are and where their logs lie, or a
    folder with one, or with logs as TYPE/UNIT/DATE.csv. Every log is read once; what was worked out stays in
    DIR, so that a second run reads new logs only. The command writes fleet.json, fleet.parquet, index.html
    (one page, no network access) and a page for each unit in units/ to DIR. The exit code is 0 whether units
    are named or not: a script looks at fleet.json. The same input gives the same files.

    `robodyn fleet init FOLDER` proposes a fleet.toml from the names of the logs in FOLDER, prints it and
    writes it there.
    """
    if fleet == _INIT:
        _propose(folder)
        return
    if folder is not None:
        raise click.UsageError(f"Got unexpected extra argument ({folder})")
    if out is None:
        raise click.UsageError("Missing option '-o' / '--output' / '--out'.")
    _compare(fleet, out, on, no_parquet, options)


def _propose(folder: str | None) -> None:
    """Print a proposal for fleet.toml, and write it where there is none."""
    from robodyn.fleet.sources.proposal import propose_fleet
    from robodyn.fleet.sources.reading import FILE as NAME

    if folder is None or not Path(folder).is_dir():
        raise InputError("there is no such folder", found=folder, expected="robodyn fleet init FOLDER")
    check_outputs(Path(folder), (NAME,))
    proposal = propose_fleet(Path(folder))
    write_files(Path(folder), {NAME: proposal.text})
    click.echo(proposal.text.rstrip())
    for remark in proposal.remarks:
        talk(f"robodyn: note: {printable(remark)}")
    talk(f"robodyn: {printable(Path(folder) / NAME)} is written: look through it, then run robodyn fleet")


def _compare(fleet: str, out: str, on: str | None, no_parquet: bool, options: Mapping[str, Any]) -> None:
    """Read, digest and compare the logs, and write the results."""
    from robodyn.cluster import check_place
    from robodyn.fleet.sources.reading import read_fleet
    from robodyn.formats.loading import load

    if on is None:
        on = "local" if DISTRIBUTED.present() else "here"
        if on == "here":
            talk("robodyn: note: one process works; pip install 'robodyn[fleet]' for several")
    check_place(on)
    folder = output_folder(out)
    security = _security(options, on)
    if not no_parquet and not PYARROW.present():
        talk("robodyn: note: fleet.parquet is left out: it needs pip install 'robodyn[fleet]'")
        no_parquet = True
    false_names = options["false_names"]
    if false_names is not None and not false_names < 1:
        raise InputError("--false-names is not a share", found=f"{false_names:g}", expected="less than 1")
    described = read_fleet(fleet)
    inputs = [fleet, *(part for log in described.logs for part in log.source.split("+"))]
    spare_inputs([folder / name for name in (_DATA, _TABLE, _PAGE)], inputs)
    check_outputs(folder, (_DATA, _PAGE, *[_TABLE] * (not no_parquet)))
    with progress.line() as shown:
        result = _judged(described, folder, on, options, security, shown.tell)
        text = _written(result, folder, shown.tell, table=not no_parquet)
    for arm in described.types.values():
        load(arm.spec, warn=lambda _: None, note=lambda text: talk(f"robodyn: note: {text}"))
    if as_json():
        echo_document(text)
        return
    from robodyn.report.fleet_text import summary

    for line in summary(result, printable(folder / _PAGE)):
        click.echo(line)


def _security(options: Mapping[str, Any], on: str) -> Security | None:
    """The files of --tls-ca, --tls-cert and --tls-key; None without: then Dask's own configuration counts."""
    authority, certificate, key = (options[name] for name in ("tls_ca", "tls_cert", "tls_key"))
    if authority is None and certificate is None and key is None:
        return None
    if authority is None or certificate is None:
        raise InputError(
            "TLS takes two files at least",
            expected="--tls-ca and --tls-cert, and --tls-key where the certificate's file has no key",
        )
    if not on.startswith("dask://"):
        raise InputError(
            "TLS is for a scheduler of Dask", found=f"--on {on}", expected="--on dask://HOST:PORT"
        )
    from robodyn.cluster import Security

    return Security(authority, certificate, key or "")


def _judged(
    fleet: Fleet,
    folder: Path,
    on: str,
    options: Mapping[str, Any],
    security: Security | None,
    tell: Callable[[str], None],
) -> FleetResult:
    """What is said of the fleet; files of diagnoses are in ``folder`` then."""
    from robodyn.fleet.run import run_fleet
    from robodyn_cli.diagnose import files_of
    from robodyn_cli.progress import Pace

    pace = Pace()

    def progress(stage: str, done: int, of: int) -> None:
        rest = f", {done:,} of {of:,}{pace.words(stage, done, of, monotonic())}" if of else ""
        tell(f"robodyn: {printable(fleet.name)}: {stage}{rest}")

    share = {} if options["false_names"] is None else {"false_names": options["false_names"]}
    return run_fleet(
        fleet, folder, on, diagnose=options["diagnose"], files_of=files_of, security=security,
        progress=progress, **share,
    )  # fmt: skip


def _written(result: FleetResult, folder: Path, tell: Callable[[str], None], *, table: bool) -> str:
    """Write the files; the page that links all others last. The text of fleet.json."""
    from robodyn.fleet.as_json import document, text
    from robodyn.fleet.result import unit_folder
    from robodyn.fleet.table import parquet
    from robodyn.report.fleet import page, unit_pages

    tell("robodyn: writing pages")
    check_outputs(folder, [f"{unit_folder(unit.type, unit.unit)}/{_PAGE}" for unit in result.units])
    pages: dict[str, str] = {}
    for k, (path, html) in enumerate(unit_pages(result), 1):
        pages[path] = html
        if len(pages) == _PAGES or k == len(result.units):
            write_files(folder, pages)
            pages.clear()
    data = text(document(result))
    files: dict[str, str | bytes] = {_DATA: data}
    if table:
        files[_TABLE] = parquet(result)
    write_files(folder, {**files, _PAGE: page(result)})
    return data
