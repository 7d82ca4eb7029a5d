"""x"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from robodyn.dynamics.arm import Arm, Motion
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.transforms import (
    IDENTITY_4,
    Matrix,
    applied,
    homogeneous,
    inner,
    joint_operator,
    marked,
    product,
    pseudo_inertia,
    trace,
    transform,
    transposed,
)
from robodyn.dynamics.vectors import Mark, unmarked
from robodyn.ir.program import Label


@dataclass(frozen=True, slots=True)
class Slopes:
    first: tuple[Matrix, ...]
    second: tuple[tuple[Matrix, ...], ...]


def transform_slopes(arm: Arm, motion: Motion, mark: Mark) -> list[Slopes]:
    W = IDENTITY_4
    U: list[Matrix] = []
    V: list[list[Matrix]] = []
    links = []
    for i, body in enumerate(arm.bodies):
        A = marked(mark, transform(body, motion.c[i], motion.s[i], motion.d[i]), i + 1, "A")
        dA = marked(mark, product(A, joint_operator(body)), i + 1, "dA")
        ddA = marked(mark, product(dA, joint_operator(body)), i + 1, "ddA")
        V = [[product(x, A) for x in row] for row in V]
        V.append([*(product(x, dA) for x in U), product(W, ddA)])
        U = [*(product(x, A) for x in U), product(W, dA)]
        W = product(W, A)
        V = [[marked(mark, x, i + 1, "ddW", f"{j}{k}_") for k, x in enumerate(row, 1)] for j, row in enumerate(V, 1)]
        U = [marked(mark, x, i + 1, "dW", f"{j}_") for j, x in enumerate(U, 1)]
        W = marked(mark, W, i + 1, "W")
        links.append(Slopes(tuple(U), tuple(map(tuple, V))))
    return links


def triple(X: Matrix, J: Matrix, Y: Matrix) -> Any:
    return trace(product(product(X, J), transposed(Y)))


def lagrange(arm: Arm, motion: Motion, mark: Mark = unmarked) -> list[Any]:
    n = len(arm.bodies)
    links = transform_slopes(arm, motion, mark)
    J = [pseudo_inertia(b) for b in arm.bodies]
    qd, qdd = motion.qd, motion.qdd
    g = tuple(mark(x, Label(0, "g", str(k))) for k, x in enumerate((*arm.gravity, 0), 1))
    def inertia(i: int, j: int) -> Any:
        total: Any = 0
        for p in range(max(i, j), n):
            total = total + triple(links[p].first[i], J[p], links[p].first[j])
        return mark(total, Label(i + 1, "m", str(j + 1)))
    def velocity(i: int, j: int, k: int) -> Any:
        total: Any = 0
        for p in range(max(i, j, k), n):
            total = total + triple(links[p].first[i], J[p], links[p].second[max(j, k)][min(j, k)])
        return mark(total, Label(i + 1, "v", f"{j+1}{k+1}"))
    M = [[0] * n for _ in range(n)]
    for i in range(n):
        for j in range(i, n):
            M[i][j] = M[j][i] = inertia(i, j)
    torques = []
    for i in range(n):
        total: Any = 0
        for j in range(n):
            total = total + M[i][j] * qdd[j]
        for j in range(n):
            for k in range(n):
                total = total + velocity(i, j, k) * (qd[j] * qd[k])
        for p in range(i, n):
            r = tuple(mark(x, Label(p+1, "r", str(m))) for m, x in enumerate(homogeneous(arm.bodies[p].com),1))
            total = total - arm.bodies[p].mass * inner(g, applied(links[p].first[i], r))
        torques.append(joint_torque(arm, i, motion, total, mark))
    return torques


def expanded(arm: Arm, motion: Motion, mark: Mark = unmarked) -> list[Any]:
    n = len(arm.bodies)
    links = transform_slopes(arm, motion, mark)
    J = [pseudo_inertia(b) for b in arm.bodies]
    qd, qdd = motion.qd, motion.qdd
    g = tuple(mark(x, Label(0, "g", str(k))) for k, x in enumerate((*arm.gravity, 0), 1))
    torques = []
    for i in range(n):
        total: Any = 0
        for p in range(i, n):
            U = links[p].first
            V = links[p].second
            for j in range(p + 1):
                total = total + triple(U[i], J[p], U[j]) * qdd[j]
            for j in range(p + 1):
                for k in range(p + 1):
                    total = total + triple(U[i], J[p], V[max(j, k)][min(j, k)]) * qd[j] * qd[k]
            r = tuple(mark(x, Label(p+1, "r", str(m))) for m, x in enumerate(homogeneous(arm.bodies[p].com),1))
            total = total - arm.bodies[p].mass * inner(g, applied(U[i], r))
        torques.append(joint_torque(arm, i, motion, total, mark))
    return torques
