"""What refitted numbers come to: often nearly what a single mass at one link would do.

Which link's numbers were wrong, or whether a tool is missing, a log can hardly say where nothing is known of
the links. What their weights hold against gravity it does say.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from robodyn.diagnose.limits import BODY_ALIKE, BODY_EXPLAINED, BODY_POSES, BODY_SHARE
from robodyn.gate.gate import Gate
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True)
class OneBody:
    """A ``mass`` [kg], less than 0 where the arm is lighter than described, with its ``centre`` [m] in the
    frame of ``link`` (from 1), that ``explains`` such a share of the difference between two arms' weights."""

    link: int
    mass: float
    centre: tuple[float, float, float]
    explains: float

    def words(self) -> str:
        """As a remark for people."""
        place = ", ".join(f"{1e3 * x:.0f}" for x in self.centre)
        more = "heavier" if self.mass > 0 else "lighter"
        return (
            f"the refitted arm is {more} than described, {100 * self.explains:.0f} % of it as by a mass of "
            f"{abs(self.mass):.3g} kg at [{place}] mm of link {self.link}: a tool, a load, or wrong masses "
            "thereabouts"
        )


def one_body(robot: Robot, refitted: Robot, gates: Sequence[Gate]) -> OneBody | None:
    """The single mass that best explains what the ``refitted`` arm weighs more than ``robot`` in the poses of
    logs; None where that is little, or not of one mass. Of links that do as well it is at the outermost."""
    q = np.concatenate([gate.log.q for gate in gates])
    q = q[:: max(1, len(q) // BODY_POSES)]
    zeros = np.zeros_like(q)
    before, after = (Model(arm) for arm in (robot, refitted))
    weight = before.rigid_torque(q, zeros, zeros)
    difference = (after.rigid_torque(q, zeros, zeros) - weight).reshape(-1)
    if difference @ difference <= BODY_SHARE**2 * float(np.sum(weight**2)):  # both may be 0: no gravity
        return None
    columns = before.regressor(q, zeros, zeros)[..., :4]  # mass, and mass times centre
    bodies = []
    for k in range(robot.n):
        A = columns[:, :, k].reshape(-1, 4)
        scale = np.maximum(np.abs(A).max(axis=0), 1e-9 * np.abs(A).max() + 1e-300)
        # A centre that turns nothing is in the frame's origin.
        x = np.linalg.lstsq(A / scale, difference, rcond=1e-6)[0] / scale
        left = difference - A @ x
        explains = 1 - float(left @ left) / float(difference @ difference)
        if abs(x[0]) > 0:
            bodies.append(OneBody(k + 1, float(x[0]), tuple((x[1:] / x[0]).tolist()), explains))
    reach = _reach(robot)
    bodies = [one for one in bodies if np.linalg.norm(one.centre) < reach]
    best = max((one.explains for one in bodies), default=0.0)
    if best < BODY_EXPLAINED:
        return None
    return max((one for one in bodies if one.explains > best - BODY_ALIKE), key=lambda one: one.link)


def _reach(robot: Robot) -> float:
    """The longest distance [m] between axes that follow each other."""
    from robodyn.identify.prior import sizes_of

    return 2 * max(length for _, length in sizes_of(robot))
