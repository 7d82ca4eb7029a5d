"""Every number by which contacts are found in a log, with its unit and what it decides."""

from __future__ import annotations

from typing import Final

CUTOFF: Final = 8.0
"""[Hz] Cutoff of the signals in which contacts are sought: a hand's push rises in a tenth of a second."""

LOOSE: Final = 0.5
"""[share] The arm's numbers may be off by so much (standard deviation) when contacts are sought."""

KNEE: Final = 2.0
"""[standard deviations] from which on a residual counts less (Cauchy's weights, Holland and Welsch 1977)."""

SLOWEST: Final = 0.1
"""[rad/s or m/s] Friction of a joint that is slower throughout is no larger than its torque at this speed."""

LENGTHS: Final = (0.06, 3.0)
"""[s] Shortest and longest window: the filter lets nothing shorter through; what is longer is a load."""

LEVEL_TIME: Final = 0.35
"""[s] A window stands out of what is left as long before and after it."""

QUIET_WAY: Final = 0.06
"""[rad; m: a third] The arm is at rest, whatever hands move it by, where no joint covers more in four of
those times."""

ALPHA: Final = 0.01
"""[-] Chance that a log without contact has one: of M windows the best must be log(M / alpha) nats better."""

MOST: Final = 12
"""[-] As many windows are looked at, those that stand out most: contacts, and what they must stand out of."""

PRACTICAL: Final = 0.03
"""[share of RMS torque and dry friction] What makes less at all joints is not worth a name."""

MODEL_ERROR: Final = 0.07
"""[share of a joint's torque in a window] No force need explain it: friction changes with the load, and the
pose is not exactly known."""

PLACES: Final = (0.25, 0.5, 0.75, 1.0)
"""[shares of the way to the next joint] where a link may be touched, and at its centre;"""

LEVER: Final = 0.05
"""[m] the point is as far from these (standard deviation), and nobody pushes nearer than that at an axis."""

MARGIN: Final = 0.1
"""[s] A window is left out of all fits with so much before and after it: the filter's reach."""
