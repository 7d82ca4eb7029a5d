"""The recipe "Add a robot" of CONTRIBUTING.md, carried out in a copy of the package."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import textwrap
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import robodyn

TOP = Path(__file__).parents[2]
Run = Callable[..., "subprocess.CompletedProcess[str]"]


def _section() -> str:
    text = (TOP / "CONTRIBUTING.md").read_text(encoding="utf-8")
    return text.partition("\n## Add a robot\n")[2].partition("\n## ")[0]


def _block(language: str) -> str:
    """The only block of that language in the section, as it would be typed."""
    (block,) = re.findall(rf"```{language}\n(.*?) *```", _section(), re.DOTALL)
    return textwrap.dedent(block)


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the package, and in it the one file that the recipe adds."""
    folder = tmp_path_factory.mktemp("copy")
    for name in ("codegen", "cli", "templates", "robots"):
        shutil.copytree(TOP / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
    (folder / "robots" / "scara.yaml").write_text(_block("yaml"), encoding="utf-8")
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


def test_the_robot_is_listed(run: Run) -> None:
    assert "scara" in run("robots", "--names").stdout.split()
    assert "SCARA, two revolute joints" in run("robots").stdout


def test_every_command_of_the_recipe_works(run: Run) -> None:
    commands = [line.removeprefix("$ ").split() for line in _block("console").splitlines()]
    assert [command[1] for command in commands] == ["robots", "gen", "verify", "flops"]
    for command in commands:
        assert command[0] == "robodyn"
        run(*command[1:])


def test_kernels_and_counts(run: Run, copy: Path) -> None:
    """No doubts, the payload an argument, the same bytes again, few operations."""
    done = run("gen", "scara", "--strict", "-o", "generated/scara")
    assert "warning" not in done.stderr
    assert {path.name for path in (copy / "generated/scara").iterdir()} == {"scara.h", "scara.c", "scara.f90"}
    header = (copy / "generated/scara/scara.h").read_text(encoding="utf-8")
    assert re.search(r"scara_real m_load;", header)
    run("gen", "scara", "-o", "generated/scara", "--check")
    assert 0 < json.loads(run("flops", "scara", "--json").stdout)["total"] < 80
    counts = json.loads(run("flops", "scara", "--functions", "gravity", "--json").stdout)
    assert 0 < counts["total"] < 5  # only the stroke lifts anything


def test_the_numbers_are_right(run: Run, copy: Path) -> None:
    """Against the independent references, and one torque by hand: what the stroke carries."""
    assert json.loads(run("verify", "scara", "--json").stdout)["passed"] is True
    arm = robodyn.load(str(copy / "robots" / "scara.yaml")).at({"m_load": 0.5})
    torques = robodyn.compile(arm, functions=["gravity"]).gravity([0.3, -0.4, 0.1, 0.2])
    np.testing.assert_allclose(torques, [0, 0, -(1.1 + 0.4 + 0.5) * 9.81, 0], atol=1e-12)
