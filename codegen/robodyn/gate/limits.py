"""Every number by which a log is judged before anything is fitted.

Below each stand its unit and what it decides. Where no source is given, the value is a choice: the blind
tests (docs/diagnose.md) bear it out, and it was not derived. Numbers of a diagnosis stand in no other kind of
module (tests/diagnose/test_limits.py).
"""

from __future__ import annotations

from typing import Final

# --- rows --------------------

BOUNDS: Final = {"t": 1e15, "q": 1e3, "qd": 1e4, "qdd": 1e7, "tau": 1e6, "ql": 1e3}
"""[s; rad or m, and per s, per s^2; N m or N] A larger number in a column is garbage, whatever the robot."""

GARBAGE_SHARE: Final = 0.03
"""[share of rows] A log with more rows that hold no number, or garbage, is refused."""

REPEATED_SHARE: Final = 0.05
"""[share of rows] A log that repeats more of its times with other values is refused."""

FEWEST_ROWS: Final = 100
"""[rows] A log with fewer cannot be diagnosed."""

FRAGMENT_ROWS: Final = 20
"""[rows] Shorter pieces between gaps are left out."""

SLOWEST_PERIOD: Final = 0.2
"""[s] Samples further apart show no dynamics: refused."""

LOST_SHARE: Final = 1.25
"""[periods] A step that is longer by this and half a period has lost a row, or more; a shorter one has not:
the clock changed, or was late."""

FILLED_ROWS: Final = 3
"""[rows] A gap of no more missing rows is filled in."""

FILLED_TIME: Final = 0.005
"""[s] A gap that lasts no longer is filled in, however many rows it has."""

# --- second encoders --------------------

LINK_SLOPE: Final = 0.1
"""[-] A second encoder that moves by a factor further from 1 than its joint has another unit or joint."""

LINK_MOTION: Final = 0.02
"""[rad or m] Of a joint that moves less nothing is said about its second encoder."""

# --- spikes --------------------

MOST_JUMPS: Final = 0.03
"""[share of rows] Above it, what looks like jumps is how the signal is."""

LARGEST_ACCELERATION: Final = 2000.0
"""[rad/s^2 or m/s^2] No arm brings about more: a position that does jumps."""

JUMP_FACTOR: Final = 20.0
"""[-] A change so many times its 99th percentile is a jump."""

FASTEST: Final = 120.0
"""[rad/s or m/s] A position that changes faster jumps, however often it does."""

LONGEST_SPIKE: Final = 3
"""[rows] The longest spike of a torque."""

LONGEST_DROPOUT: Final = 100
"""[rows] The longest dropout of a position."""

FEWEST_CHANGES: Final = 100
"""[changes] With fewer no usual change is known, and no spike is sought."""

# --- stuck --------------------

STAY_ROWS: Final = 40
"""[samples] The shortest stay of an encoder that counts as stuck."""

STAY_TIME: Final = 0.05
"""[s] The same in time; the longer of the two holds."""

STUCK_SPEED: Final = 0.15
"""[share of top speed] A joint as fast just before the stay cannot have stopped so."""

STUCK_LEAST: Final = 0.05
"""[rad/s or m/s] and no slower than this before it."""

BEFORE_STAY: Final = 10
"""[samples] The speed before the stay is taken over as many."""

BRAKING_TORQUES: Final = 2.0
"""[largest torques of the joint] Motor and friction together brake with no more: friction that the motor does
not overcome lets nothing move. A speed that this takes away within a sample is no sign of a frozen sensor."""

STUCK_SHARE: Final = 0.03
"""[share of samples] A log that is stuck for more is refused."""

# --- smooth --------------------

SMOOTHING_REACH: Final = 0.08
"""[s] How long the local parabola through the signals reaches."""

SMOOTHING_LEAST: Final = 7
"""[samples] The fewest samples it takes."""

# --- flag --------------------

MOST_SPANS: Final = 100
"""[spans] More of a flag are counted and not listed."""

CHUNK: Final = 1 << 18
"""[samples] What is worked on at a time, so that a long log takes little memory."""

# --- gate --------------------

MOST_SAMPLES: Final = 200_000
"""[samples] As many of a log are used at most."""

SLOW_RATE: Final = 50.0
"""[Hz] A log below this rate is flagged."""

SHORT_LOG: Final = 3.0
"""[s] A log shorter than this is flagged."""

# --- grid --------------------

WINDOWS: Final = 20
"""[windows] A log that is too long is cut down to as many."""

MOVING_SHARE: Final = 0.1
"""[share of the largest motion] A window that shows less is left out."""

FAST_RATE: Final = 2000.0
"""[Hz] A log that is too long and faster is averaged down to half of it at least."""

# --- samples --------------------

TURN_NEAR: Final = 0.5
"""[rad] A change as near to a whole turn is an angle that begins anew."""

FEWEST_REPEATS: Final = 3
"""[rows] With fewer that only repeat the row before nothing is said of them,"""

MOST_REPEATS: Final = 0.25
"""[share of rows] nor with more: such a log is held, or at rest."""

REPEAT_SPEED: Final = 0.3
"""[share of the 90th percentile] As fast moves the arm before and after a row that was sent twice."""

REPEAT_EVENLY: Final = 0.35
"""[share of their mean] Distances between such rows that spread less come of a slower source."""

CONSTANT_TIME: Final = 0.3
"""[s] As long positions are the same in every digit before it is told."""

SMOOTH_SHARE: Final = 1e-3
"""[share of the torque's standard deviation] Less noise from sample to sample is not believed."""

UNKNOWN_SHARE: Final = 2e-3
"""[share of the torque's standard deviation] Of such a torque this is the least noise that is taken;"""

SPECTRUM_BAND: Final = ((0.04, 12.0), (0.15, 30.0))
"""[shares of half the rate, Hz] the spectrum from the larger of the first to that of the second is taken,"""

SPECTRUM_PIECES: Final = 8
"""[pieces] as the median of as many pieces of the log."""

# --- rest --------------------

REST_SPEED: Final = 1e-3
"""[rad/s] A revolute joint that is slower stands still, whatever its top speed,"""

REST_WAY: Final = 2e-4
"""[m/s] and a prismatic one;"""

REST_NOISE: Final = 3.0
"""[standard deviations] and so does one whose position changes by no more than so much of its noise."""

REST_TIME: Final = 0.1
"""[s] Shorter is a reversal and no rest."""

# --- content --------------------

ONE_WAY_SHARE: Final = 0.02
"""[share of moving samples] A joint that goes the other way for less goes one way only."""

NARROW_ANGLE: Final = 0.35
"""[rad] A revolute joint that covers less is flagged as narrow."""

NARROW_WAY: Final = 0.05
"""[m] The same of a prismatic joint."""

FEW_REVERSALS: Final = 4
"""[reversals] A joint that turns round less often is flagged."""

PILED_SHARE: Final = 5e-4
"""[share of moving samples] A torque is cut off if it is at its extreme for as many,"""

PILED_SAMPLES: Final = 10
"""[samples] for as many,"""

PILE_FACTOR: Final = 8.0
"""[-] and so many times more often than just beside it."""

STILL_SPEED: Final = 0.01
"""[share of top speed] A slower joint stands still."""

STANDSTILL: Final = 1.0
"""[s] A shorter standstill of all joints is not listed."""

RESOLUTION_SAMPLES: Final = 20_000
"""[samples] The steps of an encoder are sought in the first so many."""

LOAD_STATES: Final = 2000
"""[states] At as many the model's torques are evaluated to say how the motion loads the joints."""

# --- likeness --------------------

LEAST: Final = 0.4
"""[-] The model's torque is fitted to a log's with a factor of at least this,"""

MOST: Final = 2.5
"""[-] and of at most this."""

LIKENESS_FLOOR: Final = 0.01
"""[share of variance] Less is not told apart when readings of a log are compared;"""

EXACT_FLOOR: Final = 0.001
"""[share of variance] nor is this where the model's torque is taken as it is."""

# --- model --------------------

COMPARED_STATES: Final = 600
"""[states] At as many a log is compared with the model."""

FEWEST_MOVING: Final = 50
"""[samples] With fewer in motion nothing is said of signs, units and order,"""

LEAST_ANGLE: Final = 0.1
"""[rad] nor where no revolute joint goes farther,"""

LEAST_WAY: Final = 0.02
"""[m] and no prismatic one."""

UNLIKE: Final = 0.7
"""[share of variance] A joint with more of its torque unexplained is unlike the model."""

LIKE: Final = 0.3
"""[share of variance] A joint with less unexplained is like it. Between the two nothing is said."""

REFUSED_GAIN: Final = 8.0
"""[factor of the unexplained] A log is refused for a changed reading (two joints swapped) that gains more."""

FLAGGED_GAIN: Final = 3.0
"""[factor of the unexplained] One that gains more is flagged."""

SURE_GAIN: Final = 100.0
"""[factor of the unexplained] One that gains more holds even if an effect hides one of the joints."""

REVERSED_SHARE: Final = 0.5
"""[-] Joints numbered from the tip: read from the base, most of them leave no more than so much of it."""

LEAST_SCALE: Final = 0.2
"""[-] Below this multiple of the model's torques, a log's are of another unit;"""

MOST_SCALE: Final = 5.0
"""[-] and above this one."""

KNOWN_UNIT: Final = 0.2
"""[share] A factor as near to a known unit's is that unit."""

DRIVING_SHARE: Final = 0.05
"""[share of variance] Friction that drives shows a flipped sign if it makes up as much."""

ALIKE_GAIN: Final = 0.5
"""[share of the best gain] Changed readings that gain as much are named beside the best."""

SLIGHT: Final = 0.05
"""[share of variance] From so much unexplained on, another reading of the columns is compared:"""

NEARER: Final = 8.0
"""[-] it is nearer to the model if it leaves so many times less at a joint,"""

WORSE: Final = 0.01
"""[share of variance] and not more than this at another joint,"""

WORSE_FACTOR: Final = 3.0
"""[-] nor so many times more."""

SLIGHT_EXACT: Final = 0.002
"""[share of variance] As `SLIGHT`, where the model's torque is taken as it is: joints that are much alike."""

NEARER_EXACT: Final = 6.0
"""[-] As `NEARER`, there."""

WORSE_EXACT: Final = 0.001
"""[share of variance] As `WORSE`, there."""

SPRUNG_FACTOR: Final = 4.0
"""[-] A sign is not flipped where a spring beside the model leaves so many times less."""

# --- rates --------------------

SURE_CORRELATION: Final = 0.95
"""[-] A rate with a higher correlation is surely that of a position."""

NO_CORRELATION: Final = 0.5
"""[-] A rate with a lower one is not that of its position."""

RATE_SCALE: Final = 0.25
"""[share] A rate whose scale is further off is flagged."""

KNOWN_RATE_SCALE: Final = 0.05
"""[share] A scale as near to a known one (degrees, millimetres ...) is that one."""

LATE_TIME: Final = 0.002
"""[s] A velocity that is later is flagged,"""

LATE_SHARE: Final = 0.2
"""[periods] if it is later than this too."""

LONGEST_LAG: Final = 0.1
"""[s] The longest lag between a position and its rate that is sought."""

# --- readings --------------------

BEYOND_LIMITS: Final = 1.3
"""[-] Positions beyond this multiple of the joint's limits are of another unit."""

TURNS: Final = 9.0
"""[rad] So are larger ones where the joint has no limits,"""

FAR: Final = 5.0
"""[m] and these of a prismatic joint."""
