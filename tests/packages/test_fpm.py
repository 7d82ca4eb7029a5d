"""The package for fpm, the Fortran package manager: a dependency of a project, tested, installed."""

from __future__ import annotations

import sys
import tomllib
from pathlib import Path

import pytest

from packages.consumers import MAINTAINER, Consumer, consumer, fortran_program, run, write
from robodyn.kernels.generate import Options
from robodyn_testing import require_module, require_tool

pytestmark = pytest.mark.thorough
FPM = (sys.executable, "-m", "fpm")
PROJECT = """\
name = "consumer"
[dependencies]
{package} = {{ path = "{path}" }}
"""


@pytest.fixture(autouse=True)
def _fpm() -> None:
    require_module("fpm")
    require_tool("gfortran")


@pytest.fixture
def arm(tmp_path: Path) -> Path:
    """With a run-time parameter, and called like the tool."""
    path = tmp_path / "arm.yaml"
    path.write_text(
        "name: fpm\nlinks:\n- {joint: revolute, alpha: pi/2, mass: m_tool, com: [0.1, 0.2, 0]}\n"
        "- {joint: prismatic, alpha: 1, mass: 2, com: [0.1, 0, 0.2], motor_inertia: 1}\n"
    )
    return path


def built(user: Consumer, folder: Path) -> None:
    """Build the project that depends on the package, run it, and hold its numbers to what is expected."""
    write(folder / "package", user.package.files())
    manifest = PROJECT.format(package=user.package.name, path="../package")
    project = write(folder / "project", {"fpm.toml": manifest, "app/main.f90": fortran_program(user)})
    run(*FPM, "build", "--profile", "release", cwd=project)
    user.check(run(*FPM, "run", "--profile", "release", cwd=project, stdin=user.stdin))


def test_a_project_depends_on_it(tmp_path: Path) -> None:
    built(
        consumer("stanford_3dof", "fpm", Options(("inverse_dynamics", "mass_matrix", "jacobian"))), tmp_path
    )


def test_in_float_with_parameters_and_sines_of_its_own(arm: Path, tmp_path: Path) -> None:
    options = Options(scalar="float", trig="builtin")
    built(consumer(str(arm), "fpm", options, parameters={"m_tool": 1.5}), tmp_path)


def test_it_is_installed(tmp_path: Path) -> None:
    user = consumer("stanford_3dof", "fpm", Options(("gravity",)), license="MIT", maintainer=MAINTAINER)
    package = write(tmp_path / "package", user.package.files())
    assert tomllib.loads((package / "fpm.toml").read_text(encoding="utf-8"))["maintainer"] == MAINTAINER
    run(*FPM, "install", "--prefix", tmp_path / "prefix", cwd=package)
    write(tmp_path, {"main.f90": fortran_program(user)})
    prefix = tmp_path / "prefix"
    link = (f"-I{prefix}/include", "main.f90", f"-L{prefix}/lib", f"-l{user.package.name}")
    run(require_tool("gfortran"), *link, "-o", "consumer", cwd=tmp_path)
    user.check(run(tmp_path / "consumer", cwd=tmp_path, stdin=user.stdin))
