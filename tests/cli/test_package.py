"""``robodyn package``: where a package goes, what is said, what is refused."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from robodyn_cli.main import main

Capture = pytest.CaptureFixture[str]
GRAVITY = ("--functions", "gravity", "--optimize", "fast")


@pytest.fixture(autouse=True)
def _there(elsewhere: Path) -> None:
    """In a folder of the test's own."""


def package(capsys: Capture, *arguments: str, code: int = 0) -> tuple[str, str]:
    """What is said on both streams."""
    assert main(["package", "stanford_3dof", *arguments]) == code
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return out, err


def test_writes_a_folder_and_says_what_to_do_with_it(capsys: Capture) -> None:
    out, _ = package(capsys, "--as", "cmake", *GRAVITY, "--version", "2.1.0")
    folder = Path("packages/stanford_3dof/cmake")
    assert out.splitlines() == [
        "stanford_3dof: wrote a CMake package of 7 files in packages/stanford_3dof/cmake",
        "stanford_3dof_dynamics 2.1.0: gravity (4 operations)",
        "next: cmake -S packages/stanford_3dof/cmake -B build && cmake --build build && "
        "cmake --install build --prefix PREFIX",
    ]
    assert "VERSION 2.1.0" in (folder / "CMakeLists.txt").read_text()
    assert len([path for path in folder.rglob("*") if path.is_file()]) == 7


def test_the_kernel_is_what_gen_writes(capsys: Capture) -> None:
    options = (*GRAVITY, "--scalar", "float", "--trig", "builtin", "--misra")
    package(capsys, "--as", "cmake", "-o", "out", *options)
    assert main(["gen", "stanford_3dof", "--lang", "c", "-o", "gen", *options]) == 0
    for path, name in (("src", "stanford_3dof.c"), ("include/stanford_3dof_dynamics", "stanford_3dof.h")):
        assert Path("out", path, name).read_bytes() == Path("gen", name).read_bytes()


def test_check_compares(capsys: Capture) -> None:
    arguments = ("--as", "cmake", "-o", "out", *GRAVITY)
    _, err = package(capsys, *arguments, "--check", code=1)
    assert "out/README.md, " in err
    assert not Path("out").exists()
    package(capsys, *arguments)
    assert package(capsys, *arguments, "--check")[0] == "stanford_3dof: 7 files in out are up to date\n"
    (Path("out") / "README.md").write_text("mine")
    assert "out/README.md: not up to date" in package(capsys, *arguments, "--check", code=1)[1]


def test_json(capsys: Capture) -> None:
    report = json.loads(package(capsys, "--as", "cmake", "-o", "o u t", *GRAVITY, "--json")[0])
    assert (report["robot"], report["format"], report["package"]) == (
        "stanford_3dof",
        "cmake",
        "stanford_3dof_dynamics",
    )
    assert [Path(path).is_file() for path in report["files"]] == [True] * 7
    assert report["functions"][0]["function"] == "gravity"
    assert "-S 'o u t' " in report["take"]


def test_what_robodyn_did_not_write_stays(capsys: Capture) -> None:
    Path("CMakeLists.txt").write_text("project(mine)\n")
    _, err = package(capsys, "--as", "cmake", "-o", ".", *GRAVITY, code=2)
    assert "CMakeLists.txt is in the way, which robodyn did not write; expected nothing there" in err
    assert [path.name for path in Path().iterdir()] == ["CMakeLists.txt"]
    Path("CMakeLists.txt").unlink()
    package(capsys, "--as", "cmake", "-o", ".", *GRAVITY)
    package(
        capsys, "--as", "cmake", "-o", ".", *GRAVITY, "--version", "0.2.0"
    )  # its own files, written again
    assert "VERSION 0.2.0" in Path("CMakeLists.txt").read_text()


def test_a_folder_where_a_file_should_be_stays_too(capsys: Capture) -> None:
    (Path("out") / "README.md").mkdir(parents=True)
    _, err = package(capsys, "--as", "cmake", "-o", "out", *GRAVITY, code=2)
    assert "cannot write out/README.md; found something that is not a file" in err
    assert [path.name for path in Path("out").iterdir()] == ["README.md"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "Missing option '--as'"),
        (("--as", "cmak"), "unknown format of a package 'cmak'"),
        (("--as", "cmake", "--version", "1"), "this is no version of a package"),
        (("--as", "cmake", "-o", ""), "the path after -o is empty"),
        (("--as", "cmake", "--functions", "gravty"), "unknown function 'gravty'"),
    ],
)
def test_what_is_refused(capsys: Capture, arguments: tuple[str, ...], message: str) -> None:
    assert message in package(capsys, *arguments, code=2)[1]
    assert not list(Path().iterdir())
