"""A forger who has the source code, and writes records that would add a false term to a torque: none gets in.

Each starts from the best record there is, so that what he adds still costs less than the recursion and would
be taken if nobody looked. What he writes goes through text, as a file does.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from fractions import Fraction
from typing import Final

import pytest

from records.made import arm, bundled, fast
from robodyn import InputError, Options, program
from robodyn.counts import count
from robodyn.dynamics.equality import equals_recursion, same_in_field
from robodyn.ir import Input, Operand, Operation, Program
from robodyn.ir.field import Field
from robodyn.ir.fingerprint import digest
from robodyn.optimize.records import Record, best_record, identity, parse_record
from robodyn.robot import Robot
from robodyn.search.network import BELOW
from robodyn_testing import representative

ROBOT: Final = bundled("stanford_3dof_d3")
Q, QD, QDD = (Input(array, 0) for array in ("q", "qd", "qdd"))
WALK_PRIMES: Final = [2**61 - c for c in BELOW]


def genuine(robot: Robot = ROBOT) -> Program:
    record = best_record(robot, "inverse_dynamics")
    assert record is not None
    return record.program


class Forgery:
    """A genuine program with operations added; ``add`` hands back the position of the new one."""

    def __init__(self, base: Program) -> None:
        self.base = base
        self.operations = list(base.operations)
        ((self.name, self.elements),) = base.outputs

    def add(self, op: str, *args: Operand | float) -> int:
        exact = tuple(Fraction(x) if isinstance(x, float) else x for x in args)
        self.operations.append(Operation(op, exact))
        return len(self.operations) - 1

    def program(self, term: Operand, output: int = 0) -> Program:
        """``term`` added to an output."""
        total = self.add("add", self.elements[output], term)
        elements = (*self.elements[:output], total, *self.elements[output + 1 :])
        return Program(tuple(self.operations), ((self.name, elements),))


def written(robot: Robot, made: Program, function: str = "inverse_dynamics") -> Record:
    text = Record(robot.name, identity(robot), function, "total", "robodyn --optimize full", made).text()
    return parse_record(text, "forged.record")


def check_refused(made: Program) -> None:
    assert count(made).total <= count(fast(ROBOT)).total, "it would not be taken anyway"
    with pytest.raises(InputError, match="does not compute its inverse_dynamics"):
        program(ROBOT, "inverse_dynamics", Options(records=(written(ROBOT, made),)))


def test_the_genuine_record_is_taken() -> None:
    """Otherwise nothing here says anything."""
    made = program(ROBOT, "inverse_dynamics", Options(records=(written(ROBOT, genuine()),)))
    assert count(made) == count(genuine())
    assert count(fast(ROBOT)).total - count(made).total >= 15


# --- false terms, hidden from arithmetic modulo primes ---------------------------------------------------


def about(size: float, multiple: int) -> Fraction:
    """A multiple of a number that is about ``size``."""
    k = 1
    while multiple * k < 2**80:
        k *= 2
    return Fraction(multiple * k, round(multiple * k / Fraction(size)))


@pytest.mark.parametrize(
    "multiple",
    [2**61 - 1, (2**61 - 1) ** 5, 2**127 - 1, math.prod(WALK_PRIMES[:12])],
    ids=["mersenne", "power", "127", "many"],
)
@pytest.mark.parametrize("size", [50.0, 1e-3])
def test_a_coefficient_that_is_zero_in_a_field(multiple: int, size: float) -> None:
    forged = Forgery(genuine())
    check_refused(forged.program(forged.add("mul", about(size, multiple), QDD)))


def test_a_term_that_is_zero_where_the_genuine_program_is_looked_at() -> None:
    """At the points, rational and of fields, that belong to the program before it was forged."""
    base = genuine()
    chance = random.Random(f"{ROBOT.name} inverse_dynamics 0")
    points = [Fraction(chance.randint(-40, 40), chance.randint(1, 9)) for _ in range(12)]
    seed = b"".join(len(part).to_bytes(4, "big") + part for part in (digest(base), digest(fast(ROBOT))))
    fields = [Field(seed + bytes((k,))) for k in range(3)] + [Field(f"seed {k}") for k in range(8)]
    points += [Fraction(field.variable(QDD)) for field in fields]
    for point in points:
        forged = Forgery(base)
        away = forged.add("sub", QDD, point)
        check_refused(forged.program(forged.add("mul", about(50, 2**61 - 1), away)))


def test_following_one_s_own_shadow() -> None:
    """Each forgery is made for the field of the one before: it has changed when the next is written."""
    base, recursion = genuine(), fast(ROBOT)
    point, multiple = Fraction(1), 2**61 - 1
    for _ in range(25):
        forged = Forgery(base)
        made = forged.program(forged.add("mul", about(50, multiple), forged.add("sub", QDD, point)))
        assert not same_in_field(ROBOT, "inverse_dynamics", made)
        assert not equals_recursion(ROBOT, "inverse_dynamics", made, points=1)
        check_refused(made)
        parts = (digest(made), digest(recursion))
        field = Field(b"".join(len(part).to_bytes(4, "big") + part for part in parts) + b"\0")
        point, multiple = Fraction(field.variable(QDD)), field.prime


# --- programs that are equal, and useless ----------------------------------------------------------------


def lost_in_a_sum(forged: Forgery, size: float) -> Operand:
    """(x + 1e20) - 1e20 - x."""
    return forged.add("sub", forged.add("sub", forged.add("add", QD, size), size), QD)


def lost_in_squares(forged: Forgery, size: float) -> Operand:
    """k ((x + y) (x - y) - x x + y y)."""
    x, y = QD, QDD
    product = forged.add("mul", forged.add("add", x, y), forged.add("sub", x, y))
    squares = forged.add("sub", forged.add("mul", x, x), forged.add("mul", y, y))
    return forged.add("mul", size, forged.add("sub", product, squares))


def lost_in_a_circle(forged: Forgery, size: float) -> Operand:
    """k (sin^2 + cos^2 - 1)."""
    c, s = forged.add("cos", Q), forged.add("sin", Q)
    total = forged.add("add", forged.add("mul", c, c), forged.add("mul", s, s))
    return forged.add("mul", size, forged.add("sub", total, Fraction(1)))


def lost_in_an_angle(forged: Forgery, size: float) -> Operand:
    """sin(q + 1e20 - 1e20) - sin(q)."""
    away = forged.add("sub", forged.add("add", Q, size), size)
    return forged.add("mul", 50.0, forged.add("sub", forged.add("sin", away), forged.add("sin", Q)))


def beyond_all_numbers(forged: Forgery, size: float) -> Operand:
    """x 1e-200 1e-200 1e200 1e200 - x: an underflow on the way, or infinity where ``size`` is negative."""
    factors = [Fraction(1, 10**200)] * 2 + [Fraction(10**200)] * 2
    x: Operand = QD
    for k in factors if size > 0 else factors[::-1]:
        x = forged.add("mul", k, x)
    return forged.add("mul", size, forged.add("sub", x, QD))


def a_constant_that_loses_digits(forged: Forgery, size: float) -> Operand:
    """A subnormal number has three digits where others have sixteen."""
    tiny = Fraction(12345678901234567, 10 ** (16 + 321))
    x = forged.add(
        "mul", Fraction(10**160), forged.add("mul", Fraction(10**160), forged.add("mul", tiny, QD))
    )
    return forged.add("mul", size, forged.add("sub", x, forged.add("mul", tiny * 10**320, QD)))


def power(forged: Forgery, x: Operand, doublings: int) -> Operand:
    for _ in range(doublings):
        x = forged.add("mul", x, x)
    return x


def only_at_one_angle(forged: Forgery, size: float) -> Operand:
    """Noise that is there within a few degrees only, so that samples hardly ever meet it."""
    near = forged.add("mul", 0.5, forged.add("add", forged.add("cos", Q), Fraction(1)))
    return forged.add("mul", power(forged, near, 7), lost_in_a_sum(forged, size))


def only_when_fast(forged: Forgery, size: float) -> Operand:
    """Noise that grows with the sixteenth power of a rate, nothing at 1 rad/s."""
    return forged.add("mul", power(forged, forged.add("mul", 0.002, QD), 4), lost_in_a_sum(forged, size))


USELESS: Final[dict[str, tuple[Callable[[Forgery, float], Operand], tuple[float, ...]]]] = {
    "sum": (lost_in_a_sum, (1e20, 1e16, 1e12)),
    "squares": (lost_in_squares, (1e18, 1e12, 1e8)),
    "circle": (lost_in_a_circle, (1e18, 1e12, 1e8)),
    "angle": (lost_in_an_angle, (1e20, 1e12, 1e8)),
    "range": (beyond_all_numbers, (1.0, 50.0, -1.0)),
    "subnormal": (a_constant_that_loses_digits, (1.0, 50.0)),
    "one angle": (only_at_one_angle, (1e20, 1e15)),
    "fast": (only_when_fast, (1e20, 1e16)),
}


@pytest.mark.parametrize(
    ("how", "size"), [(how, size) for how, (_, sizes) in USELESS.items() for size in sizes], ids=str
)
@pytest.mark.parametrize("output", representative([0, 2], 0, rest="slow"))
def test_a_program_that_is_equal_and_useless(how: str, size: float, output: int) -> None:
    forged = Forgery(genuine())
    made = forged.program(USELESS[how][0](forged, size), output)
    assert same_in_field(ROBOT, "inverse_dynamics", made), "it is equal as a function"
    check_refused(made)


# --- programs without a value ----------------------------------------------------------------------------

#: Its mass is an argument, and the payload's centre is found by a division.
LOADED: Final = arm(
    """\
name: loaded
links:
  - {joint: revolute, mass: 3, com: [0.1, 0, 0.2], inertia: {zz: 0.25}, friction: {coulomb: 4}}
  - {joint: revolute, alpha: pi/2, a: 0.4, mass: 2, com: [0.2, 0.1, 0.3], inertia: {xx: 0.2, xy: 0.01}}
effects:
  - {effect: payload, mass: m_load, com: [0, 0.02, 0.1]}
"""
)


def test_division_by_what_may_be_zero() -> None:
    """x y / y is x, and nothing where y is 0; of divisors only those of the recursion are taken."""
    recursion = fast(LOADED)
    assert any(op.op == "div" for op in recursion.operations)
    for divisor in (QD, Q, Input("m_load", None)):
        forged = Forgery(recursion)
        product = forged.add("mul", forged.elements[0], divisor)
        quotient = forged.add("div", product, divisor)
        elements = (quotient, *forged.elements[1:])
        made = Program(tuple(forged.operations), ((forged.name, elements),))
        assert same_in_field(LOADED, "inverse_dynamics", made)
        with pytest.raises(InputError, match=r"differs from the recursion|in a higher degree"):
            program(LOADED, "inverse_dynamics", Options(records=(written(LOADED, made),)))
    genuine_one = written(LOADED, recursion)
    assert program(LOADED, "inverse_dynamics", Options(records=(genuine_one,))).operations


@pytest.mark.parametrize("op", ["sqrt", "exp", "tanh", "sign", "abs", "div"])
def test_nothing_times_what_has_no_value(op: str) -> None:
    """0 times a root of a negative number; the 0 is one only as a function."""
    forged = Forgery(genuine())
    nothing = lost_in_squares(forged, 1.0)
    below = forged.add("sub", forged.add("neg", forged.add("mul", QD, QD)), Fraction(1))
    args: tuple[Operand, ...] = (Fraction(1), QD) if op == "div" else (below,)
    check_refused(forged.program(forged.add("mul", nothing, forged.add(op, *args))))


def test_a_sign_of_what_is_nearly_known() -> None:
    """sgn(qd) - sgn(qd + 1e20 - 1e20): equal as functions, opposite near rest."""
    loaded_recursion = fast(LOADED)
    forged = Forgery(loaded_recursion)
    away = forged.add("sub", forged.add("add", QD, 1e20), 1e20)
    term = forged.add("mul", 4.0, forged.add("sub", forged.add("sign", QD), forged.add("sign", away)))
    with pytest.raises(InputError):
        program(LOADED, "inverse_dynamics", Options(records=(written(LOADED, forged.program(term)),)))


# --- sizes -----------------------------------------------------------------------------------------------


def test_long_records_are_refused_before_anything_is_calculated(monkeypatch: pytest.MonkeyPatch) -> None:
    """2.4 MB took 78 s."""
    many = Forgery(genuine())
    x: Operand = QD
    for k in range(20_000):
        x = many.add("add", x, Fraction(k + 1, 10**9 + 2 * k + 1))
    digits = Forgery(genuine())
    for k in range(20):
        x = digits.add("mul", Fraction(10**990 + 2 * k + 1, 3**2000 + k), QD)
    records = [written(ROBOT, forged.program(x)) for forged in (many, digits)]

    def never(*_: object) -> None:
        raise AssertionError("it was evaluated")

    monkeypatch.setattr("robodyn.kernels.rigid_programs.validated", never)
    for record, what in zip(records, ("operations", "digits"), strict=True):
        for function in ("inverse_dynamics", "gravity", "bias"):
            with pytest.raises(InputError, match=f"{what}.* where .*the recursion ha"):
                program(ROBOT, function, Options((function,), records=(record,)))
