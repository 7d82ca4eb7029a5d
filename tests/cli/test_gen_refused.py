"""What robodyn gen refuses, where it cannot write, and --compile."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from cli.generated import FILES, TOOL, Capture, gen, tree
from robodyn import outputs
from robodyn.kernels.generate import Options, generate
from robodyn.robot import bundled_text, load
from robodyn_cli.main import main
from robodyn_testing import require_tool

pytestmark = pytest.mark.usefixtures("elsewhere")

# --- what is refused --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "hint"),
    [
        (["--functions", "inverse_dynamic"], "did you mean 'inverse_dynamics'?"),
        (["--functions", "gravity,gravity"], "twice"),
        (["--functions", ","], "no function asked for"),
        (["--functions", ""], "no function asked for"),
        (["--lang", "c,fortan"], "did you mean 'fortran'?"),
        (["--lang", "cpp"], "one of c, fortran"),
        (["--lang", ""], "--lang names no language"),
        (["--scalar", "doubl"], "did you mean 'double'?"),
        (["--trig", "gven"], "did you mean 'given'?"),
        (["--formulation", "lagrange_"], "one of modified_newton_euler, newton_euler"),
        (["--optimize", "fastest"], "did you mean 'fast'?"),
        (["--engine", "sympi"], "did you mean 'sympy'?"),
        (["--optimise", "fast"], "--optimize"),
        (["--chek"], "--check"),
        (["--function", "gravity"], "--functions"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else None,
)
def test_what_is_unknown_gets_a_hint(
    arguments: list[str], hint: str, elsewhere: Path, capsys: Capture
) -> None:
    out, err = gen(capsys, "stanford_3dof", *arguments, code=2)
    assert out == ""
    assert hint in err
    assert tree(elsewhere) == {}


def test_a_robot_that_is_not_there_or_wrong(elsewhere: Path, capsys: Capture) -> None:
    assert "stanford" in gen(capsys, "stanfrod", code=2)[1]
    (elsewhere / "bad.yaml").write_text("name: bad\nlinks:\n  - joint: revolute\n    mass: -1\n")
    _, err = gen(capsys, "bad.yaml", code=2)
    assert err.startswith("robodyn: error: bad.yaml:4:11: link 1: mass is negative")
    assert len(err.splitlines()) == 1
    assert set(tree(elsewhere)) == {"bad.yaml"}


def test_doubtful_numbers_warn_and_strict_refuses_them(elsewhere: Path, capsys: Capture) -> None:
    lines = bundled_text("puma560_3dof").splitlines(keepends=True)
    (elsewhere / "arm.yaml").write_text("".join(line for line in lines if "acknowledged" not in line))
    assert main(["gen", "arm.yaml"]) == 0
    assert capsys.readouterr().err.startswith("robodyn: warning: arm.yaml:")
    shutil.rmtree(elsewhere / "generated")
    assert main(["gen", "puma560_3dof"]) == 0
    assert "warning" not in capsys.readouterr().err
    shutil.rmtree(elsewhere / "generated")
    for refused in ("arm.yaml", "puma560_3dof"):
        assert "inertia is not physical" in gen(capsys, refused, "--strict", code=2)[1]
    assert list(tree(elsewhere)) == ["arm.yaml"]


def test_an_arm_without_forward_dynamics(elsewhere: Path, capsys: Capture) -> None:
    out, err = gen(capsys, "tx40", "-o", "out", "--lang", "c")
    assert "forward_dynamics" not in out
    assert err == "robodyn: note: tx40 has no forward_dynamics: a joint that moves without inertia"
    assert "forward" not in (elsewhere / "out" / "tx40.h").read_text()
    _, err = gen(capsys, "tx40", "-o", "other", "--functions", "gravity,forward_dynamics", code=2)
    assert "tx40 has no forward dynamics" in err
    assert "motor_inertia" in err
    assert not (elsewhere / "other").exists()


@pytest.mark.parametrize("scalar", ["float", "double"])
def test_numbers_that_do_not_fit(scalar: str, elsewhere: Path, capsys: Capture) -> None:
    com = {"float": "1e20", "double": "1e200"}[scalar]
    (elsewhere / "far.yaml").write_text(
        f"name: far\nlinks: [{{joint: revolute, mass: 1, com: [{com}, 0, 0]}}]\n"
    )
    _, err = gen(capsys, "far.yaml", "--scalar", scalar, "-o", "out", code=2)
    assert f"does not fit into a {scalar}" in err
    assert not (elsewhere / "out").exists()


# --- places where nothing can be written ------------------------------------------------------------------


def test_a_file_is_in_the_way_of_the_folder(elsewhere: Path, capsys: Capture) -> None:
    (elsewhere / "out").write_text("a file")
    for place in ("out", "out/below"):
        _, err = gen(capsys, "stanford_3dof", "-o", place, code=2)
        assert err.startswith("robodyn: error: cannot write out")
        assert "-o" in err
        assert len(err.splitlines()) == 1
    assert tree(elsewhere) == {"out": "a file"}


@pytest.mark.parametrize("name", sorted(FILES))
def test_a_folder_is_in_the_way_of_a_file(name: str, elsewhere: Path, capsys: Capture) -> None:
    """Whichever of the files it is, none of the others is written."""
    (elsewhere / "out" / name).mkdir(parents=True)
    _, err = gen(capsys, "stanford_3dof", "-o", "out", code=2)
    assert f"cannot write out/{name}" in err
    assert tree(elsewhere) == {f"out/{name}": "a folder"}


def test_a_place_that_is_no_place(capsys: Capture) -> None:
    _, err = gen(capsys, "stanford_3dof", "-o", "/dev/null/out", code=2)
    assert err.startswith("robodyn: error: cannot write /dev/null/out/")


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


# --- --compile --------------------------------------------------------------------------------------------


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


def test_no_name_is_no_folder(elsewhere: Path, capsys: Capture) -> None:
    _, err = gen(capsys, "stanford_3dof", "-o", "", code=2)
    assert "is empty" in err
    assert list(elsewhere.iterdir()) == []


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
