"""The closed form of the equations of motion: with the mass matrix and gravity, all products of velocities.

``tau_i = sum_k M_ik qdd_k + sum_km h_ikm qd_k qd_m + g_i``, the h_ikm being Christoffel's symbols of the mass
matrix. Source: Dhanaraj 1990, section 2.3.1 (D, h and c there).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.functions.record import Array, Function, Pair, Q
from robodyn.dynamics.limits import SYMBOLS_JOINTS
from robodyn.dynamics.state import Dynamics, NoSuchFunction, Vector

H = Array("h", "torques by products of velocities qd_k qd_m", "N m s^2/rad^2", shape=("n", "n", "n"))


def _symbols(at: Dynamics) -> Sequence[Any]:
    """Column k of the Coriolis matrix of a unit of the rate m is h_ikm."""
    from robodyn.dynamics.derivatives import coriolis_matrix

    n = len(at.rest)
    if n > SYMBOLS_JOINTS:
        raise NoSuchFunction(
            "Christoffel's symbols of so many joints are too many numbers",
            found=f"{n} joints, {n**3} numbers",
            expected=f"at most {SYMBOLS_JOINTS} joints",
            remedy="take coriolis or coriolis_matrix",
        )
    units = ([int(j == m) for j in range(n)] for m in range(n))
    matrices = [coriolis_matrix(at.links(unit, at.rest), at.mark) for unit in units]
    # h_ikm = h_imk: each pair of rates is read once.
    return [matrices[max(k, m)][i][min(k, m)] for i in range(n) for k in range(n) for m in range(n)]


def _products(at: Dynamics, result: Sequence[Any], x: Vector) -> Pair:
    """At the rates ``x`` the torques of the velocities; and symmetry, which these do not show."""
    n = len(x)
    rows = [result[n * n * i : n * n * (i + 1)] for i in range(n)]
    torques = [sum(row[n * k + m] * (x[k] * x[m]) for k in range(n) for m in range(n)) for row in rows]
    mirrored = [row[n * m + k] for row in rows for k in range(n) for m in range(n)]
    return [*torques, *result], [*at.inertial_torques(x, at.rest), *mirrored]


FUNCTIONS = (
    Function(
        "christoffel_symbols",
        "torques by products of velocities: C qd is the sum over k and m of h_ikm qd_k qd_m",
        (Q,),
        (H,),
        _symbols,
        condition=_products,
        drives=False,
    ),
)
