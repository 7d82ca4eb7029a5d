"""The files of batches: clean with every compiler, the same every time, nothing but code in the objects."""

from __future__ import annotations

import re
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from emit.kernels import STRICT, STRICT_CPP, complaints, in_single, made, together, write
from robodyn_testing import covering, representative, require_tool

#: Inputs that nothing reads, parameters with the names of other things, every operation that is a call.
SOME = ("puma560", "ghosts", "lift", "tool", "confusing", "effects_rubbing", "effects_sliding", "smooth")


@pytest.fixture(scope="module", params=["float"])
def folder(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the files of some robots, batches and kernels, in double or float."""
    path = tmp_path_factory.mktemp(request.param)
    for name in SOME:
        generated = made(name, "given" if request.param == "given" else "builtin")
        if request.param == "float":
            generated = in_single(generated)
        write(path, generated.files(("c",), batch=True))
    return path


@pytest.mark.parametrize(
    ("compiler", "flags", "width"),
    covering(
        representative(
            [
                ("gcc", ("-x", "c", *STRICT)),
                ("clang", ("-x", "c", *STRICT)),
                ("g++", STRICT_CPP),
                ("clang++", STRICT_CPP),
            ],
            "gcc",
        ),
        representative([64, 0], 64),
    ),
)
def test_clean(compiler: str, flags: tuple[str, ...], width: int, folder: Path) -> None:
    """All in one program, too: no two robots get in each other's way."""
    sources = [f"{name}_batch.c" for name in SOME]
    widths = [f"-D{name.upper()}_BATCH_BYTES={width}" for name in SOME]
    file = together(sources, folder, f"together_{compiler}_{width}.h")
    assert complaints(require_tool(compiler), (*flags, "-O0", *widths), [file], folder) == ""


@pytest.mark.thorough
def test_nothing_but_code_is_in_the_object(tmp_path: Path) -> None:
    """No globals, no heap, and of other libraries only what finds out about the processor."""
    write(tmp_path, made("puma560").files(("c",), batch=True))
    flags = ("-std=c99", "-O2", "-c", "puma560_batch.c")
    subprocess.run([require_tool("gcc"), *flags], cwd=tmp_path, check=True)
    done = subprocess.run(
        [require_tool("nm"), "puma560_batch.o"], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    found = {(kind, name) for kind, name in re.findall(r"^[0-9a-f ]{16} (\w) (\S+)$", done.stdout, re.M)}
    assert {kind for kind, _ in found} <= {"T", "t", "r", "U"}
    assert {name for kind, name in found if kind == "U"} <= {"__cpu_model", "_GLOBAL_OFFSET_TABLE_"}
    functions = made("puma560").counts
    wanted = {f"puma560_{function}_batch{rows}" for function in functions for rows in ("", "_rows")}
    assert {name for kind, name in found if kind == "T"} == wanted


def test_what_remembers_is_left_out() -> None:
    generated = made("effects_remembering")
    files = generated.files(("c",), batch=True)
    assert "effects_remembering_gravity_batch(" in files["effects_remembering_batch.h"]
    assert "inverse_dynamics_batch" not in files["effects_remembering_batch.h"]


MAIN = """#include "NAME_batch.h"
#include <stdlib.h>
#include <string.h>
int main(void)
{
    size_t count, k;
    for (count = 0; count < 70; ++count) {
        const size_t size = 6 * count * sizeof(NAME_real);
        /* Each in a block of its own size, an odd number behind an aligned one. */
        NAME_real *a[4], *b[4];
        for (k = 0; k < 4; ++k) {
            a[k] = (NAME_real *)malloc(size + sizeof(NAME_real));
            b[k] = (NAME_real *)malloc(size + sizeof(NAME_real));
            if (!a[k] || !b[k]) return 2;
            memset(a[k], 0, size + sizeof(NAME_real));
            memset(b[k], 0, size + sizeof(NAME_real));
        }
        NAME_inverse_dynamics_batch(count, count, a[0] + 1, a[1] + 1, a[2] + 1, a[3] + 1);
        NAME_inverse_dynamics_batch_rows(count, b[0] + 1, b[1] + 1, b[2] + 1, b[3] + 1);
        for (k = 0; k < count; ++k) {
            size_t j;
            for (j = 0; j < 6; ++j) {
                if (memcmp(&a[3][1 + j * count + k], &b[3][1 + 6 * k + j], sizeof(NAME_real))) return 1;
            }
        }
        if (a[3][0] != 0 || b[3][0] != 0) return 3;
        for (k = 0; k < 4; ++k) {
            free(a[k]);
            free(b[k]);
        }
    }
    return 0;
}
"""


@pytest.mark.parametrize(
    ("scalar", "width"),
    covering(representative(["double", "float"], "double"), representative([16, 32, 64], 16)),
)
def test_sanitizers_find_nothing(scalar: str, width: int, tmp_path: Path) -> None:
    """Any count reads and writes its own states only; nothing is undefined."""
    generated = made("puma560", "builtin")
    generated = in_single(generated) if scalar == "float" else generated
    first = replace(generated.unit, functions=generated.unit.functions[:1])
    files = replace(generated, unit=first).files(("c",), batch=True)
    write(tmp_path, {**files, "main.c": MAIN.replace("NAME", "puma560")})
    flags = ("-std=c99", "-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    width_flag = f"-DPUMA560_BATCH_BYTES={width}"
    command = [require_tool("gcc"), *flags, width_flag, "puma560_batch.c", "main.c", "-lm", "-o", "main"]
    subprocess.run(command, cwd=tmp_path, check=True)
    done = subprocess.run(["./main"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
