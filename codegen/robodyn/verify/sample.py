"""States to compare at, the same for the same seed."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.dynamics.functions.record import PI
from robodyn.errors import InputError
from robodyn.ir.signature import Signature
from robodyn.robot.filling import parameter_values
from robodyn.robot.model import Joint, Robot
from robodyn.verify.numbers import Parameters, real
from robodyn.verify.reference import Reference

# However wide the limits are: an angle of many turns loses the digits of its offset, and what is squared must
# stay a number.
_FARTHEST = (Fraction(10**3), Fraction(10**6), Fraction(10**6))  # q, qd, qdd
_REST = 4  # how many states of a sample have joints at rest


@dataclass(frozen=True, slots=True)
class Sample:
    """States ``[N, n]``: rad or m, and per second. Every number is one of the kernel's own type."""

    q: Floats
    qd: Floats
    qdd: Floats

    def __len__(self) -> int:
        return len(self.q)


def draw(robot: Robot, states: int, seed: int, dtype: np.dtype[Any]) -> Sample:
    """``states`` random states within the joints' limits.

    Where a limit is not stated, q is within pi or 0.5 m, qd within 3, qdd within 10 (SI). Of limits that are
    very wide only the middle is used: q within 1e3, qd and qdd within 1e6, as far as the limits allow it. Of
    twenty states or more the last four are at rest, where friction and terms that multiply a velocity show
    themselves: nothing moves; likewise with q = 0; nothing moves but accelerates; steady motion.

    Raises
    ------
    InputError: less than one state.
    """
    if states < 1:
        raise InputError("there is nothing to compare", found=f"{states} states", expected="one or more")
    rng = np.random.default_rng(seed)
    bounds = np.array([bounds_of(robot.links[joint].joint) for joint in robot.commanded])  # [n, 3, 2]
    low, high = bounds[:, :, 0], bounds[:, :, 1]
    drawn = low + (high - low) * rng.random((states, len(robot.commanded), 3))
    if states >= 5 * _REST:
        drawn[-4, :, 2] = 0.0
        drawn[-3, :, 1] = 0.0
        drawn[-2, :, 1:] = 0.0
        drawn[-1] = 0.0
    rounded = drawn.astype(dtype).astype(np.float64)
    q, qd, qdd = (np.ascontiguousarray(rounded[:, :, k]) for k in range(3))
    return Sample(q, qd, qdd)


def draw_parameters(
    robot: Robot, parameters: Parameters | None, seed: int, dtype: np.dtype[Any]
) -> dict[str, float]:
    """Values of the run-time parameters in the kernel's type: those given, else random in 0.1 .. 1 (SI).

    Raises
    ------
    InputError: some are given and others are not, one is unknown, or a value is not allowed.
    """
    if parameters:
        values = parameter_values(robot, parameters)
    else:
        rng = np.random.default_rng([seed, 1])
        values = {name: float(rng.uniform(0.1, 1.0)) for name in robot.parameters}
    return {name: float(dtype.type(values[name])) for name in robot.parameters}


def bounds_of(joint: Joint) -> list[tuple[float, float]]:
    """Lower and upper bounds of q, qd and qdd that :func:`draw` keeps to."""
    limits = joint.limits
    reach = Fraction(0.5 if joint.kind == "prismatic" else math.pi)
    speed = Fraction(3) if limits.velocity is None else limits.velocity
    rate = Fraction(10) if limits.acceleration is None else limits.acceleration
    stated = (limits.position or (-reach, reach), (-speed, speed), (-rate, rate))
    return [
        (real(max(low, min(high, -far))), real(min(high, max(low, far))))
        for (low, high), far in zip(stated, _FARTHEST, strict=True)
    ]


#: How hard tools are pushed [N, N m].
_PUSH = 10.0


#: How many poses of a sample are out of the reach of an arm of revolute joints.
UNREACHABLE = 3


def poses_of(reference: Reference, q: Floats, dtype: np.dtype[Any]) -> Floats:
    """Poses ``[N, 12]`` of the tool at the positions ``q`` ``[N, n]``, in ``dtype``; of twenty or more the
    first :data:`UNREACHABLE` are moved away, further than all poses are from each other."""
    T = reference.tool_pose(q).reshape(len(q), 12)
    if len(T) >= 20:
        places = T[:, 3::4]
        T[:UNREACHABLE, 3::4] += 10 * (1 + np.abs(places - places.mean(axis=0)).max())
    return T.astype(dtype).astype(np.float64)


def is_reachable(states: int) -> NDArray[np.bool_]:
    """Which of so many :func:`poses_of` are those of positions."""
    return np.arange(states) >= (UNREACHABLE if states >= 20 else 0)


def drawn_besides(
    signatures: Iterable[Signature], states: int, seed: int, dtype: np.dtype[Any]
) -> tuple[Floats, Floats]:
    """Wrenches ``[states, 6]`` and as many base parameters as the kernels take, in ``dtype``."""
    p = max((size for s in signatures for name, size in s.inputs if name == PI.name), default=0)
    wrench = np.random.default_rng([seed, 3]).uniform(-_PUSH, _PUSH, (states, 6))
    pi = np.random.default_rng([seed, 4]).uniform(0.5, 1.5, (states, p))
    return wrench.astype(dtype).astype(np.float64), pi.astype(dtype).astype(np.float64)
