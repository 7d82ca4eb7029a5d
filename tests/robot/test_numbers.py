"""The number parser against Fraction arithmetic (what is no number stands in ``tests/refusals``), and the
rounding of what comes out of other frames."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from robodyn.robot import numbers
from robodyn.robot.parts import Placement, Rows
from robodyn.robot.rotations import SAME, about_x, about_z, placement, product, tidy, twist_of
from robodyn.robot.values import PI, Affine, Value, angle, parameter


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0", 0), ("17.4", "17.4"), ("1.", 1), (".5", "1/2"), ("+5", 5), ("-0.0934", "-0.0934"),
        ("1e-3", "1/1000"), ("1E3", 1000), ("2.5e+2", 250), ("1e-300", "1e-300"), ("0e400", 0),
        ("010", 10),  # no octal numbers
        ("17*0.0254", "0.4318"), ("1/3", "1/3"), ("1/3*3", 1), ("2 - 3 - 4", -5), ("2 - (3 - 4)", 3),
        ("8/4/2", 1), ("2 + 3*4", 14), ("-(2 + 3)*-4", 20), ("--5", 5), ("- + - -1", -1), ("  ( 1 )\t", 1),
        ("1e300*1e300/1e300", 10**300),  # only the result must fit
        ("pi/pi", 1), ("0*pi", 0),
    ],
)  # fmt: skip
def test_arithmetic_is_exact(text: str, value: int | str) -> None:
    assert numbers.parse_number(text) == Fraction(value)


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


# --- rounding ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("x", "size", "expected"),
    [
        (Fraction("0.28614999999999996"), 1.3, "0.28614999999999996"),  # as a file may state it
        (Fraction("0.286149999999999963"), 1.3, "0.28615"),
        (Fraction(0.1) + Fraction(0.2), 1.0, "0.3"),
        (Fraction("0.123456789012345678"), 1.0, "0.12345678901234568"),
        (Fraction("3e-13"), 1.0, "0"),
        (Fraction("3e-13"), 1e-3, "3e-13"),
        (Fraction(1, 3), 1.0, "0.3333333333333333"),
        (Fraction("12345678901.1234"), 1e12, "12345678901.1234"),
    ],
)
def test_noise_goes_and_digits_stay(x: Fraction, size: float, expected: str) -> None:
    assert tidy(x, size) == Fraction(expected)
    assert numbers.shortest(float(tidy(x, size))) == tidy(x, size)


def test_sums_of_what_files_write_are_exact_and_large_numbers_are_doubles() -> None:
    x, large = Fraction("0.29730017006063564") + Fraction("0.2435"), Fraction("155955586838.205212692512")
    assert numbers.shortest(float(x)) != x
    assert tidy(x, 1.0) == x
    assert tidy(x / 10, 1.0) == numbers.shortest(float(x / 10))  # 18 places
    assert tidy(large, 1e12) == numbers.shortest(float(large))


def assert_same(R: Rows, other: Rows, within: float) -> None:
    for row, again in zip(R, other, strict=True):
        assert [float(x) for x in row] == pytest.approx([float(x) for x in again], abs=within)


@pytest.mark.parametrize(
    "rpy", [("0.1", "-0.2", "0.3"), ("0", "1.5707963267948966", "2"), ("3", "-1.57", "-3")]
)
def test_a_placement_is_its_rotation_whatever_its_angles(rpy: tuple[str, str, str]) -> None:
    zero = Fraction(0)
    roll, pitch, yaw = (angle(Fraction(text)) for text in rpy)
    R = Placement((zero, zero, zero), (roll, pitch, yaw)).rotation
    again = placement(R, (zero, zero, zero), 1.0)
    assert again is not None
    assert_same(R, again.rotation, 3e-16)
    assert placement(SAME, (zero, zero, zero), 1.0) is None


@pytest.mark.parametrize("alpha", [1e-10, 1e-4, 0.5, 1.5, 3.1, 3.14159])
def test_a_twist_is_its_rotation_however_near_to_parallel(alpha: float) -> None:
    first, middle, last = (angle(Fraction(x)) for x in (0.7, alpha, -2.1))
    R = product(about_z(first), product(about_x(middle), about_z(last)))
    twist = twist_of(R, 1e-11)
    assert not twist.parallel
    again = product(about_z(twist.phi), product(about_x(twist.alpha), about_z(twist.theta)))
    assert_same(R, again, 5e-16)
