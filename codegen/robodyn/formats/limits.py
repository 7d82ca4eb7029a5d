"""The numbers that the reading of other formats goes by, each with its unit and meaning."""

from __future__ import annotations

QUARTER_TURN: float = 1e-11
"""[rad] An angle of a file this near to a multiple of pi/2 is that multiple, which was written with 12 digits
(1.57079632679 is off by 4.9e-12)."""

FILE_MIB: int = 16
"""[MiB] Largest file that is read; the largest of a hundred public robots has 0.2."""

DEPTH: int = 64
"""[levels] Deepest nesting of XML elements; a robot needs about 10."""

ELEMENTS: int = 200_000
"""[elements] Most elements of a file, with all that it includes; public robots have up to 5000."""

ATTRIBUTES: int = 100
"""[attributes] Most attributes of one element; MuJoCo knows elements with about 40."""

LINKS: int = 5000
"""[links] Most links, and most joints, of a tree."""

GREATEST: float = 1e12
"""[SI units] A larger mass, length or inertia is no arm's, and a sum of products of such numbers could
overflow; limits beyond it are none."""

SHORTEST_AXIS: float = 1e-9
"""[length of an axis as written] Shorter than that it has no direction."""

UNIT_AXIS: float = 1e-6
"""[length of an axis as written] Further from 1 than that, rounding is not the reason, and it is remarked."""

FILES_INCLUDED: int = 100
"""[files] Most files that one includes, directly and through others."""

LINES_SHOWN: int = 5
"""[lines] So many lines of the file are listed with something that is not used; then only how many more."""

NAMES_SHOWN: int = 40
"""[names] So many links or joints are listed in a message."""

DEGREES: float = 40.0
"""[rad] Limits beyond six turns that are multiples of 5 were probably meant as degrees."""
