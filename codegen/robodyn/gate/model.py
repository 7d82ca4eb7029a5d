"""Logged torque against the model's: would it fit far better in other units, signs, zeros, gains or order?

One comparison of readings decides (:mod:`robodyn.gate.comparison`). Order, sign and unit are refused with
the map that mends them; zeros, gains, lateness, torques without gravity and numbers far from the
description's are flagged.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.gate import limits
from robodyn.gate.arm_fit import ArmFit, States
from robodyn.gate.comparison import Comparison, Trial
from robodyn.gate.flag import Flag, motions, named, refuse
from robodyn.gate.smooth import Smooth
from robodyn.robot.model import Robot
from robodyn.simulate.sensors import measured_position

_ANOTHER: Final = "see whether the log is of another robot or run, and in SI units"


def check_model(
    smooth: Smooth,
    moving: NDArray[np.bool_],
    period: float,
    robot: Robot,
    flags: list[Flag],
    *,
    is_one_of_many: bool = False,
) -> None:
    """Flags on units, signs, order, zeros, gains and lateness that torques tell. Nothing is said where the
    arm is ``moving`` [K] in too few samples, or too little: what stiction and somebody's hand do to a resting
    arm says nothing of signs. A log that ``is_one_of_many`` is read otherwise only where it is not like the
    model at all: ten times as quick, and what is slightly odd shows beside the others.

    Raises
    ------
    InputError: another reading of the log agrees with the model, and the log as it stands does not.
    """
    rows = np.flatnonzero(smooth.inside & moving)
    if (
        len(rows) < 10 * limits.BLOCKS
        or not (np.ptp(smooth.q[rows], axis=0) > motions(robot, limits.LEAST_ANGLE)).any()
    ):
        return
    count = min(limits.COMPARED_STATES, len(rows) // limits.BLOCKS * limits.BLOCKS)
    rows = rows[np.linspace(0, len(rows) - 1, count).astype(int)]
    offset = measured_position(np.zeros((1, robot.n)), robot.effects)

    def torque(late: float) -> Floats:
        places = np.clip(rows + late / period, 0, len(smooth.tau) - 1.001)
        first, share = places.astype(int), (places % 1)[:, None]
        return np.asarray((1 - share) * smooth.tau[first] + share * smooth.tau[first + 1])

    states = States(smooth.q[rows] - offset, smooth.qd[rows], smooth.qdd[rows], smooth.way[rows], torque)
    comparison = Comparison(ArmFit(robot, states), robot, np.abs(smooth.q[smooth.inside]).max(axis=0))
    _refuse_constant(smooth.tau[smooth.inside], comparison.base.table.model.T)
    own, model, unlike = comparison.beside_friction()
    _refuse_units(own, model)
    if is_one_of_many and not (unlike > limits.UNLIKE).any():
        return
    for _ in range(robot.n):  # one after the other, as torques in other units that lack gravity too
        better = comparison.better()
        if not better:
            break
        best = _chosen(better)
        one = best.reading
        read_so = Comparison(comparison.arm, robot, comparison.largest, one)
        if one.remedy:
            _refuse_unlike(read_so)
            _tell(best, comparison.base, better)
        flags[:] = [flag for flag in flags if (flag.kind, flag.where) != (one.kind, one.where)]
        flags.append(Flag(one.kind, one.where, (), one.text, one.joints))
        comparison = read_so
    _compare_shapes(comparison.beside_friction()[2], flags)


def _chosen(better: list[Trial]) -> Trial:
    """Of what is about as likely as the best: another mounting, which a zero half a turn off may look like;
    what has another name before the description is blamed; of gains that of the fewest joints."""
    alike = [one for one in better if one.gain > limits.ALIKE_GAIN * better[0].gain]
    mounted = [one for one in alike if one.reading.down]
    if mounted:
        return mounted[0]
    # A clock is like inertias that are all far off.
    alike = [one for one in alike if one.reading.kind != "clock" or one is better[0]]
    alike = [one for one in alike if one.reading.looseness < limits.LOOSENED] or alike
    same = [one for one in alike if one.reading.kind == alike[0].reading.kind]
    return alike[0] if alike[0].reading.remedy else min(same, key=lambda one: len(one.reading.joints))


def _tell(best: Trial, base: Trial, better: list[Trial]) -> None:
    """Refuse what is in another order, unit or sign; what explains torques about as well is named beside."""
    likely = [one.reading for one in better if one.gain > limits.ALIKE_GAIN * best.gain]
    alike = [
        best.reading,
        *(one for one in likely if one.remedy or (best.reading.down and one.kind == "zero")),
    ]
    was, now = (one.reading.by_channel(np.sqrt(one.fit.variance) / one.table.factor) for one in (base, best))
    joints = np.flatnonzero(was > limits.LEAST_RELIEF * now).tolist() or [int(np.argmax(was / now))]
    shares = ", ".join(f"{j + 1}: {was[j]:.2g} to {now[j]:.2g}" for j in joints)
    refuse(
        " or ".join(dict.fromkeys(f"{one.where}: {one.text}" for one in alike)),
        found="torques unlike the model's; read otherwise, what the model leaves of them falls (RMS of "
        f"joint {shares} N m or N)",
        expected="SI units, the signs and the order of the robot's joints, and the arm as it is mounted",
        remedy=" or ".join(dict.fromkeys(one.remedy for one in alike if one.remedy)),
    )


def _refuse_unlike(best: Comparison) -> None:
    """Refuse a log with a joint that is unlike the model in the best of its readings too: that one mends
    nothing."""
    share = np.nan_to_num(best.beside_friction()[2])
    worst, one = int(np.argmax(share)), best.base.reading
    if share[worst] > limits.UNLIKE:
        refuse(
            f"tau{worst + 1}: unlike the model's torque, however the log is read",
            found=f"the best other reading ({one.where}: {one.text}) leaves {share[worst]:.0%} of its "
            "variance beside friction",
            expected="torques of this robot in this motion",
            remedy=_ANOTHER,
        )


def _refuse_units(tau: Floats, torque: Floats) -> None:
    """Refuse torques [n, K] of the shape of the model's ``torque`` and of another size: masses that are
    little known explain them too, but not all of an arm's."""
    factors = {}
    for j, (own, model) in enumerate(zip(tau, torque, strict=True)):
        size, product = float(model @ model), float(own @ model)
        if product > 0 and product**2 > limits.UNLIKE * size * float(own @ own):
            factors[j + 1] = product / size
    low, high = min(factors.values(), default=1.0), max(factors.values(), default=1.0)
    if len(factors) < 2 or not (low > limits.MOST_SCALE or high < 1 / limits.MOST_SCALE):
        return
    remedy = "write N m (N) at the joint: a motor's current times its torque constant and the gear ratio"
    for factor, what in ((1e3, "divide by 1000: N mm or mN m for N m"), (1e-3, "multiply by 1000: kN m")):
        if low / factor > 0.5 and high / factor < 2:
            remedy = what
    refuse(
        f"{named('tau', list(factors))}: another unit than N m (N)",
        found=f"{low:.3g} to {high:.3g} times the model's torques, and of their shape",
        expected=f"{1 / limits.MOST_SCALE:g} to {limits.MOST_SCALE:g} times them, whatever the model lacks",
        remedy=remedy,
    )


def _refuse_constant(tau: Floats, torque: Floats) -> None:
    """Refuse torques [K, n] that never change where the model's do, or by a billionth of that: gain and bias
    would be named for them."""
    spread = np.ptp(torque, axis=0)
    same = np.ptp(tau, axis=0) <= 1e-9 * np.maximum(np.abs(tau).max(axis=0), spread)
    joints = np.flatnonzero(same & (spread > 1e-6 * spread.max())).tolist()
    if joints:
        refuse(
            f"{named('tau', [j + 1 for j in joints])}: the same throughout",
            found=f"{tau[0, joints[0]]:.6g} in all rows, while the model's torque changes by "
            f"{spread[joints[0]]:.3g}",
            expected="the torque of every joint as it was",
            remedy="record the torques of all joints",
        )


def _compare_shapes(unlike: Floats, flags: list[Flag]) -> None:
    """Refuse torques of which nothing is of the model's shape; only a flag where one joint alone tells."""
    telling = np.flatnonzero(np.isfinite(unlike)).tolist()
    if not telling or (unlike[telling] <= limits.UNLIKE).any():
        return
    where = named("tau", [j + 1 for j in telling])
    if len(telling) > 1:
        refuse(
            f"{where}: nothing of the torque is like the model's",
            found=f"the arm leaves {min(unlike[telling]):.0%} or more of the variance beside friction",
            expected="torques of this robot in this motion",
            remedy=_ANOTHER,
        )
    text = "nothing of the torque is like the model's: another robot, or another unit?"
    flags.append(Flag("unlike_model", where, (), text, (telling[0] + 1,)))
