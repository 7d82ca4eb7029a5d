"""The joint positions of poses, of any arm: in closed form where its class has one, else by iteration.

What is evaluated are the programs of the kernels, in double precision and without a compiler. Where iteration
from the reference does not come to a pose, it begins elsewhere as well, which a kernel leaves to its caller.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robodyn.arrays import Floats
from robodyn.dynamics.functions import function_named
from robodyn.dynamics.inverse import Numerical
from robodyn.dynamics.inverse.limits import STARTS
from robodyn.errors import InputError
from robodyn.ir.evaluate import REAL_FUNCTIONS, evaluate
from robodyn.ir.program import Input, Program
from robodyn.optimize.programs import Choice, build, inverse_kinematics_of
from robodyn.robot.model import Robot
from robodyn.simulate.kinematics import (
    Kinematics,
    closest_turns,
    drawn_between,
    is_revolute,
    position_limits,
    rotation_vector,
)

#: All branches, and the nearest.
_FUNCTIONS = ("inverse_kinematics", "nearest_inverse_kinematics")
#: Functions of programs, over arrays of many poses.
_OF_ARRAYS: dict[str, Callable[..., Any]] = {
    **REAL_FUNCTIONS,
    "sin": np.sin,
    "cos": np.cos,
    "sqrt": np.sqrt,
    "atan2": np.arctan2,
}


@dataclass(frozen=True, slots=True)
class _Evaluated:
    """Of many poses joint positions ``q`` [K, b, n], ``flags`` [K, b, 3]: exists, within, singular; and where
    there is one, which ``branch`` [K] it is."""

    q: Floats
    flags: NDArray[np.bool_]
    branch: NDArray[np.int_]


@dataclass(frozen=True, slots=True)
class Solution:
    """Joint positions for a pose.

    ``name`` of the branch, ``q`` [n] (rad or m); ``exists``: they reach it; ``within`` the joints' limits;
    ``singular``: branches meet here, or a joint is free; ``off`` the pose by so much: place [m], and angle of
    the rotation that is missing [rad].
    """

    name: str
    q: Floats
    exists: bool
    within: bool
    singular: bool
    off: tuple[float, float]


@dataclass(frozen=True, slots=True)
class Posed:
    """A pose ``T`` [3, 4], its ``solutions``, all branches in the order of the kernels, and the one nearest
    to the reference of those that exist, within limits if any is."""

    T: Floats
    solutions: tuple[Solution, ...]
    nearest: Solution

    @property
    def reached(self) -> tuple[Solution, ...]:
        """The solutions that exist; of a redundant arm with its joint elsewhere only if there is no other."""
        branches = tuple(solution for solution in self.solutions if solution.exists)
        return branches or ((self.nearest,) if self.nearest.exists else ())


#: The solution where no branch reaches a pose.
LEAST_SQUARES = "least squares"
#: What may be missing of a pose that is reached [m, rad].
_REACHED = 1e-9
#: Steps of least squares at most.
_EVALUATIONS = 40
#: How far a pose may be away [m]: squares of more are no numbers.
_FARTHEST = 1e100


class PoseSolver:
    """Inverse kinematics of ``robot`` with run-time ``parameters`` at these values.

    Attributes
    ----------
    solver: what solves, in closed form or by iteration.

    Raises
    ------
    InputError: a run-time parameter has no value.
    """

    def __init__(self, robot: Robot, parameters: Mapping[str, float] | None = None) -> None:
        self.robot = robot.at(parameters or {}) if robot.parameters else robot
        self.solver = inverse_kinematics_of(self.robot)
        tool = self.robot.tool
        point = (0.0, 0.0, 0.0) if tool is None else tool.xyz
        self._turn = np.eye(3) if tool is None else np.array(tool.rotation, np.float64)
        self._kinematics = Kinematics(self.robot, None, [float(x) for x in point])

    @property
    def place_only(self) -> bool:
        """Whether only the place of the tool counts, and its rotation follows."""
        return self.solver.place_only

    def pose(self, q: ArrayLike) -> Floats:
        """The tool's frame ``[R p]`` at ``q``: [n] to [3, 4], [K, n] to [K, 3, 4]."""
        place, rotation = self._kinematics.pose(q)
        return np.concatenate([rotation @ self._turn, place[..., None]], axis=-1)

    def solve(self, T: ArrayLike, near: ArrayLike | None = None) -> list[Posed]:
        """The solutions of poses ``T`` [K, 3, 4]; ``near`` [n] (rad or m; zeros if not stated) is what joints
        take that a pose leaves free, and what the nearest solution is near to.

        Raises
        ------
        InputError: a pose is too far away to compute with, or no number; ``near`` is not of so many joints.
        """
        poses = np.asarray(T, np.float64).reshape(-1, 3, 4)
        for k, pose in enumerate(poses, start=1):
            if not np.abs(pose).max() < _FARTHEST:
                raise InputError(
                    f"{self.robot.name}: pose {k} is too far away to compute with",
                    found=f"x y z {' '.join(f'{x:g}' for x in pose[:, 3])} m",
                    expected=f"less than {_FARTHEST:g} m",
                )
        n = self.robot.n
        reference = np.zeros(n) if near is None else np.asarray(near, np.float64)
        if reference.shape != (n,) or not np.isfinite(reference).all():
            raise InputError(
                f"{self.robot.name}: this is no reference for {n} joints",
                found=f"shape {list(reference.shape)}",
                expected=f"[{n}], finite",
            )
        posed = self._posed(poses, reference)
        alone = isinstance(self.solver, Numerical) and self.solver.alone
        further = self._from_elsewhere if alone else self._by_least_squares
        return [each if each.reached else further(each) for each in posed]

    def branches(self, T: Floats, near: Floats) -> tuple[Floats, NDArray[np.bool_]]:
        """The positions [K, b, n] of all branches for poses [K, 3, 4], and which [K, b] reach their pose
        within the limits; ``near`` [n] as in :meth:`solve`, or [K, n]."""
        every = self._evaluated(_FUNCTIONS[0], T, near)
        return every.q, every.flags[:, :, 0] & every.flags[:, :, 1]

    def _from_elsewhere(self, posed: Posed) -> Posed:
        """A pose that is not reached by iteration from the reference, by iteration from other positions: of
        those that are reached the nearest to where it would have ended, else the best there is."""
        low, high = drawn_between(self.robot, *position_limits(self.robot).T)
        starts = np.random.default_rng(0).uniform(low, high, (STARTS, self.robot.n))
        tried = self._posed(np.repeat(posed.T[None], STARTS, axis=0), starts)

        def badness(other: Posed) -> tuple[bool, float, float]:
            one = other.nearest
            missed = 0.0 if one.exists else sum(one.off)
            return not one.exists, missed, float(np.abs(one.q - posed.nearest.q).max())

        return min((posed, *tried), key=badness)

    def _by_least_squares(self, posed: Posed) -> Posed:
        """A pose that no branch reaches, with all joints free within their limits: from every branch to where
        the sum of squares of what is missing is least, lengths as shares of the arm's size, and the least of
        these. A redundant arm may reach the pose, with its joint elsewhere than the reference has it."""
        from scipy.optimize import least_squares

        T, size = posed.T, float(self.solver.size)
        low, high = position_limits(self.robot).T

        def missing(q: Floats) -> Floats:
            pose = self.pose(q)
            place = (pose[:, 3] - T[:, 3]) / size
            if self.place_only:
                return np.asarray(place)
            return np.concatenate([place, rotation_vector(T[:, :3] @ pose[:, :3].T)])

        starts = np.unique([np.clip(solution.q, low, high) for solution in posed.solutions], axis=0)
        limits = {"bounds": (low, high), "max_nfev": _EVALUATIONS}
        ends = [
            least_squares(missing, start, xtol=1e-15, ftol=1e-15, gtol=1e-15, **limits) for start in starts
        ]
        q = min(ends, key=lambda end: float(end.cost)).x
        endless = np.isinf(high - low) & is_revolute(self.robot)
        q = np.where(endless, closest_turns(q, np.zeros_like(q)), q)
        (off,) = self._off(T, q[None])
        solution = Solution(LEAST_SQUARES, q, max(off) < _REACHED, True, False, off)
        return replace(posed, nearest=solution)

    def _posed(self, poses: Floats, near: Floats) -> list[Posed]:
        """The solutions of all poses at once, from one reference [n] or one each [K, n]."""
        every, best = (self._evaluated(name, poses, near) for name in _FUNCTIONS)
        names = self.solver.branch_names
        posed = []
        for k, T in enumerate(poses):
            off = self._off(T, every.q[k])
            solutions = tuple(
                _solution(name, every.q[k, b], every.flags[k, b], off[b]) for b, name in enumerate(names)
            )
            (missed,) = self._off(T, best.q[k])
            nearest = _solution(names[best.branch[k]], best.q[k, 0], best.flags[k, 0], missed)
            if not nearest.exists:  # nearest to the pose then, not to the reference
                nearest = min(solutions, key=lambda solution: solution.off)
            posed.append(Posed(T, solutions, nearest))
        return posed

    def _evaluated(self, function: str, poses: Floats, near: Floats) -> _Evaluated:
        """What the program of ``function`` gives for all poses."""
        program, count = self._programs[function], len(poses)
        inputs: dict[Input, Any] = {Input("T", k): x for k, x in enumerate(poses.reshape(-1, 12).T)}
        inputs |= {Input("q_near", k): np.float64(x) for k, x in enumerate(near.T)}
        with np.errstate(all="ignore"):  # what is not chosen may divide by zero
            results = evaluate(program, inputs, functions=_OF_ARRAYS)
        answers = function_named(function).answers
        assert answers is not None

        def rows(name: str) -> Floats:
            return np.stack([np.broadcast_to(x, count) for x in results[name]], axis=-1)

        flags = np.stack([rows(name) > 0 for name in answers[1:4]], axis=-1)
        branch = rows(answers.branch)[:, 0].astype(int) if answers.branch else np.zeros(count, int)
        return _Evaluated(rows(answers.solutions).reshape(count, -1, self.robot.n), flags, branch)

    @cached_property
    def _programs(self) -> dict[str, Program]:
        # As they are written: what a pose is off is looked at each time.
        return {name: build(self.robot, name, Choice()) for name in _FUNCTIONS}

    def _off(self, T: Floats, q: Floats) -> list[tuple[float, float]]:
        """How far the tool is off ``T`` at ``q`` [b, n]: place [m], angle [rad]."""
        poses = self.pose(q)
        places = np.linalg.norm(poses[:, :, 3] - T[:, 3], axis=1)
        if self.place_only:
            return [(float(x), 0.0) for x in places]
        turns = [float(np.linalg.norm(rotation_vector(T[:, :3] @ R[:, :3].T))) for R in poses]
        return list(zip(places.tolist(), turns, strict=True))


def _solution(name: str, q: Floats, flags: NDArray[np.bool_], off: tuple[float, float]) -> Solution:
    exists, within, singular = flags.tolist()
    return Solution(name, q, exists, within, singular, off)
