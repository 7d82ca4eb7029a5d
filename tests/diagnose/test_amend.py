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

from robodyn.diagnose.amend.amend import Amendment, amended, amended_text, apply_amendments, difference
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Site
from robodyn.errors import InputError
from robodyn.robot import Inertia, Robot, bundled_names, bundled_text, load, read_text, to_yaml
from robodyn.robot.model import EffectEntry
from robodyn.robot.values import parameter
from robodyn_testing.effect_arms import TEXTS
from robodyn_testing.random_effects import with_random_effects
from robodyn_testing.random_robots import random_robot

F = Fraction
_LAWS = {"stribeck_friction", "asymmetric_friction", "presliding_hysteresis"}


def _read(text: str) -> Robot:
    return read_text(text, warn=lambda _: None)


def _amend(text: str, *amendments: Amendment, notes: dict[int, str] | None = None) -> str:
    """The text with the amendments, held to what the data say."""
    robot = _read(text)
    new = amended_text(text, robot, amendments, notes or {})
    assert _read(new) == amended(robot, amendments)
    return new


def _random_amendments(rng: random.Random, robot: Robot) -> list[Amendment]:
    found = []
    while len(found) < rng.randint(1, 4):
        id = rng.choice(list(CATALOGUE))
        joint = None if CATALOGUE[id].level == "robot" else rng.randint(1, robot.n)
        drawn = with_random_effects(replace(robot, effects=()), rng.randrange(10**6), ids=[id], share=1)
        entries = drawn.effects_at(joint)
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


@pytest.mark.parametrize("style", [str, _in_blocks, _in_flow, _in_flow_of_links, _as_on_windows])
def test_the_text_says_what_the_data_say(style: Callable[[str], str]) -> None:
    refused = 0
    for seed in range(24):
        rng = random.Random(seed)
        robot = random_robot(seed, joints=rng.randint(2, 4))
        text = style(to_yaml(with_random_effects(robot, seed, share=0.25, names=0.15)))
        amendments = _random_amendments(rng, robot)
        try:
            target = amended(_read(text), amendments)
        except InputError:
            refused += 1  # two bodies with run-time masses have no sum
            continue
        new = amended_text(text, _read(text), amendments, {0: "found"})
        assert _read(new) == target
        assert "Written anew" not in new
        assert ("\r\n" in new) == ("\r\n" in text)
        assert new.count("\n") == new.count("\r\n") or "\r\n" not in text
    assert refused <= 4


@pytest.mark.parametrize("name", bundled_names())
def test_bundled_robots_keep_what_is_not_amended(name: str) -> None:
    text = bundled_text(name)
    robot = _read(text)
    for seed in range(2):
        rng = random.Random(seed)
        amendments = _random_amendments(rng, robot)
        new = _amend(text, *amendments, notes=dict.fromkeys(range(4), "found by a test"))
        assert "Written anew" not in new
        old = text.splitlines()
        gone = set(old) - set(new.splitlines())
        assert len(gone) <= 3 * robot.n * (len(amendments) > 0)
        assert not any(line.lstrip().startswith("#") for line in gone)
        assert text.count("#") <= new.count("#")


_HAND = """\
# An arm   (kept: odd   spaces)
name: arm   # its name
links:   # base to tip
  # the first
  - joint: revolute   # J1
    mass: 2.50   # kg
    friction: {viscous: 1.0, coulomb: 2.0}   # N m s/rad, N m
    # between
    com: [0.1, 0, 0]   # m

  - {joint: prismatic, mass: m_tool, friction: {coulomb: 1}}   # J2
# the end
"""


def test_a_hand_written_file_changes_where_it_must() -> None:
    new = _amend(
        _HAND,
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
    assert difference(_HAND, _HAND) == ""
    shown = difference(_HAND, new).splitlines()
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
    new = _amend(_LISTED, *(Amendment("asymmetric_friction", joint, law) for joint in (1, 2, 3)))
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
    new = _amend(_LISTED, Amendment("base_tilt", None, {"tilt_y": -0.02}), notes={0: "tilted"})
    assert "base_tilt" not in new
    assert "# down" in new
    g = [float(x) for x in _read(new).gravity]
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
    new = _amend(text, Amendment("stribeck_friction", 1, {"level": 1, "static": 2, "velocity": 0.1}))
    assert _read(new).effects[0]["static"] == parameter("f_c") + 2
    assert "coulomb" not in new


def _torque(entries: tuple[EffectEntry, ...], at: Site) -> float:
    total = 0.0
    for entry in entries:
        values = {k: float(v) if isinstance(v, Fraction) else v for k, v in entry.settings}
        equation = CATALOGUE[entry.effect].equation
        assert equation is not None
        total += float(equation(values, at))
    return total


_LOAD = "load_dependent_friction"
_JOURNAL = {"bearing": "journal", "mu_r": 0.1}
_RIPPLE = {"amplitude": 2, "cycles_per_rev": 5}


@pytest.mark.parametrize(
    ("id", "one", "other", "count"),
    [
        ("spring", {"stiffness": 20, "rest": 0.3}, {"stiffness": -7.12346, "rest": -1.2}, 1),
        ("spring", {"stiffness": 20, "rest": 0.3, "cubic": 2}, {"stiffness": 5, "rest": 0.3, "cubic": 1}, 1),
        ("torque_ripple", {**_RIPPLE, "phase": 1}, {"amplitude": 1, "cycles_per_rev": 5}, 1),
        ("torque_ripple", _RIPPLE, {"amplitude": -3, "cycles_per_rev": 5}, 1),
        ("torque_ripple", _RIPPLE, {"amplitude": 1, "cycles_per_rev": 6}, 2),
        (_LOAD, {"bearing": "radial", "mu": 0.1, "radius": 0.08}, {"bearing": "journal", "mu_r": 0.01}, 1),
        (_LOAD, {"bearing": "thrust", "mu_r": 0.01}, {"bearing": "thrust", "mu": 0.1, "radius": 0.03}, 1),
        (_LOAD, {"bearing": "torque", "mu": 0.1}, {"bearing": "thrust", "mu_r": 0.03}, 2),
        (_LOAD, {**_JOURNAL, "span": 0.2}, {**_JOURNAL, "span": 0.3}, 2),
        ("asymmetric_friction", {"positive": 2, "negative": 1}, {"positive": -0.5, "negative": 0.25}, 1),
        ("torque_bias", {"bias": 2}, {"bias": -0.5}, 1),
    ],
)  # fmt: skip
def test_the_sum_acts_as_the_two_do(id: str, one: Any, other: Any, count: int) -> None:
    bare = read_text("name: a\nlinks: [{joint: revolute}]\n")
    first = amended(bare, [Amendment(id, 1, one)])
    both = amended(first, [Amendment(id, 1, other)])
    assert len(both.effects) == count
    defaults = {p.name: float(p.default) for p in CATALOGUE[id].parameters if isinstance(p.default, Fraction)}
    alone = EffectEntry(id, 1, tuple({**defaults, **other}.items()))
    rng = np.random.default_rng(0)
    for _ in range(20):
        q, qd, tau, *load = rng.uniform(-2, 2, 9)
        f, n = tuple(load[:3]), tuple(load[3:])
        at = Site(True, q=q, qd=qd, direction=math.copysign(1, qd), tau=tau, f=f, n=n)  # type: ignore[arg-type]
        wanted = _torque((*first.effects, alone), at)
        assert math.isclose(_torque(both.effects, at), wanted, rel_tol=1e-7, abs_tol=1e-7)


def _about_origin(m: float, c: np.ndarray, tensor: Inertia | None) -> np.ndarray:
    t = tensor or Inertia()
    about = np.array([[t.xx, t.xy, t.xz], [t.xy, t.yy, t.yz], [t.xz, t.yz, t.zz]], dtype=float)
    return about + m * (c @ c * np.eye(3) - np.outer(c, c))


@pytest.mark.parametrize("named", [False, True])
def test_payloads_join_to_one_body(named: bool) -> None:
    mass = "m" if named else "2"
    text = f"""\
name: a
links: [{{joint: revolute, mass: 3, com: [0.1, 0.2, 0], inertia: {{xx: 0.2, yy: 0.1, zz: 0.2, xy: 0.01}}}}]
effects: [{{effect: payload, mass: {mass}, com: [0.1, -0.2, 0.3], inertia: {{yy: 0.01, zz: 0.01}}}}]
"""
    given = {"mass": 1.25, "com_x": 0.3, "com_z": -0.1, "inertia_xx": 0.002}
    robot = _read(_amend(text, Amendment("payload", None, given)))
    before, link, load = _read(text), robot.links[0], robot.effects[0]
    if named:  # a run-time mass has no centre in common: the body is in the link that it is fixed to
        assert load == before.effects[0]
        old, new = before.links[0], (link.mass, link.com, link.inertia)
        first = (old.mass, old.com, old.inertia)
    else:
        assert link == before.links[0]
        new = (load["mass"], load["com"], load["inertia"])
        first = tuple(before.effects[0][key] for key in ("mass", "com", "inertia"))  # type: ignore[assignment]
    sums = [np.zeros(1), np.zeros(3), np.zeros((3, 3))]
    for m, c, tensor in (first, (F(5, 4), (F(3, 10), F(0), F(-1, 10)), Inertia(xx=F(2, 1000)))):
        at = np.array(c, dtype=float)
        parts = (float(m), float(m) * at, _about_origin(float(m), at, tensor))  # type: ignore[arg-type]
        sums = [total + part for total, part in zip(sums, parts, strict=True)]
    at = np.array(new[1], dtype=float)
    assert np.allclose(float(new[0]), sums[0])  # type: ignore[arg-type]
    assert np.allclose(float(new[0]) * at, sums[1], atol=1e-9)  # type: ignore[arg-type]
    assert np.allclose(_about_origin(float(new[0]), at, new[2]), sums[2], atol=1e-8)  # type: ignore[arg-type]


def test_what_would_be_negative_is_nought_and_says_so() -> None:
    text = "name: a\nlinks:\n  - joint: revolute\n    mass: 1\n    friction: {viscous: 0.5}\n"
    amendments = [
        Amendment("viscous_friction", 1, {"coefficient": -0.7}),
        Amendment("inertial_error", 1, {"delta_mass": -3}),
        Amendment("stribeck_friction", 1, {"level": 2, "static": 1, "velocity": 0.1}),
        Amendment("transmission_loss", 1, {"breakaway": -1, "efficiency": 0.8}),
    ]
    done = apply_amendments(_read(text), amendments)
    assert [len(remarks) for remarks in done.remarks] == [1, 1, 1, 1]
    new = _amend(text, *amendments)
    assert "# viscous_friction: the sum of viscous would be -0.2, and is 0 instead\n" in new
    link = _read(new).links[0]
    assert (link.mass, link.joint.viscous) == (0, 0)
    assert _read(new).effects[0]["static"] == 2


def test_a_note_follows_what_it_is_about() -> None:
    text = "name: a\nlinks:\n  - joint: revolute\n    friction: {coulomb: 1}\n"
    law = Amendment("stribeck_friction", 1, {"level": 1, "static": 2, "velocity": 0.1})
    new = _amend(text, Amendment("coulomb_friction", 1, {"level": 1}), law, notes={0: "one", 1: "two"})
    assert "    # one\n    # two\n    effects:\n      - {effect: stribeck_friction, level: 3, " in new
    table = "[[0, 0.5],  # cold\n      [1, 0.9]], rated_torque: 5"
    entry = f"{{effect: transmission_loss, efficiency: {table}}}"
    text = f"name: a\nlinks:\n  - joint: revolute\n    effects: [{entry}]\n"
    assert "# cold" in _amend(text, Amendment("transmission_loss", 1, {"efficiency": 0.7}))


def test_elasticity_and_play_become_one_entry() -> None:
    text = "name: a\nlinks: [{joint: revolute, effects: [{effect: joint_elasticity, stiffness: 500}]}]\n"
    new = _amend(text, Amendment("backlash", 1, {"gap": 0.01}))
    (entry,) = _read(new).effects
    assert (entry.effect, entry["gap"], entry["stiffness"]) == ("backlash", F(1, 100), 500)
    new = _amend(new, Amendment("joint_elasticity", 1, {"stiffness": 800}))
    (entry,) = _read(new).effects
    assert (entry.effect, entry["gap"], entry["stiffness"]) == ("backlash", F(1, 100), 800)


def test_a_delay_of_all_joints_and_one_of_a_joint_add_up() -> None:
    text = "name: a\nlinks: [{joint: revolute}, {joint: revolute}]\n"
    new = _amend(text, Amendment("time_delay", None, {"delay": 0.002}))
    new = _amend(new, Amendment("time_delay", None, {"delay": 0.001}))
    assert _read(new).effects_at(None)[0]["delay"] == F(3, 1000)
    new = _amend(new, Amendment("time_delay", 2, {"delay": 0.004}))
    new = _amend(new, Amendment("time_delay", None, {"delay": 0.001}))
    delays = [(entry.joint, entry["delay"]) for entry in _read(new).effects]
    assert delays == [(1, F(4, 1000)), (2, F(8, 1000))]


def test_contacts_are_kept_once_with_their_log() -> None:
    text = "name: a\nlinks: [{joint: revolute}]\n"
    contact = Amendment("external_contact", None, {"start": 1, "end": 2, "link": 1, "log": "ab: #12"})
    new = _amend(text, contact)
    assert _amend(new, contact) == new
    other = Amendment("external_contact", None, {"start": 3, "end": 4, "link": 1, "log": "ab: #12"})
    assert len(_read(_amend(new, other)).effects) == 2


def test_numbers_have_six_digits() -> None:
    robot = read_text("name: a\nlinks: [{joint: revolute, friction: {viscous: 1/3}}]\n")
    new = amended(robot, [Amendment("viscous_friction", 1, {"coefficient": 0.123456789})])
    assert new.links[0].joint.viscous == F(repr(float(F(1, 3) + F(123457, 10**6))))
    new = amended(new, [Amendment("torque_bias", 1, {"bias": 1e-9 / 3})])
    assert new.effects[0]["bias"] == F("3.33333e-10")


def test_aliases_and_standard_dh_are_written_anew() -> None:
    shared = "name: a\nlinks:\n  - &l {joint: revolute, mass: 2}\n  - *l\n"
    new = _amend(shared, Amendment("viscous_friction", 2, {"coefficient": 1}), notes={0: "found"})
    assert new.startswith("# Written anew, without the comments that were here: line 3 is used by an alias")
    assert "\n# found\n" in new
    standard = "name: a\nconvention: sdh  # kept\nlinks:\n  - {joint: revolute, a: 1, alpha: 0.3, mass: 2}\n"
    assert "# kept" in _amend(standard, Amendment("viscous_friction", 1, {"coefficient": 1}))
    for amendment in (
        Amendment("inertial_error", 1, {"delta_com_y": 0.1}),
        Amendment("payload", None, {"mass": 1, "com_y": 0.1}),
    ):
        first = _amend(standard, amendment).splitlines()[0]
        assert first.startswith("# Written anew")
        assert "standard DH" in first


def test_arithmetic_stays_where_a_name_is_in_it() -> None:
    text = (
        "name: a\nlinks: [{joint: revolute, mass: 17*0.0254, com: [1/3 + 2*c, 0, pi*k], motor_inertia: j}]\n"
    )
    deltas = {"delta_mass": 0.1, "delta_com_x": 0.01, "delta_com_z": -0.5}
    new = _amend(text, Amendment("inertial_error", 1, deltas), Amendment("rotor_inertia", 1, {"inertia": 2}))
    assert "mass: 0.5318, com: [1/3 + 2*c + 0.01, 0, pi*k - 0.5], motor_inertia: j + 2}" in new


@pytest.mark.parametrize("name", TEXTS)
def test_arms_with_effects_take_the_same_again(name: str) -> None:
    robot = _read(TEXTS[name])
    found = []
    for entry in robot.effects:
        values: dict[str, Any] = {k: float(v) for k, v in entry.settings if isinstance(v, Fraction)}
        values |= {k: v for k, v in entry.settings if isinstance(v, (str, int))}
        if entry.effect == "transmission_loss":
            values = {"breakaway": 1, "efficiency": 0.5}  # one number in place of a table
        elif entry.effect == "stribeck_friction":
            values.setdefault("static", 4)
        elif entry.effect == "payload":
            values["mass"] = 1
        found.append(Amendment(entry.effect, entry.joint, values))
    new = _amend(TEXTS[name], *found)
    assert "Written anew" not in new
    assert len(_read(new).effects) == len(robot.effects)


@pytest.mark.parametrize(
    ("amendment", "words"),
    [
        (Amendment("friction", 1, {}), "unknown effect"),
        (Amendment("spring", 3, {"stiffness": 1}), "no such joint"),
        (Amendment("spring", None, {"stiffness": 1}), "an effect of a joint"),
        (Amendment("payload", 1, {"mass": 1}), "an effect of the whole robot"),
        (Amendment("spring", 1, {"stiffness": 1, "colour": 2}), "no such parameter"),
        (Amendment("spring", 1, {"rest": 1}), "stiffness is missing"),
        (Amendment("spring", 1, {"stiffness": math.nan}), "not a number"),
        (Amendment("backlash", 1, {"gap": -1}), "gap is out of range"),
        (Amendment("transmission_loss", 1, {"efficiency": 1.1}), "efficiency is out of range"),
        (Amendment("backlash", 1, {"gap": 1, "encoder": "both"}), "not what may stand there"),
        (Amendment("motor_coupling", 1, {"with": 1, "inertia": 1}), "names the joint itself"),
        (Amendment("load_dependent_friction", 1, {"bearing": "linear", "mu": 1, "span": 1}), "does not fit"),
        (Amendment("external_contact", None, {"start": 2, "end": 1, "link": 1}), "not after the start"),
    ],
)
def test_what_the_catalogue_does_not_know_is_refused(amendment: Amendment, words: str) -> None:
    robot = read_text("name: a\nlinks: [{joint: revolute}, {joint: prismatic}]\n")
    with pytest.raises(InputError, match=words):
        amended(robot, [amendment])


def test_another_robots_text_is_refused() -> None:
    with pytest.raises(InputError, match="does not describe this robot"):
        amended_text(_HAND, load("ur5"), [], {})
