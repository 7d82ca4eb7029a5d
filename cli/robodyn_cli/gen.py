"""``robodyn gen``: write a robot's kernels."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from robodyn.outputs import write_files
from robodyn_cli.choices import FOLDER
from robodyn_cli.code_options import code_options, prune_option
from robodyn_cli.common import (
    FORCE,
    check_files,
    echo_json,
    force_option,
    json_option,
    output_folder,
    printable,
    robot_argument,
    wrapped,
)
from robodyn_cli.counted import (
    effect_lines,
    fused_lines,
    lines,
    pruning_lines,
    record,
    with_pruning,
    with_rigid,
)
from robodyn_cli.firmware import firmware_option, write_firmware
from robodyn_cli.generating import kernels
from robodyn_cli.languages import language_option
from robodyn_cli.options import functions_option, fuse_option, model_options, search_options

if TYPE_CHECKING:
    from robodyn.kernels.generate import Generated, Options


@click.command()
@robot_argument
@click.option("-o", "--output", type=FOLDER, metavar="DIR", help="Output folder.  [default: generated/NAME]")
@language_option
@click.option("--compile", "compile_", is_flag=True, help="Also compile and load the kernels.")
@code_options(
    lists={"compiled": "compiled_targets", "firmware": "firmware_targets"},
    target_help=" With --firmware: processors of the images, separated by commas: {firmware}.  [default with "
    "--firmware: all]",
)
@click.option("--batch", is_flag=True, help="Also write NAME_batch.c: many states per call, with SIMD.")
@functions_option()
@fuse_option
@model_options
@search_options
@click.option(
    "--on",
    metavar="WHERE",
    help="Search with many seeds at once, and take the best: here, local[:N] (N processes) or "
    "dask://HOST:PORT (a scheduler of Dask).",
)
@click.option(
    "--seeds",
    type=click.IntRange(1, 100_000),
    metavar="N",
    help="How many seeds, from --seed on, with --on; each has the whole budget.  [default: 8]",
)
@prune_option
@firmware_option
@click.option("--latex", is_flag=True, help="Also write NAME.tex, the typeset recursion (uses sympy).")
@click.option("--check", is_flag=True, help="Write nothing; exit with 1 if the files in DIR differ.")
@force_option(FORCE)
@json_option
def command(
    robot: str,
    output: str | None,
    lang: str | None,
    compile_: bool,
    target: str | None,
    batch: bool,
    keep: bool,
    firmware: bool,
    latex: bool,
    check: bool,
    force: bool,
    as_json: bool,
    **others: Any,
) -> None:
    """Write the kernels of a robot, and print the operation counts.

    They are in C and Fortran unless --lang says otherwise: DIR gets NAME.h, NAME.c and NAME.f90 (a crate with
    --lang rust, a module with --lang javascript) with the functions of --functions. The same input gives the
    same bytes on any machine.
    """
    from robodyn.errors import InputError

    if check and keep:
        raise InputError("--check writes nothing, but --keep writes a record", remedy="remove one of them")
    folder = output_folder(output) if output is not None else None
    product = kernels(
        robot,
        lang=lang,
        compiled=compile_,
        firmware=firmware,
        target=target,
        batch=batch,
        keep=keep,
        latex=latex,
        **others,
    )
    described, options, generated = product.robot, product.options, product.generated
    formulation = options.formulation
    if folder is None:
        folder = Path("generated") / described.name
    if firmware:
        write_firmware(
            generated, folder, product.languages, target, check=check, as_json=as_json,
            write=lambda folder, files: _write(folder, files, default=output is None, force=force),
        )  # fmt: skip
        return
    files = product.files(batch=batch, latex=latex)
    if check:
        check_files(folder, files)
        if as_json:
            echo_json({"robot": described.name, "checked": [str(folder / name) for name in files]})
        else:
            click.echo(f"{described.name}: {len(files)} files in {printable(folder)} are up to date")
        return
    built = (
        _compiled(generated, product.languages, explicit=lang is not None, batch=batch) if compile_ else None
    )
    _write(folder, files, default=output is None, force=force)
    if as_json:
        echo_json(
            {
                "robot": described.name,
                **_profile(options),
                "files": [str(folder / name) for name in files],
                "functions": [
                    with_pruning(
                        with_rigid(record(described, f, formulation, c), generated.rigid_counts.get(f)),
                        generated.prunings.get(f),
                    )
                    | {"zeros": generated.zeros[f]}
                    for f, c in generated.counts.items()
                ],
                "compiled": built,
                **generated.base_parameters(),
            }
        )
        return
    wrote = ", ".join(printable(folder / name) for name in files)
    for line in wrapped(f"{described.name}: wrote {wrote}"):
        click.echo(line)
    for line in lines(described, [(f, f, formulation, c) for f, c in generated.counts.items()]):
        click.echo(line)
    for line in fused_lines(generated.counts, generated.alone):
        click.echo(line)
    for line in effect_lines(generated.counts, generated.rigid_counts):
        click.echo(line)
    for line in pruning_lines(generated.prunings):
        click.echo(line)
    for language, text in (built or {}).items():
        click.echo(f"{language}: {text}")


def _write(folder: Path, files: Mapping[str, str | bytes], *, default: bool, force: bool) -> None:
    """Write ``files`` to ``folder``; of the ``default`` one no part may be a link, which nobody has named."""
    base = Path() if default else folder
    paths = {str((folder / name).relative_to(base)): content for name, content in files.items()}
    write_files(base, paths, force=force)


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
    from robodyn.errors import CheckError, ToolError
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
