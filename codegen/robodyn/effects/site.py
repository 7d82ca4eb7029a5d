"""What the equation of an effect may read."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Site:
    """What an equation may read at a joint, over any scalar.

    ``q, qd, qdd``: position, velocity and acceleration on its side of the drive [rad or m, per second];
    ``direction``: sgn(qd), by whatever rule holds near rest; ``tau``: the torque that has come so far [N m or
    N]; ``f`` [3] (N) and ``n`` [3] (N m): force and moment of the rigid arm through the joint, about the
    origin and along the axes of the link's frame, z the joint's. ``revolute``: the kind of joint.
    """

    revolute: bool
    q: Any = 0
    qd: Any = 0
    qdd: Any = 0
    direction: Any = 0
    tau: Any = 0
    f: tuple[Any, Any, Any] = (0, 0, 0)
    n: tuple[Any, Any, Any] = (0, 0, 0)
