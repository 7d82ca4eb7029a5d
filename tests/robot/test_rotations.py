"""Rounding of what comes out of other frames."""

from __future__ import annotations

from fractions import Fraction

import pytest

from robodyn.robot.numbers import shortest
from robodyn.robot.parts import Placement
from robodyn.robot.rotations import SAME, about_x, about_z, placement, product, tidy, twist_of
from robodyn.robot.values import angle


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
    assert shortest(float(tidy(x, size))) == tidy(x, size)


def test_sums_of_what_files_write_are_exact() -> None:
    x = Fraction("0.29730017006063564") + Fraction("0.2435")
    assert shortest(float(x)) != x
    assert tidy(x, 1.0) == x
    assert tidy(x / 10, 1.0) == shortest(float(x / 10))  # 18 places


def test_large_numbers_are_doubles() -> None:
    x = Fraction("155955586838.205212692512")
    assert tidy(x, 1e12) == shortest(float(x))


@pytest.mark.parametrize(
    "rpy", [("0.1", "-0.2", "0.3"), ("0", "1.5707963267948966", "2"), ("3", "-1.57", "-3")]
)
def test_a_placement_is_its_rotation_whatever_its_angles(rpy: tuple[str, str, str]) -> None:

    zero = Fraction(0)
    roll, pitch, yaw = (angle(Fraction(text)) for text in rpy)
    R = Placement((zero, zero, zero), (roll, pitch, yaw)).rotation
    again = placement(R, (zero, zero, zero), 1.0)
    assert again is not None
    for row, other in zip(R, again.rotation, strict=True):
        assert [float(x) for x in row] == pytest.approx([float(x) for x in other], abs=3e-16)
    assert placement(SAME, (zero, zero, zero), 1.0) is None


@pytest.mark.parametrize("alpha", [1e-10, 1e-4, 0.5, 1.5, 3.1, 3.14159])
def test_a_twist_is_its_rotation_however_near_to_parallel(alpha: float) -> None:

    first, middle, last = (angle(Fraction(x)) for x in (0.7, alpha, -2.1))
    R = product(about_z(first), product(about_x(middle), about_z(last)))
    twist = twist_of(R, 1e-11)
    assert not twist.parallel
    again = product(about_z(twist.phi), product(about_x(twist.alpha), about_z(twist.theta)))
    for row, other in zip(R, again, strict=True):
        assert [float(x) for x in row] == pytest.approx([float(x) for x in other], abs=5e-16)
