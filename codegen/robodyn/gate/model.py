"""Logged torque against the model's: would it fit far better in other units, with another sign or order?

A model that lacks something fits badly too, so a log is refused only where the change makes a torque that was
unlike the model's like it, or leaves next to nothing of a difference: no effect looks like another joint's
column. Friction that the model does not know is left out of the comparison.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from robodyn.gate.flag import Flag, Floats, count, named, refuse
from robodyn.gate.likeness import Likeness, Trial, gain_of, likeness
from robodyn.gate.limits import (
    ALIKE_GAIN,
    COMPARED_STATES,
    DRIVING_SHARE,
    FEWEST_MOVING,
    FLAGGED_GAIN,
    KNOWN_UNIT,
    LEAST_ANGLE,
    LEAST_SCALE,
    LEAST_WAY,
    LIKE,
    MOST_SCALE,
    NEARER,
    NEARER_EXACT,
    REFUSED_GAIN,
    REVERSED_SHARE,
    SLIGHT,
    SLIGHT_EXACT,
    SPRUNG_FACTOR,
    SURE_GAIN,
    UNLIKE,
    WORSE,
    WORSE_EXACT,
    WORSE_FACTOR,
)
from robodyn.gate.readings import Change, reversed_order, signs_and_order, units
from robodyn.gate.smooth import Smooth
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.model import EffectEntry, Robot
from robodyn.robot.values import ZERO
from robodyn.simulate.sensors import measured_position


def check_model(
    smooth: Smooth,
    moving: NDArray[np.bool_],
    robot: Robot,
    parameters: Mapping[str, float] | None,
    source: str | None,
    flags: list[Flag],
    *,
    is_one_of_many: bool = False,
) -> Floats | None:
    """Flags on units, signs and order that the torques tell; the share of each joint's torque [n] that the
    model and friction leave (see :class:`Likeness`). None: too few samples at which the arm is ``moving``
    [K], or too little motion: what stiction and somebody's hand do to a resting arm says nothing of signs.
    A log that ``is_one_of_many`` is read otherwise only where it is not like the model at all: ten times as
    quick, and what is slightly odd shows beside the others.

    Raises
    ------
    InputError: another reading of the log agrees with the model, and the log as it stands does not.
    """
    rows = np.flatnonzero(smooth.inside & moving)
    if len(rows) < FEWEST_MOVING or not (np.ptp(smooth.q[rows], axis=0) > least_way(robot)).any():
        return None
    rows = rows[np.linspace(0, len(rows) - 1, min(COMPARED_STATES, len(rows))).astype(int)]
    offset = measured_position(np.zeros((1, robot.n)), robot.effects, parameters)
    trial = Trial(smooth.q[rows] - offset, smooth.qd[rows], smooth.qdd[rows], smooth.tau[rows])
    model = Model(_frictionless(robot), parameters).torque
    torque = model(trial.q, trial.qd, trial.qdd)
    _constant(smooth.tau[smooth.inside], torque, source)
    fit = likeness(trial, torque)

    def changed(changes: Iterator[Change]) -> list[tuple[float, Change, Likeness]]:
        read = ((change, likeness(*change.of(trial, model, torque))) for change in changes)
        return sorted(((gain_of(fit, other), change, other) for change, other in read), key=lambda x: -x[0])

    if not (fit.apart > SLIGHT_EXACT).any():
        return fit.unexplained
    if is_one_of_many and not (fit.unexplained > UNLIKE).any():
        return fit.unexplained
    if (fit.unexplained > UNLIKE).any():
        _tell(changed(units(robot, smooth)), fit, source, flags)
    _reversed(changed(reversed_order(robot)), fit, source)
    _scales(fit, source)
    _tell(changed(signs_and_order(robot, fit)), fit, source, flags)
    _unlike(fit, torque, trial, source, flags)
    return fit.unexplained


def least_way(robot: Robot) -> Floats:
    """How far [n] a joint must go for its motion to say something."""
    return np.array([LEAST_ANGLE if k.joint.kind == "revolute" else LEAST_WAY for k in robot.links])


def _rubs(entry: EffectEntry) -> bool:
    return entry.definition.dissipative and entry.definition.level == "joint"


def _frictionless(robot: Robot) -> Robot:
    """``robot`` without friction, which is fitted here: how much there is says nothing of units."""
    links = tuple(replace(k, joint=replace(k.joint, viscous=ZERO, coulomb=ZERO)) for k in robot.links)
    return replace(robot, links=links, effects=tuple(e for e in robot.effects if not _rubs(e)))


def _tell(
    read: list[tuple[float, Change, Likeness]], before: Likeness, source: str | None, flags: list[Flag]
) -> None:
    """Refuse or flag what another reading explains far better; ``read``: gains, changes, results, best
    first."""
    likely, sure = [], []
    for gain, change, after in read:
        if gain < FLAGGED_GAIN or gain < ALIKE_GAIN * read[0][0]:
            break
        # The joints that the change makes like the model, among those that tell anything.
        became = _nearer(before, after, change)
        if became is None:
            continue
        likely.append(change)
        # A spring that is not in the model can outdo gravity at one joint: beside it the sign is right,
        # friction does not drive, and the other joints are as they were. Two joints are in
        # each other's place only if both are better so.
        if change.kind == "sign" and became.sum() == 1:
            clear = bool(
                (before.twisted[became] < -0.5)
                | (before.driving[became] > DRIVING_SHARE)
                | (before.sprung[became] > SPRUNG_FACTOR * after.sprung[became])
                | _elsewhere(before, after, change)
            )
        elif change.kind == "order":
            clear = gain > SURE_GAIN or all(after.unexplained[j - 1] < 0.5 for j in change.joints)
        else:
            clear = True
        if gain > REFUSED_GAIN and clear:
            sure.append(change)
    if not likely:
        return
    # What is about as likely as the surest is named beside it.
    chosen = [*sure, *(change for change in likely if change not in sure)]
    where = " or ".join(dict.fromkeys(f"{change.where}: {change.text}" for change in chosen))
    after = next(result for _, change, result in read if change is chosen[0])
    was, now = before.unexplained, after.unexplained
    if not (was > np.maximum(2 * now, SLIGHT)).any():
        was, now = before.apart, after.apart
    better = np.flatnonzero(was > np.maximum(2 * now, SLIGHT_EXACT)).tolist()
    shares = ", ".join(f"{j + 1}: {was[j]:.2g} to {now[j]:.2g}" for j in better)
    if sure:
        refuse(
            source,
            where,
            found=f"torques unlike the model's; read otherwise, the share of their variance that the model "
            f"leaves falls (joint {shares})",
            expected="SI units, and the signs and the order of the robot's joints",
            remedy=" or ".join(dict.fromkeys(change.remedy for change in chosen)),
        )
    first = chosen[0]
    text = f"perhaps {where}; read so, the model leaves less (joint {shares})"
    flags.append(Flag(f"perhaps_{first.kind}", first.where, (), text, first.joints))


def _reversed(read: list[tuple[float, Change, Likeness]], before: Likeness, source: str | None) -> None:
    """Refuse a log in which the joints are numbered from the tip: nearly all are far nearer read so."""
    for gain, change, after in read:
        telling = np.isfinite(before.unexplained) & np.isfinite(after.unexplained)
        nearer = telling & (after.unexplained < REVERSED_SHARE * before.unexplained)
        if gain > SURE_GAIN and nearer.sum() > 0.5 * len(telling) and nearer.sum() > 1:
            refuse(
                source,
                f"{change.where}: {change.text}",
                found=f"torques unlike the model's at {count(int(nearer.sum()), 'joint')}, and like it "
                "counted from the tip",
                expected="joints numbered from the base",
                remedy=change.remedy,
            )


def _nearer(before: Likeness, after: Likeness, change: Change) -> NDArray[np.bool_] | None:
    """The joints [n] where a ``change`` makes a log that is not the model's like it; None: it does not."""
    was, now = before.unexplained, after.unexplained
    became = (was > UNLIKE) & (now < LIKE)
    if became.any() and not (now > np.maximum(2 * was, 0.5)).any():
        return became
    # Two joints are in each other's place only if both are nearer so.
    own = [j - 1 for j in change.joints] if change.kind == "order" else []
    for was, now, slight, times, worse in (
        (before.unexplained, after.unexplained, SLIGHT, NEARER, WORSE),
        (before.apart, after.apart, SLIGHT_EXACT, NEARER_EXACT, WORSE_EXACT),
    ):
        near = (was > slight) & (was > times * now)
        if near.any() and near[own].all() and not (now > np.maximum(WORSE_FACTOR * was, worse)).any():
            return near
    return None


def _constant(tau: Floats, torque: Floats, source: str | None) -> None:
    """Refuse torques [K, n] that never change where the model's do, or by a billionth of that: gain and bias
    would be named for them."""
    spread = np.ptp(torque, axis=0)
    same = np.ptp(tau, axis=0) <= 1e-9 * np.maximum(np.abs(tau).max(axis=0), spread)
    joints = np.flatnonzero(same & (spread > 1e-6 * spread.max())).tolist()
    if joints:
        refuse(
            source,
            f"{named('tau', [j + 1 for j in joints])}: the same throughout",
            found=f"{tau[0, joints[0]]:.6g} in all rows, while the model's torque changes by "
            f"{spread[joints[0]]:.3g}",
            expected="the torque of every joint as it was",
            remedy="record the torques of all joints",
        )


def _elsewhere(before: Likeness, after: Likeness, change: Change) -> bool:
    """Whether another joint than those of a ``change`` is far nearer to the model too."""
    near = (before.apart > SLIGHT_EXACT) & (before.apart > NEARER_EXACT * after.apart)
    return any(near[j] for j in range(len(near)) if j + 1 not in change.joints)


def _scales(fit: Likeness, source: str | None) -> None:
    """Refuse torques of the model's shape and of another size: a fit would name gains, errors of inertia."""
    like = [j for j in range(len(fit.factor)) if fit.correlation[j] > 0.9]
    off = [j for j in like if not LEAST_SCALE < fit.factor[j] < MOST_SCALE]
    if len(off) <= max(1, len(like) / 2):
        return
    low, high = (float(f(fit.factor[off])) for f in (np.min, np.max))
    remedy = "write N m (N) at the joint: a motor's current times its torque constant and the gear ratio"
    for factor, what in ((1e3, "divide by 1000: N mm or mN m for N m"), (1e-3, "multiply by 1000: kN m")):
        if abs(low / factor - 1) < KNOWN_UNIT and abs(high / factor - 1) < KNOWN_UNIT:
            remedy = what
    refuse(
        source,
        f"{named('tau', [j + 1 for j in off])}: another unit than N m (N)",
        found=f"{low:.3g} to {high:.3g} times the model's torques, and of their shape",
        expected=f"{LEAST_SCALE:g} to {MOST_SCALE:g} times them, whatever the model lacks",
        remedy=remedy,
    )


def _unlike(fit: Likeness, torque: Floats, trial: Trial, source: str | None, flags: list[Flag]) -> None:
    """Refuse torques of which nothing is of the model's shape; only a flag where one joint alone tells."""
    joints = range(len(fit.factor))
    # Not their means: what does not change says nothing.
    size = torque.std(axis=0), trial.tau.std(axis=0)
    telling = [j for j in joints if np.isfinite(fit.unexplained[j]) and size[0][j] > 0.2 * size[1][j]]
    if any(abs(fit.correlation[j]) >= 0.3 or fit.unexplained[j] <= UNLIKE for j in telling):
        return
    where = named("tau", [j + 1 for j in telling])
    if len(telling) > 1:
        refuse(
            source,
            f"{where}: nothing of the torque is like the model's",
            found=f"correlations of {min(fit.correlation[telling]):.2f} to "
            f"{max(fit.correlation[telling]):.2f}, beside friction and a bias",
            expected="torques of this robot in this motion",
            remedy="see whether the log is of another robot or run, and in SI units",
        )
    if telling:
        text = "nothing of the torque is like the model's: another robot, or another unit?"
        flags.append(Flag("unlike_model", where, (), text, (telling[0] + 1,)))
