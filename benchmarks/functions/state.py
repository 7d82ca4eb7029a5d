"""What functions are written in terms of: an arm, a symbolic tool, its symbols; linear algebra over them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol

import numpy as np
from benchmarks.peers.textbook import Vector, inverse_dynamics, known, minus, plain, plus, times

from robodyn.bench.peers.numbers import Numbers

Values = list[Any]
Rows = list[list[Any]]


class Tool(Protocol):
    """What a symbolic tool does."""

    def sin(self, x: Any) -> Any: ...
    def cos(self, x: Any) -> Any: ...
    def jacobian(self, values: Sequence[Any], by: Sequence[Any]) -> Rows:
        """Derivatives of ``values`` by the symbols ``by``, as rows."""
        ...

    def substituted(self, values: Sequence[Any], symbols: Sequence[Any], by: Sequence[Any]) -> Values:
        """``values`` with ``by`` in the place of ``symbols``."""
        ...

    def solved(self, matrix: Rows, right: Rows) -> Rows | None:
        """``matrix^-1 right`` by the tool's own solver; None: it has none."""
        ...


@dataclass(frozen=True, slots=True)
class State:
    """An arm, a tool and the tool's symbols [n]: positions, velocities, and accelerations or torques."""

    arm: Numbers
    tool: Tool
    q: Values
    qd: Values
    third: Values

    def torques(self, qd: Sequence[Any], qdd: Sequence[Any], *, weightless: bool = False) -> Values:
        """The recursion's torques [n]."""
        arm = replace(self.arm, gravity=np.zeros(3)) if weightless else self.arm
        return inverse_dynamics(arm, self.q, qd, qdd, self.tool.sin, self.tool.cos)

    @property
    def rest(self) -> Values:
        """Zeros [n]."""
        return [0] * self.arm.n

    def turns(self) -> list[tuple[Any, Any]]:
        """Cosine and sine of each joint's angle."""
        pairs = []
        for link, x in zip(self.arm.links, self.q, strict=True):
            angle = plus(x, plain(link.theta[0]))
            constant = plain(link.theta[1]), plain(link.theta[2])
            pairs.append((self.tool.cos(angle), self.tool.sin(angle)) if link.revolute else constant)
        return pairs


# --- linear algebra ---------------------------------------------------------------------------------------


def by_factors(matrix: Rows, right: Rows, width: int) -> Values:
    """``matrix^-1 right`` by ``L D L^T``, row by row."""
    n = len(matrix)
    L: Rows = [[0] * n for _ in range(n)]
    D: Values = []
    for j in range(n):
        scaled_row = [times(L[j][k], D[k]) for k in range(j)]
        D.append(minus(matrix[j][j], dot(scaled_row, L[j][:j])))
        for i in range(j + 1, n):
            L[i][j] = over(minus(matrix[i][j], dot(L[i][:j], scaled_row)), D[j])
    rows: Rows = [[] for _ in range(n)]
    for column in range(width):
        y: Values = []
        for i in range(n):
            y.append(minus(right[i][column], dot(L[i][:i], y)))
        y = [over(x, d) for x, d in zip(y, D, strict=True)]
        for i in reversed(range(n)):
            y[i] = minus(y[i], dot([L[k][i] for k in range(i + 1, n)], y[i + 1 :]))
        for i in range(n):
            rows[i].append(y[i])
    return flat(rows)


def over(x: Any, y: Any) -> Any:
    return 0 if known(x, 0) else x / y


def unit(n: int) -> Rows:
    return [[int(i == j) for j in range(n)] for i in range(n)]


def dot(one: Sequence[Any], other: Sequence[Any]) -> Any:
    total: Any = 0
    for x, y in zip(one, other, strict=True):
        total = plus(total, times(x, y))
    return total


def turned(rows: Rows, v: Vector) -> Vector:
    x, y, z = (dot(row, v) for row in rows)
    return x, y, z


def flat(rows: Rows) -> Values:
    return [x for row in rows for x in row]


def in_rows(values: Sequence[Any], width: int) -> Rows:
    return [list(values[k : k + width]) for k in range(0, len(values), width)]
