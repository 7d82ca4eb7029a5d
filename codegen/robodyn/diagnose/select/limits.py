"""Every number by which effects are tried, chosen and named, with its unit and what it decides.

Where no source is given, the value is a choice and was not derived.
"""

from __future__ import annotations

from typing import Final

BLOCKS: Final = 10
"""[-] Parts of a log that are held out in turn (ten-fold, Breiman and Spector 1992)."""

GUARD: Final = 6.0
"""[time constants of the torque's filter] Rows at the edge of a block that have something of its neighbour:
an impulse through a fourth-order filter has died down after so many."""

SHORTEST_PIECE: Final = 5.0
"""[periods of the cutoff] Shorter parts of a log are mostly the filter's edge."""

LEAST_NOISE_SHARE: Final = 1e-4
"""[share of RMS torque] No torque channel is better than that."""

ALPHA: Final = 0.01
"""[-] Chance that a log of a model that is right names something (of all candidates together): an e-value of
a held-out likelihood ratio is larger than M / alpha for one of M candidates by no more than this chance
(Wasserman, Ramdas and Balakrishnan 2020)."""

PRACTICAL: Final = 0.1
"""[share of the RMS that is left at some joint] What is worth a name; less is nobody's next step."""

ABOVE_FLOOR: Final = 1.5
"""[floors] A joint whose residual stands out of its sensors' noise by less needs no name."""

RIVAL: Final = 2.0
"""[standard errors] Candidates whose foretelling is not worse by more are rivals."""

OVERLAP: Final = 0.5
"""[share] Candidates explain the same where they have more than half of their gain at the same joints."""

MOST_MEMBERS: Final = 16
"""[-] A model that lacks more than that is not this model."""

RIDGE: Final = 1e-6
"""[share of a column's square] By which it must differ from others: columns are in single precision."""

TOLERANCE: Final = 1e-5
"""[share of the largest singular value] Columns that are smaller say nothing apart from others."""

RESOLUTION: Final = 2.0
"""[-] The speed below which a direction is not resolved is looked for by this factor,"""

RANGE: Final = 10.0
"""[-] as far from what the log's rates and encoders let expect."""

NOISE_STEPS: Final = 20
"""[-] Sizes of noise that are tried, from the sensors' to all that is left: a choice; between two of them the
likelihood hardly changes, for what is left is seldom a hundred times the noise."""

FIT_ROUNDS: Final = 6
"""[-] Steps of Gauss and Newton at most."""

FIT_WORTH: Final = 0.05
"""[nats] A step that explains less is the last."""

FINEST: Final = 0.03
"""[share of the first step] Values of what is not linear are tried as near to each other before all numbers
are fitted together."""

STEP: Final = 1e-3
"""[share of a number] By which it is moved to see what the torques change by."""

TOWARDS_ZERO: Final = 0.3
"""[-] A size that would change its sign goes to this share of itself instead."""

LEAST_SHOWN: Final = 0.03
"""[standard deviations] Combinations of the arm's own numbers whose prior moves the torques of all rows
together by less are not seen."""

LEAST_CENTRE: Final = 0.02
"""[m] A centre of mass that is described as 0 may be as far off, by the share that is stated of the link."""

LEAST_INERTIA: Final = 0.1
"""[share of the largest moment] The same of moments and products of inertia."""

SHARES: Final = (0.01, 0.03, 0.1, 0.3, 1.0)
"""[shares] By which all inertial numbers may be wrong, if that foretells enough more; at first those of which
nothing is said are right."""

PART_CORRELATION: Final = 10.0
"""[correlation times] Length of the parts whose pulls on a fit are summed: the rows of one have little to do
with those of the next."""

NOT_SHOWN: Final = 1e-11
"""[share of the largest eigenvalue] A combination of numbers that shows by less is lost in rounding: it is
open, and so is each number of it."""

STRIKE_ACCURACY: Final = 0.01
"""[share of the value] A link in backlash strikes its motor between samples: a gap and its teeth are known no
better. (A spring that does not strike is as well known as the log shows it.)"""

VAGUE: Final = 0.5
"""[share of the value] A standard error that is larger says that the value is not known."""

TOGETHER: Final = 0.1
"""[-] Two numbers are sure together where their product or ratio is ten times as sure as either."""

RIVAL_LEAST: Final = 0.5
"""[share of the gain] A candidate that explains less than half is another thing and no rival."""

ODDS: Final = (-1.77, 1.62, 0.99)
"""[-; by logit of the share explained; probability] That the catalogue has what is missing at a joint, a
logistic regression, and how sure any name is at most. Maximum likelihood of 345 names, right or not, in blind
trials of drawn arms whose joints stick, of all kinds alike (``clear``, ``near``, ``after``, ``null``,
``outside``; seeds 39000 to 39044; 2026-11-28); one more wrong name among the 200 surest is counted as if it
had been seen."""

EXCESS: Final = 2.0
"""[floors] What is left beyond the sensors' noise and has structure; less is no model's fault."""

STRUCTURE: Final = 0.1
"""[-] RMS of the autocorrelation between two lags above which a residual has structure: white noise of ten
seconds has half of that."""

STRUCTURE_LAGS: Final = (0.1, 0.5)
"""[s] Those lags: longer than the filter's memory, shorter than a motion."""

# --- what was looked for, and how candidates are made --------------------

MOST_KINDS: Final = 6
"""[effects] So many different ones are named at most; what is left beyond is unexplained."""

DAMPED: Final = 0.05
"""[share of critical damping] How much a spring is damped when it is first tried."""

OSCILLATOR_RATE: Final = 300.0
"""[steps/s] The fewest in which the motion of a spring is integrated."""

TWIST_CUTOFF: Final = 6.0
"""[Hz] Cutoff of what is differentiated twice: at 15 Hz that was noise (docs/decisions/0047)."""

FILTERED_AT_ONCE: Final = 1_000_000
"""[numbers] About so many, of candidates' columns, are filtered in one pass, or those of one candidate."""

# --- contacts and second encoders --------------------

CONTACT_ODDS: Final = (0.67, 1.05)
"""[-; by log of the force in its standard errors] That what was found is a contact, a logistic regression:
maximum likelihood of 68 of them, right or not, in blind trials of all kinds (seeds 39000 to 39044, 46000 to
46039, 47000 to 47039; 2026-11-28)."""

CONTACT_EDGE: Final = 0.02
"""[s] So well is either end of a contact's window known."""

CONTACT_LOUD: Final = 2.0
"""[ratio of RMS] In its window a contact leaves more than this at some joint, beside the rest of the log."""

CONTACT_NARROW: Final = 30.0
"""[degrees] A contact's force has a known direction if the true one is as near to it with 95 %,"""

CONTACT_WIDE: Final = 90.0
"""[degrees] and none at all, nor a sign, if it may be as far from it."""

ENCODER_CONFIDENCE: Final = 0.95
"""[probability] The confidence of what two encoders show without a fit to the torques."""

ENCODER_MOVING: Final = 0.02
"""[share of top speed] A slower joint may stick: friction is then unknown."""

ENCODER_SAMPLES: Final = 100
"""[samples] Fewer of a second encoder, without a gap, are not looked at."""

ENCODER_SURE: Final = 2.0
"""[standard errors] A compliance that is not so far from none cannot be told from a rigid gear."""
