"""Products and sums that are not to be fused are not, by any compiler of this machine."""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from emit.kernels import write
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import load
from robodyn_testing import require_machine, require_tool

FUNCTIONS = ("forward_dynamics",)


def made(name: str, **options: Any) -> Generated:
    return generate(load(name, warn=lambda _: None), Options(FUNCTIONS, optimize="none", **options))


def results(library: ctypes.CDLL, generated: Generated) -> dict[str, NDArray[np.float64]]:
    """What each function says at forty states."""
    found = {}
    for signature in generated.signatures:
        random = np.random.default_rng(3)
        rows = []
        for _ in range(40):
            given = [random.uniform(-3, 3, size) for _, size in signature.inputs]
            told = [np.empty(size) for _, size in signature.outputs]
            arrays = (a.ctypes.data_as(ctypes.c_void_p) for a in (*given, *told))
            getattr(library, signature.symbol)(*arrays)
            rows.append(np.concatenate(told))
        found[signature.function] = np.array(rows)
    return found


@pytest.mark.parametrize("name", ["ur5", pytest.param("puma560", marks=pytest.mark.thorough)])
@pytest.mark.parametrize("options", [{"trig": "builtin"}, {"contraction": "off"}], ids=str)
def test_bits_are_the_same_with_fused_instructions_at_hand(
    name: str, options: dict[str, str], tmp_path: Path
) -> None:
    require_machine(" fma " in Path("/proc/cpuinfo").read_text(), "a processor that fuses products and sums")
    generated = made(name, **options)
    write(tmp_path, generated.files(("c",)))
    bits = {}
    for cc in ("gcc", "clang"):
        for flags in ("-O0", "-O2 -mfma", "-O3 -march=x86-64-v3"):
            library = f"{cc}{flags.replace(' ', '')}.so"
            command = [require_tool(cc), *flags.split(), "-ffp-contract=off", "-shared", "-fPIC", f"{name}.c"]
            subprocess.run([*command, "-o", library, "-lm"], cwd=tmp_path, check=True)
            found = results(ctypes.CDLL(str(tmp_path / library)), generated)
            bits[cc, flags] = {function: rows.tobytes() for function, rows in found.items()}
    expected = bits["gcc", "-O0"]
    for way, found_ in bits.items():
        for function, text in found_.items():
            assert text == expected[function], (way, function)


@pytest.mark.parametrize("flags", ["-mfma", "-march=x86-64-v3", "-march=x86-64-v4"])
def test_no_instruction_fuses(flags: str, tmp_path: Path) -> None:
    """On processors that this machine does not have, too."""
    generated = made("ur5", trig="builtin")
    write(tmp_path, generated.files(("c",), batch=True))
    for file in ("ur5.c", "ur5_batch.c"):
        command = [require_tool("gcc"), "-O3", "-ffp-contract=off", flags, "-S", file, "-o", "-"]
        done = subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True)
        assert "vmulpd" in done.stdout
        assert "vfm" not in done.stdout
        assert "vfnm" not in done.stdout
