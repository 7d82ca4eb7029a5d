"""Two robots: what differs, in numbers and in what they do."""

from __future__ import annotations

TOLERANCE: float = 1e-9
"""[share] Numbers that differ by less are the same: of the arm's reach, of the largest mass, moment or
torque, of the larger of two limits; or [rad]."""

STATES: int = 200
"""[states] Random states within the limits of the first robot at which torques and poses are compared."""

SEED: int = 1
"""[] Of the random states, so that a comparison says the same each time."""
