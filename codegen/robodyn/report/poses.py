"""Inverse kinematics in words and figures: what leads to each pose, branch by branch."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees as to_degrees
from typing import Any

from robodyn.draw.tables import aligned
from robodyn.dynamics.inverse import Numerical
from robodyn.simulate.pose_text import roll_pitch_yaw
from robodyn.simulate.poses import LEAST_SQUARES, Posed, PoseSolver, Solution

#: Positions and errors nearer to 0 than this are shown as 0 [rad or m].
_NOTHING = 5e-7
#: Errors [m, rad, deg] up to this are no more than rounding.
_ROUNDING = 1e-12


def poses_document(
    solver: PoseSolver, posed: Sequence[Posed], *, nearest_only: bool = False
) -> dict[str, Any]:
    """For JSON: rad and m."""
    used = solver.solver
    poses: list[dict[str, Any]] = [
        {"pose": each.T.tolist(), "reached": len(each.reached), "nearest": _solution(each.nearest)}
        for each in posed
    ]
    if not nearest_only:
        for pose, each in zip(poses, posed, strict=True):
            pose["branches"] = [_solution(x) for x in each.solutions]
    return {
        "robot": solver.robot.name,
        "method": "iteration" if isinstance(used, Numerical) else "closed form",
        "conditions": list(used.conditions),
        "place_only": solver.place_only,
        "free_joint": None if used.redundant is None else used.redundant + 1,
        "poses": poses,
    }


def _solution(solution: Solution) -> dict[str, Any]:
    return {
        "branch": solution.name,
        "q": solution.q.tolist(),
        **{name: getattr(solution, name) for name in ("exists", "within", "singular")},
        "off": dict(zip(("place", "rotation"), solution.off, strict=True)),
    }


def poses_text(
    solver: PoseSolver, posed: Sequence[Posed], *, nearest_only: bool = False, degrees: bool = False
) -> list[str]:
    """The same as lines of text."""
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
        joint = f"joint {used.redundant + 1}"
        lines.append(f"{joint} is free, and takes its position from the reference (--near)")
    for k, each in enumerate(posed, start=1):
        place = " ".join(map(_number, each.T[:, 3]))
        turn = " ".join(_number(to_degrees(x) if degrees else x) for x in roll_pitch_yaw(each.T[:, :3]))
        title = f"pose {k}" if len(posed) > 1 else "pose"
        lines += ["", f"{title}: x y z {place} m, roll pitch yaw {turn} {_unit(degrees)}"]
        shown = [each.nearest] if nearest_only else list(each.solutions)
        if not nearest_only and each.nearest.name == LEAST_SQUARES:
            shown.append(each.nearest)
        lines += _table(solver, shown, degrees)
        lines.append(_summary(solver, each, nearest_only, degrees))
    return lines


def _unit(degrees: bool) -> str:
    return "deg" if degrees else "rad"


def _table(solver: PoseSolver, solutions: Sequence[Solution], degrees: bool) -> list[str]:
    kinds = [link.joint.kind for link in solver.robot.links]
    heads = ["branch", *(f"q{i}" for i in range(1, len(kinds) + 1)), "reached", "within", "singular", "off"]
    rows = [heads]
    for each in solutions:
        joints = zip(each.q.tolist(), kinds, strict=True)
        q = [_number(to_degrees(x) if degrees and kind == "revolute" else x) for x, kind in joints]
        flags = ["yes" if flag else "no" for flag in (each.exists, each.within, each.singular)]
        place, turn = each.off
        turn = to_degrees(turn) if degrees else turn
        place_text, turn_text = (f"{x:.1e}" if x > _ROUNDING else f"<{_ROUNDING:.0e}" for x in (place, turn))
        off = f"{place_text} m" if solver.place_only else f"{place_text} m, {turn_text} {_unit(degrees)}"
        rows.append([each.name, *q, *flags, off])
    return aligned(rows, left=(0, len(heads) - 1))


def _summary(solver: PoseSolver, posed: Posed, nearest_only: bool, degrees: bool) -> str:
    near, used = posed.nearest, solver.solver
    if not posed.reached:
        place, turn = near.off
        angle = f" and {to_degrees(turn) if degrees else turn:.3g} {_unit(degrees)}"
        by = "where the iteration ends" if len(posed.solutions) == 1 else f"at {near.name}"
        by = f"by {near.name}" if near.name == LEAST_SQUARES else by
        return f"not reached: {place:.3g} m{'' if solver.place_only else angle} are missing {by}"
    if near.name == LEAST_SQUARES:
        joint = f"joint {(used.redundant or 0) + 1}"
        return f"reached by no branch with {joint} as --near has it, by least squares with it elsewhere"
    if nearest_only or (isinstance(used, Numerical) and used.alone):
        return "reached" if near.within else "reached, beyond the joints' limits"
    within = sum(each.within for each in posed.reached)
    return (
        f"{len(posed.reached)} of {len(posed.solutions)} branches reach it, {within} within the joints' "
        f"limits; nearest to the reference: {near.name}"
    )


def _number(x: float) -> str:
    return f"{0.0 if abs(x) < _NOTHING else x:.6f}"
