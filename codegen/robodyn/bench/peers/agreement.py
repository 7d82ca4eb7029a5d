"""A peer is timed only if it gives our torques."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import CheckError

#: What may be between two torques of a state, as a share of the larger of 1 and its largest torque.
TOLERANCE: Final = 1e-9
#: The same for kernels in single precision.
TOLERANCE_FLOAT: Final = 2e-4


class Disagreement(CheckError):
    """A peer gives other torques: whatever it computes, its time says nothing."""


def hold_against(name: str, ours: NDArray[Any], theirs: NDArray[Any], tolerance: float = TOLERANCE) -> float:
    """The largest difference of the torques [N, n] of one and the other, as a share of what it is held to
    (:data:`TOLERANCE`).

    Raises
    ------
    Disagreement: more than ``tolerance``, or a torque that is no number.
    """
    if ours.shape != theirs.shape:
        raise Disagreement(f"{name} gives torques [{theirs.shape}]", expected=f"[{ours.shape}]")
    scale = np.maximum(1.0, np.abs(ours).max(axis=1, keepdims=True))
    error = np.abs(theirs.astype(np.float64) - ours) / scale
    worst = float(np.nan_to_num(error, nan=np.inf).max()) if error.size else 0.0
    if worst > tolerance:
        state, joint = np.unravel_index(int(np.nan_to_num(error, nan=np.inf).argmax()), error.shape)
        raise Disagreement(
            f"{name} gives another torque in state {state}, joint {joint + 1}",
            found=f"{theirs[state, joint]!r}",
            expected=f"{ours[state, joint]!r}, to {tolerance:g} of the largest torque",
            remedy="it is not timed",
        )
    return worst
