"""Whatever the text is, the answer is a Robot or an InputError of one line."""

from __future__ import annotations

import json
import random

from hypothesis import given, settings
from hypothesis import strategies as st

from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError
from robodyn.robot import Robot, bundled_text, read_text, starter, to_yaml
from robodyn.robot.reader import read_bytes

_TEXT = r"""name links joint revolute prismatic alpha a d theta mass com inertia xx zz motor_inertia limits
position velocity confidence friction viscous effects gravity compare convention sdh torque_side smooth exact
friction_at_rest dead_band effect spring stiffness payload efficiency m_tool gear ratio unknown pi -pi/2 0 1
-1 1e309 nan .inf ~ null yes << *a &a !!str [ ] { } , : - ? | > ' " # % @ ( ) * / 2**3 --- ... \n \0 é 🤖"""
_WORDS = st.sampled_from([*_TEXT.split(), "\t", "\n", "\n  ", "\n    ", " ", ": ", "- "])
_EFFECTS = """
    effects:
      - {effect: transmission_loss, efficiency: [[0, 0.5], [1, 0.9]], rated_torque: 10, interpolation: cubic}
      - {effect: load_dependent_friction, bearing: journal, mu: 0.1, radius: r, span: 0.2}
      - {effect: motor_coupling, with: 1, ratio: -1/2, inertia: 1e-3}
      - {effect: inertial_error, delta_mass: 0.1, delta_com_x: dx}
effects:
  - {effect: payload, mass: m_load, com: [0, 0, 0.1], inertia: {xx: 1e-3}}
  - {effect: base_tilt, tilt_x: 0.1}
  - {effect: external_contact, start: 1, end: 2, link: 3, force_x: 10, log: a hash}
"""
_SEEDS = (
    bundled_text("puma560"),
    bundled_text("tx40"),
    starter("my_arm", 3),
    starter("my_arm", 3).partition("\n# torque_side")[0] + _EFFECTS,
)


def assert_answered(data: bytes | str) -> None:
    try:
        if isinstance(data, bytes):
            robot = read_bytes(data, "f.yaml", warn=lambda _: None)
        else:
            robot = read_text(data, "f.yaml", warn=lambda _: None)
    except InputError as error:
        told = str(error)
    else:
        told = ""
        assert isinstance(robot, Robot)
        assert read_text(to_yaml(robot), warn=lambda _: None).n == robot.n
    assert "\n" not in told
    assert told == "" or told.startswith("f.yaml")


@given(st.binary(max_size=300))
def test_random_bytes(data: bytes) -> None:
    assert_answered(data)


@given(st.text(max_size=200))
def test_random_text(text: str) -> None:
    assert_answered(text)


@settings(max_examples=300, deadline=None)
@given(st.lists(_WORDS, max_size=60))
def test_random_words_of_the_format(words: list[str]) -> None:
    assert_answered("".join(words))
    assert_answered("name: arm\nlinks:\n  - joint: revolute\n    " + "".join(words))
    assert_answered("name: arm\nlinks:\n  - joint: revolute\n    effects:\n    - effect: " + "".join(words))


_LEAVES = st.one_of(st.text(max_size=6), _WORDS, st.integers().map(str), st.floats().map(str))
_TREES = st.recursive(
    _LEAVES,
    lambda inner: (
        st.lists(inner, max_size=4) | st.dictionaries(_WORDS | st.text(max_size=4), inner, max_size=5)
    ),
    max_leaves=20,
)


@settings(deadline=None)
@given(st.dictionaries(_WORDS, _TREES, max_size=5), st.dictionaries(_WORDS, _TREES, max_size=5))
def test_random_trees_in_json(robot: dict[str, object], link: dict[str, object]) -> None:
    assert_answered(json.dumps({"name": "arm", "links": [{"joint": "revolute", **link}], **robot}))


@settings(max_examples=50, deadline=None)
@given(st.sampled_from(sorted(CATALOGUE)), st.data())
def test_random_trees_as_parameters_of_an_effect(id: str, data: st.DataObject) -> None:
    drawn = data.draw(st.dictionaries(st.sampled_from(CATALOGUE[id].names) | _WORDS, _TREES, max_size=5))
    link = {"joint": "revolute", "effects": [{"effect": id, **drawn}]}
    assert_answered(json.dumps({"name": "arm", "links": [link]}))
    assert_answered(
        json.dumps({"name": "arm", "links": [{"joint": "prismatic"}], "effects": link["effects"]})
    )


def test_the_fourth_seed_is_a_robot() -> None:
    assert len(read_text(_SEEDS[3]).effects) == 5


@settings(max_examples=300, deadline=None)
@given(st.integers(0, 3), st.integers(0, 2**32))
def test_robots_with_a_few_changed_characters(which: int, seed: int) -> None:
    chance = random.Random(seed)
    data = bytearray(_SEEDS[which].encode())
    for _ in range(chance.randint(1, 4)):
        k = chance.randrange(len(data))
        change = chance.randrange(3)
        if change == 0:
            data[k] = chance.choice(b" \n\t:-,[]{}()*&!|>'\"%@`#?e.0123456789xp\x00\xff/+")
        elif change == 1:
            del data[k : k + chance.randint(1, 30)]
        else:
            m = chance.randrange(len(data))
            data[k:k] = data[m : m + chance.randint(1, 60)]
    assert_answered(bytes(data))
