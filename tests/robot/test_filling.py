"""Run-time parameters get their values on the model, whatever they are called."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from dynamics.direct import exact_arm, values_of, with_named_numbers
from robodyn.errors import InputError
from robodyn.robot import Robot, load, read_text, to_yaml
from robodyn.robot.filling import parameter_values
from robodyn_testing import sampled
from robodyn_testing.random_effects import with_random_effects
from robodyn_testing.random_robots import random_robot

#: Names that are keys, words and axes of a description too.
ARM = """
name: length
title: mass at x
links:
  - name: mass
    joint: revolute
    a: LENGTH
    mass: MASS
    com: [X, 0.01, 0.02]
    inertia: {xx: 0.1, yy: 0.2, zz: 0.25, xy: XX}
    friction: {viscous: FRICTION}
    effects:
      - {effect: spring, stiffness: STIFFNESS, rest: X}
      - {effect: joint_elasticity, stiffness: STIFFNESS, damping: 0}
  - {joint: prismatic, d: 2*LENGTH + 0.1, mass: MASS + 1}
effects:
  - {effect: payload, mass: PAYLOAD, com: [X - 0.1, 0, LENGTH]}
"""
NUMBERS: dict[str, float] = {
    "LENGTH": 0.3, "MASS": 2.5, "X": -0.125, "XX": 1e-3, "FRICTION": 0.7, "STIFFNESS": 12.0, "PAYLOAD": 1e-20,
}  # fmt: skip


def _arm(words: Mapping[str, Any]) -> Robot:
    text = ARM
    for key in sorted(words, key=len, reverse=True):
        text = text.replace(key, str(words[key]))
    return read_text(text, warn=lambda _: None)


NAMED = _arm({key: key.lower() for key in NUMBERS})
VALUES = {key.lower(): value for key, value in NUMBERS.items()}


def test_names_that_are_keys_of_the_description() -> None:
    assert NAMED.at(VALUES) == _arm(NUMBERS)
    assert NAMED.at({name: Fraction(str(value)) for name, value in VALUES.items()}) == _arm(NUMBERS)
    assert NAMED.at({name: np.float64(value) for name, value in VALUES.items()}) == _arm(NUMBERS)
    assert not NAMED.at(VALUES).parameters
    assert list(parameter_values(NAMED, VALUES).items()) == [
        (name, VALUES[name]) for name in NAMED.parameters
    ]


@pytest.mark.parametrize("seed", range(6))
def test_every_number_comes_back(seed: int) -> None:
    robot = exact_arm(seed)
    named = with_named_numbers(robot)
    assert named != robot
    assert named.at({leaf.array: value for leaf, value in values_of(named, robot).items()}) == robot


@pytest.mark.parametrize("seed", sampled(range(30), every=5))
def test_effects_are_filled_as_the_reader_reads_them(seed: int) -> None:
    """Against the reader, on texts in which the names (``e1_stiffness`` and so on) are no other word."""
    named = with_random_effects(random_robot(seed), seed, share=0.4, names=0.5)
    values = {name: Fraction(k % 16 + 1, 8) for k, name in enumerate(named.parameters)}
    text = re.sub(r"\w+", lambda word: str(values.get(word.group(), word.group())), to_yaml(named))
    expected: Robot | None
    try:
        expected = read_text(text, warn=lambda _: None)
    except InputError:
        expected = None
    try:
        assert named.at(values) == expected
    except InputError:
        assert expected is None


def test_a_robot_without_parameters_is_itself() -> None:
    robot = load("ur5")
    assert robot.at({}) is robot


def test_the_file_of_a_robot_stays(tmp_path: Path) -> None:
    (tmp_path / "arm.yaml").write_text("name: arm\nlinks: [{joint: revolute, mass: m}]\n")
    robot = load(str(tmp_path / "arm.yaml"))
    assert robot.at({"m": 2}).file == robot.file is not None


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"mas": 1}, "length has no such run-time parameter; found mas; expected length, mass, x, xx"),
        ({"length": None}, "run-time parameters without values; found no length; expected a number for each"),
        (
            {"x": math.nan},
            "the run-time parameter x is not a number; found nan; expected a finite",
        ),
        ({"x": -math.inf}, "found -inf"),
        ({"x": "two"}, "found 'two'; expected a finite number within double"),
        ({"x": 10**400}, "found 1000"),
        ({"mass": -2}, "length: link 1: mass is negative; found -2 kg with mass = -2; expected 0 kg or more"),
        ({"friction": -1.0}, "link 1: viscous is negative; found -1 N m s/rad with friction = -1"),
        (
            {"stiffness": -3},
            "joint 1: joint_elasticity: stiffness is not positive; found -3 N m/rad with",
        ),
        ({"payload": -3}, "length: payload: mass is negative; found -3 kg with payload = -3"),
        ({"length": 1.7e308}, "link 2: d is beyond double; found more than 1e308 m with length = 1.7e+308"),
    ],
)
def test_what_does_not_fit_is_refused(change: dict[str, Any], message: str) -> None:
    values: Any = {name: value for name, value in {**VALUES, **change}.items() if value is not None}
    for fill in (NAMED.at, lambda parameters: parameter_values(NAMED, parameters)):
        with pytest.raises(InputError) as caught:
            fill(values)
        assert message in str(caught.value)
        assert caught.value.exit_code == 2


def test_values_that_contradict_each_other() -> None:
    """What the reader refuses between two numbers is refused where one of them is a parameter."""
    text = (
        "name: arm\nlinks:\n  - joint: revolute\n    mass: 1\n"
        "    effects: [{effect: stribeck_friction, level: 2, static: peak, velocity: 0.1}]\n"
    )
    robot = read_text(text)
    assert robot.at({"peak": 3}).effects == read_text(text.replace("peak", "3")).effects
    with pytest.raises(InputError, match=r"stribeck_friction: static is .*; found peak = 1; "):
        robot.at({"peak": 1})
