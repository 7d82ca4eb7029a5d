"""``gen --firmware``: the option, and writing the folder with the measured figures."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import click

from robodyn_cli.decorators import at_most_one, flag
from robodyn_cli.options import listed
from robodyn_cli.output import as_json, echo_json, printable, talk
from robodyn_cli.output_files import report_up_to_date

if TYPE_CHECKING:
    from robodyn.firmware import Folder
    from robodyn.kernels.generate import Generated, Options

#: The folder of the firmware, in that of the robot.
FOLDER = "firmware"


#: Adds ``--firmware``, passed as ``firmware: bool``.
firmware_option = flag(
    "--firmware",
    "Write DIR/firmware instead: kernel with built-in sine and cosine (inverse_dynamics, or --functions), "
    "self-test, CMake, an image for qemu, a README with the measured cost.",
)


def for_firmware(options: Options, target: str | None, **others: object) -> Options:
    """``options`` for a firmware folder; ``others`` are options that cannot be combined with it, by name.

    Raises
    ------
    InputError: one of them is set.
    """
    from robodyn.firmware import firmware_options

    for name, value in others.items():
        at_most_one({f"--{name}": value, "--firmware": True})
    source = click.get_current_context().get_parameter_source
    named = {
        name: getattr(options, name) if source(name) is click.core.ParameterSource.COMMANDLINE else None
        for name in ("scalar", "trig")
    }
    return firmware_options(options, listed(target or ""), **named)


def firmware_of(generated: Generated, languages: tuple[str, ...], target: str | None) -> Folder:
    """The folder of the kernels for the processors of ``--target``."""
    from robodyn.firmware import firmware, targets_named

    return firmware(generated, targets_named(listed(target or "")), languages)


def write_firmware(
    generated: Generated,
    folder: Path,
    languages: tuple[str, ...],
    target: str | None,
    write: Callable[[Path, dict[str, str]], None] | None,
) -> None:
    """``write`` the folder; None: compare it with what would be written (except the README, which depends on
    this machine).

    Raises
    ------
    CheckError: files differ, or the self-test fails on a processor.
    """
    from robodyn.firmware import measure, targets_named

    folder = folder / FOLDER
    name, targets = generated.unit.robot.name, targets_named(listed(target or ""))
    product = firmware_of(generated, languages, target)
    files = dict(product.files)
    if write is None:
        report_up_to_date(name, folder, files)
        return
    functions = [interface.function for interface in generated.signatures]
    figures = [measure(name, files, functions, one) for one in targets]
    files["README.md"] = product.readme(figures)
    write(folder, files)
    for needed in dict.fromkeys(tool for each in figures for tool in (each.missing, each.not_run)):
        if needed is not None:
            talk(f"robodyn: note: not everything was measured: needs {needed}")
    if as_json():
        paths = [str(folder / file) for file in files]
        echo_json({"robot": name, "files": paths, "firmware": [each.to_dict() for each in figures]})
        return
    click.echo(f"{name}: wrote {len(files)} files in {printable(folder)}")
    for line in (line for each in figures for line in each.lines()):
        click.echo(line)
