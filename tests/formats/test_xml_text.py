"""Files that are not well-formed XML, or not in UTF-8: the arm that other readers see, and a warning."""

from __future__ import annotations

import codecs
from pathlib import Path

import numpy as np
import pytest

import robodyn
from robodyn.errors import InputError
from robodyn.formats.arm import import_arm
from robodyn.formats.elements import parse
from robodyn.formats.xml_text import ENCODINGS, xml_text
from robodyn.robot import to_yaml
from robodyn_cli.main import main
from robodyn_testing import require_module
from robodyn_testing.arms import RigidArm
from robodyn_testing.urdf_text import joint, link, robot
from robodyn_testing.xacro_arms import HEAD, arm, write

LIMIT = '<limit lower="-1" upper="2" effort="9" velocity="9"/>'
ARM = robot(link("a"), link("b"), joint("j", "a", "b", inside=f'<axis xyz="0 1 0"/>{LIMIT}'))
DECLARED = '<?xml version="1.0" encoding="%s"?>\n'
COMMENT = "<!-- M\N{LATIN SMALL LETTER A WITH DIAERESIS}rz -->"

#: What is before and in the arm, its encoding, and what the warning says, with its place.
READ: dict[str, tuple[str, str, str]] = {
    "hyphens": ("\n<!-- a -- b -->", "utf-8", ":2:8: hyphens in a row in a comment are not"),
    "rule": ("<!--------->\n<!-- a --->", "utf-8", ":1:5: hyphens in a row in a comment, here and in 1 more"),
    "comment of markup": ('<!-- <link name="--"/> <?x --><!-- <![CDATA[ -- -->', "utf-8", ":1:18: hyphens"),
    "hyphens elsewhere": ("<?x -- <!-- ?><!-- a - b -->", "utf-8", ""),
    "blank line": ('\n <?xml version="1.0"?>', "utf-8", ":2:2: something stands before <?xml"),
    "carriage return": ('\r\n\r\n<?xml version="1.0"?>', "utf-8", ":3:1: something stands before <?xml"),
    "mark": ('\ufeff<?xml version="1.0"?>', "utf-8", ""),
    "mark after a line": ('\n\ufeff<?xml version="1.0"?>', "utf-8", ":2:2: something stands before <?xml"),
    "mark twice": ("\ufeff\ufeff", "utf-8", ":1:1: a byte order mark"),
    "latin-1": (DECLARED % "ISO-8859-1" + COMMENT, "latin-1", ""),
    "single quotes": ("<?xml version='1.0' encoding='Latin1' ?>" + COMMENT, "latin-1", ""),
    "utf-16": (DECLARED % "UTF-16" + COMMENT, "utf-16", ""),
    "utf-16 undeclared": (COMMENT, "utf-16", ""),
    "utf-16, big end": ("\ufeff" + DECLARED % "UTF-16" + COMMENT, "utf-16-be", ""),
    "utf-16 without mark": (DECLARED % "UTF-16" + COMMENT, "utf-16-le", ":1:31: a file in UTF-16 has no"),
    "mark of another": ("\ufeff" + DECLARED % "ISO-8859-1" + COMMENT, "utf-8", ":1:31: the file declares"),
    "both": ("\n" + DECLARED % "Latin-1" + COMMENT + "<!-- -- -->", "latin-1", ":2:1: something stands"),
}


@pytest.mark.parametrize("case", READ)
def test_the_arm_is_that_of_the_plain_file(case: str, tmp_path: Path) -> None:
    before, encoding, words = READ[case]
    path = tmp_path / "arm.urdf"
    path.write_bytes((before + ARM).encode(encoding))
    imported = import_arm(path)
    path.write_text(ARM)
    assert imported.robot == import_arm(path).robot
    warnings = [f"{where}: {said}" for where, said in imported.warnings]
    assert len(warnings) == (2 if case == "both" else bool(words)), warnings
    assert warnings[:1] == [] if not words else warnings[0].startswith(f"{path}{words}")


@pytest.mark.parametrize("case", ["hyphens", "rule", "blank line", "mark", "mark after a line", "latin-1"])
def test_pinocchio_reads_the_same_file(case: str, tmp_path: Path) -> None:
    pinocchio = require_module("pinocchio")
    path = tmp_path / "arm.urdf"
    before, encoding, _ = READ[case]
    path.write_bytes((before + ARM).encode(encoding))
    model = pinocchio.buildModelFromUrdf(str(path))
    q, qd, qdd = np.array([[0.3], [-0.4], [0.7]])
    assert RigidArm(import_arm(path).robot).torques(q, qd, qdd) == pytest.approx(
        pinocchio.rnea(model, model.createData(), q, qd, qdd), abs=1e-9
    )


@pytest.mark.parametrize("encoding", ["latin-1", "utf-16", "cp1251", "shift_jis"])
def test_letters_and_later_places_are_those_of_the_file(encoding: str) -> None:
    letter = {
        "latin-1": "\N{LATIN SMALL LETTER A WITH DIAERESIS}",
        "shift_jis": "\N{CJK UNIFIED IDEOGRAPH-624B}",
    }
    name = letter.get(encoding, "\N{CYRILLIC SMALL LETTER YA}") * 3
    text = f'\n\n{DECLARED % encoding}<robot name="{name}">\n<!-- -- --> <link name="{name}" x="1"/></robot>'
    document = parse(text.encode(encoding), "arm.urdf")
    assert document.root.attributes["name"] == name
    (element,) = document.root.children
    assert (element.line, element.column) == (5, 13)
    assert str(document.place(element, "x")) == "arm.urdf:5:30"


#: Texts stand in refusals/urdf.yaml.
REFUSED: dict[str, tuple[bytes, str]] = {
    "undeclared": (
        f"\n{COMMENT}{ARM}".encode("latin-1"),
        ":2:7: the file is not UTF-8 text; found byte 0xe4; save the file as UTF-8, or declare what it is",
    ),
    "not what it declares": (
        (DECLARED % "UTF-8" + COMMENT + ARM).encode("latin-1"),
        ":2:7: the file is not UTF-8 text; found byte 0xe4; save",
    ),
    "undefined byte": (
        (DECLARED % "windows-1252").encode() + b"\r\n <!-- \x81 -->" + ARM.encode(),
        ":3:7: the file is not windows-1252 text; found byte 0x81",
    ),
    "utf-8 that is utf-16": (
        (DECLARED % "utf-8" + ARM).encode("utf-16"),
        ":1:31: the file is not in the encoding that it declares; found 'utf-8', but the text is UTF-16",
    ),
    "half a character": ((COMMENT + ARM).encode("utf-16") + b"<", "the file is not UTF-16 text"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_no_xml_is_refused_with_its_place(case: str) -> None:
    data, words = REFUSED[case]
    with pytest.raises(InputError) as caught:
        parse(data, "arm.urdf")
    assert str(caught.value).startswith("arm.urdf:")
    assert words in str(caught.value)


def test_every_encoding_is_one_of_pythons_and_of_text() -> None:
    for name in ENCODINGS:
        data = ('<?xml version="1.0" encoding="{}"?><r/>'.format(name.replace("_", "-"))).encode(name)
        assert codecs.lookup(name)
        assert xml_text(data, "x").text.endswith("<r/>")


def test_a_mend_takes_time_that_grows_with_the_file() -> None:
    """A time that grew with its square would be hours."""
    data = b"<!-- -- -->" * 300_000 + b"<!--" * 300_000
    assert len(xml_text(data, "x").text) == len(data)


def test_who_loads_and_imports_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text(f"\n<!-- -- -->{ARM}")
    heard: list[str] = []
    robodyn.load(path, warn=heard.append)
    assert [line for line in heard if line.startswith(f"{path}: line 2, column 6: hyphens in a row")]
    assert main(["import", str(path)]) == 0
    assert f"robodyn: note: {path}: line 2, column 6: hyphens in a row" in capsys.readouterr().err


def test_files_that_a_xacro_file_includes(tmp_path: Path) -> None:
    require_module("xacro")
    mass = '<xacro:property name="m" value="7"/>'
    write(tmp_path, {"arm.xacro": "\n" + arm('<!-- -- --><xacro:include filename="m.xacro"/>')})
    included = f"<!-- M\xe4rz --><!-- -- -->{HEAD.partition('?>')[2]}{mass}</robot>"
    (tmp_path / "m.xacro").write_bytes((DECLARED % "ISO-8859-1" + included).encode("latin-1"))
    imported = import_arm(tmp_path / "arm.xacro")
    assert "mass: 7" in to_yaml(imported.robot)
    assert [str(where) for where, _ in imported.warnings] == [
        f"{tmp_path}/arm.xacro:2:1",
        f"{tmp_path}/arm.xacro:2:{2 + len(HEAD) + 4}",
        f"{tmp_path}/m.xacro:2:19",
    ]
    (tmp_path / "m.xacro").write_bytes((DECLARED % "UTF-8" + included).encode("latin-1"))
    with pytest.raises(InputError, match=r"m\.xacro:2:7: the file is not UTF-8 text"):
        import_arm(tmp_path / "arm.xacro")
