"""Every number by which contacts are found in a log.

Below each stand its unit and what it decides. Where no source is given, the value is a choice: simulated
pushes and real logs without any (docs/diagnose.md) bear it out, and it was not derived.
"""

from __future__ import annotations

from typing import Final

# --- rough fit --------------------

CONTACT_CUTOFF: Final = 8.0
"""[Hz] Cutoff of the signals in which contacts are sought,"""

CONTACT_BAND: Final = 0.2
"""[share of the rate] and no more than this."""

LOOSE: Final = 0.5
"""[share] The arm's numbers may be off by so much (standard deviation) when contacts are sought."""

FIT_KNEE: Final = 2.0
"""[standard deviations] from which on a residual counts less (Cauchy)."""

REST_WEIGHT: Final = 0.02
"""[-] Weight of a joint's samples while it rests, when friction is fitted."""

SLOWEST: Final = 0.1
"""[rad/s or m/s] Friction of a joint that is slower throughout is no larger than its torque at this speed."""

LEAST_SIZE: Final = 0.01
"""[share of the arm's largest RMS torque] No joint's torque is taken to be smaller."""

# --- bursts --------------------

QUIET_REACH: Final = 0.6
"""[s] The arm is quiet where, within this time before and after,"""

QUIET_ANGLE: Final = 0.06
"""[rad] no revolute joint covers more,"""

QUIET_WAY: Final = 0.02
"""[m] and no prismatic one."""

QUIET_NEAR: Final = 0.25
"""[s] Beside a motion it is where this is so on one side for twice that time, and within so much of both at
the same rate."""

QUIET_SHARE: Final = 0.4
"""[share of the samples] So much of a quiet span at least is without contact: its level is that of the
rest."""

QUIET_PIECE: Final = 12.0
"""[s] In a longer quiet span the level may change slowly: each piece of this length has its own."""

MEDIAN_TIME: Final = 0.4
"""[s] The noise of a quiet arm is what is beside the running median over this time,"""

WANDER: Final = 0.1
"""[share of dry friction] and at least so much, for a torque wanders within stiction."""

LEAST_SPREAD: Final = 1e-3
"""[share of RMS torque] What is left of a quiet arm is not taken to be less."""

STICTION: Final = 1.5
"""[-] A joint at rest may need so many times its dry friction before it moves."""

BURST_HIGH: Final = 6.0
"""[standard deviations] A burst is where some joint's residual is larger,"""

BURST_ENERGY: Final = 12.0
"""[mean squares] and all joints' mean square together."""

STEP_TIME: Final = 0.1
"""[s] A burst begins with a step of the mean over this time,"""

STEP_HIGH: Final = 5.0
"""[standard deviations] of this size,"""

RINGING_TIME: Final = 0.3
"""[s] The filter rings for so long beside a step,"""

RINGING_SHARE: Final = 0.4
"""[share of the step] by less than this;"""

SUSTAINED: Final = 0.3
"""[share of the 75th percentile] Between its steps a burst is as large,"""

SUSTAINED_SHARE: Final = 0.85
"""[share of its samples] for so much of it."""

END_STEP: Final = 0.4
"""[share of its smaller outer step] At a step inside it that is larger a burst may have ended:"""

FALLEN: Final = 0.7
"""[share of it] if it is less after it."""

LONGEST_RISE: Final = 0.7
"""[s] A burst is widened by as much on either side, to where it rises and fades,"""

RISE_SHARE: Final = 0.5
"""[share of it] and by no more than this,"""

FADED: Final = 0.2
"""[share of its median] that is, while more is left of it,"""

LEVEL_TIME: Final = 0.35
"""[s] Its level is that of as long before and after it."""

SHORTEST: Final = 0.06
"""[s] Shorter bursts are none,"""

LONGEST: Final = 3.0
"""[s] nor are longer ones,"""

LONGEST_SHARE: Final = 0.5
"""[share of the log] or those that cover more of it."""

EXCESS_SHARE: Final = 0.5
"""[share of all that stands out] In motion, contacts make up so much of it; else the model lacks
something."""

ABOVE_OTHERS: Final = 70.0
"""[-] In motion a contact is larger than what else stands out by a factor that, times what a force explains
of it by what it does not, is more: swinging tools came to 33 at most, nearly all pushes to 140 at least;"""

SHORT_TIME: Final = 0.15
"""[s] over as long."""

ALONE_SHARE: Final = 0.8
"""[share of what stands out at a joint] In motion a burst at one joint alone is a contact if it is so
much."""

MOST_LOAD: Final = 0.75
"""[share of its largest torque elsewhere] and its torque is smaller."""

REST_EDGE: Final = 0.2
"""[s] As near to a motion a torque at rest is that of setting out or of coming to rest;"""

SHORT_REST: Final = 3.0
"""[s] a shorter rest at an end of a log with motion is that of brakes and drives being switched."""

SLACK: Final = 0.2
"""[share] Where all joints that carry more than so much of the largest torque carry less than so much of what
they do beside it, brakes hold them."""

SLOW_SHARE: Final = 0.05
"""[share of RMS speed] A joint that is slower may stick."""

END_TIME: Final = 0.5
"""[s] As near to the ends of a log the start of a motion is not mistaken for contact."""

# --- force --------------------

EXPLAINED: Final = 0.6
"""[share of squares] A constant force on one link explains as much of a contact's window,"""

LEAST_EVIDENCE: Final = 3.0
"""[log-likelihood] and is so much more likely than what one joint does alone."""

ARM_OF_FORCE: Final = 0.05
"""[m] The point of contact is as far from a point of its link (standard deviation)."""

LEAST_LEVER: Final = 0.05
"""[m] A point with a shorter lever at all joints is not where a link is touched."""

FORCE_MOST: Final = 3.0
"""[-] A force is at most so many times what would make the torques with its best lever."""

LEAST_FORCE: Final = 0.1
"""[share of that] and at least as large (standard deviations of the prior)."""

TURNED: Final = 0.1
"""[rad] while no joint turns farther."""

PLACES: Final = (0.25, 0.5, 0.75, 1.0)
"""[shares of the way to the next joint] where a link may be touched."""

MOST_COURSE: Final = 2.0
"""[-] In motion a force is never so many times its mean."""

WHOLE: Final = 0.9
"""[share of squares] A burst in motion is one push if a force explains as much, though its size falls."""

CORRELATED: Final = 0.2
"""[s] What is left of an arm in motion is another after as long."""

OWN_ERROR: Final = 0.07
"""[share of a joint's torque] in a window that no force need explain: friction changes with the load,"""

ALL_ERROR: Final = 0.02
"""[share of the largest joint's torque] and as much of all: the pose is not exactly known."""

SHIFT_ERROR: Final = 0.5
"""[share of the change of level] What stiction holds after a push it may have held during it."""

HELD: Final = 0.5
"""[share of dry friction] A resting joint keeps so much of a push from its motor, or gives it (standard
deviation)."""

LEAST_PUSH: Final = 0.03
"""[share of RMS torque and dry friction] A push that makes less at all joints is not reported,"""

LEAST_OF_LARGEST: Final = 0.1
"""[share of the largest push of the log] nor one that is smaller beside others."""

MARGIN: Final = 0.1
"""[s] A window is left out of all fits with so much before and after it."""
