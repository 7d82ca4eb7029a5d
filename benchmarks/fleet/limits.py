"""Every number by which a simulated fleet is drawn that is not an option of its recipe.

Below each stand its unit and what it decides. All are choices: what is usual of industrial arms.
"""

from __future__ import annotations

from typing import Final

CONTROL_PERIOD: Final = 1e-3
"""[s] Period of the controller, and step of the integration."""

# --- programs --------------------

TOP_SPEED: Final = 1.875
"""[distance / time] Largest speed of a move of degree five from rest to rest."""

TOP_RATE: Final = 10 / 3**0.5
"""[distance / time^2] Its largest acceleration."""

POINTS: Final = (4, 8)
"""[points] of a program, at least and at most."""

REACH: Final = (0.25, 0.7)
"""[share of half a joint's range] A program goes as far to either side of its centre."""

WIDEST: Final = 1.5
"""[rad or m] but no farther than this."""

SHIFT: Final = 0.03
"""[rad or m] Standard deviation of a program's points from one time to the next."""

STOPS: Final = 0.7
"""[share of the points] at which the arm comes to rest."""

LONGEST_DWELL: Final = 0.6
"""[s] It rests there for as long at most."""

SHORTEST_MOVE: Final = 0.3
"""[s] No move is quicker."""

# --- types --------------------

COULOMB: Final = (0.10, 0.30)
"""[share of the RMS torque] Coulomb friction of a joint that states none."""

VISCOUS: Final = (0.4, 1.2)
"""[share of the Coulomb level] Viscous friction at the RMS speed, of a joint that states none."""

ROTOR: Final = (0.3, 1.0)
"""[share of the inertia that the joint carries] Rotor inertia of a joint that states none."""

CARRIED_SHARE: Final = 0.02
"""[share of the largest] No joint counts as carrying less inertia when its rotor is drawn."""

TYPICAL: Final = (4, 8.0)
"""[programs, s] whose torques say what is usual of a type."""

COARSE: Final = 0.05
"""[s] Period of the motion by which a type's controller is tuned."""

TORQUE_STEP: Final = 1e-3
"""[N m or N] To which controllers round torques in their logs."""

DIGITS: Final = 4
"""[digits] of the numbers in a data sheet."""

# --- days --------------------

DAY: Final = 86400.0
"""[s] A day."""

FIRST_DAY: Final = 1735689600.0
"""[s since 1970] When the year begins: 2025-01-01, UTC."""

WARMEST_DAY: Final = 200.0
"""[days from the beginning] The middle of summer."""

YEAR: Final = 365.25
"""[days] From one summer to the next."""

UNEVEN: Final = 0.7
"""[-] Shape of the gamma distribution of the time between two logs: 1 is by chance, large is even."""

# --- friction and temperature --------------------

REFERENCE: Final = 30.0
"""[deg C] Temperature for which friction is stated."""

# --- units --------------------

SPEEDS: Final = (0.6, 1.0)
"""[share of the full speed] of a log that is not slow."""

SLOW: Final = 1 / 3
"""[share] by which a slow log is slower, and a short one shorter."""

SHIFTS: Final = (6.0, 22.0)
"""[h] of the day, between which logs are recorded."""

# --- changes --------------------

LEAST_LEVEL: Final = 0.02
"""[share] A change that has begun is there with this much of its full size: less is no play at all."""

STIFFER_TEETH: Final = 6.0
"""[-] Teeth are as many times stiffer than those that blind tests of one arm hide: 29 Hz in place of 12."""

STIFFER_DAMPING: Final = 2.4
"""[-] and their damping as many times larger, about the root of it."""

MOVING: Final = 0.02
"""[rad/s or m/s] Samples at which all joints are faster say how much an effect shows."""

SIZED_DURATION: Final = 8.0
"""[s] of the motion by which the size of an effect is found,"""

SIZED_RATE: Final = 250.0
"""[Hz] and of its samples."""

LOST_DATE: Final = 4 * 365.25 * DAY
"""[s] So far back is the clock that has lost its date."""

# --- score --------------------

NEAR: Final = 30.0
"""[days] A date that is off by no more is near."""

NAMED: Final = 0.9
"""[share of the planted] An answer names as many at least,"""

FALSE: Final = 0.05
"""[share of the units with a name] of which as many are healthy at most,"""

RIGHT: Final = 0.95
"""[share of what is named] and is right about as many at least."""

# --- recipe --------------------

FEWEST_LOGS: Final = 5
"""[logs] of a unit in which a change has a before and an after."""

LARGEST_RECIPE: Final = 1 << 20
"""[bytes] A recipe with more is refused."""
