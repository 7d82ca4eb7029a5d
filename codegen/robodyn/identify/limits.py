"""Every number by which an arm is identified, and its model evaluated along a log.

Below each stand its unit and what it decides. Where no source is given, the value is a choice: the logs of
docs/identify.md and the blind tests bear it out, and it was not derived. Numbers of a diagnosis stand in no
other kind of module (tests/diagnose/test_limits.py).
"""

from __future__ import annotations

from typing import Final

# --- stages --------------------

LOOKING_COST: Final = (0.4, 2e-7)
"""[s; s for each number of positions] The data check takes about so long on a usual processor,"""

FITTING_COST: Final = (0.5, 1.1e-6)
"""[s; s for each number of positions] the fit,"""

COMPARING_COST: Final = (0.2, 2.6e-6)
"""[s; s for each number of positions] and the comparison of torques."""

# --- twist --------------------

STEP_ANGLE: Final = 0.1
"""[rad] By a larger angle a link does not swing on its spring in a step: that would make the spring a
thousandth softer;"""

LAG_BEGIN: Final = 1.0
"""[s] How the lag begins is sought over this time,"""

LAG_SHARES: Final = (0.15, 0.4, 1.0)
"""[shares of that time] over these one after the other,"""

LAG_EDGE: Final = 0.1
"""[s] but for this, where filters know less of the accelerations,"""

LAG_PIECE: Final = 4.0
"""[s] In shorter pieces of a log it begins at rest: two numbers more would be too many."""

# --- rows --------------------

FOLDS: Final = 10
"""[parts] A log is cut into as many equal parts;"""

TRAIN_SHARE: Final = 0.7
"""[share of a part] of each, so much is fitted at first, and what follows is held out."""

SUB_BLOCKS: Final = 3
"""[blocks] What is fitted of a part is cut into as many, which intervals are taken from."""


# --- residual --------------------

END_SHARE: Final = 0.01
"""[share of a log] No figure counts so much of either end, where filters know less."""

# --- prior --------------------

UNSTATED_CONFIDENCE: Final = 0.4
"""[share] So far off may the inertial numbers be of a link that does not say: few files keep 10 %."""

ASYMMETRY: Final = 3.5
"""[-] A confidence c is a standard deviation of c (1 + 3.5 c) of what is described: described 30 % too small,
a number lacks 43 % of itself; at twice that 150 %. Intervals of masses hold with it (docs/identify.md)."""

LEAST_MASS: Final = 0.02
"""[share of the heaviest link] No link is thought to be lighter,"""

LEAST_LENGTH: Final = 0.05
"""[share of the longest distance between joints] nor shorter,"""

LEAST_INERTIA: Final = 0.25
"""[m L^2] nor to have less inertia, when it is asked how far off its description may be."""

FREE_SHARE: Final = 10.0
"""[-] Friction may be so many times as large as the torque."""

# --- problem --------------------

ROUNDS: Final = 5
"""[rounds] of weights, each by what the last one left."""

START_SHARE: Final = 0.01
"""[share of a link's size] The fit begins so far inside of what is possible."""

PRIOR_FREEDOM: Final = 2.0
"""[degrees of freedom] of Student's t about the description: fewer let go of a wrong one sooner."""

LEAST_NOISE: Final = 1e-9
"""[N m or N] No torque channel is more exact: fits believe no sample of a torque beyond this."""

# --- plain --------------------

RANK: Final = 1e-9
"""[share of the largest] A smaller eigenvalue of columns of one length is none."""

# --- fit --------------------

PASSES: Final = 3
"""[passes] over all rows with weights by what the last fit left of them."""

HUBER_FACTOR: Final = 2.5
"""[RMS] A sample that is off by more counts less."""


CHANCE: Final = 0.01
"""[-] So often a log of a right model gets an offset, at any of its joints: a likelihood ratio of held-out
blocks is larger than n / 0.01 by no more than this chance (Wasserman, Ramdas and Balakrishnan 2020)."""

GAIN_SPREAD: Final = 0.3
"""[share] So far off may torque constants be that are only roughly known."""

KNOWN_MASS: Final = 1e-3
"""[share] A load whose mass is stated may be off by so much."""

LOAD_REACH: Final = 0.5
"""[longest link] So far from the last frame may the centre of a load be."""

# --- known --------------------

LARGEST_FILE: Final = 64 << 20
"""[bytes] The covariance of an arm of 100 links takes 35 MB of text."""

# --- outcome --------------------

KEPT_SHARE: Final = 1e-4
"""[prior standard deviations] A number that moved by less stays as it is described."""

MARGIN: Final = 1e-7
"""[share of a link's size] Bodies are written so far inside of what is possible."""

UNSEEN_SHARE: Final = 0.9
"""[prior standard deviations] A number that the logs leave more uncertain than this is not seen by them."""

# --- advice --------------------

POOR_CONDITION: Final = 100.0
"""[-] A base regressor with a larger condition number is poorly excited (Gautier and Khalil 1992)."""
