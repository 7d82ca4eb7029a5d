"""Logs that a division may trip over: empty, of a row or two, constant, of NaN, of huge and tiny numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.robot.model import Robot

Floats = NDArray[np.float64]
Columns = dict[str, Floats]


def plain_log(robot: Robot, samples: int = 240, period: float = 0.01, seed: int = 0) -> Columns:
    """A motion of all joints, with the torques of ``robot``, friction that no description has, and noise."""
    from robodyn.kernels.array_dynamics import Model

    chance = np.random.default_rng(seed)
    t = period * np.arange(samples)
    w = 2 * np.pi * np.array([0.5 + 0.37 * j for j in range(robot.n)])
    size, phase = np.full(robot.n, 0.4), chance.uniform(0, 6, robot.n)
    angle = np.outer(t, w) + phase
    q, qd, qdd = size * np.sin(angle), size * w * np.cos(angle), -size * w * w * np.sin(angle)
    tau = Model(robot).rigid_torque(q, qd, qdd) + 0.8 * np.sign(qd) + 0.01 * chance.standard_normal(q.shape)
    columns: Columns = {"t": np.asarray(t, np.float64)}
    for name, values in (("q", q), ("qd", qd), ("qdd", qdd), ("tau", tau)):
        columns |= {f"{name}{j + 1}": np.array(values[:, j], np.float64) for j in range(robot.n)}
    return columns


def text_of(columns: Mapping[str, Floats]) -> str:
    """The columns as CSV."""
    rows = np.column_stack(list(columns.values())) if columns else np.zeros((0, 0))
    return "\n".join([",".join(columns), *(",".join(map(repr, row)) for row in rows.tolist())]) + "\n"


def _rows(*where: int) -> Callable[[Columns], Columns]:
    return lambda c: {k: v[list(where)] for k, v in c.items()}


def _columns(
    prefix: str, value: Callable[[Floats], Floats], *, first: bool = False
) -> Callable[[Columns], Columns]:
    def change(c: Columns) -> Columns:
        names = [k for k in c if k.rstrip("0123456789") == prefix]
        return {k: value(v.copy()) if k in (names[:1] if first else names) else v for k, v in c.items()}

    return change


def _some(value: float, share: float = 0.3) -> Callable[[Floats], Floats]:
    def change(v: Floats) -> Floats:
        v[np.random.default_rng(1).random(len(v)) < share] = value
        return v

    return change


def _at(v: Floats, place: int, value: float) -> Floats:
    v = v.copy()
    v[place] = value
    return v


def _all(c: Columns, value: Callable[[Floats], Floats]) -> Columns:
    return {k: value(v.copy()) if k != "t" else v for k, v in c.items()}


def _without(*prefixes: str) -> Callable[[Columns], Columns]:
    return lambda c: {k: v for k, v in c.items() if k.rstrip("0123456789") not in prefixes}


def _duplicated(t: Floats) -> Floats:
    t[1::2] = t[0::2][: len(t[1::2])]
    return t


def _still(c: Columns) -> Columns:
    """Positions stay where they begin, and rates are 0."""
    still = {k: np.full(len(v), 0.0 if "d" in k else v[0]) for k, v in c.items() if k.startswith("q")}
    return {**c, **still}


def _joint_still(c: Columns) -> Columns:
    last = max(int(k[1:]) for k in c if k[1:].isdigit())
    still = {f"q{last}": 0.3, f"qd{last}": 0.0, f"qdd{last}": 0.0}
    return {**c, **{k: np.full(len(c["t"]), x) for k, x in still.items() if k in c}}


def _bursts(c: Columns) -> Columns:
    """Bursts of one to four rows, a second apart."""
    t = c["t"].copy()
    place = 0
    for k, size in enumerate([1, 2, 1, 3, 1, 4, 1, 1, 5] * len(t)):
        t[place : place + size] += k
        place += size
    return {**c, "t": t}


#: What is strange about a log, and how a plain one becomes it.
LOGS: Final[dict[str, Callable[[Columns], Columns]]] = {
    "plain": lambda c: c,
    "empty": lambda c: {},
    "header": _rows(),
    "one_row": _rows(0),
    "two_rows": _rows(0, 1),
    "three_rows": _rows(0, 1, 2),
    "five_rows": _rows(*range(5)),
    "twelve_rows": _rows(*range(12)),
    "thirty_rows": _rows(*range(30)),
    "no_rates": _without("qd", "qdd"),
    "no_accelerations": _without("qdd"),
    "nan_column": _columns("q", lambda v: v * np.nan, first=True),
    "nan_torque": _columns("tau", lambda v: v * np.nan, first=True),
    "nan_torques": _columns("tau", lambda v: v * np.nan),
    "nan_rates": _columns("qd", lambda v: v * np.nan),
    "nan_all": lambda c: _all(c, lambda v: v * np.nan),
    "nan_row": lambda c: _all(c, lambda v: _at(v, len(v) // 2, np.nan)),
    "nan_times": _columns("t", lambda v: v * np.nan),
    "nan_some_times": _columns("t", _some(np.nan)),
    "nan_some": _columns("q", _some(np.nan)),
    "nan_most": _columns("tau", _some(np.nan, 0.97)),
    "inf_torque": _columns("tau", _some(np.inf, 0.02)),
    "inf_position": _columns("q", lambda v: v + np.inf, first=True),
    "inf_time": _columns("t", lambda v: _at(v, -1, np.inf)),
    "constant": lambda c: _all(c, lambda v: np.full(len(v), 0.25)),
    "zero": lambda c: _all(c, lambda v: 0 * v),
    "still": _still,
    "joint_still": _joint_still,
    "no_torque": _columns("tau", lambda v: 0 * v),
    "no_first_torque": _columns("tau", lambda v: 0 * v, first=True),
    "huge": lambda c: _all(c, lambda v: 1e300 * v),
    "huge_torque": _columns("tau", lambda v: 1e300 * v),
    "huge_position": _columns("q", lambda v: 1e300 * v),
    "huge_sample": _columns("tau", lambda v: _at(v, 20, 1e308)),
    "tiny": lambda c: _all(c, lambda v: 1e-302 * v),
    "tiny_torque": _columns("tau", lambda v: 1e-302 * v),
    "tiny_motion": lambda c: _columns("q", lambda v: 1e-12 * v)(_without("qd", "qdd")(c)),
    "tiny_times": _columns("t", lambda v: 1e-302 * v),
    "huge_times": _columns("t", lambda v: 1e300 * v),
    "small_times": _columns("t", lambda v: 1e-9 * v),
    "same_times": _columns("t", lambda v: 0 * v),
    "duplicated_times": _columns("t", _duplicated),
    "backward": _columns("t", lambda v: -v),
    "shuffled": _columns("t", lambda v: np.random.default_rng(2).permutation(v)),
    "slow": _columns("t", lambda v: 100 * v),
    "very_slow": _columns("t", lambda v: 1e6 * v),
    "late": _columns("t", lambda v: v + 1e15),
    "bursts": _bursts,
    "steps": lambda c: _all(c, lambda v: np.round(v)),
    "noise": lambda c: _all(c, lambda v: np.random.default_rng(3).standard_normal(len(v))),
    "no_time": _without("t"),
    "no_torques": _without("tau"),
}
