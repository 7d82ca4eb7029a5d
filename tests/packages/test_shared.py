"""A shared library as bytes: loaded it gives the kernel's numbers, and it is the same every time."""

from __future__ import annotations

import ctypes
from pathlib import Path

import pytest

from robodyn.errors import ToolError
from robodyn.toolchain.shared import shared_library
from robodyn_testing import require_tool

FILES = {
    "inner/twice.h": "double twice(double x);\n",
    "inner/twice.c": '#include "twice.h"\ndouble twice(double x) { return 2 * x; }\n',
    "more.c": '#include "inner/twice.h"\ndouble four_times(double x) { return twice(twice(x)); }\n',
}


@pytest.mark.thorough
def test_a_library(tmp_path: Path) -> None:
    require_tool("cc")
    data = shared_library(FILES, "libtwice.so")
    assert data == shared_library(FILES, "libtwice.so")
    path = tmp_path / "libtwice.so"
    path.write_bytes(data)
    four_times = ctypes.CDLL(str(path)).four_times
    four_times.restype, four_times.argtypes = ctypes.c_double, [ctypes.c_double]
    assert four_times(1.5) == 6.0


def test_what_the_compiler_refuses() -> None:
    require_tool("cc")
    with pytest.raises(ToolError, match=r"the C compiler failed at wrong\.c; found .*error"):
        shared_library({"wrong.c": "double wrong(void) { return; ]\n"}, "libwrong.so")
