"""That each formulation is what it is called, and costs what its authors or the thesis's Table 1.1 say,
difference by difference."""

from __future__ import annotations

import pytest

from robodyn.counts import Count
from robodyn.counts.general import general_count
from robodyn.thesis.formulations.balafoutis import balafoutis
from robodyn.thesis.formulations.lagrange import lagrange
from robodyn.thesis.formulations.lagrange_3x3 import lagrange_3x3
from robodyn.thesis.formulations.lagrange_4x4 import lagrange_4x4
from robodyn.thesis.tables.formulations import pairs, triples

# --- what they cost ---------------------------------------------------------------------------------------


def test_a_revolute_joint_more_costs_the_tensor_recursion_93_and_81() -> None:
    """Balafoutis and Patel 1991, algorithm 5.7: 93 n - 108 and 81 n - 100."""
    five, six = (general_count(balafoutis, n) for n in (5, 6))
    assert (six.mul - five.mul, six.add - five.add) == (93, 81)


@pytest.mark.parametrize("n", range(1, 7))
def test_general_counts_of_lagrange(n: int) -> None:
    """Beside the table, the closed form: two rates for a D_ijk, not for each of its traces; a qdd for a D_ij;
    inertial traces for all i <= j <= p; (n - 1)(n - 2) / 2 transforms fewer; the entries of A (4 n); sums
    over links. In 4x4 (830 n - 592, 675 n - 464): 20 n multiplications and two sums of 4x4 matrices a link
    fewer, which its equations do not explain; 16 and 48 fewer, the zero velocity and acceleration of the
    base. In 3x3 (412 n - 277, 320 n - 201): two sums of 3x3 matrices a link fewer and 3 additions for the
    masses beyond p in h; 13 n multiplications fewer."""
    products = 2 * pairs(n) ** 2 + 2 * triples(n) + (triples(n) + pairs(n) + n - 3)
    traces = 4 * pairs(n) ** 2 + 4 * triples(n) - pairs(n)
    assert general_count(lagrange, n, dense=True) == Count(
        mul=64 * products + 2 * n**3 + n**2 + 21 * pairs(n) + 4 * n,
        add=48 * products + traces + n**2 + 16 * pairs(n) - n,
    )
    assert general_count(lagrange_4x4, n, dense=True) == Count(mul=810 * n - 608, add=643 * n - 512)
    assert general_count(lagrange_3x3, n, dense=True) == Count(mul=399 * n - 279, add=305 * n - 231)
