"""The number parser against Fraction arithmetic. What is no number stands in ``tests/refusals``."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from robodyn.robot import numbers
from robodyn.robot.values import PI, Affine, Value, parameter


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0", Fraction(0)),
        ("17.4", Fraction(174, 10)),
        ("0.4318", Fraction(4318, 10000)),
        ("1.", Fraction(1)),
        (".5", Fraction(1, 2)),
        ("+5", Fraction(5)),
        ("-0.0934", Fraction(-934, 10000)),
        ("1e-3", Fraction(1, 1000)),
        ("1E3", Fraction(1000)),
        ("2.5e+2", Fraction(250)),
        ("1e-300", Fraction(1, 10**300)),
        ("0e400", Fraction(0)),
        ("010", Fraction(10)),  # no octal numbers
        ("17*0.0254", Fraction(17 * 254, 10000)),
        ("1/3", Fraction(1, 3)),
        ("1/3*3", Fraction(1)),
        ("2 - 3 - 4", Fraction(-5)),
        ("2 - (3 - 4)", Fraction(3)),
        ("8/4/2", Fraction(1)),
        ("2 + 3*4", Fraction(14)),
        ("-(2 + 3)*-4", Fraction(20)),
        ("--5", Fraction(5)),
        ("- + - -1", Fraction(-1)),
        ("  ( 1 )\t", Fraction(1)),
        ("1e300*1e300/1e300", Fraction(10**300)),  # only the result must fit
        ("pi/pi", Fraction(1)),
        ("0*pi", Fraction(0)),
    ],
)
def test_arithmetic_is_exact(text: str, value: Fraction) -> None:
    assert numbers.parse_number(text) == value


def test_pi_is_rounded_outside_of_angles_and_exact_in_them() -> None:
    assert numbers.parse_number("-pi/2") == Fraction(repr(-math.pi / 2))
    read = numbers.parse("-pi/2")
    assert read.has_pi
    assert read.value == -PI / 2
    assert abs(PI - Fraction("3.14159265358979323846264338327950288419716939937510")) < Fraction(1, 10**49)


def test_names_where_they_are_allowed() -> None:
    assert numbers.parse("m_tool", names=True).value == parameter("m_tool")
    assert numbers.parse("-m_tool", names=True).value == -parameter("m_tool")
    assert numbers.parse("0.35 + 2*i_rotor/4 - (a - b)", names=True).value == Affine(
        Fraction(35, 100), (("a", Fraction(-1)), ("b", Fraction(1)), ("i_rotor", Fraction(1, 2)))
    )
    assert numbers.parse("m - m + 1", names=True).value == 1
    assert numbers.parse("m_tool + m2", names=True).names == (("m_tool", 0), ("m2", 9))


def test_names_are_refused_elsewhere() -> None:
    with pytest.raises(numbers.NumberError, match="a name cannot stand here"):
        numbers.parse("m_tool")


_DECIMALS = st.decimals(min_value=-1000, max_value=1000, places=4)


@st.composite
def _expressions(draw: st.DrawFn, depth: int = 3) -> tuple[str, Fraction]:
    """The text of an arithmetic expression, and its value by Fraction."""
    if depth == 0 or draw(st.booleans()):
        number = draw(_DECIMALS)
        return (f"{number}" if number >= 0 else f"({number})"), Fraction(str(number))
    left, x = draw(_expressions(depth=depth - 1))
    right, y = draw(_expressions(depth=depth - 1))
    sign = draw(st.sampled_from("+-*/" if y else "+-*"))
    value = {"+": x + y, "-": x - y, "*": x * y, "/": x / y if y else x}[sign]
    space = draw(st.sampled_from(["", " "]))
    return f"({left}{space}{sign}{space}{right})", value


@given(_expressions())
def test_arithmetic_agrees_with_fractions(expression: tuple[str, Fraction]) -> None:
    text, value = expression
    if len(text) <= numbers.LENGTH:
        assert numbers.parse_number(text) == value


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_every_double_reads_back(x: float) -> None:
    assert float(numbers.parse_number(repr(x))) == x
    assert numbers.shortest(x) == numbers.parse_number(repr(x))


@given(st.text(max_size=60) | st.text("0123456789.eE+-*/() pi_m", max_size=60))
def test_any_text_is_a_number_or_a_number_error(text: str) -> None:
    for names in (False, True):
        try:
            read = numbers.parse(text, names=names)
        except numbers.NumberError as error:
            position = error.position
        else:
            position = 0
            assert all(math.isfinite(float(part)) for part in _parts(read.value))
        assert 0 <= position <= len(text)


def _parts(value: Value) -> list[Fraction]:
    return [value] if isinstance(value, Fraction) else [value.constant, *(c for _, c in value.terms)]
