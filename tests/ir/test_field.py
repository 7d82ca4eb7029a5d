"""Fields drawn from hashes: primes of 120 bits that nobody knows before all that is compared is written."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from robodyn.ir import Graph, Input, Operation, Program
from robodyn.ir.field import Field, Residue, Vanishes, is_prime
from robodyn.ir.fingerprint import agree, digest, fingerprint, in_drawn_field
from robodyn.ir.lowering import lower
from robodyn.robot.values import circle_point

FIELD = Field("here")
fractions = st.fractions(max_denominator=10**30)
X = Input("qd", 0)


def test_primes_are_primes_and_each_seed_has_its_own() -> None:
    primes = [Field(f"{k}").prime for k in range(40)]
    assert len(set(primes)) == 40
    for p in primes:
        assert sympy.isprime(p)
        assert p.bit_length() == 120
        assert p % 4 == 3
    # Of 40 chances for each bit none is stuck, but for those that size and remainder fix.
    fixed = [k for k in range(120) if len({p >> k & 1 for p in primes}) == 1]
    assert fixed == [0, 1, 119]


def test_the_test_of_primes_refuses_composites() -> None:
    """Carmichael numbers, squares, products of two primes that are close; all 3 modulo 4 or made so."""
    p = FIELD.prime
    close = sympy.nextprime(p)
    composites = [p * p, p * close, 3 * p, 8911, 1024651, 3215031751]
    assert not any(is_prime(n, b"key") for n in composites)
    assert all(is_prime(n, b"key") for n in (p, 1000003, 2**127 - 1, 2**61 - 1))


@given(fractions, fractions)
def test_places_are_those_of_rational_numbers(a: Fraction, b: Fraction) -> None:
    p, place = FIELD.prime, FIELD.number
    assert place(a + b) == (place(a) + place(b)) % p
    assert place(a * b) == place(a) * place(b) % p
    assert (a == b) == (place(a) == place(b))


@pytest.mark.parametrize("power", [1, 2, 5])
def test_what_would_vanish_is_noticed(power: int) -> None:
    multiple = 6 * FIELD.prime**power
    for number in (Fraction(multiple), multiple, -multiple, Fraction(multiple, 7), Fraction(1, multiple)):
        with pytest.raises(Vanishes):
            FIELD.number(number)
    with pytest.raises(Vanishes):
        FIELD.prepare([3, multiple])
    assert FIELD.number(0) == FIELD.number(Fraction(0)) == 0


def test_another_field_is_drawn_where_a_constant_vanishes() -> None:
    tried: list[int] = []

    def decide(field: Field) -> int:
        tried.append(field.prime)
        if len(tried) < 3:
            raise Vanishes
        return field.prime

    assert in_drawn_field(decide, b"seed") == tried[-1]
    assert len(set(tried)) == 3


def test_points_of_circles_obey_the_theorems() -> None:
    p = FIELD.prime
    c, s = FIELD.angle(Input("q", 0))
    assert (c * c + s * s) % p == 1
    assert FIELD.multiple((c, s), 2) == ((c * c - s * s) % p, 2 * c * s % p)
    assert FIELD.turn(FIELD.multiple((c, s), 5), FIELD.multiple((c, s), -5)) == (1, 0)
    assert FIELD.angle(Input("q", 0)) == (c, s)
    assert len({FIELD.angle(x) for x in (Input("q", 0), Input("q", 1), Input("q0", None))}) == 3
    assert FIELD.angle(Input("q", 0), 2) != (c, s)


def test_what_is_compared_chooses_the_field() -> None:
    """One digit more, another operation, another order of outputs: another hash, another prime."""
    made = Program((Operation("mul", (Fraction(3, 2), X)),), (("t", (0, X)),))
    others = [
        Program((Operation("mul", (Fraction(3, 4), X)),), made.outputs),
        Program((Operation("mul", (Fraction(-3, 2), X)),), made.outputs),
        Program((Operation("add", (Fraction(3, 2), X)),), made.outputs),
        Program((Operation("mul", (Fraction(3, 2), Input("qd", 1))),), made.outputs),
        Program(made.operations, (("t", (X, 0)),)),
        Program(made.operations, (("u", (0, X)),)),
        Program(made.operations, (("t", (0,)), ("u", (X,)))),
    ]
    assert len({digest(program) for program in (made, *others)}) == len(others) + 1


@pytest.mark.parametrize("prime", [2**61 - 1, 2**61 - 31, 2**31 - 1, 2**127 - 1, 10**9 + 7, FIELD.prime])
def test_a_multiple_of_a_prime_is_not_zero(prime: int) -> None:
    graph = Graph()
    x, y = graph.input("qd", 0), graph.input("qd", 1)
    for k in (prime, prime**3, Fraction(prime, 10**18), Fraction(1, prime), Fraction(3, prime**2)):
        one, other = (lower(graph, [("t", [v])]) for v in (x + k * y, x))
        assert not agree(one, other, circle_point)
        assert agree(one, lower(graph, [("t", [y * k + x])]), circle_point)


def test_a_coincidence_in_one_field_is_none_in_the_drawn_one() -> None:
    """The difference of the two vanishes wherever it was known beforehand."""
    known = Field("seed 3")
    graph = Graph()
    x = graph.input("qd", 0)
    y = x + (x - known.variable(X)) * 1000
    one, other = lower(graph, [("t", [x])]), lower(graph, [("t", [y])])
    assert fingerprint(one, known, circle_point) == fingerprint(other, known, circle_point)
    assert not agree(one, other, circle_point)


@given(st.tuples(*[st.fractions(max_denominator=50)] * 4))
def test_residues_calculate_as_fractions_do(numbers: tuple[Fraction, ...]) -> None:
    a, b, c, d = numbers

    def formula(x: Fraction | Residue, y: Fraction | Residue) -> list[Fraction | Residue]:
        values = [x + y, x - y, x * y, -x, 2 - x, x - 2, 3 * x, x * Fraction(2, 7), x + c, c - x, d * y]
        return values + ([x / y, 1 / y, c / y, x / 3] if b else [])

    found = formula(Residue(FIELD, FIELD.number(a)), Residue(FIELD, FIELD.number(b)))
    for residue, exact in zip(found, formula(a, b), strict=True):
        assert residue == exact
        assert residue != exact + Fraction(1, 10**40)
