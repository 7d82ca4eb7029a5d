"""All effects by id, in the order in which a person reads them: whatever a module of this folder lists."""

from __future__ import annotations

import difflib
import importlib
import pkgutil
from types import MappingProxyType
from typing import Final

from robodyn import effects
from robodyn.effects.effect import Effect
from robodyn.errors import InputError

#: Where effects stand whose module does not say it (``ORDER``): last.
_LAST = 1000


def _by_id() -> dict[str, Effect]:
    """The effects of each module of this folder that lists some in ``EFFECTS``, in the order of ``ORDER`` and
    then of names."""
    names = [entry.name for entry in pkgutil.iter_modules(effects.__path__) if entry.name != "catalogue"]
    modules = [importlib.import_module(f"{effects.__name__}.{name}") for name in names]
    catalogue: dict[str, Effect] = {}
    for module in sorted(modules, key=lambda each: (getattr(each, "ORDER", _LAST), each.__name__)):
        for one in getattr(module, "EFFECTS", ()):
            if one.id in catalogue:
                raise ValueError(f"two effects are called {one.id!r}: one of them must have another id")
            catalogue[one.id] = one
    return catalogue


CATALOGUE: Final = MappingProxyType(_by_id())


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
