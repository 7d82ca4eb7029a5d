"""Places, warnings and refusals of MJCF that includes or attaches other files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from robodyn.errors import InputError
from robodyn.formats.arm import how_files_are_read, import_arm, read_tree
from robodyn.formats.serial import serial_chain
from robodyn_cli.main import main
from robodyn_testing import require_module
from robodyn_testing.mjcf_arms import ATTACHED, GRIPPER, HAND, SOLID, arm, write
from robodyn_testing.mujoco_chains import check_chain


@pytest.fixture(autouse=True)
def mujoco() -> Any:
    return require_module("mujoco")


def test_places_in_files_that_are_attached(tmp_path: Path) -> None:
    files = {
        "arm.xml": arm('<attach model="g" body="wrist" prefix="out_"/>', ATTACHED % "hand.xml"),
        "hand.xml": HAND,
        "gripper.xml": "\n" + GRIPPER.replace("<body name", "\n<body name"),
    }
    path = write(tmp_path, files)
    (link,) = [link for link in read_tree(path).links if link.name == "out_in_finger"]
    assert str(link.where) == "gripper.xml:4:1"
    write(tmp_path, {"gripper.xml": files["gripper.xml"].replace('name="k"', 'name="k" type="knee"')})
    with pytest.raises(InputError, match=r"^gripper\.xml:4:\d+: MuJoCo refuses the file; found XML Error"):
        read_tree(path)
    write(tmp_path, {"gripper.xml": files["gripper.xml"].replace('model="gripper">', "><!-- a -- b -->")})
    assert [str(where) for where, _ in read_tree(path).warnings] == ["gripper.xml:2:17"]


REFUSED: dict[str, tuple[dict[str, str], str]] = {
    "itself": (
        {"arm.xml": arm("", ATTACHED % "arm.xml")},
        "arm.xml:1:44: the model attaches itself; found 'arm.xml'",
    ),
    "each other": (
        {"arm.xml": arm("", ATTACHED % "b.xml"), "b.xml": HAND.replace("gripper.xml", "arm.xml")},
        "b.xml:1:49: the model attaches itself",
    ),
    "doubling": (
        {
            f"{i or 'arm'}.xml": arm(
                '<attach model="g" prefix="x"/><attach model="g" prefix="y"/>', ATTACHED % f"{i + 1}.xml"
            )
            for i in range(40)
        }
        | {"40.xml": GRIPPER},
        "with what it includes, the file is too large",
    ),
    "long names of replicas": (
        {"arm.xml": arm(f'<replicate count="900"><site name="{"s" * 40_000}"/></replicate>')},
        "arm.xml:4:24: with what it includes, the file is too large",
    ),
    "long prefix": (
        {"arm.xml": arm(f'<attach model="g" prefix="{"s" * 40_000}"/>', ATTACHED % "b.xml"), "b.xml": HAND},
        "arm.xml:4:19: prefix of <attach> is long",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_refused_has_its_place(case: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    files, words = REFUSED[case]
    write(tmp_path, files)
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError) as caught:
        import_arm("arm.xml")
    assert words in str(caught.value)


def test_a_folder_that_is_stated_may_be_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], mujoco: Any
) -> None:
    files = {
        "scenes/arm.xml": arm('<include file="../parts/a.xml"/>', ATTACHED % "../parts/gripper.xml"),
        "parts/a.xml": '<mujocoinclude><attach model="g" body="palm" prefix="p_"/>'
        f"<body>{SOLID}</body></mujocoinclude>",
        "parts/gripper.xml": GRIPPER,
        "other/a.xml": "<mujocoinclude/>",
    }
    path = write(tmp_path, files)
    with pytest.raises(
        InputError, match=r"outside of the folder; .*state the folder .*--arg 'find NAME=FOLDER'"
    ):
        read_tree(path)
    serial = serial_chain(read_tree(path, {"find parts": str(tmp_path / "parts")}), "arm")
    check_chain(mujoco, mujoco.MjModel.from_xml_path(str(path)), serial, "p_finger", {})
    with (
        how_files_are_read({"find parts": str(tmp_path / "other")}),
        pytest.raises(InputError, match="outside"),
    ):
        read_tree(path)
    monkeypatch.chdir(tmp_path / "scenes")
    assert main(["flops", "arm.xml", "--arg", "find parts=../parts"]) == 0
    assert main(["flops", "arm.xml", "--arg", "mass=3"]) == 2
    assert "arguments are for xacro files; found arm.xml" in capsys.readouterr().err
