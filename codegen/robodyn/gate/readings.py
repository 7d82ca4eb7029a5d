"""Other readings of a log: in other units, with other signs, zeros and gains, in another order, later."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from robodyn.arrays import Floats
from robodyn.gate import limits
from robodyn.gate.flag import named
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True)
class Reading:
    """What is wrong if it is right; as logged by default. A log is refused where a reading with a ``remedy``
    is right: what has a number, or may be an effect, has none.

    Positions are taken in the ``order`` [n], times the ``scale`` [n], less the ``zero`` [n]; torques ``late``
    [s], in the ``tau_order`` and times ``tau_scale`` [n]. ``gravity``: the torque has all of
    it, what a controller with the description leaves of it, or none; ``down``: itself [m/s^2], where it is
    not the description's; ``clock``: times of the log are so many times the true ones; ``looseness``: so many
    times less sure is the description than it says.
    """

    order: tuple[int, ...]
    tau_order: tuple[int, ...]
    scale: tuple[float, ...]
    zero: tuple[float, ...]
    tau_scale: tuple[float, ...]
    late: float = 0.0
    gravity: Literal["whole", "error", "none"] = "whole"
    down: tuple[float, ...] = ()
    clock: float = 1.0
    looseness: float = 1.0
    kind: str = "logged"
    joints: tuple[int, ...] = ()
    where: str = ""
    text: str = ""
    remedy: str = ""

    def by_channel(self, x: Floats) -> Floats:
        """Of ``x`` [n, ...] by the model's joints that by torque channels."""
        back = np.empty_like(x)
        back[list(self.tau_order)] = x
        return back


def as_logged(n: int) -> Reading:
    """The reading of a log of ``n`` joints as it stands."""
    order = tuple(range(n))
    return Reading(order, order, (1.0,) * n, (0.0,) * n, (1.0,) * n)


def readings(robot: Robot, largest: Floats, base: Reading) -> Iterator[Reading]:
    """Readings in other units, with other signs and in another order, of positions that reach ``largest``
    [n], beside what ``base`` says already of zeros, gains, lateness and gravity."""
    yield from _units(robot, largest, base)
    yield from _signs(robot.n, base)
    yield from _orders(robot.n, base)


def _units(robot: Robot, largest: Floats, base: Reading) -> Iterator[Reading]:
    for kind, unit, remedy, factor, of_kind in (
        ("degrees", "radians", "multiply {} (and the rates) by pi/180", math.radians(1), "revolute"),
        ("millimetres", "metres", "divide {} (and the rates) by 1000", 1e-3, "prismatic"),
    ):
        joints = [link.joint for link in robot.links]
        ends = [max(map(abs, map(float, one.limits.position or (limits.FAR, limits.FAR)))) for one in joints]
        own = tuple(j + 1 for j in range(robot.n) if joints[j].kind == of_kind)
        beyond = [(j,) for j in own if largest[j - 1] > limits.BEYOND_LIMITS * ends[j - 1]]
        # All that are of the kind, or one that is beyond alone.
        for some in {own, *beyond} if beyond else ():
            scale = tuple(factor if j + 1 in some else 1.0 for j in range(robot.n))
            where = named("q", some)
            yield replace(
                base, kind=kind, joints=some, where=where, text=f"{kind} for {unit}",
                remedy=remedy.format(where), scale=scale,
            )  # fmt: skip


def _signs(n: int, base: Reading) -> Iterator[Reading]:
    everyone = tuple(range(1, n + 1))
    for joints in dict.fromkeys([everyone, *((j,) for j in everyone)]):
        sign = tuple(-1.0 if j in joints else 1.0 for j in everyone)
        tau, q = named("tau", joints), named("q", joints)
        of = "all {}s" if len(joints) > 1 else "the {}"
        turned = "all joints turn" if len(joints) > 1 else "the joint turns"
        for where, text, rates, groups in (
            (tau, f"the sign of {of.format('torque')} is flipped", "", ("tau",)),
            (q, f"the sign of {of.format('position')} is flipped", " and its rates", ("q",)),
            (f"{q}, {tau}", f"{turned} the other way than the model's", " and the rates", ("q", "tau")),
        ):
            gains = tuple(a * b for a, b in zip(sign, base.tau_scale, strict=True))
            yield replace(
                base, kind="sign", joints=joints, where=where, text=text,
                remedy=f"change the sign of {where}{rates}{_map(groups, sign)}",
                scale=sign if "q" in groups else base.scale,
                tau_scale=gains if "tau" in groups else base.tau_scale,
            )  # fmt: skip


def _orders(n: int, base: Reading) -> Iterator[Reading]:
    for i, j in itertools.combinations(range(n), 2):
        order = list(range(n))
        order[i], order[j] = j, i
        pair = (i + 1, j + 1)
        for groups, where, columns in (
            (("q",), named("q", pair), "the columns"),
            (("tau",), named("tau", pair), "the columns"),
            (("q", "tau"), f"joints {i + 1} and {j + 1}", "all columns of"),
        ):
            one = replace(base, joints=pair, where=where, text="swapped", remedy=f"swap {columns} {where}")
            yield _reordered(one, order, groups)
    if n > 3:  # of three, it is two that are swapped
        text, remedy = "the joints are in the reverse order", "number them from the base"
        one = replace(base, joints=tuple(range(1, n + 1)), where="q, tau", text=text, remedy=remedy)
        yield _reordered(one, list(range(n - 1, -1, -1)), ("q", "tau"))


def _reordered(one: Reading, order: list[int], groups: tuple[str, ...]) -> Reading:
    return replace(
        one, kind="order", remedy=one.remedy + _map(groups, order),
        order=tuple(order) if "q" in groups else one.order,
        tau_order=tuple(order) if "tau" in groups else one.tau_order,
    )  # fmt: skip


def _map(groups: Sequence[str], values: Sequence[float]) -> str:
    """How a map of columns (--map) says so: signs, which are +-1 and floats, or the order, which are ints."""
    lines = []
    for group in groups:
        columns, sign = f"{group}%d", f", sign: [{', '.join(f'{x:g}' for x in values)}]"
        if all(isinstance(x, int) for x in values):
            columns, sign = f"[{', '.join(f'{group}{int(j) + 1}' for j in values)}]", ""
        lines.append(f"{group}: {{columns: {columns}{sign}}}")
    return f" (with --map, in a file: {' and '.join(lines)})"
