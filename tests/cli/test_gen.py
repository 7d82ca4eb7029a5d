"""``robodyn gen``: the files, where they go, what is said, and what is left behind when it fails."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
from robodyn_cli.main import main
from robodyn_testing import require_tool

Capture = pytest.CaptureFixture[str]
FILES = {"stanford_3dof.h", "stanford_3dof.c", "stanford_3dof.f90"}
TOOL = """\
name: tool
links:
  - {joint: revolute, alpha: pi/2, mass: 2, com: [0.1, 0.2, 0], inertia: {zz: 1}}
  - {joint: revolute, a: 0.4, mass: m_tool, com: [0.3, 0, 0.1], friction: {coulomb: c_2}, motor_inertia: 1}
"""


@pytest.fixture(autouse=True)
def elsewhere(
    tmp_path: Path, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> Path:
    """Every test works in a folder of its own, with its own cache of compiled kernels."""
    folder = tmp_path / "here"
    folder.mkdir()
    monkeypatch.chdir(folder)
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path_factory.getbasetemp() / "robodyn-cache"))
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.delenv("FC", raising=False)
    return folder


def gen(capsys: Capture, *arguments: str, code: int = 0) -> tuple[str, str]:
    """Standard output and the lines on standard error that are not doubts about the robot."""
    assert main(["gen", *arguments]) == code
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    lines = [line for line in err.splitlines() if not line.startswith("robodyn: warning: ")]
    return out, "\n".join(lines)


def tree(folder: Path) -> dict[str, str]:
    """Every file under ``folder`` with its text; links and folders by name."""
    return {
        path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8")
        if path.is_file()
        else "a folder"
        for path in sorted(folder.rglob("*"))
        if path.is_file() or not any(path.iterdir())
    }


# --- what is written --------------------------------------------------------------------------------------


def test_files_go_to_generated_under_the_working_folder(elsewhere: Path, capsys: Capture) -> None:
    out, err = gen(capsys, "stanford_3dof")
    expected = generate(load("stanford_3dof")).files()
    assert tree(elsewhere) == {f"generated/stanford_3dof/{name}": text for name, text in expected.items()}
    assert set(expected) == FILES
    assert err == ""
    first, *table = out.splitlines()
    assert first == "stanford_3dof: wrote " + ", ".join(
        f"generated/stanford_3dof/{name}" for name in expected
    )
    assert table[0].split()[:2] == ["mul", "add"]
    assert "48+33 = 81" in table[1]


@pytest.mark.parametrize("option", ["-o", "--output"])
def test_files_go_where_they_are_asked_to(option: str, elsewhere: Path, capsys: Capture) -> None:
    gen(capsys, "stanford_3dof", option, "a/b c/é")
    assert {path.name for path in (elsewhere / "a" / "b c" / "é").iterdir()} == FILES
    assert not (elsewhere / "generated").exists()


def test_bytes_are_the_librarys_and_line_ends_are_unix(elsewhere: Path, capsys: Capture) -> None:
    gen(capsys, "puma560", "-o", "out")
    for name, text in generate(load("puma560", warn=lambda _: None)).files().items():
        data = (elsewhere / "out" / name).read_bytes()
        assert data == text.encode("ascii")
        assert b"\r" not in data


def test_a_second_run_overwrites_and_leaves_other_files_alone(elsewhere: Path, capsys: Capture) -> None:
    out = elsewhere / "out"
    out.mkdir()
    (out / "main.c").write_text("mine")
    (out / "stanford_3dof.c").write_text("old")
    gen(capsys, "stanford_3dof", "-o", "out")
    once = tree(out)
    gen(capsys, "stanford_3dof", "-o", "out")
    assert tree(out) == once
    assert once["main.c"] == "mine"
    assert set(once) == FILES | {"main.c"}


@pytest.mark.parametrize(
    ("languages", "names"),
    [
        ("c", {"tool.h", "tool.c"}),
        ("fortran", {"tool.f90"}),
        ("c,fortran", {"tool.h", "tool.c", "tool.f90"}),
        (" fortran , c ", {"tool.h", "tool.c", "tool.f90"}),
    ],
)
def test_languages(languages: str, names: set[str], elsewhere: Path, capsys: Capture) -> None:
    (elsewhere / "tool.yaml").write_text(TOOL)
    gen(capsys, "tool.yaml", "--lang", languages, "-o", "out")
    assert {path.name for path in (elsewhere / "out").iterdir()} == names


@pytest.mark.parametrize(
    ("arguments", "options"),
    [
        (["--scalar", "float"], Options(scalar="float")),
        (["--trig", "given"], Options(trig="given")),
        (["--functions", "gravity,bias"], Options(functions=("gravity", "bias"))),
        (["--functions", " mass_matrix "], Options(functions=("mass_matrix",))),
        (["--formulation", "newton_euler"], Options(formulation="newton_euler")),
        (["--optimize", "none"], Options(optimize="none")),
        (["--no-regroup"], Options(regroup=False)),
        (["--engine", "sympy", "--functions", "gravity"], Options(engine="sympy", functions=("gravity",))),
        (
            ["--scalar", "float", "--trig", "given", "--no-regroup"],
            Options(scalar="float", trig="given", regroup=False),
        ),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else None,
)
def test_options_are_the_librarys(
    arguments: list[str], options: Options, elsewhere: Path, capsys: Capture
) -> None:
    gen(capsys, "stanford_3dof", *arguments, "-o", "out")
    made = generate(load("stanford_3dof"), options)
    assert tree(elsewhere / "out") == made.files()
    assert made.files() != generate(load("stanford_3dof")).files()


def test_given_sines_are_described_and_none_is_called(elsewhere: Path, capsys: Capture) -> None:
    gen(capsys, "stanford_3dof", "--trig", "given", "-o", "out")
    header, source = ((elsewhere / "out" / f"stanford_3dof.{end}").read_text() for end in ("h", "c"))
    assert "sc[0] = cos(q2)" in header
    assert "const stanford_3dof_real sc[3]" in header
    assert "sin(" not in source.split("#include")[-1]


def test_float_is_float_throughout(elsewhere: Path, capsys: Capture) -> None:
    gen(capsys, "stanford_3dof", "--scalar", "float", "-o", "out")
    header, source = ((elsewhere / "out" / f"stanford_3dof.{end}").read_text() for end in ("h", "c"))
    assert "typedef float stanford_3dof_real;" in header
    assert "cosf(" in source
    assert "cos(" not in source
    assert "rk => c_float" in (elsewhere / "out" / "stanford_3dof.f90").read_text()


def test_folded_rotors(elsewhere: Path, capsys: Capture) -> None:
    gen(capsys, "puma560_3dof", "-o", "one")
    gen(capsys, "puma560_3dof", "--fold-rotor", "-o", "other")
    assert (elsewhere / "one" / "puma560_3dof.c").read_text() != (
        elsewhere / "other" / "puma560_3dof.c"
    ).read_text()


def test_latex_beside_the_kernels(elsewhere: Path, capsys: Capture) -> None:
    gen(capsys, "stanford_3dof", "--latex", "-o", "out")
    text = (elsewhere / "out" / "stanford_3dof.tex").read_text()
    assert text.startswith(r"\begin{align*}")
    assert r"\tau_{3}" in text
    gen(capsys, "stanford_3dof", "--latex", "-o", "out", "--check")


# --- JSON -------------------------------------------------------------------------------------------------


def test_json(elsewhere: Path, capsys: Capture) -> None:
    out, err = gen(capsys, "puma560", "--json", "-o", "out")
    found = json.loads(out)
    assert found.keys() >= {"robot", "files", "functions", "compiled"}
    assert found["robot"] == "puma560"
    assert [Path(file).name for file in found["files"]] == ["puma560.h", "puma560.c", "puma560.f90"]
    assert all(Path(file).is_file() for file in found["files"])
    assert found["compiled"] is None
    assert [record["function"] for record in found["functions"]] == list(
        generate(load("puma560", warn=lambda _: None)).counts
    )
    for record in found["functions"]:
        assert record.keys() >= {
            "robot", "function", "formulation", "mul", "add", "div", "sqrt", "neg", "sincos", "total",
            "thesis",
        }  # fmt: skip
    assert found["functions"][0]["thesis"]["mul"] == 208
    assert err == ""
    checked = json.loads(gen(capsys, "puma560", "--json", "-o", "out", "--check")[0])
    assert checked["checked"] == found["files"]


# --- --check ----------------------------------------------------------------------------------------------


def _missing(out: Path) -> None:
    (out / "stanford_3dof.f90").unlink()


def _changed(out: Path) -> None:
    with (out / "stanford_3dof.f90").open("a") as file:
        file.write("\n")


def _other_line_ends(out: Path) -> None:
    path = out / "stanford_3dof.f90"
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))


def _no_file(out: Path) -> None:
    (out / "stanford_3dof.f90").unlink()
    (out / "stanford_3dof.f90").mkdir()


def _no_text(out: Path) -> None:
    (out / "stanford_3dof.f90").write_bytes(b"\xff\xfe")


@pytest.mark.parametrize("damage", [_missing, _changed, _other_line_ends, _no_file, _no_text])
def test_check_notices_a_difference_and_writes_nothing(
    damage: Callable[[Path], None], elsewhere: Path, capsys: Capture
) -> None:
    out = elsewhere / "out"
    gen(capsys, "stanford_3dof", "-o", "out")
    said, _ = gen(capsys, "stanford_3dof", "-o", "out", "--check")
    assert said == "stanford_3dof: 3 files in out are up to date\n"
    damage(out)
    before = [(p.name, p.stat().st_mtime_ns, p.is_file() and p.read_bytes()) for p in sorted(out.iterdir())]
    _, err = gen(capsys, "stanford_3dof", "-o", "out", "--check", code=1)
    assert err.startswith("robodyn: error: out/stanford_3dof.f90: not up to date")
    assert "without --check" in err
    after = [(p.name, p.stat().st_mtime_ns, p.is_file() and p.read_bytes()) for p in sorted(out.iterdir())]
    assert after == before


def test_check_of_a_folder_that_is_not_there(elsewhere: Path, capsys: Capture) -> None:
    _, err = gen(capsys, "stanford_3dof", "--check", code=1)
    assert all(name in err for name in FILES)
    assert tree(elsewhere) == {}


def test_check_compares_what_is_asked_for(capsys: Capture) -> None:
    gen(capsys, "stanford_3dof", "--scalar", "float", "--functions", "gravity", "-o", "out")
    gen(capsys, "stanford_3dof", "--scalar", "float", "--functions", "gravity", "-o", "out", "--check")
    gen(capsys, "stanford_3dof", "--functions", "gravity", "-o", "out", "--check", code=1)
    gen(capsys, "stanford_3dof", "--scalar", "float", "-o", "out", "--check", code=1)


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
    assert main(["gen", "puma560_3dof"]) == 0
    assert capsys.readouterr().err.startswith("robodyn: warning: puma560_3dof.yaml:")
    shutil.rmtree(elsewhere / "generated")
    _, err = gen(capsys, "puma560_3dof", "--strict", code=2)
    assert "inertia is not physical" in err
    assert tree(elsewhere) == {}


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
    write, calls = Path.write_text, []

    def full(path: Path, *arguments: Any, **options: Any) -> int:
        calls.append(path)
        if len(calls) == 2:
            raise OSError(28, "No space left on device")
        return write(path, *arguments, **options)

    monkeypatch.setattr(Path, "write_text", full)
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


def test_without_compile_no_compiler_is_looked_for(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", "/nonexistent")
    monkeypatch.setenv("FC", "/nonexistent")
    monkeypatch.setenv("PATH", "")
    gen(capsys, "stanford_3dof")


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
