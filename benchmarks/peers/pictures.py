"""peers.svg and growth.svg, made from peers.json."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from benchmarks.peers.dots import Dot, dots

from robodyn.draw.panels import Curve, Panel, figure
from robodyn.draw.style import GREY, OURS, SKY

_GROWN = {
    "robodyn-builtin": ("robodyn, built-in sine and cosine", OURS),
    "robodyn-libm": ("robodyn, libm", SKY),
    "pinocchio": ("Pinocchio, rnea", GREY),
}
#: Variants of a row that are in the table only.
_LEFT_OUT = ("-v3", "-default", "-scheduled", "-portable", "-checked")


def peers_picture(results: Mapping[str, Any], path: Path) -> None:
    """The ratios, the fastest on top."""
    rows = [row for row in results["native"]["rows"] if not row["key"].endswith(_LEFT_OUT)]
    picture = dots(
        "Time of the inverse dynamics beside its peers",
        "PUMA 560, one core; robodyn in blue; left is faster",
        "time a state / one call with built-in sine and cosine, logarithmic",
        [
            Dot(row["title"], row["ratio"][0], row["ours"])
            for row in sorted(rows, key=lambda row: float(row["ratio"][0]))
        ],
    )
    path.write_text(picture, encoding="utf-8")


def growth_picture(rows: Sequence[Mapping[str, Any]], path: Path) -> None:
    """Time of a call, instructions and time of generation over the number of joints."""
    joints = [row["joints"] for row in rows]

    def grown(what: str) -> tuple[Curve, ...]:
        return tuple(
            Curve(title, joints, [row[what][key] for row in rows], colour=colour)
            for key, (title, colour) in _GROWN.items()
            if rows[0][what].get(key) is not None
        )

    seconds = [row["generation_s"]["process"] for row in rows]
    panels = (
        Panel("A call", "joints", "time [ns]", grown("ns")),
        Panel("A call", "joints", "instructions", grown("instructions")),
        Panel(
            "robodyn gen, the whole process",
            "joints",
            "CPU time [s]",
            (
                Curve("measured", joints, seconds, colour=OURS),
                Curve("limit", [joints[0], joints[-1]], [1.0, 1.0], dashed=True, colour=GREY),
            ),
            from_zero=True,
        ),
    )
    note = "Inverse dynamics of arms of that many joints, one core"
    path.write_text(figure("Growth with the number of joints", note, panels), encoding="utf-8")
