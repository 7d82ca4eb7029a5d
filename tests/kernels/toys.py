"""Inputs and parameters of the small arm that stands in conftest.py."""

from __future__ import annotations

from typing import Any

import numpy as np

PARAMS = {"inertia": 0.5, "bend": -1.5}


def states(count: int | None, dtype: Any = np.float64, seed: int = 0) -> Any:
    """Random ``q``, ``qd``, ``qdd``: ``[3, count, 2]``, or ``[3, 2]`` for one state."""
    shape = (3, 2) if count is None else (3, count, 2)
    return np.random.default_rng(seed).normal(size=shape).astype(dtype)
