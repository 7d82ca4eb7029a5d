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

BROKEN_SHARE: Final = 0.03
"""[share of rows] A log with more rows that hold no number, or garbage, or in which a position is stuck, is
refused; above it, what looks like jumps is how the signal is."""

REPEATED_SHARE: Final = 0.05
"""[share of rows] A log that repeats more of its times with other values is refused."""

FEWEST_ROWS: Final = 100
"""[rows] A log with fewer cannot be diagnosed; with fewer changes of a signal no usual one is known."""

FRAGMENT_ROWS: Final = 20
"""[rows] Shorter pieces between gaps are left out."""

SLOWEST_PERIOD: Final = 0.2
"""[s] Samples further apart show no dynamics: refused."""

LOST_SHARE: Final = 1.25
"""[periods] A step that is longer by this and half a period has lost a row, or more; a shorter one has not:
the clock changed, or was late."""

FILLED_ROWS: Final = 3
"""[rows] A gap of no more missing rows is filled in, and a spike of no more left out."""

FILLED_TIME: Final = 0.005
"""[s] A gap that lasts no longer is filled in, however many rows it has."""

# --- second encoders --------------------

LINK_SLOPE: Final = 0.1
"""[-] A second encoder that moves by a factor further from 1 than its joint has another unit or joint."""

# --- spikes --------------------

LARGEST_ACCELERATION: Final = 2000.0
"""[rad/s^2 or m/s^2] No arm brings about more: a position that does jumps."""

JUMP_FACTOR: Final = 20.0
"""[-] A change so many times its 99th percentile is a jump."""

FASTEST: Final = 120.0
"""[rad/s or m/s] A position that changes faster jumps, however often it does."""

LONGEST_DROPOUT: Final = 100
"""[rows] The longest dropout of a position."""

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
"""[rad/s] A joint that is slower stands still, whatever its top speed,"""

REST_NOISE: Final = 3.0
"""[standard deviations] and so does one whose position changes by no more than so much of its noise."""

REST_TIME: Final = 0.1
"""[s] Shorter is a reversal and no rest."""

# --- content --------------------

ONE_WAY_SHARE: Final = 0.02
"""[share of moving samples] A joint that goes the other way for less goes one way only."""

NARROW_ANGLE: Final = 0.35
"""[rad] A joint that covers less is flagged as narrow."""

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

# --- model --------------------

COMPARED_STATES: Final = 320
"""[states] At as many a log is compared with the model: where three say the same, an RMS that falls by a
tenth at one joint is 320 / 3 * log(1 / 0.9) = 11 in log-likelihood, and log(80 / 0.01) = 9 is asked for."""

BLOCKS: Final = 8
"""[blocks] of which one after the other is held out: 5 to 10 do (Breiman and Spector 1992)."""

LEAST_ANGLE: Final = 0.1
"""[rad] Nothing is said of signs, units and order where no joint goes farther, nor of a second encoder:
gravity changes by a tenth there, which is above the noise of a torque."""

LEVER: Final = 0.2
"""[m/rad] A way of a prismatic joint says as much as an angle that moves a hand as far: about as long are the
levers of the inertias that joints feel."""

UNSTATED_CONFIDENCE: Final = 0.4
"""[share] So far off may the inertial numbers be of a link that does not say: few files keep 10 %."""

LOAD_SHARE: Final = 0.1
"""[share of the arm's mass] The last link may bear a load of so much: arms lift a tenth of theirs."""

LOOSENED: Final = 10.0
"""[-] A description that is off is off by so many times what it says: with 0.4 a mass is then any number."""

RESOLVED_SHARE: Final = 0.1
"""[share of the RMS speed] Below it a joint's direction is not resolved."""

CHANCE: Final = 0.01
"""[-] So often a right reading is taken for another: likelihood ratios of held-out blocks are larger than
M / 0.01 by no more than this chance, M readings tried (Wasserman, Ramdas and Balakrishnan 2020)."""

FILTER_SHARE: Final = 0.005
"""[share of the torque's standard deviation] So much is left of quick motion by the filter of the comparison
(a parabola over 0.08 s takes as much off a swing of 1.5 Hz): less tells no reading from another."""

STEADY: Final = 7
"""[blocks] In as many a reading gains (by chance, 9 of 256), and enough without the best: a push is once."""

STEPS: Final = 6
"""[steps] of Gauss and Newton at most to a gain, a zero or a lateness: e^1.4 a step, 3 digits of a unit."""

LEAST_RELIEF: Final = 1.25
"""[-] By this factor the RMS that is left of some joint's torque falls with another reading. Calibrated: a
drive's filter alone makes torques of the UR10's recording 7 ms late, which is 1.04."""

ALIKE_GAIN: Final = 0.5
"""[share of the best gain] Readings that gain as much are named beside the best."""

MOST_SCALE: Final = 5.0
"""[-] Torques of all joints so many times the model's, or a part of it, are of another unit."""

TILT: Final = 0.5
"""[rad] A base that is tilted by less is an effect that a diagnosis names (docs/effects.md); by more it is
mounted otherwise. A choice."""

UNLIKE: Final = 0.7
"""[share of variance] A joint of which the arm leaves more of what friction leaves is unlike the model; one
of which the description's torque explains more of it is like it."""

# --- rates --------------------

SURE_CORRELATION: Final = 0.95
"""[-] A rate with a higher correlation is surely that of a position."""

NO_CORRELATION: Final = 0.5
"""[-] A rate with a lower one is not that of its position."""

RATE_SCALE: Final = 0.25
"""[share] A rate whose scale is further off is flagged; one as near to a known one (degrees, millimetres ...)
is that one."""

LATE_TIME: Final = 0.002
"""[s] A velocity that is later is flagged,"""

LATE_SHARE: Final = 0.2
"""[periods] if it is later than this too."""

LONGEST_LAG: Final = 0.1
"""[s] The longest lag between a position and its rate that is sought."""

# --- readings --------------------

BEYOND_LIMITS: Final = 1.3
"""[-] Positions beyond this multiple of the joint's limits are of another unit."""

FAR: Final = 7.0
"""[rad or m] of one without limits, which has them here: a turn and some."""
