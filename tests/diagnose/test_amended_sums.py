"""Effects that are there already: sums that act as both do, and what cannot be summed."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from diagnose.amending import HAND, F, amend, read
from robodyn.diagnose.amend.amend import Amendment, amended, amended_text, apply_amendments
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Site
from robodyn.errors import InputError
from robodyn.robot import Inertia, load, read_text
from robodyn.robot.model import EffectEntry
from robodyn_testing.effect_arms import TEXTS


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
    robot = read(amend(text, Amendment("payload", None, given)))
    before, link, load = read(text), robot.links[0], robot.effects[0]
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
    done = apply_amendments(read(text), amendments)
    assert [len(remarks) for remarks in done.remarks] == [1, 1, 1, 1]
    new = amend(text, *amendments)
    assert "# viscous_friction: the sum of viscous would be -0.2, and is 0 instead\n" in new
    link = read(new).links[0]
    assert (link.mass, link.joint.viscous) == (0, 0)
    assert read(new).effects[0]["static"] == 2


def test_a_note_follows_what_it_is_about() -> None:
    text = "name: a\nlinks:\n  - joint: revolute\n    friction: {coulomb: 1}\n"
    law = Amendment("stribeck_friction", 1, {"level": 1, "static": 2, "velocity": 0.1})
    new = amend(text, Amendment("coulomb_friction", 1, {"level": 1}), law, notes={0: "one", 1: "two"})
    assert "    # one\n    # two\n    effects:\n      - {effect: stribeck_friction, level: 3, " in new
    table = "[[0, 0.5],  # cold\n      [1, 0.9]], rated_torque: 5"
    entry = f"{{effect: transmission_loss, efficiency: {table}}}"
    text = f"name: a\nlinks:\n  - joint: revolute\n    effects: [{entry}]\n"
    assert "# cold" in amend(text, Amendment("transmission_loss", 1, {"efficiency": 0.7}))


def test_elasticity_and_play_become_one_entry() -> None:
    text = "name: a\nlinks: [{joint: revolute, effects: [{effect: joint_elasticity, stiffness: 500}]}]\n"
    new = amend(text, Amendment("backlash", 1, {"gap": 0.01}))
    (entry,) = read(new).effects
    assert (entry.effect, entry["gap"], entry["stiffness"]) == ("backlash", F(1, 100), 500)
    new = amend(new, Amendment("joint_elasticity", 1, {"stiffness": 800}))
    (entry,) = read(new).effects
    assert (entry.effect, entry["gap"], entry["stiffness"]) == ("backlash", F(1, 100), 800)


def test_a_delay_of_all_joints_and_one_of_a_joint_add_up() -> None:
    text = "name: a\nlinks: [{joint: revolute}, {joint: revolute}]\n"
    new = amend(text, Amendment("time_delay", None, {"delay": 0.002}))
    new = amend(new, Amendment("time_delay", None, {"delay": 0.001}))
    assert read(new).effects_at(None)[0]["delay"] == F(3, 1000)
    new = amend(new, Amendment("time_delay", 2, {"delay": 0.004}))
    new = amend(new, Amendment("time_delay", None, {"delay": 0.001}))
    delays = [(entry.joint, entry["delay"]) for entry in read(new).effects]
    assert delays == [(1, F(4, 1000)), (2, F(8, 1000))]


def test_contacts_are_kept_once_with_their_log() -> None:
    text = "name: a\nlinks: [{joint: revolute}]\n"
    contact = Amendment("external_contact", None, {"start": 1, "end": 2, "link": 1, "log": "ab: #12"})
    new = amend(text, contact)
    assert amend(new, contact) == new
    other = Amendment("external_contact", None, {"start": 3, "end": 4, "link": 1, "log": "ab: #12"})
    assert len(read(amend(new, other)).effects) == 2


def test_numbers_have_six_digits() -> None:
    robot = read_text("name: a\nlinks: [{joint: revolute, friction: {viscous: 1/3}}]\n")
    new = amended(robot, [Amendment("viscous_friction", 1, {"coefficient": 0.123456789})])
    assert new.links[0].joint.viscous == F(repr(float(F(1, 3) + F(123457, 10**6))))
    new = amended(new, [Amendment("torque_bias", 1, {"bias": 1e-9 / 3})])
    assert new.effects[0]["bias"] == F("3.33333e-10")


def test_aliases_and_standard_dh_are_written_anew() -> None:
    shared = "name: a\nlinks:\n  - &l {joint: revolute, mass: 2}\n  - *l\n"
    new = amend(shared, Amendment("viscous_friction", 2, {"coefficient": 1}), notes={0: "found"})
    assert new.startswith("# Written anew, without the comments that were here: line 3 is used by an alias")
    assert "\n# found\n" in new
    standard = "name: a\nconvention: sdh  # kept\nlinks:\n  - {joint: revolute, a: 1, alpha: 0.3, mass: 2}\n"
    assert "# kept" in amend(standard, Amendment("viscous_friction", 1, {"coefficient": 1}))
    for amendment in (
        Amendment("inertial_error", 1, {"delta_com_y": 0.1}),
        Amendment("payload", None, {"mass": 1, "com_y": 0.1}),
    ):
        first = amend(standard, amendment).splitlines()[0]
        assert first.startswith("# Written anew")
        assert "standard DH" in first


def test_arithmetic_stays_where_a_name_is_in_it() -> None:
    text = (
        "name: a\nlinks: [{joint: revolute, mass: 17*0.0254, com: [1/3 + 2*c, 0, pi*k], motor_inertia: j}]\n"
    )
    deltas = {"delta_mass": 0.1, "delta_com_x": 0.01, "delta_com_z": -0.5}
    new = amend(text, Amendment("inertial_error", 1, deltas), Amendment("rotor_inertia", 1, {"inertia": 2}))
    assert "mass: 0.5318, com: [1/3 + 2*c + 0.01, 0, pi*k - 0.5], motor_inertia: j + 2}" in new


@pytest.mark.parametrize("name", TEXTS)
def test_arms_with_effects_take_the_same_again(name: str) -> None:
    robot = read(TEXTS[name])
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
    new = amend(TEXTS[name], *found)
    assert "Written anew" not in new
    assert len(read(new).effects) == len(robot.effects)


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
        amended_text(HAND, load("ur5"), [], {})
