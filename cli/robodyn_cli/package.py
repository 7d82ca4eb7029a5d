"""``robodyn package``: write a robot's kernels as a package for somebody else's build."""

from __future__ import annotations

import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from robodyn_cli.choices import FOLDER, PACKAGES
from robodyn_cli.code_options import code_options, prune_option
from robodyn_cli.decorators import flag, option, robot_argument
from robodyn_cli.generating import Kernels, kernels
from robodyn_cli.options import functions_option, fuse_option, listed, model_options, search_options
from robodyn_cli.output import as_json, echo_json, printable, wrapped
from robodyn_cli.output_files import FORCE, output_folder, report_up_to_date, write_product
from robodyn_cli.progress import messages

if TYPE_CHECKING:
    from robodyn.packages import Format, Package


def _formats() -> str:
    from robodyn.packages import FORMATS

    names = "; ".join(f"{name} ({form.title}, for {form.tool})" for name, form in FORMATS.items())
    return f"Format: {names}."


@click.command()
@robot_argument
@option("--as=FORMAT format_", _formats, PACKAGES, required=True)
@option("-o --output=DIR", "Output folder.  [default: packages/NAME/FORMAT]", FOLDER)
@option("--version=X.Y.Z", "Version of the package.", default="0.1.0")
@option("--license=ID", "Licence of the package, an SPDX expression such as MIT.")
@option(
    "--maintainer",
    'Maintainer of the package, such as "Ada Lovelace <ada@example.org>".  [default: not stated]',
    metavar="NAME <EMAIL>",
)
@functions_option(
    text="Functions, separated by commas, or all that ROBOT has.  [default: those of the format]"
)
@fuse_option
@code_options()
@model_options
@search_options
@prune_option
@flag("--check", "Write nothing; exit with 1 if the files in DIR differ.")
@flag("--force", FORCE)
def command(robot: str, output: str | None, check: bool, force: bool, **options: Any) -> None:
    """Write a package of a robot's kernels for somebody else's build.

    DIR gets everything that the tool needs, and a README on how to use it. The kernels are those of "robodyn
    gen" with the same options. Scalar type and trigonometry default to what the format needs; options on the
    command line override them. The same input gives the same bytes on any machine, except where a package
    has a binary.
    """
    folder = None if output is None else output_folder(output)
    package, product = packed(robot, **options)
    name = product.robot.name
    with messages() as tell:
        tell(f"{name}: {package.format.title} ...")
        files = package.files()
    folder = Path("packages") / name / package.format.name if folder is None else folder
    if check:
        report_up_to_date(name, folder, files)
        return
    write_product(Path() if output is None else folder, folder, files, force=force)
    take = package.format.take.format(folder=shlex.quote(str(folder)), name=package.name)
    counts = product.generated.counts
    if as_json():
        echo_json(
            {
                "robot": name, "format": package.format.name, "package": package.name,
                "version": package.version,
                "files": [str(folder / path) for path in files],
                "functions": [product.record(function) for function in counts],
                "take": take,
            }
        )  # fmt: skip
    else:
        click.echo(f"{name}: wrote {package.format.title} of {len(files)} files in {printable(folder)}")
        sizes = ", ".join(f"{function} ({count.total} operations)" for function, count in counts.items())
        for text in (*wrapped(f"{package.name} {package.version}: {sizes}"), f"next: {printable(take)}"):
            click.echo(text)


def packed(robot: str, format_: str, **options: Any) -> tuple[Package, Kernels]:
    """The package for the options of the command line (click's current context), and its kernels.

    Raises
    ------
    RobodynError: options that do not go together, or a description that cannot be read.
    """
    from robodyn.packages import format_named, package

    form = format_named(format_)
    head = {name: options.pop(name) for name in ("version", "license", "maintainer")}
    product = _kernels(robot, form, options)
    return package(product.generated, form, **head), product


def _kernels(robot: str, form: Format, options: dict[str, Any]) -> Kernels:
    """The kernels for the options of the command line; the format supplies defaults."""
    from click.core import ParameterSource

    context = click.get_current_context()
    for name, value in form.options.items():
        default = context.get_parameter_source(name) is ParameterSource.DEFAULT
        if default and options["target"] is None:  # a target chooses these itself
            options[name] = value
            context.set_parameter_source(name, ParameterSource.DEFAULT_MAP)
    functions = listed(options["functions"] or "")
    if not functions and not options["fuse"]:
        functions = form.functions
    if functions or options["fuse"]:
        options["functions"] = ",".join(dict.fromkeys((*functions, *form.needs))) or None
    options |= {"lang": form.language.name, "batch": False, "latex": False, "derivatives": form.derivatives}
    return kernels(robot, **options)
