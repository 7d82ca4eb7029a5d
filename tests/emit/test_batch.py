"""The files of batches: clean with every compiler, the same every time, nothing but code in the objects."""

from __future__ import annotations

import re
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from emit.kernels import STRICT, STRICT_CPP, complaints, in_single, made, together, write
from robodyn.emit.batch import STREAMED
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


#: Exit code 1: another bit than row by row; 3, 4: written where nothing belongs.
MAIN = """#define _POSIX_C_SOURCE 200112L
#include "NAME_batch.h"
#include <stdlib.h>
#include <string.h>

/* Places of the numbers of count states in blocks, up to the last that is read or written. */
static size_t at(size_t k, size_t j, size_t block) { return (k / block * 6 + j) * block + k % block; }
static size_t length(size_t count, size_t block) { return count ? at(count - 1, 5, block) + 1 : 0; }

/* Aligned with a line of the cache, or an odd number behind. */
static NAME_real *array(size_t size, size_t odd, void **kept)
{
    if (posix_memalign(kept, 64, (size + odd) * sizeof(NAME_real) + (size + odd == 0))) exit(2);
    return (NAME_real *)*kept + odd;
}

static void compared(size_t count, size_t block, size_t odd)
{
    void *kept[8];
    NAME_real *a[4], *b[4];
    size_t i, k, j;
    for (i = 0; i < 4; ++i) {
        a[i] = array(length(count, block), odd, &kept[i]);
        b[i] = array(6 * count, 0, &kept[4 + i]);
        for (k = 0; k < length(count, block); ++k) a[i][k] = 7;
        for (k = 0; k < count; ++k) {
            for (j = 0; j < 6; ++j) {
                b[i][6 * k + j] = (NAME_real)((k * 7919 + j * 31 + i) % 601) / 100 - 3;
                a[i][at(k, j, block)] = b[i][6 * k + j];
            }
        }
    }
    NAME_inverse_dynamics_batch(count, block, a[0], a[1], a[2], a[3]);
    NAME_inverse_dynamics_batch_rows(count, b[0], b[1], b[2], b[3]);
    for (k = 0; k < count; ++k) {
        for (j = 0; j < 6; ++j) {
            if (memcmp(&a[3][at(k, j, block)], &b[3][6 * k + j], sizeof(NAME_real))) exit(1);
            a[3][at(k, j, block)] = 7;
        }
    }
    for (k = 0; k < length(count, block); ++k) {
        if (a[3][k] != 7) exit(3); /* between the last state and the next element */
    }
    for (i = 0; i < 8; ++i) free(kept[i]);
}

int main(void)
{
    const size_t blocks[] = {1, 2, 7, NAME_BATCH_BLOCK, NAME_BATCH_BLOCK + 1, 32, 70, 1000};
    const size_t counts[] = {0, 1, 2, 7, 8, 9, 15, 16, 17, 31, 33, 63, 64, 65, 70, 1029};
    size_t count, block;
    for (count = 0; count < sizeof counts / sizeof *counts; ++count) {
        for (block = 0; block < sizeof blocks / sizeof *blocks; ++block) {
            compared(counts[count], blocks[block], 0);
            compared(counts[count], blocks[block], 1);
        }
    }
    return 0;
}
""".replace("NAME_BATCH", "PUMA560_BATCH").replace("NAME", "puma560")


@pytest.mark.parametrize(
    ("scalar", "width", "streamed"),
    covering(
        representative(["double", "float"], "double"),
        representative([16, 32, 64, 0], 64),
        representative([0, STREAMED], 0),
    ),
)
def test_any_block_any_count_any_place(scalar: str, width: int, streamed: int, tmp_path: Path) -> None:
    """Each reads and writes its own states only, past the caches or not; nothing is undefined."""
    generated = made("puma560", "builtin")
    generated = in_single(generated) if scalar == "float" else generated
    first = replace(generated.unit, functions=generated.unit.functions[:1])
    files = replace(generated, unit=first).files(("c",), batch=True)
    limit = f"#define STREAMED ((size_t){STREAMED})"
    assert limit in files["puma560_batch.c"]
    code = files["puma560_batch.c"].replace(limit, f"#define STREAMED ((size_t){streamed})")
    write(tmp_path, {**files, "puma560_batch.c": code, "main.c": MAIN})
    flags = ("-std=c99", "-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    width_flag = f"-DPUMA560_BATCH_BYTES={width}"
    command = [require_tool("gcc"), *flags, width_flag, "puma560_batch.c", "main.c", "-lm", "-o", "main"]
    subprocess.run(command, cwd=tmp_path, check=True)
    done = subprocess.run(["./main"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
