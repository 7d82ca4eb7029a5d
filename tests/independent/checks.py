"""Functions whose results are not numbers to be compared, but have to have a property."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final

import casadi as ca
import numpy as np

from independent.reference import Array, Reference, same_turn

Run = Callable[[Mapping[str, Array]], list[Array]]
"""A function of a kernel: its results, flat, one after another."""

Check = Callable[[Reference, Any, Run, Sequence[Mapping[str, Array]]], float]


def _columns(arm: Reference, at: Mapping[str, Array], names: Sequence[tuple[str, int]]) -> Array:
    moving = {x: at[x] for x in ("q", "qd", "qdd")}
    return arm.value(f"columns {names}", lambda: ca.horzcat(*[arm.columns[x] for x in names]), **moving)


def _numbers(columns: Any) -> list[tuple[str, int]]:
    """The first number of each base parameter: a column of the regressor is that of its unit."""
    return [(column.own.quantity, column.own.link) for column in columns]


def regressor(arm: Reference, base: Any, run: Run, states: Sequence[Mapping[str, Array]]) -> float:
    """Columns are those of the first numbers, are independent, and are all; with values, torques."""
    names = _numbers(base.columns)
    worst, ours, all_columns = 0.0, [], []
    for at in states:
        expected = _columns(arm, at, names)
        matrix = run(at)[0].reshape(expected.shape)
        ours.append(matrix)
        all_columns.append(_columns(arm, at, list(arm.columns)))
        worst = max(worst, _off(matrix, expected))
        moving = {x: at[x] for x in ("q", "qd", "qdd")}
        worst = max(worst, _off(matrix @ base.values, arm.inverse_dynamics(**moving)))
    rank, most = (np.linalg.matrix_rank(np.vstack(x), tol=1e-8) for x in (ours, all_columns))
    return worst if rank == most == len(names) else np.inf


def from_parameters(arm: Reference, base: Any, run: Run, states: Sequence[Mapping[str, Array]]) -> float:
    """Linear in any parameters, not in those of the description alone."""
    names, worst = _numbers(base.columns), 0.0
    for k, at in enumerate(states):
        anything = np.random.default_rng(k).uniform(-2, 2, len(names))
        torques = run({**at, "pi": anything})[0]
        worst = max(worst, _off(torques, _columns(arm, at, names) @ anything))
    return worst


def _off(result: Array, expected: Array) -> float:
    return float(np.abs(result - expected).max()) / max(float(np.abs(expected).max()), 1e-3)


def _misses(arm: Reference, q: Array, frame: Array) -> float:
    """How far joint positions are off a pose; of up to three joints, off its place."""
    reached = arm.value("tool", lambda: arm.tool[:3, :], q=q)
    return float(np.abs(reached - frame)[:, 3 if arm.n <= 3 else 0 :].max())


def branches(arm: Reference, base: Any, run: Run, states: Sequence[Mapping[str, Array]]) -> float:
    """Every branch that is said to exist leads to the pose, and one of them is where the pose is from."""
    worst = 0.0
    for at in states:
        q, frame = at["q"], arm.value("tool", lambda: arm.tool[:3, :], q=at["q"])
        solutions, exists, *_, count = run({"T": frame.ravel(), "q_near": q + 0.05})
        rows = solutions.reshape(-1, arm.n)[exists > 0]
        if not len(rows) or count[0] != len(rows):
            return np.inf
        worst = max(worst, *(_misses(arm, row, frame) for row in rows))
        worst = max(worst, min(_apart(arm, row, q) for row in rows))
    return worst


def nearest(arm: Reference, base: Any, run: Run, states: Sequence[Mapping[str, Array]]) -> float:
    """That the reference is near to is where the pose is from."""
    worst = 0.0
    for at in states:
        q, frame = at["q"], arm.value("tool", lambda: arm.tool[:3, :], q=at["q"])
        solution, exists, *_ = run({"T": frame.ravel(), "q_near": q + 0.05})
        if not exists[0]:
            return np.inf
        worst = max(worst, _misses(arm, solution, frame), _apart(arm, solution, q))
    return worst


def _apart(arm: Reference, row: Array, q: Array) -> float:
    """0 for arms with a joint to spare, and for joints on which the pose does not depend: where a pose is
    from is one of many there."""
    if arm.n > 6:
        return 0.0
    moved = arm.value("jacobian", lambda: arm.jacobian, q=q)[: 3 if arm.n <= 3 else 6]
    worst = 0.0
    for k, link in enumerate(arm.links):
        if np.abs(moved[:, k]).max() > 1e-9:
            apart = same_turn(row[k], q[k]) if link["joint"] == "revolute" else abs(row[k] - q[k])
            worst = max(worst, float(apart))
    return worst


CHECKS: Final[dict[str, Check]] = {
    "regressor": regressor,
    "inverse_dynamics_from_parameters": from_parameters,
    "inverse_kinematics": branches,
    "nearest_inverse_kinematics": nearest,
}
