"""An arm, its log, and ways to spoil it, for the tests of the gate."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np

from robodyn.gate.gate import Flag, Gate
from robodyn.logs.log import Log
from robodyn.robot import load
from robodyn.robot.model import EffectEntry, Limits, Robot

ANGLE = Limits((Fraction(-2), Fraction(2)), Fraction(2), Fraction(8))
WAY = Limits((Fraction(1, 5), Fraction(9, 10)), Fraction(1), Fraction(4))
#: Flags that say that something is wrong, and not merely how the motion is.
WRONG = {
    "garbage", "rates_unusable", "duplicated", "repeated_time", "stray_time", "spike", "jump", "held",
    "missing", "gap", "fragment", "jitter", "cut_down", "rate_scale", "rate_mismatch", "unlike_model",
    "stuck", "saturation", "torque_gain", "zero", "late_torque", "perhaps_no_gravity", "description_off",
}  # fmt: skip


def arm(name: str) -> Robot:
    """The bundled arm with limits for a motion."""
    robot = load(name, warn=lambda _: None)
    links = [
        replace(k, joint=replace(k.joint, limits=WAY if k.joint.kind == "prismatic" else ANGLE))
        for k in robot.links
    ]
    return replace(robot, links=tuple(links))


def entry(kind: str, joint: int | None, **settings: Any) -> EffectEntry:
    exact = {k: tuple(map(fraction, v)) if isinstance(v, tuple) else fraction(v) for k, v in settings.items()}
    return EffectEntry(kind, joint, tuple(exact.items()))


def fraction(x: Any) -> Any:
    return Fraction(f"{x:.6f}") if isinstance(x, float) else x


GIVEN = arm("puma560_3dof")


def at(log: Log, rows: Any) -> Log:
    """The ``rows`` of ``log``, in that order."""
    return replace(log, t=log.t[rows], q=log.q[rows], qd=log.qd[rows], tau=log.tau[rows])  # type: ignore[index]


def put(log: Log, group: str, where: Any, value: Any) -> Log:
    """``log`` with ``value`` in the array ``group``."""
    array = getattr(log, group).copy()
    array[where] = value
    return replace(log, **{group: array})


def swapped(log: Log, i: int, j: int, *groups: str) -> Log:
    order = np.arange(log.n)
    order[[i, j]] = j, i
    return replace(log, **{g: getattr(log, g)[:, order] for g in groups if getattr(log, g) is not None})


def flag_of(gate: Gate, kind: str) -> Flag:
    (flag,) = gate.flags_of(kind)
    return flag


# --- rows and times ---------------------------------------------------------------------------------------


def rows_of(gate: Gate, kind: str) -> list[tuple[int, int]]:
    return [(span.first, span.last) for span in flag_of(gate, kind).spans]
