"""What is added to a model is what its text says afterwards, and the rest of the text stays."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import yaml

from diagnose.amending import HAND, F, amend, read
from robodyn.diagnose.amend.amend import Amendment, amended, amended_text, difference
from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError
from robodyn.robot import Inertia, Robot, bundled_names, bundled_text, read_text, to_yaml
from robodyn.robot.values import parameter
from robodyn_testing import representative
from robodyn_testing.random_effects import with_random_effects
from robodyn_testing.random_robots import random_robot

_LAWS = {"stribeck_friction", "asymmetric_friction", "presliding_hysteresis"}


def _random_amendments(rng: random.Random, robot: Robot) -> list[Amendment]:
    found = []
    while len(found) < rng.randint(1, 4):
        id = rng.choice(list(CATALOGUE))
        joint = None if CATALOGUE[id].level == "robot" else rng.randint(1, robot.n)
        drawn = with_random_effects(replace(robot, effects=()), rng.randrange(10**6), ids=[id], share=1)
        entries = drawn.effects_at(joint)
        if id == "gas_spring" and not entries:  # not at prismatic joints
            continue
        values: dict[str, Any] = {}
        for name, value in entries[0].settings if entries else ():
            if isinstance(value, Fraction):
                values[name] = float(value) * (1 + rng.random() * 1e-3)
            elif isinstance(value, (str, int)):
                values[name] = value
            elif name == "com":
                values |= {f"com_{axis}": float(x) for axis, x in zip("xyz", value, strict=True)}  # type: ignore[arg-type]
            elif isinstance(value, Inertia):
                values |= {axes: float(getattr(value, axes)) for axes in ("xx", "yy", "zz")}  # type: ignore[arg-type]
            elif name == "efficiency":
                values |= {"efficiency": value}
        if not values:  # those that the rigid arm takes up
            for p in CATALOGUE[id].parameters:
                if (p.kind == "number" and rng.random() < 0.7) or p.required:
                    values[p.name] = rng.uniform(0 if p.sign == "nonnegative" else -0.1, 0.3)
        if values and not any(p.required and p.name not in values for p in CATALOGUE[id].parameters):
            found.append(Amendment(id, joint, values))
    return found


def _in_blocks(text: str) -> str:
    return yaml.safe_dump(yaml.load(text, yaml.BaseLoader), default_flow_style=False, sort_keys=False)


def _in_flow(text: str) -> str:
    return yaml.safe_dump(yaml.load(text, yaml.BaseLoader), default_flow_style=True, sort_keys=False)


def _in_flow_of_links(text: str) -> str:
    head, _, links = text.partition("links:\n")
    body = yaml.load("links:\n" + links, yaml.BaseLoader)
    rest = {key: value for key, value in body.items() if key != "links"}
    rows = [yaml.safe_dump(row, default_flow_style=True, width=1e9, sort_keys=False) for row in body["links"]]
    tail = yaml.safe_dump(rest, default_flow_style=None, sort_keys=False) if rest else ""
    return head + "links:\n" + "".join(f"- {row}" for row in rows) + tail


def _as_on_windows(text: str) -> str:
    return "\ufeff" + text.rstrip("\n").replace("\n", "\r\n")


@pytest.mark.parametrize(
    "style",
    representative([str, _in_blocks, _in_flow, _in_flow_of_links, _as_on_windows], str, _in_flow_of_links),
)
def test_the_text_says_what_the_data_say(style: Callable[[str], str]) -> None:
    refused = 0
    for seed in range(24):
        rng = random.Random(seed)
        robot = random_robot(seed, joints=rng.randint(2, 4))
        text = style(to_yaml(with_random_effects(robot, seed, share=0.25, names=0.15)))
        amendments = _random_amendments(rng, robot)
        try:
            target = amended(read(text), amendments)
        except InputError:
            refused += 1  # two bodies with run-time masses have no sum
            continue
        new = amended_text(text, read(text), amendments, {0: "found"})
        assert read(new) == target
        assert "Written anew" not in new
        assert ("\r\n" in new) == ("\r\n" in text)
        assert new.count("\n") == new.count("\r\n") or "\r\n" not in text
    assert refused <= 4


@pytest.mark.parametrize("name", bundled_names())
def test_bundled_robots_keep_what_is_not_amended(name: str) -> None:
    text = bundled_text(name)
    robot = read(text)
    for seed in range(2):
        rng = random.Random(seed)
        amendments = _random_amendments(rng, robot)
        new = amend(text, *amendments, notes=dict.fromkeys(range(4), "found by a test"))
        assert "Written anew" not in new
        old = text.splitlines()
        gone = set(old) - set(new.splitlines())
        assert len(gone) <= 3 * robot.n * (len(amendments) > 0)
        assert not any(line.lstrip().startswith("#") for line in gone)
        assert text.count("#") <= new.count("#")


def test_a_hand_written_file_changes_where_it_must() -> None:
    new = amend(
        HAND,
        Amendment("viscous_friction", 1, {"coefficient": 0.25}),
        Amendment("stribeck_friction", 1, {"level": 0.5, "static": 1.5, "velocity": 0.05}),
        Amendment("inertial_error", 2, {"delta_mass": -0.125, "delta_xx": 0.01}),
        Amendment("torque_bias", 2, {"bias": -3}),
        Amendment("payload", None, {"mass": 1.5, "com_z": 0.1}),
        Amendment("rotor_inertia", 1, {"inertia": 0.3}),
        notes={0: "viscous +0.25", 1: "log 12ab\nscore 0.97", 3: "bias", 4: "load"},
    )
    assert (
        new
        == """\
# An arm   (kept: odd   spaces)
name: arm   # its name
links:   # base to tip
  # the first
  - joint: revolute   # J1
    mass: 2.50   # kg
    # viscous +0.25
    friction: {viscous: 1.25}   # N m s/rad, N m
    # between
    com: [0.1, 0, 0]   # m
    motor_inertia: 0.3
    # log 12ab
    # score 0.97
    effects:
      - {effect: stribeck_friction, level: 2.5, static: 3.5, velocity: 0.05}

  # bias
  - {joint: prismatic, mass: m_tool - 0.125, friction: {coulomb: 1}, inertia: {xx: 0.01}, \
effects: [{effect: torque_bias, bias: -3}]}   # J2
# load
effects:
  - {effect: payload, mass: 1.5, com: [0, 0, 0.1]}
# the end
"""
    )
    assert difference(HAND, HAND) == ""
    shown = difference(HAND, new).splitlines()
    assert shown[:2] == ["--- a/model.yaml", "+++ b/model.yaml"]
    assert "-    friction: {viscous: 1.0, coulomb: 2.0}   # N m s/rad, N m" in shown


_LISTED = """\
name: arm
gravity:
- 0
- 0
- -9.81   # down
links:
- joint: revolute
  effects:
  # of the drive
  - effect: coulomb_friction   # measured
    level: 2   # cold
  - effect: spring
    stiffness: 3   # N m/rad
- joint: revolute
  effects: [
    {effect: coulomb_friction, level: 1},  # old
    {effect: torque_bias, bias: 0.5},
  ]
- joint: revolute
  friction:
    coulomb: 4   # warm
effects:
- {effect: base_tilt, tilt_x: 0.01}
"""


def test_a_level_in_a_list_moves_into_the_law_of_friction() -> None:
    law = {"positive": 1.0, "negative": 0.5}
    new = amend(_LISTED, *(Amendment("asymmetric_friction", joint, law) for joint in (1, 2, 3)))
    assert (
        new
        == """\
name: arm
gravity:
- 0
- 0
- -9.81   # down
links:
- joint: revolute
  effects:
  # of the drive
  # measured
  # cold
  - effect: spring
    stiffness: 3   # N m/rad
  - {effect: asymmetric_friction, positive: 3, negative: 2.5}
- joint: revolute
  effects: [
      # old
    {effect: torque_bias, bias: 0.5}, {effect: asymmetric_friction, positive: 2, negative: 1.5},
  ]
- joint: revolute
  # warm
  effects:
    - {effect: asymmetric_friction, positive: 5, negative: 4.5}
effects:
- {effect: base_tilt, tilt_x: 0.01}
"""
    )


def test_a_tilt_turns_gravity_and_takes_the_place_of_the_one_before() -> None:
    new = amend(_LISTED, Amendment("base_tilt", None, {"tilt_y": -0.02}), notes={0: "tilted"})
    assert "base_tilt" not in new
    assert "# down" in new
    g = [float(x) for x in read(new).gravity]
    c, s, d, t = math.cos(0.01), math.sin(0.01), math.cos(0.02), -math.sin(0.02)
    assert np.allclose(g, [t * -9.81 * c, 9.81 * s, d * -9.81 * c], rtol=1e-8)


@pytest.mark.parametrize(
    ("law", "given", "levels"),
    [
        ("stribeck_friction", {"level": 1, "static": 2, "velocity": 0.1}, {"level": 4, "static": 5}),
        ("asymmetric_friction", {"positive": 1, "negative": 2}, {"positive": 4, "negative": 5}),
        ("presliding_hysteresis", {"stiffness": 100, "level": 1}, {"level": 4}),
    ],
)
def test_a_joint_keeps_one_law_of_friction(
    law: str, given: dict[str, float], levels: dict[str, float]
) -> None:
    robot = read_text("name: a\nlinks: [{joint: revolute, friction: {viscous: 1, coulomb: 3}}]\n")
    one = amended(robot, [Amendment(law, 1, given)])
    assert one.links[0].joint.coulomb == 0
    assert one.links[0].joint.viscous == 1
    assert {name: one.effects[0][name] for name in levels} == levels
    more = amended(one, [Amendment("coulomb_friction", 1, {"level": 0.5})])
    assert more.links[0].joint.coulomb == 0
    assert {name: more.effects[0][name] for name in levels} == {k: v + F(1, 2) for k, v in levels.items()}
    assert len(more.effects) == 1


def test_a_level_with_a_name_moves_too() -> None:
    text = "name: a\nlinks: [{joint: revolute, friction: {coulomb: f_c}}]\n"
    new = amend(text, Amendment("stribeck_friction", 1, {"level": 1, "static": 2, "velocity": 0.1}))
    assert read(new).effects[0]["static"] == parameter("f_c") + 2
    assert "coulomb" not in new
