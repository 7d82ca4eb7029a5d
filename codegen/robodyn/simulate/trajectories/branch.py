"""Joint positions along a path in closed form, from sample to sample on the branch that is nearest."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.inverse import Numerical
from robodyn.robot.model import Placement, Robot
from robodyn.robot.values import quarter_turns
from robodyn.simulate.inverse_kinematics import closest_turns, position_limits
from robodyn.simulate.kinematics import Kinematics
from robodyn.simulate.poses import PoseSolver

Floats = NDArray[np.float64]

#: How far a joint may go from one sample to the next [rad or m]: further is another branch.
_LARGEST_JUMP = math.pi / 2


def solver_up_to(kinematics: Kinematics) -> PoseSolver:
    """Inverse kinematics of the arm up to the link of ``kinematics``, whose point is its tool."""
    robot, straight = kinematics.robot, quarter_turns(0)
    x, y, z = (Fraction(value) for value in kinematics.point)
    arm: Robot = replace(
        robot,
        links=robot.links[: kinematics.link],
        tool=Placement((x, y, z), (straight, straight, straight)),
        effects=(),
    )
    return PoseSolver(arm, {name: kinematics.parameters[name] for name in arm.parameters})


def along_branch(solver: PoseSolver, poses: Floats, start: Floats) -> Floats | None:
    """Joint positions [K, n] for ``poses`` [K, 3, 4], within the limits, the first those nearest to ``start``
    [n]; None where branches are not known, a pose is not reached, or a joint would have to jump."""
    if isinstance(solver.solver, Numerical) and solver.solver.alone:
        return None
    q, usable = solver.branches(poses, start)
    revolute = np.array([link.joint.kind == "revolute" for link in solver.robot.links])
    low, high = position_limits(solver.robot).T
    joints = np.empty((len(q), solver.robot.n))
    last = start
    for k, (rows, here) in enumerate(zip(q, usable, strict=True)):
        turned = np.where(revolute, closest_turns(rows, last), rows)
        rows = np.where((turned >= low) & (turned <= high), turned, rows)
        steps = np.where(here, np.abs(rows - last).max(axis=1), math.inf)
        best = int(np.argmin(np.where(here, ((rows - last) ** 2).sum(axis=1), math.inf)))
        if not here[best] or (k and steps[best] > _LARGEST_JUMP):
            return None
        joints[k] = last = rows[best]
    return joints
