"""What the commands share: loading, JSON, writing files whole or not at all, and comparing them."""

from __future__ import annotations

from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn_cli.common import compare_files, echo_json, load_robot, write_files

FILES = {"a.c": "int a;\n", "sub/b.h": "/* \u03c4 */\n"}


def everything(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_writes_and_compares(tmp_path: Path) -> None:
    folder = tmp_path / "new" / "folder"
    assert compare_files(folder, FILES) == ["a.c", "sub/b.h"]
    assert write_files(folder, FILES) == [folder / "a.c", folder / "sub" / "b.h"]
    assert everything(folder) == {name: text.encode() for name, text in FILES.items()}
    assert compare_files(folder, FILES) == []
    (folder / "sub" / "b.h").write_bytes(b"/* \xcf\x84 */\r\n")
    assert compare_files(folder, FILES) == ["sub/b.h"]


def test_overwrites(tmp_path: Path) -> None:
    (tmp_path / "a.c").write_text("old")
    write_files(tmp_path, FILES)
    assert compare_files(tmp_path, FILES) == []


def test_nothing_is_written_where_something_is_in_the_way(tmp_path: Path) -> None:
    (tmp_path / "a.c").write_text("old")
    (tmp_path / "sub" / "b.h").mkdir(parents=True)
    with pytest.raises(InputError, match=r"cannot write .*b\.h") as caught:
        write_files(tmp_path, FILES)
    assert caught.value.remedy
    assert everything(tmp_path) == {"a.c": b"old"}


def test_folder_under_a_file(tmp_path: Path) -> None:
    (tmp_path / "sub").write_text("a file")
    with pytest.raises(InputError, match="cannot write"):
        write_files(tmp_path, FILES)
    assert everything(tmp_path) == {"sub": b"a file"}


def test_an_error_on_the_way_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(UnicodeEncodeError):
        write_files(tmp_path / "new", {"a.c": "fine", "deep/b.c": "\ud800"})
    assert list(tmp_path.iterdir()) == []


def test_json_refuses_nan(capsys: pytest.CaptureFixture[str]) -> None:
    echo_json({"name": "\u03bb", "n": [1, None]})
    assert capsys.readouterr().out == '{\n  "name": "\u03bb",\n  "n": [\n    1,\n    null\n  ]\n}\n'
    with pytest.raises(ValueError, match="nan"):
        echo_json(float("nan"))


def test_doubts_are_told_on_stderr(capsys: pytest.CaptureFixture[str]) -> None:
    assert load_robot("puma560").name == "puma560"
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("robodyn: warning: puma560.yaml:")
    with pytest.raises(InputError, match="inertia"):
        load_robot("puma560", strict=True)
