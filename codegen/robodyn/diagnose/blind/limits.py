"""Every number by which blind tests are drawn, hidden and scored.

Below each stand its unit and what it decides. Where no source is given, the value is a choice: the blind
tests (docs/diagnose.md) bear it out, and it was not derived. Numbers of a diagnosis stand in no other kind of
module (tests/diagnose/test_limits.py).
"""

from __future__ import annotations

from typing import Final

# --- drawn --------------------

LOADED_SHARE: Final = 0.2
"""[share of the largest RMS torque] An effect that needs load is drawn at joints with more."""

DRAWN_SAMPLES: Final = 1000
"""[samples] Of a motion as many are looked at to know what is usual of it."""

# --- hide --------------------

QUIET_SHARE: Final = 0.05
"""[share of the largest RMS torque] No torque channel has less noise than a joint with as much."""

BASE_FREQUENCY: Final = 0.1
"""[Hz] The motion's lowest frequency, to the nearest whole number of periods."""

HARMONICS: Final = 5
"""[-] Harmonics of the motion."""

LIMITS_SHARE: Final = 0.9
"""[share of the joint's limits] The motion goes as far and as fast."""

SIZE_TOLERANCE: Final = 0.05
"""[share] As near to the wanted size an effect's size is near enough."""

SIZE_TRIALS: Final = 5
"""[trials] for which there are as many."""

DRAWS: Final = 20
"""[draws] Effects that cannot reach the wanted size are drawn anew as often."""

LEAST_SIZE: Final = 0.7
"""[share of the wanted size] What a drawn effect must reach."""

# --- seal --------------------

LONGEST_ANSWER: Final = 8_000_000
"""[characters] A longer sealed answer is refused before it is unpacked."""
