"""Inverse kinematics of any arm by damped least squares, within the joints' limits.

The step is Levenberg's and Marquardt's, ``dq = J^T (J J^T + damping^2 1)^-1 error``, over the joints that do
not stand at a limit that the step would cross; the damping falls with the error, so that convergence is
quadratic in the end (T. Sugihara, IEEE Trans. Robotics 27, 2011).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robodyn.errors import InputError
from robodyn.robot.model import Robot
from robodyn.simulate.kinematics import Kinematics

Floats = NDArray[np.float64]

_STEPS = 300
_REFUSALS = 12  # steps in a row that do not lower the error before a start is given up
_LARGEST_JUMP = math.pi / 2
_TURN = 2 * math.pi


@dataclass(frozen=True, slots=True)
class InverseKinematics:
    """Joint positions that bring a point of an arm to a place, or its link to a pose.

    ``limits`` [n, 2] (rad or m): lowest and highest position of each joint; by default the robot's own, none
    where it states none. An error is ``[3]`` (m), of a pose ``[6]`` (m, then rad of the rotation vector), and
    its largest entry counts against ``tolerance``. ``starts`` joint positions are tried, the same for the
    same ``seed``. At the very edge of reach, where solutions meet, convergence is slow and a looser tolerance
    may be needed.

    Raises
    ------
    InputError: limits of the wrong shape or empty.
    """

    kinematics: Kinematics
    limits: ArrayLike | None = None
    tolerance: float = 1e-10
    starts: int = 20
    seed: int = 0

    def __post_init__(self) -> None:
        robot = self.kinematics.robot
        bounds = position_limits(robot) if self.limits is None else np.array(self.limits, dtype=np.float64)
        if bounds.shape != (robot.n, 2) or not (bounds[:, 0] < bounds[:, 1]).all():
            raise InputError(
                f"{robot.name}: these are no limits of joint positions",
                found=str(bounds.tolist()),
                expected=f"[{robot.n}, 2], lowest before highest",
            )
        object.__setattr__(self, "limits", bounds)

    def solve(
        self, point: ArrayLike, rotation: ArrayLike | None = None, start: ArrayLike | None = None
    ) -> Floats:
        """Joint positions [n] (rad or m) with the point at ``point`` [3] (m), the link at ``rotation``.

        ``rotation`` [3, 3] may be left open. The search begins at ``start`` [n] and what it finds is in the
        turns closest to it; by default at the middle of the limits (0 where there are none).

        Raises
        ------
        InputError: the place cannot be reached from any start; says how near the arm came.
        """
        target, turn = _target(point, rotation)
        low, high = drawn_between(self.kinematics.robot, *self._bounds())
        first = (low + high) / 2 if start is None else self._start(start)
        rng = np.random.default_rng(self.seed)
        nearest = math.inf
        for attempt in range(max(1, self.starts)):
            q, error = self._descend(target, turn, first if attempt == 0 else rng.uniform(low, high))
            if error <= self.tolerance:
                return self._in_turn(q, first)
            nearest = min(nearest, error)
        raise self._unreachable("the pose" if turn is not None else "the point", target, nearest, self.starts)

    def along(
        self, points: ArrayLike, rotations: ArrayLike | None = None, start: ArrayLike | None = None
    ) -> Floats:
        """Joint positions [K, n] (rad or m) along the path ``points`` [K, 3] (m), ``rotations`` [K, 3, 3].

        The first sample is solved from ``start`` as by :meth:`solve`, every other by going on from the two
        samples before, so that the joints move continuously.

        Raises
        ------
        InputError: a sample cannot be reached from the one before, or a joint would jump to it by more than
            pi/2 or 1 m.
        """
        path = np.asarray(points, dtype=np.float64)
        turns = None if rotations is None else np.asarray(rotations, dtype=np.float64)
        if path.ndim != 2 or path.shape[1] != 3 or not len(path):
            raise InputError("this is not a path", found=f"shape {list(path.shape)}", expected="[K, 3] in m")
        if turns is not None and turns.shape != (len(path), 3, 3):
            raise InputError(
                "rotations do not fit the path", found=str(list(turns.shape)), expected=f"[{len(path)}, 3, 3]"
            )
        largest = np.array([_LARGEST_JUMP if r else 1.0 for r in _revolute(self.kinematics.robot)])
        joints = np.empty((len(path), self.kinematics.robot.n))
        low, high = self._bounds()
        for k, target in enumerate(path):
            if k == 0:
                joints[0] = self.solve(target, None if turns is None else turns[0], start)
                continue
            last = joints[k - 1]
            guess = np.clip(2 * last - joints[k - 2], low, high) if k > 1 else last
            turn = None if turns is None else _rotation(turns[k])
            joints[k], error = self._descend(target, turn, guess)
            what = f"sample {k + 1} of the path"
            if error > self.tolerance:
                raise self._unreachable(what, target, error, 1)
            jump = np.abs(joints[k] - last) / largest
            if jump.max() > 1:
                worst = int(np.argmax(jump))
                raise InputError(
                    f"{what}: joint {worst + 1} would jump",
                    found=f"{abs(joints[k, worst] - last[worst]):.3g} from the sample before",
                    expected="at most pi/2 rad or 1 m",
                    remedy="sample the path more finely, or keep it away from singular places",
                )
        return joints

    def _descend(self, target: Floats, turn: Floats | None, start: Floats) -> tuple[Floats, float]:
        """The best joint positions found from ``start`` and their error."""
        low, high = self._bounds()
        q = np.clip(start, low, high)
        error, J = self._error(q, target, turn)
        size = float(error @ error)
        gain, refused = 1.0, 0
        for _ in range(_STEPS):
            if np.abs(error).max() <= 1e-3 * self.tolerance or refused > _REFUSALS:
                break
            step = self._step(q, error, J, gain * size, low, high)
            moved = np.clip(q + step, low, high)
            next_error, next_J = self._error(moved, target, turn)
            next_size = float(next_error @ next_error)
            if next_size < size:
                q, error, J, refused = moved, next_error, next_J, 0
                gain = max(gain / 10, 1e-6)
                if next_size > 0.25 * size and size < self.tolerance**2:
                    break  # down at the rounding of the kinematics
                size = next_size
            else:
                gain, refused = gain * 8, refused + 1
        return q, float(np.abs(error).max())

    def _step(self, q: Floats, error: Floats, J: Floats, damping: float, low: Floats, high: Floats) -> Floats:
        """The damped step of the joints that it does not push across a limit where they stand."""
        free = np.ones(len(q), dtype=bool)
        step = np.zeros(len(q))
        for _ in range(len(q)):
            free_J = J * free
            damped = free_J @ free_J.T + (damping + 1e-16) * np.eye(len(error))
            step = free_J.T @ np.linalg.solve(damped, error)
            blocked = free & (((q <= low) & (step < 0)) | ((q >= high) & (step > 0)))
            if not blocked.any():
                break
            free &= ~blocked
        return step

    def _error(self, q: Floats, target: Floats, turn: Floats | None) -> tuple[Floats, Floats]:
        """What is missing to the target, ``[3]`` or ``[6]``, and the Jacobian's rows for it."""
        position, rotation, J = self.kinematics.pose_and_jacobian(q)
        if turn is None:
            return target - position, J[:3]
        return np.concatenate([target - position, rotation_vector(turn @ rotation.T)]), J

    def _bounds(self) -> tuple[Floats, Floats]:
        bounds = np.asarray(self.limits)
        return bounds[:, 0], bounds[:, 1]

    def _start(self, start: ArrayLike) -> Floats:
        q = np.asarray(start, dtype=np.float64)
        n = self.kinematics.robot.n
        if q.shape != (n,) or not np.isfinite(q).all():
            raise InputError("this is not a start", found=f"shape {list(q.shape)}", expected=f"[{n}], finite")
        return q

    def _in_turn(self, q: Floats, near: Floats) -> Floats:
        """``q`` in the turns closest to ``near`` that the limits allow."""
        low, high = self._bounds()
        turned = np.where(_revolute(self.kinematics.robot), closest_turns(q, near), q)
        allowed: Floats = np.where((turned >= low) & (turned <= high), turned, q)
        return allowed

    def _unreachable(self, what: str, target: Floats, error: float, starts: int) -> InputError:
        x, y, z = target
        return InputError(
            f"{self.kinematics.robot.name}: {what}, [{x:.6g}, {y:.6g}, {z:.6g}], cannot be reached",
            found=f"an error of {error:.3g} at best, from {starts} start{'s' if starts > 1 else ''}",
            expected=f"at most {self.tolerance:g} (m and rad)",
            remedy="move it into the arm's reach, widen the joints' limits, or give another start",
        )


def closest_turns(q: Floats, near: Floats) -> Floats:
    """``q`` [.., n] (rad) with whole turns added, so that each is within half a turn of ``near``."""
    return q - _TURN * np.round((q - near) / _TURN)


def position_limits(robot: Robot) -> Floats:
    """Lowest and highest position of each joint [n, 2] (rad or m); infinite where the robot states none."""
    none = (-math.inf, math.inf)
    bounds = [link.joint.limits.position or none for link in robot.links]
    return np.array([[float(low), float(high)] for low, high in bounds])


def drawn_between(robot: Robot, low: Floats, high: Floats) -> tuple[Floats, Floats]:
    """Between what positions are drawn [n]: the limits, or within pi or 1 m where there are none."""
    reach = np.where(_revolute(robot), math.pi, 1.0)
    lowest = np.where(np.isfinite(low), low, np.minimum(-reach, high - reach))
    return lowest, np.where(np.isfinite(high), high, np.maximum(reach, lowest + reach))


def rotation_vector(R: Floats) -> Floats:
    """Axis times angle [3] (rad, 0 to pi) of the rotation ``R`` [3, 3]."""
    axis = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
    sine, cosine = float(np.linalg.norm(axis)), (float(np.trace(R)) - 1) / 2
    if cosine > -0.99:
        return axis * (math.atan2(sine, cosine) / sine if sine > 1e-8 else 1.0)
    # Near half a turn the axis is in the symmetric part; its sign is the small antisymmetric part's.
    column = int(np.argmax(np.diag(R)))
    u = (R[:, column] + R[column, :]) / 2 - cosine * np.eye(3)[column]
    u = u / np.linalg.norm(u)
    turn: Floats = u * (math.atan2(sine, cosine) if u @ axis >= 0 else -math.atan2(sine, cosine))
    return turn


def _revolute(robot: Robot) -> list[bool]:
    return [link.joint.kind == "revolute" for link in robot.links]


def _target(point: ArrayLike, rotation: ArrayLike | None) -> tuple[Floats, Floats | None]:
    target = np.asarray(point, dtype=np.float64)
    if target.shape != (3,) or not np.isfinite(target).all():
        raise InputError(
            "this is not a point", found=f"shape {list(target.shape)}", expected="[3] in m, finite"
        )
    return target, None if rotation is None else _rotation(np.asarray(rotation, dtype=np.float64))


def _rotation(R: Floats) -> Floats:
    if R.shape != (3, 3) or not np.allclose(R @ R.T, np.eye(3), atol=1e-9) or np.linalg.det(R) < 0:
        raise InputError(
            "this is not a rotation", found=str(R.tolist()), expected="[3, 3], orthogonal, det 1"
        )
    return R
