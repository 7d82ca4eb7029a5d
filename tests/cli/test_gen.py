"""``robodyn gen``: the files, where they go, what is said, what compilers make of them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from cli.command import Capture, run, run_json, tree
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
from robodyn_testing import representative, require_tool

pytestmark = pytest.mark.usefixtures("elsewhere")

GEN = "gen stanford_3dof -o out"
FILES = {"stanford_3dof.h", "stanford_3dof.c", "stanford_3dof.f90"}
TOOL = """\
name: tool
links:
  - {joint: revolute, alpha: pi/2, mass: 2, com: [0.1, 0.2, 0], inertia: {zz: 1}}
  - {joint: revolute, a: 0.4, mass: m_tool, com: [0.3, 0, 0.1], friction: {coulomb: c_2}, motor_inertia: 1}
"""


def test_files_go_to_generated_under_the_working_folder(elsewhere: Path, capsys: Capture) -> None:
    out, err = run(capsys, "gen puma560")
    expected = generate(load("puma560", warn=lambda _: None)).files()
    files = {
        path.relative_to(elsewhere).as_posix(): path.read_bytes() for path in elsewhere.rglob("puma560.*")
    }
    assert files == {f"generated/puma560/{name}": text.encode("ascii") for name, text in expected.items()}
    assert b"\r" not in b"".join(files.values())
    assert err == ""
    names = ", ".join(f"generated/puma560/{name}" for name in expected)
    assert " ".join(out.split()).startswith(f"puma560: wrote {names} ")


@pytest.mark.parametrize(
    ("arguments", "options"),
    [
        ("--functions gravity,bias", Options(functions=("gravity", "bias"))),
        ("--formulation newton_euler", Options(formulation="newton_euler")),
        ("--optimize none", Options(optimize="none")),
        ("--engine sympy --functions gravity", Options(engine="sympy", functions=("gravity",))),
        ("--scalar float --trig given --no-regroup", Options(scalar="float", trig="given", regroup=False)),
    ],
)
def test_options_are_the_librarys(arguments: str, options: Options, elsewhere: Path, capsys: Capture) -> None:
    run(capsys, f"{GEN} {arguments}")
    made = generate(load("stanford_3dof"), options)
    assert tree(elsewhere / "out") == made.files()
    assert made.files() != generate(load("stanford_3dof")).files()


def test_a_package_has_the_same_kernel(elsewhere: Path, capsys: Capture) -> None:
    options = "--functions gravity --scalar float --trig builtin --misra"
    run(capsys, f"package stanford_3dof --as cmake -o out {options}")
    run(capsys, f"gen stanford_3dof --lang c -o gen {options}")
    for path, name in (("src", "stanford_3dof.c"), ("include/stanford_3dof_dynamics", "stanford_3dof.h")):
        assert Path("out", path, name).read_bytes() == Path("gen", name).read_bytes()


def test_latex_beside_the_kernels(elsewhere: Path, capsys: Capture) -> None:
    run(capsys, f"{GEN} --latex")
    text = (elsewhere / "out" / "stanford_3dof.tex").read_text()
    assert "\n% Written by robodyn; do not edit, generate again.\n\\begin{align*}" in text
    assert r"\tau_{3}" in text
    run(capsys, f"{GEN} --latex --check")


def test_json(capsys: Capture) -> None:
    found = run_json(capsys, "gen puma560 -o out")
    assert found.keys() >= {"robot", "files", "functions", "compiled"}
    assert (found["robot"], found["compiled"]) == ("puma560", None)
    assert found["files"] == ["out/puma560.h", "out/puma560.c", "out/puma560.f90"]
    counts = generate(load("puma560", warn=lambda _: None)).counts
    assert [record["function"] for record in found["functions"]] == list(counts)
    for record in found["functions"]:
        assert record.keys() >= {
            "robot", "function", "formulation", "mul", "add", "div", "sqrt", "neg", "sincos", "total",
            "thesis",
        }  # fmt: skip
    assert found["functions"][0]["thesis"]["mul"] == 208
    assert run_json(capsys, "gen puma560 -o out --check")["checked"] == found["files"]


def test_check_notices_a_difference_and_writes_nothing(elsewhere: Path, capsys: Capture) -> None:
    run(capsys, GEN)
    path = elsewhere / "out" / "stanford_3dof.f90"
    for damaged in (path.read_bytes().replace(b"\n", b"\r\n"), b"\xff\xfe", None):
        path.unlink()
        if damaged is None:
            path.mkdir()
        else:
            path.write_bytes(damaged)
        before = [(one, one.stat().st_mtime_ns) for one in sorted(path.parent.iterdir())]
        _, err = run(capsys, f"{GEN} --check", code=1)
        assert err.startswith("robodyn: error: out/stanford_3dof.f90: not up to date")
        assert [(one, one.stat().st_mtime_ns) for one in sorted(path.parent.iterdir())] == before


def test_all_functions_are_those_that_the_robot_has(elsewhere: Path, capsys: Capture) -> None:
    """No inertia at a joint, no gears: what solves and what motors do is left out, with the reason."""
    text = """\
name: hanging
links:
  - {joint: revolute, mass: 1, com: [0.1, 0, 0], inertia: {xx: 0.1, yy: 0.1, zz: 0.1}}
  - {joint: revolute, alpha: pi/2, a: 0.3, mass: 1}
"""
    (elsewhere / "hanging.yaml").write_text(text, encoding="utf-8")
    _, err = run(capsys, "gen hanging.yaml --functions all -o all")
    written = (elsewhere / "all" / "hanging.h").read_text(encoding="utf-8")
    for name, function in FUNCTIONS.items():
        declared = f"void hanging_{function.emitted or name}(" in written
        assert declared != (f"hanging has no {name}: " in err), name
        assert declared or function.solves or "gear" in err
    assert "void hanging_jacobian(" in written
    assert "--functions all" in written
    assert Options(functions=("all", "bias")).function_names == tuple(FUNCTIONS)


# --- compilers --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "command",
    representative(
        ["tool.yaml", "stanford_3dof --scalar float --trig given --functions bias,gravity",
         "stanford_3dof --functions link_poses,controller"],
        "tool.yaml",
    ),
)  # fmt: skip
def test_compile_builds_loads_and_compares(command: str, elsewhere: Path, capsys: Capture) -> None:
    require_tool("gcc")
    require_tool("gfortran")
    (elsewhere / "tool.yaml").write_text(TOOL)
    lines = run(capsys, f"gen {command} --compile -o out")[0].splitlines()[-3:]
    assert lines[0].startswith("c: compiled with ")
    assert lines[1].startswith("fortran: compiled with GNU Fortran")
    assert lines[2] == "c and fortran: the same bits on 100 states"
    assert {path.suffix for path in (elsewhere / "out").glob("*.*")} == {".h", ".c", ".f90"}


def test_compilers_that_are_missing(
    elsewhere: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One of Fortran is, unless Fortran alone is asked for, only noted; none is looked for unless asked."""
    require_tool("gcc")
    monkeypatch.setenv("FC", "/nonexistent")
    assert "FC" in run(capsys, f"{GEN} --compile --lang fortran", code=3)[1]
    with monkeypatch.context() as patch:
        patch.setenv("CC", "/nonexistent")
        out, err = run(capsys, f"{GEN} --compile", code=3)
        assert out == ""
        assert err.startswith("robodyn: error: there is no C compiler '/nonexistent' (CC names it)")
    assert tree(elsewhere) == {}
    note = run(capsys, f"{GEN} --compile")[0].splitlines()[-1]
    assert note.startswith("fortran: written, not compiled: ")
    assert "/nonexistent" in note
    assert run_json(capsys, f"{GEN} --compile")["compiled"].keys() == {"c", "fortran"}
    monkeypatch.setenv("CC", "/nonexistent")
    monkeypatch.setenv("PATH", "")
    run(capsys, "gen stanford_3dof")
    assert Path("generated/stanford_3dof/stanford_3dof.c").is_file()


def test_different_bits_are_a_failed_check(
    elsewhere: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A compiler that was told to be fast and not exact: nothing is written."""
    require_tool("gfortran")
    monkeypatch.setattr("robodyn_cli.gen._same_bits", lambda *_: False)
    assert "different bits" in run(capsys, f"{GEN} --compile", code=1)[1]
    assert not (elsewhere / "out").exists()


def test_batch(capsys: Capture, elsewhere: Path) -> None:
    """The files of batches, compiled with the kernels; checked like them."""
    require_tool("cc")
    command = f"{GEN} --batch --functions inverse_dynamics --lang c"
    run(capsys, f"{command} --compile")
    made = generate(load("stanford_3dof", warn=lambda _: None), Options(functions=("inverse_dynamics",)))
    assert tree(elsewhere / "out") == made.files(("c",), batch=True)
    (elsewhere / "out" / "stanford_3dof_lanes.h").unlink()
    run(capsys, f"{command} --check", code=1)


# --- firmware ---------------------------------------------------------------------------------------------


def test_firmware_is_a_folder_that_is_held_against_what_would_be_written(
    elsewhere: Path, capsys: Capture
) -> None:
    for tool in ("arm-none-eabi-gcc", "qemu-system-arm"):
        require_tool(tool)
    command = "gen stanford_3dof --firmware --target cortex-m4f"
    out, _ = run(capsys, command)
    folder = elsewhere / "generated" / "stanford_3dof" / "firmware"
    assert out.startswith("stanford_3dof: wrote 16 files in generated/stanford_3dof/firmware\ncortex-m4f: ")
    assert "instructions a call, self-test passed in qemu" in out
    assert len(list(folder.iterdir())) == 16
    assert "typedef float stanford_3dof_real;" in (folder / "stanford_3dof.h").read_text(encoding="utf-8")
    (folder / "README.md").write_text("mine", encoding="utf-8")
    assert run(capsys, f"{command} --check")[0].endswith("are up to date\n")
    (folder / "stanford_3dof_startup.c").unlink()
    _, err = run(capsys, f"{command} --check", code=1)
    assert "firmware/stanford_3dof_startup.c: not up to date" in err


def test_firmware_without_tools_says_what_was_not_measured(
    elsewhere: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", "")
    (elsewhere / "arm.yaml").write_text(
        "name: main\ntitle: '# Proven | `x` <b>[y](z)</b> *'\nlinks: [{joint: revolute, inertia: {zz: 1}}]\n"
    )
    out, err = run(capsys, "gen arm.yaml --firmware --json -o there --scalar double --lang c")
    said = json.loads(out)
    assert not [file for file in said["files"] if file.endswith(".f90")]
    missing = {found["target"]: found["missing"].partition(" ")[0] for found in said["firmware"]}
    compilers = dict.fromkeys(("cortex-m3", "cortex-m4f", "cortex-m7"), "arm-none-eabi-gcc")
    assert missing == {**compilers, "rv32imafc": "riscv64-unknown-elf-gcc"}
    assert "note: not everything was measured: needs arm-none-eabi-gcc" in err
    readme = Path("there/firmware/README.md").read_text(encoding="utf-8")
    assert "of \\# Proven \\| \\`x\\` &lt;b&gt;\\[y\\](z)&lt;/b&gt; \\*, in double" in readme
    assert "main_inverse_dynamics(" in Path("there/firmware/main.c").read_text(encoding="utf-8")
