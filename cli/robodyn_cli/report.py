"""``robodyn report``: a page that shows an arm, or two beside each other."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from robodyn.outputs import write_files
from robodyn_cli.choices import FILE, ROBOTS
from robodyn_cli.decorators import flag, option, robot_argument
from robodyn_cli.output import as_json, echo_json, printable, talk
from robodyn_cli.output_files import output_folder, write_file
from robodyn_cli.robot_files import load_robot, parameter_values
from robodyn_cli.values import parameter_option

if TYPE_CHECKING:
    from robodyn.robot import Robot


Parameters = Sequence[tuple[str, float]]


@click.command()
@robot_argument
@click.argument("other", type=ROBOTS, metavar="[ROBOT]", required=False)
@option(
    "-o --output --out=PATH out",
    "Page to write (.html), or the folder that gets it.  [default: this folder]",
    FILE,
)
@parameter_option(" of both")
@flag("--strict", "Refuse implausible numbers in place of showing the doubts.")
def command(robot: str, other: str | None, out: str | None, param: Parameters, strict: bool) -> None:
    """Write a page that shows an arm, or two beside each other.

    One HTML file that needs no network: the arm in 3D, moved by sliders through its own kernel in JavaScript,
    with torques, gravity, manipulability and Jacobian; its numbers and what is doubtful about them, operation
    counts, equations, effects, a motion, schedule and C. Two robots are moved alike and compared.

    PATH gets NAME.html (of two robots A-B.html) if it is a folder.
    """
    from robodyn.report.arm_data import arm_of

    specs = (robot, *([other] if other is not None else []))
    arms = [arm_of(_filled(load_robot(spec, strict=strict), param)) for spec in specs]
    comparison = None
    if len(arms) == 2:
        from robodyn.compare.robots import compare

        comparison = compare(arms[0].robot, arms[1].robot).to_dict()
    path = _path(out, [arm.robot.name for arm in arms])
    if not as_json() or out is not None:
        from robodyn.report.arm_page import page

        text = page(arms, comparison)
        if out is not None and path == Path(out):
            write_file(path, text)
        else:
            write_files(path.parent, {path.name: text})
        talk(f"robodyn: wrote {printable(path)}")
    if as_json():
        data: list[dict[str, Any]] = [arm.data for arm in arms]
        echo_json(data[0] if comparison is None else {"robots": data, "comparison": comparison})


def _filled(described: Robot, param: Parameters) -> Robot:
    """The robot with its run-time parameters at the values of ``--param``, those that it has."""
    own = [(name, value) for name, value in param if name in described.parameters]
    return described.at(parameter_values(described, own)) if own else described


def _path(out: str | None, names: Sequence[str]) -> Path:
    """Where the page goes."""
    place = Path() if out is None else output_folder(out)
    return place if place.suffix.lower() == ".html" else place / f"{'-'.join(names)}.html"
