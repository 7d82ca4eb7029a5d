"""Poses that functions of poses are tested at: which of them rounding leaves digits of, and whether what is
expected leads back to them.

Where two branches meet positions lose half their digits, and where a flag or an angle may change by rounding
there is no bound at all. So more poses are drawn than are needed, and those are taken whose results have
proven bounds.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.functions.arguments import NEAR, POSE, Q
from robodyn.dynamics.functions.record import Function
from robodyn.errors import InputError
from robodyn.firmware.rounding import rounding_bounds
from robodyn.firmware.states import DTYPE, draw, program_inputs, ranges
from robodyn.ir.program import Program
from robodyn.ir.signature import ScalarType
from robodyn.optimize.programs import inverse_kinematics_of
from robodyn.robot.model import Robot
from robodyn.verify.reference import Reference

#: Poses are rounded to multiples of this [1 and m], so that they do not depend on a machine's sines.
_GRID = 2.0**-30
#: How large the bound of an error may be at a pose, as a share of the largest result there.
_WELL_CONDITIONED = 1e-2
#: So many times as many poses are drawn as are wanted.
_DRAWN = 6
#: By how much what is expected may miss a pose, which is rounded, as a share of the largest place or 1 m.
_MISSED = 1e-5


def pose_states(
    robot: Robot, parameters: Mapping[str, float], states: int, seed: int, scalar: ScalarType
) -> dict[str, NDArray[Any]]:
    """``T`` ``[states, 12]``, the tool's frame at positions within the joints' limits, and other positions
    ``q_near`` ``[states, n]``, in the kernel's type; only a redundant joint has the same position in both."""
    drawn = draw(ranges(robot, (Q.name, NEAR.name), scalar), states, seed, scalar)
    q = drawn[Q.name].astype(np.float64)
    near = drawn[NEAR.name]
    redundant = inverse_kinematics_of(robot).redundant
    if redundant is not None:
        near[:, redundant] = drawn[Q.name][:, redundant]
    T = Reference(robot, parameters).tool_pose(q).reshape(states, 12)
    return {POSE.name: (np.rint(T / _GRID) * _GRID).astype(DTYPE[scalar]), NEAR.name: near}


def well_conditioned(
    robot: Robot,
    program: Program,
    parameters: Mapping[str, float],
    states: int,
    seed: int,
    scalar: ScalarType,
) -> dict[str, NDArray[Any]]:
    """The first ``states`` of :func:`pose_states` at which rounding takes few digits of the results of
    ``program``.

    Raises
    ------
    InputError: there are fewer among those that are drawn.
    """
    drawn = pose_states(robot, parameters, _DRAWN * states, seed, scalar)
    bounds = rounding_bounds(program, program_inputs(drawn, parameters), scalar)
    largest = np.concatenate(list(bounds.values()), axis=1).max(axis=1)
    (sound,) = np.nonzero(largest <= _WELL_CONDITIONED)
    if len(sound) < states:
        raise InputError(
            f"rounding may leave no digit of {robot.name}'s inverse kinematics in {scalar}",
            found=f"bounds of its error at {len(sound)} of {_DRAWN * states} poses within the limits",
            expected=f"{states} at least, to test it with",
            remedy="leave that function out of --functions, or use --scalar double",
        )
    return {array: x[sound[:states]] for array, x in drawn.items()}


def missed_poses(
    robot: Robot,
    function: Function,
    states: Mapping[str, NDArray[Any]],
    parameters: Mapping[str, float],
    expected: Sequence[Sequence[Any]],
) -> list[int]:
    """At which of ``states`` the results ``expected`` ``[N, size]`` of ``function`` do not lead back to the
    pose by plain forward kinematics, or no branch exists."""
    T = states[POSE.name].astype(np.float64)
    counted = [3, 7, 11] if inverse_kinematics_of(robot).place_only else list(range(12))
    allowed = _MISSED * (1 + np.abs(T[:, 3::4]).max())
    missed = np.zeros(len(T), bool)
    rows = [dict(function.split(row, robot.n)) for row in expected]
    for part in function.fuses or (function,):
        assert part.answers is not None
        solutions, exists = (
            np.array([row[name] for row in rows], float)
            for name in (part.answers.solutions, part.answers.exists)
        )
        q = solutions.reshape(-1, robot.n)
        poses = Reference(robot, parameters).tool_pose(q).reshape(*exists.shape, 12)
        off = np.abs(poses - T[:, None, :])[:, :, counted].max(axis=2)
        missed |= ~(exists == 1).any(axis=1) | ((exists == 1) & (off > allowed)).any(axis=1)
    return [int(k) for k in np.nonzero(missed)[0]]
