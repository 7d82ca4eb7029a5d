"""``robodyn case-study``: chapter 3 of the thesis run anew, on assumptions that are stated."""

from __future__ import annotations

import sys

import click

from robodyn_cli.common import echo_json, json_option, output_folder, printable, talk, write_files


@click.command()
@click.option("-o", "output", metavar="DIR", help="Write the samples as CSV and the pictures into DIR.")
@click.option("--profile", default="quintic", show_default=True, help="Along the line: quintic or trapezoid.")
@click.option("--end", metavar="M", type=float, default=0.5, show_default=True, help="y = z at its end.")
@click.option("--payload", metavar="KG", type=float, default=0.0, show_default=True, help="Load of the arm.")
@click.option(
    "--span", metavar="M", type=float, default=0.2, show_default=True, help="Distance of a joint's bearings."
)
@click.option(
    "--arm",
    default="programs",
    show_default=True,
    help="programs: D.1.3's joint angles in D.1.2's dynamics; consistent: D.1.2's arm all the way.",
)
@json_option
def command(
    output: str | None, profile: str, end: float, payload: float, span: float, arm: str, as_json: bool
) -> None:
    """Run the thesis's case study of friction (chapter 3) anew.

    A PUMA 560 of three joints moves its point along the line y = z at x = 0.4 m, with the friction of Table
    3.4 in its bearings and transmissions. The thesis's own curves cannot be recovered: it gives neither
    profile nor end of the motion, nor the span of the bearings, nor the efficiency curve beyond three points.
    What is assumed in their place is printed, then the torques, and a forward check: the arm is simulated
    with the torques fed to it, and must follow the line. docs/case-study.md tells more; "robodyn tables 3.5"
    sets the printed figures beside what follows from them.
    """
    folder = None if output is None else output_folder(output)
    from robodyn.thesis.case_study import Assumptions, case_study
    from robodyn.thesis.case_text import to_csv, to_dict, to_text

    if sys.stderr is not None and sys.stderr.isatty():
        talk("robodyn: compiling and simulating")
    assumed = Assumptions(profile, end, span, payload, arm)  # type: ignore[arg-type]  # checked by case_study
    study = case_study(assumed)
    if as_json:
        echo_json(to_dict(study))
    else:
        click.echo(to_text(study), nl=False)
    if folder is not None:
        from robodyn.thesis.case_pictures import pictures

        written = write_files(folder, {"case-study.csv": to_csv(study), **pictures(study)})
        talk(f"robodyn: wrote {len(written)} files into {printable(folder)}")
