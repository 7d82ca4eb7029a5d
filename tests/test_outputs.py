"""What robodyn did not write stays, and nothing is written through a link."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from robodyn.errors import InputError
from robodyn.outputs import LIST, SENTENCE, check_outputs, replace_file, write_files
from robodyn_testing import require_tool

CODE = f"/* {SENTENCE} */\nint a;\n"
FILES = {"a.c": CODE, "sub/b.json": "{}\n"}


@pytest.fixture
def out(tmp_path: Path) -> Path:
    folder = tmp_path / "out"
    folder.mkdir()
    return folder


def tree(folder: Path) -> dict[str, str]:
    return {
        str(path.relative_to(folder)): f"-> {path.readlink()}" if path.is_symlink() else path.read_text()
        for path in sorted(folder.rglob("*"))
        if path.is_symlink() or path.is_file()
    }


def refused(folder: Path, message: str, **how: Any) -> str:
    """What is said of :data:`FILES` that are not written into ``folder``; nothing else is there then."""
    before = tree(folder.parent)
    with pytest.raises(InputError, match=message) as caught:
        write_files(folder, FILES, **how)
    assert caught.value.exit_code == 2
    assert tree(folder.parent) == before
    return str(caught.value.remedy)


@pytest.mark.parametrize("name", FILES)
def test_a_file_of_somebody_else_stays(name: str, out: Path) -> None:
    (out / name).parent.mkdir(exist_ok=True)
    (out / name).write_text("/* mine; it calls code Written by robodyn 1.0 */\n")
    assert "--force" not in refused(out, f"{name} is in the way, which robodyn did not write")
    assert "--force" in refused(out, f"{name} is in the way", force=False)
    write_files(out, FILES, force=True)
    assert {**FILES, LIST: tree(out)[LIST]} == tree(out)
    write_files(out, FILES | {"sub/b.json": "[]\n"})  # now it is robodyn's


def test_what_says_so_is_written_again_and_what_is_listed_unless_edited(out: Path) -> None:
    write_files(out, FILES)
    (out / "a.c").write_text(f"{CODE}/* edited, in spite of its head */\n")
    write_files(out, FILES | {"sub/b.json": "[1]\n"})
    assert tree(out)["a.c"] == CODE
    (out / "sub/b.json").write_text("[2]\n")
    refused(out, r"sub/b\.json is in the way, which was edited since robodyn wrote it")
    write_files(out, {"sub/b.json": "[2]\n"})  # the same: nobody loses anything
    write_files(out, FILES)
    assert tree(out)["sub/b.json"] == FILES["sub/b.json"]


def test_the_list_is_what_sha256sum_reads(out: Path) -> None:
    require_tool("sha256sum")
    write_files(out, FILES)
    write_files(out, {"c.csv": "t\n"})
    command = ["sha256sum", "--check", "--strict", "--quiet", LIST]
    assert subprocess.run(command, cwd=out, check=False).returncode == 0
    assert tree(out)[LIST].count("\n") == 3  # its head, and the two that do not say whose they are


def a_link(out: Path) -> None:
    (out.parent / "precious").write_text(CODE)
    (out / "a.c").symlink_to("../precious")


def a_broken_link(out: Path) -> None:
    (out / "a.c").symlink_to("../nowhere")


def a_link_to_itself(out: Path) -> None:
    (out / "a.c").symlink_to("a.c")


@pytest.mark.parametrize("link", [a_link, a_broken_link, a_link_to_itself])
def test_a_link_is_never_followed(link: Callable[[Path], None], out: Path) -> None:
    link(out)
    for how in ({}, {"force": False}, {"named": True}):
        refused(out, r"a\.c is a symbolic link, through which nothing is written", **how)
    outside = {name: text for name, text in tree(out.parent).items() if not name.startswith("out/")}
    write_files(out, FILES, force=True)
    assert tree(out)["a.c"] == CODE
    assert {name: text for name, text in tree(out.parent).items() if not name.startswith("out/")} == outside


@pytest.mark.parametrize("force", [False, True])
def test_a_folder_that_is_a_link_is_refused(force: bool, out: Path) -> None:
    (out.parent / "elsewhere").mkdir()
    (out / "sub").symlink_to("../elsewhere")
    refused(out, r"out/sub is a symbolic link", force=force)
    assert list((out.parent / "elsewhere").iterdir()) == []


def test_the_folder_itself_may_be_a_link(out: Path) -> None:
    (out.parent / "named").symlink_to("out")
    write_files(out.parent / "named", FILES)
    assert tree(out)["a.c"] == CODE


def test_another_name_of_the_same_file_keeps_what_it_had(out: Path) -> None:
    (out / "a.c").write_text(f"{CODE}/* old */\n")
    os.link(out / "a.c", out.parent / "other")
    write_files(out, FILES)
    assert (out.parent / "other").read_text() == f"{CODE}/* old */\n"


def test_a_file_that_the_command_line_names_is_replaced(out: Path) -> None:
    (out / "a.c").write_text("an earlier picture")
    check_outputs(out, ["a.c"], named=True)
    write_files(out, {"a.c": "new"}, named=True)
    assert tree(out) == {"a.c": "new"}


def test_a_link_in_place_of_the_list(out: Path) -> None:
    (out.parent / "precious").write_text(f"# {SENTENCE}\n")
    (out / LIST).symlink_to("../precious")
    for force in (False, True):
        refused(out, r"\.robodyn\.sha256 is not the list that robodyn writes", force=force)


def test_a_link_in_place_of_a_temporary_file(out: Path) -> None:
    (out.parent / "precious").write_text("mine")
    for name in ("0", "1", "2", "one"):
        (out / f".robodyn.{os.getpid()}.{name}.tmp").symlink_to("../precious")
    write_files(out, {"a.c": CODE, "b.c": CODE})
    replace_file(out / "c.c", CODE.encode())
    assert (out.parent / "precious").read_text() == "mine"
    assert tree(out)["c.c"] == CODE
