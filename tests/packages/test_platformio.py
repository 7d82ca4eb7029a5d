"""The library for PlatformIO: taken by its core, which builds the sketch; run on this machine.

PlatformIO fetches platforms and SCons from a registry of its own. Here a platform for this machine with a
stand-in for Arduino's core (``platformio``) and PyPI's SCons lie where the fetched ones would.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import sys
from pathlib import Path

import pytest

from packages.consumers import MAINTAINER, UPPER_CASE, packaged, run, write
from robodyn_testing import require_module, require_tool

pytestmark = pytest.mark.thorough

BOARD = Path(__file__).parent / "platformio"
PLATFORM = {
    "platform.json": {
        "name": "host",
        "version": "1.0.0",
        "title": "host",
        "description": "the machine that runs the tests",
        "frameworks": {"arduino": {"package": "framework-host", "script": "builder/arduino.py"}},
        "packages": {"framework-host": {"type": "framework", "version": "1.0.0"}},
    },
    "boards/host.json": {
        "name": "host",
        "vendor": "tests",
        "url": "https://example.com",
        "frameworks": ["arduino"],
        "build": {"mcu": "host", "f_cpu": "1"},
        "upload": {"maximum_size": 1, "maximum_ram_size": 1},
    },
}
BUILDER = """\
from SCons.Script import Default, DefaultEnvironment
env = DefaultEnvironment()
for tool in ("gcc", "g++", "gnulink", "ar"):
    env.Tool(tool)
Default(env.BuildProgram())
"""
FRAMEWORK = """\
from SCons.Script import DefaultEnvironment
env = DefaultEnvironment()
core = env.PioPlatform().get_package_dir("framework-host")
env.Append(CPPPATH=[core])
env.Prepend(LIBS=[env.BuildLibrary("$BUILD_DIR/core", core)])
"""
PROJECT = """\
[env:host]
platform = host
board = host
framework = arduino
build_flags = -Wall -Wextra -Werror
lib_deps = symlink://{library}
"""


@pytest.fixture(scope="module")
def core(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """PlatformIO's folder with all that it would fetch."""
    require_tool("g++")
    require_module("SCons")
    dependencies = require_module("platformio.dependencies")
    version = dependencies.get_core_dependencies()["tool-scons"].lstrip("~^")
    folder = tmp_path_factory.mktemp("core")
    named = {"name": "tool-scons", "version": version}
    spec = {"owner": "platformio", "id": None, "name": "tool-scons", "requirements": None, "uri": None}
    write(
        folder / "packages" / "tool-scons",
        {
            "package.json": json.dumps(named),
            ".piopm": json.dumps({"type": "tool", **named, "spec": spec}),
            "scons.py": "import SCons.Script\nSCons.Script.main()\n",
        },
    )
    framework = folder / "packages" / "framework-host"
    shutil.copytree(BOARD, framework)
    write(framework, {"package.json": json.dumps({"name": "framework-host", "version": "1.0.0"})})
    platform = {path: json.dumps(content) for path, content in PLATFORM.items()}
    write(
        folder / "platforms" / "host",
        {**platform, "builder/main.py": BUILDER, "builder/arduino.py": FRAMEWORK},
    )
    return folder


def pio(core: Path, cwd: Path, *arguments: str) -> str:
    environment = {
        **os.environ,
        "PLATFORMIO_CORE_DIR": str(core),
        "PLATFORMIO_SETTING_ENABLE_TELEMETRY": "no",
    }
    environment.pop("PYTHONPATH", None)
    return run(sys.executable, "-m", "platformio", *arguments, cwd=cwd, environment=environment)


@pytest.mark.parametrize(
    ("robot", "options"), [("stanford_3dof", ()), (UPPER_CASE, ("--scalar", "double", "--trig", "libm"))]
)
def test_the_sketch(robot: str, options: tuple[str, ...], core: Path, tmp_path: Path) -> None:
    """PlatformIO makes C++ of the sketch, finds the library by its header and builds it with its own flags;
    a wrong kernel is told."""
    library = packaged(tmp_path / "library", robot, "platformio", *options)
    project = write(tmp_path / "project", {"platformio.ini": PROJECT.format(library=library)})
    shutil.copytree(library / "examples" / "selftest", project / "src")
    told = pio(core, project, "run", "-v")
    name = json.loads((library / "library.json").read_text())["headers"].removesuffix(".h")
    assert f"{name}_dynamics @ 0.1.0" in told
    (compiled,) = (line for line in told.splitlines() if line.endswith(f"{name}.c"))
    assert "-ffp-contract=off" in compiled
    program = project / ".pio" / "build" / "host" / "program"
    assert run(program, cwd=project) == 2 * f"{name}: every result is within its tolerance, 0 us\n"
    source = library / "src" / f"{name}.c"
    text = source.read_text()
    source.write_text(re.sub(r"(\btau\[\d\] = )", r"\g<1>1e-2f + ", text))
    pio(core, project, "run")
    assert run(program, cwd=project).count(f"{name}: results are wrong") == 2


def test_it_is_packed(core: Path, tmp_path: Path) -> None:
    """Both manifests are valid for PlatformIO, which makes an archive of all files."""
    library = packaged(tmp_path / "library", "stanford_3dof", "platformio")
    pio(core, library, "pkg", "pack", "-o", str(tmp_path / "packed.tar.gz"))
    files = {path.relative_to(library).as_posix() for path in library.rglob("*") if path.is_file()}
    shutil.unpack_archive(tmp_path / "packed.tar.gz", tmp_path / "packed")
    packed = {path.relative_to(tmp_path / "packed").as_posix() for path in (tmp_path / "packed").rglob("*.*")}
    assert packed == files
    (library / "library.json").unlink()
    pio(core, library, "pkg", "pack", "-o", str(tmp_path / "arduino.tar.gz"))  # by library.properties


def test_licence_and_maintainer_are_stated(tmp_path: Path) -> None:
    options = ("--license", "BSD-3-Clause", "--maintainer", MAINTAINER)
    library = packaged(tmp_path / "library", "stanford_3dof", "platformio", *options)
    manifest = json.loads((library / "library.json").read_text())
    assert manifest["license"] == "BSD-3-Clause"
    (author,) = manifest["authors"]
    assert "{name} <{email}>".format(**author) == MAINTAINER
    lines = (library / "library.properties").read_text(encoding="utf-8").splitlines()
    assert {f"author={MAINTAINER}", f"maintainer={MAINTAINER}"} <= set(lines)
