"""The tests that a package has: they pass where they are built, and a wrong kernel fails them."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from emit.kernels import STRICT, STRICT_FORTRAN, in_single, made
from packages.consumers import run, write
from robodyn.packages import Package, package
from robodyn_testing import require_module, require_tool

pytestmark = pytest.mark.thorough


def compiled(packed: Package, folder: Path) -> Path:
    """The program of a package's tests, compiled with every warning; nothing but what the package has."""
    kernel, tests = packed.kernel(), packed.tests()
    write(folder, {**kernel, **tests})
    compilers = {".c": ("cc", STRICT), ".f90": ("gfortran", STRICT_FORTRAN)}
    tool, flags = compilers[Path(next(iter(tests))).suffix]
    sources = [name for name in (*kernel, *tests) if not name.endswith(".h")]
    run(require_tool(tool), *flags, *sources, "-lm", "-o", "vectors", cwd=folder)
    return folder / "vectors"


@pytest.mark.parametrize(
    ("name", "trig", "scalar", "form"),
    [
        ("puma560", "builtin", "float", "cmake"),
        ("effects_remembering", "libm", "double", "cmake"),
        ("effects_smooth", "libm", "double", "fpm"),
        ("tool", "given", "float", "fpm"),
    ],
)
def test_they_pass(name: str, trig: str, scalar: str, form: str, tmp_path: Path) -> None:
    """Rigid, with memory and run-time parameters, with functions of libm."""
    generated = made(name, trig)
    packed = package(in_single(generated) if scalar == "float" else generated, form)
    assert "every result is within its tolerance" in run(compiled(packed, tmp_path), cwd=tmp_path)


@pytest.mark.parametrize("form", ["cmake", "fpm"])
def test_a_wrong_kernel_fails_them(form: str, tmp_path: Path) -> None:
    """One product, in the eighth digit."""
    packed = package(made("stanford_3dof", "builtin"), form)
    program = compiled(packed, tmp_path)
    run(program, cwd=tmp_path)
    source = tmp_path / next(name for name in packed.kernel() if not name.endswith(".h"))
    lines = source.read_text().splitlines(keepends=True)
    place = next(k for k, text in enumerate(lines) if re.match(r" +(const .* )?t\d+ = .*\*", text))
    scale = "0.99999999*" if form == "cmake" else "0.99999999_rk*"
    lines[place] = lines[place].replace(" = ", f" = {scale}", 1)
    source.write_text("".join(lines))
    tool = require_tool("cc" if form == "cmake" else "gfortran")
    sources = [name for name in (*packed.kernel(), *packed.tests()) if not name.endswith(".h")]
    run(tool, *sources, "-lm", "-o", "vectors", cwd=tmp_path)
    done = subprocess.run([program], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 1
    assert ", vector 1" in done.stdout


def test_cmake_and_fpm_run_them(tmp_path: Path) -> None:
    for form in ("cmake", "fpm"):
        folder = write(tmp_path / form, package(made("stanford_3dof", "libm"), form).files())
        if form == "cmake":
            run(require_tool("cmake"), "-S", ".", "-B", "build", cwd=folder)
            run("cmake", "--build", "build", cwd=folder)
            output = run(require_tool("ctest"), "-V", cwd=folder / "build")
        else:
            require_module("fpm")
            require_tool("gfortran")
            output = run(sys.executable, "-m", "fpm", "test", cwd=folder)
        assert "stanford_3dof: every result is within its tolerance" in output
