"""Inverse kinematics in words and figures: what leads to each pose, branch by branch."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees as to_degrees
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.inverse import Numerical
from robodyn.report.figures import aligned
from robodyn.simulate.pose_text import roll_pitch_yaw
from robodyn.simulate.poses import LEAST_SQUARES, Posed, PoseSolver, Solution

Floats = NDArray[np.float64]
#: Positions and errors nearer to 0 than this are shown as 0 [rad or m].
_NOTHING = 5e-7
#: Errors [m, rad, deg] up to this are no more than rounding.
_ROUNDING = 1e-12


def poses_document(
    solver: PoseSolver, posed: Sequence[Posed], *, nearest_only: bool = False
) -> dict[str, Any]:
    """For JSON: rad and m."""
    used = solver.solver
    return {
        "robot": solver.robot.name,
        "method": "iteration" if isinstance(used, Numerical) else "closed form",
        "conditions": list(used.conditions),
        "place_only": solver.place_only,
        "free_joint": None if used.redundant is None else used.redundant + 1,
        "poses": [
            {
                "pose": each.T.tolist(),
                "reached": len(each.reached),
                "nearest": _solution(each.nearest),
                **({} if nearest_only else {"branches": [_solution(x) for x in each.solutions]}),
            }
            for each in posed
        ],
    }


def _solution(solution: Solution) -> dict[str, Any]:
    place, turn = solution.off
    return {
        "branch": solution.name,
        "q": solution.q.tolist(),
        "exists": solution.exists,
        "within": solution.within,
        "singular": solution.singular,
        "off": {"place": place, "rotation": turn},
    }


def poses_text(
    solver: PoseSolver, posed: Sequence[Posed], *, nearest_only: bool = False, degrees: bool = False
) -> list[str]:
    """The same as lines of text."""
    lines = _method(solver)
    for k, each in enumerate(posed, start=1):
        lines += ["", _pose(each.T, k if len(posed) > 1 else None, degrees=degrees)]
        shown = [each.nearest] if nearest_only else list(each.solutions)
        if not nearest_only and each.nearest.name == LEAST_SQUARES:
            shown.append(each.nearest)
        lines += _table(solver, shown, degrees=degrees)
        lines.append(_summary(solver, each, nearest_only=nearest_only, degrees=degrees))
    return lines


def _method(solver: PoseSolver) -> list[str]:
    used, name = solver.solver, solver.robot.name
    way = f"closed form, {used.branches} branches"
    if isinstance(used, Numerical):
        way = f"closed form of a similar arm, {used.branches} branches, refined in {used.most} steps at most"
        if used.alone:
            way = f"one solution near the reference (--near), by iteration of {used.most} steps at most"
    lines = [f"{name}: {way}; {'; '.join(used.conditions)}"]
    if used.place_only:
        lines.append(f"{solver.robot.n} joints bring the tool to a place; its rotation follows")
    if used.redundant is not None:
        lines.append(
            f"joint {used.redundant + 1} is free, and takes its position from the reference (--near)"
        )
    return lines


def _pose(T: Floats, k: int | None, *, degrees: bool) -> str:
    angles = [to_degrees(x) if degrees else x for x in roll_pitch_yaw(T[:, :3])]
    place, turn = (" ".join(map(_number, values)) for values in (T[:, 3], angles))
    return f"pose{'' if k is None else f' {k}'}: x y z {place} m, roll pitch yaw {turn} {_unit(degrees)}"


def _unit(degrees: bool) -> str:
    return "deg" if degrees else "rad"


def _table(solver: PoseSolver, solutions: Sequence[Solution], *, degrees: bool) -> list[str]:
    joints = [link.joint for link in solver.robot.links]
    turns = [degrees and joint.kind == "revolute" for joint in joints]
    heads = ["branch", *(f"q{i}" for i in range(1, len(joints) + 1)), "reached", "within", "singular", "off"]
    rows = [heads]
    for each in solutions:
        q = [_number(to_degrees(x) if turn else x) for x, turn in zip(each.q.tolist(), turns, strict=True)]
        flags = ["yes" if flag else "no" for flag in (each.exists, each.within, each.singular)]
        rows.append([each.name, *q, *flags, _off(each, solver, degrees=degrees)])
    return aligned(rows, left=(0, len(heads) - 1))


def _off(solution: Solution, solver: PoseSolver, *, degrees: bool) -> str:
    place, turn = solution.off
    text = f"{_error(place)} m"
    if solver.place_only:
        return text
    return f"{text}, {_error(to_degrees(turn) if degrees else turn)} {_unit(degrees)}"


def _error(x: float) -> str:
    return f"{x:.1e}" if x > _ROUNDING else f"<{_ROUNDING:.0e}"


def _summary(solver: PoseSolver, posed: Posed, *, nearest_only: bool, degrees: bool) -> str:
    near = posed.nearest
    if not posed.reached:
        place, turn = near.off
        angle = f"{to_degrees(turn) if degrees else turn:.3g} {_unit(degrees)}"
        beside = "" if solver.place_only else f" and {angle}"
        if near.name == LEAST_SQUARES:
            by = f"by {near.name}"
        else:
            by = "where the iteration ends" if len(posed.solutions) == 1 else f"at {near.name}"
        return f"not reached: {place:.3g} m{beside} are missing {by}"
    if near.name == LEAST_SQUARES:
        joint = f"joint {(solver.solver.redundant or 0) + 1}"
        return f"reached by no branch with {joint} as --near has it, by least squares with it elsewhere"
    if nearest_only or (isinstance(solver.solver, Numerical) and solver.solver.alone):
        return "reached" if near.within else "reached, beyond the joints' limits"
    within = sum(each.within for each in posed.reached)
    return (
        f"{len(posed.reached)} of {len(posed.solutions)} branches reach it, {within} within the joints' "
        f"limits; nearest to the reference: {near.name}"
    )


def _number(x: float) -> str:
    return f"{0.0 if abs(x) < _NOTHING else x:.6f}"
