"""Inverse kinematics in closed form of the first three joints of arms built like the PUMA 560.

The first axis is vertical, the second and third are parallel and horizontal (alpha 0, -pi/2, 0). With
u the horizontal distance from the shoulder to the point in the arm's plane, d the shoulder's offset, a
the upper arm and f the distance from the elbow to the point,

    u = +- sqrt(x^2 + y^2 - d^2),   cos psi = (u^2 + z^2 - a^2 - f^2) / (2 a f)

where psi is the bend at the elbow. The two signs, of u and of psi, make four branches.
Source: Craig, Introduction to Robotics, 4.7; the thesis's program D.1.3. Both signs are those of their roots.

That program measures the point along +y of frame 3, whereas Table 2.1 of the thesis (alpha = pi/2 before
link 4) and the load of its simulation D.4 have the forearm along -y: its angles are those of a negative
``forearm`` here.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from robodyn.arrays import Floats
from robodyn.errors import InputError
from robodyn.robot.model import Robot
from robodyn.simulate.kinematics import closest_turns
from robodyn.verify.numbers import exact_value, filled, real

#: Signs of u (+1 and -1: the two shoulders) and of psi (the two elbows).
Branch = tuple[int, int]
BRANCHES: tuple[Branch, ...] = ((1, 1), (1, -1), (-1, 1), (-1, -1))

_TURN = 2 * math.pi
_LARGEST_JUMP = math.pi / 2
_ROUNDING = 1e-14  # what a distance at the edge of reach may be off by, as a share of the arm


@dataclass(frozen=True, slots=True)
class PumaArm:
    """Lengths [m] of the first three joints of an arm like the PUMA 560.

    ``offset`` is d2 + d3, ``upper`` a2; the point is at ``(elbow, -forearm, 0)`` of frame 3 (``elbow`` is
    a3 and ``forearm`` d4 where the point is the wrist and alpha3 is pi/2). ``zero`` [3] (rad) is what the
    joints' theta add.
    """

    offset: float
    upper: float
    forearm: float
    elbow: float = 0.0
    zero: tuple[float, float, float] = (0.0, 0.0, 0.0)

    @classmethod
    def of(cls, robot: Robot, point: Sequence[float] | None = None) -> PumaArm:
        """The first three joints of ``robot``, which is built like this; ``point`` [3] (m) in frame 3, by
        default frame 4's origin."""
        joints, values = [link.joint for link in robot.links], filled(robot, None)

        def length(joint: int, name: str) -> float:
            return real(exact_value(getattr(joints[joint], name), values))

        if point is None:
            alpha, along = joints[3].alpha, length(3, "d")
            point = (length(3, "a"), -float(alpha.sin) * along, float(alpha.cos) * along)
        x, y, z = (float(value) for value in point)
        zero = joints[0].theta.radians, joints[1].theta.radians, joints[2].theta.radians
        return cls(length(1, "d") + length(2, "d") + z, length(2, "a"), -y, x, zero)

    def positions(self, point: ArrayLike) -> Floats:
        """Joint positions [rad], (-pi, pi], that bring the point to ``point`` (m, in the base).

        ``[3]`` gives ``[4, 3]``, one row a branch in the order of :data:`BRANCHES`; ``[K, 3]`` gives
        ``[K, 4, 3]``. Straight above the shoulder or at it some angle is free, and is 0.

        Raises
        ------
        InputError: a point is out of reach.
        """
        target = np.asarray(point, dtype=np.float64)
        if not 1 <= target.ndim <= 2 or target.shape[-1] != 3 or not np.isfinite(target).all():
            found = f"shape {list(target.shape)}"
            raise InputError("this is not a point", found=found, expected="[3] or [K, 3] in m")
        x, y, z = target.reshape(-1, 3).T
        d, a, f = self.offset, abs(self.upper), math.hypot(self.forearm, self.elbow)
        from_axis = np.hypot(x, y)
        self._reached(target, from_axis, abs(d), math.inf, "from the axis of joint 1")
        r = np.sqrt(np.maximum((from_axis - abs(d)) * (from_axis + abs(d)), 0.0))
        from_shoulder = np.hypot(r, z)
        self._reached(target, from_shoulder, abs(a - f), a + f, "from the shoulder, in the arm's plane")
        bend = 2 * np.arctan2(  # the half angle keeps its digits near a stretched or a folded arm
            np.sqrt(np.maximum((a + f - from_shoulder) * (a + f + from_shoulder), 0.0)),
            np.sqrt(np.maximum((from_shoulder - abs(a - f)) * (from_shoulder + abs(a - f)), 0.0)),
        )
        branches = []
        for shoulder, elbow in BRANCHES:
            u, psi = shoulder * r, elbow * bend + (math.pi if self.upper < 0 else 0.0)
            along, across = self.upper + f * np.cos(psi), f * np.sin(psi)
            q1 = np.arctan2(y * u - x * d, x * u + y * d)
            q2 = np.arctan2(-z * along - u * across, u * along - z * across)
            branches.append(np.stack([q1, q2, psi - math.atan2(-self.forearm, self.elbow)], axis=1))
        positions: Floats = np.stack(branches, axis=1) - np.array(self.zero)
        positions -= _TURN * np.ceil(positions / _TURN - 0.5)
        return positions.reshape((*target.shape[:-1], 4, 3))

    def continuous(
        self, path: ArrayLike, branch: Branch = (1, 1), near: Sequence[float] | None = None
    ) -> Floats:
        """Joint positions [K, 3] (rad) along the sampled ``path`` [K, 3] (m, in the base).

        The first sample is on ``branch``, in the turns closest to ``near`` [3] (rad; by default within
        (-pi, pi]); every other on the branch and in the turns closest to the sample before.

        Raises
        ------
        InputError: a sample is out of reach; a joint would jump by more than pi/2 between two samples.
        """
        choices = self.positions(np.atleast_2d(np.asarray(path, dtype=np.float64)))
        start = choices[0, BRANCHES.index(branch)]
        joints = np.empty((len(choices), 3))
        joints[0] = start if near is None else closest_turns(start, np.asarray(near, dtype=np.float64))
        for k in range(1, len(choices)):
            near_last = closest_turns(choices[k], joints[k - 1])
            steps = np.abs(near_last - joints[k - 1])
            best = int(np.argmin((steps**2).sum(axis=1)))
            if steps[best].max() > _LARGEST_JUMP:
                raise InputError(
                    f"sample {k + 1} of the path: joint {int(np.argmax(steps[best])) + 1} would jump",
                    found=f"{steps[best].max():.3g} rad from the sample before",
                    expected="at most pi/2",
                    remedy="sample the path more finely, or keep it away from the axis of joint 1",
                )
            joints[k] = near_last[best]
        return joints

    def _reached(self, target: Floats, distance: Floats, low: float, high: float, place: str) -> None:
        """Refuses the first point of ``target`` whose ``distance`` is not within ``low`` and ``high``."""
        slack = _ROUNDING * (abs(self.offset) + abs(self.upper) + math.hypot(self.forearm, self.elbow))
        bad = np.flatnonzero((distance < low - slack) | (distance > high + slack))
        if len(bad):
            which = "the point" if len(distance) == 1 else f"point {bad[0] + 1} of {len(distance)}"
            x, y, z = target.reshape(-1, 3)[bad[0]]
            raise InputError(
                f"{which}, [{x:.6g}, {y:.6g}, {z:.6g}], is out of reach",
                found=f"{distance[bad[0]]:.6g} m {place}",
                expected=f"at least {low:.6g} m" if high == math.inf else f"{low:.6g} to {high:.6g} m",
            )
