"""Kernels under the sanitizers and the analyser, on any bytes; fuzzers where they are asked for."""

from __future__ import annotations

import itertools
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from certify.harness import harness
from robodyn.kernels.generate import TRIGONOMETRY, Generated, Options, generate
from robodyn.robot import load
from robodyn_testing import representative, require_module, require_tool, sampled

SANITIZERS = "-fsanitize=address,undefined,float-cast-overflow"
FIRM = ("-std=c99", "-g", "-O1", "-fno-sanitize-recover=all")
FUZZ_SECONDS = int(os.environ.get("ROBODYN_FUZZ_SECONDS", "600"))


def written(folder: Path, robot: str, trig: str, scalar: str) -> Generated:
    """The kernels of ``robot`` with the harness beside them, in ``folder``."""
    options = Options(trig=trig, scalar=scalar)  # type: ignore[arg-type]
    made = generate(load(robot, warn=lambda _: None), options)
    for name, text in made.files(("c",)).items():
        (folder / name).write_text(text, encoding="utf-8")
    (folder / "harness.c").write_text(harness(made.signatures), encoding="utf-8")
    return made


def said(command: list[str], folder: Path, seconds: float = 300.0) -> str:
    """Run a command that must succeed; what it said."""
    done = subprocess.run(
        command, cwd=folder, capture_output=True, text=True, errors="replace", timeout=seconds, check=False
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
    return done.stdout + done.stderr


@pytest.mark.parametrize(
    ("scalar", "trig"),
    representative(itertools.product(["float", "double"], TRIGONOMETRY), ("float", "builtin")),
)
def test_sanitizers_find_nothing_on_random_bytes(tmp_path: Path, trig: str, scalar: str) -> None:
    gcc = require_tool("gcc")
    written(tmp_path, "puma560", trig, scalar)
    said([gcc, *FIRM, SANITIZERS, "-DALONE", "puma560.c", "harness.c", "-lm", "-o", "run"], tmp_path)
    assert said(["./run"], tmp_path) == ""


@pytest.mark.parametrize("trig", sampled(TRIGONOMETRY, every=3))
def test_gcc_analyzer_finds_nothing(tmp_path: Path, trig: str) -> None:
    gcc = require_tool("gcc")
    for scalar in ("float", "double"):
        written(tmp_path, "puma560", trig, scalar)
        flags = ["-std=c99", "-O2", "-fanalyzer", "-Wall", "-Wextra", "-Werror"]
        assert said([gcc, *flags, "-c", "puma560.c", "-o", "k.o"], tmp_path) == ""


@pytest.mark.slow
@pytest.mark.parametrize("scalar", ["float", "double"])
def test_libfuzzer_finds_nothing(tmp_path: Path, scalar: str) -> None:
    """Half of the time for each type; what it ran is printed."""
    clang = require_tool("clang")
    written(tmp_path, "puma560", "builtin", scalar)
    probe = [clang, "-fsanitize=fuzzer,address", "-x", "c", "-", "-o", "probe"]
    text = "int LLVMFuzzerTestOneInput(const char *d, unsigned long n)\n{ return !d && n; }\n"
    if subprocess.run(
        probe, cwd=tmp_path, input=text, text=True, capture_output=True, check=False
    ).returncode:
        require_tool("the runtime of clang's libFuzzer (Debian: libclang-rt-14-dev)")
    said(
        [clang, *FIRM, f"{SANITIZERS},fuzzer", "puma560.c", "harness.c", "-lm", "-o", "fuzz"],
        tmp_path,
    )
    seconds = FUZZ_SECONDS // 2
    told = said(["./fuzz", f"-max_total_time={seconds}", "-max_len=1024"], tmp_path, seconds + 120)
    done = re.search(r"Done ([0-9]+) runs in ([0-9]+) second", told)
    assert done is not None
    print(f"libFuzzer, {scalar}: {done[1]} runs in {done[2]} s")
    assert int(done[1]) > 100_000


@pytest.mark.slow
def test_atheris_finds_nothing_in_the_reader(tmp_path: Path) -> None:
    require_module("atheris")
    script = Path(__file__).with_name("fuzz_reader.py")
    command = [sys.executable, str(script), "corpus", f"-max_total_time={FUZZ_SECONDS}", "-timeout=60"]
    told = said(command, tmp_path, FUZZ_SECONDS + 300)
    done = re.search(r"Done ([0-9]+) runs in ([0-9]+) second", told)
    assert done is not None
    print(f"atheris: {done[1]} runs in {done[2]} s")
    assert int(done[1]) > 1000
