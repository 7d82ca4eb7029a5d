"""Every number by which an arm is identified, and its model evaluated along a log.

Below each stand its unit and what it decides. Where no source is given, the value is a choice: the logs of
docs/identify.md and the blind tests bear it out, and it was not derived. Numbers of a diagnosis stand in no
other kind of module (tests/diagnose/test_limits.py).
"""

from __future__ import annotations

from typing import Final

# --- twist --------------------

TWIST_PLACES: Final = 4001
"""[places] at which a spring is tabulated,"""

TWIST_BEYOND: Final = 4.0
"""[multiples of the log's largest torque] up to so much."""

TWIST_DIVERGED: Final = 1e3
"""[multiples of the largest twist tabulated] A link that lags by more has diverged."""

SWEEPS: Final = 2
"""[sweeps] over joints that lag together."""

LAG_BEGIN: Final = 1.0
"""[s] How the lag begins is sought over this time,"""

LAG_TRIES: Final = 2
"""[steps] in so many."""

LAG_PIECE: Final = 4.0
"""[s] In shorter pieces of a log it begins at rest: two numbers more would be too many."""
