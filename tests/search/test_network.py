"""A program as a network and back again: exactly what it was."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction

import pytest

from records.made import fast
from robodyn import InputError
from robodyn.counts import count
from robodyn.counts.objective import operations_of
from robodyn.dynamics.equality import equals_recursion
from robodyn.dynamics.functions import function_named
from robodyn.ir import Input, Operand, Operation, Program
from robodyn.ir.fingerprint import fingerprint
from robodyn.robot import Robot, bundled_names
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
    network,
)
from robodyn.search.reconstruction import fraction
from robodyn.search.recovery import rebuilt
from robodyn_testing import representative, sampled
from robodyn_testing.functions import OF_ANY_ARM
from search.arms import SPECIAL, bundled, random_arms

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


def check(robot: Robot, function: str) -> None:
    plain = fast(robot, function)
    found = back(network([plain]))
    assert meaning(found) == meaning(plain)
    assert [(n, len(e)) for n, e in found.outputs] == [(n, len(e)) for n, e in plain.outputs]
    assert operations_of(found).total <= operations_of(plain).total
    if robot.rest_velocity is None:
        assert equals_recursion(robot, function, found, points=1)


def by_hand(*operations: tuple[str, tuple[Operand, ...]], outputs: tuple[Operand, ...]) -> Program:
    return Program(tuple(Operation(op, args) for op, args in operations), (("tau", outputs),))


def check_by_hand(made: Program) -> Network:
    found = network([made])
    assert meaning(back(found)) == meaning(made)
    return found


@pytest.mark.parametrize("name", sampled(bundled_names(), every=4))
def test_bundled_robots(name: str) -> None:
    check(bundled(name), "inverse_dynamics")


@pytest.mark.parametrize("name", ["stanford", "puma560_3dof"])
@pytest.mark.parametrize("function", ["gravity", "bias", "mass_matrix", "forward_dynamics"])
def test_other_functions(name: str, function: str) -> None:
    check(bundled(name), function)


@pytest.mark.slow
@pytest.mark.parametrize("name", bundled_names())
def test_other_functions_of_every_robot(name: str) -> None:
    for function in ("gravity", "bias", "mass_matrix"):
        check(bundled(name), function)


@pytest.mark.parametrize("name", representative(SPECIAL, "tool", "smooth", "parameter"))
def test_special_arms(name: str) -> None:
    for function in OF_ANY_ARM:
        try:
            check(SPECIAL[name], function)
        except InputError as error:  # an arm that moves without inertia has no inverse of its mass matrix
            assert f"has no {function_named(function).words}" in str(error)  # noqa: PT017
            assert function_named(function).solves


@pytest.mark.parametrize("robot", random_arms(9, joints=4), ids=lambda robot: robot.name)
def test_random_arms(robot: Robot) -> None:
    for function in ("inverse_dynamics", "gravity", "mass_matrix"):
        check(robot, function)


@pytest.mark.slow
@pytest.mark.parametrize("robot", random_arms(60, joints=9), ids=lambda robot: robot.name)
def test_many_random_arms(robot: Robot) -> None:
    for function in ("inverse_dynamics", "gravity", "bias", "mass_matrix"):
        check(robot, function)


def test_outputs_that_are_inputs_constants_and_one_another() -> None:
    made = by_hand(
        ("mul", (X, Y)),
        ("neg", (0,)),
        ("sin", (Q,)),
        ("add", (X, Y)),
        ("sub", (3, Y)),
        outputs=(X, Fraction(3, 7), Fraction(0), 0, 1, 0, 2, 2, 4, Input("m", None)),
    )
    found = check_by_hand(made)
    assert found.outputs[1] == Fraction(3, 7)
    assert found.outputs[4] == (found.outputs[3][0], -1)  # type: ignore[index]
    assert found.outputs[8] == found.outputs[0]  # (x + y) - y is x
    assert len(found.targets) == 1


@pytest.mark.parametrize("outputs", [(X,), (Fraction(2),), (X, X), (Fraction(0), Q), ()])
def test_nothing_to_compute(outputs: tuple[Operand, ...]) -> None:
    made = by_hand(outputs=outputs)
    assert check_by_hand(made).targets == []


def test_what_is_constant_is_a_number() -> None:
    made = by_hand(
        ("sin", (Q,)),
        ("cos", (Q,)),
        ("mul", (0, 0)),
        ("mul", (1, 1)),
        ("mul", (Fraction(-5, 3), 2)),
        ("mul", (Fraction(-5, 3), 3)),
        ("add", (4, 5)),  # -5/3
        ("mul", (6, X)),
        ("add", (2, 3)),
        ("sub", (8, Fraction(1))),  # 0
        outputs=(7, 6, 9),
    )
    found = check_by_hand(made)
    assert found.outputs[1:] == (Fraction(-5, 3), Fraction(0))
    assert [row.op for row in found.rows if row.op in (ADD, OFFSET)] == []


def test_sines_of_one_angle_are_one_leaf() -> None:
    made = by_hand(
        ("add", (Q, R)),
        ("sin", (0,)),
        ("add", (R, Q)),
        ("sin", (2,)),
        ("neg", (0,)),
        ("sin", (4,)),
        ("add", (1, 3)),
        ("add", (6, 5)),  # sin
        ("mul", (7, X)),
        outputs=(8,),
    )
    found = check_by_hand(made)
    assert len(found.leaves) == [row.op for row in found.rows].count(LEAF) == 2
    assert operations_of(back(found)).total == 2  # q1 + q2, and one product


def test_values_are_told_apart_and_recognised() -> None:
    made = by_hand(
        ("mul", (X, X)),
        ("mul", (Y, Y)),
        ("sub", (0, 1)),
        ("add", (X, Y)),
        ("sub", (X, Y)),
        ("mul", (3, 4)),  # x^2 - y^2 again
        ("sub", (5, 2)),  # nothing
        ("add", (5, 2)),
        outputs=(6, 7, 5, 2),
    )
    found = check_by_hand(made)
    assert found.outputs[0] == Fraction(0)
    assert found.outputs[2] == found.outputs[3]


def test_the_sign_of_a_minus_and_of_an_offset() -> None:
    made = by_hand(
        ("sub", (Fraction(5, 3), X)),
        ("neg", (0,)),
        ("sub", (1, Y)),
        ("mul", (Fraction(-2, 7), 2)),
        ("sub", (X, Fraction(5, 3))),
        ("mul", (Fraction(-1), 4)),
        ("add", (Fraction(0), 5)),
        outputs=(0, 1, 2, 3, 4, 5, 6),
    )
    check_by_hand(made)


def test_opaque_operations_stay_as_they_are() -> None:
    made = by_hand(
        ("mul", (X, Fraction(100))),
        ("tanh", (0,)),
        ("sign", (Y,)),
        ("add", (Q, Fraction(1, 3))),
        ("div", (3, X)),
        ("sqrt", (3,)),
        ("mul", (1, 2)),
        ("mul", (4, 5)),
        ("add", (6, 7)),
        outputs=(8, 1, 0),
    )
    check_by_hand(made)


def test_an_input_read_as_an_angle_and_as_a_number() -> None:
    made = by_hand(("sin", (Q,)), ("mul", (0, Q)), ("add", (1, R)), outputs=(2, 0))
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


def test_the_same_seed_gives_the_same_network() -> None:
    plain = fast(bundled("stanford_3dof"))
    assert network([plain], seed=4) == network([plain], seed=4)
    assert network([plain], seed=4).residues != network([plain], seed=5).residues


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
    for x in (
        Fraction(0),
        Fraction(1),
        Fraction(-1),
        Fraction((1 << most) - 1),
        Fraction(-1, (1 << most) - 1),
    ):
        assert fraction(residues(x), moduli) == x
    for _ in range(20):  # too large a fraction is never another one
        x = Fraction(chance.getrandbits(61 * primes) | 1 << 61 * primes - 1, chance.getrandbits(40) | 1)
        with pytest.raises(NoWalk):
            fraction(residues(x), moduli)


def test_numbers_of_many_digits_come_back() -> None:
    long = [Fraction(3**180 + k, 7**90 + k) for k in range(3)]
    made = by_hand(
        ("mul", (long[0], X)),
        ("add", (long[1], 0)),
        ("mul", (long[2], 1)),
        ("mul", (2, Y)),
        outputs=(3, 0, 1),
    )
    found = back(network([made]))
    assert meaning(found) == meaning(made)
    assert set(long) <= {arg for operation in found.operations for arg in operation.args}


def test_numbers_of_the_program_come_back_however_long_they_are() -> None:
    long = Fraction(3**5000, 7**3000)
    made = by_hand(
        ("mul", (long, X)), ("add", (-long, Y)), ("mul", (0, 1)), ("mul", (1 / long, 2)), outputs=(3, 0)
    )
    assert meaning(back(network([made]))) == meaning(made)


def test_nothing_is_folded_on_the_way_back() -> None:
    made = by_hand(
        ("add", (X, Fraction(2))),
        ("add", (Y, Fraction(3))),
        ("mul", (0, 1)),
        ("add", (0, 1)),  # folded it were (x + y) + 5: one more
        ("mul", (2, 3)),
        ("add", (4, 4)),
        outputs=(5,),
    )
    found = back(network([made]))
    assert meaning(found) == meaning(made)
    assert operations_of(found).counts == {"add": 4, "mul": 2}


def test_other_programs_lend_their_values() -> None:
    first = by_hand(("mul", (X, Y)), ("mul", (0, Y)), outputs=(1,))
    second = by_hand(("mul", (Y, Y)), ("mul", (0, X)), ("tanh", (X,)), ("mul", (2, X)), outputs=(1,))
    found = network([first, second])
    assert len(found.rows) > len(network([first]).rows)
    assert meaning(back(found)) == meaning(first)


def test_labels_and_origin_make_no_difference() -> None:
    plain = fast(bundled("stanford_3dof"))
    bare = replace(plain, operations=tuple(op._replace(label=None) for op in plain.operations))
    assert count(back(network([bare]))) == count(back(network([plain])))
