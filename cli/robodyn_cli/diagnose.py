"""``robodyn diagnose``: find missing effects in logs; write the amended model, kernels and a report."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

import click

from robodyn.errors import InputError
from robodyn.outputs import write_files
from robodyn_cli.choices import FILE, FOLDER, SEVERAL_EFFECTS
from robodyn_cli.decorators import flag, option, robot_argument
from robodyn_cli.log_files import log_options, outputs_for, run_on_logs
from robodyn_cli.options import listed
from robodyn_cli.output import as_json, echo_document, printable, talk
from robodyn_cli.values import parameter_option

if TYPE_CHECKING:
    from robodyn.diagnose.result import Diagnosis

#: The files of a diagnosis.
DATA: Final = "diagnosis.json"
MODEL: Final = "model.yaml"
REPORT: Final = "report.html"
KERNELS: Final = "kernels"
#: Exit code if a residual remains that no effect explains.
UNEXPLAINED: Final = 4


@click.command()
@robot_argument
@click.argument("logs", type=FILE, metavar="TRAIN.csv [MORE.csv ...]", nargs=-1, required=True)
@option("--validate=V.csv", "Log for validation, not used for fitting.", FILE)
@log_options
@option("-o --output --out=DIR out", "Output folder.", FOLDER, required=True)
@parameter_option()
@option("--only=A,B", "Look for these effects only.", SEVERAL_EFFECTS)
@option("--except=A,B without", "Look for all but these effects.", SEVERAL_EFFECTS)
@option(
    "--joints=J,K",
    "Look for effects at these joints only, and for none of the whole robot (payload, base tilt).",
)
@option(
    "--most=N", "Name at most N effects; one at several joints counts once.  [default: 8]", click.IntRange(1)
)
@flag("--no-kernels", "Do not write C and Fortran of the amended model.")
@flag("--strict", "Refuse physically implausible values.")
def command(robot: str, no_kernels: bool, **options: Any) -> None:
    """Find the effects that a model is missing, add them, and validate the amended model.

    Logs have the columns t, q1.., tau1.., and optionally qd1.., qdd1.. and ql1.. (second encoders, on the
    links), in SI units, unless --map or --columns says otherwise; A.csv+B.csv is a log whose ql1.. stand in a
    second file. The command writes diagnosis.json, model.yaml (the amended description), report.html (one
    page, no network access) and kernels/ to DIR. The same input gives the same files. Exit code 4 means that
    a residual remains that no effect of the catalogue explains.
    """
    from robodyn.diagnose.run import diagnose, stages

    folder = outputs_for(robot, options, (DATA, MODEL, REPORT))
    scope = {
        "only": _effects("--only", options["only"]), "without": _effects("--except", options["without"]),
        "joints": _joints(options["joints"]), "most": options["most"],
    }  # fmt: skip
    diagnosis = run_on_logs(diagnose, stages, robot, options, **scope)
    validated = options["validate"] is not None
    files: dict[str, str | bytes] = {**files_of(diagnosis, validated=validated)}
    if not no_kernels:
        files.update(kernels_of(diagnosis))
    elif (folder / KERNELS).exists():
        talk(f"robodyn: note: {printable(folder / KERNELS)} is from an earlier run")
    write_files(folder, files)
    if as_json():
        echo_document(str(files[DATA]))
    else:
        from robodyn.report.diagnosis_summary import summary

        for line in summary(diagnosis, printable(folder / REPORT), validated=validated):
            click.echo(line)
    if diagnosis.verdict == "unexplained":
        raise click.exceptions.Exit(UNEXPLAINED)


# --- before the diagnosis ---------------------------------------------------------------------------------


def _effects(option: str, text: str | None) -> tuple[str, ...]:
    """The ids of ``--only`` or ``--except``."""
    ids = listed(text or "")
    if text is not None and not ids:
        raise InputError(f"{option} is empty", expected="ids of effects, as robodyn effects lists them")
    return ids


def _joints(text: str | None) -> list[int]:
    """The joints of ``--joints``."""
    words = [] if text is None else [word.strip() for word in text.split(",")]
    if not all(word.isascii() and word.isdigit() for word in words):
        raise InputError("--joints is not a list of joints", found=str(text), expected="numbers, such as 1,3")
    return [int(word) for word in words]


# --- the files ----------------------------------------------------------------------------------------------


def files_of(diagnosis: Diagnosis, *, validated: bool = False) -> dict[str, str]:
    """Data, the amended description and the page of ``diagnosis``, by their names; ``validated``: the last of
    its logs was not fitted."""
    from robodyn.report.diagnosis import page

    data = json.dumps(_finite(diagnosis.to_dict()), indent=2, ensure_ascii=False, allow_nan=False)
    return {
        DATA: f"{data}\n",
        MODEL: diagnosis.model_text,
        REPORT: page(diagnosis, validated=validated),
    }


def kernels_of(diagnosis: Diagnosis) -> dict[str, str]:
    """C and Fortran of the amended model, by their paths in the folder."""
    from robodyn.kernels.generate import generate

    return {f"{KERNELS}/{name}": text for name, text in generate(diagnosis.model).files().items()}


def _finite(value: Any) -> Any:
    """``value`` for JSON: non-finite numbers, such as the error of an unidentifiable parameter, are null."""
    if isinstance(value, Mapping):
        return {key: _finite(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(each) for each in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
