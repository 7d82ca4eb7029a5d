"""``robodyn gen`` on a full disk, ``--compile`` and ``--batch``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from cli.generated import FILES, TOOL, Capture, gen, tree
from robodyn import outputs
from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
from robodyn_testing import require_tool

pytestmark = pytest.mark.usefixtures("elsewhere")


def test_a_disk_that_is_full_halfway(
    elsewhere: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The second file does not fit: the first is not there either, nor anything temporary."""
    create, calls = outputs._create, list[Path]()

    def full(path: Path, content: bytes) -> None:
        calls.append(path)
        if len(calls) == 2:
            raise OSError(28, "No space left on device")
        create(path, content)

    monkeypatch.setattr(outputs, "_create", full)
    _, err = gen(capsys, "stanford_3dof", "-o", "new/folder", code=74)
    assert "No space left on device" in err
    assert len(calls) == 2
    assert list(elsewhere.iterdir()) == []


def test_compile_builds_loads_and_compares(elsewhere: Path, capsys: Capture) -> None:
    require_tool("gcc")
    require_tool("gfortran")
    (elsewhere / "tool.yaml").write_text(TOOL)
    out, err = gen(capsys, "tool.yaml", "--compile", "-o", "out")
    last = out.splitlines()[-3:]
    assert last[0].startswith("c: compiled with ")
    assert last[1].startswith("fortran: compiled with GNU Fortran")
    assert last[2] == "c and fortran: the same bits on 100 states"
    assert err == ""
    assert {path.name for path in (elsewhere / "out").iterdir()} == {"tool.h", "tool.c", "tool.f90"}


def test_compile_without_a_fortran_compiler_is_noted(
    elsewhere: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    require_tool("gcc")
    monkeypatch.setenv("FC", "/nonexistent")
    out, _ = gen(capsys, "stanford_3dof", "--compile", "-o", "out")
    note = out.splitlines()[-1]
    assert note.startswith("fortran: written, not compiled: ")
    assert "/nonexistent" in note
    assert {path.name for path in (elsewhere / "out").iterdir()} == FILES
    found = json.loads(gen(capsys, "stanford_3dof", "--compile", "-o", "out", "--json")[0])
    assert found["compiled"].keys() == {"c", "fortran"}


def test_compile_without_the_fortran_compiler_that_was_asked_for(
    elsewhere: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    require_tool("gcc")
    monkeypatch.setenv("FC", "/nonexistent")
    _, err = gen(capsys, "stanford_3dof", "--compile", "--lang", "fortran", code=3)
    assert "FC" in err
    assert tree(elsewhere) == {}


def test_compile_without_a_c_compiler_is_a_missing_tool(
    elsewhere: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CC", "/nonexistent")
    out, err = gen(capsys, "stanford_3dof", "--compile", code=3)
    assert out == ""
    assert err.startswith("robodyn: error: there is no C compiler '/nonexistent' (CC names it)")
    assert tree(elsewhere) == {}


def test_compile_with_given_sines_in_float(capsys: Capture) -> None:
    require_tool("gcc")
    require_tool("gfortran")
    out, _ = gen(
        capsys,
        "stanford_3dof",
        "--compile",
        "--scalar",
        "float",
        "--trig",
        "given",
        "--functions",
        "bias,gravity",
    )
    assert out.splitlines()[-1] == "c and fortran: the same bits on 100 states"


def test_compile_compares_functions_with_results_of_different_shapes(capsys: Capture) -> None:
    require_tool("gcc")
    require_tool("gfortran")
    out, _ = gen(capsys, "stanford_3dof", "--compile", "--functions", "link_poses,controller")
    assert out.splitlines()[-1] == "c and fortran: the same bits on 100 states"


def test_without_compile_no_compiler_is_looked_for(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", "/nonexistent")
    monkeypatch.setenv("FC", "/nonexistent")
    monkeypatch.setenv("PATH", "")
    gen(capsys, "stanford_3dof")
    assert Path("generated/stanford_3dof/stanford_3dof.c").is_file()


def test_different_bits_are_a_failed_check(
    elsewhere: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A compiler that was told to be fast and not exact: nothing is written."""
    require_tool("gfortran")
    import robodyn_cli.gen

    monkeypatch.setattr(robodyn_cli.gen, "_same_bits", lambda *_: False)
    _, err = gen(capsys, "stanford_3dof", "-o", "out", "--compile", code=1)
    assert "different bits" in err
    assert not (elsewhere / "out").exists()


def test_batch(capsys: Capture, elsewhere: Path) -> None:
    """The files of batches, compiled with the kernels; checked like them."""
    require_tool("cc")
    arguments = ("stanford_3dof", "--batch", "--functions", "inverse_dynamics", "--lang", "c")
    gen(capsys, *arguments, "--compile", "-o", "out")
    made = generate(load("stanford_3dof", warn=lambda _: None), Options(functions=("inverse_dynamics",)))
    assert tree(elsewhere / "out") == made.files(("c",), batch=True)
    gen(capsys, *arguments, "--check", "-o", "out")
    (elsewhere / "out" / "stanford_3dof_lanes.h").unlink()
    gen(capsys, *arguments, "--check", "-o", "out", code=1)
    _, err = gen(capsys, "stanford_3dof", "--batch", "--lang", "fortran", code=2)
    assert "batches are in C only" in err
