"""peers.svg and growth.svg, made from peers.json."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt

_OURS, _THEIRS = "#1f6f8b", "#b0b0b0"
_PLAIN: Any = {"svg.hashsalt": "robodyn", "svg.fonttype": "none", "font.size": 9}


def peers_picture(found: Mapping[str, Any], path: Path) -> None:
    """Bars of the ratios, logarithmic, the fastest on top."""
    rows = [
        row
        for row in found["native"]["rows"]
        if not row["key"].endswith(("-v3", "-default", "-scheduled", "-portable", "-checked"))
    ]
    rows = sorted(rows, key=lambda row: -row["ratio"][0])
    with plt.rc_context(_PLAIN):
        figure, axes = plt.subplots(figsize=(9, 0.3 * len(rows) + 1.2), layout="constrained")
        colours = [_OURS if row["ours"] else _THEIRS for row in rows]
        ratios = [row["ratio"][0] for row in rows]
        axes.barh([row["title"] for row in rows], ratios, color=colours, left=0)
        for k, ratio in enumerate(ratios):
            axes.text(ratio * 1.05, k, f"{ratio:.2g}", va="center")
        axes.set_xscale("log")
        axes.set_xlim(min(ratios) / 2, max(ratios) * 2)
        axes.set_xlabel("time a state / one call with built-in sine and cosine, one core")
        axes.spines[["top", "right"]].set_visible(False)
        _write(figure, path)


def growth_picture(rows: Sequence[Mapping[str, Any]], path: Path) -> None:
    """Time of a call, instructions and time of generation over the number of joints."""
    joints = [row["joints"] for row in rows]
    styles = {
        "robodyn-builtin": ("robodyn, built-in sine and cosine", _OURS, "o"),
        "robodyn-libm": ("robodyn, libm", "#7fb3c4", "s"),
        "pinocchio": ("Pinocchio, rnea", "#808080", "^"),
    }
    with plt.rc_context(_PLAIN):
        figure, (time, count, generation) = plt.subplots(1, 3, figsize=(12, 3.6), layout="constrained")
        for key, (title, colour, marker) in styles.items():
            if key in rows[0]["ns"]:
                time.plot(
                    joints, [row["ns"][key] for row in rows], marker, ls="-", ms=3, color=colour, label=title
                )
            if rows[0]["instructions"].get(key) is not None:
                values = [row["instructions"][key] for row in rows]
                count.plot(joints, values, marker, ls="-", ms=3, color=colour, label=title)
        seconds = [row["generation_s"]["process"] for row in rows]
        generation.plot(joints, seconds, "o-", ms=3, color=_OURS, label="robodyn gen, the whole process")
        generation.axhline(1, color="#c0392b", lw=0.8, ls="--")
        for axes, title in (
            (time, "ns a call"),
            (count, "instructions a call"),
            (generation, "generation, CPU s"),
        ):
            axes.set(xlabel="joints", title=title, xlim=(0, None), ylim=(0, None))
            axes.spines[["top", "right"]].set_visible(False)
        time.legend(frameon=False)
        _write(figure, path)


def _write(figure: Any, path: Path) -> None:
    figure.savefig(path, format="svg", metadata={"Date": None, "Creator": None})
    plt.close(figure)
    lines = path.read_text(encoding="utf-8").splitlines()
    path.write_text("\n".join(line.rstrip() for line in lines) + "\n", encoding="utf-8")
