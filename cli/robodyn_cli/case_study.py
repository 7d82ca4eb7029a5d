"""``robodyn case-study``: repeat the case study of the thesis's chapter 3, with stated assumptions."""

from __future__ import annotations

import click

from robodyn.outputs import write_files
from robodyn_cli.choices import ARMS, FOLDER, PROFILES
from robodyn_cli.decorators import option
from robodyn_cli.output import printable, show, talk
from robodyn_cli.output_files import output_folder


@click.command()
@option("-o --output=DIR", "Write the samples (CSV) and the pictures to DIR.", FOLDER)
@option(
    "--profile=PROFILE", "Velocity profile along the line: quintic or trapezoid.", PROFILES, default="quintic"
)
@option("--end=M", "End of the line: y = z.", float, default=0.5)
@option("--payload=KG", "Payload of the arm.", float, default=0.0)
@option("--span=M", "Distance between the bearings of a joint.", float, default=0.2)
@option(
    "--arm=ARM",
    "Arm: programs (angles of D.1.3, dynamics of D.1.2) or consistent (the arm of D.1.2 for both).",
    ARMS,
    default="programs",
)
def command(output: str | None, profile: str, end: float, payload: float, span: float, arm: str) -> None:
    """Repeat the thesis's case study of friction (chapter 3).

    The end point of a three-joint PUMA 560 moves along the line y = z at x = 0.4 m, with the friction of
    Table 3.4 in its bearings and transmissions. The thesis's own curves cannot be recovered, because it does
    not give the profile and end of the motion, the span of the bearings, or the efficiency curve beyond three
    points. The command prints what is assumed instead, then the torques and a forward check: the simulated
    arm must follow the line under these torques. See docs/case-study.md. "robodyn tables 3.5" compares the
    printed figures with recomputed ones.
    """
    folder = None if output is None else output_folder(output)
    from robodyn.thesis.case_study import Assumptions, case_study
    from robodyn.thesis.case_text import to_csv, to_dict, to_text

    assumed = Assumptions(profile, end, span, payload, arm)  # type: ignore[arg-type]  # checked by case_study
    study = case_study(assumed)
    show(lambda: to_dict(study), lambda: to_text(study).splitlines())
    if folder is not None:
        from robodyn.thesis.case_pictures import pictures

        written = write_files(folder, {"case-study.csv": to_csv(study), **pictures(study)})
        talk(f"robodyn: wrote {len(written)} files to {printable(folder)}")
