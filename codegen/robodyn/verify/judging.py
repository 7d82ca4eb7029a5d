"""Errors beside their yardsticks, and states at which there is none."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.dynamics.functions import Function
from robodyn.robot.model import Robot
from robodyn.verify.numbers import real

#: Share of what is added up, in double, that is nothing but rounding.
_ROUNDING = 64 * 2.0**-52


def relative_to(error: Floats, yardstick: Floats) -> Floats:
    """``error / yardstick``; infinite where the yardstick is, or is 0 and the error is not."""
    relative: Floats = np.divide(error, yardstick, out=np.full(error.shape, np.inf), where=yardstick > 0)
    relative[(yardstick == 0) & (error == 0)] = 0.0
    relative[~np.isfinite(yardstick)] = np.inf
    return relative


def beside_terms(largest: list[float], robot: Robot, qd: Floats) -> list[float]:
    """The ``largest`` of elements that are places or motion; where one is no more than the rounding of what
    lengths and rates ``qd`` ``[N, n]`` add up to, that sum: nothing else is left of what cancels."""
    joints = [link.joint for link in robot.links]
    lengths = sum(abs(float(x)) for j in joints for x in (j.a, j.b, j.d) if isinstance(x, Fraction))
    terms = (1 + lengths) * max(1.0, float(np.abs(qd).max()) ** 2)
    return [x if x > _ROUNDING * terms else terms for x in largest]


def is_regular(matrix: Floats, dtype: np.dtype[Any]) -> NDArray[np.bool_]:
    """At which states ``[N]`` the mass matrix can be inverted in ``dtype``."""
    diagonal = np.einsum("kii->ki", matrix)
    fit = (diagonal > 0).all(axis=1)
    scale = 1 / np.sqrt(np.where(diagonal > 0, diagonal, 1.0))
    scaled = matrix * scale[:, :, None] * scale[:, None, :]
    fit &= np.isfinite(scaled).all(axis=(1, 2))
    try:
        condition = np.linalg.cond(np.where(fit[:, None, None], scaled, 0.0))
    except np.linalg.LinAlgError:
        return np.zeros(len(matrix), np.bool_)
    return np.asarray(fit & (condition < 0.01 / float(np.finfo(dtype).eps)))


def ulps_of(
    function: Function,
    error: Floats,
    expected: NDArray[Any],
    yardstick: float | Floats,
    dtype: np.dtype[Any],
) -> float:
    """The largest error in units in the last place of each joint's largest torque, or of the yardstick of
    what are no torques."""
    sizes = np.reshape([real(abs(x)) for x in expected.flat], expected.shape)
    most = np.broadcast_to(yardstick, sizes.shape[1:])
    vectors = all(array.shape == ("n",) for array in function.results)
    unit = sizes.max(axis=0) if vectors else most
    unit = np.where(unit > 0, unit, np.where(most > 0, most, 1.0))
    worst = float((error / np.spacing(unit.astype(dtype)).astype(np.float64)).max())
    return np.inf if np.isnan(worst) else worst
