"""``robodyn prove``: prove properties of a kernel."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from robodyn.errors import CheckError, ToolError
from robodyn.outputs import write_files
from robodyn_cli.choices import FOLDER, PROOFS, SCALARS, TRIGONOMETRY
from robodyn_cli.code_options import tolerance
from robodyn_cli.decorators import option, robot_argument
from robodyn_cli.options import functions_option, listed, load, model_options, options_of
from robodyn_cli.output import printable, show
from robodyn_cli.output_files import output_folder

if TYPE_CHECKING:
    from robodyn.certify import Proof


@click.command()
@robot_argument
@option("-o --output=DIR", "Output folder.  [default: proof/NAME]", FOLDER)
@option("--ranges=R", "Ranges as qd=3,qdd=10,q2=-pi/2:pi/2.  [default: the joint limits]")
@option("--scalar=TYPE", "Scalar type: float or double.", SCALARS, default="float")
@option("--trig=HOW", "Sine and cosine: builtin, libm or given.", TRIGONOMETRY, default="builtin")
@functions_option("inverse_dynamics")
@option("--only=A,B", "Proofs to run: gappa, eva, stack, misra.  [default: all]", PROOFS)
@option(
    "--budget-seconds --seconds=S seconds",
    "Time limit of Gappa for each torque.",
    click.FloatRange(min=1),
    default=300.0,
)
@option("--workers", "Torques proved in parallel.  [default: one per core]", click.IntRange(min=1))
@option("--tolerance=T", "Fail if a bound exceeds this share of the joint's largest torque: 0.01% or 1e-4.")
@model_options
def command(robot: str, output: str | None, functions: str, **options: Any) -> None:
    """Prove properties of a kernel: rounding, run-time errors, stack, MISRA C:2012.

    DIR gets the kernel as written by "gen --misra", the scripts, the output of the tools, PROOF.md and
    proof.json. Gappa bounds the rounding error of every torque within the ranges. Frama-C Eva shows that no
    input leads to undefined behaviour. gcc reports the stack, cppcheck the deviations from MISRA. Exits with
    1 if a proof fails, 3 if a tool is missing.
    """
    from robodyn.certify import PROOFS, ProofOptions, prove, with_ranges
    from robodyn.toolchain.program import cores
    from robodyn_cli.progress import messages

    kernel = options_of(listed(functions), options, scalar=options["scalar"], trig=options["trig"])
    names = PROOFS if options["only"] is None else listed(options["only"])
    workers, share = options["workers"] or cores(), tolerance(options["tolerance"])
    proofs = ProofOptions(names, options["seconds"], workers, share)
    described, ranges = load(robot, strict=options["strict"]), options["ranges"]
    needed = ranges is not None or "gappa" in proofs.only
    ranged = with_ranges(described, ranges) if needed else described  # as the robot's limits
    folder = output_folder(output) if output is not None else Path("proof") / described.name
    with messages() as tell:
        proof = prove(described, ranged, kernel, proofs, tell)
    write_files(folder, proof.files())
    show(lambda: {**proof.to_dict(), "folder": str(folder)}, lambda: _lines(proof, folder))
    if proof.failed:
        raise CheckError(f"{described.name}: not proven: {', '.join(proof.failed)}")
    if proof.missing:
        remedies = "; ".join(f"{name} {remedy}" for name, remedy in proof.missing.items())
        raise ToolError(f"{described.name}: proofs not run because tools are missing", found=remedies)


def _lines(proof: Proof, folder: Path) -> Iterator[str]:
    for finding in proof.findings:
        yield f"{finding.name}: {finding.status}"
        if finding.status != "not run":
            yield from (f"  {text}" for text in (finding.claim, *finding.lines))
        else:
            yield from (f"  {text}" for text in finding.lines)
    yield f"wrote {printable(folder / 'PROOF.md')}"
