"""Numbers that decide in this room, with unit and meaning."""

from __future__ import annotations

from typing import Final

#: Share of an arm's largest torque that is taken for rounding where friction at two positions is compared.
SAME_FRICTION: Final = 1e-9
#: States at which it is compared, and the largest velocity there [rad/s, m/s].
FRICTION_STATES: Final = 8
FRICTION_VELOCITY: Final = 2.0

#: Stack [bytes] of a sample's thread beside the largest result: frames of the kernel and of printf.
MAIN_STACK: Final = 4096
#: Of a number, by its type [bytes].
BYTES: Final = {"double": 8, "float": 4}

#: Joint positions [rad, m], one joint after another, at which no two axes are parallel by chance.
REFERENCE_POSITIONS: Final = (0.4, -0.7, 0.9, 0.3, -0.5, 0.8, -0.6)
#: What two descriptions of one arm may differ by, such as nominal and calibrated: the cosine of the angle
#: between two axes, and the distance between two axes [m].
SAME_AXES: Final = (0.02, 0.01)
