"""The package for CMake: installed, found by CMake and by pkg-config, static and shared, from C and C++."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

from packages.consumers import MAINTAINER, Consumer, c_program, consumer, loaded_arm, run, write
from robodyn.kernels.generate import Options, generate
from robodyn.packages import package
from robodyn.robot import load
from robodyn_testing import representative, require_tool

FUNCTIONS = ("inverse_dynamics", "mass_matrix", "jacobian")
ROBOT = "stanford_3dof"
PROJECT = """\
cmake_minimum_required(VERSION 3.16)
project(consumer LANGUAGES {language})
find_package({package} {wanted} REQUIRED)
add_executable(consumer main.{suffix})
target_link_libraries(consumer PRIVATE {package}::{package})
"""
INSIDE = """\
cmake_minimum_required(VERSION 3.16)
project(consumer LANGUAGES C)
add_subdirectory("{folder}" dynamics)
add_executable(consumer main.c)
target_link_libraries(consumer PRIVATE {package}::{package})
"""


@pytest.fixture(scope="module")
def cmake() -> str:
    require_tool("cc")
    return require_tool("cmake")


@pytest.fixture(scope="module")
def user() -> Consumer:
    return consumer(ROBOT, "cmake", Options(FUNCTIONS), license="BSD-3-Clause", maintainer=MAINTAINER)


def installed(cmake: str, user: Consumer, folder: Path, *options: str) -> Path:
    """The prefix at which the package is installed; it was moved there afterwards."""
    write(folder / "package", user.package.files())
    run(cmake, "-S", "package", "-B", "build", *options, cwd=folder)
    run(cmake, "--build", "build", cwd=folder)
    run(cmake, "--install", "build", "--prefix", folder / "staged", cwd=folder)
    shutil.rmtree(folder / "build")
    shutil.rmtree(folder / "package")
    return (folder / "staged").rename(folder / "prefix")


@pytest.mark.thorough
@pytest.mark.parametrize(("language", "suffix", "shared"), [("CXX", "cpp", "OFF"), ("C", "c", "ON")])
def test_a_project_finds_it(
    language: str, suffix: str, shared: str, cmake: str, user: Consumer, tmp_path: Path
) -> None:
    if language == "CXX":
        require_tool("g++")
    prefix = installed(cmake, user, tmp_path, f"-DBUILD_SHARED_LIBS={shared}")
    text = PROJECT.format(language=language, suffix=suffix, package=user.package.name, wanted="1.1")
    project = write(tmp_path / "consumer", {"CMakeLists.txt": text, f"main.{suffix}": c_program(user)})
    run(cmake, "-S", ".", "-B", "build", f"-DCMAKE_PREFIX_PATH={prefix}", cwd=project)
    run(cmake, "--build", "build", cwd=project)
    user.check(run(project / "build" / "consumer", cwd=project, stdin=user.stdin))
    libraries = {path.name for path in (prefix / "lib").iterdir() if path.is_file() or path.is_symlink()}
    library = f"lib{user.package.name}"
    names = {f"{library}.a"} if shared == "OFF" else {f"{library}.so{v}" for v in ("", ".1", ".1.2.3")}
    assert libraries == names


@pytest.mark.thorough
def test_another_version_is_not_found(cmake: str, user: Consumer, tmp_path: Path) -> None:
    prefix = installed(cmake, user, tmp_path)
    for wanted, fits in (("1.2.3", True), ("1.3", False), ("2.0", False), ("0.9", False)):
        text = PROJECT.format(language="C", suffix="c", package=user.package.name, wanted=wanted)
        text = text.replace("REQUIRED)", f")\nmessage(STATUS found=${{{user.package.name}_FOUND}})")
        project = write(tmp_path / wanted, {"CMakeLists.txt": text.partition("add_executable")[0]})
        output = run(cmake, "-S", ".", "-B", "build", f"-DCMAKE_PREFIX_PATH={prefix}", cwd=project)
        assert ("found=1" in output, "found=0" in output) == (fits, not fits), wanted


@pytest.mark.thorough
@pytest.mark.parametrize("shared", ["OFF", pytest.param("ON", marks=pytest.mark.slow)])
def test_pkg_config_finds_it(shared: str, cmake: str, user: Consumer, tmp_path: Path) -> None:
    pkg_config = require_tool("pkg-config")
    prefix = installed(cmake, user, tmp_path, f"-DBUILD_SHARED_LIBS={shared}")
    environment = {**os.environ, "PKG_CONFIG_PATH": str(prefix / "lib" / "pkgconfig")}
    ask = (pkg_config, "--cflags", "--libs", *(["--static"] * (shared == "OFF")), user.package.name)
    flags = run(*ask, cwd=tmp_path, environment=environment).split()
    assert (
        run(pkg_config, "--modversion", user.package.name, cwd=tmp_path, environment=environment) == "1.2.3\n"
    )
    record = (prefix / "lib" / "pkgconfig" / f"{user.package.name}.pc").read_text(encoding="utf-8")
    assert f"\nMaintainer: {MAINTAINER}\n" in record
    project = write(tmp_path / "consumer", {"main.c": c_program(user)})
    run(require_tool("cc"), "main.c", *flags, f"-Wl,-rpath,{prefix}/lib", "-o", "consumer", cwd=project)
    user.check(run(project / "consumer", cwd=project, stdin=user.stdin))


@pytest.mark.thorough
@pytest.mark.parametrize("name", representative(("test", "all", "m"), "test", rest="slow"))
def test_a_part_of_a_larger_build_whatever_the_robot_is_called(name: str, cmake: str, tmp_path: Path) -> None:
    """In float, with sines of its own and run-time parameters; names of targets that CMake has itself."""
    options = Options(scalar="float", trig="builtin")
    user = consumer(str(loaded_arm(tmp_path, name)), "cmake", options, parameters={"m_tool": 1.5})
    folder = write(tmp_path / "a package", user.package.files())
    text = INSIDE.format(folder=folder, package=user.package.name)
    project = write(tmp_path / "consumer", {"CMakeLists.txt": text, "main.c": c_program(user)})
    run(cmake, "-S", ".", "-B", "build", cwd=project)
    run(cmake, "--build", "build", cwd=project)
    user.check(run(project / "build" / "consumer", cwd=project, stdin=user.stdin))


@pytest.mark.parametrize(
    ("options", "flags"),
    [
        (Options(("gravity",)), "-ffp-contract=off;-fno-math-errno"),
        (
            Options.for_target("cortex-m4f", functions=("gravity",), contraction="on"),
            "-mcpu=cortex-m4;-mthumb;-mfpu=fpv4-sp-d16;-mfloat-abi=hard;-ffp-contract=fast;-fno-math-errno",
        ),
    ],
)
def test_arithmetic_is_compiled_as_it_is_written(options: Options, flags: str) -> None:
    """Or as it was asked for; how far the rest is optimised is the project's affair."""
    files = package(generate(load(ROBOT), options), "cmake").files()
    assert f':{flags}>")' in str(files["CMakeLists.txt"])
    assert ("PRIVATE m)" in str(files["CMakeLists.txt"])) == (options.trig == "libm")
