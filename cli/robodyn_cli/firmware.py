"""``gen --firmware``: the option, and writing the folder with the measured figures."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from robodyn_cli.common import check_files, echo_json, printable, talk
from robodyn_cli.options import listed

if TYPE_CHECKING:
    from robodyn.firmware import Folder
    from robodyn.kernels.generate import Generated, Options

Command = TypeVar("Command", bound=Callable[..., Any])

#: The folder of the firmware, in that of the robot.
FOLDER = "firmware"


def firmware_option(command: Command) -> Command:
    """Add ``--firmware``, passed to `command` as ``firmware: bool``."""
    return click.option(
        "--firmware",
        is_flag=True,
        help="Write DIR/firmware instead: kernel with built-in sine and cosine (inverse_dynamics, or "
        "--functions), self-test, CMake, an image for qemu, a README with the measured cost.",
    )(command)


def for_firmware(options: Options, target: str | None, **others: object) -> Options:
    """``options`` for a firmware folder; ``others`` are options that cannot be combined with it, by name.

    Raises
    ------
    InputError: one of them is set.
    """
    from robodyn.errors import InputError
    from robodyn.firmware import firmware_options

    for name, value in others.items():
        if value:
            raise InputError(f"--{name} cannot be combined with --firmware", remedy="remove one of them")
    return firmware_options(
        options,
        listed(target or ""),
        scalar=options.scalar if _on_command_line("scalar") else None,
        trig=options.trig if _on_command_line("trig") else None,
    )


def firmware_of(generated: Generated, languages: tuple[str, ...], target: str | None) -> Folder:
    """The folder of the kernels for the processors of ``--target``."""
    from robodyn.firmware import firmware, targets_named

    return firmware(generated, targets_named(listed(target or "")), languages)


def write_firmware(
    generated: Generated,
    folder: Path,
    languages: tuple[str, ...],
    target: str | None,
    *,
    check: bool,
    as_json: bool,
    write: Callable[[Path, dict[str, str]], None],
) -> None:
    """``write`` the folder, or compare it with what would be written (except the README, which depends on
    this machine).

    Raises
    ------
    CheckError: files differ, or the self-test fails on a processor.
    """
    from robodyn.firmware import measure, targets_named

    folder = folder / FOLDER
    name, targets = generated.unit.robot.name, targets_named(listed(target or ""))
    made_folder = firmware_of(generated, languages, target)
    files = dict(made_folder.files)
    if check:
        check_files(folder, files)
        if as_json:
            echo_json({"robot": name, "checked": [str(folder / file) for file in files]})
        else:
            click.echo(f"{name}: {len(files)} files in {printable(folder)} are up to date")
        return
    functions = [interface.function for interface in generated.signatures]
    figures = [measure(name, files, functions, one) for one in targets]
    files["README.md"] = made_folder.readme(figures)
    write(folder, files)
    for needed in dict.fromkeys(
        missing for measured in figures for missing in (measured.missing, measured.not_run)
    ):
        if needed is not None:
            talk(f"robodyn: note: not everything was measured: needs {needed}")
    if as_json:
        echo_json(
            {
                "robot": name,
                "files": [str(folder / file) for file in files],
                "firmware": [measured.to_dict() for measured in figures],
            }
        )
        return
    click.echo(f"{name}: wrote {len(files)} files in {printable(folder)}")
    for measured in figures:
        for line in measured.lines():
            click.echo(line)


def _on_command_line(name: str) -> bool:
    """Whether the option was given on the command line."""
    source = click.get_current_context().get_parameter_source(name)
    return source is click.core.ParameterSource.COMMANDLINE
