"""Broken descriptions: each refused with an InputError of one line that begins with the right place.

The mark ¶ in a text stands where the message must point; it is taken out before the text is read.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.robot import load, read_text
from robodyn.robot.reader import read_bytes
from robodyn_testing.clocks import calls_of

HEAD = "name: arm\nlinks:\n  - joint: revolute\n"


def _pointed(marked: str) -> tuple[str, int, int]:
    before, mark, _ = marked.partition("¶")
    assert mark, "the case has no mark"
    return marked.replace("¶", ""), before.count("\n") + 1, len(before) - before.rfind("\n")


BROKEN = {
    # the file as a whole
    "empty": ("¶", "the file is empty"),
    "only a comment": ("¶# nothing\n", "the file is empty"),
    "only a document mark": ("---\n¶", "the description has no value"),
    "plain text": ("¶hello, world\n", "must be a mapping"),
    "a list": ("¶- name: arm\n", "must be a mapping; found a list"),
    "a number": ("¶42\n", "must be a mapping; found '42'"),
    "two documents": (HEAD + "¶---\nname: other\n", "a second YAML document begins here"),
    "tab as indentation": ("name: arm\nlinks:\n¶\t- joint: revolute\n", "indent with spaces, not tabs"),
    "tab before a key": ("name: arm\nlinks:\n  - joint: revolute\n¶\ta: 1\n", "indent with spaces"),
    "unclosed bracket": (HEAD + "    com: [0, 0, 1\n¶", "not valid YAML"),
    "unclosed quote": ('name: arm\ntitle: "PUMA\n¶', "not valid YAML"),
    "unclosed brace": (HEAD + "    inertia: {xx: 1\n¶", "not valid YAML"),
    "two colons on a line": ("name: arm\ntitle: PUMA¶: six joints\n", "in quotes"),
    "two keys on a line": ("name: arm¶: links:\n", "each key on a line of its own"),
    "no colon": ("name: arm\nlinks\n  - joint¶: revolute\n", "not valid YAML"),
    "wrong indentation": ("name: arm\nlinks:\n  - joint: revolute\n ¶- joint: revolute\n", "not valid YAML"),
    "NUL": ("name: a¶\0rm\n", "U+0000"),
    "control character": ("name: arm\ntitle: ¶\x1b[31mred\n", "U+001B"),
    "lone surrogate": ("name: arm\ntitle: ¶\ud800\n", "U+D800"),
    # YAML's own machinery
    "python tag": ("name: ¶!!python/object/apply:os.system ['true']\n", "YAML tags are not used here"),
    "custom tag": ("name: ¶!env HOME\nlinks: []\n", "YAML tags"),
    "core tag": (HEAD + "    mass: ¶!!float 3\n", "found '!!float'; delete the tag"),
    "tag on a mapping": ("¶!robot\nname: arm\n", "YAML tags"),
    "tag on a list": ("name: arm\nlinks: ¶!!seq\n  - joint: revolute\n", "YAML tags"),
    "unknown alias": ("name: arm\nlinks: ¶*nowhere\n", "has no anchor before it"),
    "alias in itself": ("name: arm\nlinks: &all [¶*all]\n", "contains itself"),
    "merge key": ("name: arm\nlinks:\n  - &one {joint: revolute}\n  - {¶<<: *one}\n", "merge keys"),
    "key is a list": ("name: arm\n? ¶[a, b]\n: 1\n", "a key must be a word"),
    "key is a mapping": ("name: arm\n? ¶{a: b}\n: 1\n", "a key must be a word"),
    "deep lists": ("name: " + "[" * 31 + "¶[" + "[" * 200, "nested too deep"),
    "deep mappings": ("name: " + "{a: " * 31 + "¶{a: " + "{a: " * 200, "nested too deep"),
    # keys
    "duplicate key": ("name: arm\n¶name: arm2\nlinks: []\n", "a second time; found the first in line 1"),
    "duplicate link key": (HEAD + "    a: 1\n    ¶a: 2\n", "a second time"),
    "unknown key": ("name: arm\n¶gravitation: [0, 0, -9.8]\nlinks: []\n", "did you mean 'gravity'?"),
    "unknown link key": (HEAD + "    ¶masss: 1\n", "did you mean 'mass'?"),
    "key of another format": (HEAD + "    ¶armature: 1\n", "did you mean 'motor_inertia'?"),
    "key in capitals": (HEAD + "    ¶Mass: 1\n", "did you mean 'mass'?"),
    "unknown inertia key": (HEAD + "    inertia: {xx: 1, ¶Iyy: 1}\n", "did you mean 'yy'?"),
    "unknown limit": (HEAD + "    limits: {¶speed: 1}\n", "expected one of position, velocity"),
    "unknown friction": (HEAD + "    friction: {¶stribeck: 1}\n", "expected one of viscous, coulomb"),
    "unknown compare key": ("name: arm\ncompare: {table: 1, row: x, ¶column: 2}\nlinks: []\n", "unknown key"),
    "empty key": ("name: arm\n¶'': 1\n", "unknown key"),
    "name is missing": ("¶links:\n  - joint: revolute\n", "the key 'name' is missing"),
    "links are missing": ("¶name: arm\n", "the key 'links' is missing"),
    "joint is missing": ("name: arm\nlinks:\n  - ¶alpha: 0\n", "link 1: the key 'joint' is missing"),
    "row is missing": ("name: arm\ncompare: ¶{table: 1}\nlinks: []\n", "compare: the key 'row' is missing"),
    # the robot's own values
    "name injects": ('name: ¶"x; system()"\nlinks: []\n', "is not a name in C and Fortran"),
    "name with umlaut": ("name: ¶Rüssel\nlinks: []\n", "is not a name in C and Fortran"),
    "name with a line break": ('name: ¶"arm\\n"\nlinks: []\n', "is not a name in C and Fortran"),
    "name begins with a digit": ("name: ¶560puma\nlinks: []\n", "is not a name in C and Fortran"),
    "name begins with underscore": ("name: ¶_arm\nlinks: []\n", "which Fortran forbids"),
    "name is a keyword": ("name: ¶double\nlinks: []\n", "keyword of C"),
    "name is a Fortran keyword": ("name: ¶Program\nlinks: []\n", "keyword of Fortran"),
    "name hides a header": ("name: ¶math\nlinks: []\n", "<math.h>"),
    "name of a device": ("name: ¶con\nlinks: []\n", "device on Windows"),
    "name too long": (f"name: ¶{'a' * 41}\nlinks: []\n", "has 41 characters, 40 are allowed"),
    "parameter is the real type": (HEAD + "    mass: ¶arm_real\n", "is a name of the emitted files"),
    "parameter is the struct": (
        HEAD + "    com: [0, 0, 2*¶arm_params]\n",
        "found 'arm_params'; choose another",
    ),
    "parameter is another macro": (HEAD + "    mass: ¶Arm_Processors\n", "is a name of the emitted files"),
    "parameter is a macro": (HEAD + "    mass: ¶ARM_H\n", "is a name of the emitted files"),
    "name is empty": ("name:¶\nlinks: []\n", "has no value"),
    "name is null": ("name: ¶~\nlinks: []\n", "has no value"),
    "name is a list": ("name: ¶[arm]\nlinks: []\n", "must be a single value; found a list of 1"),
    "title too long": (f"name: arm\ntitle: ¶{'x' * 201}\n" + HEAD[10:], "200 are allowed"),
    "title is a mapping": ("name: arm\ntitle: ¶{a: b}\nlinks: []\n", "must be a single value"),
    "title turns direction": ('name: arm\ntitle: ¶"a\\u202eb"\nlinks: []\n', "U+202E"),
    "title with an Arabic letter mark": ('name: arm\ntitle: ¶"a\\u061cb"\nlinks: []\n', "U+061C"),
    "link name with an invisible space": (
        'name: arm\nlinks:\n  - {joint: revolute, name: ¶"a\\u200bb"}\n',
        "U+200B",
    ),
    "source with a bell": ('name: arm\nsource: ¶"a\\ab"\nlinks: []\n', "U+0007"),
    "gravity is a number": ("name: arm\ngravity: ¶-9.8\nlinks: []\n", "gravity must be a list; found '-9.8'"),
    "gravity has two": ("name: arm\ngravity: ¶[0, -9.8]\nlinks: []\n", "gravity must have 3 entries"),
    "gravity is a name": ("name: arm\ngravity: [0, 0, ¶g]\nlinks: []\n", "a name cannot stand here"),
    "gravity nests": ("name: arm\ngravity: [0, 0, ¶[1]]\nlinks: []\n", "must be a single value"),
    "convention": ("name: arm\nconvention: ¶craig\nlinks: []\n", "expected mdh or sdh"),
    "torque side": (HEAD + "torque_side: ¶gear\n", "expected motor or link"),
    "friction at rest": (HEAD + "friction_at_rest: ¶sharp\n", "expected exact, or smooth"),
    "smooth and more": (HEAD + "friction_at_rest: ¶{smooth: {}, exact: 1}\n", "friction_at_rest is unknown"),
    "smooth by nothing": (HEAD + "friction_at_rest: {smooth: {velocity: ¶0}}\n", "is not positive"),
    "smooth by a name": (HEAD + "friction_at_rest: {smooth: {velocity: ¶eps}}\n", "a name cannot stand here"),
    "smooth with a dead band": (
        HEAD + "friction_at_rest: ¶{smooth: {}, dead_band: {}}\n",
        "friction_at_rest is both smooth and a dead band",
    ),
    "dead band of nothing": (HEAD + "friction_at_rest: {dead_band: {velocity: ¶0}}\n", "is not positive"),
    "effects are a mapping": (HEAD + "    effects: ¶{spring: 1}\n", "effects must be a list"),
    # links
    "no link": ("name: arm\nlinks: ¶[]\n", "1 to 100 entries; found an empty list"),
    "links are null": ("name: arm\nlinks:¶\n", "links must be a list; found nothing"),
    "links are a mapping": ("name: arm\nlinks: ¶{joint: revolute}\n", "links must be a list"),
    "too many links": ("name: arm\nlinks:\n  ¶" + "- joint: revolute\n  " * 101, "found a list of 101"),
    "a link is a word": (
        "name: arm\nlinks:\n  - joint: revolute\n  - ¶revolute\n",
        "link 2 must be a mapping",
    ),
    "a link is nothing": ("name: arm\nlinks:\n  -¶\n", "link 1 has no value"),
    "fixed joint": ("name: arm\nlinks:\n  - joint: ¶fixed\n", "expected revolute or prismatic"),
    "misspelt joint": ("name: arm\nlinks:\n  - joint: ¶Revolut\n", "did you mean 'revolute'?"),
    "joint is a list": ("name: arm\nlinks:\n  - joint: ¶[revolute]\n", "must be a single value"),
    "two links of one name": (
        "name: arm\nlinks:\n  - {name: a, joint: revolute}\n  - {name: ¶a, joint: revolute}\n",
        "link 2: another link has this name; found 'a', as link 1",
    ),
    "a name like a default": (
        "name: arm\nlinks:\n  - {name: link2, joint: revolute}\n  - ¶{joint: revolute}\n",
        "found 'link2', as link 1",
    ),
    "empty link name": (HEAD + "    name: ¶''\n", "link 1: name is empty"),
    # numbers
    "not a number": (HEAD + "    mass: ¶{kg: 1}\n", "link 1: mass must be a single value; found a mapping"),
    "no number": (HEAD + "    mass:¶\n", "link 1: mass has no value"),
    "null": (HEAD + "    mass: ¶null\n", "link 1: mass has no value"),
    "quoted nothing": (HEAD + "    mass: ¶''\n", "there is no number"),
    "python": (HEAD + "    mass: ¶__import__('os').system('true')\n", "functions are not supported"),
    "power": (HEAD + "    mass: 2*¶*3\n", "powers are not supported"),
    "power in quotes": (HEAD + '    mass: "2*¶*3"\n', "powers are not supported"),
    "function": (HEAD + "    d: 1 + ¶sin(1)\n", "functions are not supported"),
    "degrees": (HEAD + "    alpha: 90 ¶deg\n", "90 deg"),
    "division by zero": (HEAD + "    d: 1/¶0\n", "link 1: d: division by zero"),
    "huge exponent": (HEAD + "    mass: ¶1e999999999\n", "the exponent is out of range"),
    "overflow": (HEAD + "    mass: ¶1e308*10\n", "too large for a double"),
    "underflow": (HEAD + "    mass: ¶1e-308/1e300\n", "too small for a double"),
    "nan": (HEAD + "    mass: ¶.nan\n", "not a finite number"),
    "infinity": (HEAD + "    limits: {position: [¶-.inf, .inf]}\n", "not a finite number"),
    "sexagesimal": (HEAD + "    d: 1¶:30\n", "unexpected ':'"),
    "boolean": (HEAD + "    mass: ¶yes\n", "nor free to be a name"),
    "decimal comma": (HEAD + "    mass: 1¶,5\n", "decimal point"),
    "underscores": (HEAD + "    mass: 1¶_000\n", "without underscores"),
    "hexadecimal": (HEAD + "    mass: 0¶x10\n", "in decimal"),
    "com without commas": (HEAD + "    com: ¶[0 0 1]\n", "com must have 3 entries; found a list of 1"),
    "com of four": (HEAD + "    com: ¶[0, 0, 1, 2]\n", "com must have 3 entries; found a list of 4"),
    "com y is wrong": (HEAD + "    com: [0, 1¶x, 1]\n", "link 1: com y: unexpected 'x'"),
    "com is a mapping": (HEAD + "    com: ¶{x: 1}\n", "com must be a list; found a mapping"),
    "inertia is a list": (HEAD + "    inertia: ¶[1, 1, 1]\n", "inertia must be a mapping; found a list"),
    "inertia is a number": (HEAD + "    inertia: ¶1\n", "inertia must be a mapping; found '1'"),
    "name for alpha": (HEAD + "    alpha: ¶twist\n", "link 1: alpha: a name cannot stand here"),
    "name for theta": (HEAD + "    theta: pi/2 + ¶offset\n", "link 1: theta: a name cannot stand here"),
    "name for a limit": (HEAD + "    limits: {velocity: ¶fast}\n", "a name cannot stand here"),
    "name for confidence": (HEAD + "    confidence: ¶good\n", "a name cannot stand here"),
    "keyword as name": (HEAD + "    mass: ¶register\n", "keyword of C"),
    "macro as name": (HEAD + "    mass: 2*¶M_PI\n", "macro of the C library"),
    "macro of a number's limits": (HEAD + "    com: [0, 1 + ¶DBL_MAX, 0]\n", "macro of the C library"),
    "macro of a compiler": (HEAD + "    mass: ¶linux\n", "macro of C compilers"),
    "macro of ours": (HEAD + "    mass: ¶LANES_BYTES\n", "macro of the emitted files"),
    "names by case": (
        HEAD + "    d: m_tool\n    mass: 1 + ¶M_tool\n",
        "found 'M_tool' after 'm_tool' in line 4",
    ),
    "product of names": (HEAD + "    mass: m*¶n\n", "a product of names"),
    # what physics and common sense forbid
    "negative mass": (
        HEAD + "    mass: ¶-1\n",
        "link 1: mass is negative; found -1 kg; expected 0 kg or more",
    ),
    "negative motor inertia": (HEAD + "    motor_inertia: ¶-0.1\n", "motor_inertia is negative"),
    "negative viscous": (HEAD + "    friction: {viscous: ¶-1}\n", "link 1: friction: viscous is negative"),
    "negative coulomb": (HEAD + "    friction: {coulomb: ¶-1}\n", "link 1: friction: coulomb is negative"),
    "limits crossed": (HEAD + "    limits: {position: ¶[2, -2]}\n", "position is empty; found [2, -2]"),
    "limits equal": (HEAD + "    limits: {position: ¶[1, 1]}\n", "with lowest < highest"),
    "limit of one": (HEAD + "    limits: {position: ¶[1]}\n", "position must have 2 entries"),
    "velocity zero": (HEAD + "    limits: {velocity: ¶0}\n", "velocity is not positive"),
    "acceleration negative": (HEAD + "    limits: {acceleration: ¶-1}\n", "acceleration is not positive"),
    "torque negative": (HEAD + "    limits: {torque: ¶-1}\n", "torque is not positive; found -1 N m"),
    "limits are a list": (HEAD + "    limits: ¶[1, 2]\n", "limits must be a mapping"),
    "limits are nothing": (HEAD + "    limits:¶\n", "limits has no value"),
    "confidence zero": (
        HEAD + "    confidence: ¶0\n",
        "confidence is not a share; found 0; expected more",
    ),
    "confidence of two": (HEAD + "    confidence: ¶2\n", "more than 0 and at most 1, or unknown"),
    "confidence of a word": (HEAD + "    confidence: ¶unkown\n", "expected a number or unknown"),
    "confidence of the robot": ("name: arm\nconfidence: ¶-1\nlinks: [{joint: revolute}]\n", "is not a share"),
    "gear is a number": (HEAD + "    gear: ¶100\n", "link 1: gear must be a mapping"),
    "gear without a ratio": (HEAD + "    gear: ¶{torque_constant: 0.1}\n", "the key 'ratio' is missing"),
    "gear ratio of zero": (HEAD + "    gear: {ratio: ¶0}\n", "link 1: gear: ratio is 0"),
    "gear ratio by name": (HEAD + "    gear: {ratio: ¶r}\n", "a name cannot stand here"),
    "torque constant negative": (
        HEAD + "    gear: {ratio: 2, torque_constant: ¶-0.1}\n",
        "torque_constant is not positive; found -0.1 N m/A",
    ),
}


@pytest.mark.parametrize("case", BROKEN)
def test_refused_at_its_place_in_one_line(case: str) -> None:
    marked, message = BROKEN[case]
    text, line, column = _pointed(marked)
    with pytest.raises(InputError) as caught:
        calls_of(lambda: read_text(text, "arm.yaml", strict=True), most=200_000)
    told = str(caught.value)
    assert told.startswith(f"arm.yaml:{line}:{column}: "), told
    assert message in told
    assert "\n" not in told
    assert told.isprintable()
    assert len(told) < 700
    assert caught.value.exit_code == 2
    assert caught.value.__cause__ is None


@pytest.mark.parametrize("case", BROKEN)
def test_the_python_parser_of_yaml_refuses_too(case: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where PyYAML was built without libyaml."""
    import yaml

    monkeypatch.delattr(yaml, "CSafeLoader", raising=False)
    with pytest.raises(InputError, match=r"\Aarm\.yaml:\d+:\d+: "):
        read_text(_pointed(BROKEN[case][0])[0], "arm.yaml")


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
