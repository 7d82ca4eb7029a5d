"""Every number by which effects are tried, chosen, refined and named.

Below each stand its unit and what it decides. Where no source is given, the value is a choice: the blind
tests (docs/diagnose.md) bear it out, and it was not derived. Numbers of a diagnosis stand in no other kind of
module (tests/diagnose/test_limits.py).
"""

from __future__ import annotations

from typing import Final

# --- fit --------------------

BLOCKS: Final = 10
"""[parts] A log is cut into as many; each is judged by a fit to the others."""

FREE_PRECISION: Final = 1e-9
"""[1/variance] The prior of a coefficient that may be anything."""

UNPULLED: Final = 1e-12
"""[share of the variance] At a coefficient that spreads less from part to part of a log than this, nothing in
the log pulls: it is known as well as its prior says."""

UNSEEN_NUISANCE: Final = 1e-6
"""[squares over the noise] A direction of the arm's own numbers that shows less along the whole logs, if it
is off by one standard deviation of its prior, is left out: no fit would move it."""

SPANNED: Final = 1e-9
"""[share of its squares] A candidate of which what is known leaves less adds nothing."""

TRIED_AT_ONCE: Final = 100
"""[candidates] So many are tried at once, with copies of their columns."""

# --- ceiling --------------------

CEILING_RIDGE: Final = 1e-3
"""[share of the samples] Ridge of columns of size 1, when all linear candidates are fitted together."""

STANDS_OUT: Final = 2.0
"""[noise floors] What is left beyond stands out of the noise."""

# --- choice --------------------

LEAST_T: Final = 3.0
"""[standard errors] The least paired t over the parts of a log with which a candidate is taken."""

LEAST_SHARE: Final = 0.1
"""[share of the mean square left] What a candidate must take away at some joint, in parts that were not
fitted: a real arm has many small things in it, and a name for each helps nobody."""

REPLACING_SHARE: Final = 0.2
"""[share of the mean square left] The same for a law that takes the place of a plainer one."""

ROUGH_SHARE: Final = 0.5
"""[share of the mean square left] And in a log with more in it than the catalogue has."""

RELIEF: Final = 20.0
"""[log-likelihood] With more, the arm's own numbers would be too far beyond their confidence without it."""

BODY_NUMBERS: Final = 4
"""[numbers] Of the ten of a body as many are seen in most motions."""

TIE: Final = 2.0
"""[standard errors] Candidates within so many of the best are its rivals,"""

TIE_LOSS: Final = 0.02
"""[share of the gain] and those that lose no more of its gain,"""

ROUGH_TIE: Final = 0.15
"""[share of the gain] or this, in a log with more in it than the catalogue has,"""

CLOSE: Final = 5.0
"""[log-likelihood] and those as near,"""

NEARLY: Final = 0.9
"""[share of the gain] if they gain as much."""

ROUGH: Final = 3.0
"""[mean squares of the noise] If no candidate leaves less, the log has what is not in the catalogue."""

ALONE: Final = 1.5
"""[mean squares of the noise] A candidate that is not likely is named if it alone leaves less."""

REPLACING_T: Final = 2.0
"""[standard errors] The least paired t of a law that takes the place of a plainer one."""

ROUGH_T: Final = 1.3
"""[standard errors] In such a log this t suffices with twice the evidence."""

MANY_POWER: Final = 0.1
"""[exponent of the number of numbers] There a candidate of several must explain more by this power."""

REFINING_ROUNDS: Final = 12
"""[rounds] of refining what is not linear in a candidate."""

OSCILLATOR_STARTS: Final = 2
"""[places] As many of the best on a grid of springs are refined,"""

OSCILLATOR_GAIN: Final = 0.1
"""[share of the largest gain] if they gain as much,"""

OSCILLATOR_DIRECTIONS: Final = 16
"""[directions] by steps in as many,"""

OSCILLATOR_FARTHEST: Final = 8.0
"""[-] never farther than by this factor."""

# --- common --------------------

COMMON_JOINTS: Final = 0.5
"""[share of the moving joints] What so many lack, and two at least, is looked for at all joints at once."""

COMMON_T: Final = 2.0
"""[standard errors] The least paired t over the parts of a log of what is common,"""

COMMON_PARTS: Final = 0.8
"""[share of the parts] or as many parts in which it explains something."""

# --- prepared --------------------

FILTERED_AT_ONCE: Final = 1_000_000
"""[numbers] About so many, of candidates' columns, are filtered in one pass, or those of one candidate."""

# --- forward --------------------

SURE: Final = 0.95
"""[probability] Of a name without rivals."""

MOST_VAGUE: Final = 0.5
"""[share of the value] A standard error that is larger says that the value is not known."""

MOST_KINDS: Final = 8
"""[effects] So many different ones are named at most; what is left beyond is unexplained."""

# --- contact --------------------

CONTACT_LOUD: Final = 2.0
"""[ratio of RMS] In its window a contact leaves more than this at some joint, beside the rest of the log."""

CONTACT_NARROW: Final = 30.0
"""[degrees] A contact's force has a known direction if the true one is as near to it with 95 %,"""

CONTACT_WIDE: Final = 90.0
"""[degrees] and none at all, nor a sign, if it may be as far from it."""

CONTACT_EDGE: Final = 0.02
"""[s] So well is either end of a contact's window known."""

CONTACT_CONFIDENCE: Final = 0.9
"""[probability] That of a contact that was found (docs/diagnose.md)."""

# --- elastic --------------------

DAMPED: Final = 0.05
"""[share of critical damping] How much a spring is damped when it is first tried."""

TWIST_CUTOFF: Final = 6.0
"""[Hz] Cutoff of what is differentiated twice: at 15 Hz that was noise (docs/decisions/0012)."""

OSCILLATOR_RATE: Final = 300.0
"""[steps/s] The fewest in which the motion of a spring is integrated."""

# --- encoders --------------------

ENCODER_SAMPLES: Final = 100
"""[samples] Fewer of a second encoder, without a gap, are not looked at."""

ENCODER_MOVING: Final = 0.02
"""[share of top speed] A slower joint may stick: friction is then unknown."""

ENCODER_SURE: Final = 2.0
"""[standard errors] A compliance that is not so far from none cannot be told from a rigid gear."""

ENCODER_CONFIDENCE: Final = 0.95
"""[probability] The confidence of what two encoders show without a fit to the torques."""

# --- own numbers --------------------

TURN_TIME: Final = 0.005
"""[s] So well is known (standard deviation) when the friction of a joint that turns round does so as well: it
sticks for a few thousandths of a second to some hundredths."""

# --- refine --------------------

REFINE_ROUNDS: Final = 4
"""[rounds] of Gauss and Newton over all findings,"""

REFINE_STEP: Final = 1e-3
"""[share] with differences over so much of each number."""

REFINE_WORTH: Final = 1e-3
"""[share of the sum of squares] What a round must gain for another."""

REFINE_FARTHEST: Final = 5.0
"""[-] A number that is so many times larger than it began is lost."""

TOWARDS_ZERO: Final = 0.1
"""[share of the value] A size that a round would take through zero is reduced to so much instead."""

STICKING_SPEEDS: Final = (1e-4, 3e-4, 1e-3, 3e-3, 1e-2)
"""[shares of the top speed] Below one of these a joint with friction sticks, to begin with."""

HUBER: Final = 2.0
"""[median residuals] From here on an error counts by its size and no more by its square (Huber)."""

HUBER_ROUNDS: Final = 3
"""[rounds] of such weights."""

LEAST_SHAPE: Final = 0.1
"""[-] What shapes a curve and is 0 begins with this in the last fit."""

# --- uncertainty --------------------

SCORE_PARTS: Final = 20
"""[parts] A log is cut into as many: the pulls of each at the numbers say how sure these are."""

LEAST_CURVATURE: Final = 1e-12
"""[-] Of columns of size 1, directions that show less are taken to show so much."""

LEAST_SPREAD: Final = 1e-6
"""[variances of the noise] No residual is so small that a number is known better than with this."""

NOISE_DRAWS: Final = 4
"""[draws] of the encoders' noise say what it does to a fit: so many add an eighth to the error by it."""

BIAS_ROUNDS: Final = 5
"""[times] at most what it does is looked at where values are without it,"""

BIAS_SETTLED: Final = 0.1
"""[standard errors] until they move by less,"""

BIAS_NEARER: Final = 0.1
"""[share of the value] no farther than to this, and intervals are wider by no more than its inverse."""

PROFILE_STEPS: Final = 3
"""[steps] in which all other numbers are refitted where one is held,"""

PROFILE_TRIES: Final = 8
"""[places] at which it is held, for each end of an interval,"""

NEAR_BOUND: Final = 0.05
"""[share] of the distance, in standard errors, within which that end is near enough."""

FARTHEST_BOUND: Final = 2.3
"""[logarithm; intervals] An end that is farther than this (a factor of ten) is open."""

BETTER_FIT: Final = 0.5
"""[squares of standard errors] A misfit that is smaller by more is a better fit, from which is begun anew,"""

PROFILE_RESTARTS: Final = 2
"""[times] at most."""

LEAST_PRIOR_SHARE: Final = 0.005
"""[share of what is said] No better than this are the arm's own numbers taken to be where logs bear it out: a
filtered log shows them to half a thousandth at best;"""

PRIOR_SHARES: Final = 15
"""[shares] so many are tried, up to what is said."""

BY_PRIOR: Final = 0.7
"""[share of the error] A number whose error comes from its own prior by more is not told by the logs."""

STRIKE_ACCURACY: Final = 0.01
"""[share of the value] A link in backlash strikes its motor between samples: a gap and its teeth are known no
better. (A spring that does not strike is as well known as the log shows it.)"""

# --- walk --------------------

WALK_STEP: Final = 1.3
"""[-] A stiffness is varied by this factor,"""

WALK_STEPS: Final = (12, 5)
"""[steps] down and up at most: a grid ends too stiff more often than too soft;"""

WALK_LOST: Final = 4.0
"""[-] no farther than to so many times the least misfit."""

WALK_ROUNDS: Final = 3
"""[rounds] of Gauss and Newton at each step,"""

WALK_FARTHEST: Final = 0.7
"""[logarithm] none farther than this,"""

WALK_DAMPED: Final = 1e-6
"""[-] with this on the diagonal of columns of size 1."""

# --- search --------------------

PASSES: Final = 10
"""[passes] After each the model is amended and looked at again."""

PASSES_ROUGH: Final = 2
"""[passes] The same for a log with more in it than the catalogue has: what the model lacks has no end, and
what comes late has no size that matters."""

PRICE: Final = 0.3
"""[share of the evidence threshold] An effect stays if leaving it out loses more."""

FEW: Final = 6
"""[effects] Of more the others are not refitted where one is left out: that takes too long."""

STANDING: Final = 0.05
"""[share of top speed] A joint that is slower stands."""

# --- selection --------------------

MOST_EFFECTS: Final = 6
"""[effects] named in one look at most."""

OF_NOISE: Final = 0.3
"""[share of the raw noise] What an effect must explain at a joint to be worth a name,"""

OF_TORQUE: Final = 0.004
"""[share of the RMS torque] and of this,"""

OF_ENCODER_NOISE: Final = 2.0
"""[-] and of what the encoders' noise makes of the torque."""

TIGHT: Final = (0.1, 0.01)
"""[-] How much better the arm's numbers may be than they are said to be (docs/decisions/0012): those of an
identified arm foresee its torques to some thousandths, whatever its description has said of each of them;"""

TIGHT_EVIDENCE: Final = 5.0
"""[log-likelihood] and how much better the evidence for it must be."""

RIGID_EVIDENCE: Final = 36.0
"""[log-likelihood] and for one body or link that is not as described, whose ten numbers may fit a scatter of
the numbers of all: of 10 % in an arm of three joints, with up to 33."""

POSES: Final = 50
"""[poses] at which inertias are looked at."""

UNSTATED: Final = (0.3, 1.0)
"""[shares] Where nothing is said of inertial numbers, they may be wrong by so much instead of a tenth, if the
evidence is better by as much as TIGHT_EVIDENCE; 1: they are a guess."""

SHORTEST_PIECE: Final = 6.0
"""[periods of the cutoff] Shorter pieces of a log are left out."""

FEW_PARTS: Final = 1.15
"""[-] A standard error of ten parts is so much larger, for twice of it to hold 95 % (Student, 9 degrees)."""

DIVERGED: Final = 30.0
"""[-] So many times larger in the fit of all than alone, a coefficient has diverged."""

REST_WEIGHT: Final = 0.3
"""[-] What a row of a joint that rests counts, as a factor (stiction holds it with any torque),"""

LEAST_MOVING: Final = 0.1
"""[share] if the joint moves for more than this: else there is nothing better to go by."""
