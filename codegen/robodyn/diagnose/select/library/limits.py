"""Every number by which candidates are made.

Below each stand its unit and what it decides. Where no source is given, the value is a choice: the blind
tests (docs/diagnose.md) bear it out, and it was not derived. Numbers of a diagnosis stand in no other kind of
module (tests/diagnose/test_limits.py).
"""

from __future__ import annotations

from typing import Final

# --- laws --------------------

GRAVITY_SHARE: Final = 0.1
"""[share of the joint that carries most] A joint with less carries no gravity worth a spring."""

# --- sensors --------------------

DRIVE_LIMITS: Final = (0.5, 0.65, 0.8, 0.9, 0.96)
"""[shares of the largest torque] Limits of a drive that are tried."""

SENSOR_PILED: Final = 0.003
"""[share of samples] A sensor that clips has as many at its extreme."""

LIMIT_SHARE: Final = 0.3
"""[share of samples] A drive at its limit for more leaves nothing to compare."""

LIMIT_EXPLAINED: Final = 0.55
"""[share of squares] What a limit must explain where it clips, and where the arm needs as much: of noise
about a level half of the squares lie beyond it."""

GAIN_MOST: Final = 0.5
"""[share] A torque constant is wrong by less."""

ENCODER_OFF: Final = 0.25
"""[rad or m] An encoder is off by less."""

# --- several --------------------

PAIR_RATIOS: Final = (1.0, -1.0)
"""[-] What the motor of a pair turns by a turn of its other joint: those that are tried."""

COUPLED_FARTHEST: Final = 2
"""[joints] No motor reaches to a joint that is farther along the arm: its shaft goes through all between."""

COUPLED_BEYOND_SHARE: Final = 0.3
"""[share of the mean square left] What a motor that reaches over a joint must take away, being rare."""

LINK_WRONG: Final = 1.0
"""[shares] Numbers of a link that is not as described are off by about as much as it says, or its neighbours
(a prior where nothing is stated: `identify` thinks so too; most motions do not see all of them)."""

LOAD_SHARE: Final = 1.0
"""[share of the arm's mass] A load is about as heavy (a prior),"""

LOAD_SIZE: Final = 0.15
"""[m] about as large (a prior for what most motions do not see),"""

LOAD_REACH: Final = 0.7
"""[m] The centre of a load is no farther from the last link's frame."""

TILT: Final = 0.3
"""[rad] No base is more tilted."""
