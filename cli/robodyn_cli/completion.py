"""``robodyn completion``: what lets a shell complete commands, options and names."""

from __future__ import annotations

import os
from pathlib import Path

import click

from robodyn_cli.choices import SHELLS
from robodyn_cli.common import echo_json, json_option, printable, write_file


@click.command()
@click.argument("shell", type=SHELLS, metavar="[SHELL]", required=False)
@click.option("--install", is_flag=True, help="Write the script to your folder of SHELL's completions.")
@click.option("--uninstall", is_flag=True, help="Remove it from there.")
@json_option
def command(shell: str | None, install: bool, uninstall: bool, as_json: bool) -> None:
    """Print or install the script with which a shell completes robodyn.

    SHELL is bash, zsh or fish; without it, the one that the environment variable SHELL names. Commands,
    options, robots, functions, effects, targets, languages and files are completed. --install writes one
    file, and changes none of yours.
    """
    from robodyn.errors import InputError
    from robodyn_cli.shells import script

    name = _named(shell)
    if install and uninstall:
        raise InputError("--install and --uninstall contradict each other", remedy="remove one of them")
    text = script(name)
    if not install and not uninstall:
        if as_json:
            echo_json({"shell": name, "script": text})
        else:
            click.echo(text, nl=False)
        return
    path = _path(name)
    changed = _remove(path) if uninstall else _write(path, text)
    if as_json:
        echo_json({"shell": name, "path": str(path), "installed": install, "changed": changed})
    else:
        _report(name, path, install=install, changed=changed)


def _named(shell: str | None) -> str:
    """The name of the shell.

    Raises
    ------
    InputError: there is no completion for it.
    """
    from robodyn.errors import InputError
    from robodyn_cli.shells import SHELLS

    name = shell if shell is not None else Path(os.environ.get("SHELL", "")).name
    if name not in SHELLS:
        raise InputError(
            "no shell is named" if not name else f"there is no completion for the shell {name!r}",
            expected=f"one of {', '.join(SHELLS)}",
            remedy="name it: robodyn completion bash" if shell is None else None,
        )
    return name


def _path(shell: str) -> Path:
    """Where the script of `shell` goes.

    Raises
    ------
    InputError: there is no home folder.
    """
    from robodyn.errors import InputError
    from robodyn_cli.shells import SHELLS

    try:
        home = Path.home()
    except RuntimeError:
        raise InputError(
            "there is no home folder to install into", remedy=f"robodyn completion {shell} > FILE"
        ) from None
    return SHELLS[shell].folder(os.environ, home) / SHELLS[shell].file


def _write(path: Path, text: str) -> bool:
    """Write `text` to `path`; False if it is there already."""
    if _is_ours(path) and path.read_text(encoding="utf-8") == text:
        return False
    write_file(path, text, remedy="print it: robodyn completion SHELL")
    return True


def _remove(path: Path) -> bool:
    """Remove the script at `path`; False if there is none."""
    from robodyn.files import cannot_write

    if not _is_ours(path):
        return False
    try:
        path.unlink()
    except OSError as error:
        raise cannot_write(printable(path), error, "remove it by hand") from None
    return True


def _is_ours(path: Path) -> bool:
    """Whether a script of robodyn is at `path`.

    Raises
    ------
    InputError: something else is.
    """
    from robodyn.errors import InputError
    from robodyn_cli.shells import MARK

    if not path.exists():
        return False
    if not path.is_file() or MARK not in path.read_text(encoding="utf-8", errors="replace"):
        raise InputError(
            f"{printable(path)} is not a script of robodyn",
            expected="nothing there, or an earlier completion of robodyn",
            remedy="move it away first",
        )
    return True


def _report(shell: str, path: Path, *, install: bool, changed: bool) -> None:
    """Say what was done, what is left to do, and how to undo it."""
    from robodyn_cli.shells import SHELLS

    if not install:
        click.echo(f"removed {printable(path)}" if changed else f"nothing to remove at {printable(path)}")
        return
    click.echo(f"wrote {printable(path)}" if changed else f"{printable(path)} is up to date")
    needed = SHELLS[shell].needed(path.parent)
    if needed is not None:
        click.echo(needed)
    click.echo(f"new shells complete robodyn; to undo: robodyn completion {shell} --uninstall")
