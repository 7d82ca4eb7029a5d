"""Solutions of inverse kinematics against the reference's forward kinematics."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.dynamics.functions.record import Answers, Function
from robodyn.dynamics.inverse import Inverse, Numerical
from robodyn.dynamics.inverse.limits import EDGE, WEAK_NEAR
from robodyn.optimize.programs import inverse_kinematics_of
from robodyn.robot.model import Robot
from robodyn.verify.reference import Reference
from robodyn.verify.sample import is_reachable

#: How near a limit [rad or m] a joint may be for rounding to decide whether it is within.
_AT_LIMIT = 1e-3
#: What a pose may be off where it is taken for one at the edge of reach, as a multiple of that share.
_EDGE = 10
#: Up to what distance [rad or m] positions are the same, as a multiple of the root of the tolerance: where
#: two branches meet positions lose half their digits.
_SAME = 10.0
#: Rounds of Newton's method to where positions half way between two branches lead, and the step [rad or m]
#: of the differences that its Jacobian is made of.
_ROUNDS, _STEP = 4, 1e-6
#: How far beside positions steps begin [rad or m], and how many of the poses they have to come to.
_BESIDE, _REACHED = 0.05, 0.9


def references(robot: Robot, q: Floats) -> Floats:
    """The references [N, n] of poses of positions ``q`` [N, n]: these; where steps begin at them, beside."""
    solver = inverse_kinematics_of(robot)
    if not isinstance(solver, Numerical) or not solver.alone:
        return q
    return q + (float(WEAK_NEAR) if solver.weak else _BESIDE)


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
    judge = _Judge(robot, reference, inverse_kinematics_of(robot), inputs["T"], inputs["q"], tolerance)
    eps = float(np.finfo(dtype).eps)
    parts = [part.answers for part in function.fuses or (function,) if part.answers is not None]
    errors = [judge.errors(part, results, eps) for part in parts]
    sound = np.isfinite(np.concatenate(list(results.values()), axis=1)).all(axis=1)
    worst: Floats = np.where(sound, np.max(errors, axis=0), np.inf)
    return worst


@dataclass(frozen=True, slots=True)
class _Judge:
    """Poses ``T`` ``[N, 12]``, the positions ``q`` ``[N, n]`` that they are of, and by how much solutions may
    be off, ``tolerance``, as a share of the arm's size."""

    robot: Robot
    reference: Reference
    solver: Inverse | Numerical
    T: Floats
    q: Floats
    tolerance: float

    @property
    def size(self) -> float:
        """Of the arm [m]: how far it is to the poses that are not out of reach, and 1 m."""
        reachable = is_reachable(len(self.q))
        return float(1 + np.abs(self.T[reachable][:, 3::4]).max(initial=0.0))

    def errors(self, answers: Answers, results: Mapping[str, Floats], eps: float) -> Floats:
        """The errors ``[N]`` of one function, see :func:`pose_errors`; ``eps`` of the kernel's type."""
        count, n = self.q.shape
        solutions = np.nan_to_num(results[answers.solutions].reshape(count, -1, n))
        exists, within, singular = (
            results[name] for name in (answers.exists, answers.within, answers.singular)
        )
        sound = np.isin(np.concatenate([exists, within, singular], axis=1), (0.0, 1.0)).all(axis=1)
        sound &= _is_within(self.robot, solutions, within).all(axis=1)
        poses = self.reference.tool_pose(solutions.reshape(-1, n)).reshape(count, -1, 12)
        missed = self._counted(np.abs(poses - self.T[:, None, :])).max(axis=2)
        at_edge = max(1.0, _EDGE * EDGE * eps / self.tolerance)
        share = missed / np.where(singular == 1, at_edge, 1.0)
        closure = np.where(exists == 1, share, 0.0).max(axis=1)
        reachable = is_reachable(count)
        right = np.where(reachable, self._are_among(solutions, exists == 1), (exists == 0).all(axis=1))
        if any(link.joint.kind == "prismatic" for link in self.robot.links):
            right |= ~reachable  # what slides comes anywhere
        errors: Floats = np.where(sound & right, closure / self.size, np.inf)
        return errors

    def _counted(self, frames: Floats) -> Floats:
        """What counts of ``frames`` ``[..., 12]``: all, or only the place."""
        return frames[..., 3::4] if self.solver.place_only else frames

    def _are_among(self, solutions: Floats, exists: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Whether ``[N]`` the positions that poses are of are among their ``solutions`` ``[N, b, n]``."""
        if isinstance(self.solver, Numerical):  # steps do not lead to all of them
            came: NDArray[np.bool_] = np.asarray(exists.any(axis=1))
            return np.full(len(came), came[is_reachable(len(came))].mean() > _REACHED)
        gaps = _gaps(self.robot, solutions, self.q[:, None, :])
        apart = np.abs(gaps).max(axis=2)
        near = apart < _SAME * math.sqrt(self.tolerance)
        among: NDArray[np.bool_] = (near & exists).any(axis=1)
        for k in np.nonzero(~near.any(axis=1) & is_reachable(len(near)))[0]:
            among[k] = self._are_one_branch(int(k), gaps[k, np.argmin(apart[k])])
        return among

    def _are_one_branch(self, k: int, gap: Floats) -> bool:
        """Whether the positions of pose ``k`` and those ``gap`` [n] beside them cannot be told apart.

        Where more than two branches nearly meet, the tool stays where it is to within the tolerance although
        joints move by far more than its root. So it is asked whether there are positions half way, beside the
        straight line, that lead to the pose as well; between two branches that are apart there are none.
        """
        along = gap / np.linalg.norm(gap)
        free = np.ones(len(gap))
        if self.solver.redundant is not None:
            free[self.solver.redundant] = 0.0
        steps = _STEP * np.eye(len(gap))
        q, missing = self.q[k] + gap / 2, np.zeros(0)
        for _ in range(_ROUNDS):
            missing = self._counted(self.reference.tool_pose(q).reshape(12) - self.T[k])
            ahead, behind = (self.reference.tool_pose(q + way).reshape(-1, 12) for way in (steps, -steps))
            J = self._counted(ahead - behind).T / (2 * _STEP) * free
            across = J - np.outer(J @ along, along)
            q = q - np.linalg.lstsq(across, missing, rcond=math.sqrt(self.tolerance))[0]
        return bool(np.abs(missing).max() <= self.tolerance * self.size)


def _is_within(robot: Robot, solutions: Floats, within: Floats) -> NDArray[np.bool_]:
    """Whether each flag ``[N, b]`` is right, of solutions that are not at a limit."""
    limits = [link.joint.limits.position or (-math.inf, math.inf) for link in robot.links]
    low, high = np.array([(float(a), float(b)) for a, b in limits]).T
    inside = ((solutions > low + _AT_LIMIT) & (solutions < high - _AT_LIMIT)).all(axis=2)
    outside = ((solutions < low - _AT_LIMIT) | (solutions > high + _AT_LIMIT)).any(axis=2)
    right: NDArray[np.bool_] = np.where(within == 1, ~outside, ~inside)
    return right


def _gaps(robot: Robot, one: Floats, other: Floats) -> Floats:
    """From positions ``other`` to ``one``, ``[..., n]`` [rad, m], the shorter way round."""
    revolute = np.array([link.joint.kind == "revolute" for link in robot.links])
    gap = one - other
    shorter: Floats = np.where(revolute, np.remainder(gap + math.pi, 2 * math.pi) - math.pi, gap)
    return shorter
