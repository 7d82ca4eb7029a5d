"""``robodyn prove``: prove properties of a kernel."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

import click

from robodyn.outputs import write_files
from robodyn_cli.choices import FOLDER, PROOFS, SCALARS, TRIGONOMETRY
from robodyn_cli.common import echo_json, json_option, output_folder, printable, robot_argument
from robodyn_cli.options import functions_option, listed, load, model_options

if TYPE_CHECKING:
    from robodyn.certify import Proof
    from robodyn.robot import Robot


@click.command()
@robot_argument
@click.option("-o", "--output", type=FOLDER, metavar="DIR", help="Output folder.  [default: proof/NAME]")
@click.option(
    "--ranges",
    metavar="R",
    help="Ranges as qd=3,qdd=10,q2=-pi/2:pi/2.  [default: the joint limits]",
)
@click.option(
    "--scalar",
    type=SCALARS,
    metavar="TYPE",
    default="float",
    show_default=True,
    help="Scalar type: float or double.",
)
@click.option(
    "--trig",
    type=TRIGONOMETRY,
    metavar="HOW",
    default="builtin",
    show_default=True,
    help="Sine and cosine: builtin, libm or given.",
)
@functions_option("inverse_dynamics")
@click.option(
    "--only", type=PROOFS, metavar="A,B", help="Proofs to run: gappa, eva, stack, misra.  [default: all]"
)
@click.option(
    "--budget-seconds",
    "--seconds",
    "seconds",
    metavar="S",
    type=click.FloatRange(min=1),
    default=300.0,
    show_default=True,
    help="Time limit of Gappa for each torque.",
)
@click.option(
    "--workers", type=click.IntRange(min=1), help="Torques proved in parallel.  [default: one per core]"
)
@click.option(
    "--tolerance",
    metavar="T",
    help="Fail if a bound exceeds this share of the joint's largest torque: 0.01% or 1e-4.",
)
@model_options
@json_option
def command(
    robot: str,
    output: str | None,
    ranges: str | None,
    scalar: str,
    trig: str,
    functions: str,
    only: str | None,
    seconds: float,
    workers: int | None,
    tolerance: str | None,
    formulation: str,
    optimize: str,
    no_regroup: bool,
    engine: str,
    strict: bool,
    as_json: bool,
) -> None:
    """Prove properties of a kernel: rounding, run-time errors, stack, MISRA C:2012.

    DIR gets the kernel as written by "gen --misra", the scripts, the output of the tools, PROOF.md and
    proof.json. Gappa bounds the rounding error of every torque within the ranges. Frama-C Eva shows that no
    input leads to undefined behaviour. gcc reports the stack, cppcheck the deviations from MISRA. Exits with
    1 if a proof fails, 3 if a tool is missing.
    """
    from robodyn.certify import PROOFS, ProofOptions, prove
    from robodyn.errors import CheckError, ToolError
    from robodyn.kernels.generate import Options
    from robodyn.toolchain.program import cores
    from robodyn_cli.progress import line

    options = Options(
        functions=listed(functions),
        formulation=formulation,
        optimize=optimize,  # type: ignore[arg-type]  # checked by Options
        regroup=not no_regroup,
        scalar=scalar,  # type: ignore[arg-type]
        trig=trig,  # type: ignore[arg-type]
        engine=engine,  # type: ignore[arg-type]
    )
    proofs = ProofOptions(
        PROOFS if only is None else listed(only), seconds, workers or cores(), _share(tolerance)
    )
    described = load(robot, strict=strict)
    ranged = _ranged(described, ranges, needed="gappa" in proofs.only)
    folder = output_folder(output) if output is not None else Path("proof") / described.name
    with line() as shown:
        proof = prove(described, ranged, options, proofs, lambda text: shown.tell(f"robodyn: {text}"))
    write_files(folder, proof.files())
    if as_json:
        echo_json({**proof.to_dict(), "folder": str(folder)})
    else:
        _print(proof, folder)
    if proof.failed:
        raise CheckError(f"{described.name}: not proven: {', '.join(proof.failed)}")
    if proof.missing:
        remedies = "; ".join(f"{name} {remedy}" for name, remedy in proof.missing.items())
        raise ToolError(f"{described.name}: proofs not run because tools are missing", found=remedies)


def _ranged(described: Robot, ranges: str | None, *, needed: bool) -> Robot:
    """The robot with the ranges as its limits; unchanged if no ranges are given or needed."""
    from robodyn.certify import with_ranges

    return with_ranges(described, ranges) if needed or ranges is not None else described


def _share(text: str | None) -> Fraction | None:
    """``--tolerance`` as a share."""
    from robodyn.errors import InputError
    from robodyn.robot.numbers import NumberError, parse_number

    if text is None:
        return None
    plain = text.strip()
    try:
        share = parse_number(plain.removesuffix("%")) / (100 if plain.endswith("%") else 1)
    except NumberError:
        share = Fraction(0)
    if not 0 < share < 1:
        raise InputError(
            "the tolerance is not a share", found=repr(text), expected="more than 0 and less than 100%"
        )
    return share


def _print(proof: Proof, folder: Path) -> None:
    for finding in proof.findings:
        click.echo(f"{finding.name}: {finding.status}")
        if finding.status != "not run":
            click.echo(f"  {finding.claim}")
        for text in finding.lines:
            click.echo(f"  {text}")
    click.echo(f"wrote {printable(folder / 'PROOF.md')}")
