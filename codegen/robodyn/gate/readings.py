"""Other readings of a log: in other units, with other signs, in another order of the joints."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from robodyn.gate.flag import Floats, named
from robodyn.gate.likeness import Likeness, Trial
from robodyn.gate.limits import BEYOND_LIMITS, FAR, TURNS
from robodyn.gate.smooth import Smooth
from robodyn.robot.model import Robot

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
        changed = Trial(states[0], states[1], states[2], tau)
        if self.order is None and self.scale is None:
            return changed, torque
        return changed, model(changed.q, changed.qd, changed.qdd)


def units(robot: Robot, smooth: Smooth) -> Iterator[Change]:
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
            if largest[j] > BEYOND_LIMITS * end:
                beyond.append(j)
        # All that are of the kind, or one that is beyond alone.
        for some in {tuple(joints), *((j,) for j in beyond)} if beyond else ():
            numbers = tuple(j + 1 for j in some)
            scale = tuple(factor if j in some else 1.0 for j in range(robot.n))
            where = named("q", numbers)
            yield Change(kind, numbers, where, text, remedy.format(where), scale=scale)


def reversed_order(robot: Robot) -> Iterator[Change]:
    """The reading in which the joints are numbered from the tip."""
    order = tuple(range(robot.n - 1, -1, -1))
    if robot.n > 3:  # of three, it is two that are swapped
        yield Change(
            "reversed", tuple(j + 1 for j in order), "q, tau", "the joints are in the reverse order",
            f"number them from the base{_map(q=order, tau=order)}", order=order, tau_order=order,
        )  # fmt: skip


def _map(**groups: tuple[float, ...]) -> str:
    """How a map of columns (--map) says so: signs, which are +-1 and floats, or the order, which are ints."""
    lines = []
    for group, values in groups.items():
        if all(isinstance(x, int) for x in values):
            columns = ", ".join(f"{group}{int(j) + 1}" for j in values)
            lines.append(f"{group}: {{columns: [{columns}]}}")
        else:
            lines.append(f"{group}: {{columns: {group}%d, sign: [{', '.join(f'{x:g}' for x in values)}]}}")
    return f" (with --map, in a file: {' and '.join(lines)})"


def _exchange(group: str, where: str, order: tuple[int, ...]) -> str:
    if group == "all":
        return f"swap all columns of {where}{_map(q=order, tau=order)}"
    return f"swap the columns {where}{_map(**{group: order})}"


def signs_and_order(robot: Robot, fit: Likeness) -> Iterator[Change]:
    """Readings with other signs and in another order."""
    n = robot.n
    unlike = [j for j in range(n) if not fit.unexplained[j] < 0.5]
    everyone = tuple(range(1, n + 1))
    minus = tuple(-1.0 for _ in everyone)
    for where, groups, text, scale, sign in (
        (named("tau", everyone), "torques", "the sign of all torques is flipped", None, minus),
        (named("q", everyone), "positions and rates", "the sign of all positions is flipped", minus, None),
        ("q, tau", "columns but t", "all joints turn the other way than the model's", minus, minus),
    ):
        remedy = f"change the sign of all {groups}"
        yield Change("sign", everyone, where, text, remedy, scale=scale, tau_sign=sign)
    for j in everyone:
        one = tuple(-1.0 if k == j else 1.0 for k in everyone)
        if j - 1 in unlike:
            yield Change(
                "sign", (j,), f"tau{j}", "the sign of the torque is flipped",
                f"change the sign of tau{j}{_map(tau=one)}", tau_sign=one,
            )  # fmt: skip
        yield Change(
            "sign", (j,), f"q{j}", "the sign of the position is flipped",
            f"change the sign of q{j} and its rates{_map(q=one)}", scale=one,
        )  # fmt: skip
        yield Change(
            "sign", (j,), f"q{j}, tau{j}", "the joint turns the other way than the model's",
            f"change the signs of q{j}, its rates and tau{j}{_map(q=one, tau=one)}", scale=one, tau_sign=one,
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
                    "order", both, where, "swapped", _exchange(group, where, tuple(order)),
                    order=tuple(order) if group != "tau" else None,
                    tau_order=tuple(order) if group != "q" else None,
                )  # fmt: skip
