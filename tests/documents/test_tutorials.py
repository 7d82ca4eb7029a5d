"""Each tutorial is followed literally by somebody who has just installed robodyn and has nothing else."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from documents.blocks import ROOT, TUTORIALS, commands, read
from robodyn_testing import require_tool
from robodyn_testing.environments import clean_environment, pip_install, run

#: Of the four tutorials this takes seconds; ``make prove-all`` follows the others.
QUICK = [page for page in TUTORIALS if "from-a-urdf" in page]


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What ``pip install .`` makes of a new environment."""
    folder = clean_environment(tmp_path_factory.mktemp("tutorials") / "venv")
    pip_install(folder, ROOT)
    return folder


@pytest.mark.parametrize(
    "page",
    [
        pytest.param(page, marks=pytest.mark.thorough if page in QUICK else pytest.mark.slow)
        for page in TUTORIALS
    ],
)
def test_a_newcomer_gets_what_the_tutorial_shows(page: str, environment: Path, tmp_path: Path) -> None:
    """With a home of their own, copies of the inputs, and no Python but the environment's."""
    blocks = read(page)
    for block in blocks:
        for tool in block.detail.split(", ") if block.mark == "needs" else ():
            require_tool(tool)
    (install,) = [block for block in blocks if block.mark == "not run"]
    assert [command.text for command in commands(install)] == ["pip install ."]
    home = tmp_path / "home"
    home.mkdir()
    variables = {
        "HOME": str(home),
        "PATH": os.pathsep.join([str(environment / "bin"), os.defpath]),
        "PYTHONPATH": str(ROOT / "tests"),  # only for the runner, which imports nothing of robodyn
        "LANG": "C.UTF-8",
    }
    python = environment / "bin" / "python"
    run(python, "-m", "documents", "--installed", page, cwd=tmp_path, variables=variables)
