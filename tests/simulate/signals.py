"""Smooth true signals, and entries of effects, for tests of sensors."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from robodyn.logs.log import Log
from robodyn.robot.model import EffectEntry

STEP = 1e-3


def entry(kind: str, joint: int | None = None, **settings: Any) -> EffectEntry:
    """An effect's entry; numbers become the exact ones of a robot file."""
    exact = {k: Fraction(str(v)) if isinstance(v, (int, float)) else v for k, v in settings.items()}
    return EffectEntry(kind, joint, tuple(exact.items()))


def smooth(samples: int = 400, n: int = 3) -> Log:
    t = np.asarray(np.arange(samples) * STEP, dtype=np.float64)
    w = np.arange(1.0, n + 1)
    x = np.multiply.outer(t, w)
    return Log(t, np.sin(x), w * np.cos(x), -w * w * np.sin(x), 10 * np.cos(x))
