"""Square roots and absolute values without a C library: the same bits as with one, on every processor."""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from firmware.folders import STRICT, digests, fortran, host, require_firmware_tools, write
from robodyn.firmware import Folder, firmware, firmware_options, targets_named
from robodyn.firmware.digest import DTYPE
from robodyn.firmware.measure import FLAGS, measure
from robodyn.kernels.generate import Options, generate
from robodyn.robot import read_text
from robodyn_testing import require_tool

TEXT = """
name: worn
links:
  - joint: revolute
    mass: 3
    com: [0.1, 0, 0.2]
    effects: [{effect: load_dependent_friction, bearing: radial, mu_r: 0.02}]
  - joint: revolute
    alpha: pi/2
    a: 0.3
    mass: 2
    com: [0.2, 0.1, 0.1]
    effects: [{effect: load_dependent_friction, bearing: torque, mu: 0.03}]
"""


def folder(scalar: str) -> Folder:
    options = firmware_options(Options(), (), scalar=scalar)  # type: ignore[arg-type]
    return firmware(generate(read_text(TEXT, warn=lambda _: None), options), targets_named(()))


@pytest.mark.thorough
@pytest.mark.parametrize("scalar", ["float", pytest.param("double", marks=pytest.mark.slow)])
def test_all_processors_x86_and_fortran_give_the_same_bits(scalar: str, tmp_path: Path) -> None:
    files = folder(scalar).files
    write(tmp_path, files)
    code, said = host(require_tool("gcc"), "worn", tmp_path)
    assert code == 0, said
    by_processor = {
        "x86": digests(said)["inverse_dynamics"][0],
        "fortran": digests(fortran(require_tool("gfortran"), "worn", tmp_path)[1])["inverse_dynamics"][0],
    }
    for target in targets_named(()):
        require_firmware_tools(target)
        figures = measure("worn", files, ["inverse_dynamics"], target)
        assert not any(name.startswith(("sqrt", "fabs")) for name in figures.undefined)
        by_processor[target.name] = figures.costs[0].digest or 0
    assert len(set(by_processor.values())) == 1, by_processor


_ALL = """
#include "worn.c"
void all(long n, const worn_real *x, worn_real *roots);
void all(long n, const worn_real *x, worn_real *roots)
{
    for (long i = 0; i < n; ++i) roots[i] = worn_sqrt_(x[i]);
}
"""


@pytest.mark.parametrize("scalar", ["float", "double"])
def test_roots_digit_by_digit_are_rounded_correctly(scalar: str, tmp_path: Path) -> None:
    real: Any = DTYPE[scalar]  # type: ignore[index]
    write(tmp_path, folder(scalar).files)
    (tmp_path / "all.c").write_text(_ALL, encoding="ascii")
    # No compiler for this computer lacks the instruction: -U takes what says so away.
    command = [
        require_tool("gcc"),
        *STRICT,
        *FLAGS,
        "-U__SSE2__",
        "-shared",
        "-fPIC",
        "all.c",
        "-o",
        "all.so",
    ]
    subprocess.run(command, cwd=tmp_path, check=True)
    info, random = np.finfo(real), np.random.default_rng(3)
    special = [0.0, -0.0, 1.0, 2.0, 4.0, info.tiny, info.smallest_subnormal, info.max]
    special += [-1.0, np.inf, -np.inf, np.nan]
    bits = random.integers(0, 1 << (8 * real().nbytes - 1), 20_000, dtype=np.uint64)
    near = np.nextafter(np.arange(1, 200, dtype=real) ** 2, real(np.inf))
    subnormal = random.uniform(0, 1, 200).astype(real) * real(info.tiny)
    drawn = bits.astype(f"u{real().nbytes}").view(real)
    x = np.concatenate([np.array(special, real), drawn, near, subnormal])
    roots = np.empty_like(x)
    ctypes.CDLL(str(tmp_path / "all.so")).all(
        ctypes.c_long(x.size), *(a.ctypes.data_as(ctypes.c_void_p) for a in (x, roots))
    )
    with np.errstate(invalid="ignore"):
        expected = np.sqrt(x)
    assert np.array_equal(np.isnan(roots), np.isnan(expected))
    number = ~np.isnan(expected)
    assert roots[number].tobytes() == expected[number].tobytes()
