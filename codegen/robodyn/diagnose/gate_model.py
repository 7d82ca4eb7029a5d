"""Logged torque against the model's: would it fit far better in other units, with another sign or order?

A model that lacks something fits badly too, so a log is refused only where the change makes a torque that was
unlike the model's like it. Friction that the model does not know is left out of the comparison.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from robodyn.diagnose.gate_flag import Flag, Floats, named, refuse
from robodyn.diagnose.gate_likeness import Likeness, Trial, gain_of, likeness
from robodyn.diagnose.gate_smooth import Smooth
from robodyn.robot.model import Robot
from robodyn.robot.values import ZERO
from robodyn.simulate.sensors import measured_position
from robodyn.verify.reference import Reference

#: States that are compared.
STATES = 600
#: A joint is unlike the model from this unexplained share of its torque on, and like it below this one.
UNLIKE, LIKE = 0.7, 0.3
#: What a change must gain to refuse the log, and to be told: factors of what is left unexplained.
REFUSED, TOLD = 8.0, 3.0
#: The share of a torque's variance that friction which drives must make up to show a flipped sign.
DRIVING = 0.05
#: Changes that gain this share of the best one's factor are told with it.
ALIKE = 0.5
#: Positions are too large beyond this multiple of the limits; of these [rad], [m] where there are none.
BEYOND, TURNS, FAR = 1.3, 9.0, 5.0
_FRICTION = {
    "asymmetric_friction", "stribeck_friction", "load_dependent_friction", "presliding_hysteresis",
    "transmission_loss", "viscous_friction", "coulomb_friction",
}  # fmt: skip

Model = Callable[[Floats, Floats, Floats], Floats]


@dataclass(frozen=True, slots=True)
class Change:
    """Another reading: what is wrong if it is right, and the remedy. Positions and their rates are taken in
    the ``order`` and times the ``scale`` [n], torques in the ``tau_order`` and times the ``tau_sign`` [n]."""

    kind: str
    joints: tuple[int, ...]
    where: str
    text: str
    remedy: str
    scale: tuple[float, ...] | None = None
    order: tuple[int, ...] | None = None
    tau_sign: tuple[float, ...] | None = None
    tau_order: tuple[int, ...] | None = None

    def of(self, trial: Trial, model: Model, torque: Floats) -> tuple[Trial, Floats]:
        """The trial in that reading, and the torque of the model for it (``torque``, if its states stay)."""
        tau = trial.tau
        if self.tau_order is not None:
            tau = tau[:, list(self.tau_order)]
        if self.tau_sign is not None:
            tau = tau * np.array(self.tau_sign)
        states = [trial.q, trial.qd, trial.qdd]
        if self.order is not None:
            states = [x[:, list(self.order)] for x in states]
        if self.scale is not None:
            states = [x * np.array(self.scale) for x in states]
        found = Trial(states[0], states[1], states[2], tau)
        if self.order is None and self.scale is None:
            return found, torque
        return found, model(found.q, found.qd, found.qdd)


def check_model(
    smooth: Smooth,
    robot: Robot,
    parameters: Mapping[str, float] | None,
    source: str | None,
    flags: list[Flag],
) -> Floats | None:
    """Flags on units, signs and order that the torques tell; the share of each joint's torque [n] that the
    model and friction leave (see :class:`Likeness`). None: too few samples.

    Raises
    ------
    InputError: another reading of the log agrees with the model, and the log as it stands does not.
    """
    rows = np.flatnonzero(smooth.inside)
    if len(rows) < 50:
        return None
    rows = rows[np.linspace(0, len(rows) - 1, min(STATES, len(rows))).astype(int)]
    offset = measured_position(np.zeros((1, robot.n)), robot.effects, parameters)
    trial = Trial(smooth.q[rows] - offset, smooth.qd[rows], smooth.qdd[rows], smooth.tau[rows])
    model = Reference(_frictionless(robot), parameters).inverse_dynamics
    torque = model(trial.q, trial.qd, trial.qdd)
    found = likeness(trial, torque)

    def changed(changes: Iterator[Change]) -> list[tuple[float, Change, Likeness]]:
        read = ((change, likeness(*change.of(trial, model, torque))) for change in changes)
        return sorted(((gain_of(found, other), change, other) for change, other in read), key=lambda x: -x[0])

    if not (found.unexplained > UNLIKE).any():
        return found.unexplained
    _tell(changed(_units(robot, smooth)), found, source, flags)
    if not _scales(found, torque, trial, flags):
        _tell(changed(_signs_and_order(robot, found)), found, source, flags)
    return found.unexplained


def _frictionless(robot: Robot) -> Robot:
    """``robot`` without friction, which is fitted here: how much there is says nothing of units."""
    links = tuple(replace(k, joint=replace(k.joint, viscous=ZERO, coulomb=ZERO)) for k in robot.links)
    return replace(robot, links=links, effects=tuple(e for e in robot.effects if e.effect not in _FRICTION))


# --- other readings ---------------------------------------------------------------------------------------


def _units(robot: Robot, smooth: Smooth) -> Iterator[Change]:
    """Readings in other units, of positions that are too large for those of SI."""
    revolute = [link.joint.kind == "revolute" for link in robot.links]
    largest = np.abs(smooth.q[smooth.inside]).max(axis=0)
    for kind, text, remedy, factor, of_kind, usual in (
        (
            "degrees",
            "degrees for radians",
            "multiply {} (and the rates) by pi/180",
            math.radians(1),
            True,
            TURNS,
        ),
        ("millimetres", "millimetres for metres", "divide {} (and the rates) by 1000", 1e-3, False, FAR),
    ):
        joints = [j for j in range(robot.n) if revolute[j] == of_kind]
        beyond = []
        for j in joints:
            limits = robot.links[j].joint.limits.position
            end = max(abs(float(x)) for x in limits) if limits else usual
            if largest[j] > BEYOND * end:
                beyond.append(j)
        # All that are of the kind, or one that is beyond alone.
        for some in {tuple(joints), *((j,) for j in beyond)} if beyond else ():
            numbers = tuple(j + 1 for j in some)
            scale = tuple(factor if j in some else 1.0 for j in range(robot.n))
            where = named("q", numbers)
            yield Change(kind, numbers, where, text, remedy.format(where), scale=scale)


def _signs_and_order(robot: Robot, found: Likeness) -> Iterator[Change]:
    """Readings with other signs and in another order."""
    n = robot.n
    unlike = [j for j in range(n) if not found.unexplained[j] < 0.5]
    everyone = tuple(range(1, n + 1))
    minus = tuple(-1.0 for _ in everyone)
    yield Change(
        "sign", everyone, named("tau", everyone), "the sign of all torques is flipped",
        "change the sign of all torques", tau_sign=minus,
    )  # fmt: skip
    for j in everyone:
        one = tuple(-1.0 if k == j else 1.0 for k in everyone)
        if j - 1 in unlike:
            yield Change(
                "sign", (j,), f"tau{j}", "the sign of the torque is flipped", f"change the sign of tau{j}",
                tau_sign=one,
            )  # fmt: skip
        yield Change(
            "sign", (j,), f"q{j}", "the sign of the position is flipped",
            f"change the sign of q{j} and its rates", scale=one,
        )  # fmt: skip
        yield Change(
            "sign", (j,), f"q{j}, tau{j}", "the joint turns the other way than the model's",
            f"change the signs of q{j}, its rates and tau{j}", scale=one, tau_sign=one,
        )  # fmt: skip
    for i in range(n):
        for j in range(i):
            order = list(range(n))
            order[i], order[j] = j, i
            both = (j + 1, i + 1)
            for group, where in (
                ("tau", named("tau", both)),
                ("q", named("q", both)),
                ("all", f"joints {both[0]} and {both[1]}"),
            ):
                yield Change(
                    "order", both, where, "swapped", f"swap the columns {where}"
                    if group != "all"
                    else f"swap all columns of {where}",
                    order=tuple(order) if group != "tau" else None,
                    tau_order=tuple(order) if group != "q" else None,
                )  # fmt: skip


def _tell(
    read: list[tuple[float, Change, Likeness]], before: Likeness, source: str | None, flags: list[Flag]
) -> None:
    """Refuse or flag what another reading explains far better; ``read``: gains, changes, results, best
    first."""
    likely, sure = [], []
    for gain, change, after in read:
        if gain < TOLD or gain < ALIKE * read[0][0]:
            break
        # The joints that the change makes like the model, among those that tell anything.
        became = (before.unexplained > UNLIKE) & (after.unexplained < LIKE)
        spoilt = after.unexplained > np.maximum(2 * before.unexplained, 0.5)
        if not became.any() or spoilt.any():
            continue
        likely.append(change)
        # A spring that is not in the model can outdo gravity at one joint: beside it the sign is right, and
        # friction does not drive. Two joints are in each other's place only if both are better so.
        if change.kind == "sign" and became.sum() == 1:
            clear = bool((before.twisted[became] < -0.5) | (before.driving[became] > DRIVING))
        elif change.kind == "order":
            clear = all(after.unexplained[j - 1] < 0.5 for j in change.joints)
        else:
            clear = True
        if gain > REFUSED and clear:
            sure.append(change)
    if not likely:
        return
    # What is about as likely as the surest is named beside it.
    chosen = [*sure, *(change for change in likely if change not in sure)]
    where = " or ".join(dict.fromkeys(f"{change.where}: {change.text}" for change in chosen))
    after = next(result for _, change, result in read if change is chosen[0])
    better = np.flatnonzero(before.unexplained > np.maximum(2 * after.unexplained, LIKE)).tolist()
    shares = ", ".join(f"{j + 1}: {before.unexplained[j]:.0%} to {after.unexplained[j]:.0%}" for j in better)
    if sure:
        refuse(
            source,
            where,
            found=f"torques unlike the model's; read otherwise, what the model leaves of their variance "
            f"falls (joint {shares})",
            expected="SI units, and the signs and the order of the robot's joints",
            remedy=" or ".join(dict.fromkeys(change.remedy for change in chosen)),
        )
    first = chosen[0]
    text = f"perhaps {where}; read so, the model leaves less (joint {shares})"
    flags.append(Flag(f"perhaps_{first.kind}", first.where, (), text, first.joints))


def _scales(found: Likeness, torque: Floats, trial: Trial, flags: list[Flag]) -> bool:
    """Flags on torques of another size than the model's, and of none of its shape; whether there is one."""
    joints = range(len(found.factor))
    like = [j for j in joints if found.correlation[j] > 0.9]
    off = [j for j in like if not 0.2 < found.factor[j] < 5]
    if len(off) > max(1, len(like) / 2):
        low, high = (float(f(found.factor[off])) for f in (np.min, np.max))
        text = f"{low:.3g} to {high:.3g} times the model's: amperes, or another unit?"
        numbers = tuple(j + 1 for j in off)
        flags.append(Flag("torque_scale", named("tau", numbers), (), text, numbers))
        return True
    size = np.sqrt((torque * torque).mean(axis=0)), np.sqrt((trial.tau * trial.tau).mean(axis=0))
    telling = [j for j in joints if np.isfinite(found.unexplained[j]) and size[0][j] > 0.2 * size[1][j]]
    if telling and all(abs(found.correlation[j]) < 0.3 and found.unexplained[j] > UNLIKE for j in telling):
        numbers = tuple(j + 1 for j in telling)
        text = "nothing of the torque is like the model's: another robot, or another unit?"
        flags.append(Flag("unlike_model", named("tau", numbers), (), text, numbers))
    return False
