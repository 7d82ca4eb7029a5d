"""The module for Zephyr: configured by Kconfig, built by CMake as its build does, and run on this machine.

Zephyr itself is on no registry. In its place stands a package of the same name (``zephyr``) with the few
functions and symbols that a module uses; Kconfig files are read by kconfiglib, Zephyr's own reader.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from packages.consumers import UPPER_CASE, packaged, run, write
from robodyn_testing import require_module, require_tool

pytestmark = pytest.mark.thorough

ZEPHYR = Path(__file__).parent / "zephyr"
LIBM = ("--scalar", "double", "--trig", "libm")


@pytest.fixture(scope="module")
def cmake() -> str:
    require_tool("cc")
    require_module("kconfiglib")
    return require_tool("cmake")


def built(cmake: str, module: Path, folder: Path) -> str:
    """What is said while the sample of ``module`` is built in ``folder``."""
    found = (f"-DZephyr_DIR={ZEPHYR}", f"-DPYTHON={sys.executable}", "-DCMAKE_C_FLAGS=-Wall -Wextra -Werror")
    run(cmake, "-S", module / "samples" / "selftest", "-B", "build", *found, cwd=folder)
    return run(cmake, "--build", "build", "--verbose", cwd=folder)


@pytest.mark.parametrize(("robot", "options"), [("stanford_3dof", ()), (UPPER_CASE, LIBM)])
def test_the_sample(robot: str, options: tuple[str, ...], cmake: str, tmp_path: Path) -> None:
    """It is configured without a warning and passes; a wrong kernel does not."""
    name = "stanford_3dof" if robot != UPPER_CASE else "UPPER_case"
    module = packaged(tmp_path / "module", robot, "zephyr", *options)
    told = built(cmake, module, tmp_path)
    (compiled,) = (line for line in told.splitlines() if line.endswith(f"{name}.c"))
    assert "-ffp-contract=off" in compiled
    expected = run(tmp_path / "build" / "app", cwd=tmp_path)
    sample = yaml.safe_load((module / "samples" / "selftest" / "sample.yaml").read_text())
    (test,) = sample["tests"].values()
    (pattern,) = test["harness_config"]["regex"]
    assert re.search(pattern, expected)
    source = module / "src" / f"{name}.c"
    source.write_text(re.sub(r"(\btau\[\d\] = )", r"\g<1>1e-2f + ", source.read_text()))
    built(cmake, module, tmp_path)
    assert subprocess.run([tmp_path / "build" / "app"], capture_output=True).returncode == 1


def test_what_needs_libm_is_not_built_without(cmake: str, tmp_path: Path) -> None:
    """Zephyr's minimal C library has no sine: the option is not to be had with it."""
    module = packaged(tmp_path / "module", "stanford_3dof", "zephyr", *LIBM)
    with (module / "samples" / "selftest" / "prj.conf").open("a") as file:
        file.write("CONFIG_MINIMAL_LIBC=y\n")
    configure = (sys.executable, ZEPHYR / "configure.py", module, module / "samples/selftest/prj.conf")
    done = subprocess.run(configure, capture_output=True, text=True)
    assert done.returncode == 1
    assert "STANFORD_3DOF_DYNAMICS" in done.stderr
    run(*configure[:2], packaged(tmp_path / "other", "stanford_3dof", "zephyr"), configure[3], cwd=tmp_path)


def test_the_option(cmake: str, tmp_path: Path) -> None:
    """It turns the FPU on where there is one, and is off unless it is asked for."""
    module = packaged(tmp_path / "module", "stanford_3dof", "zephyr")
    write(tmp_path, {"on.conf": "CONFIG_STANFORD_3DOF_DYNAMICS=y\n", "off.conf": ""})
    configured = [
        run(sys.executable, ZEPHYR / "configure.py", module, tmp_path / f"{state}.conf", cwd=tmp_path)
        for state in ("on", "off")
    ]
    assert ['set(CONFIG_FPU "y")' in text for text in configured] == [True, False]
    assert ['set(CONFIG_STANFORD_3DOF_DYNAMICS "y")' in text for text in configured] == [True, False]
