"""A robot that is written reads back as the same robot."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import partial

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from robodyn.robot import (
    Comparison,
    Gear,
    Inertia,
    Joint,
    Limits,
    Link,
    Robot,
    bundled_names,
    fold_rotor,
    load,
    read_text,
    to_yaml,
)  # fmt: skip
from robodyn.robot.model import Placement
from robodyn.robot.values import PI, ZERO, Value, angle, parameter
from robodyn_testing import exactly

_NAMES = st.sampled_from(["m_tool", "x1", "i_rotor", "fv"])
_DECIMALS = st.decimals(-1000, 1000, allow_nan=False, places=5).map(lambda d: Fraction(str(d)))
_DOUBLES = st.floats(allow_nan=False, allow_infinity=False).map(lambda x: Fraction(repr(x)))
_RATIONALS = st.builds(Fraction, st.integers(-(10**9), 10**9), st.integers(1, 10**9))
_NUMBERS = st.one_of(st.just(ZERO), st.integers(-5, 5).map(Fraction), _DECIMALS, _DOUBLES, _RATIONALS)
_POSITIVE = _NUMBERS.map(abs).filter(bool)
_ANGLES = st.one_of(
    st.just(angle(ZERO)),
    st.integers(-6, 6).map(lambda k: angle(k * PI / 2)),
    st.builds(lambda k, n: angle(k * PI / n), st.integers(-40, 40), st.integers(1, 360)),
    st.decimals(-7, 7, allow_nan=False, places=6).map(lambda d: angle(Fraction(str(d)))),
    st.builds(lambda k, x: angle(k * PI / 3 + x), st.integers(-6, 6), _RATIONALS.map(lambda x: x % 1)),
)
_PLACEMENTS = st.none() | st.builds(
    Placement, st.tuples(_NUMBERS, _NUMBERS, _NUMBERS), st.tuples(_ANGLES, _ANGLES, _ANGLES)
)
_TEXTS = st.text(st.characters(blacklist_categories=("Cc", "Cf", "Cs", "Zl", "Zp")), max_size=60).map(
    lambda text: " ".join(text.split())
)


@st.composite
def _values(draw: st.DrawFn) -> Value:
    value: Value = draw(_NUMBERS)
    for name in draw(st.lists(_NAMES, max_size=2)):
        value = value + parameter(name) * draw(st.integers(-9, 9).filter(bool) | _DECIMALS)
    return value


@st.composite
def _amounts(draw: st.DrawFn) -> Value:
    """Values that are not negative, or not known."""
    value = draw(_values())
    return abs(value) if isinstance(value, Fraction) else value


@st.composite
def _limits(draw: st.DrawFn) -> Limits:
    low, width = draw(_DECIMALS), draw(_DECIMALS.map(abs).filter(bool))
    position = draw(st.none() | st.just((low, low + width)))
    return Limits(position, *(draw(st.none() | _POSITIVE) for _ in range(3)))


_JOINTS = st.builds(
    Joint, st.sampled_from(["revolute", "prismatic"]), _ANGLES, _values(), _values(), _ANGLES, _amounts(),
    _amounts(), _amounts(), _limits(),
    st.sampled_from([None, Gear(Fraction(100)), Gear(Fraction(1, 3), Fraction(1, 7))]),
    st.just(ZERO) | _values(),
)  # fmt: skip


def _numbered(i: int, text: str) -> str:
    return f"{i} {text}".strip()


@st.composite
def _robots(draw: st.DrawFn) -> Robot:
    links = []
    for i in range(1, draw(st.integers(1, 3)) + 1):
        name = draw(st.just(f"link{i}") | _TEXTS.map(partial(_numbered, i)))
        links.append(draw(st.builds(
            Link, st.just(name), _JOINTS, _amounts(), st.tuples(_values(), _values(), _values()),
            st.builds(Inertia, *[_values()] * 6),
            st.sampled_from([None, "unknown", Fraction(1, 10), Fraction(1), Fraction(1, 3)]),
        )))  # fmt: skip
    return draw(st.builds(
        Robot, st.sampled_from(["arm", "yes", "e1", "R2D2"]), st.just(tuple(links)), _TEXTS, _TEXTS,
        st.tuples(_NUMBERS, _NUMBERS, _NUMBERS), st.none() | st.builds(Comparison, _TEXTS, _TEXTS),
        st.sampled_from(["motor", "link"]), st.none() | _POSITIVE, base=_PLACEMENTS, tool=_PLACEMENTS,
    ))  # fmt: skip


# A robot is some hundred draws: few examples are many numbers.
@settings(
    max_examples=25, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large], deadline=None
)
@given(_robots())
def test_what_is_written_reads_back(robot: Robot) -> None:
    text = to_yaml(robot)
    assert read_text(text, warn=lambda _: None) == robot
    assert to_yaml(read_text(text, warn=lambda _: None)) == text


@pytest.mark.parametrize("name", bundled_names())
def test_bundled_robots_are_written_and_read_back(name: str) -> None:
    robot = load(name, warn=lambda _: None)
    for one in (robot, fold_rotor(robot)):
        assert read_text(to_yaml(one), warn=lambda _: None) == one


def test_the_text_is_what_a_person_would_write() -> None:
    robot = read_text(
        "name: arm\ntitle: 'a \"title\"\\'\ngravity: [0, 0, -9.8]\nlinks:\n"
        "  - {joint: revolute, alpha: -90*pi/180, a: 17*0.0254, d: 1e-12, theta: pi/6,\n"
        "     mass: 2*3 + m_tool/2, com: [1/3, -x, 1e20], motor_inertia: 0.50, friction: {coulomb: 3},\n"
        "     confidence: 0.02, limits: {velocity: 3.0, position: [-pi, 1]}}\n"
        "  - {name: slide, joint: prismatic, theta: 3*pi/2, alpha: 0.3, gear: {ratio: 1/3}}\n"
        "friction_at_rest: smooth\ntorque_side: link\n"
    )
    assert (
        to_yaml(robot)
        == """\
name: arm
title: "a \\"title\\"\\\\"
gravity: [0, 0, -9.8]
links:
  - joint: revolute
    alpha: -pi/2
    a: 0.4318
    d: 1e-12
    theta: pi/6
    mass: 6 + 0.5*m_tool
    com: [1/3, -x, 1e20]
    motor_inertia: 0.5
    limits: {position: [-3.141592653589793, 1], velocity: 3}
    confidence: 0.02
    friction: {coulomb: 3}
  - name: "slide"
    joint: prismatic
    alpha: 0.3
    a: 0
    d: 0
    theta: 3*pi/2
    gear: {ratio: 1/3}
torque_side: link
friction_at_rest: {smooth: {velocity: 0.001}}
"""
    )


@pytest.mark.parametrize(
    ("confidences", "text"),
    [
        (("0.1", "0.1"), "links"),
        (("unknown", "unknown"), "confidence: unknown\nlinks:\n  - joint"),
        (("1/50", "1/50"), "confidence: 0.02\nlinks:\n  - joint"),
        (("unknown", "0.02"), "    confidence: unknown\n  - joint"),
        (("unknown", None), "    confidence: unknown\n  - joint"),
        ((None, None), "[0, 0, -9.81]\nlinks"),
    ],
)
def test_confidence_stands_at_the_top_where_all_links_share_it(
    confidences: tuple[str | None, ...], text: str
) -> None:
    links = ", ".join("{joint: revolute" + (f", confidence: {c}" if c else "") + "}" for c in confidences)
    robot = read_text(f"name: arm\nlinks: [{links}]")
    assert text in to_yaml(robot)
    assert to_yaml(robot).count("confidence") == (len(set(confidences) - {None}))
    assert read_text(to_yaml(robot)) == robot


def test_numbers_without_a_short_text_are_written_as_doubles() -> None:
    link = read_text("name: arm\nlinks: [{joint: revolute}]").links[0]
    long = Fraction(10**150 + 1, 3**300)
    robot = Robot("arm", (replace(link, mass=long, com=(Fraction(0.1), long * parameter("x") + long, ZERO)),))
    back = read_text(to_yaml(robot)).links[0]
    assert isinstance(back.mass, Fraction)
    assert float(back.mass) == float(long)
    assert back.com[0] == Fraction(0.1)  # 55 digits are short enough
    assert back.com[1] == back.mass * parameter("x") + back.mass


def test_the_rotor_folds_into_the_link() -> None:
    robot = read_text(
        "name: arm\nlinks:\n  - {joint: revolute, mass: 1, inertia: {xx: 1, zz: 0.25}, motor_inertia: 0.5}\n"
        "  - {joint: prismatic, mass: 2, com: [0, 0, 1], motor_inertia: 0.782}\n"
        "  - {joint: revolute, inertia: {zz: 1/4}, motor_inertia: j}\n",
        warn=lambda _: None,
    )
    first, second, third = fold_rotor(robot).links
    assert (first.mass, first.inertia) == (Fraction(1), Inertia(xx=Fraction(1), zz=Fraction(3, 4)))
    assert (second.mass, second.com, second.inertia) == (Fraction("2.782"), exactly(0, 0, 1), Inertia())
    assert third.inertia.zz == Fraction(1, 4) + parameter("j")
    assert all(link.joint.motor_inertia == ZERO for link in (first, second, third))
    assert fold_rotor(fold_rotor(robot)) == fold_rotor(robot)
