"""The numbers that decide how numbers of other frames and formats are rounded, each with unit and meaning."""

from __future__ import annotations

QUARTER_TURN: float = 1e-11
"""[rad] An angle of a file this near to a multiple of pi/2 is that multiple, which was written with 12 digits
(1.57079632679 is off by 4.9e-12)."""

ONE_TURN: float = 6.2832
"""[rad] Angles beyond it are doubted: they were probably meant as degrees."""

SIX_TURNS: float = 40.0
"""[rad] Limits of a joint beyond it are doubted, if they are multiples of 5: as degrees are."""

MANY_TURNS: float = 720.0
"""[rad] Limits beyond it are no degrees either: no limits at all, probably."""

NOTHING: float = 1e-12
"""[share] Beside the arm's reach (of a tensor: its trace) a smaller number is 0."""

NOISE: float = 1e-15
"""[share] So much of the arm's reach sums of rounded numbers may be off: a decimal this near is meant."""

DECIMALS: int = 12
"""[decimal places] Of a decimal that is meant."""

WRITTEN: int = 17
"""[decimal places] Programs write doubles below 10 with so many; sums of such numbers are not rounded."""
