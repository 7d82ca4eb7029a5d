"""The recipe "Add a language" of CONTRIBUTING.md, carried out in a copy of the package."""

from __future__ import annotations

import os
import re
import runpy
import shutil
import subprocess
import sys
import textwrap
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import robodyn

TOP = Path(__file__).parents[2]
Run = Callable[..., "subprocess.CompletedProcess[str]"]
STATES = 20


def _section() -> str:
    text = (TOP / "CONTRIBUTING.md").read_text(encoding="utf-8")
    return text.partition("\n## Add a language\n")[2].partition("\n## ")[0]


def _block(language: str) -> str:
    """The only block of that language in the section, as it would be typed."""
    (block,) = re.findall(rf"```{language}\n(.*?) *```", _section(), re.DOTALL)
    return textwrap.dedent(block)


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the package, and in it the two files that the recipe adds."""
    folder = tmp_path_factory.mktemp("copy")
    for name in ("codegen", "cli", "templates", "robots"):
        shutil.copytree(TOP / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
    for place, block in re.findall(
        r"`((?:codegen|templates)/[^`]*python[^`]*)`.*?```(\w+)", _section(), re.S
    ):
        path = folder / place
        path.parent.mkdir(exist_ok=True)
        path.write_text(_block(block), encoding="utf-8")
    return folder


@pytest.fixture
def run(copy: Path) -> Run:
    def run(*arguments: str, code: int = 0) -> subprocess.CompletedProcess[str]:
        path = os.pathsep.join([str(copy / "codegen"), str(copy / "cli")])
        environment = {**os.environ, "PYTHONPATH": path, "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run(
            [sys.executable, "-m", "robodyn", *arguments],
            cwd=copy, env=environment, capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert done.returncode == code, done.stderr
        return done

    return run


def test_help_and_errors_know_the_language(run: Run) -> None:
    assert re.search(r"python \(py\)", run("gen", "--help").stdout)
    expected = "one of c, fortran, javascript, python, rust"
    assert expected in run("gen", "puma560", "--lang", "basic", code=2).stderr
    assert "did you mean 'python'?" in run("gen", "puma560", "--lang", "pyton", code=2).stderr


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--batch"], "batches are in C only"),
        (["--scalar", "float"], "Python is not written with --scalar float; expected --scalar double"),
        (["--trig", "builtin"], "Python is not written with --trig builtin"),
        (["--firmware"], "a firmware folder is not written in Python"),
        (["--compile"], "Python is written, and cannot be called from Python"),
    ],
)
def test_what_the_language_lacks_is_refused(run: Run, options: list[str], message: str) -> None:
    assert message in run("gen", "puma560", "--lang", "py", *options, code=2).stderr


def test_every_command_of_the_recipe_works(run: Run, copy: Path) -> None:
    commands = [line.removeprefix("$ ").split() for line in _block("console").splitlines()]
    assert [command[:2] for command in commands] == [["robodyn", "gen"]] * 2
    for command in commands:
        run(*command[1:])
    assert (copy / "generated/puma560/puma560.py").is_file()
    assert {p.name for p in (copy / "both").iterdir()} == {"puma560.h", "puma560.c", "puma560.py"}
    run("gen", "puma560", "--lang", "py", "-o", "both", "--check")


TOOL = """
name: tool
links:
  - {joint: revolute, alpha: 1, mass: m_tool, com: [0.3, 0.1, 0], friction: {coulomb: 2}}
  - {joint: prismatic, alpha: 0.5, mass: 2, motor_inertia: 1}
"""


@pytest.mark.parametrize("name", ["puma560", "tool"])
def test_the_module_gives_the_right_torques(run: Run, copy: Path, name: str) -> None:
    """Every function, run-time parameters too, to the bits of the C: math's sines are those of libm."""
    (copy / "tool.yaml").write_text(TOOL)
    source = {"tool": "tool.yaml"}.get(name, name)
    run("gen", source, "--lang", "py", "-o", name)
    place = copy / "tool.yaml" if name == "tool" else copy / "robots" / f"{name}.yaml"
    kernel = robodyn.compile(robot := robodyn.load(str(place), warn=lambda _: None))
    parameters = dict.fromkeys(robot.parameters, 0.7)
    module = runpy.run_path(str(copy / name / f"{name}.py"))
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
