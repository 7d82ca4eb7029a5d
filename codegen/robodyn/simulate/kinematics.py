"""Where a robot's point is and how it moves, in numbers: one state or many at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from robodyn.arrays import Floats
from robodyn.dynamics.arm import Arm, JointAngle, build_arm, build_motion
from robodyn.dynamics.kinematics import frames, jacobian, jacobian_rate
from robodyn.dynamics.vectors import Frame
from robodyn.errors import InputError
from robodyn.robot.filling import parameter_values
from robodyn.robot.model import Robot


class Kinematics:
    """Kinematics of a point of ``robot`` at given values of its run-time parameters.

    ``point`` [3] (m) is fixed in the frame of ``link`` (1..n, by default the last). Every method takes
    one state ``[n]`` or many ``[N, n]`` (rad or m, and per second) and returns as many; all results are in
    the base frame, or in the world's where the description has ``base``.

    Raises
    ------
    InputError: a run-time parameter has no value, there is no such link, or an array has the wrong shape.
    """

    def __init__(
        self,
        robot: Robot,
        parameters: Mapping[str, float] | None = None,
        point: Sequence[float] = (0.0, 0.0, 0.0),
        link: int | None = None,
    ) -> None:
        if link is not None and not 1 <= link <= robot.n:
            raise InputError(
                f"{robot.name} has no such link", found=f"link {link}", expected=f"1 to {robot.n}"
            )
        if len(point) != 3 or not all(math.isfinite(x) for x in point):
            raise InputError("a point is three numbers", found=str(list(point)), expected="[x, y, z] in m")
        self.robot = robot
        self.parameters = parameter_values(robot, parameters)
        self.point = (float(point[0]), float(point[1]), float(point[2]))
        self.link = robot.n if link is None else link
        self._arm: Arm = build_arm(robot, float, self.parameters.__getitem__)
        self._turns = [(float(body.theta.cos), float(body.theta.sin)) for body in self._arm.bodies]

    def position(self, q: ArrayLike) -> Floats:
        """The point [m], ``[3]`` or ``[N, 3]``."""
        placed, lead, _ = self._frames(q)
        return _gathered(placed[self.link - 1].place(self.point), lead)

    def pose(self, q: ArrayLike) -> tuple[Floats, Floats]:
        """The point [m], ``[3]`` or ``[N, 3]``, and its link's rotation, ``[3, 3]`` or ``[N, 3, 3]``."""
        placed, lead, _ = self._frames(q)
        frame = placed[self.link - 1]
        return _gathered(frame.place(self.point), lead), _gathered(frame.rotation(), lead)

    def frames(self, q: ArrayLike) -> tuple[Floats, Floats]:
        """All links' origins [m], ``[n, 3]`` or ``[N, n, 3]``, and rotations, ``[n, 3, 3]`` or
        ``[N, n, 3, 3]``."""
        placed, lead, _ = self._frames(q)
        origins = _gathered([frame.origin for frame in placed], lead)
        return origins, _gathered([frame.rotation() for frame in placed], lead)

    def jacobian(self, q: ArrayLike) -> Floats:
        """Geometric Jacobian, ``[6, n]`` or ``[N, 6, n]``: three linear rows, then three angular ones."""
        placed, lead, _ = self._frames(q)
        return _gathered(jacobian(self._arm, placed, self.point, self.link), lead)

    def jacobian_rate(self, q: ArrayLike, qd: ArrayLike) -> Floats:
        """Time derivative of the Jacobian at the joint rates ``qd``; of the Jacobian's shape."""
        placed, lead, (rates,) = self._frames(q, qd)
        return _gathered(jacobian_rate(self._arm, placed, rates, self.point, self.link), lead)

    def _frames(self, q: ArrayLike, *rest: ArrayLike) -> tuple[list[Frame], tuple[int, ...], list[Any]]:
        """Frames at ``q``, the shape that stands before a result's own, and ``rest`` joint by joint.

        The scalars are floats for one state (numpy is slow at single numbers) and ``[N]`` arrays for many.
        """
        n = self.robot.n
        arrays = [np.asarray(array, dtype=np.float64) for array in (q, *rest)]
        shape = arrays[0].shape
        if not 1 <= len(shape) <= 2 or shape[-1] != n or any(array.shape != shape for array in arrays):
            raise InputError(
                f"{self.robot.name}: states of the wrong shape",
                found=", ".join(str(list(array.shape)) for array in arrays),
                expected=f"[{n}] or [N, {n}] each",
            )
        if not np.isfinite(arrays[0]).all():
            raise InputError(f"{self.robot.name}: joint positions that are not finite", expected="numbers")
        one = len(shape) == 1
        joints = [array.tolist() if one else list(array.T) for array in arrays]
        cos: Callable[[Any], Any] = math.cos if one else np.cos
        sin: Callable[[Any], Any] = math.sin if one else np.sin

        def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
            joint = angle.terms[0][0]
            c, s = cos(joints[0][joint]), sin(joints[0][joint])
            ct, st = self._turns[joint]
            return c * ct - s * st, s * ct + c * st

        zeros = [0.0] * n
        motion = build_motion(self._arm, joints[0], zeros, zeros, trigonometry, float)
        return frames(self._arm, motion, self._arm.base), shape[:-1], joints[1:]


def _gathered(nested: Any, lead: tuple[int, ...]) -> Floats:
    """Nested sequences of scalars as one array, states first; a single number holds for all states."""
    if not lead:
        return np.array(nested, dtype=np.float64)
    if isinstance(nested, (list, tuple)):
        return np.stack([_gathered(x, lead) for x in nested], axis=1)
    return np.broadcast_to(np.asarray(nested, dtype=np.float64), lead)


# --- positions and rotations --------------------------------------------------------------------------------


def is_revolute(robot: Robot) -> list[bool]:
    """Which joints [n] turn."""
    return [link.joint.kind == "revolute" for link in robot.links]


def closest_turns(q: Floats, near: Floats) -> Floats:
    """``q`` [.., n] (rad) with whole turns added, so that each is within half a turn of ``near``."""
    return q - math.tau * np.round((q - near) / math.tau)


def position_limits(robot: Robot) -> Floats:
    """Lowest and highest position of each joint [n, 2] (rad or m); infinite where the robot states none."""
    none = (-math.inf, math.inf)
    bounds = [link.joint.limits.position or none for link in robot.links]
    return np.array([[float(low), float(high)] for low, high in bounds])


def drawn_between(robot: Robot, low: Floats, high: Floats) -> tuple[Floats, Floats]:
    """Between what positions are drawn [n]: the limits, or within pi or 1 m where there are none."""
    reach = np.where(is_revolute(robot), math.pi, 1.0)
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
