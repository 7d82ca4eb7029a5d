"""``robodyn gen``: write a robot's kernels."""

from __future__ import annotations

import itertools
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from robodyn.errors import CheckError, ToolError
from robodyn_cli.choices import FOLDER
from robodyn_cli.code_options import code_options, prune_option
from robodyn_cli.counted import effect_lines, fused_lines, lines, pruning_lines
from robodyn_cli.decorators import at_most_one, flag, option, robot_argument
from robodyn_cli.firmware import firmware_option, write_firmware
from robodyn_cli.generating import kernels
from robodyn_cli.languages import language_option
from robodyn_cli.options import functions_option, fuse_option, model_options, search_options
from robodyn_cli.output import as_json, echo_json, printable, wrapped
from robodyn_cli.output_files import FORCE, output_folder, report_up_to_date, write_product

if TYPE_CHECKING:
    from robodyn.kernels.generate import Generated, Options


@click.command()
@robot_argument
@option("-o --output=DIR", "Output folder.  [default: generated/NAME]", FOLDER)
@language_option
@flag("--compile compile_", "Also compile and load the kernels.")
@code_options(firmware=True)
@flag("--batch", "Also write NAME_batch.c: many states per call, with SIMD.")
@functions_option()
@fuse_option
@model_options
@search_options
@option(
    "--on=WHERE",
    "Search with many seeds at once, and take the best: here, local[:N] (N processes) or "
    "dask://HOST:PORT (a scheduler of Dask).",
)
@option(
    "--seeds=N",
    "How many seeds, from --seed on, with --on; each has the whole budget.  [default: 8]",
    click.IntRange(1, 100_000),
)
@prune_option
@firmware_option
@flag("--latex", "Also write NAME.tex, the typeset recursion (uses sympy).")
@flag("--check", "Write nothing; exit with 1 if the files in DIR differ.")
@flag("--force", FORCE)
def command(robot: str, output: str | None, check: bool, force: bool, **options: Any) -> None:
    """Write the kernels of a robot, and print the operation counts.

    They are in C and Fortran unless --lang says otherwise: DIR gets NAME.h, NAME.c and NAME.f90 (a crate with
    --lang rust, a module with --lang javascript, NAME.cuh and NAME.cu with --lang cuda) with the functions of
    --functions. The same input gives the same bytes on any machine.
    """
    at_most_one({"--check": check, "--keep": options["keep"]})
    folder = output_folder(output) if output is not None else None
    product = kernels(robot, **options)
    generated, name = product.generated, product.robot.name
    folder = Path("generated") / name if folder is None else folder

    write = partial(write_product, Path() if output is None else folder, force=force)

    if options["firmware"]:
        write_firmware(generated, folder, product.languages, options["target"], None if check else write)
        return
    files = product.files(batch=options["batch"], latex=options["latex"])
    if check:
        report_up_to_date(name, folder, files)
        return
    built: dict[str, Any] | None = None
    if options["compile_"]:
        explicit = options["lang"] is not None
        built = _compiled(generated, product.languages, explicit=explicit, batch=options["batch"])
    write(folder, files)
    if as_json():
        paths = [str(folder / file) for file in files]
        functions = [
            {**product.record(function), "zeros": generated.zeros[function]} for function in generated.counts
        ]
        head = {"robot": name, **_profile(product.options), "files": paths, "functions": functions}
        echo_json({**head, "compiled": built, **generated.base_parameters()})
        return
    wrote = ", ".join(printable(folder / file) for file in files)
    rows = [(f, f, product.options.formulation, count) for f, count in generated.counts.items()]
    for line in (
        *wrapped(f"{name}: wrote {wrote}"),
        *lines(product.robot, rows),
        *fused_lines(generated.counts, generated.alone),
        *effect_lines(generated.counts, generated.rigid_counts),
        *pruning_lines(generated.prunings),
        *(f"{language}: {text}" for language, text in (built or {}).items()),
    ):
        click.echo(line)


def _profile(options: Options) -> dict[str, Any]:
    """The target and the options it sets, for JSON."""
    from robodyn.kernels.generate import CHOSEN

    settings: dict[str, Any] = {what: getattr(options, what) for what in CHOSEN}
    target = options.profile
    flags = None if target is None else target.compiled(options.contraction or "off")
    return {"target": options.target, **settings, "flags": flags}


def _compiled(
    generated: Generated, languages: tuple[str, ...], *, explicit: bool, batch: bool
) -> dict[str, Any]:
    """Compile and load each language; compare their results bit by bit if there are several."""
    from robodyn.emit.languages import LANGUAGES
    from robodyn.kernels.kernel import load as load_kernel

    kernels: dict[str, Any] = {}
    results: dict[str, Any] = {}
    for language in languages:
        try:
            files = generated.files((language,), batch=batch and language == "c")
            kernel = load_kernel(generated.signatures, files, language=language)
        except ToolError as error:
            if language != "c" and not explicit:
                results[language] = f"written, not compiled: {error}"
                continue
            raise
        kernels[language] = kernel
        results[language] = f"compiled with {kernel.compiler}, loaded"
    for one, other in itertools.pairwise(kernels):
        if not _same_bits(generated, kernels[one], kernels[other]):
            raise CheckError(
                f"the compiled {LANGUAGES[one].title} and {LANGUAGES[other].title} give different bits",
                remedy="compile both without contraction and -ffast-math (CC, FC), or one of them (--lang)",
            )
        results[f"{one} and {other}"] = "the same bits on 100 states"
    return results


def _same_bits(generated: Generated, one: Any, other: Any) -> bool:
    import numpy as np

    random = np.random.default_rng(0)
    params = dict.fromkeys(generated.signatures[0].parameters, 1.0) or None
    for interface in generated.signatures:
        arrays = [random.uniform(-1, 1, (100, size)) for _, size in interface.inputs]
        dt = 1e-3 if interface.states else None
        both = (getattr(k, interface.function)(*arrays, params=params, dt=dt) for k in (one, other))
        mine, theirs = (results if isinstance(results, tuple) else (results,) for results in both)
        if not all(np.array_equal(x, y, equal_nan=True) for x, y in zip(mine, theirs, strict=True)):
            return False
    return True
