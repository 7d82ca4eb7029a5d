"""Files that are no descriptions, and hostile ones; what is said of broken texts is in ``tests/refusals``."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.robot import load, read_text
from robodyn.robot.reader import read_bytes
from robodyn_testing.clocks import calls_of

HEAD = "name: arm\nlinks:\n  - joint: revolute\n"


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
        "{" * 500_000,
        "- " * 400_000,
        "a: " * 300_000,
        "? " * 400_000,
        pytest.param("[" + "[]," * 300_000 + "]", marks=pytest.mark.thorough),
        pytest.param("name: arm\nlinks: [" + "{joint: revolute}," * 50_000 + "]", marks=pytest.mark.thorough),
        "name: " + "(" * 900_000,
        "name: arm\nlinks:\n  - joint: revolute\n    mass: " + "9" * 900_000,
        "name: arm\nlinks:\n  - joint: revolute\n    mass: " + "(" * 900_000,
        "&a " * 300_000,
        "\n" * 1_000_000,
        "x" * 1_000_000 + ": 1",
        "'" + "''" * 500_000,
        '"' + "\\n" * 500_000,
        "\n".join(f"k{i}: {i}" for i in range(80_000)),
    ],
    ids=lambda text: text[:12],
)
def test_hostile_files_end_soon(text: str) -> None:
    with pytest.raises(InputError) as caught:
        calls_of(lambda: read_text(text, "arm.yaml"), most=5_000_000)
    assert len(str(caught.value)) < 700


LISTS = "name: arm\nlinks:\n  - joint: revolute\n    effects: "


@pytest.mark.parametrize(
    "text",
    [
        pytest.param(
            LISTS + "[" + "{effect: torque_ripple, amplitude: 1, cycles_per_rev: 2}," * 2000 + "]",
            marks=pytest.mark.thorough,
        ),
        LISTS + "[" + "{}," * 20_000 + "]",
        LISTS + "[{effect: transmission_loss, rated_torque: 1, efficiency: " + "[" * 25 + "]" * 25 + "}]",
        LISTS + "[{effect: transmission_loss, rated_torque: 1, efficiency: [" + "[0, 1]," * 5000 + "]}]",
        LISTS + "[{effect: transmission_loss, efficiency: " + "(" * 900_000 + "}]",
        LISTS + "[{effect: " + "x" * 900_000 + "}]",
        LISTS + "[{effect: spring, " + "x" * 900_000 + ": 1}]",
        LISTS + "[{effect: motor_coupling, with: " + "9" * 900_000 + "}]",
        LISTS + "[{effect: {effect: {effect: spring}}}]",
        LISTS + "&a [{effect: spring, stiffness: 1}, *a]",
        LISTS + "[{effect: spring, stiffness: \"1*/ __import__('os').system('true')\"}]",
    ],
    ids=lambda text: text[47:85],
)
def test_hostile_lists_end_soon(text: str) -> None:
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
