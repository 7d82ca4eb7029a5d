"""Every number by which a fleet's files are read and its logs are digested and judged.

Below each stand its unit and what it decides. Where no source is given, the value is a choice: simulated
fleets bear it out (docs/fleet.md).
"""

from __future__ import annotations

from typing import Final

import numpy as np

PIECE: Final = 200_000
"""[samples] A longer log is read in pieces of so many: what a process needs does not grow with it."""

HASHED: Final = 32
"""[logs] So many are read at a time to see whether they are new: one takes a millisecond or two."""

LOGS_AFTER: Final = 2
"""[logs] The diagnosis of a unit is of its last so many, none of them from before a change of it,"""

LOGS_BEFORE: Final = 1
"""[logs] and another of so many from before that."""
# --- its files --------------------

LARGEST_FILE: Final = 4 << 20
"""[bytes] A fleet.toml with more is refused: thousands of types need less."""

LARGEST_MANIFEST: Final = 256 << 20
"""[bytes] A manifest with more is refused: a million logs need less."""

MOST_LOGS: Final = 1_000_000
"""[logs] A fleet with more is refused."""

MOST_ENTRIES: Final = 5_000_000
"""[files and folders] A pattern that goes through more is refused: it was meant for another folder."""

DEEPEST: Final = 40
"""[folders in each other] ``**`` goes no deeper: links that lead round in circles end as well."""

MOST_FIELDS: Final = 4
"""[fields of any text, and stars, in a part of a path] With more, a name fits a pattern in too many ways."""

LONGEST_NAME: Final = 200
"""[characters] A type, a unit or a condition with a longer name is refused: a slip of a pattern."""

LONGEST_FORMAT: Final = 100
"""[characters] The longest format of dates."""

MOST_CONDITIONS: Final = 64
"""[conditions] A log with more is refused: its columns are no conditions."""

LISTED: Final = 3
"""[names] Of many files with the same fault so many are named."""
# --- digests --------------------

RIDGE: Final = 1e-8
"""[share of the largest] Columns of a joint that are farther from independent count as dependent."""

KNEE: Final = 2.5
"""[RMS] A sample that is off by more counts less."""

FIT_ROUNDS: Final = 2
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
# --- reduction --------------------

LINK_SCATTER: Final = 0.03
"""[share] Units of a type are built so alike: inertial numbers, by the size of their link."""

ALIKE: Final = 1e-9
"""[share] Numbers that a log tells apart by less are the same to it."""

GAIN_SCATTER: Final = 0.02
"""[share] So much do torque constants scatter from unit to unit."""

LEAST_ROTOR: Final = 1e-3
"""[share of what is possible] A rotor that is described as nothing may be as large."""

FIRST_SCATTER: Final = 0.05
"""[share of what is usual] Friction changes by so much from log to log, before logs speak,"""

FIRST_BODY: Final = 0.002
"""[share of the arm's mass] and a body at the tip by so much."""

OTHER_UNIT: Final = 3.0
"""[scatters between units] A unit may be farther from its siblings by this factor before that is a change."""

INFORMED: Final = 0.02
"""[share of the median log] A log that says less of a feature does not count among those before and after."""

LEAST_ALWAYS: Final = 1.0
"""[share] Friction of siblings differs by as much: only a unit with more than twice of it, or less than half,
has a name."""

BODY_SIZE: Final = 100.0
"""[share of the arm's mass] A body at the tip may have any mass below, before logs speak."""

ANY_NUMBER: Final = 1e4
"""[-] A number that a log does not show has a standard deviation of so many times what is usual of it."""

# --- population --------------------

LEAST_APART: Final = 0.02
"""[-] No combination of numbers of units has less variance, in units of theirs."""

EFFICIENCY: Final = 0.37
"""[-] A scatter by medians is as sure as that of so many times fewer normal numbers (Huber 1981)."""

MEDIAN: Final = 0.6745
"""[standard deviations] Half of all normal numbers are nearer to their mean."""

ROUNDS: Final = 8
"""[rounds] of means, slopes and scatters, each by the last ones."""

SLOPE_T: Final = 4.0
"""[standard errors] A condition counts if its slope is so sure."""

SLOPE_LOGS: Final = 20
"""[logs] No slope is fitted to fewer."""

VARIES: Final = 1e-4
"""[share of its squares] A condition that varies by less within units has no slope,"""

COLLINEAR: Final = 1e-3
"""[share] nor have several that vary together by so nearly the same."""

LEAST_SPREAD: Final = 1e-6
"""[share of what is usual] Scatters are not taken to be smaller."""

OUTLIER: Final = 3.0
"""[standard deviations] A reading that is off by more counts less."""

LEAST_LEFT: Final = 0.02
"""[-] The logarithm of what is left of a log's torque has at least so large an error."""

# --- changes --------------------

RAMPS: Final = (0.0, 45.0, 120.0, 240.0)
"""[days] A change takes so long, or as long as there are logs (0: at once)."""

ONSET_STEP: Final = 12.0
"""[days] Changes are looked for at so many days,"""

FINE_STEP: Final = 2.0
"""[days] and dated to so many."""

FINE_RAMPS: Final = (0.0, 20.0, 40.0, 70.0, 100.0, 150.0, 200.0, 300.0)
"""[days] How long a change may take, where it is dated."""

HALF: Final = 0.5
"""[share of a change] After it there is at least as much of it,"""

NOT_YET: Final = 0.1
"""[share of a change] and before it at most as much."""

LEAST_AFTER: Final = 2
"""[logs] A change shows in at least so many, to half of its size or more,"""

LEAST_BEFORE: Final = 2
"""[logs] and so many show what was before."""

STANDS_ALONE: Final = 0.3
"""[share of the log-likelihood] A change must be worth so much without any one log: an odd one is none."""

OTHER_WAY: Final = 3.0
"""[log-likelihood] Friction grows as a whole, unless that viscous or Coulomb friction alone explains as much
more."""

LEAST_SHARE: Final = 0.08
"""[share] A change of friction or of what is left that is smaller is not worth a name."""

SURE_SIZE: Final = 2.0
"""[standard errors] So sure must the size of any other change be,"""

LEAST_OF_ALL: Final = 0.05
"""[share] and all friction of a joint must differ by so much, though it be its viscous part alone that
does."""

SURE_BODY: Final = 3.0
"""[standard errors] So sure must the mass of a body be: its moment alone may be a program of motion."""

UNKNOWN: Final = 1e6
"""[-] The variance of a reading that there is not."""

OWN_SCATTER: Final = 5.0
"""[logs] Logs of a unit scatter as those of its type do, which counts as much as so many of its own."""

LEAST_BODY: Final = 0.002
"""[share of the arm's mass] Nor is a lighter body."""

PLAY_RISE: Final = 0.3
"""[-] What is left of a torque after reversals of the load must have grown by so much beside the rest of it,
as a logarithm, before play is named,"""

LEFT_RISE: Final = 0.7
"""[-] and all that is left, before it is said that something grows which nothing explains."""

# --- names --------------------

FALSE_NAMES: Final = 0.05
"""[share] of all units with a name that are false, in the mean (Benjamini and Hochberg 1995)."""

MIDDLE: Final = 0.5
"""[-] Half of all healthy units are as likely, and less likely the other half,"""

RARE: Final = 0.1
"""[-] and so many as are no likelier than that."""

FREEDOMS: Final = (np.inf, 100.0, 50.0, 30.0, 20.0, 15.0, 12.0, 10.0, 8.0, 7.0, 6.0, 5.0, 4.0)
"""[-] Of the scatter beside which units are odd, as far as units that are not very odd say."""

MOST_CLAIMS: Final = 3
"""[claims] A unit has at most so many."""

FIRST: Final = 10
"""[units] to look at first."""
