"""Batches from 64 to 1,000,000 states: ``python -m benchmarks.batch``, into results/ and docs/batch.md.

Nanoseconds a state of each function in the three layouts; beside them what the bytes alone take, and what the
products alone would if they came as fast as this processor multiplies vectors: all in one process, the
fastest of twelve rounds. For x86-64, with gcc.
"""

from __future__ import annotations

import json
import re
import subprocess
import tempfile
from pathlib import Path
from typing import Any, Final

from benchmarks.marked import with_part

from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import load
from robodyn.toolchain.compiler import C_FLAGS, find_c

ROOT: Final = Path(__file__).parents[2]
RESULTS: Final = ROOT / "benchmarks" / "results" / "batch.json"
PAGE: Final = ROOT / "docs" / "batch.md"
ARMS: Final = ("puma560", "panda")
FUNCTIONS: Final = (
    "inverse_dynamics", "mass_matrix", "forward_dynamics", "inverse_dynamics_derivatives",
    "forward_dynamics_derivatives", "forward_kinematics", "jacobian",
)  # fmt: skip
COUNTS: Final = ("64", "512", "4096", "131072", "1000000")
#: Where batches lie in the caches, and where they do not.
SMALL, LARGE = "512", "131072"
_PRODUCT: Final = re.compile(r"(?<=[\w)])\*(?=[\w(])")

Row = dict[str, Any]


def products(generated: Generated, lanes: str) -> dict[str, int]:
    """Of each function the products of a state, those of sines and cosines included, from the C text."""
    bodies = re.split(r"^LANES_TARGET ", lanes, flags=re.MULTILINE)
    sines = next(len(_PRODUCT.findall(body)) for body in bodies if "LANES_NAME(sincos)(" in body)
    counts = {}
    for signature in generated.signatures:
        head = f"static void LANES_NAME({signature.called})("
        (body,) = (body for body in bodies if body.startswith(head))
        loop = body.partition("LANES) {")[2]
        counts[signature.function] = len(_PRODUCT.findall(loop)) + sines * loop.count("LANES_SINCOS(")
    return counts


def _arm(arm: str, folder: Path) -> tuple[list[str], list[Row]]:
    """The C of an arm in ``folder``; lines of functions.h, and what is known of its functions."""
    generated = generate(load(arm, warn=lambda _: None), Options(FUNCTIONS, trig="builtin"))
    files = generated.files(("c",), batch=True)
    for file, text in files.items():
        (folder / file).write_text(text, encoding="ascii")
    counted = products(generated, files[f"{arm}_lanes.h"])
    lines, rows = (
        [f'#include "{arm}_batch.h"', "#undef BLOCK", f"#define BLOCK {arm.upper()}_BATCH_BLOCK"],
        [],
    )
    for s in generated.signatures:
        arrays = len(s.inputs) + len(s.outputs)
        passed = "".join(f", a[{k}]" for k in range(arrays))
        lines.append(f"static void {s.symbol}_(size_t n, size_t block, double **a)")
        lines.append(f"{{ {s.symbol}_batch(n, block{passed}); }}")
        sizes = {"read": sum(n for _, n in s.inputs), "written": sum(n for _, n in s.outputs)}
        most = max(n for _, n in (*s.inputs, *s.outputs))
        rows.append(
            {"arm": arm, "function": s.function, **sizes, "most": most, "products": counted[s.function]}
        )
    return lines, rows


def measured() -> Row:
    """Compile, run, and read what was printed."""
    compiler = find_c()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        lines, rows = [], list[Row]()
        for arm in ARMS:
            own, known = _arm(arm, folder)
            lines += own
            rows += known
        table = ", ".join(
            f'{{"{r["arm"]}", "{r["function"]}", {r["arm"]}_{r["function"]}_, {r["read"]}, {r["written"]}}}'
            for r in rows
        )
        lines += [
            f"enum {{ MOST = {max(r['most'] for r in rows)}, SUM = {max(r['written'] for r in rows)} }};",
            "struct Function { const char *arm, *name; void (*call)(size_t, size_t, double **); "
            "size_t read, written; };",
            f"static const struct Function functions[] = {{{table}}};",
        ]
        (folder / "functions.h").write_text("\n".join(lines) + "\n", encoding="ascii")
        (folder / "measure.c").write_bytes((Path(__file__).parent / "measure.c").read_bytes())
        sources = ["measure.c", *(f"{arm}_batch.c" for arm in ARMS)]
        compiler.run([*C_FLAGS, *sources, "-lm", "-o", "measure"], folder=folder, doing="what is measured")
        printed = subprocess.run(["./measure"], cwd=folder, capture_output=True, text=True, check=True).stdout
    product, *rest = printed.splitlines()
    for line in rest:
        arm, function, what, *numbers = line.split()
        row = next(r for r in rows if (r["arm"], r["function"]) == (arm, function))
        if what == "alone":
            row["alone"] = float(numbers[0])
        else:
            row.setdefault(what, {})[numbers[0]] = float(numbers[1])
    model = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text(encoding="utf-8"))
    return {
        "processor": model[1] if model else "unknown",
        "product": float(product.split()[1]),
        "functions": rows,
    }


def _ratio(row: Row, layout: str) -> float:
    return float(row[layout][LARGE] / row[layout][SMALL])


def tables(results: Row) -> tuple[str, str]:
    """What the page shows, and all times."""
    heads = ("N = 512", "of the bound", "N = 131,072", "ratio", "bytes alone", "rows", "columns")
    summary = [f"| arm | function | {' | '.join(heads)} |", "|---|---|" + "---:|" * len(heads)]
    counts = " | ".join(f"{int(count):,}" for count in COUNTS)
    every = [f"| arm | function | layout | {counts} |", "|---|---|---|" + "---:|" * len(COUNTS)]
    for row in results["functions"]:
        blocks, name = row["blocks"], f"| `{row['arm']}` | `{row['function']}` |"
        share = row["products"] * results["product"] / blocks[SMALL]
        ratios = " | ".join(f"{_ratio(row, layout):.2f}" for layout in ("rows", "columns"))
        summary.append(
            f"{name} {blocks[SMALL]:.3g} | {100 * share:.0f} % | {blocks[LARGE]:.3g} "
            f"| {_ratio(row, 'blocks'):.2f} | {row['alone']:.3g} | {ratios} |"
        )
        every += [
            f"{name} {layout} | {' | '.join(f'{row[layout][count]:.3g}' for count in COUNTS)} |"
            for layout in ("blocks", "rows", "columns")
        ]
    return "\n".join(summary), "\n".join(every)


def markdown(results: Row) -> str:
    """The page of all times."""
    summary, every = tables(results)
    return (
        f"# Batches\n\nNanoseconds a state, one thread, double, on {results['processor']}; a product of "
        f"vectors takes {results['product']:.3g} ns a state. What the columns are: docs/batch.md.\n\n"
        f"{summary}\n\nBy number of states:\n\n{every}\n"
    )


def main() -> int:
    """Measure, and write the results and the page."""
    results = measured()
    RESULTS.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    RESULTS.with_suffix(".md").write_text(markdown(results), encoding="utf-8")
    text = with_part(PAGE.read_text(encoding="utf-8"), "batch speed", tables(results)[0])
    PAGE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
