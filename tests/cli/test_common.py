"""What the commands share: loading, JSON, writing files whole or not at all, and comparing them."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import robodyn_cli
from cli.command import Capture
from robodyn.errors import CheckError, InputError
from robodyn.outputs import LIST, write_files
from robodyn.resources import data_dir
from robodyn_cli.output import echo_json, printable
from robodyn_cli.output_files import output_folder, report_up_to_date
from robodyn_cli.robot_files import load_robot

FILES = {"a.c": "int a;\n", "sub/b.h": "/* \u03c4 */\n"}


def everything(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_writes_and_compares(tmp_path: Path) -> None:
    folder = tmp_path / "new" / "folder"
    with pytest.raises(CheckError, match=r"a\.c, .*b\.h: not up to date"):
        report_up_to_date("arm", folder, FILES)
    assert write_files(folder, FILES) == [folder / "a.c", folder / "sub" / "b.h"]
    written = everything(folder)
    assert written.pop(LIST)
    assert written == {name: text.encode() for name, text in FILES.items()}
    report_up_to_date("arm", folder, FILES)
    (folder / "sub" / "b.h").write_bytes(b"/* \xcf\x84 */\r\n")
    with pytest.raises(CheckError, match=r"folder/sub/b\.h: not up to date"):
        report_up_to_date("arm", folder, FILES)


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


def test_names_of_places_and_json(capsys: Capture) -> None:
    with pytest.raises(InputError, match="is empty"):
        output_folder("")
    assert printable(Path("some/place it's")) == "some/place it's"
    assert printable("a\x1bb\n") == "'a\\x1bb\\n'"
    echo_json({"name": "\u03bb", "n": [1, None]})
    assert capsys.readouterr().out == '{\n  "name": "\u03bb",\n  "n": [\n    1,\n    null\n  ]\n}\n'
    with pytest.raises(ValueError, match="nan"):
        echo_json(float("nan"))


def test_doubts_are_told_on_stderr(capsys: Capture, tmp_path: Path) -> None:
    """The bundled arm acknowledges its own: it is the same arm without that."""
    lines = (data_dir("robots") / "puma560.yaml").read_text(encoding="utf-8").splitlines(keepends=True)
    file = tmp_path / "puma560.yaml"
    file.write_text("".join(line for line in lines if "acknowledged:" not in line), encoding="utf-8")
    assert load_robot("puma560").name == "puma560"
    assert capsys.readouterr() == ("", "")
    assert load_robot(str(file)).name == "puma560"
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith(f"robodyn: warning: {file}:")
    with pytest.raises(InputError, match="inertia"):
        load_robot("puma560", strict=True)


def test_no_class_is_of_a_generic_type_of_click() -> None:
    """Click 8.1 and 8.2 have none: ``click.ParamType[str]`` is an error there."""
    for path in Path(robodyn_cli.__file__).parent.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            for base in node.bases if isinstance(node, ast.ClassDef) else ():
                assert not (isinstance(base, ast.Subscript) and "click" in ast.unparse(base)), path
