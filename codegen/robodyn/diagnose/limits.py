"""The numbers of a diagnosis as a whole; those of its parts stand in the `limits` of their folders.

Below each stand its unit and what it decides. Where no source is given, the value is a choice: the blind
tests (docs/diagnose.md) bear it out, and it was not derived. Numbers of a diagnosis stand in no other kind of
module (tests/diagnose/test_limits.py).
"""

from __future__ import annotations

from typing import Final

# --- result --------------------

CLAIM: Final = 0.5
"""[probability] A finding of this confidence is a claim. Part of the file format."""

ABOVE_NOISE: Final = 1.15
"""[noise floors] A joint whose RMS is larger has something to be explained."""

HALF_WIDTH: Final = 1.96
"""[standard errors] Half the width of an interval that holds a number in 95 of 100 cases."""

# --- evidence --------------------

MOST_TRIED: Final = 8
"""[candidates] As many of the best that were not named are listed."""

MOST_RIVALS: Final = 5
"""[candidates] As many rivals of a finding are listed."""

MOSTLY: Final = 0.5
"""[share of the RMS torque] A joint of which more is left, and not as noise, is not explained whatever fits:
more than half of what it does is unknown."""

# --- excite --------------------

EXCITE_SAMPLES: Final = 400
"""[samples] A motion is judged at as many."""

EXCITE_NOISE: Final = 0.01
"""[share of RMS torque] The noise of the torques that is expected in the log."""

EXCITE_QUIET: Final = 0.05
"""[share of the largest RMS torque] No joint's noise is less than that of a joint with as much."""

NO_TORQUE: Final = 1e-9
"""[noise floors] An effect of likely size that shows less shows nothing."""

SAME_SPACE: Final = 1e-8
"""[1 - cosine] Nearer directions are shared by the nature of the effects, not by the motion."""

RIPPLE_WAVES: Final = 30.0
"""[1/rad] The waves of a ripple for which a motion is judged."""

CORRELATION_RIDGE: Final = 1e-4
"""[-] Added to the diagonal of correlations, so that they can be inverted."""

EXCITE_SHARE: Final = 0.95
"""[share of the joint's limits] The motion goes as far and as fast."""

# --- stages --------------------

LOOKING_COST: Final = (0.5, 1e-6)
"""[s; s for each number of positions] The data check and the search for contacts take about so long."""

STAGE_COSTS: Final = {
    "fitting the catalogue": (2.0, 5e-5),
    "validating the result": (0.2, 2e-6),
    "fitting the arm's own numbers": (0.8, 1e-5),
}
"""[s; s for each row and square of the joints] The other stages, on a usual processor."""

# --- run --------------------

FITTED_SAMPLES: Final = 30_000
"""[samples] Of all logs that are fitted as many are used at most, of each an equal share, which bounds time
and memory (60 s at 500 Hz),"""

FITTED_ROWS: Final = 4_000
"""[samples] and, at low rates, as many as are left where they are filtered and thinned (80 s at 100 Hz);"""

FITTED_WINDOWS: Final = 8
"""[windows] of a longer log in as many, spread over its motion: few and long, since slow friction and the
first swing of a spring need seconds."""

REFIT_SHARE: Final = 0.1
"""[share of mean square] The arm's own numbers are written anew if they take away so much at some joint,"""

REFIT_WORSE: Final = 1.05
"""[ratio of RMS] and add no more than this at another."""

SPRING_WORSE: Final = 1.05
"""[share] A spring that two encoders show is added to the model where no joint's RMS grows by more."""

END_SHARE: Final = 0.02
"""[share of samples] Left out at either end of each unbroken part of a log when gaps are measured. Part of
the file format."""

WITHDRAWN: Final = 0.3
"""[probability] The confidence of names that are taken back: below `CLAIM`."""

DRAWN_POINTS: Final = 3000
"""[points] A series in the report has as many."""

# --- combined --------------------

AMENDED_DIGITS: Final = 6
"""[digits] Of a number of an amendment,"""

WORKED_OUT: Final = 9
"""[digits] and of one that is worked out from it and what the model had."""

BODY_POSES: Final = 2000
"""[poses] In so many are weights compared of an arm as described and refitted."""

BODY_SHARE: Final = 0.05
"""[share of the torques by weight] A difference below this is no matter."""

BODY_EXPLAINED: Final = 0.9
"""[share of the mean square] One mass is spoken of if it explains so much of the difference,"""

BODY_ALIKE: Final = 0.02
"""[share of the mean square] at the outermost link of those that explain as much but for this."""
