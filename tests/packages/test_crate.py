"""The crate: a dependency of a project, with cargo's own check of what would be published."""

from __future__ import annotations

import os
import tomllib
from pathlib import Path

import pytest

from emit.crates import without_network
from packages.consumers import MAINTAINER, Consumer, consumer, run, rust_program, write
from robodyn.kernels.generate import Options
from robodyn_testing import require_tool

pytestmark = pytest.mark.thorough
PROJECT = """\
[package]
name = "consumer"
version = "0.1.0"
edition = "2021"
[dependencies]
{package} = {{ path = "../package", version = "1.2" }}
"""


def environment(folder: Path) -> dict[str, str]:
    return {**os.environ, "RUSTFLAGS": "-D warnings", "CARGO_TARGET_DIR": str(folder / "target")}


def built(user: Consumer, folder: Path) -> None:
    """Build the project that depends on the package, run it, and hold its numbers to what is expected."""
    cargo = require_tool("cargo")
    files = user.package.files()
    write(folder / "package", files)
    manifest = PROJECT.format(package=user.package.name)
    project = write(folder / "project", {"Cargo.toml": manifest, "src/main.rs": rust_program(user)})
    write(project, without_network(str(files["Cargo.toml"])))
    output = run(
        cargo, "run", "--offline", "--quiet", cwd=project, stdin=user.stdin, environment=environment(folder)
    )
    user.check(output)


def test_a_project_depends_on_it(tmp_path: Path) -> None:
    options = Options(("inverse_dynamics", "mass_matrix", "jacobian"), trig="builtin")
    built(consumer("stanford_3dof", "crate", options), tmp_path)


def test_in_float_with_parameters_and_the_sines_of_libm(tmp_path: Path) -> None:
    """Called like a crate of Rust's own, and a parameter like a word of Rust."""
    path = tmp_path / "arm.yaml"
    path.write_text(
        "name: core\nlinks:\n- {joint: revolute, alpha: pi/2, mass: m_tool, com: [0.1, 0.2, 0]}\n"
        "- {joint: prismatic, alpha: 1, mass: 2, com: [0.1, 0, 0.2], motor_inertia: 1}\n"
    )
    user = consumer(str(path), "crate", Options(scalar="float"), parameters={"m_tool": 1.5})
    assert user.package.name == "core_dynamics"
    built(user, tmp_path)


def test_cargo_would_publish_it(tmp_path: Path) -> None:
    """Built from the very archive, its tests included, without a warning."""
    cargo = require_tool("cargo")
    options = Options(("gravity",), trig="builtin")
    user = consumer("stanford_3dof", "crate", options, license="MIT", maintainer=MAINTAINER)
    package = write(tmp_path / "package", user.package.files())
    manifest = tomllib.loads((package / "Cargo.toml").read_text(encoding="utf-8"))
    assert manifest["package"]["authors"] == [MAINTAINER]
    environ = environment(tmp_path)
    run(cargo, "package", "--offline", "--quiet", "--allow-dirty", cwd=package, environment=environ)
    listed = run(cargo, "package", "--offline", "--list", "--allow-dirty", cwd=package, environment=environ)
    assert {"Cargo.toml", "README.md", "src/lib.rs", "tests/vectors.rs"} <= set(listed.split())
    run(cargo, "test", "--offline", "--quiet", cwd=package, environment=environ)
