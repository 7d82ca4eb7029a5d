"""Where a robot's point is and how it moves, in numbers: one state or many at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robodyn.dynamics.arm import Arm, JointAngle, build_arm, build_motion
from robodyn.dynamics.kinematics import frames, jacobian, jacobian_rate
from robodyn.dynamics.vectors import BASE, Frame
from robodyn.errors import InputError
from robodyn.robot.model import Placement, Robot
from robodyn.verify.numbers import Parameters, filled, real

Floats = NDArray[np.float64]


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
        parameters: Parameters | None = None,
        point: Sequence[float] = (0.0, 0.0, 0.0),
        link: int | None = None,
    ) -> None:
        if link is not None and not 1 <= link <= robot.n:
            raise InputError(
                f"{robot.name} has no such link", found=f"link {link}", expected=f"1 to {robot.n}"
            )
        if len(point) != 3 or not all(math.isfinite(x) for x in point):
            raise InputError("a point is three numbers", found=str(list(point)), expected="[x, y, z] in m")
        values = filled(robot, parameters)
        self.robot = robot
        self.parameters = values
        self.point = (float(point[0]), float(point[1]), float(point[2]))
        self.link = robot.n if link is None else link
        self._arm: Arm = build_arm(robot, real, lambda name: float(values[name]))
        self._base = BASE if robot.base is None else _frame(robot.base)
        self._turns = [(float(link.joint.theta.cos), float(link.joint.theta.sin)) for link in robot.links]

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

    def pose_and_jacobian(self, q: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """:meth:`pose` and :meth:`jacobian` from one pass along the arm."""
        placed, lead, _ = self._frames(q)
        frame = placed[self.link - 1]
        columns = jacobian(self._arm, placed, self.point, self.link)
        return (
            _gathered(frame.place(self.point), lead),
            _gathered(frame.rotation(), lead),
            _gathered(columns, lead),
        )

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
        motion = build_motion(self._arm, joints[0], zeros, zeros, trigonometry, real)
        return frames(self._arm, motion, self._base), shape[:-1], joints[1:]


def _frame(place: Placement) -> Frame:
    x, y, z = (tuple(map(float, column)) for column in zip(*place.rotation, strict=True))
    return Frame(tuple(map(float, place.xyz)), x, y, z)  # type: ignore[arg-type]


def _gathered(nested: Any, lead: tuple[int, ...]) -> Floats:
    """Nested sequences of scalars as one array, states first; a single number holds for all states."""
    if not lead:
        return np.array(nested, dtype=np.float64)
    shape: list[int] = []
    level = nested
    while isinstance(level, (list, tuple)):
        shape.append(len(level))
        level = level[0]
    result = np.empty((*lead, *shape))
    for index in np.ndindex(*shape):
        value = nested
        for i in index:
            value = value[i]
        result[(slice(None), *index)] = value
    return result
