"""A program as a network and back again: exactly what it was."""

from __future__ import annotations

import random
from fractions import Fraction
from functools import partial

import pytest

from records.made import fast
from robodyn.counts.objective import operations_of
from robodyn.ir import Input, Program
from robodyn.ir.fingerprint import fingerprint
from robodyn.robot.values import circle_point
from robodyn.search.network import (
    ADD,
    BELOW,
    LEAF,
    OFFSET,
    POINTS,
    SCALE,
    STATES,
    Network,
    NoWalk,
    fraction,
    network,
)
from robodyn.search.walk import rebuilt
from robodyn_testing import by_hand as programs
from search.arms import bundled

X, Y, Q, R = Input("qd", 0), Input("qd", 1), Input("q", 0), Input("q", 1)


def back(made: Network) -> Program:
    """The program of a network that nothing has walked over: the rows that its outputs need."""
    wanted: set[int] = set()
    stack = list(made.targets)
    while stack:
        k = stack.pop()
        if k not in wanted:
            wanted.add(k)
            row = made.rows[k]
            if row.op != LEAF:
                stack += [row.a, row.b] if row.op < SCALE else [row.a]
    ids = sorted(wanted | set(range(len(made.leaves))))
    return rebuilt(made, ids, [made.rows[k] for k in ids], [made.residues[k] for k in ids])


def meaning(made: Program) -> list[tuple[int, ...]]:
    return [fingerprint(made, seed, circle_point) for seed in (11, 12)]


by_hand = partial(programs.by_hand, names={"x": X, "y": Y, "q": Q, "r": R})


def check_by_hand(made: Program) -> Network:
    found = network([made])
    assert meaning(back(found)) == meaning(made)
    return found


def test_outputs_that_are_inputs_constants_and_one_another() -> None:
    made = by_hand("mul x y, neg %0, sin q, add x y, sub %3 y", "x 3/7 0 %0 %1 %0 %2 %2 %4 m")
    found = check_by_hand(made)
    assert check_by_hand(by_hand("", "x x 0 q")).targets == []
    assert found.outputs[1] == Fraction(3, 7)
    assert found.outputs[4] == (found.outputs[3][0], -1)  # type: ignore[index]
    assert found.outputs[8] == found.outputs[0]  # (x + y) - y is x
    assert len(found.targets) == 1


def test_what_is_constant_is_a_number() -> None:
    made = by_hand(
        "sin q, cos q, mul %0 %0, mul %1 %1, mul -5/3 %2, mul -5/3 %3, add %4 %5, mul %6 x, add %2 %3,"
        "sub %8 1",
        "%7 %6 %9",
    )
    found = check_by_hand(made)
    assert found.outputs[1:] == (Fraction(-5, 3), Fraction(0))
    assert [row.op for row in found.rows if row.op in (ADD, OFFSET)] == []


def test_sines_of_one_angle_are_one_leaf() -> None:
    made = by_hand("add q r, sin %0, add r q, sin %2, neg %0, sin %4, add %1 %3, add %6 %5, mul %7 x", "%8")
    found = check_by_hand(made)
    assert len(found.leaves) == [row.op for row in found.rows].count(LEAF) == 2
    assert operations_of(back(found)).total == 2  # q1 + q2, and one product


def test_values_are_told_apart_and_recognised() -> None:
    made = by_hand(
        "mul x x, mul y y, sub %0 %1, add x y, sub x y, mul %3 %4, sub %5 %2, add %5 %2", "%6 %7 %5 %2"
    )
    found = check_by_hand(made)
    assert found.outputs[0] == Fraction(0)
    assert found.outputs[2] == found.outputs[3]


def test_opaque_operations_stay_as_they_are() -> None:
    made = by_hand(
        "mul x 100, tanh %0, sign y, add q 1/3, div %3 x, sqrt %3, mul %1 %2, mul %4 %5, add %6 %7",
        "%8 %1 %0",
    )
    check_by_hand(made)


def test_what_is_known_of_a_row() -> None:
    found = network([fast(bundled("puma560_3dof"))])
    n = len(found.leaves)
    assert [row.op for row in found.rows[:n]] == [LEAF] * n
    assert LEAF not in [row.op for row in found.rows[n:]]
    moduli = [(1 << 61) - below for below in BELOW]
    for k, row in enumerate(found.rows):
        assert len(found.truth[k]) == STATES
        assert all(0 <= x < moduli[0] for x in found.residues[k][:POINTS])
        if row.op == ADD:
            for s in range(STATES):
                a, b, x = (
                    Fraction(high) + Fraction(low)
                    for high, low in (found.truth[j][s] for j in (row.a, row.b, k))
                )
                grain = (abs(a) + abs(b)) / 10**28
                assert abs(a + row.sign * b - x) <= grain or abs(a + row.sign * b + x) <= grain


def test_primes_are_primes() -> None:
    assert len(set(BELOW)) == len(BELOW)
    for below in BELOW:
        p = (1 << 61) - below
        assert all(pow(a, p - 1, p) == 1 for a in (2, 3, 5, 7, 11, 13)), below


@pytest.mark.parametrize("primes", [2, 5, 16, 48])
def test_fractions_are_recovered_up_to_the_size_that_there_is(primes: int) -> None:
    chance = random.Random(primes)
    moduli = [(1 << 61) - below for below in BELOW[:primes]]
    most = (61 * primes - 60) // 2 - 2

    def residues(x: Fraction) -> list[int]:
        return [x.numerator * pow(x.denominator, -1, p) % p for p in moduli]

    for bits in (1, most // 2, most):
        for _ in range(20):
            x = Fraction(chance.getrandbits(bits) * chance.choice((-1, 1)), chance.getrandbits(bits) | 1)
            assert fraction(residues(x), moduli) == x
    for x in (Fraction(0), Fraction(-1), Fraction((1 << most) - 1), Fraction(-1, (1 << most) - 1)):
        assert fraction(residues(x), moduli) == x
    for _ in range(20):  # too large a fraction is never another one
        x = Fraction(chance.getrandbits(61 * primes) | 1 << 61 * primes - 1, chance.getrandbits(40) | 1)
        with pytest.raises(NoWalk):
            fraction(residues(x), moduli)


def test_numbers_of_the_program_come_back_however_long_they_are() -> None:
    short = Fraction(3**180, 7**90)
    assert short in {
        arg for op in back(network([by_hand(f"mul {short} x", "%0")])).operations for arg in op.args
    }
    long = Fraction(3**5000, 7**3000)
    made = by_hand(f"mul {long} x, add {-long} y, mul %0 %1, mul {1 / long} %2", "%3 %0")
    assert meaning(back(network([made]))) == meaning(made)


def test_nothing_is_folded_on_the_way_back() -> None:
    made = by_hand("add x 2, add y 3, mul %0 %1, add %0 %1, mul %2 %3, add %4 %4", "%5")
    found = back(network([made]))
    assert meaning(found) == meaning(made)
    assert operations_of(found).counts == {"add": 4, "mul": 2}


def test_other_programs_lend_their_values() -> None:
    first = by_hand("mul x y, mul %0 y", "%1")
    second = by_hand("mul y y, mul %0 x, tanh x, mul %2 x", "%1")
    found = network([first, second])
    assert len(found.rows) > len(network([first]).rows)
    assert meaning(back(found)) == meaning(first)
