"""Every number by which logs are read and filtered.

Below each stand its unit and what it decides. Where no source is given, the value is a choice: the blind
tests (docs/diagnose.md) bear it out, and it was not derived. Numbers of a diagnosis stand in no other kind of
module (tests/diagnose/test_limits.py).
"""

from __future__ import annotations

from typing import Final

# --- files --------------------

SAME_TIME: Final = 0.5
"""[share of the time from row to row] Rows of two files are of the same sample up to this difference."""

APART: Final = 3.5
"""[times between two samples] Between samples further apart nothing is interpolated."""

STILL_TIME: Final = 0.1
"""[s] Over so long a time an arm moves or stands still,"""

STANDSTILL: Final = 1e-3
"""[share of the largest motion in that time] which it does if all its joints move less."""

EARLIEST: Final = 631_152_000.0
"""[s since 1970: 1990-01-01] No log is older: a clock that lost its date begins before,"""

LATEST: Final = 4_102_444_800.0
"""[s since 1970: 2100-01-01] and none is younger."""

# --- proposals --------------------

FASTEST_RATE: Final = 20_000.0
"""[Hz] Rows that would come faster have another unit of time,"""

SLOWEST_RATE: Final = 5.0
"""[Hz] and so have rows that would come more slowly."""

TURNED: Final = 7.0
"""[rad] Positions beyond, and beyond the limits of the joint, are not in rad."""

COUNTS: Final = 100.0
"""[-] Torques that are all whole numbers, and reach further, are counts of a converter."""

MOST_AMPERES: Final = 200.0
"""[A] Currents that reach further are taken for mA."""

RATE_NEAR: Final = 0.1
"""[share] A rate has a unit if it is as many times that of the positions as the unit says, up to this."""

RATE_MATCH: Final = 0.5
"""[-] A rate correlates as much with the difference of what it is the rate of."""

BEYOND: Final = 0.02
"""[share of the joint's range] Positions further beyond its limits are remarked on."""

SIGN_MATCH: Final = 0.8
"""[-] A torque that correlates with gravity's by less than minus this has the other sign."""

GAIN_MATCH: Final = 0.4
"""[-] With a weaker correlation nothing is said of how large a torque is beside gravity's,"""

SMALL_GAIN: Final = 0.1
"""[-] which is remarked on below this many times"""

LARGE_GAIN: Final = 8.0
"""[-] and above this many times."""

TELLING: Final = 0.02
"""[share of the largest change] Where gravity's torque changes less it says nothing of a joint."""

# --- signals --------------------

LOWEST_CUTOFF: Final = 6.0
"""[Hz] The filter through which all signals are seen cuts off no lower,"""

HIGHEST_CUTOFF: Final = 0.2
"""[share of the sampling rate] no higher than this,"""

ENOUGH_CUTOFF: Final = 15.0
"""[Hz] and no higher than this: steps of friction reach far up, and what is worth naming shows below
(docs/decisions/0047)."""

LEAST_RATE: Final = 6.0
"""[multiples of the cutoff] Where samples come faster, every second one carries what the filter passes."""

MOTION_OVER_NOISE: Final = 30.0
"""[powers of the noise] At a frequency with more power, positions show motion;"""

MOTION_ABOVE: Final = 2.0
"""[-] a filter that cuts off at so many times the highest of these frequencies leaves it as it is."""

MOTION_WIDER: Final = 3.0
"""[cutoffs] Motion is kept up to so many times the cutoff of what is compared at most."""

FILTER_ORDER: Final = 4
"""[-] Order of that filter (Butterworth, forth and back)."""

CONTINUED: Final = 1.5
"""[periods of the cutoff] The ends of a motion are continued so far before it is filtered."""
