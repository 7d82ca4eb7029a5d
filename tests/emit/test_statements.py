"""Statements and literals of the emitted languages."""

from __future__ import annotations

import re
import struct
from collections.abc import Sequence
from fractions import Fraction

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from emit.kernels import in_single, made
from robodyn import InputError, Options
from robodyn.emit.c_syntax import c_spelling
from robodyn.emit.languages.fortran import LANGUAGE as FORTRAN
from robodyn.emit.spelling import shortest
from robodyn.emit.statements import LARGE, Apply, Body, statements
from robodyn.ir import Input, Label, Operation, Program
from robodyn.kernels.generate import generate
from robodyn.robot import read_text

# --- statements -------------------------------------------------------------------------------------------

Q, QD, X = Input("q", 0), Input("qd", 0), Input("x", None)


def spelt(*operations: Operation, single: bool = False) -> tuple[str, str]:
    """The last operation in C and in Fortran, all others written into it."""
    *_, expression = statements(Program(operations, (("t", (len(operations) - 1,)),))).statements
    return (
        c_spelling(single=single).text(expression.expression),
        FORTRAN.spelling(single).text(expression.expression),
    )


@pytest.mark.parametrize(
    ("operations", "text"),
    [
        ([Operation("add", (Q, QD)), Operation("mul", (0, X))], "(q[0] + qd[0])*p->x"),
        ([Operation("mul", (Q, QD)), Operation("add", (X, 0))], "p->x + q[0]*qd[0]"),
        ([Operation("sub", (Q, QD)), Operation("sub", (X, 0))], "p->x - (q[0] - qd[0])"),
        ([Operation("sub", (Q, QD)), Operation("sub", (0, X))], "q[0] - qd[0] - p->x"),
        ([Operation("mul", (Q, QD)), Operation("mul", (X, 0))], "p->x*(q[0]*qd[0])"),
        ([Operation("div", (Q, QD)), Operation("div", (X, 0))], "p->x / (q[0] / qd[0])"),
        ([Operation("mul", (Q, QD)), Operation("neg", (0,))], "-(q[0]*qd[0])"),
        ([Operation("neg", (Q,)), Operation("mul", (0, X))], "-q[0]*p->x"),
        ([Operation("neg", (Q,)), Operation("mul", (X, 0))], "p->x*(-q[0])"),
        ([Operation("neg", (Q,)), Operation("sub", (X, 0))], "p->x - (-q[0])"),
        ([Operation("neg", (Q,)), Operation("neg", (0,))], "-(-q[0])"),
        ([Operation("mul", (Fraction(-1, 2), Q)), Operation("add", (X, 0))], "p->x + (-0.5*q[0])"),
        ([Operation("mul", (Fraction(-1, 2), Q)), Operation("sub", (0, X))], "-0.5*q[0] - p->x"),
        ([Operation("sub", (Q, Fraction(-3))), Operation("neg", (0,))], "-(q[0] - (-3.0))"),
        ([Operation("tanh", (Q,)), Operation("mul", (0, X))], "tanh(q[0])*p->x"),
        ([Operation("sqrt", (Q,)), Operation("neg", (0,))], "-sqrt(q[0])"),
    ],
)  # fmt: skip
def test_parentheses_keep_the_order_of_operations(operations: Sequence[Operation], text: str) -> None:
    c, fortran = spelt(*operations)
    assert c == text
    as_fortran = text.replace("p->", "p%").replace("q[0]", "q(1)").replace("qd[0]", "qd(1)")
    assert fortran == re.sub(r"(\d\.\d)", r"\1_rk", as_fortran)


def test_values_used_twice_and_labelled_ones_have_names() -> None:
    made_ = Program(
        (
            Operation("mul", (Q, Q)),
            Operation("add", (0, QD)),
            Operation("mul", (1, X), Label(2, "n", "z", negative=True)),
            Operation("add", (0, 2)),
        ),
        (("t", (3, 2)),),
    )
    body = statements(made_)
    assert [s.name for s in body.statements] == ["t1", "neg_n2_z", "t2"]
    assert body.statements[1].expression == Apply("mul", (Apply("add", ("t1", QD)), X))
    assert body.statements[1].heading == "link 2: moment through the joint, about the frame's origin [N m]"
    assert body.outputs == (("t", ("t2", "neg_n2_z")),)


def test_no_name_is_given_twice_not_even_in_capitals() -> None:
    labels = [Label(1, "n", "z"), Label(1, "N", "z"), Label(1, "n", "z")]
    made_ = Program(tuple(Operation("neg", (Q,), label) for label in labels), (("t", (0, 1, 2)),))
    assert [s.name for s in statements(made_).statements] == ["n1_z", "N1_z_2", "n1_z_3"]


def test_a_line_is_not_made_of_everything() -> None:
    operations = [Operation("add", (Q, QD))] + [Operation("add", (k, X)) for k in range(40)]
    body = statements(Program(tuple(operations), (("t", (40,)),)))
    assert len(body.statements) > 3


# --- large functions --------------------------------------------------------------------------------

OFTEN, RARE, SHORT = Fraction("0.123456789012"), Fraction("0.987654321098"), Fraction("0.25")


def _large(*more: Operation) -> Program:
    """``more``, and a sum of products with numbers, long enough to be told shortly."""
    n = len(more)
    operations = [
        *more,
        Operation("mul", (RARE, Q)),
        Operation("mul", (SHORT, Q)),
        Operation("add", (n, n + 1)),
    ]
    while len(operations) <= LARGE:
        last = len(operations) - 1
        operations += [Operation("mul", (OFTEN, last)), Operation("mul", (SHORT, last))]
        operations.append(Operation("add", (last + 1, last + 2), Label(1 + last % 2, "fc", "x")))
    return Program(tuple(operations), (("tau", (len(operations) - 1,)),))


def _text(body: Body) -> str:
    spelling = c_spelling(single=False)
    return "\n".join(f"{s.name} = {spelling.text(s.expression)}" for s in body.statements)


def test_a_long_number_that_is_read_often_is_written_once() -> None:
    program = _large()
    body = statements(program, concise=True)
    first, second = body.statements[:2]
    assert (first.name, first.expression, first.heading) == ("k1", OFTEN, "numbers that are read often")
    assert isinstance(second.expression, Apply)
    text = _text(body)
    assert text.count("0.123456789012") == 1
    assert text.count("k1*") == sum(OFTEN in operation.args for operation in program.operations)
    assert "0.987654321098*q[0]" in text, "what is read once stands where it is read"
    assert "0.25*" in text, "a name would be no shorter"


@pytest.mark.parametrize("way", ["asked for", "small"])
def test_else_numbers_stand_where_they_are_read(way: str) -> None:
    program = _large()
    if way == "small":
        program = Program(program.operations[: LARGE - 1], (("tau", (LARGE - 2,)),))
    text = _text(statements(program, concise=way == "small"))
    assert text.count("0.123456789012") > 4
    assert "k1" not in text


def test_arguments_of_sines_are_written_whole() -> None:
    angle = [Operation("add", (Q, OFTEN)), Operation("cos", (0,))]
    body = statements(_large(*angle), concise=True)
    assert [s.expression for s in body.statements if s.angle] == [Apply("add", (Q, OFTEN))]


def test_headings_explain_a_quantity_once() -> None:
    headings = [s.heading for s in statements(_large(), concise=True).statements if s.heading]
    assert headings[1] == "link 1: force that moves the link [N]"
    assert set(headings[2:]) == {"link 1: force that moves the link", "link 2: force that moves the link"}


# --- literals ---------------------------------------------------------------------------------------------


@settings(deadline=None, max_examples=300)
@given(st.floats(allow_nan=False, allow_infinity=False, allow_subnormal=False))
def test_a_double_is_written_in_the_fewest_digits_that_give_it_back(x: float) -> None:
    text = shortest(Fraction(x), single=False)
    assert text == repr(x + 0.0 if x else 0.0)
    assert float(text) == x


@settings(deadline=None, max_examples=300)
@given(st.floats(allow_nan=False, allow_infinity=False, allow_subnormal=False, width=32))
def test_a_float_is_written_in_digits_that_give_it_back(x: float) -> None:
    text = shortest(Fraction(x), single=True)
    assert struct.pack("f", float(text)) == struct.pack("f", x + 0.0 if x else 0.0)
    digits = re.sub(r"e.*|[-.]", "", text).strip("0")
    assert len(digits) <= 9
    assert len(digits) <= len(re.sub(r"e.*|[-.]", "", repr(x)).strip("0"))


def nearest_float(x: Fraction) -> Fraction:
    """The single-precision number nearest to ``x`` (a normal one), ties to even, by integers."""
    exponent = 0
    while abs(x) >= 1 << 24:
        x, exponent = x / 2, exponent + 1
    while 0 < abs(x) < 1 << 23:
        x, exponent = x * 2, exponent - 1
    return Fraction(round(x)) * Fraction(2) ** exponent


@settings(deadline=None, max_examples=200)
@given(st.fractions(min_value=1, max_value=10**6, max_denominator=10**30))
@example(
    1 + Fraction(1, 2**24) + Fraction(1, 2**60)
)  # above the middle of two floats, by less than a double tells
@example(1 + Fraction(3, 2**24) - Fraction(1, 2**60))
def test_a_number_is_rounded_to_float_once(x: Fraction) -> None:
    text = shortest(x, single=True)
    assert nearest_float(Fraction(text)) == nearest_float(x)


def test_what_a_literal_looks_like() -> None:
    for value, double, single in (
        (Fraction(1), "1.0", "1.0f"),
        (Fraction(-1, 2), "-0.5", "-0.5f"),
        (Fraction(1, 3), "0.3333333333333333", "0.33333334f"),
        (Fraction(1, 10), "0.1", "0.1f"),
        (Fraction(10) ** 22, "1e+22", "1e+22f"),
        (Fraction(1, 10**7), "1e-07", "1e-07f"),
    ):
        assert c_spelling(single=False).number(value) == double
        assert c_spelling(single=True).number(value) == single
        assert FORTRAN.spelling(False).number(value) == f"{double}_rk"


@pytest.mark.parametrize(("mass", "scalar"), [("1e39", "float"), ("-3.5e38", "float"), ("1e200", "double")])
def test_constants_that_do_not_fit_are_bad_input(mass: str, scalar: str) -> None:
    com = "1e200" if scalar == "double" else "1"
    robot = read_text(
        f"name: heavy\nlinks: [{{joint: revolute, mass: {mass.lstrip('-')}, com: [{com}, 0, 0], "
        f"inertia: {{zz: 1}}}}]\ngravity: [0, {'-' * mass.startswith('-')}9.81, 0]",
        warn=lambda _: None,
    )
    with pytest.raises(
        InputError, match=f"a number that follows .* does not fit into a {scalar}; found about 1e"
    ):
        generate(robot, Options(scalar=scalar)).files()  # type: ignore[arg-type]
    if scalar == "float":
        assert generate(robot).files()
        with pytest.raises(InputError, match="--scalar double"):
            generate(robot, Options(scalar="float")).files(("fortran",))


def test_options_and_languages_must_be_known() -> None:
    for wrong, message in (
        ({"scalar": "single"}, "unknown scalar 'single'"),
        (
            {"optimize": "fst"},
            "unknown level of optimisation 'fst'; expected one of none, fast.*; did you mean 'fast'",
        ),
        ({"trig": "given_"}, "did you mean 'given'"),
        ({"engine": "graphs"}, "did you mean 'graph'"),
        ({"formulation": "newton_euler_"}, "did you mean"),
        ({"functions": ("gravit",)}, "did you mean 'gravity'"),
        ({"functions": ()}, "no function asked for"),
        ({"functions": ("gravity", "gravity")}, "twice"),
    ):
        with pytest.raises(InputError, match=message):
            Options(**wrong)
    with pytest.raises(InputError, match=r"unknown language 'fortan'.*did you mean 'fortran'"):
        made("lift").files(("fortan",))
    assert set(in_single(made("lift")).files(("fortran",))) == {"lift.f90"}


@pytest.mark.parametrize(("mass", "scalar"), [("1e-46", "float"), ("1e-39", "float"), ("1e-320", "double")])
def test_a_number_is_not_lost_below_the_smallest(mass: str, scalar: str) -> None:
    """A subnormal constant has lost digits, and gfortran refuses it; zero would be a wrong torque."""
    with pytest.raises(InputError, match=rf"does not fit into a {scalar}; found about 1e-"):
        shortest(Fraction(mass), single=scalar == "float")
