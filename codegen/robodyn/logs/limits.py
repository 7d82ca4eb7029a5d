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

# --- signals --------------------

LOWEST_CUTOFF: Final = 6.0
"""[Hz] The filter through which all signals are seen cuts off no lower,"""

HIGHEST_CUTOFF: Final = 0.2
"""[share of the sampling rate] no higher than this,"""

ENOUGH_CUTOFF: Final = 15.0
"""[Hz] and no higher than this: steps of friction reach far up, and what is worth naming shows below
(docs/decisions/0012)."""

FILTER_ORDER: Final = 4
"""[-] Order of that filter (Butterworth, forth and back)."""

CONTINUED: Final = 1.5
"""[periods of the cutoff] The ends of a motion are continued so far before it is filtered."""
