"""``robodyn build``: write the kernels of all robots of a project, or check what is committed of them."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from robodyn.errors import CheckError, InputError, RobodynError
from robodyn.outputs import check_outputs, remove_leftovers, write_files
from robodyn_cli.choices import FILE
from robodyn_cli.decorators import at_most_one, flag, option
from robodyn_cli.output import as_json, echo_document, printable, talk
from robodyn_cli.output_files import FORCE, output_folder, write_file

if TYPE_CHECKING:
    from robodyn.project.compare import Report
    from robodyn.project.lock import Lock
    from robodyn.project.reading import Project
    from robodyn_cli.building import Products


@click.command()
@option("--file=FILE path", "Project file; its lock file lies beside it.", FILE, default="robodyn.toml")
@option("--workers=N", "Robots generated in parallel.  [default: one per core]", click.IntRange(min=1))
@flag(
    "--check",
    "Write nothing; exit with 1 if a file differs, a budget is exceeded, or a count is higher than in "
    "the lock file.",
)
@option(
    "--against=FILE",
    "Lock file to compare counts with, such as that of the branch that a pull request goes to.  "
    "[default: that of the project]",
    FILE,
)
@option(
    "--format=HOW format_",
    "Format of the report: text, json, junit (XML), or markdown (for a pull request).",
    ("text", "json", "junit", "markdown"),
    default="text",
)
@option("-o --output=FILE", "Write the report to FILE, and the text of it to stdout.", FILE)
@flag("--force", FORCE)
def command(path: str, check: bool, format_: str, output: str | None, **options: Any) -> None:
    """Write or check the kernels of all robots of a project.

    The project file, robodyn.toml, has the robots with their options, outputs and budgets. Only what has
    changed is generated and written. The lock file, robodyn.lock, has the counts of every function and the
    hashes of all files: commit it, and let CI run "robodyn build --check".
    """
    at_most_one({"--json": as_json(), f"--format {format_}": format_ not in ("text", "json")})
    form = "json" if as_json() else format_
    try:
        comparison = _built(Path(path), check=check, report=output, **options)
    except RobodynError as error:
        _show_error(error, form, output)
        raise
    _show(comparison, form, output)
    _fail(comparison)


def _built(
    path: Path, *, workers: int | None, check: bool, force: bool, against: str | None, report: str | None
) -> Report:
    """Write or check what the project file asks for, once the file ``report`` can be written: how it
    compares, and the paths of what was written."""
    from robodyn.project.compare import check_products, compare, locked
    from robodyn.project.lock import read_lock
    from robodyn.project.reading import read_project
    from robodyn_cli.building import Products
    from robodyn_cli.project_keys import project_keys

    keys = project_keys()
    project = read_project(path, keys)
    if against is not None and not Path(against).is_file():
        raise InputError("there is no lock file of this name", found=printable(against))
    if report is not None:
        check_outputs(output_folder(report).parent, [Path(report).name], named=True)
    with _alone(project.path, waits=not check):
        before = read_lock(project.lock) if check else _lock_before(project)
        base = before if against is None else read_lock(Path(against))
        products = Products(project, keys, workers)
        check_products(project, products.by_name)
        written = [] if check else _write(project, products, force=force)
        if not check:
            _name_leftovers(project, before or {}, locked(project, products.by_name))
        lock = before if check else locked(project, products.by_name)
        comparison = compare(project, products.by_name, lock, base, products.texts)
    return comparison if check else _worse_is_noted({**comparison, "written": written})


@contextmanager
def _alone(path: Path, *, waits: bool) -> Iterator[None]:
    """Keep other builds of the project file ``path`` waiting, and wait for them."""
    if not waits:
        yield
        return
    with path.open("rb") as file:
        with suppress(ImportError, OSError):  # a system without locks: builds that do not meet need none
            import fcntl

            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                talk(f"robodyn: another build of {printable(path)} is running; this one waits for it")
                fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _lock_before(project: Project) -> Lock | None:
    """The lock file as it is; one that cannot be read, as after a merge, is about to be replaced."""
    from robodyn.project.lock import read_lock

    try:
        return read_lock(project.lock)
    except InputError as error:
        talk(f"robodyn: note: the lock file is written anew: {error}")
        return None


def _write(project: Project, products: Products, *, force: bool) -> list[str]:
    """Write the files that are not as they should be, the lock file last, all or none; their paths."""
    from robodyn.project.compare import locked, outdated
    from robodyn.project.lock import lock_text

    files: dict[str, str | bytes] = {}
    folders = {project.folder}
    for entry in project.entries:
        product, folder = products.by_name[entry.name], project.output(entry)
        folders |= {(folder / name).parent for name in product.files}
        different = outdated(folder, product)
        texts = products.texts(entry) if different else {}
        contents = {f"{entry.output}/{name}": texts[name] for name in different}
        try:
            check_outputs(project.folder, contents, force=force)
        except InputError as error:
            raise error.at(entry.place()) from None
        files |= contents
    remove_leftovers(folders)
    lock = lock_text(locked(project, products.by_name)).encode("utf-8")
    if not project.lock.is_file() or project.lock.read_bytes() != lock:
        files[project.lock.name] = lock
    if not files:
        return []
    remedy = f"choose another output in {printable(project.path)}, or free some space there"
    return [printable(path) for path in write_files(project.folder, files, force=force, remedy=remedy)]


def _name_leftovers(project: Project, before: Lock, now: Lock) -> None:
    """Say on stderr which files of the lock file ``before`` are there but no longer written."""
    files, old = (
        [project.folder / locked.output / name for locked in lock.values() for name in locked.files]
        for lock in (now, before)
    )
    written = {os.path.realpath(path) for path in files}
    gone = [printable(path) for path in old if os.path.realpath(path) not in written and path.is_file()]
    if gone:
        talk(f"robodyn: note: no longer written: {', '.join(gone)}")


def _worse_is_noted(comparison: Report) -> Report:
    """``comparison`` for a build that writes: a count may grow, with a note, and the lock file says it."""
    for fault in comparison["faults"]:
        if fault["kind"] == "count":
            talk(f"robodyn: note: {fault['text']}")
    faults = [fault for fault in comparison["faults"] if fault["kind"] != "count"]
    return {**comparison, "passed": not faults, "faults": faults}


def _show(comparison: Report, form: str, output: str | None) -> None:
    """Print the report and, or, write it."""
    from robodyn.project.reports import FORMATS

    text = FORMATS[form](comparison)
    if output is not None:
        path = output_folder(output)
        write_file(path, text)
        text = FORMATS["text"](comparison)
        form = "text"
    if form == "json":
        echo_document(text)
    else:
        click.echo(text, nl=False)


def _show_error(error: RobodynError, form: str, output: str | None) -> None:
    """Print or write the error in place of a report that cannot be made; stderr gets it anyway."""
    from robodyn.project.reports import ERRORS

    text = ERRORS[form](error)
    if output:
        path = Path(output)
        try:
            write_file(path, text)
        except RobodynError as second:
            if str(second) != str(error):
                talk(f"robodyn: error: {second}")
    elif form == "json":
        echo_document(text)
    elif form != "text":
        click.echo(text, nl=False)


def _fail(comparison: Report) -> None:
    """Say on stderr why the check fails, a line each.

    Raises
    ------
    CheckError: there is a fault.
    """
    faults = comparison["faults"]
    for fault in faults:
        talk(f"robodyn: error: {fault['text']}")
    if faults:
        raise CheckError(
            f"{comparison['project']}: {len(faults)} fault{'s' * (len(faults) != 1)}",
            remedy="raise the budget or simplify the model"
            if {fault["kind"] for fault in faults} == {"budget"}
            else "run robodyn build, and commit what it writes if it should be so",
        )
