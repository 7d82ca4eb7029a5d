"""Effects without a reference written by hand: the torque by the equation that their definition prints."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.effects.catalogue import effect
from robodyn.effects.effect import Effect
from robodyn.errors import InputError
from robodyn.verify.typeset import ARRAYS, value

Floats = NDArray[np.float64]
#: Where in a drive an effect can act that is its printed equation and nothing else.
PLACES = ("link", "bearing", "gear", "motor")


class NoReferenceError(InputError):
    """Nothing independent is known to compare an effect with."""


def _no_reference(known: Effect, why: str) -> NoReferenceError:
    return NoReferenceError(
        f"there is no reference for {known.id}",
        found=why,
        remedy=f"write one for {known.id} in robodyn/verify/effects.py, from its source",
    )


def declared_place(id: str) -> str:
    """Where the effect ``id``, for which there is no reference, acts.

    Raises
    ------
    NoReferenceError: what it does is more than its equation.
    """
    known = effect(id)
    if known.memory is not None or known.coupler is not None:
        raise _no_reference(known, "an effect that remembers")
    if known.place not in (*PLACES, "sensor", "outside"):
        raise _no_reference(known, f"an effect at the place {known.place!r}")
    return known.place


def declared_torque(id: str, p: Mapping[str, Any], site: Mapping[str, Floats]) -> Floats:
    """The torque ``[N]`` [N m or N] by the equation that the effect ``id`` is typeset with, at a ``site``:
    arrays by symbol.

    Raises
    ------
    NoReferenceError: its LaTeX is not of the form ``\\tau = ...``, or cannot be read.
    """
    known = effect(id)
    equation = re.fullmatch(r"\s*\\tau\s*=(.*)", known.latex, re.S)
    if equation is None:
        raise _no_reference(known, f"an equation that is not \\tau = ...: {known.latex}")
    symbols: dict[str, Any] = dict(site)
    for parameter in known.parameters:
        if parameter.symbol and isinstance(p.get(parameter.name), float):
            symbols[parameter.symbol] = p[parameter.name]
    try:
        torque = value(equation[1], symbols, ARRAYS)
    except (SyntaxError, KeyError, ValueError) as error:
        raise _no_reference(known, f"an equation that cannot be read: {error}") from error
    return np.asarray(torque + np.zeros_like(site[r"\dot q"]))
