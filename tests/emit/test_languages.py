"""Languages are found in their folder and named nowhere else."""

from __future__ import annotations

import ast
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from emit.kernels import in_single, made
from robodyn.emit.languages import DEFAULTS, LANGUAGES, compiled_language, language_named, languages_named
from robodyn.errors import InputError
from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
from robodyn_testing import require_tool

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


def test_the_table() -> None:
    assert list(LANGUAGES) == ["c", "fortran", "javascript", "rust"]
    assert DEFAULTS == ("c", "fortran")
    assert language_named("f90") is LANGUAGES["fortran"]
    assert language_named("rs") is LANGUAGES["rust"]
    assert {"rust", "rs", ".rs", "fortran", "f90", ".f90", ".f", "javascript", "js", ".mjs"} == NAMES


def languages_in(text: str) -> set[str]:
    """The names of languages that are constants of a text in Python."""
    words = {node.value for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Constant)}
    return NAMES & {word for word in words if isinstance(word, str)}


@pytest.mark.thorough
def test_no_other_file_names_a_language() -> None:
    """C is the language of firmware, threads and calls from Python; the others stand in their own files."""
    named = {str(file): languages_in((TOP / file).read_text(encoding="utf-8")) for file in FILES}
    assert {file: names for file, names in named.items() if names} == {}
    assert len(FILES) > 700


def test_a_language_that_is_named_is_noticed() -> None:
    assert languages_in("if language == 'fortran' or file.endswith('.rs'): 'c'") == {"fortran", ".rs"}


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (["c", "fortran", "f90"], "a language is asked for twice"),
        (["rost"], "did you mean 'rust'?"),
        (["cobol"], "expected one of c, fortran, javascript, rust"),
    ],
)
def test_what_is_no_choice_of_languages(names: list[str], message: str) -> None:
    with pytest.raises(InputError) as error:
        languages_named(names)
    assert message in str(error.value)


def test_what_cannot_be_called_is_refused() -> None:
    with pytest.raises(
        InputError, match="Rust is written, and cannot be called from Python; expected c or fo"
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


@pytest.mark.parametrize("name", LANGUAGES)
def test_every_language_writes_every_kind_of_kernel(name: str) -> None:
    """Each function is there, and float, where there is one, is not double."""
    for trig in ("libm", "builtin", "given"):
        double = made("tool", trig)
        text = "".join(double.files((name,)).values())
        assert all(signature.symbol in text for signature in double.signatures)
        if "float" in LANGUAGES[name].scalars:
            assert text != "".join(in_single(double).files((name,)).values())
