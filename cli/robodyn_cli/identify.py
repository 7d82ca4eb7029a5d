"""``robodyn identify``: the numbers of an arm from logs, in a new description and as data."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import click

from robodyn.errors import InputError
from robodyn.outputs import write_files
from robodyn_cli.choices import FILE, FOLDER
from robodyn_cli.decorators import flag, option, robot_argument
from robodyn_cli.log_files import log_options, outputs_for, run_on_logs
from robodyn_cli.output import as_json, echo_document, printable
from robodyn_cli.values import parameter_option

if TYPE_CHECKING:
    from robodyn.identify.fit import Load

_MODEL = "identified.yaml"
#: What stands for the mass of a load that is not known.
_UNKNOWN: Final = "unknown"


@click.command()
@robot_argument
@click.argument("logs", type=FILE, metavar="LOG [LOG ...]", nargs=-1, required=True)
@option("--validate=V.csv", "Log for validation, not used for fitting.", FILE)
@log_options
@option("-o --output=DIR out", "Output folder.", FOLDER, required=True)
@flag("--gains", "Fit a gain of each torque channel: torque constants are known only roughly.")
@option(
    "--offsets",
    "Fit a constant offset of each torque channel; auto: where held-out samples show one.",
    ["auto", "yes", "no"],
    default="auto",
)
@option(
    "--load=LOG=MASS",
    "Mass [kg] that the arm carried in that log beyond its description, or LOG=unknown.",
    multiple=True,
)
@parameter_option()
@flag("--strict", "Refuse physically implausible values.")
def command(robot: str, gains: bool, offsets: str, load: tuple[str, ...], **options: Any) -> None:
    """Identify links, friction and rotors from logs, physically consistent, with intervals.

    Logs have the columns t, q1.., tau1.. in SI units, unless --map or --columns says otherwise. The command
    writes identified.yaml (the description with its new numbers, physically consistent) and identify.json
    (all numbers with standard errors, what the logs do not show, residuals) to DIR. Numbers stay as near to
    the description as its `confidence` says. Without --validate the residual is that of 30 % of the samples,
    which a first fit leaves out.
    """
    from robodyn.identify.fit import Options
    from robodyn.identify.known import DATA_FILE
    from robodyn.identify.run import identify, stages

    folder = outputs_for(robot, options, (DATA_FILE, _MODEL))
    fitted = Options(
        offsets={"auto": "auto", "yes": True, "no": False}[offsets],  # type: ignore[arg-type]
        gains=gains,
        loads=_loads(load, options["logs"]),
    )
    outcome = run_on_logs(identify, stages, robot, options, options=fitted)
    text = json.dumps(outcome.to_dict(), indent=2, ensure_ascii=False, allow_nan=False) + "\n"
    write_files(folder, {DATA_FILE: text, _MODEL: outcome.model_text})
    if as_json():
        echo_document(text)
        return
    from robodyn.report.identification import summary

    for line in summary(outcome, printable(folder / _MODEL)):
        click.echo(line)


def _loads(texts: Sequence[str], logs: Sequence[str]) -> tuple[Load, ...]:
    """What ``--load`` says; logs with one known mass carried the same body.

    Raises
    ------
    InputError: no such log, twice the same, or no mass.
    """
    from robodyn.identify.fit import Load

    masses: dict[int, float | None] = {}
    for text in texts:
        name, sign, mass = text.rpartition("=")
        places = [k for k, log in enumerate(logs) if name in (log, Path(log).name)]
        if not sign or len(places) != 1:
            raise InputError(
                "--load names no log, or more than one",
                found=repr(text),
                expected=f"LOG=MASS with one of {', '.join(map(printable, logs))}",
            )
        if places[0] in masses:
            raise InputError("--load names a log twice", found=repr(text))
        masses[places[0]] = None if mass == _UNKNOWN else _mass(mass, text)
    groups: dict[float | None, list[int]] = {}
    for place, value in sorted(masses.items()):
        groups.setdefault(value, []).append(place)
    return tuple(Load(tuple(places), value) for value, places in groups.items())


def _mass(text: str, option: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = float("nan")
    if not 0 < value < float("inf"):
        raise InputError("--load: not a mass", found=repr(option), expected=f"more than 0 kg, or {_UNKNOWN}")
    return value
