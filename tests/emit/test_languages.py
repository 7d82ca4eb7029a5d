"""Languages are found in their folder and named nowhere else; those beside C and Fortran give the bits of the
C, have tests of their own, and refuse what they lack."""

from __future__ import annotations

import ast
import os
import re
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Final

import numpy as np
import pytest

from emit.crates import Crate, without_network
from emit.kernels import in_single, made, robots
from emit.modules import Module
from emit.test_bits import DT, arrays, own_cache, parameters, run, same_bits
from robodyn import compile as compile_robot
from robodyn.emit.languages import DEFAULTS, LANGUAGES, compiled_language, language_named, languages_named
from robodyn.errors import InputError
from robodyn.firmware.language_tests import language_tests
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import load, read_text
from robodyn_cli.main import main
from robodyn_testing import representative, require_tool, sampled

__all__ = ["own_cache"]

TOP = Path(__file__).parents[2]
FILES = sorted(
    path.relative_to(TOP)
    for folder in ("codegen", "cli")
    for path in (TOP / folder).rglob("*.py")
    if "emit/languages/" not in path.as_posix()
)
NAMES = {
    word
    for language in LANGUAGES.values()
    for word in (language.name, *language.aliases, *language.suffixes)
    if language.name != "c"
}
#: What names another language than C: that of browsers.
NAMED = {"codegen/robodyn/report/arm_page.py"}
RUNNERS: Final = {"javascript": Module, "rust": Crate}


def test_the_table() -> None:
    assert list(LANGUAGES) == ["c", "cuda", "fortran", "javascript", "rust"]
    assert DEFAULTS == ("c", "fortran")
    assert language_named("f90") is LANGUAGES["fortran"]
    assert language_named("rs") is LANGUAGES["rust"]
    others = {"rust", "rs", ".rs", "fortran", "f90", ".f90", ".f", "javascript", "js", ".mjs"}
    assert others | {"cuda", "cu", ".cu", ".cuh"} == NAMES


def languages_in(text: str) -> set[str]:
    """The names of languages that are constants of a text in Python."""
    words = {node.value for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Constant)}
    return NAMES & {word for word in words if isinstance(word, str)}


@pytest.mark.thorough
def test_no_other_file_names_a_language() -> None:
    """C is the language of firmware, threads and calls from Python; the others stand in their own files."""
    named = {str(file): languages_in((TOP / file).read_text(encoding="utf-8")) for file in FILES}
    assert {file: names for file, names in named.items() if names and file not in NAMED} == {}
    assert len(FILES) > 400
    assert languages_in("if language == 'fortran' or file.endswith('.rs'): 'c'") == {"fortran", ".rs"}


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (["c", "fortran", "f90"], "a language is asked for twice"),
        (["rost"], "did you mean 'rust'?"),
        (["cobol"], "expected one of c, cuda, fortran, javascript, rust"),
    ],
)
def test_what_is_no_choice_of_languages(names: list[str], message: str) -> None:
    with pytest.raises(InputError) as error:
        languages_named(names)
    assert message in str(error.value)
    with pytest.raises(
        InputError, match="Rust is written, and cannot be called from Python; expected c or f"
    ):
        compiled_language("rust")


def test_names_that_a_language_does_not_allow(tmp_path: Path) -> None:
    robot = replace(load("stanford_3dof"), name="a" * 40)
    generated = generate(robot, Options(("gravity", "inverse_dynamics_derivatives")))
    with pytest.raises(
        InputError, match=r"Fortran allows names of 63 characters; found 69 in .*; shorten the"
    ) as error:
        generated.files(("c", "fortran"))
    assert "name to 34 characters, or leave fortran out" in str(error.value)
    assert generated.files(("c",))
    fitting = generate(replace(robot, name="a" * 34), generated.options).files(("fortran",))
    (text,) = fitting.values()
    (tmp_path / "a.f90").write_text(text)
    compiler = require_tool("gfortran")
    subprocess.run([compiler, "-std=f2018", "-fsyntax-only", tmp_path / "a.f90"], check=True)


# --- beside C and Fortran -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("language", "name", "scalar"),
    representative(
        [
            ("javascript", "tool", "double"),
            ("javascript", "puma560", "double"),
            ("javascript", "rubbing", "double"),
            ("javascript", "effects_remembering", "double"),
            ("rust", "tool", "float"),
            ("rust", "rubbing", "double"),
            ("rust", "puma560", "double"),
            ("rust", "stanford", "float"),
        ],
        ("javascript", "tool", "double"),
        ("rust", "tool", "float"),
        rest="slow",
    ),
)
def test_bits_are_those_of_the_c(language: str, name: str, scalar: str, tmp_path: Path) -> None:
    """1,000 states a function; run-time parameters, the sign of a velocity and memory included. Functions of
    Math (in effects_remembering) are right to a few last bits."""
    generated = made(name, "builtin")
    runner = RUNNERS[language](in_single(generated) if scalar == "float" else generated, tmp_path)
    c = compile_robot(robots()[name], scalar=scalar, trig="builtin", cc=require_tool("gcc"), mode="abi")
    inputs = arrays(name)
    for function in c.functions:
        expected = run(c, function, inputs, name)
        found = runner.run(function, inputs, parameters(name) or {}, DT).reshape(expected.shape)
        assert np.isfinite(found).all()
        if name == "effects_remembering":
            np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-12 * np.abs(expected).max())
        else:
            assert same_bits(found.astype(expected.dtype), expected), function


def test_sines_of_any_angle_have_the_bits_of_the_c_in_javascript(tmp_path: Path) -> None:
    """Up to where they are NaN, negative zero included; of a pendulum gravity is a multiple of the sine."""
    text = "name: arm\ngravity: [0, -1, 0]\nlinks: [{joint: revolute, mass: 1, com: [1, 1, 0]}]"
    generated = generate(read_text(text), Options(trig="builtin", functions=("gravity",)))
    rng = np.random.default_rng(4)
    limits = [0.0, -0.0, 411773.0, -411773.0, 1e6, -1e300, np.inf, -np.inf, np.nan]
    sizes = rng.uniform(-1, 1, 2000) * 10.0 ** rng.integers(-300, 6, 2000)
    angles = np.concatenate([sizes, np.arange(-400, 400) * (np.pi / 4), limits])[:, None]
    found = Module(generated, tmp_path).run("gravity", {"q": angles}, {}, DT)
    robot = generated.unit.robot
    kernel = compile_robot(robot, trig="builtin", functions=("gravity",), cc=require_tool("gcc"), mode="abi")
    expected = kernel.gravity(angles)
    np.testing.assert_array_equal(np.isnan(found), np.isnan(expected))
    assert np.isnan(found).sum() == 5
    assert same_bits(found[~np.isnan(found)], expected[~np.isnan(expected)])


def write_tested(language: str, generated: Generated, folder: Path) -> None:
    """The files of a language with their tests, and Debian's folder of crates in place of the network."""
    files = {**generated.files((language,)), **language_tests(generated, (language,))}
    files |= without_network(files.get("Cargo.toml", ""))
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8", newline="\n")


def run_tests(language: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """What the language's own runner of tests says."""
    command = {"javascript": ["node", "--test"], "rust": ["cargo", "test", "--offline", "--quiet"]}[language]
    environment = {**os.environ, "RUSTFLAGS": "-D warnings", "CARGO_TARGET_DIR": str(folder / "target")}
    return subprocess.run(
        [require_tool(command[0]), *command[1:]],
        cwd=folder, env=environment, capture_output=True, text=True, timeout=300,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("language", "name", "scalar"),
    representative(
        [
            ("javascript", "effects_remembering", "double"),
            ("javascript", "puma560", "double"),
            ("rust", "puma560", "double"),
            ("rust", "effects_remembering", "float"),
            ("rust", "effects_smooth", "double"),
        ],
        ("javascript", "effects_remembering", "double"),
        ("rust", "effects_remembering", "float"),
        rest="slow",
    ),
)
def test_its_tests_pass(language: str, name: str, scalar: str, tmp_path: Path) -> None:
    """Rigid, with memory and run-time parameters, with functions of libm or Math."""
    generated = made(name, "builtin")
    write_tested(language, in_single(generated) if scalar == "float" else generated, tmp_path)
    done = run_tests(language, tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    if language == "javascript":
        assert f"# pass {len(generated.counts)}" in done.stdout
        return
    text = (tmp_path / "tests/vectors.rs").read_text()
    assert [f for f in generated.counts if f"fn {f}_is_right()" not in text] == []
    assert text.count("check(") > 8 * len(generated.counts)
    command = [require_tool("rustfmt"), "--check", "--edition", "2021", "tests/vectors.rs"]
    assert subprocess.run(command, cwd=tmp_path, capture_output=True, text=True).stdout == ""


@pytest.mark.parametrize(
    ("language", "file", "start", "said"),
    [
        ("javascript", "stanford_3dof.mjs", "export function stanford_3dof_inverse_dynamics(", "# fail 1"),
        ("rust", "src/lib.rs", "pub fn inverse_dynamics(", "inverse_dynamics_is_right"),
    ],
)
def test_a_wrong_kernel_fails_its_tests(
    language: str, file: str, start: str, said: str, tmp_path: Path
) -> None:
    """One constant's last digits, beyond what rounding can do."""
    write_tested(language, made("stanford_3dof", "builtin"), tmp_path)
    head, start, rest = (tmp_path / file).read_text().partition(start)
    wrong = re.sub(r"((?:const|let) t\d+ = )(?=.* \* )", r"\g<1>0.99999999 * ", rest, count=1)
    assert wrong != rest
    (tmp_path / file).write_text(head + start + wrong)
    done = run_tests(language, tmp_path)
    assert done.returncode != 0
    assert said in done.stdout
    assert "is not" in done.stdout


@pytest.mark.parametrize(
    ("lang", "names", "builtin", "libm"),
    sampled([
        ("js", {"stanford_3dof.mjs", "stanford_3dof.test.mjs"}, set(), "Math.sin(q[1])"),
        ("c,rs", {"stanford_3dof.c", "stanford_3dof.h", "Cargo.toml", "src/lib.rs", "tests/vectors.rs"},
         {"libm =", "<math.h>"}, 'libm = "0.2"'),
    ], every=2),
)  # fmt: skip
def test_gen_writes_tests_and_checks_them(
    lang: str, names: set[str], builtin: set[str], libm: str, tmp_path: Path
) -> None:
    """Sines are built in unless --trig says otherwise, in every language that is asked for."""
    folder = tmp_path / "arm"
    arguments = ["gen", "stanford_3dof", "--lang", lang, "-o", str(folder)]
    assert main(arguments) == 0
    files = {str(p.relative_to(folder)): p for p in folder.rglob("*") if p.is_file()}
    assert set(files) == names
    text = "".join(files[name].read_text() for name in names if "test" not in name)
    assert not any(word in text for word in (*builtin, "Math."))
    assert main([*arguments, "--check"]) == 0
    with next(path for name, path in files.items() if "test" in name).open("a") as file:
        file.write("// edited\n")
    assert main([*arguments, "--check"]) == 1
    assert main([*arguments, "--trig", "libm"]) == 0
    assert libm in "".join(files[name].read_text() for name in names)


@pytest.mark.parametrize(
    ("lang", "options", "message"),
    [
        (
            "js",
            ["--scalar", "float"],
            "JavaScript is not written with --scalar float; expected --scalar double",
        ),
        ("js", ["--batch"], "batches are in C only"),
        ("rust", ["--misra"], "MISRA C:2012 is in C only"),
        ("rust", ["--firmware"], "a firmware folder is not written in Rust"),
        ("js", ["--compile"], "JavaScript is written, and cannot be called from Python"),
        ("cuda", ["--batch"], "batches are in C only"),
        ("cuda", ["--firmware"], "a firmware folder is not written in CUDA"),
        ("cu", ["--compile"], "CUDA is written, and cannot be called from Python"),
    ],
)
def test_what_a_language_has_not_is_refused(
    lang: str, options: list[str], message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ["gen", "stanford_3dof", "--lang", lang, "-o", str(tmp_path / "arm"), *options]
    assert main(arguments) == 2
    assert message in capsys.readouterr().err
    assert not (tmp_path / "arm").exists()
