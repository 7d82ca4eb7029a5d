"""How many instructions a call of a kernel takes, counted by valgrind.

    python benchmarks/instructions.py [ROBOT ...] [--function F] [--trig T ...] [--scalar S ...]
        [--march M ...] [--cc CC] [--check]

Each kernel is compiled with ``-std=c99 -O2 -march=M`` and called in a loop under ``valgrind
--tool=callgrind``, with two lengths of the loop: the difference is what calls take. ``call`` is the function
itself, ``loop`` with the loop about it. The figures are repeatable on a machine under load, and those of a
compiler, not of a CPU. With ``--check`` the exit code is 1 where puma560 exceeds its ceiling.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from robodyn.kernels.generate import Options, generate
from robodyn.robot import load

#: Instructions a call that puma560's inverse dynamics may take, built for x86-64-v3, in either scalar.
CEILINGS = {"builtin": 450, "given": 340}
_SHORT, _LONG = 100, 1100


@dataclass(frozen=True)
class Instructions:
    """What was counted of one kernel: instructions of a call, and with the loop about it."""

    robot: str
    trig: str
    scalar: str
    march: str
    call: int
    loop: int


def measure(
    robot: str, trig: str, scalar: str, march: str, function: str = "inverse_dynamics", cc: str = "gcc"
) -> Instructions:
    """Count the instructions of a call of ``robot``'s ``function``.

    Raises
    ------
    subprocess.CalledProcessError: the compiler or valgrind fails.
    """
    options = Options(functions=(function,), trig=trig, scalar=scalar)  # type: ignore[arg-type]
    generated = generate(load(robot, warn=lambda _: None), options)
    (interface,) = generated.signatures
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, text in generated.files(("c",)).items():
            (folder / file).write_text(text, encoding="ascii")
        arrays = [*interface.inputs, *interface.outputs]
        lines = [f"static {scalar} {array}[{size}];" for array, size in arrays]
        filled = [
            f"for (int i = 0; i < {size}; ++i) {array}[i] = ({scalar})(0.1*i - 0.3);"
            for array, size in interface.inputs
        ]
        call = f"{interface.symbol}({', '.join(array for array, _ in arrays)});"
        (folder / "main.c").write_text(
            f'#include "{generated.unit.robot.name}.h"\n#include <stdlib.h>\n' + "\n".join(lines) + "\n"
            "int main(int argc, char **argv)\n{\n    long n = argc > 1 ? atol(argv[1]) : 1;\n    "
            + "\n    ".join(filled)
            + f"\n    for (long k = 0; k < n; ++k) {call}\n    return 0;\n}}\n",
            encoding="ascii",
        )
        flags = ["-std=c99", "-O2", *([f"-march={march}"] if march else [])]
        sources = ["main.c", f"{generated.unit.robot.name}.c"]
        subprocess.run([cc, *flags, *sources, "-o", "main", "-lm"], cwd=folder, check=True)
        inside = [f"--toggle-collect={interface.symbol}"]
        call_only, whole = (
            (_collected(folder, _LONG, more) - _collected(folder, _SHORT, more)) / (_LONG - _SHORT)
            for more in (inside, [])
        )
    return Instructions(robot, trig, scalar, march, round(call_only), round(whole))


def _collected(folder: Path, turns: int, options: list[str]) -> int:
    valgrind = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"]
    command = [*valgrind, *options, "./main", str(turns)]
    done = subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True)
    collected = re.search(r"Collected\s*:\s*(\d+)", done.stderr)
    if collected is None:
        raise RuntimeError(f"valgrind said nothing of what it collected:\n{done.stderr}")
    return int(collected[1])


def main() -> int:
    """Measure what the command line asks for, and print a table."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("robots", nargs="*", default=["puma560"])
    parser.add_argument("--function", default="inverse_dynamics")
    parser.add_argument("--trig", nargs="+", default=["libm", "builtin", "given"])
    parser.add_argument("--scalar", nargs="+", default=["double", "float"])
    parser.add_argument("--march", nargs="+", default=["x86-64-v3"])
    parser.add_argument("--cc", default="gcc")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    for tool in ("valgrind", options.cc):
        if shutil.which(tool) is None:
            print(f"there is no {tool}; Debian, Ubuntu: apt install {tool}", file=sys.stderr)
            return 3
    print(f"{'robot':20} {'trig':8} {'scalar':7} {'march':12} {'call':>6} {'loop':>6}")
    status = 0
    for robot in options.robots:
        for march in options.march:
            for trig in options.trig:
                for scalar in options.scalar:
                    counts = measure(robot, trig, scalar, march, options.function, options.cc)
                    print(f"{robot:20} {trig:8} {scalar:7} {march:12} {counts.call:6} {counts.loop:6}")
                    limited = options.check and robot == "puma560" and options.function == "inverse_dynamics"
                    if limited and march == "x86-64-v3" and counts.call > CEILINGS.get(trig, counts.call):
                        print(f"more than the {CEILINGS[trig]} allowed", file=sys.stderr)
                        status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
