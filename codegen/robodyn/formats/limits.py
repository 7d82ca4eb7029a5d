"""The numbers that the reading of other formats goes by, each with its unit and meaning."""

from __future__ import annotations

QUARTER_TURN: float = 1e-11
"""[rad] An angle of a file this near to a multiple of pi/2 is that multiple, which was written with 12 digits
(1.57079632679 is off by 4.9e-12)."""
