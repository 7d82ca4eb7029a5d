"""``robodyn gen``: the files, where they go, what is said, and what is left behind when it fails."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from cli.generated import FILES, TOOL, Capture, gen, tree
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
from robodyn_cli.main import main

pytestmark = pytest.mark.usefixtures("elsewhere")

# --- what is written --------------------------------------------------------------------------------------


def test_files_go_to_generated_under_the_working_folder(elsewhere: Path, capsys: Capture) -> None:
    out, err = gen(capsys, "stanford_3dof")
    expected = generate(load("stanford_3dof")).files()
    assert tree(elsewhere) == {f"generated/stanford_3dof/{name}": text for name, text in expected.items()}
    assert set(expected) == FILES
    assert err == ""
    wrote = " ".join(
        ["stanford_3dof: wrote", ", ".join(f"generated/stanford_3dof/{name}" for name in expected)]
    )
    first, second, *table = out.splitlines()
    assert f"{first} {second.strip()}" == wrote
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
    gen(capsys, "stanford_3dof", "-o", "out", "--formulation", "newton_euler")
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


def test_a_package_has_the_same_kernel(elsewhere: Path, capsys: Capture) -> None:
    options = ("--functions", "gravity", "--scalar", "float", "--trig", "builtin", "--misra")
    assert main(["package", "stanford_3dof", "--as", "cmake", "-o", "out", *options]) == 0
    gen(capsys, "stanford_3dof", "--lang", "c", "-o", "gen", *options)
    for path, name in (("src", "stanford_3dof.c"), ("include/stanford_3dof_dynamics", "stanford_3dof.h")):
        assert Path("out", path, name).read_bytes() == Path("gen", name).read_bytes()


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


def test_latex_beside_the_kernels(elsewhere: Path, capsys: Capture) -> None:
    gen(capsys, "stanford_3dof", "--latex", "-o", "out")
    text = (elsewhere / "out" / "stanford_3dof.tex").read_text()
    assert "\n% Written by robodyn; do not edit, generate again.\n\\begin{align*}" in text
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


def test_check_compares_what_is_asked_for(capsys: Capture) -> None:
    gen(capsys, "stanford_3dof", "--scalar", "float", "--functions", "gravity", "-o", "out")
    gen(capsys, "stanford_3dof", "--scalar", "float", "--functions", "gravity", "-o", "out", "--check")
    gen(capsys, "stanford_3dof", "--functions", "gravity", "-o", "out", "--check", code=1)
    gen(capsys, "stanford_3dof", "--scalar", "float", "-o", "out", "--check", code=1)


def test_all_functions_are_those_that_the_robot_has(elsewhere: Path, capsys: Capture) -> None:
    """No inertia at a joint, no gears: what solves and what motors do is left out, with the reason."""
    text = """\
name: hanging
links:
  - {joint: revolute, mass: 1, com: [0.1, 0, 0], inertia: {xx: 0.1, yy: 0.1, zz: 0.1}}
  - {joint: revolute, alpha: pi/2, a: 0.3, mass: 1}
"""
    (elsewhere / "hanging.yaml").write_text(text, encoding="utf-8")
    _, err = gen(capsys, "hanging.yaml", "--functions", "all", "-o", "all")
    written = (elsewhere / "all" / "hanging.h").read_text(encoding="utf-8")
    for name, function in FUNCTIONS.items():
        declared = f"void hanging_{function.emitted or name}(" in written
        assert declared != (f"hanging has no {name}: " in err), name
        assert declared or function.solves or "gear" in err
    assert "void hanging_jacobian(" in written
    assert "--functions all" in written
    assert Options(functions=("all", "bias")).function_names == tuple(FUNCTIONS)
