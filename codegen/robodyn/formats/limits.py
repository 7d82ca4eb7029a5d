"""The numbers that the reading of other formats goes by, each with its unit and meaning."""

from __future__ import annotations

FILE_MIB: int = 16
"""[MiB] Largest file that is read; the largest of a hundred public robots has 0.2."""

DEPTH: int = 64
"""[levels] Deepest nesting of XML elements; a robot needs about 10."""

ELEMENTS: int = 100_000
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

SLIDE: float = 0.25
"""[share of the reach] Of axes that are nearly parallel, the common normal may lie far away: no frame's
origin slides further along its axis to it."""

STEEP: float = 0.5
"""[sine of the angle] Axes that are less parallel always have their frames at the common normal; then no
offset is longer than twice the reach."""

NEAR_RIGHT_ANGLE: float = 1e-4
"""[rad] An angle this near to a multiple of pi/2 was probably meant to be it, and written with few digits."""

SAME_INERTIA: float = 1e-9
"""[share of the largest entry] Tensors that differ by no more are the same but for rounding."""

PLACEHOLDER: float = 1.0
"""[kg, kg m^2] Mass and moments of a body that has none without its meshes, so that MuJoCo compiles it; the
tree has none for it."""

ROUNDING: float = 1e-15
"""[entry of a rotation] An entry this near to 0 or +-1 is that: what is left is the rounding of cosines."""

XACRO_SECONDS: int = 20
"""[s] Processor time that a xacro file may take; large robots take 2."""

XACRO_MEMORY: int = 1024
"""[MiB] Memory that the expansion of a xacro file may take, the interpreter in it."""

PICTURE_RADIUS: float = 0.02
"""[share of the sum of distances between frames] Radius of the cylinders that stand for links in exports."""

PICTURE_HUB: float = 1.4
"""[radius of a link's cylinder] Radius of the cylinder about a joint's axis, which is twice as long."""

LEAST_BODY: float = 1e-13
"""[share of the largest pseudo-inertia's trace] Mass [kg] and moments [kg m^2] of a body that stands for
none: too small to be noticed, and enough for MuJoCo, which refuses less than 1e-15."""

SLACK: float = 1e-9
"""[share] Principal moments may be so far beyond what a body has before they are replaced in an export: the
decimals of a table are rounded. Replacements have that much room."""

MOVED_DIGITS: int = 2
"""[digits] Digits after the first one of what an export moves from a link to the next."""
