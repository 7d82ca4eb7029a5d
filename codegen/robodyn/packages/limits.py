"""Numbers that decide in this room, with unit and meaning."""

from __future__ import annotations

from typing import Final

#: Share of an arm's largest torque that is taken for rounding where friction at two positions is compared.
SAME_FRICTION: Final = 1e-9
#: States at which it is compared, and the largest velocity there [rad/s, m/s].
FRICTION_STATES: Final = 8
FRICTION_VELOCITY: Final = 2.0
#: No file of a package is larger, binaries included [bytes].
LARGEST_FILE: Final = 64 << 20

#: Stack [bytes] of a sample's thread beside the largest result: frames of the kernel and of printf.
MAIN_STACK: Final = 4096
#: Of a number, by its type [bytes].
BYTES: Final = {"double": 8, "float": 4}
