"""Every number by which a fleet's files are read and its logs are digested and judged.

Below each stand its unit and what it decides. Where no source is given, the value is a choice and was not
derived. What names units is no number here: it is measured by permutations of dates in the fleet itself.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

PIECE: Final = 200_000
"""[samples] A longer log is read in pieces of so many: what a process needs does not grow with it."""

LOGS_AFTER: Final = 2
"""[logs] The diagnosis of a unit is of its last so many since a change, and of one from before it."""

# --- its files --------------------

LARGEST_FILE: Final = 4 << 20
"""[bytes] A fleet.toml with more is refused: thousands of types need less."""

LARGEST_MANIFEST: Final = 256 << 20
"""[bytes] A manifest with more is refused: a million logs need less."""

MOST_ENTRIES: Final = 5_000_000
"""[files and folders] A pattern that goes through more is refused: it was meant for another folder."""

DEEPEST: Final = 40
"""[folders in each other] ``**`` goes no deeper: links that lead round in circles end as well."""

MOST_FIELDS: Final = 4
"""[fields of any text, and stars, in a part of a path] With more, a name fits a pattern in too many ways."""

LONGEST_FORMAT: Final = 100
"""[characters] The longest format of dates."""

MOST_CONDITIONS: Final = 64
"""[conditions] A log with more is refused: its columns are no conditions."""

LISTED: Final = 3
"""[names] Of many files with the same fault so many are named."""

MOST_LOGS: Final = 1_000_000
"""[logs] A fleet with more is refused."""

LONGEST_NAME: Final = 200
"""[characters] A type, a unit or a condition with a longer name is refused: a slip of a pattern."""

# --- digests --------------------

MOVES: Final = 0.15
"""[share of its RMS speed] A joint that is slower rests, or is so slow that its friction is a set."""

RIDGE: Final = 1e-6
"""[share of the largest] Singular values of a joint's columns that are smaller count as none."""

LEAST_ROWS: Final = 20
"""[samples] A joint with fewer that move, beyond as many as it has numbers, is not observed in a piece."""

AFTER_TURN: Final = 0.15
"""[s] So long after its load has changed sign a joint with play rings, and so long before and after it turns
round its friction is not known."""

CELL: Final = 0.12
"""[rad or m] A path is known by the cells of a grid of this size that it goes through,"""

MOST_CELLS: Final = 600
"""[cells] and a path through more of them by those of a wider grid."""

# --- numbers --------------------

LINK_SHARE: Final = 0.03
"""[share] Units of a type are built so alike: inertial numbers, by the size of their link."""

GAIN_SHARE: Final = 0.2
"""[share] The gain of a torque may be off by so much before logs speak,"""

BODY_SHARE: Final = 0.3
"""[share of the arm's mass] a body at the tip be as heavy,"""

ANY_NUMBER: Final = 1e4
"""[-] and any number of a drive be so many times what is usual of it."""

SEEN: Final[Mapping[str, float]] = {"friction": 0.10, "gain": 0.05, "offset": 0.25, "play": 0.3, "body": 0.02}
"""[share] A log shows a feature if its standard error is smaller: of friction and of a bias beside the
friction of the joint, of a body beside the arm's mass. A change of three of them shows in one log."""

# --- programs --------------------

COVERED: Final = 0.7
"""[share] Two paths are of one program if so much of one lies along the other,"""

PART_COVERED: Final = 0.3
"""[share] and so much of that along the first, which may be a part of it."""

# --- changes --------------------

LEAST_LOGS: Final = 5
"""[logs] A change is looked for in a unit with as many that show the feature."""

ONE_LOG: Final = 0.6
"""[share of the squares] A change may not lie on one log: of two logs each has at most half."""

DATES: Final = 16
"""[dates] A drift begins and ends on one of so many."""

PERMUTATIONS: Final = 200
"""[-] of the dates of a unit's logs, by which chance is measured."""

CALM: Final = 0.2
"""[share] Units that are among so many of the oddest of their own permutations do not say what chance does to
others: a real change would."""

FREEDOM: Final = 10.0
"""[degrees of freedom] What logs of the fleet usually scatter by counts as much beside a unit's own. A choice
that nothing derived, made on simulated fleets of PUMA 560 and UR10 (decision 0052), not on data kept apart:
permutations of dates make the test hold with any."""

TRIMMED: Final = 2.5
"""[standard deviations] A reading that is farther off says nothing of what conditions do."""

SURE_SLOPE: Final = 4.0
"""[standard errors] A condition counts if its slope is so sure."""

FALSE_NAMES: Final = 0.05
"""[share] of all units with a name that are false, in the mean (Benjamini and Hochberg 1995)."""

CHANGES: Final = 0.8
"""[share] of the false names is for changes, the others are for what was always so. A choice that nothing
derived: with half for each a change was missed in the same simulated fleets."""

SIBLINGS: Final = 8
"""[units] A unit may always have been another than its siblings in a type of so many. A choice that nothing
derived: their scatter, of which a unit's distance is a multiple, is then one of 0.37 * 7 degrees of
freedom."""

ALWAYS: Final = 2.0
"""[-] Friction of siblings differs: only a unit with more than twice of it, or less than half, has a name."""

# --- clocks --------------------

CLOCK_OFF: Final = (0.02, 0.2)
"""[share] A period between samples that is off by so much is a wrong clock; by more, another rate."""

# --- what is said --------------------

FIRST: Final = 10
"""[units] to look at first."""
