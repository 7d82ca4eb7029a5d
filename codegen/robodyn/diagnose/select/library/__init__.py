"""What may be missing: for each entry of the catalogue the columns that it would add to the torques.

An effect states how it is looked for (:mod:`robodyn.effects.traits`), and here each of these ways is carried
out along a log. Friction of the drive is evaluated by the definitions themselves at unit parameters, where
they are linear; what is not linear in a parameter has a grid of values. Columns are torques [K, n], at the
full rate or the coarse one, unfiltered."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, Final

from robodyn.diagnose.select.library.candidate import Candidate, Context, Hints
from robodyn.diagnose.select.library.context import context_of
from robodyn.diagnose.select.library.elastic import twists
from robodyn.diagnose.select.library.laws import dahl, laws
from robodyn.diagnose.select.library.position import lines, waves
from robodyn.diagnose.select.library.sensors import all_channels, channels
from robodyn.diagnose.select.library.several import (
    numbers,
    pairs,
    regressor_seen,
    rotors_seen,
    without_regressor,
)
from robodyn.diagnose.select.scope import EVERYTHING, Scope
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect
from robodyn.effects.traits import Dahl, Law, Line, Shown, Twist, Wave

__all__ = [
    "Candidate",
    "Context",
    "Hints",
    "candidates",
    "context_of",
    "regressor_seen",
    "rotors_seen",
    "without_regressor",
]

#: What shows at a joint, by the way in which it is looked for.
_AT_JOINT: Final[Mapping[type, Callable[[Context, Effect, Any, int], Iterator[Candidate]]]] = {
    Law: laws,
    Line: lines,
    Wave: waves,
    Dahl: dahl,
    Twist: twists,
    Shown: channels,
}


def candidates(c: Context, scope: Scope = EVERYTHING) -> Iterator[Candidate]:
    """What the catalogue has in ``scope`` and a log can show."""
    for one in _candidates(c, scope):
        if scope.allows(one.effect, one.joint):
            yield one


def _candidates(c: Context, scope: Scope) -> Iterator[Candidate]:
    """Those of effects in ``scope``, and a few others that come with them."""
    ways = [(e, way) for e in CATALOGUE.values() for way in e.traits.candidates if scope.has_effect(e.id)]
    shown = [(effect, way) for effect, way in ways if isinstance(way, Shown)]
    for j in range(c.n):
        for effect, way in ways if scope.has_joint(j + 1) else ():
            if not isinstance(way, Shown) or effect.traits.channel is not None:
                yield from _AT_JOINT[type(way)](c, effect, way, j)
    for effect, way in shown:
        if effect.place == "pair":
            for j in range(c.n):
                for k in range(j):
                    yield from pairs(c, effect, way, j, k)
        elif effect.traits.channel is None:
            yield from numbers(c, effect, way)
        elif way.of_all is not None:
            yield from all_channels(c, effect, way)
