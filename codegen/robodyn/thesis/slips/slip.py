"""A slip in the thesis: place, print, what is right, and what tries it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Final

from robodyn.thesis.slips.comparison import Comparison
from robodyn.thesis.slips.recursion import PUMA, STANFORD, Recursion, of_recursion


@dataclass(frozen=True, slots=True)
class Slip:
    """A slip at ``place``: what is ``printed`` and what is ``right``, in words; ``check`` computes both, or
    says why there is nothing to compute."""

    place: str
    printed: str
    right: str
    check: Callable[[], Comparison] | str


#: Why nothing can be computed.
REFERENCE: Final = "a reference in the text"
NAME: Final = "a name or a word, whose formula is right otherwise"


def puma(slip: type[Recursion]) -> Callable[[], Comparison]:
    """The recursion with ``slip``, on the six-joint PUMA of program D.2."""
    return partial(of_recursion, slip, PUMA)


def stanford(slip: type[Recursion]) -> Callable[[], Comparison]:
    """The recursion with ``slip``, on the six-joint Stanford arm of listing D.3.2."""
    return partial(of_recursion, slip, STANFORD)
