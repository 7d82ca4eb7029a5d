"""Registers and spilled bytes of all kernels in CUDA: ``python -m benchmarks.cuda``, into results/cuda.md.

``--program FOLDER`` writes and compiles, in place of that, a program that checks and times them on a GPU and
needs nothing there but the driver: ``FOLDER/run.sh FIGURES.json``. ``--figures FIGURES.json`` puts what it
found into the results.
"""

from __future__ import annotations

import argparse
import itertools
import json
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any, Final

from benchmarks.cuda.program import ARMS, SCALARS, build, kernels
from benchmarks.marked import with_part

from robodyn.doctor import examine
from robodyn.emit.languages.cuda import NVCC

ROOT: Final = Path(__file__).parents[2]
RESULTS: Final = ROOT / "benchmarks" / "results" / "cuda.json"
PAGE: Final = ROOT / "docs" / "cuda.md"
ARCHITECTURES: Final = ("sm_80", "sm_90")
#: What the page shows of all functions.
SHOWN: Final = (
    "inverse_dynamics", "mass_matrix", "forward_dynamics", "inverse_dynamics_derivatives",
    "forward_dynamics_derivatives", "forward_kinematics", "jacobian", "inverse_kinematics",
)  # fmt: skip
_ENTRY: Final = re.compile(
    r"entry function '(\w+)_blocks' for '(\w+)'.*?(\d+) bytes spill stores, (\d+) bytes spill loads"
    r".*?Used (\d+) registers",
    re.DOTALL,
)

Row = dict[str, Any]


def compiled(arm: str, scalar: str) -> list[Row]:
    """What ``ptxas`` says of each function of an arm.

    Raises
    ------
    RuntimeError: nvcc fails, or has something to say.
    """
    generated = kernels(arm, scalar)
    name = generated.unit.robot.name
    codes = [f"-gencode=arch=compute_{a[3:]},code={a}" for a in ARCHITECTURES]
    with tempfile.TemporaryDirectory() as folder:
        for file, text in generated.files(("cuda",)).items():
            (Path(folder) / file).write_text(text, encoding="ascii")
        command = [*(NVCC.command() or (NVCC.needed(),)), *codes, "-fatbin", "-Xcompiler", "-Wall,-Wextra"]
        command += ["-Xptxas", "-v", f"{name}.cu"]
        run = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    text = run.stdout + run.stderr
    if run.returncode or "warning" in text:
        raise RuntimeError(text)
    rows: dict[str, Row] = {}
    for symbol, architecture, stores, loads, registers in _ENTRY.findall(text):
        row = rows.setdefault(symbol, {})
        row[architecture] = {"registers": int(registers), "spilled": int(stores) + int(loads)}
    return [
        {"arm": arm, "scalar": scalar, "function": s.function, "called": s.called, **rows[s.symbol]}
        for s in generated.signatures
    ]


def _measured(results: Row) -> dict[tuple[str, str, str], tuple[float, float]]:
    """Of each function nanoseconds a state in the largest batch, and the share of a copy's bandwidth."""
    figures = results.get("measured") or {"functions": []}
    times = {}
    for each in figures["functions"]:
        if each["times"]:
            count, seconds = each["times"][-1]
            share = 1e-9 * each["bytes"] * count / seconds / figures["copy"]
            times[each["arm"], each["scalar"], each["function"]] = (1e9 * seconds / count, share)
    return times


def table(results: Row, shown: tuple[str, ...] | None = None) -> str:
    """The rows of all functions, or of those that are ``shown``."""
    measured = _measured(results)
    heads = [f"{what}, {a}" for a in ARCHITECTURES for what in ("registers", "spilled")]
    lines = [f"| arm | function | numbers | {' | '.join(heads)} | ns a state | share of a copy |"]
    lines.append("|---|---|---|" + "---:|" * (len(heads) + 2))
    for row in results["compiled"]:
        if shown is None or row["function"] in shown:
            cells = [str(row[a][key]) for a in ARCHITECTURES for key in ("registers", "spilled")]
            time = measured.get((row["arm"], row["scalar"], row["called"]))
            cells += ["", ""] if time is None else [f"{time[0]:.3g}", f"{100 * time[1]:.0f} %"]
            head = f"| `{row['arm']}` | `{row['function']}` | {row['scalar']} |"
            lines.append(f"{head} {' | '.join(cells)} |")
    return "\n".join(lines)


def _device(results: Row) -> str:
    """What was found on a GPU, in words."""
    figures = results.get("measured")
    if not figures:
        return "Compiled, not run: no GPU has measured them."
    checked = figures["functions"]
    wrong = sum(1 for each in checked if each["other_bits"] or each["behind"])
    far = [each["fused_worst"] for each in checked if each["scalar"] == "double"]
    copy, states = f"{figures['copy']:.0f} GB/s", checked[0]["states"]
    return (
        f"Measured on {figures['device']}, a copy in its memory at {copy}. Without fused products "
        f"{len(checked) - wrong} of {len(checked)} functions have the bits of the C at {states} states; "
        f"fused, results in double differ by {max(far):.1g} of the largest at most."
    )


def markdown(results: Row) -> str:
    """The page of all results."""
    spilled = [row for row in results["compiled"] if row["sm_90"]["spilled"]]
    names = [f"`{row['function']}` of `{row['arm']}` in {row['scalar']}" for row in spilled]
    return (
        f"# CUDA\n\n{results['nvcc']}. Registers a thread, of 255 at most, and bytes of spilled registers, "
        f"stored and loaded. Spilled on sm_90: {', '.join(names) or 'nothing'}.\n\n{_device(results)}\n\n"
        f"{table(results)}\n"
    )


def write(results: Row) -> None:
    """The results, and the table of the page."""
    RESULTS.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    RESULTS.with_suffix(".md").write_text(markdown(results), encoding="utf-8")
    page = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(with_part(page, "cuda kernels", table(results, SHOWN)), encoding="utf-8")


def main() -> int:
    """Do what the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument(
        "--program", type=Path, metavar="FOLDER", help="write and compile what measures on a GPU"
    )
    parser.add_argument("--figures", type=Path, metavar="FILE", help="put what that printed into the results")
    parser.add_argument("--processes", type=int, metavar="N", help="how many at a time (default: processors)")
    options = parser.parse_args()
    if options.program:
        build(options.program, options.processes)
        return 0
    results = json.loads(RESULTS.read_text(encoding="utf-8")) if RESULTS.exists() else {}
    if options.figures:
        results["measured"] = json.loads(options.figures.read_text(encoding="utf-8"))
    else:
        results["nvcc"] = f"nvcc {examine([NVCC])[0].version}"
        with ProcessPoolExecutor(options.processes) as pool:
            parts = pool.map(compiled, *zip(*itertools.product(ARMS, SCALARS), strict=True))
            results["compiled"] = list(itertools.chain(*parts))
    write(results)
    return 0


if __name__ == "__main__":
    sys.exit(main())
