"""The recipe "Add a language" of CONTRIBUTING.md, carried out in a copy of the package."""

from __future__ import annotations

import re
import runpy
from types import SimpleNamespace

import numpy as np
import pytest

import robodyn
from recipes.copies import Copy, commands_in_recipe, source_in_recipe

TITLE = "Add a language"
FILES = ("codegen/robodyn/emit/languages/python.py", "templates/python/kernel.py.j2")
STATES = 20


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    return Copy(tmp_path_factory.mktemp("language"), {file: source_in_recipe(TITLE, file) for file in FILES})


def test_help_and_errors_know_the_language(copy: Copy) -> None:
    assert re.search(r"python \(py\)", copy.robodyn("gen", "--help"))
    expected = "one of c, cuda, fortran, javascript, python, rust"
    assert expected in copy.robodyn("gen", "puma560", "--lang", "basic", code=2)
    assert "did you mean 'python'?" in copy.robodyn("gen", "puma560", "--lang", "pyton", code=2)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--scalar", "float"], "Python is not written with --scalar float; expected --scalar double"),
        pytest.param(
            ["--compile"],
            "Python is written, and cannot be called from Python",
            marks=pytest.mark.thorough,
        ),
    ],
)
def test_what_the_language_lacks_is_refused(copy: Copy, options: list[str], message: str) -> None:
    assert message in copy.robodyn("gen", "puma560", "--lang", "py", *options, code=2)


def test_every_command_of_the_recipe_works(copy: Copy) -> None:
    commands = commands_in_recipe(TITLE)
    assert [command[0] for command in commands] == ["gen", "gen"]
    for command in commands:
        copy.robodyn(*command)
    assert (copy.work / "generated/puma560/puma560.py").is_file()
    assert {p.name for p in (copy.work / "both").iterdir()} == {"puma560.h", "puma560.c", "puma560.py"}
    copy.robodyn("gen", "puma560", "--lang", "py", "-o", "both", "--check")


TOOL = """
name: tool
links:
  - {joint: revolute, alpha: 1, mass: m_tool, com: [0.3, 0.1, 0], friction: {coulomb: 2}}
  - {joint: prismatic, alpha: 0.5, mass: 2, motor_inertia: 1}
"""


@pytest.mark.parametrize("name", [pytest.param("puma560", marks=pytest.mark.thorough), "tool"])
def test_the_module_gives_the_right_torques(copy: Copy, name: str) -> None:
    """Every function, run-time parameters too, to the bits of the C: math's sines are those of libm."""
    (copy.work / "tool.yaml").write_text(TOOL)
    source = {"tool": "tool.yaml"}.get(name, name)
    copy.robodyn("gen", source, "--lang", "py", "-o", name)
    place = copy.work / "tool.yaml" if name == "tool" else copy.folder / "robots" / f"{name}.yaml"
    kernel = robodyn.compile(robot := robodyn.load(str(place), warn=lambda _: None))
    parameters = dict.fromkeys(robot.parameters, 0.7)
    module = runpy.run_path(str(copy.work / name / f"{name}.py"))
    rng = np.random.default_rng(5)
    for function, interface in kernel.signatures.items():
        ((_, size),) = interface.outputs
        for _ in range(STATES):
            inputs = [rng.uniform(-2, 2, length).tolist() for _, length in interface.inputs]
            result = [0.0] * size
            rest = [SimpleNamespace(**parameters)] if parameters else []
            module[f"{name}_{function}"](*inputs, result, *rest)
            expected = np.asarray(getattr(kernel, function)(*inputs, params=parameters or None)).ravel()
            assert result == expected.tolist()
            assert np.abs(expected).max() > 0
