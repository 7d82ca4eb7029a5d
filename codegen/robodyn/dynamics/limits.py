"""Numbers that decide in this room."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

#: Joints of an arm at most for which a function is also written in ways that only few joints suit
#: (``Function.small``): over the whole mass matrix, whose entries grow with the square of the joints, where
#: a recursion grows with the joints. At 6 joints the recursion takes two thirds of the operations.
FEW_JOINTS: int = 4

#: Joints of an arm from which on a function is also written in ways that only many joints suit
#: (``Function.of_long_arms``): without the mass matrix, whose factors grow with the cube of the joints. Of
#: fewer joints no arm takes fewer operations so; that of a tool's mass matrix begins at some 12, the inverse
#: mass matrix at some 20.
MANY_JOINTS: int = 9

#: Joints of an arm at most whose Christoffel's symbols are written: there are as many as the joints' cube,
#: and operations grow faster.
SYMBOLS_JOINTS: int = 12

#: Sections of an arm at most (joints and the parallel ones that follow each) at all of which it is tried
#: whether places and levers take fewer operations when they are put together from there: the work grows with
#: the square of the sections, or their cube. Of longer arms the first and the last sections are tried.
SECTIONS_TRIED: int = 12

#: Finite fields at most, of 120 bits each, whose residues together write a factor of a base parameter down.
MOST_FIELDS: int = 40

#: The distance from 1 to the next number of a type: by it programs tell what is zero from what is rounding.
ROUNDING: Mapping[str, Fraction] = {"double": Fraction(1, 2**52), "float": Fraction(1, 2**23)}

#: Digits to which programs of poses are compared with plain forward kinematics. How far they may miss a pose,
#: as a share of the arm's size: by so many squares of the rounding unit, which keep divisors from 0; where
#: numbers of the description were taken for its rounding; at the edge of reach, which single precision does
#: not tell from what is beyond. Within how many roots of the rounding unit [rad or m] positions are the
#: same: where branches meet half the digits are lost.
PROVEN_DIGITS: int = 60
PROVEN_SHARE: int = 1 << 20
NEGLECTED_SHARE: Fraction = Fraction(1, 10**11)
EDGE_SHARE: Fraction = Fraction(1, 500)
SAME_POSITION: int = 128

#: Joints of arms that can do less than a pose asks for, and more than bring their tool to a place.
TASK_JOINTS: range = range(4, 6)

#: Poses of drawn positions, and as many others, at which that is looked at: an arm's branches exist together
#: at about half of all poses.
DRAWN_POSES: int = 6
