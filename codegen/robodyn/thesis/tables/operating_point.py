"""Where on the case study's line Table 3.5 could have been taken, and how small joint friction could be.

At a place z of the line y = z, torques and reactions of the rigid arm are affine in the acceleration a along
the line and in the square w of the velocity: three states give both for all of a and w. Two journals take
at least the force between them, so that Eq 3.3, corrected or not, is never below
``mu r sqrt(f_x^2 + f_y^2)``, whatever the span.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.dynamics.arm import build_arm, build_motion, trigonometry_at
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.ir.program import Label
from robodyn.robot.model import Robot
from robodyn.thesis.case_arm import D4_BRANCH, FOREARM, Led, led, led_at
from robodyn.thesis.printed import TABLE_3_4, TABLE_3_5, bundled
from robodyn.thesis.puma_inverse import BRANCHES
from robodyn.verify.numbers import real

#: Four sets of parameters that the thesis has for this arm; that of D.1.1, the fifth, has no rotors.
SETS: Final = ("puma560_3dof", "puma560_3dof_d3", "puma560_3dof_d12", "puma560_3dof_d4")
#: x of the line as D.4's start has it, and as the thesis prints it; y = z within reach [m].
LINES: Final = ((0.4, 0.548), (0.3, 0.579))
#: Spacing of places [m], and of those from which the nearest is taken.
_STEP: Final = 0.01
_FINE: Final = 0.0025
_A: Final = np.linspace(-6.0, 6.0, 49)
_W: Final = np.linspace(0.0, 4.0, 33)


def printed_torques() -> Floats:
    """The column "dynamic" [3] (N m)."""
    return np.array([float(row.dynamic) for row in TABLE_3_5])


@dataclass(frozen=True, slots=True, eq=False)
class Places:
    """Places z [K] (m) of a line on a branch: joint positions, rates and second rates [K, 3] at unit velocity
    and no acceleration along the line."""

    z: Floats
    q: Floats
    qd: Floats
    qdd: Floats

    def where(self, kept: NDArray[np.bool_]) -> Places:
        """Those of the places that are ``kept`` [K]."""
        return Places(self.z[kept], self.q[kept], self.qd[kept], self.qdd[kept])

    @property
    def fitting(self) -> NDArray[np.bool_]:
        """Whether the joints can turn as in Table 3.5, up or down the line [K]."""
        signs = np.sign(self.qd) * [row.direction for row in TABLE_3_5]
        fits: NDArray[np.bool_] = (signs == signs[:, :1]).all(axis=1)
        return fits


def places(arm: Led, x: float, reach: float, branch: tuple[int, int], step: float) -> Places:
    """Places every ``step`` [m] along the line at ``x`` [m], as far as ``reach`` [m]."""
    z = np.arange(-reach, reach, step)
    q = arm.inverse.positions(np.stack([np.full_like(z, x), z, z], axis=1))[:, BRANCHES.index(branch)]
    J = arm.kinematics.jacobian(q)[:, :3]
    qd = np.linalg.solve(J, np.tile([[0.0], [1.0], [1.0]], (len(z), 1, 1)))[..., 0]
    Jd = arm.kinematics.jacobian_rate(q, qd)[:, :3]
    qdd = np.asarray(-np.linalg.solve(J, Jd @ qd[..., None])[..., 0], dtype=np.float64)
    return Places(z, q, qd, qdd)


def affine(robot: str, at: Places) -> list[tuple[Floats, Floats, Floats]]:
    """Torques [K, 3] and reactions [K, 3, 3] of the bundled ``robot`` as ``still + a ahead + w fast``."""
    none = np.zeros_like(at.q)
    states = ((none, none), (none, at.qd), (at.qd, at.qdd))
    runs = (reactions(bundled(robot), at.q, *rates) for rates in states)
    return [(still, ahead - still, fast - still) for still, ahead, fast in zip(*runs, strict=True)]


def reactions(robot: Robot, q: Floats, qd: Floats, qdd: Floats) -> tuple[Floats, Floats]:
    """Torques [K, n] and forces in the joints [K, n, 3], along the links' axes, of the rigid arm."""
    none: dict[str, float] = {}
    arm = build_arm(robot, real, none.__getitem__)
    f = np.zeros((*q.shape, 3))

    def mark(value: Any, label: Label) -> Any:
        if label.quantity == "f":
            f[:, label.link - 1, "xyz".index(label.axis)] = value
        return value

    motion = build_motion(arm, list(q.T), list(qd.T), list(qdd.T), trigonometry_at(list(q.T)), real)
    tau = newton_euler(arm, motion, mark)
    return np.stack([np.broadcast_to(x, len(q)) for x in tau], axis=1), f


def closest(robot: str, at: Places) -> tuple[float, float]:
    """How near the torques of ``at`` come to Table 3.5's, root of a sum of squares [N m], and at which z."""
    still, ahead, fast = affine(robot, at)[0]
    wanted = printed_torques() - still
    both = np.linalg.pinv(np.stack([ahead, fast], axis=2)) @ wanted[..., None]
    rest = wanted - np.maximum(both[:, 1], 0.0) * fast
    a = (rest * ahead).sum(axis=1, keepdims=True) / (ahead**2).sum(axis=1, keepdims=True)
    size = np.linalg.norm(rest - a * ahead, axis=1)
    k = int(size.argmin())
    return float(size[k]), float(at.z[k])


def least_friction(robot: str, at: Places, tolerance: float) -> tuple[float, float] | None:
    """The least that bearings of joints 2 and 3 take by Table 3.4 [N m] where all three torques are within
    ``tolerance`` [N m] of Table 3.5; None where they nowhere are."""
    if not len(at.z):
        return None
    torques, forces = affine(robot, at)
    still, ahead, fast = (part[:, None, None] for part in torques)
    tau = still + _A[:, None, None] * ahead + _W[:, None] * fast
    k, i, j = np.nonzero((np.abs(tau - printed_torques()) <= tolerance).all(axis=-1))
    if not len(k):
        return None
    f0, fa, fw = (part[k, 1:, :2] for part in forces)
    force = f0 + _A[i, None, None] * fa + _W[j, None, None] * fw
    least = np.linalg.norm(force, axis=2).min(axis=0)
    second, third = (
        float(drive.mu * drive.radius) * float(size) for drive, size in zip(TABLE_3_4[1:], least, strict=True)
    )
    return second, third


def everywhere(step: float) -> Iterator[Places]:
    """All places where the joints can turn as in Table 3.5: both lines, all branches, the point along +y of
    frame 3 as in D.1.3 and along -y."""
    first = led("programs")
    for arm in (first, led_at(replace(first.kinematics.robot, name="puma560_turned"), -FOREARM)):
        for x, reach in LINES:
            for branch in BRANCHES:
                states = places(arm, x, reach, branch, step)
                yield states.where(states.fitting)


@cache
def bounds(tolerance: float) -> dict[str, tuple[float, float]]:
    """:func:`least_friction` of every set over all places."""
    result: dict[str, tuple[float, float]] = {}
    for at in everywhere(_STEP):
        for name in SETS:
            least = least_friction(name, at, tolerance)
            if least is not None:
                before = result.get(name, least)
                result[name] = (min(before[0], least[0]), min(before[1], least[1]))
    return result


@cache
def nearest() -> dict[str, float]:
    """How near the torques of every set come to Table 3.5's [N m], of all places every 2.5 mm."""
    found = [at for at in everywhere(_FINE) if len(at.z)]
    return {name: min(closest(name, at)[0] for at in found) for name in SETS}


@cache
def on_the_path_of_d4() -> Places:
    """Places of the line at x = 0.4 on the branch on which D.4 begins, every 2.5 mm."""
    x, reach = LINES[0]
    return places(led("programs"), x, reach, D4_BRANCH, _FINE)
