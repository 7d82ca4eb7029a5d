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
    Consumer,
    consumer,
    fortran_program,
    loaded_arm,
    run,
    rust_program,
    write,
)
from robodyn.kernels.generate import Options
from robodyn_testing import require_module, require_tool

pytestmark = pytest.mark.thorough
CRATE = """\
[package]
name = "consumer"
version = "0.1.0"
edition = "2021"
[dependencies]
{package} = {{ path = "../package", version = "1.2" }}
"""
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


def check_project(user: Consumer, folder: Path) -> None:
    """Build the project that depends on the package, run it, and hold its numbers to what is expected."""
    files = user.package.files()
    write(folder / "package", files)
    if user.package.format.name == "crate":
        manifest = CRATE.format(package=user.package.name)
        project = write(folder / "project", {"Cargo.toml": manifest, "src/main.rs": rust_program(user)})
        write(project, without_network(str(files["Cargo.toml"])))
        command: tuple[str, ...] = (require_tool("cargo"), "run", "--offline", "--quiet")
    else:
        manifest = FPM.format(package=user.package.name)
        project = write(folder / "project", {"fpm.toml": manifest, "app/main.f90": fortran_program(user)})
        run(*fpm(), "build", "--profile", "release", cwd=project)
        command = (*fpm(), "run", "--profile", "release")
    user.check(run(*command, cwd=project, stdin=user.stdin, environment=cargo_environment(folder)))


@pytest.mark.parametrize(("form", "trig"), [("crate", "builtin"), ("fpm", "libm")])
def test_a_project_depends_on_it(form: str, trig: str, tmp_path: Path) -> None:
    functions = ("inverse_dynamics", "mass_matrix", "jacobian")
    check_project(consumer("stanford_3dof", form, Options(functions, trig=trig)), tmp_path)  # type: ignore[arg-type]


@pytest.mark.parametrize(("form", "name", "trig"), [("crate", "core", "libm"), ("fpm", "fpm", "builtin")])
def test_in_float_with_parameters(form: str, name: str, trig: str, tmp_path: Path) -> None:
    """Called like a crate of Rust's own, or like the tool."""
    options = Options(scalar="float", trig=trig)  # type: ignore[arg-type]
    user = consumer(str(loaded_arm(tmp_path, name)), form, options, parameters={"m_tool": 1.5})
    assert user.package.name == f"{name}_dynamics"
    check_project(user, tmp_path)


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
