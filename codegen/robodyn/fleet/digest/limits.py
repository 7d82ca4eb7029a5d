"""Every number by which a log is digested.

Below each stand its unit and what it decides. Where no source is given, the value is a choice: simulated
fleets bear it out (docs/fleet.md).
"""

from __future__ import annotations

from typing import Final

RIDGE: Final = 1e-8
"""[share of the largest] Columns of a joint that are farther from independent count as dependent."""

KNEE: Final = 2.5
"""[RMS] A sample that is off by more counts less."""

ROUNDS: Final = 2
"""[rounds] of least squares with weights by what the last one left."""

LEAST_ROWS: Final = 20
"""[samples] A piece with fewer that say something of their own, beyond as many as there are numbers, is
too short."""

TURNING: Final = 0.15
"""[s] So long before and after a joint turns round its friction is not known,"""

SLOW_SHARE: Final = 0.1
"""[share of its RMS speed] nor where it is slower."""

BURST: Final = 0.15
"""[s] So long after its load has changed sign a joint with play rings."""

LEAST_BURSTS: Final = 8
"""[samples] With fewer after reversals of the load, or otherwise, the two are not compared."""
