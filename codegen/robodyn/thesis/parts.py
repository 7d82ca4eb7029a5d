"""Lagrange's closed form counted by its parts, each as often as the figures of 1980 have it.

The printed polynomials of Uicker and Kahn's method are a sum of four parts: what one part costs is counted
here on our own formulation's functions, how often it comes is read from the printed figures. The inertial
traces come half as often as they are needed (for one joint half a trace): by this convention nobody could
compute, and it is only for seeing what the figures are made of.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from robodyn.counts.general import Tally
from robodyn.dynamics.transforms import Matrix, applied, inner, product
from robodyn.thesis.formulations.lagrange import weighed

Cost = tuple[int, int]


def pairs(n: int) -> int:
    """Joint and link, ``i <= p``."""
    return n * (n + 1) // 2


def triples(n: int) -> int:
    """Two joints and a link, ``i <= j <= p``."""
    return n * (n + 1) * (n + 2) // 6


def quadruples(n: int) -> int:
    """Three joints and a link, none of the joints beyond it."""
    return pairs(n) ** 2


def part_costs() -> dict[str, Cost]:
    """Multiplications and additions of a full trace ``tr(X J Y^T)``, of a product of two full 4x4 matrices,
    and of a link's share ``m g^T (dW r)`` in the gravity of a joint."""

    def cost(run: Any) -> Cost:
        ledger: dict[str, int] = {}

        def full() -> Matrix:
            return tuple(tuple(Tally(ledger) for _ in range(4)) for _ in range(4))

        def column() -> tuple[Any, ...]:
            return tuple(Tally(ledger) for _ in range(4))

        run(full, column)
        return ledger.get("mul", 0), ledger.get("add", 0)

    return {
        "trace": cost(lambda full, column: weighed(full(), full(), full())),
        "product": cost(lambda full, column: product(full(), full())),
        "gravity": cost(lambda full, column: inner(column(), applied(full(), column())) * column()[0]),
    }


def uicker_kahn_by_parts(n: int) -> tuple[Fraction, Fraction]:
    """Multiplications and additions for ``n`` joints: two rates and a sum with every trace of D_ijk, one
    acceleration and a sum with every second trace of D_ij, ``n^2 - 2`` transforms beside the sum over
    ``i <= j <= p``, and gravity."""
    cost = part_costs()
    (trace, sums), (matrix, matrix_sums), (weight, weight_sums) = (
        cost["trace"],
        cost["product"],
        cost["gravity"],
    )
    halved, products = Fraction(triples(n), 2), triples(n) + n * n - 2
    mul = (trace + 2) * quadruples(n) + (trace + 1) * halved + matrix * products + weight * pairs(n)
    add = (sums + 1) * (quadruples(n) + halved) + matrix_sums * products + weight_sums * pairs(n)
    return Fraction(mul), Fraction(add)
