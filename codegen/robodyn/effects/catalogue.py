"""All effects by id, in the order in which a person reads them."""

from __future__ import annotations

import difflib
from types import MappingProxyType
from typing import Final

from robodyn.effects import bearings, friction, joints, rigid, sensors
from robodyn.effects.effect import Effect
from robodyn.errors import InputError

_EFFECTS = (*friction.EFFECTS, *bearings.EFFECTS, *joints.EFFECTS, *rigid.EFFECTS, *sensors.EFFECTS)
CATALOGUE: Final = MappingProxyType({effect.id: effect for effect in _EFFECTS})


def effect(id: str) -> Effect:
    """The effect of that id.

    Raises
    ------
    InputError: there is none.
    """
    if id not in CATALOGUE:
        raise InputError(
            f"unknown effect {id!r}", expected=f"one of {', '.join(CATALOGUE)}", remedy=nearest(id)
        )
    return CATALOGUE[id]


def nearest(id: str) -> str | None:
    """``did you mean ...?`` for a mistyped id."""
    close = difflib.get_close_matches(id.lower(), CATALOGUE, 1, 0.5)
    return f"did you mean {close[0]!r}?" if close else None
