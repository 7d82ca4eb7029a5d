"""The crate and the package for fpm, Fortran's package manager: dependencies of projects, tested, published,
installed."""

from __future__ import annotations

import os
import sys
import tomllib
from pathlib import Path

import pytest

from emit.crates import without_network
from packages.consumers import (
    MAINTAINER,
    consumer,
    fortran_program,
    loaded_arm,
    run,
    write,
)
from robodyn.kernels.generate import Options
from robodyn_testing import require_module, require_tool

pytestmark = pytest.mark.thorough
FPM = """\
name = "consumer"
[dependencies]
{package} = {{ path = "../package" }}
"""


def fpm() -> tuple[str, ...]:
    """The command."""
    require_module("fpm")
    require_tool("gfortran")
    return (sys.executable, "-m", "fpm")


def cargo_environment(folder: Path) -> dict[str, str]:
    return {**os.environ, "RUSTFLAGS": "-D warnings", "CARGO_TARGET_DIR": str(folder / "target")}


def test_a_project_depends_on_an_fpm_package_in_float_with_parameters(tmp_path: Path) -> None:
    """Called like the tool. A crate is used so by its own tests, which see no more of it than a project."""
    options = Options(scalar="float", trig="builtin")
    user = consumer(str(loaded_arm(tmp_path, "fpm")), "fpm", options, parameters={"m_tool": 1.5})
    write(tmp_path / "package", user.package.files())
    manifest = FPM.format(package=user.package.name)
    project = write(tmp_path / "project", {"fpm.toml": manifest, "app/main.f90": fortran_program(user)})
    run(*fpm(), "build", "--profile", "release", cwd=project)
    user.check(run(*fpm(), "run", "--profile", "release", cwd=project, stdin=user.stdin))


def test_a_crate_in_float_with_parameters(tmp_path: Path) -> None:
    """Called like a crate of Rust's own, and without a library of sines in float."""
    options = Options(scalar="float", trig="libm")
    user = consumer(str(loaded_arm(tmp_path, "core")), "crate", options, parameters={"m_tool": 1.5})
    assert user.package.name == "core_dynamics"
    files = user.package.files()
    package = write(tmp_path / "package", files)
    write(package, without_network(str(files["Cargo.toml"])))
    command = (require_tool("cargo"), "test", "--offline", "--quiet")
    run(*command, cwd=package, environment=cargo_environment(tmp_path))


def test_cargo_would_publish_it(tmp_path: Path) -> None:
    """Built from the very archive, its tests included, without a warning."""
    cargo = require_tool("cargo")
    options = Options(("gravity",), trig="builtin")
    user = consumer("stanford_3dof", "crate", options, license="MIT", maintainer=MAINTAINER)
    package = write(tmp_path / "package", user.package.files())
    manifest = tomllib.loads((package / "Cargo.toml").read_text(encoding="utf-8"))
    assert manifest["package"]["authors"] == [MAINTAINER]
    environ = cargo_environment(tmp_path)
    run(cargo, "package", "--offline", "--quiet", "--allow-dirty", cwd=package, environment=environ)
    listed = run(cargo, "package", "--offline", "--list", "--allow-dirty", cwd=package, environment=environ)
    assert {"Cargo.toml", "README.md", "src/lib.rs", "tests/vectors.rs"} <= set(listed.split())
    run(cargo, "test", "--offline", "--quiet", cwd=package, environment=environ)


def test_fpm_installs_it(tmp_path: Path) -> None:
    user = consumer("stanford_3dof", "fpm", Options(("gravity",)), license="MIT", maintainer=MAINTAINER)
    package = write(tmp_path / "package", user.package.files())
    assert tomllib.loads((package / "fpm.toml").read_text(encoding="utf-8"))["maintainer"] == MAINTAINER
    prefix = tmp_path / "prefix"
    run(*fpm(), "install", "--prefix", prefix, cwd=package)
    write(tmp_path, {"main.f90": fortran_program(user)})
    link = (f"-I{prefix}/include", "main.f90", f"-L{prefix}/lib", f"-l{user.package.name}")
    run(require_tool("gfortran"), *link, "-o", "consumer", cwd=tmp_path)
    user.check(run(tmp_path / "consumer", cwd=tmp_path, stdin=user.stdin))
