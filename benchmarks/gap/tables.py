"""Tables and a picture of real logs, made from the results and nothing else."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

_OURS, _THEIRS = "#1f6f8b", "#b0b0b0"
_PLAIN: Any = {"svg.hashsalt": "robodyn", "svg.fonttype": "none", "font.size": 9}
Results = Mapping[str, Any]


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


def _legend(axes: Any) -> tuple[list[str], list[Any]]:
    handles, labels = axes.get_legend_handles_labels()
    return labels, handles


def _shares(row: Mapping[str, Any]) -> list[float]:
    return row["held_out"]["percent"] if "held_out" in row else []


def picture(results: Results, path: Path) -> None:
    """Bars of held-out shares of each joint, a panel for each arm."""
    import matplotlib

    matplotlib.use("svg")
    import matplotlib.pyplot as plt

    greys = {"before": "#e4e4e4", "least_squares": "#9a9a9a", "mujoco_sysid": "#c9b48a", "sparse": "#c98a8a"}
    ours = {"identify": "#7fb3c4", "diagnose": _OURS}
    joints = _most_joints(results)
    with plt.rc_context(_PLAIN):
        figure, panels = plt.subplots(
            len(results["arms"]),
            1,
            figsize=(9, 1.7 * len(results["arms"]) + 0.6),
            layout="constrained",
            squeeze=False,
        )
        for axes, (name, arm) in zip(panels[:, 0], results["arms"].items(), strict=True):
            rows = [one for one in arm["rows"] if _shares(one)]
            width = 0.8 / len(rows)
            for k, one in enumerate(rows):
                places = [j + 1 + (k - (len(rows) - 1) / 2) * width for j in range(len(_shares(one)))]
                colour = (greys | ours).get(one["tool"], _THEIRS)
                axes.bar(places, _shares(one), width, color=colour, label=one["title"].replace("`", ""))
            axes.set(
                xlim=(0.4, joints + 0.6),
                ylim=(0, 100),
                xticks=range(1, len(_shares(rows[0])) + 1),
                ylabel=f"{name}\n% of torque",
            )
            axes.spines[["top", "right"]].set_visible(False)
        panels[-1, 0].set_xlabel("joint")
        shown = dict(pair for axes in panels[:, 0] for pair in zip(*_legend(axes), strict=True))
        panels[0, 0].legend(
            shown.values(), shown.keys(), frameon=False, ncols=3, loc="lower center", bbox_to_anchor=(0.5, 1)
        )
        figure.savefig(path, format="svg", metadata={"Date": None, "Creator": None})
        plt.close(figure)
    lines = path.read_text(encoding="utf-8").splitlines()
    path.write_text("\n".join(line.rstrip() for line in lines) + "\n", encoding="utf-8")
