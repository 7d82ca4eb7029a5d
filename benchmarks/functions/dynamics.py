"""Dynamics, their derivatives and energies as a user of a symbolic tool writes them."""

from __future__ import annotations

from typing import Any

from benchmarks.functions.kinematics import jacobian, poses
from benchmarks.functions.state import Rows, State, Values, by_factors, dot, flat, in_rows, turned, unit
from benchmarks.peers.textbook import (
    Vector,
    add,
    cross,
    down,
    minus,
    on_inertia,
    origin,
    plain,
    plus,
    scaled,
    times,
    up,
    vector,
)
from benchmarks.peers.textbook import joint_reactions as reactions

from robodyn.bench.peers.numbers import LinkNumbers

# --- dynamics ---------------------------------------------------------------------------------------------


def joint_reactions(at: State) -> Values:
    """Forces and moments of the recursion, joint by joint."""
    joints = reactions(at.arm, at.q, at.qd, at.third, at.tool.sin, at.tool.cos)
    return [x for force, moment in joints for x in (*force, *moment)]


def mass_matrix_by_torques(at: State) -> Values:
    """Torques of unit accelerations; what lies above the diagonal, and the same below."""
    n = at.arm.n
    columns = [at.torques(at.rest, [int(i == j) for i in range(n)], weightless=True) for j in range(n)]
    return [columns[max(i, j)][min(i, j)] for i in range(n) for j in range(n)]


def mass_matrix(at: State) -> Rows:
    """Composite bodies (Walker and Orin 1982): mass, first moment and inertia about the frame's origin of all
    that a joint carries; what moves it alone, carried down to the base."""
    n, links, turns = at.arm.n, at.arm.links, at.turns()
    matrix: Rows = [[0] * n for _ in range(n)]
    mass: Any = 0
    h: Vector = (0, 0, 0)
    inertia: Rows = [[0] * 3 for _ in range(3)]
    for i in reversed(range(n)):
        link = links[i]
        own, com = plain(link.mass), vector(link.com)
        mass, h = plus(mass, own), add(h, scaled(own, com))
        inertia = _summed(
            inertia, [[plain(x) for x in row] for row in link.inertia], _steiner(com, scaled(own, com))
        )
        if link.revolute:
            f, m = cross((0, 0, 1), h), (inertia[0][2], inertia[1][2], inertia[2][2])
        else:
            f, m = (0, 0, mass), cross(h, (0, 0, 1))
        matrix[i][i] = plus((m if link.revolute else f)[2], plain(link.rotor))
        for j in reversed(range(i)):
            child = links[j + 1]
            f, m = up(child, *turns[j + 1], f), up(child, *turns[j + 1], m)
            m = add(m, cross(origin(child, at.q[j + 1]), f))
            matrix[i][j] = matrix[j][i] = (m if links[j].revolute else f)[2]
        c, s = turns[i]
        p = origin(link, at.q[i])
        h = up(link, c, s, h)
        inertia = _turned_on_both_sides(link, c, s, inertia)
        moved = add(h, scaled(mass, p))  # p (h + m p)^T and h p^T make the axes' parallels
        inertia = _summed(inertia, _steiner(p, moved), _steiner(h, p))
        h = moved
    return matrix


def _turned_on_both_sides(link: LinkNumbers, c: Any, s: Any, matrix: Rows) -> Rows:
    once = [up(link, c, s, (row[0], row[1], row[2])) for row in matrix]
    return [
        list(row) for row in zip(*(up(link, c, s, column) for column in zip(*once, strict=True)), strict=True)
    ]


def _steiner(u: Vector, v: Vector) -> Rows:
    """``u . v`` times unity less ``v u^T``."""
    total = dot(u, v)
    return [[minus(total if i == j else 0, times(u[j], v[i])) for j in range(3)] for i in range(3)]


def _summed(*matrices: Rows) -> Rows:
    return [
        [plus(plus(matrices[0][i][j], matrices[1][i][j]), matrices[2][i][j]) for j in range(3)]
        for i in range(3)
    ]


def inverse_dynamics(at: State) -> Values:
    return at.torques(at.qd, at.third)


def gravity(at: State) -> Values:
    return at.torques(at.rest, at.rest)


def bias(at: State) -> Values:
    return at.torques(at.qd, at.rest)


def coriolis(at: State) -> Values:
    return at.torques(at.qd, at.rest, weightless=True)


def forward_dynamics(at: State) -> Values:
    return by_factors(mass_matrix(at), [[x] for x in needed(at)], 1)


def forward_dynamics_by_solver(at: State) -> Values | None:
    solution = at.tool.solved(mass_matrix(at), [[x] for x in needed(at)])
    return None if solution is None else [row[0] for row in solution]


def needed(at: State) -> Values:
    return [minus(tau, h) for tau, h in zip(at.third, bias(at), strict=True)]


def inverse_mass_matrix(at: State) -> Values:
    return by_factors(mass_matrix(at), unit(at.arm.n), at.arm.n)


def inverse_by_solver(at: State) -> Values | None:
    solution = at.tool.solved(mass_matrix(at), unit(at.arm.n))
    return None if solution is None else flat(solution)


def momentum(at: State) -> Values:
    return at.torques(at.rest, at.qd, weightless=True)


def momentum_by_matrix(at: State) -> Values:
    return [dot(row, at.qd) for row in mass_matrix(at)]


# --- derivatives ------------------------------------------------------------------------------------------


def inverse_dynamics_derivatives(at: State) -> Values:
    tau = inverse_dynamics(at)
    return flat(at.tool.jacobian(tau, at.q) + at.tool.jacobian(tau, at.qd))


def forward_dynamics_derivatives(at: State) -> Values:
    """``-M^-1`` times the torques' derivatives at the accelerations, and ``M^-1``."""
    n = at.arm.n
    inverse = in_rows(inverse_mass_matrix(at), n)
    tau = inverse_dynamics(at)  # of accelerations that have the torques' symbols
    slopes = flat(at.tool.jacobian(tau, at.q) + at.tool.jacobian(tau, at.qd))
    accelerations = [dot(row, needed(at)) for row in inverse]
    slopes = at.tool.substituted(slopes, at.third, accelerations)
    by_q, by_qd = in_rows(slopes[: n * n], n), in_rows(slopes[n * n :], n)
    products = [
        minus(0, dot(row, column))
        for by in (by_q, by_qd)
        for row in inverse
        for column in zip(*by, strict=True)
    ]
    return [*products, *flat(inverse)]


def forward_dynamics_differentiated(at: State) -> Values:
    """The solution of the linear equations, differentiated as it stands."""
    qdd = forward_dynamics(at)
    return flat([row for by in (at.q, at.qd, at.third) for row in at.tool.jacobian(qdd, by)])


def coriolis_matrix(at: State) -> Values:
    """Half the derivatives of the Coriolis torques, which are quadratic in the velocities."""
    return [times(0.5, x) for x in flat(at.tool.jacobian(coriolis(at), at.qd))]


# --- energies ---------------------------------------------------------------------------------------------


def kinetic_energy(at: State) -> Values:
    w: Vector = (0, 0, 0)
    v: Vector = (0, 0, 0)
    energy: Any = 0
    for link, (c, s), x, rate in zip(at.arm.links, at.turns(), at.q, at.qd, strict=True):
        v = down(link, c, s, add(v, cross(w, origin(link, x))))
        w = down(link, c, s, w)
        v, w = (v, add(w, (0, 0, rate))) if link.revolute else (add(v, (0, 0, rate)), w)
        com = add(v, cross(w, vector(link.com)))
        energy = plus(energy, times(times(0.5, plain(link.mass)), dot(com, com)))
        energy = plus(energy, times(0.5, dot(w, on_inertia(link, w))))
        energy = plus(energy, times(times(0.5, plain(link.rotor)), times(rate, rate)))
    return [energy]


def kinetic_energy_by_matrix(at: State) -> Values:
    return [times(0.5, dot(at.qd, momentum_by_matrix(at)))]


def kinetic_energy_by_momentum(at: State) -> Values:
    return [times(0.5, dot(at.qd, momentum(at)))]


def potential_energy(at: State) -> Values:
    """Heights of the centres of mass, link by link."""
    energy: Any = 0
    g = vector(-at.arm.gravity)
    for link, rows, place in zip(at.arm.links, *poses(at), strict=True):
        com = add(place, turned(rows, vector(link.com)))
        energy = plus(energy, times(plain(link.mass), dot(g, com)))
    return [energy]


def momentum_observer_term(at: State) -> Values:
    """Derivatives of the kinetic energy by the positions, less gravity."""
    return _less_gravity(at, _slopes(at, kinetic_energy(at)))


def observer_by_momentum(at: State) -> Values:
    return _less_gravity(at, _slopes(at, kinetic_energy_by_momentum(at)))


def observer_by_matrix(at: State) -> Values:
    C = in_rows(coriolis_matrix(at), at.arm.n)
    return _less_gravity(at, [dot(column, at.qd) for column in zip(*C, strict=True)])


def _slopes(at: State, energy: Values) -> Values:
    return at.tool.jacobian(energy, at.q)[0]


def _less_gravity(at: State, values: Values) -> Values:
    return [minus(x, g) for x, g in zip(values, gravity(at), strict=True)]


# --- operational space -----------------------------------------------------------------------------------


def lambda_inverse(at: State) -> Values:
    return _around(jacobian(at), in_rows(inverse_mass_matrix(at), at.arm.n))


def lambda_inverse_by_columns(at: State) -> Values:
    """``M^-1 J^T`` column by column."""
    J = jacobian(at)
    solution = in_rows(by_factors(mass_matrix(at), [list(row) for row in zip(*J, strict=True)], 6), 6)
    return flat(
        [[dot(J[min(i, j)], [row[max(i, j)] for row in solution]) for j in range(6)] for i in range(6)]
    )


def _around(J: Rows, inverse: Rows) -> Values:
    half = [[dot(row, other) for other in J] for row in inverse]
    return flat([[dot(J[min(i, j)], [row[max(i, j)] for row in half]) for j in range(6)] for i in range(6)])
