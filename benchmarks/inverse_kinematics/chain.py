"""An arm as axes in space, its poses and its Jacobian, by the product of exponentials in plain doubles.

Nothing here comes from what is measured: neither the recursion nor the emitted code.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.robot.model import Joint, Placement, Robot
from robodyn.verify.numbers import exact_value

Floats = NDArray[np.float64]

#: Stroke of a slide of which none is stated [m].
_STROKE = (0.1, 1.0)


@dataclass(frozen=True, slots=True)
class Chain:
    """An arm of ``n`` joints where all are at 0: unit vectors along their ``axes`` [n, 3] and ``points`` on
    them [n, 3] (m), which joints turn [n], and the pose ``home`` [4, 4] of the tool, all in the world.

    ``limits`` [n, 2] are of the positions (rad, m), infinite where there are none.
    """

    name: str
    axes: Floats
    points: Floats
    home: Floats
    revolute: NDArray[np.bool_]
    limits: Floats

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.axes)

    @property
    def reach(self) -> float:
        """Way from the first axis to the tool [m], from point to point, with all slides drawn out."""
        stations = np.vstack([self.points, self.home[:3, 3]])
        slides = np.abs(np.array(self.ranges())[:, ~self.revolute]).max(axis=0, initial=0.0)
        return float(np.linalg.norm(np.diff(stations, axis=0), axis=1).sum() + slides.sum())

    def ranges(self) -> tuple[Floats, Floats]:
        """From where to where positions are drawn [n]: half a turn to each side whatever the limits, and the
        strokes of slides."""
        stroke = np.where(np.isfinite(self.limits), self.limits, _STROKE)
        low = np.where(self.revolute, -np.pi, stroke[:, 0])
        return low, np.where(self.revolute, np.pi, stroke[:, 1])

    def offsets(self) -> Floats:
        """From the world's origin to the first point, from point to point, from the last one to the tool
        [n + 1, 3]."""
        return np.diff(np.vstack([np.zeros(3), self.points, self.home[:3, 3]]), axis=0)

    def poses(self, q: Floats) -> Floats:
        """The tool [N, 4, 4] at the positions ``q`` [N, n]."""
        return self._placed(q)[0]

    def jacobians(self, q: Floats) -> Floats:
        """Rates of the tool's origin (m) and of its rotation (rad) in the world [N, 6, n]."""
        poses, axes, points = self._placed(q)
        turning = np.concatenate([np.cross(axes, poses[:, None, :3, 3] - points), axes], axis=2)
        sliding = np.concatenate([axes, np.zeros_like(axes)], axis=2)
        return np.where(self.revolute[:, None], turning, sliding).transpose(0, 2, 1)

    def _placed(self, q: Floats) -> tuple[Floats, Floats, Floats]:
        """The tool [N, 4, 4], and the axes and points [N, n, 3] where the joints have taken them."""
        R = np.broadcast_to(np.eye(3), (len(q), 3, 3))
        p = np.zeros((len(q), 3))
        axes, points = np.empty((len(q), self.n, 3)), np.empty((len(q), self.n, 3))
        for i, (axis, point) in enumerate(zip(self.axes, self.points, strict=True)):
            axes[:, i], points[:, i] = R @ axis, R @ point + p
            if self.revolute[i]:
                turn = _turned(axis, q[:, i])
                p = p + np.einsum("kij,kj->ki", R, point - turn @ point)
                R = R @ turn
            else:
                p = p + axes[:, i] * q[:, i, None]
        tool = np.zeros((len(q), 4, 4))
        tool[:, :3, :3], tool[:, :3, 3], tool[:, 3, 3] = R @ self.home[:3, :3], R @ self.home[:3, 3] + p, 1.0
        return tool, axes, points


def chain_of(robot: Robot) -> Chain:
    """The axes of ``robot``."""
    at, axes, points = _frame(robot.base), [], []
    for link in robot.links:
        at = at @ _row(link.joint)
        axes.append(at[:3, 2])
        points.append(at[:3, 3])
    stated = [link.joint.limits.position for link in robot.links]
    limits = [(-np.inf, np.inf) if pair is None else (float(pair[0]), float(pair[1])) for pair in stated]
    revolute = np.array([link.joint.kind == "revolute" for link in robot.links])
    home = at @ _frame(robot.tool)
    return Chain(robot.name, np.array(axes), np.array(points), home, revolute, np.array(limits))


def _row(joint: Joint) -> Floats:
    """A modified Denavit-Hartenberg row with the joint at 0: twist about x, offset, turn about z."""
    ca, sa, ct, st = (float(x) for x in (joint.alpha.cos, joint.alpha.sin, joint.theta.cos, joint.theta.sin))
    a, b, d = (float(exact_value(x, {})) for x in (joint.a, joint.b, joint.d))
    twist = np.array([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
    turn = np.array([[ct, -st, 0, 0], [st, ct, 0, b], [0, 0, 1, d], [0, 0, 0, 1]])
    return np.asarray(twist @ turn, dtype=np.float64)


def _frame(placement: Placement | None) -> Floats:
    frame = np.eye(4)
    if placement is not None:
        frame[:3, :3] = [[float(x) for x in row] for row in placement.rotation]
        frame[:3, 3] = [float(x) for x in placement.xyz]
    return frame


def _turned(axis: Floats, angle: Floats) -> Floats:
    """Rotations [N, 3, 3] about one axis."""
    x, y, z = axis
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    s, c = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    return np.asarray(np.eye(3) * c + K * s + np.outer(axis, axis) * (1 - c))
