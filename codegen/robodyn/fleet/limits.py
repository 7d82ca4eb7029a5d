"""Every number by which a fleet's logs are gone through: below each its unit, and what it decides."""

from __future__ import annotations

from typing import Final

PIECE: Final = 200_000
"""[samples] A longer log is read in pieces of so many: what a process needs does not grow with it."""

HASHED: Final = 32
"""[logs] So many are read at a time to see whether they are new: one takes a millisecond or two."""

LOGS_AFTER: Final = 2
"""[logs] The diagnosis of a unit is of its last so many, none of them from before a change of it,"""

LOGS_BEFORE: Final = 1
"""[logs] and another of so many from before that."""
