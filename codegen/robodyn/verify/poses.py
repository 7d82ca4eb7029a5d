"""Solutions of inverse kinematics against the reference's forward kinematics."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.functions.record import Answers, Function
from robodyn.dynamics.inverse import Numerical
from robodyn.dynamics.inverse.limits import EDGE
from robodyn.optimize.programs import inverse_kinematics_of
from robodyn.robot.model import Robot
from robodyn.verify.reference import Floats, Reference
from robodyn.verify.sample import is_reachable

#: How near a limit [rad or m] a joint may be for rounding to decide whether it is within.
_AT_LIMIT = 1e-3
#: What a pose may be off where it is taken for one at the edge of reach, as a multiple of that share.
_EDGE = 10
#: Up to what distance [rad or m] positions are the same, as a multiple of the root of the tolerance: where
#: branches meet positions lose half their digits.
_SAME = 10.0
#: How far beside positions steps begin [rad or m], and how many of the poses they have to come to.
_BESIDE, _REACHED = 0.05, 0.9


def references(robot: Robot, q: Floats) -> Floats:
    """The references [N, n] of poses of positions ``q`` [N, n]: these; where steps begin at them, beside."""
    solver = inverse_kinematics_of(robot)
    return q + _BESIDE if isinstance(solver, Numerical) and solver.alone else q


def pose_errors(
    robot: Robot,
    reference: Reference,
    function: Function,
    results: Mapping[str, Floats],
    inputs: Mapping[str, Floats],
    tolerance: float,
    dtype: np.dtype[Any],
) -> Floats:
    """How far the solutions of ``function``, ``[N, size]`` by name, are off the poses ``T`` ``[N, 12]`` of
    ``inputs`` at most, as a share of the arm's size: ``[N]``.

    Infinite where a result is no number, where a flag is wrong, where the positions ``q`` ``[N, n]`` that a
    pose is of are not among the solutions, and where a pose out of reach has one. What is off at the edge of
    reach, which a kernel of ``dtype`` does not tell from beyond, counts by so much less.
    """
    parts = [part.answers for part in function.fuses or (function,) if part.answers is not None]
    errors = [_errors(robot, reference, part, results, inputs, tolerance, dtype) for part in parts]
    sound = np.isfinite(np.concatenate(list(results.values()), axis=1)).all(axis=1)
    worst: Floats = np.where(sound, np.max(errors, axis=0), np.inf)
    return worst


def _errors(
    robot: Robot,
    reference: Reference,
    answers: Answers,
    results: Mapping[str, Floats],
    inputs: Mapping[str, Floats],
    tolerance: float,
    dtype: np.dtype[Any],
) -> Floats:
    T, q = inputs["T"], inputs["q"]
    count, n = q.shape
    solutions = np.nan_to_num(results[answers.solutions].reshape(count, -1, n))
    exists, within, singular = (results[name] for name in (answers.exists, answers.within, answers.singular))
    sound = np.isin(np.concatenate([exists, within, singular], axis=1), (0.0, 1.0)).all(axis=1)
    sound &= _is_within(robot, solutions, within).all(axis=1)
    poses = reference.tool_pose(solutions.reshape(-1, n)).reshape(count, -1, 12)
    missed = np.abs(poses - T[:, None, :])
    solver = inverse_kinematics_of(robot)
    if solver.place_only:
        missed = missed[:, :, 3::4]
    at_edge = max(1.0, _EDGE * EDGE * float(np.finfo(dtype).eps) / tolerance)
    share = missed.max(axis=2) / np.where(singular == 1, at_edge, 1.0)
    closure = np.where(exists == 1, share, 0.0).max(axis=1)
    reachable = is_reachable(count)
    same = (_apart(robot, solutions, q[:, None, :]) < _SAME * math.sqrt(tolerance)) & (exists == 1)
    if isinstance(solver, Numerical):  # steps lead to some positions, near where branches meet to none
        came = (exists == 1).any(axis=1)
        same = np.full_like(same, came[reachable].mean() > _REACHED)
    right = np.where(reachable, same.any(axis=1), (exists == 0).all(axis=1))
    if any(link.joint.kind == "prismatic" for link in robot.links):
        right |= ~reachable  # what slides comes anywhere
    size = 1 + np.abs(T[reachable][:, 3::4]).max(initial=0.0)
    errors: Floats = np.where(sound & right, closure / size, np.inf)
    return errors


def _is_within(robot: Robot, solutions: Floats, within: Floats) -> NDArray[np.bool_]:
    """Whether each flag ``[N, b]`` is right, of solutions that are not at a limit."""
    limits = [link.joint.limits.position or (-math.inf, math.inf) for link in robot.links]
    low, high = np.array([(float(a), float(b)) for a, b in limits]).T
    inside = ((solutions > low + _AT_LIMIT) & (solutions < high - _AT_LIMIT)).all(axis=2)
    outside = ((solutions < low - _AT_LIMIT) | (solutions > high + _AT_LIMIT)).any(axis=2)
    right: NDArray[np.bool_] = np.where(within == 1, ~outside, ~inside)
    return right


def _apart(robot: Robot, one: Floats, other: Floats) -> Floats:
    """How far positions ``[..., n]`` are apart [rad, m], whole turns aside."""
    revolute = np.array([link.joint.kind == "revolute" for link in robot.links])
    gap = one - other
    distance: Floats = np.where(revolute, 2 * np.abs(np.sin(gap / 2)), np.abs(gap)).max(axis=-1)
    return distance
