"""Bundled arms with effects put on them, for the simulator to be held against what is known of them."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.effects.catalogue import CATALOGUE
from robodyn.logs.log import Log
from robodyn.robot import load
from robodyn.robot.effects import default_of
from robodyn.robot.folding import folded
from robodyn.robot.model import EffectEntry, Robot
from robodyn.simulate.plant import Plant, build_plant

Floats = NDArray[np.float64]
Effects = list[EffectEntry]

#: Steps of which the error is next to rounding.
TIGHT: dict[str, Any] = {"method": "adaptive", "rtol": 1e-12, "atol": 1e-13}


def arm(name: str, *effects: EffectEntry) -> Robot:
    """The bundled robot ``name`` with ``effects``."""
    robot = load(name, warn=lambda _: None)
    return folded(replace(robot, effects=(*robot.effects, *effects)))


def effect(id: str, joint: int | None = None, /, **settings: Any) -> EffectEntry:
    """An entry of the effect ``id``: decimals as they are written, what is left out at its default."""
    defaults = {p.name: default_of(p) for p in CATALOGUE[id].parameters}
    values = {name: value for name, value in defaults.items() if value is not None}
    values.update({name: _exact(given) for name, given in settings.items()})
    return EffectEntry(id, joint, tuple(values.items()))


def _exact(given: Any) -> Any:
    if isinstance(given, tuple):
        return tuple(map(_exact, given))
    return Fraction(str(given)) if isinstance(given, float) else given


def each(robot: Robot, id: str, **settings: Any) -> Effects:
    """The same effect at every joint."""
    return [effect(id, joint, **settings) for joint in range(1, robot.n + 1)]


def rotors(robot: Robot) -> Effects:
    """Of 0.3 kg m^2 or kg, so that nothing moves without inertia."""
    return each(robot, "rotor_inertia", inertia=0.3)


def hung(name: str, *kinds: Callable[[Robot], Effects]) -> Robot:
    """With the effects of the ``kinds``; what slides hangs on a spring, so that it does not fall for ever."""
    bare = arm(name)
    found = [entry for kind in kinds for entry in kind(bare)]
    held = {entry.joint for entry in found if entry.effect == "spring"}
    for j, link in enumerate(bare.links, 1):
        if link.joint.kind == "prismatic" and j not in held:
            found.append(effect("spring", j, stiffness=100.0))
    return arm(name, *found)


def start_of(robot: Robot) -> Floats:
    """A pose [n] without symmetry."""
    return np.linspace(0.3, -0.4, robot.n)


@functools.cache
def plant_of(robot: Robot) -> Plant:
    """``robot`` compiled, once."""
    return build_plant(robot)


#: Time between the samples of :func:`smooth` [s].
STEP = 1e-3


def smooth(samples: int = 400, n: int = 3) -> Log:
    """Smooth true signals, for tests of sensors."""
    t = np.asarray(np.arange(samples) * STEP, dtype=np.float64)
    w = np.arange(1.0, n + 1)
    x = np.multiply.outer(t, w)
    return Log(t, np.sin(x), w * np.cos(x), -w * w * np.sin(x), 10 * np.cos(x))
