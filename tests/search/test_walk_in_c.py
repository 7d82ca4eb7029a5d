"""The C code of the walk: warnings, bounds, undefined behaviour."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from robodyn.search import walk as walking
from robodyn_testing import require_tool

SOURCE = Path(walking.__file__).parent / "c" / "walk.c"


# --- the C code -------------------------------------------------------------------------------------------

STRICT = ("-Wall", "-Wextra", "-Wshadow", "-Wpointer-arith", "-Wstrict-prototypes", "-Werror")


@pytest.mark.parametrize(("compiler", "level"), [("gcc", "-O2"), ("clang", "-O1")])
def test_compilers_have_nothing_to_say(compiler: str, level: str, tmp_path: Path) -> None:
    command = [require_tool(compiler), "-std=gnu11", level, *STRICT, "-c", str(SOURCE), "-o", "walk.o"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


DRIVER = """
import sys
import cffi
from fractions import Fraction
from records.made import ELBOW, arm, bundled, fast
from robodyn.search import walk as walking
from robodyn.search.network import NoWalk
from robodyn.dynamics.equality import equals_recursion
from robodyn_testing.random_robots import random_robot

ffi = cffi.FFI()
ffi.cdef(walking._DECLARED)
library = ffi.dlopen(sys.argv[1])
walking.library = lambda: (ffi, library)
steps = int(sys.argv[2])
robots = [arm(ELBOW), random_robot(6), bundled("stanford_3dof_d3"), random_robot(22, exotic=0)]
for k, robot in enumerate(robots if steps > 100 else robots[:1]):
    for function in ("inverse_dynamics", "mass_matrix")[: 2 if steps > 100 else 1]:
        for kind in (0, 1, 2):
            for temperature in (0.3, 50.0):
                try:
                    walk = walking.Walk([fast(robot, function)], seed=k + 1, objective=kind)
                except NoWalk:
                    continue
                walk.run(steps, temperature)
                assert equals_recursion(robot, function, walk.best(), points=1)
                del walk
print("done")
"""


@pytest.mark.thorough
def test_no_step_out_of_bounds(tmp_path: Path) -> None:
    sanitized(tmp_path, steps=60)


def sanitized(folder: Path, steps: int) -> None:
    """Walk with every access to memory and every arithmetic checked."""
    gcc = require_tool("gcc")
    runtimes = []
    for name in ("libasan.so", "libubsan.so"):
        found = subprocess.run([gcc, f"-print-file-name={name}"], capture_output=True, text=True, check=True)
        runtimes.append(found.stdout.strip())
        if not Path(runtimes[-1]).is_absolute():
            require_tool(f"gcc with {name}")
    flags = ["-std=gnu11", "-g", "-O1", "-shared", "-fPIC", "-fno-sanitize-recover=all"]
    checks = "-fsanitize=address,undefined,float-cast-overflow"
    subprocess.run([gcc, *flags, checks, str(SOURCE), "-o", "walk.so"], cwd=folder, check=True)
    environment = dict(
        os.environ,
        LD_PRELOAD=" ".join(runtimes),
        ASAN_OPTIONS="detect_leaks=0:abort_on_error=0",
        UBSAN_OPTIONS="print_stacktrace=1",
        PYTHONPATH=os.pathsep.join(path for path in sys.path if path),
    )
    done = subprocess.run(
        [sys.executable, "-c", DRIVER, str(folder / "walk.so"), str(steps)],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stdout) == (0, "done\n"), done.stderr[-3000:]
