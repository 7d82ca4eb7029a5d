"""Runs every tool on every real log and writes results/gap.json, gap.md and gap.svg.

    python -m benchmarks.gap [ARM...] [--tools a,b] [--out DIR] [--render]

The same samples are fitted and the same are held out for all (:mod:`benchmarks.gap.recordings`). With arms or
tools only their rows are measured again. ``--render`` measures nothing. What others need is in
``benchmarks/gap/requirements.txt``; where it is missing, the row says so.
"""

from __future__ import annotations

import argparse
import json
import platform
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from benchmarks.gap.recordings import Motion, rms, shares
from benchmarks.gap.robots import ARMS, RealArm
from benchmarks.gap.tables import markdown, picture
from benchmarks.gap.tools import TOOLS, Tool

RESULTS = Path(__file__).parents[1] / "results"


def row(tool: Tool, arm: RealArm, motions: Sequence[Motion]) -> dict[str, Any]:
    """What a tool leaves of the logs of an arm; or why it is not there."""
    head = {"tool": tool.key, "title": tool.title, "ours": tool.ours}
    try:
        with tempfile.TemporaryDirectory() as folder:
            answer = tool.run(arm, motions, Path(folder))
    except (ImportError, AttributeError, RuntimeError) as error:
        return {**head, "missing": f"{type(error).__name__}: {error}"}
    parts: dict[str, Any] = {}
    for which in ("fitted", "held_out"):
        masks = [getattr(m, which) for m in motions]
        left = [r[mask] for r, mask in zip(answer.residuals, masks, strict=True)]
        torques = [m.tau[mask] for m, mask in zip(motions, masks, strict=True)]
        parts[which] = {"percent": _rounded(shares(left, torques)), "rms": _rounded(rms(left))}
    memory = None if answer.memory is None else round(answer.memory)
    return {**head, **parts, "cpu": round(answer.cpu, 1), "memory": memory, **answer.notes}


def _rounded(values: Any) -> list[float]:
    return [float(f"{x:.4g}") for x in values]


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line."""
    assert __doc__
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("arms", nargs="*", choices=[[], *ARMS], metavar="ARM", help=", ".join(ARMS))
    parser.add_argument("--tools", default=",".join(tool.key for tool in TOOLS))
    parser.add_argument("--out", type=Path, default=RESULTS)
    parser.add_argument("--render", action="store_true")
    options = parser.parse_args(arguments)
    file = options.out / "gap.json"
    results: dict[str, Any] = {"arms": {}}
    if file.is_file():
        results = json.loads(file.read_text(encoding="utf-8"))
    if not options.render:
        results["machine"] = {"processor": processor(), "python": platform.python_version()}
        for name in options.arms or ARMS:
            measure(results, name, options.tools.split(","))
    options.out.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(results, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    (options.out / "gap.md").write_text(markdown(results), encoding="utf-8")
    picture(results, options.out / "gap.svg")
    return 0


def measure(results: dict[str, Any], name: str, keys: Sequence[str]) -> None:
    """Writes the rows of an arm into ``results``, in the order of the tools; others stay."""
    arm = ARMS[name]
    motions = arm.motions()
    known = {one["tool"]: one for one in results["arms"].get(name, {}).get("rows", ())}
    for tool in TOOLS:
        if tool.key in keys:
            known[tool.key] = row(tool, arm, motions)
            print(name, tool.key, known[tool.key].get("held_out"), file=sys.stderr, flush=True)
    rows = [known[tool.key] for tool in TOOLS if tool.key in known]
    seconds = sum(float(m.t[-1] - m.t[0]) for m in motions)
    results["arms"][name] = {
        "cutoff": arm.cutoff,
        "logs": len(motions),
        "seconds": round(seconds, 1),
        "rows": rows,
    }


def processor() -> str:
    """The processor's name."""
    info = Path("/proc/cpuinfo")
    names = [line.partition(":")[2].strip() for line in info.read_text().splitlines() if "model name" in line]
    return names[0] if names else platform.processor()


if __name__ == "__main__":
    sys.exit(main())
