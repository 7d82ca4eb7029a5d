"""Numbers that are known only at run time give exactly what the same numbers give when written in."""

from __future__ import annotations

from fractions import Fraction

import pytest

from ir.programs import Point, exactly
from robodyn import Options, program
from robodyn.ir import Input
from robodyn.robot import Robot, read_text
from robodyn_testing import covering, sampled
from robodyn_testing.functions import OF_ANY_ARM

TOOL = """
name: gripper
links:
  - {joint: revolute, mass: 3, com: [0.1, 0, 0.2], inertia: {xx: 0.1, yy: 0.2, zz: 0.25}}
  - {joint: revolute, alpha: pi/2, a: 0.3, mass: 2, com: [0.2, 0.1, 0.1], inertia: {xx: XX, zz: 0.1}}
  - joint: prismatic
    alpha: 0.7
    a: A
    d: D
    mass: MASS
    com: [0.2, COM, -0.05]
    inertia: {xx: XX, yy: 0.02, zz: 0.03, xy: XY}
    motor_inertia: MOTOR
    friction: {viscous: VISCOUS, coulomb: COULOMB}
"""
NUMBERS = {
    "MASS": "2.5", "COM": "0.03", "XX": "0.011", "XY": "0.002", "MOTOR": "1.1", "VISCOUS": "0.7",
    "COULOMB": "1.9", "A": "0.31", "D": "-0.12",
}  # fmt: skip
NAMES = {key: f"{key.lower()}_tool" for key in NUMBERS}


def filled(words: dict[str, str]) -> Robot:
    text = TOOL
    for key in sorted(words, key=len, reverse=True):
        text = text.replace(key, words[key])
    return read_text(text, warn=lambda _: None)


@pytest.mark.parametrize(("regroup", "function"), sampled(covering([True, False], OF_ANY_ARM), every=5))
def test_every_kind_of_number_may_be_a_name(function: str, regroup: bool) -> None:
    named, plain = filled(NAMES), filled(NUMBERS)
    assert sorted(named.parameters) == sorted(NAMES.values())
    numbers = {Input(NAMES[key], None): Fraction(text) for key, text in NUMBERS.items()}
    options = Options(regroup=regroup)
    made = program(named, function, options)
    assert exactly(made, Point(1), numbers) == exactly(program(plain, function, options), Point(1))
    if function == "inverse_dynamics":
        assert set(numbers) <= set(made.inputs())


def test_arithmetic_with_names() -> None:
    words = dict(NUMBERS, MASS="2*m + 0.5", COM="-c", XX="i/4 + 3*j - 1")
    named = filled(words)
    assert named.parameters == ("i", "j", "m", "c")  # base to tip, as in the struct
    numbers = {"m": Fraction(1), "c": Fraction("-0.03"), "i": Fraction("4"), "j": Fraction("0.011") / 3}
    found = exactly(
        program(named, "inverse_dynamics"), Point(2), {Input(k, None): v for k, v in numbers.items()}
    )
    assert found == exactly(program(filled(NUMBERS), "inverse_dynamics"), Point(2))
