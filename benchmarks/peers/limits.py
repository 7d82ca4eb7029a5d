"""What limits our kernels: ``python -m benchmarks.peers.limits``, after ``python -m benchmarks.peers``.

Each kernel that raced is disassembled and given to llvm-mca: its instructions and micro-operations, the
latency of one call (the longest chain of operations that wait for each other), what the execution units
take, and how many cycles a call takes when calls follow each other, as far as the reorder buffer lets them
overlap. Beside it stands what was measured, in cycles. Written to ``benchmarks/results/limits.md``.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from benchmarks.peers.building import Lacking, Source, program
from benchmarks.peers.tables import table

RESULTS = Path(__file__).resolve().parents[1] / "results"
#: The newest model of llvm-mca 14 with AVX-512; calls one after another that it simulates.
MODEL, CALLS = "icelake-server", 100
#: Beginnings and ends of functions; jumps between the parts of a kernel.
_LEFT_OUT = {
    "call", "ret", "push", "pop", "jmp", "endbr64", "leave", "nop", "nopw", "nopl", "xchg", "cs", "data16",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Bound:
    """Of a piece of straight-line code: instructions, micro-operations, the cycles of its longest chain,
    those that the busiest execution unit needs, and those that it takes when it is run again and again."""

    instructions: int
    operations: int
    latency: int
    units: float
    steady: float


def instructions_of(disassembly: str, symbols: Sequence[str]) -> list[str]:
    """The instructions of functions, one after another, without calls.

    Raises
    ------
    Lacking: a function is not in the disassembly.
    """
    lines = []
    for symbol in symbols:
        body = re.search(
            rf"^<{re.escape(symbol)}>:\n(.*?)(?=^\s*$|\Z)", disassembly, flags=re.DOTALL | re.MULTILINE
        )
        if body is None:
            raise Lacking(f"no function {symbol} in the disassembly")
        for line in body[1].splitlines():
            text = re.sub(r"[#<].*", "", line).strip()
            if text and text.split()[0] not in _LEFT_OUT:
                lines.append(text)
    return lines


def bound_of(instructions: Sequence[str]) -> Bound:
    """What llvm-mca says of the instructions."""
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "kernel.s"
        source.write_text("\n".join(instructions) + "\n", encoding="ascii")
        once, often = (
            output_of("llvm-mca", f"-mcpu={MODEL}", f"-iterations={calls}", str(source))
            for calls in (1, CALLS)
        )
    return parsed(once, often)


def parsed(once: str, often: str) -> Bound:
    """The summaries that llvm-mca prints of one call and of :data:`CALLS`."""

    def figure(summary: str, name: str) -> float:
        match = re.search(rf"^{name}:\s+([\d.]+)", summary, flags=re.MULTILINE)
        if match is None:
            raise Lacking(f"llvm-mca says nothing of {name}")
        return float(match[1])

    return Bound(
        instructions=int(figure(once, "Instructions")),
        operations=int(figure(once, "Total uOps")),
        latency=int(figure(once, "Total Cycles")),
        units=figure(once, "Block RThroughput"),
        steady=figure(often, "Total Cycles") / CALLS,
    )


def measured(figures: Mapping[str, Any], work: Path) -> dict[str, Any]:
    """The bounds of every kernel that raced, and the clock."""
    rows = []
    for race in figures["functions"]["races"]:
        name, function = race["robot"], race["function"]
        library = work / name / function / "robodyn-native.so"
        text = output_of("objdump", "-d", "--no-show-raw-insn", "--no-addresses", str(library))
        symbol = f"{name}_{function}"
        parts = {"sines": (symbol,), "rest": (f"{symbol}_given_",), "all": (symbol, f"{symbol}_given_")}
        bounds = {part: bound_of(instructions_of(text, symbols)) for part, symbols in parts.items()}
        (ns,) = (row["ns"] for row in race["rows"] if row["key"] == "robodyn")
        peers = {row["key"]: row["ns"] for row in race["rows"] if not row["ours"]}
        wanted = {demand["peer"]: demand["wanted"] for demand in race["demands"]}
        targets = {peer: peers[peer] / times for peer, times in wanted.items()}
        rows.append(
            {
                "robot": name,
                "function": function,
                "ns": ns,
                "target_ns": min(targets.values(), default=0.0),
                **{part: asdict(bound) for part, bound in bounds.items()},
            }
        )
    return {"ghz": clock(work), "model": MODEL, "rows": rows}


def clock(work: Path) -> float:
    """The fastest of several loops of additions that wait for each other [GHz]: one takes a cycle."""
    ticks = program(work / "clock", Source(("clock.c",)), ("-O1",))
    return max(float(x) for x in output_of(str(ticks)).split())


def markdown(bounds: Mapping[str, Any]) -> str:
    """limits.md."""
    ghz = bounds["ghz"]
    lines = []
    for row in bounds["rows"]:
        whole, sines, rest = (row[part] for part in ("all", "sines", "rest"))
        cycles = [ghz * row[key] for key in ("ns", "target_ns")] + [whole["steady"], whole["units"]]
        chains = [part["latency"] for part in (whole, sines, rest)]
        counts = whole["instructions"], whole["operations"]
        figures = (f"{x:.0f}" for x in (*cycles, *chains, *counts))
        lines.append((row["robot"], row["function"], *figures, verdict(*cycles)))
    head = (
        "robot", "function", "measured", "wanted", "simulated", "units alone", "latency of a call",
        "of its sines", "of the rest", "instructions", "micro-operations", "what limits",
    )  # fmt: skip
    parts = (
        "# What limits the kernels",
        f"Cycles a call, at {ghz:.2f} GHz. Written by `python -m benchmarks.peers.limits`; made from "
        "`limits.json`. *Measured* is the race of `peers.json`, kernels compiled with `-O3 "
        "-march=native`; *wanted* what the strictest of the ratios asked for there comes to. The rest"
        f" is llvm-mca's account of the compiled kernels ({bounds['model']}): *simulated*, {CALLS} "
        "calls one after another, which overlap as far as the reorder buffer reaches; *units alone*, "
        "what the busiest execution unit needs, if nothing ever waited; *latency*, one call from its "
        "first to its last instruction, and its two parts.",
        table(head, lines),
        "*What limits*: where the units alone need more than is wanted, only fewer operations would "
        "get there. Elsewhere it is latency: *measured* is near *simulated* and well above *units "
        "alone*, so the chain of sine, recursion and result is what takes the time. Its operations "
        "wait for each other, and the buffer holds too few calls at once to fill the gaps; operations"
        " that are not on the chain cost little there, and a shorter sine would pay.",
    )
    return "\n\n".join(parts) + "\n"


def verdict(measured: float, wanted: float, simulated: float, units: float) -> str:
    """Why ``measured`` cycles are more than are wanted."""
    if measured <= wanted:
        return "reached"
    return "the units: too many operations" if units > wanted else "latency"


def output_of(*command: str) -> str:
    if shutil.which(command[0]) is None:
        raise Lacking(f"there is no {command[0]}: apt-get install llvm binutils")
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise Lacking(f"{command[0]}: {done.stderr.strip()[:300]}")
    return done.stdout


def main(arguments: Sequence[str] | None = None) -> int:
    """Analyse, write, and return the exit code."""
    about = (__doc__ or "").partition("\n")[0]
    parser = argparse.ArgumentParser(prog="benchmarks.peers.limits", description=about)
    parser.add_argument("--work", default="build/peers", help="where the race has compiled its runners")
    parser.add_argument("--out", default=str(RESULTS), help="where peers.json is, and results go")
    options = parser.parse_args(arguments)
    out = Path(options.out)
    figures = json.loads((out / "peers.json").read_text(encoding="utf-8"))
    bounds = measured(figures, Path(options.work).resolve())
    (out / "limits.json").write_text(json.dumps(bounds, indent=1) + "\n", encoding="utf-8")
    (out / "limits.md").write_text(markdown(bounds), encoding="utf-8")
    print((out / "limits.md").read_text(encoding="utf-8"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
