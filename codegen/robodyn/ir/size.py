"""How large a graph may grow."""

from __future__ import annotations

from robodyn.errors import InputError

#: Positions of a graph at most: building and comparing it takes some 2 GB and a minute or two, and its C has
#: 25 MB, more than compilers take.
MOST_POSITIONS = 1_500_000


class TooLarge(InputError):
    """A function of so many operations that no compiler takes it."""


def too_large() -> TooLarge:
    """The error of a graph that has grown beyond all use."""
    return TooLarge(
        "a function is larger than compilers take",
        found=f"more than {MOST_POSITIONS:,} operations",
        remedy="take fewer joints",
    )
