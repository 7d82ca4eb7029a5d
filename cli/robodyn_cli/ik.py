"""``robodyn ik``: the joint positions that bring the tool to a pose."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from robodyn.errors import CheckError, InputError
from robodyn_cli.choices import FILE
from robodyn_cli.decorators import flag, option, robot_argument
from robodyn_cli.output import show
from robodyn_cli.robot_files import load_robot, parameter_values
from robodyn_cli.values import SEVERAL, parameter_option

if TYPE_CHECKING:
    from robodyn.simulate.poses import PoseSolver


@click.command()
@robot_argument
@option(
    "--pose=X,Y,Z,... poses",
    "Pose of the tool in the world: x,y,z,roll,pitch,yaw (m, rad), or the 12 numbers of [R p] row by "
    "row, or 16 of a 4 by 4 matrix; may be repeated.",
    SEVERAL,
    multiple=True,
)
@option("--poses=FILE file", "File with many poses, in JSON (a list of them) or CSV (a row each).", FILE)
@option("--of=Q positions", "Pose at these joint positions (rad or m).", SEVERAL)
@option(
    "--near=Q",
    "Reference: what free joints take, and what the nearest solution is near to.  [default: zeros]",
    SEVERAL,
)
@flag("--nearest", "Only the solution nearest to the reference.")
@flag("--degrees", "Angles in degrees, on the command line, in files and in the text.")
@parameter_option()
@flag("--strict", "Refuse physically implausible values.")
def command(
    robot: str,
    poses: tuple[tuple[float, ...], ...],
    file: str | None,
    positions: tuple[float, ...] | None,
    near: tuple[float, ...] | None,
    nearest: bool,
    degrees: bool,
    param: tuple[tuple[str, float], ...],
    strict: bool,
) -> None:
    """Solve for the joint positions that bring the tool to a pose.

    Arms of many classes have a closed form: all branches are shown, whether each reaches the pose, is within
    the joints' limits, is singular (meets another, or leaves a joint free), and by how much the tool is off.
    Of other arms one solution comes by iteration. Exits with 1 if a pose is not reached. With --json:
    {"robot", "method", "conditions", "free_joint", "poses": [{"pose", "reached", "nearest", "branches"}]}, in
    rad and m.
    """
    from robodyn.report.poses import poses_document, poses_text
    from robodyn.simulate.poses import PoseSolver

    described = load_robot(robot, strict=strict)
    solver = PoseSolver(described, parameter_values(described, param))
    frames = _frames(solver, poses, file, positions, degrees=degrees)
    reference = None if near is None else _positions(solver, "--near", near, degrees=degrees)
    posed = solver.solve(frames, reference)
    show(
        lambda: poses_document(solver, posed, nearest_only=nearest),
        lambda: poses_text(solver, posed, nearest_only=nearest, degrees=degrees),
    )
    missed = [k for k, each in enumerate(posed, start=1) if not each.reached]
    if missed:
        raise CheckError(
            f"{described.name} does not reach "
            + ("the pose" if len(posed) == 1 else f"{len(missed)} of {len(posed)} poses"),
            found=None if len(posed) == 1 else f"pose {missed[0]} as the first",
            remedy="move it into the arm's reach",
        )


def _frames(
    solver: PoseSolver,
    poses: tuple[tuple[float, ...], ...],
    file: str | None,
    positions: tuple[float, ...] | None,
    *,
    degrees: bool,
) -> Any:
    """All poses [K, 3, 4] of the command line."""
    import numpy as np

    from robodyn.simulate.pose_text import FORMS, frame_of, frames_in

    frames = [frame_of(numbers, degrees=degrees) for numbers in poses]
    if file is not None:
        frames.extend(frames_in(file, degrees=degrees))
    if positions is not None:
        frames.append(solver.pose(_positions(solver, "--of", positions, degrees=degrees)))
    if not frames:
        raise InputError(
            "there is no pose", expected=f"--pose with {FORMS}; --poses FILE; or --of joint positions"
        )
    return np.array(frames)


def _positions(solver: PoseSolver, option: str, values: tuple[float, ...], *, degrees: bool) -> list[float]:
    """Joint positions [n] (rad or m) from the command line."""
    from math import radians

    from robodyn_cli.simulate_options import exactly

    robot = solver.robot
    exactly(option, values, robot)
    revolute = [degrees and link.joint.kind == "revolute" for link in robot.links]
    return [radians(x) if turn else x for x, turn in zip(values, revolute, strict=True)]
