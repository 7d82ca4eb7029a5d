"""Files that are no descriptions, and hostile ones: whatever the text is, the answer is a Robot or an
InputError of one line. What is said of broken texts is in ``tests/refusals``."""

from __future__ import annotations

import json
import random
import re
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from robodyn.effects.catalogue import CATALOGUE
from robodyn.errors import InputError
from robodyn.robot import Robot, bundled_text, load, read_text, starter, to_yaml
from robodyn.robot.reader import read_bytes
from robodyn_testing.clocks import calls_of

HEAD = "name: arm\nlinks:\n  - joint: revolute\n"
LISTS = HEAD + "    effects: "


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("name: arm\ntitle: \ud800\n", "arm.yaml:2:8: the file contains a character that text does not have"),
        ("name: " + "{a: " * 400, "arm.yaml:1:131: lists and mappings are nested too deep"),
        ("name: arm\nlinks:\n  " + "- joint: revolute\n  " * 101, "arm.yaml:3:3: links must have 1 to 100"),
    ],
)
def test_texts_that_no_file_of_refusals_has(text: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        calls_of(lambda: read_text(text, "arm.yaml", strict=True), most=200_000)
    assert str(caught.value).startswith(message)


def test_files_that_are_not_text(tmp_path: Path) -> None:
    for data, message in (
        (b"\xff\xfen\x00a\x00", r"1:1: the file is not UTF-8 text; found UTF-16; save it as UTF-8"),
        (b"name: arm\ntitle: K\xe4fer\n", r"2:9: the file is not UTF-8 text; found byte 0xe4"),
        ("name: arm\ntitle: ä\xe4".encode() + b"\xc3", r"2:10: the file is not UTF-8 text; found byte 0xc3"),
        (b"\x7fELF\x02\x01\x01\x00", r"1:1: the file contains a character that text does not have"),
        (b"#" * (1 << 20) + b"\n", r" the file is too large; found more than 1 MiB"),
    ):
        file = tmp_path / "arm.yaml"
        file.write_bytes(data)
        with pytest.raises(InputError, match=r"arm\.yaml:\s?" + message):
            load(file)


def test_a_file_of_exactly_the_allowed_size_is_read() -> None:
    start = b"name: arm\nlinks: [{joint: revolute}]\n#"
    assert read_bytes(start + b"x" * ((1 << 20) - len(start)), "arm.yaml").n == 1


def test_byte_order_mark_and_line_ends_are_accepted() -> None:
    text = HEAD.replace("\n", "\r\n")
    assert read_bytes(b"\xef\xbb\xbf" + text.encode(), "arm.yaml").name == "arm"
    assert read_text("\ufeff" + text).name == "arm"
    with pytest.raises(InputError, match=re.escape("arm.yaml:4:11: link 1: mass is negative")):
        read_bytes(b"\xef\xbb\xbf" + text.encode() + b"    mass: -1\r\n", "arm.yaml")


@pytest.mark.parametrize(
    "text",
    [
        "a0: &a0 [x]\n" + "".join(f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 9)}]\n" for i in range(1, 40)),
        "[" * 500_000,
        "- " * 400_000,
        pytest.param("name: arm\nlinks: [" + "{joint: revolute}," * 50_000 + "]", marks=pytest.mark.thorough),
        "name: " + "(" * 900_000,
        HEAD + "    mass: " + "9" * 900_000,
        "&a " * 300_000,
        "\n" * 1_000_000,
        "x" * 1_000_000 + ": 1",
        '"' + "\\n" * 500_000,
        "\n".join(f"k{i}: {i}" for i in range(80_000)),
        LISTS + "[" + "{}," * 20_000 + "]",
        LISTS + "[{effect: transmission_loss, rated_torque: 1, efficiency: " + "[" * 25 + "]" * 25 + "}]",
        LISTS + "[{effect: transmission_loss, rated_torque: 1, efficiency: [" + "[0, 1]," * 5000 + "]}]",
        LISTS + "[{effect: " + "x" * 900_000 + "}]",
        LISTS + "[{effect: motor_coupling, with: " + "9" * 900_000 + "}]",
        LISTS + "[{effect: {effect: {effect: spring}}}]",
        LISTS + "&a [{effect: spring, stiffness: 1}, *a]",
        LISTS + "[{effect: spring, stiffness: \"1*/ __import__('os').system('true')\"}]",
    ],
    ids=lambda text: text[:12] + text[47:85] * text.startswith(LISTS),
)
def test_hostile_files_end_soon(text: str) -> None:
    with pytest.raises(InputError) as caught:
        calls_of(lambda: read_text(text, "arm.yaml"), most=5_000_000)
    assert len(str(caught.value)) < 700


def test_a_table_of_efficiencies_is_short() -> None:
    entry = f"{{effect: transmission_loss, rated_torque: 1, efficiency: {[[x, 1] for x in range(65)]}}}"
    with pytest.raises(InputError, match="efficiency must have 2 to 64 knots; found a list of 65"):
        read_text(f"{LISTS}[{entry}]")


def test_text_is_kept_as_text() -> None:
    """Ends of comments and quotes go through; the emitter escapes them."""
    log = "*/ int main(void) { } /* \\\" 'x' \u00e9"
    robot = read_text(
        "name: arm\nlinks: [{joint: revolute}]\neffects:\n  - effect: external_contact\n    start: 0\n"
        f"    end: 1\n    link: 1\n    log: '{log.replace(chr(39), chr(39) * 2)}'\n"
    )
    assert robot.effects[0].text("log") == log


# --- random ones ------------------------------------------------------------------------------------------

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
        read: Any = read_bytes if isinstance(data, bytes) else read_text
        robot = read(data, "f.yaml", warn=lambda _: None)
    except InputError as error:
        told = str(error)
    else:
        told = ""
        assert isinstance(robot, Robot)
        assert read_text(to_yaml(robot), warn=lambda _: None).n == robot.n
    assert "\n" not in told
    assert told == "" or told.startswith("f.yaml")


@given(st.binary(max_size=300) | st.text(max_size=200))
def test_random_bytes_and_text(data: bytes | str) -> None:
    assert_answered(data)


@settings(max_examples=300, deadline=None)
@given(st.lists(_WORDS, max_size=60))
def test_random_words_of_the_format(words: list[str]) -> None:
    assert_answered("".join(words))
    assert_answered(HEAD + "    " + "".join(words))
    assert_answered(HEAD + "    effects:\n    - effect: " + "".join(words))


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
    slide = {"joint": "prismatic"}
    assert_answered(json.dumps({"name": "arm", "links": [slide], "effects": link["effects"]}))


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
