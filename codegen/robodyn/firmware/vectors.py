"""Test vectors: states within the joints' limits, their results to 40 digits, and what rounding may change.

The results are those of the program, evaluated with mpmath, and every one of a rigid arm is confirmed by the
torque of :func:`robodyn.verify.exact.exact_torque`, which shares nothing with the program: of the mass matrix
and of forward dynamics what that torque is for the accelerations that they speak of. Positions that belong to
a pose are confirmed by the forward kinematics of :class:`robodyn.verify.reference.Reference`.

Where two branches meet positions lose half their digits, and where a flag or an angle may change by rounding
there is no bound at all. So more poses are drawn than are needed, and those are taken whose results have
proven bounds.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.functions import function_named
from robodyn.dynamics.functions.record import NEAR, POSE, Function, Q
from robodyn.errors import InputError
from robodyn.firmware.digest import DTYPE, VECTOR_SEED, VECTORS, draw, program_inputs, ranges, vector_states
from robodyn.firmware.rounding import TINY, UNIT, rounding_bounds
from robodyn.ir.digits import evaluate_to_digits
from robodyn.ir.program import Input, Program
from robodyn.ir.signature import ScalarType, Signature
from robodyn.optimize.programs import inverse_kinematics_of
from robodyn.robot.model import Robot
from robodyn.robot.values import Value
from robodyn.verify.numbers import exact_value, real
from robodyn.verify.oracles import exact_oracle
from robodyn.verify.reference import Reference

_DIGITS = 40
#: What confirms them.
_BY_TORQUES, _BY_POSES = "exact torques from virtual work", "plain forward kinematics"
#: Digits of a tolerance, which is rounded up.
_UP = 1.0051
#: The smallest normal numbers.
SMALLEST: Mapping[ScalarType, float] = {"float": 2.0**-126, "double": 2.0**-1022}
#: How far program and exact torque may be apart, as a share of the largest term: both are right to about
#: 1e-28 of it.
_AGREED = Fraction(1, 10**24)


class Unconfirmed(AssertionError):
    """An exact torque, or a pose, contradicts the program: a defect of robodyn, never of its input."""


@dataclass(frozen=True, slots=True)
class Vectors:
    """Of one function the results ``expected``, one after another, and the ``tolerance`` of each,
    ``[N, size]``: exact numbers, and bounds of the error of the kernel's; ``confirmed`` by what, if it is."""

    expected: tuple[tuple[Fraction, ...], ...]
    tolerance: NDArray[np.float64]
    confirmed: str = ""


def states_of(
    robot: Robot, interface: Signature, program: Program, parameters: Mapping[str, float]
) -> Mapping[str, NDArray[Any]]:
    """The states that a function is tested at, ``[32, size]`` array by array: within the joints' limits, and
    of a pose such as rounding takes few digits at.

    Raises
    ------
    InputError: there are not so many poses of these.
    """
    if function_named(interface.function).of_pose:
        return well_conditioned(robot, program, parameters, VECTORS, VECTOR_SEED, interface.scalar)
    arrays = [array for array, _ in interface.inputs]
    return vector_states(ranges(robot, arrays, interface.scalar), interface.scalar)


def vectors(
    robot: Robot,
    function: str,
    program: Program,
    states: Mapping[str, NDArray[Any]],
    parameters: Mapping[str, float],
    scalar: ScalarType,
    *,
    spare: Sequence[float] = (),
) -> Vectors:
    """The vectors of ``function`` at ``states``; ``spare`` is what its program may be off the exact torques,
    joint by joint, having been pruned.

    Raises
    ------
    InputError: rounding errors have no bound at some state.
    Unconfirmed: the program and the exact torque, or forward kinematics, disagree.
    """
    inputs = program_inputs(states, parameters)
    bounds = np.concatenate(list(rounding_bounds(program, inputs, scalar).values()), axis=1)
    expected = tuple(
        tuple(x for elements in evaluated(program, inputs, k).values() for x in elements)
        for k in range(len(next(iter(states.values()))))
    )
    size = np.array([[real(abs(x)) for x in row] for row in expected])
    if not bounds.max() <= max(size.max(), TINY[scalar]):
        raise InputError(
            f"rounding may leave no digit of {robot.name}_{function} in {scalar}",
            found=f"errors up to {bounds.max():.1e} at states within the limits",
            remedy="leave that function out of --functions, or use --scalar double",
        )
    confirmed, record = "", function_named(function)
    if record.of_pose:
        confirmed = _BY_POSES
        missed = missed_poses(robot, record, states, parameters, expected)
        if missed:
            raise Unconfirmed(f"{function} of {robot.name} does not lead back to pose {missed[0]}")
    elif not robot.effects and robot.dead_band is None:
        confirmed = _BY_TORQUES
        confirm(robot, function, states, parameters, expected, spare)
    return Vectors(expected, bounds + UNIT[scalar] * size, confirmed)  # the literal is rounded, too


def evaluated(
    program: Program, inputs: Mapping[Input, NDArray[np.float64]], k: int
) -> dict[str, list[Fraction]]:
    """The outputs of ``program`` at state ``k``, to 40 digits.

    Raises
    ------
    ValueError: one of them is no number, or infinite.
    """
    import mpmath

    with mpmath.workdps(_DIGITS):
        state = {name: mpmath.mpf(float(x[k])) for name, x in inputs.items()}
        outputs = evaluate_to_digits(program, state)
        return {array: [_fraction(x) for x in row] for array, row in outputs.items()}


def rounded_up(tolerance: float, smallest: float) -> Fraction:
    """``tolerance`` rounded up to three digits, to a number well above the ``smallest`` normal one."""
    return Fraction(f"{max(tolerance, 2 * smallest) * _UP:.2e}") if tolerance else Fraction(0)


def _fraction(x: Any) -> Fraction:
    import mpmath

    if not mpmath.isfinite(x):
        raise ValueError(f"{x} is no fraction")
    sign, mantissa, exponent, _ = x._mpf_
    size: Fraction = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return -size if sign else size


def confirm(
    robot: Robot,
    function: str,
    states: Mapping[str, NDArray[Any]],
    parameters: Mapping[str, float],
    expected: Sequence[Sequence[Fraction]],
    spare: Sequence[float],
) -> None:
    """Hold every row of ``expected`` against the exact torque, to ``_AGREED`` of the largest term."""
    record = function_named(function)
    rows = np.empty((len(expected), len(expected[0])), object)
    rows[:] = expected
    along = np.tile([Fraction(1, j + 1) for j in range(len(robot.commanded))], (len(rows), 1))
    pairs = exact_oracle(robot, parameters).compared(record, states, rows, along)
    fastest = Fraction(1)
    if record.expected is None:  # then these torques are of what the function gives
        fastest = max(fastest, np.abs(rows).max())
    largest = _largest_term(robot, states, parameters) * fastest
    for one, exact in zip(*pairs, strict=True):
        for j, (x, y) in enumerate(zip(one, exact, strict=True)):
            if abs(x - y) > _AGREED * largest + (Fraction(spare[j]) if spare else 0):
                raise Unconfirmed(f"{function} of {robot.name} differs from the exact torque at element {j}")


def _largest_term(
    robot: Robot, states: Mapping[str, NDArray[Any]], parameters: Mapping[str, float]
) -> Fraction:
    """No term of a torque is larger, but for a small factor: masses, lengths and motions in one product."""

    def total(values: Iterable[Value]) -> Fraction:
        return sum((abs(exact_value(value, parameters)) for value in values), Fraction(0))

    offsets = (x for joint in (link.joint for link in robot.links) for x in (joint.a, joint.b, joint.d))
    length = 1 + total(offsets) + total(x for link in robot.links for x in link.com)
    inertias = ((i.xx, i.yy, i.zz, i.xy, i.xz, i.yz) for i in (link.inertia for link in robot.links))
    drives = ((j.motor_inertia, j.viscous, j.coulomb) for j in (link.joint for link in robot.links))
    body = total(link.mass for link in robot.links) + total(x for row in (*inertias, *drives) for x in row)
    most = {array: Fraction(float(np.abs(x).max())) for array, x in states.items()}
    length += most["q"] if any(link.joint.kind == "prismatic" for link in robot.links) else 0
    motion = 1 + most.get("qd", 0) ** 2 + most.get("qdd", 0) + total(robot.base_gravity)
    return body * length**2 * motion


#: Poses are rounded to multiples of this [1 and m], so that they do not depend on a machine's sines.
_GRID = 2.0**-30
#: How large the bound of an error may be at a pose, as a share of the largest result there.
_WELL_CONDITIONED = 1e-2
#: So many times as many poses are drawn as are wanted.
_DRAWN = 6
#: By how much what is expected may miss a pose, which is rounded, as a share of the largest place or 1 m.
_MISSED = 1e-5


def pose_states(
    robot: Robot, parameters: Mapping[str, float], states: int, seed: int, scalar: ScalarType
) -> dict[str, NDArray[Any]]:
    """``T`` ``[states, 12]``, the tool's frame at positions within the joints' limits, and other positions
    ``q_near`` ``[states, n]``, in the kernel's type; only a redundant joint has the same position in both."""
    drawn = draw(ranges(robot, (Q.name, NEAR.name), scalar), states, seed, scalar)
    q = drawn[Q.name].astype(np.float64)
    near = drawn[NEAR.name]
    redundant = inverse_kinematics_of(robot).redundant
    if redundant is not None:
        near[:, redundant] = drawn[Q.name][:, redundant]
    T = Reference(robot, parameters).tool_pose(q).reshape(states, 12)
    if robot.n not in (4, 5):  # with so many joints no pose on a grid is one that the arm reaches
        T = np.rint(T / _GRID) * _GRID
    return {POSE.name: T.astype(DTYPE[scalar]), NEAR.name: near}


def well_conditioned(
    robot: Robot,
    program: Program,
    parameters: Mapping[str, float],
    states: int,
    seed: int,
    scalar: ScalarType,
) -> dict[str, NDArray[Any]]:
    """The first ``states`` of :func:`pose_states` at which rounding takes few digits of the results of
    ``program``.

    Raises
    ------
    InputError: there are fewer among those that are drawn.
    """
    drawn = pose_states(robot, parameters, _DRAWN * states, seed, scalar)
    bounds = rounding_bounds(program, program_inputs(drawn, parameters), scalar)
    largest = np.concatenate(list(bounds.values()), axis=1).max(axis=1)
    (sound,) = np.nonzero(largest <= _WELL_CONDITIONED)
    if len(sound) < states:
        raise InputError(
            f"rounding may leave no digit of {robot.name}'s inverse kinematics in {scalar}",
            found=f"bounds of its error at {len(sound)} of {_DRAWN * states} poses within the limits",
            expected=f"{states} at least, to test it with",
            remedy="leave that function out of --functions, or use --scalar double",
        )
    return {array: x[sound[:states]] for array, x in drawn.items()}


def missed_poses(
    robot: Robot,
    function: Function,
    states: Mapping[str, NDArray[Any]],
    parameters: Mapping[str, float],
    expected: Sequence[Sequence[Any]],
) -> list[int]:
    """At which of ``states`` the results ``expected`` ``[N, size]`` of ``function`` do not lead back to the
    pose by plain forward kinematics, or no branch exists."""
    T = states[POSE.name].astype(np.float64)
    counted = [3, 7, 11] if inverse_kinematics_of(robot).place_only else list(range(12))
    allowed = _MISSED * (1 + np.abs(T[:, 3::4]).max())
    missed = np.zeros(len(T), bool)
    rows = [dict(function.split(row, robot.n)) for row in expected]
    for part in function.fuses or (function,):
        assert part.answers is not None
        solutions, exists = (
            np.array([row[name] for row in rows], float)
            for name in (part.answers.solutions, part.answers.exists)
        )
        q = solutions.reshape(-1, robot.n)
        poses = Reference(robot, parameters).tool_pose(q).reshape(*exists.shape, 12)
        off = np.abs(poses - T[:, None, :])[:, :, counted].max(axis=2)
        missed |= ~(exists == 1).any(axis=1) | ((exists == 1) & (off > allowed)).any(axis=1)
    return [int(k) for k in np.nonzero(missed)[0]]
