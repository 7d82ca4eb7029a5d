"""What comes back from a run of the simulation engine."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

#: What a run ended with, by the engine's own number.
STATUSES = ("done", "not finite", "no acceleration", "too many steps", "step too small", "interrupted")


@dataclass(frozen=True, slots=True)
class Record:
    """What a run gave at its S samples, as far as it came; SI units.

    A sample at an instant of the control is taken after it: ``a``, ``s`` and the torques are those from
    there on.
    """

    t: Floats
    """[S]"""
    y: Floats
    """[S, n] coordinates"""
    v: Floats
    """[S, n] velocities"""
    a: Floats
    """[S, n] accelerations"""
    z: Floats
    """[S, k] internal states"""
    s: Floats
    """[S, elements] directions of the dry friction: -1 or 1 sliding, 0 stuck"""
    command: Floats
    """[S, motors] torques as commanded"""
    applied: Floats
    """[S, motors] torques as the drives gave them"""
    work: Floats
    """[S] done by the torques [J]; 0 unless the system's ``conserved`` is given"""
    loss: Floats
    """[S] lost to what ``conserved`` leaves out [J]"""
    status: str
    """One of :data:`STATUSES`"""
    time: float
    """Where the run ended [s]"""
    counters: Mapping[str, int]
    """steps, rejected, evaluations of the acceleration, events, iterations of Newton's method"""
