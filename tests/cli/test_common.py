"""What the commands share: loading, JSON, writing files whole or not at all, and comparing them."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import robodyn_cli
from robodyn.errors import InputError
from robodyn.outputs import write_files

FILES = {"a.c": "int a;\n", "sub/b.h": "/* \u03c4 */\n"}


def everything(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_nothing_is_written_where_not_all_can_be(tmp_path: Path) -> None:
    folder = tmp_path / "folder"
    (folder / "sub" / "b.h").mkdir(parents=True)
    with pytest.raises(InputError, match=r"cannot write .*b\.h") as caught:
        write_files(folder, FILES)
    assert caught.value.remedy
    assert everything(folder) == {}
    (tmp_path / "sub").write_text("a file")
    with pytest.raises(InputError, match="cannot write"):
        write_files(tmp_path, FILES)
    with pytest.raises(InputError, match=r"cannot write .*: File name too long; choose another path"):
        write_files(tmp_path / "new" / ("x" * 300), FILES)
    with pytest.raises(UnicodeEncodeError):
        write_files(tmp_path / "new", {"a.c": "fine", "deep/b.c": "\ud800"})
    assert {path.name for path in tmp_path.iterdir()} == {"folder", "sub"}


def test_no_class_is_of_a_generic_type_of_click() -> None:
    """Click 8.1 and 8.2 have none: ``click.ParamType[str]`` is an error there."""
    for path in Path(robodyn_cli.__file__).parent.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            for base in node.bases if isinstance(node, ast.ClassDef) else ():
                assert not (isinstance(base, ast.Subscript) and "click" in ast.unparse(base)), path
