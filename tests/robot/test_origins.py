"""Where numbers come from: read from a description, carried along, written back, shown."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest

from robodyn import load
from robodyn.robot import Joint, Link, bundled_names, read_text, to_yaml
from robodyn.robot.account import Origins, origins_in_words, origins_to_dicts
from robodyn.robot.values import ZERO, angle

ARM = """name: arm
{top}links:
  - {{joint: revolute, mass: 2, com: [0.1, 0, 0], inertia: {{zz: 0.1}}, friction: {{viscous: 1}}{first}}}
  - {{joint: revolute, a: 0.3, limits: {{velocity: 2}}{second}}}
"""


def described(top: str = "", first: str = "", second: str = "") -> str:
    return ARM.format(top=top and f"{top}\n", first=first and f", {first}", second=second and f", {second}")


def test_what_is_left_out_is_absent() -> None:
    first, second = read_text(described()).links
    assert first.origins == Origins(geometry="absent", friction="stated")
    assert second.origins == Origins(mass="absent", com="absent", inertia="absent", limits="stated")


@pytest.mark.parametrize(
    ("top", "first", "origins"),
    [
        ("origin: synthetic", "", ("synthetic", "synthetic", "synthetic")),
        ("origin: {inertial: measured}", "", ("measured", "measured", "stated")),
        ("origin: {inertial: measured}", "origin: {friction: assumed}", ("measured", "measured", "assumed")),
        ("origin: {inertial: measured}", "origin: stated", ("stated", "stated", "stated")),
        ("confidence: unknown", "", ("assumed", "assumed", "stated")),
        ("confidence: unknown", "confidence: 0.1", ("stated", "stated", "stated")),
        ("", "confidence: unknown", ("assumed", "assumed", "stated")),
        ("confidence: unknown\norigin: {inertial: synthetic}", "", ("synthetic", "synthetic", "stated")),
    ],
)
def test_what_a_description_says_of_its_numbers(top: str, first: str, origins: tuple[str, ...]) -> None:
    robot = read_text(described(top, first))
    read = robot.links[0].origins
    assert (read.mass, read.inertia, read.friction) == origins
    assert robot.links[1].origins.mass == "absent", "no word makes a number of nothing"
    again = read_text(to_yaml(robot))
    assert [link.origins for link in again.links] == [link.origins for link in robot.links]


def test_friction_may_be_an_effect() -> None:
    effect = "effects: [{effect: stribeck_friction, level: 1, static: 2, velocity: 0.1}]"
    robot = read_text(described(second=effect))
    assert robot.links[1].origins.friction == "stated"


def test_a_number_that_is_there_is_not_absent() -> None:
    _, bare = read_text(described()).links
    assert bare.origins.mass == "absent"
    assert replace(bare, mass=Fraction(1)).origins.mass == "stated"
    joint = Joint("revolute", angle(ZERO), ZERO, ZERO, angle(ZERO))
    assert Link("made", joint).origins == Origins(), "in Python, no mass is stated as one of 0"


def test_origins_do_not_make_robots_differ() -> None:
    assert read_text(described("origin: synthetic")) == read_text(described())


def test_for_people_and_for_json() -> None:
    robot = read_text(described("origin: {inertial: synthetic}", second="origin: measured"))
    assert origins_in_words(robot.links) == [
        "friction (joint 1): stated by the description",
        "geometry, limits (joint 2): measured on the arm",
        "mass, centre of mass, inertia (joint 1): synthetic (invented, not those of a real arm)",
        "rotor inertia; geometry (joint 1); mass, centre of mass, inertia, friction (joint 2): absent, taken "
        "as 0",
        "limits (joint 1): absent, so without bounds",
    ]
    assert origins_to_dicts(robot.links)[1] == {
        "link": "link2", "geometry": "measured", "mass": "absent", "com": "absent", "inertia": "absent",
        "motor_inertia": "absent", "friction": "absent", "limits": "measured",
    }  # fmt: skip


def test_bundled_arms_with_invented_numbers_say_so() -> None:
    """Those whose source says that numbers are drawn at random, and no others; their files too."""
    synthetic = set()
    for name in bundled_names():
        robot = load(name, warn=lambda _: None)
        drawn = "random" in robot.title + robot.source
        assert drawn == all(link.origins.inertia == "synthetic" for link in robot.links), name
        if drawn:
            synthetic.add(name)
    assert synthetic == {"iiwa", "rx90", "puma560_full", "stanford_full"}
