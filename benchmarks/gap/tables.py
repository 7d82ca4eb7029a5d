"""Tables and a picture of real logs, made from the results and nothing else."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from robodyn.draw.panels import Bars, Panel, figure
from robodyn.draw.style import GREEN, GREY, OURS, PURPLE, SKY

Results = Mapping[str, Any]
#: Colour of a tool, and whether it is pale.
_LOOKS = {
    "before": (GREY, True), "least_squares": (GREY, False), "mujoco_sysid": (GREEN, False),
    "sparse": (PURPLE, False), "identify": (SKY, False), "diagnose": (OURS, False),
}  # fmt: skip


def markdown(results: Results) -> str:
    """The results as Markdown."""
    machine = results.get("machine", {})
    parts = [
        "# What is left of real logs",
        f"{machine.get('processor', '')}, Python {machine.get('python', '')}. Written by "
        "`python -m benchmarks.gap`; made from `gap.json`.",
        "100 RMS residual / RMS torque of each joint on samples that nobody fitted: the last 30 % of each of "
        "ten blocks of a log. Positions through a zero-phase low-pass, torque raw.",
        "![Held-out residuals](gap.svg)",
        table(results),
    ]
    missing = [
        f"- {one['title']}, `{name}`: {one['missing']}"
        for name, arm in results["arms"].items()
        for one in arm["rows"]
        if "missing" in one
    ]
    if missing:
        parts += ["## Not measured", "\n".join(missing)]
    return "\n\n".join(parts) + "\n"


def table(results: Results) -> str:
    """Held-out shares, joint by joint, a row for each arm and tool; CPU time, memory and kinds of names."""
    joints = _most_joints(results)
    head = ["arm", "by", *(str(j + 1) for j in range(joints)), "CPU, s", "MB", "names (kinds)"]
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for name, arm in results["arms"].items():
        for one in arm["rows"]:
            shares = _shares(one)
            if not shares:
                continue
            cells = [f"{share:.1f}" for share in shares] + [""] * (joints - len(shares))
            title = f"**{one['title']}**" if one["ours"] else one["title"]
            memory = "" if one.get("memory") is None else str(one["memory"])
            names = f"{len(one['claims'])} ({one['kinds']})" if "claims" in one else ""
            lines.append(
                "| " + " | ".join([f"`{name}`", title, *cells, f"{one['cpu']:.0f}", memory, names]) + " |"
            )
    return "\n".join(lines)


def known_table(results: Results) -> str:
    """A row for each fact that is known of logs: what it is, what was said, whether that agrees."""
    lines = ["| logs | known | said | |", "|---|---|---|---|"]
    for name, one in results.items():
        for words, text, agrees in one["facts"]:
            lines.append(f"| {name} | {words} | {text} | {'yes' if agrees else '**no**'} |")
    return "\n".join(lines)


def _most_joints(results: Results) -> int:
    return max(len(_shares(one)) for arm in results["arms"].values() for one in arm["rows"])


def _shares(row: Mapping[str, Any]) -> list[float]:
    return row["held_out"]["percent"] if "held_out" in row else []


def picture(results: Results, path: Path) -> None:
    """Bars of held-out shares of each joint, a panel for each arm."""
    joints = _most_joints(results)
    panels = [
        Panel(
            name,
            "joint",
            "residual / torque, RMS [%]",
            bars=tuple(
                Bars(one["title"].replace("`", ""), _shares(one), *_LOOKS.get(one["tool"], (GREY, False)))
                for one in rows
            ),
            categories=tuple(str(j + 1) for j in range(len(_shares(rows[0])))),
        )
        for name, arm in results["arms"].items()
        for rows in [[one for one in arm["rows"] if _shares(one)]]
    ]
    drawn = figure(
        "What is left of real logs", "Samples that nobody fitted; shorter is better", panels, columns=1,
        width=90 * joints,
    )  # fmt: skip
    path.write_text(drawn, encoding="utf-8")
