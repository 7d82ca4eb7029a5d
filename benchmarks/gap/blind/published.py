"""The figures of blind trials for the documents: counts and shares from the rows, tables from the counts."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from benchmarks.gap.blind.grade import WIDE
from benchmarks.gap.blind.summary import coverage, reliability

#: What a kind hides. Of ``weak`` there are figures of earlier trials only.
TITLES = {
    "clear": "one effect, 3 to 8 times the noise",
    "weak": "one effect, 1.5 to 3 times the noise",
    "near": "one of laws that are alike, 1.5 to 4 times the noise, some with damping at the same joint",
    "exact": "one effect, 3 to 8 times the noise; the description exact, and said to be",
    "uncertain": "one effect, 8 to 20 times the noise; inertial numbers 10 % off, and said to be",
    "after": "one effect of 3 times the noise, the arm identified before from a description 30 % off",
    "backlash": "backlash, 3 to 8 times the noise",
    "journal": "friction in a journal bearing, 3 to 8 times the noise",
    "contact": "a push, during a motion or at rest",
    "null": "nothing; inertial numbers right, or 5 to 30 % off, said or not",
    "outside": "an effect of no catalogue, 4 to 8 times the noise",
    "poor": "one effect, 3 to 8 times the noise, of a motion in one direction or a small range",
}
#: What the numbers of a link are called.
_GROUPS = {"com": "centres of mass", "mass": "masses of links", "inertia": "inertias of links"}
#: Arms of which the last joints feel a push at the last link: in a spherical wrist's centre they do not, and
#: which link was pushed, and with it the direction, cannot be known.
WRISTS = ("ur5", "ur10", "panda")
#: What is right where nothing of the catalogue is hidden: no name.
_QUIET = {"null": "silent", "outside": "missed"}


def published(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """The figures, from the rows of :mod:`benchmarks.gap.blind`."""
    counts: dict[str, Counter[str]] = {}
    for row in rows:
        counts.setdefault(row["kind"], Counter())[row["status"]] += 1
    off = coverage(rows)
    identified = [row for row in rows if row["kind"] == "identify" and "truth_ratio" in row]
    pushes = [c for row in rows if row["arm"] in WRISTS for c in row.get("contacts", ()) if "angle" in c]
    widths = [
        abs(value / true - 1)
        for row in rows
        for name, value, _, true, *_ in row.get("values", ())
        if name == "backlash.gap"
    ]
    masses = [row["masses"]["together"] for row in rows if "masses" in row]
    return {
        "names": {kind: dict(counts[kind]) for kind in TITLES if kind in counts},
        "intervals": {name: [len(each), sum(z <= WIDE for z in each)] for name, each in sorted(off.items())},
        "reliability": reliability(rows),
        "identified": {
            "arms": len(identified),
            "worst beside the true arm": max(
                (
                    a / b
                    for row in identified
                    for a, b in zip(row["floor_ratio"], row["truth_ratio"], strict=True)
                ),
                default=None,
            ),
        },
        "pushes": [len(pushes), sum(c["angle"] <= 20 for c in pushes), sum(c["angle"] > 90 for c in pushes)],
        "widths": [len(widths), sum(w <= 0.2 for w in widths)],
        "payloads": [len(masses), sum(abs(m) <= 0.1 for m in masses)],
    }


def renewed(before: Mapping[str, Any], figures: Mapping[str, Any]) -> dict[str, Any]:
    """Figures with those ``before`` where no row says anything: of kinds that did not run again, of numbers
    that nothing has estimated again."""
    both = {key: {**before.get(key, {}), **figures[key]} for key in ("names", "intervals")}
    both["names"] = {kind: both["names"][kind] for kind in TITLES if kind in both["names"]}
    both["intervals"] = dict(sorted(both["intervals"].items()))
    identified = figures["identified"] if figures["identified"]["arms"] else before.get("identified")
    counts = {
        key: figures[key] if figures[key][0] else before.get(key) for key in ("pushes", "widths", "payloads")
    }
    steps = figures["reliability"] or before.get("reliability", [])
    return {**both, "reliability": steps, "identified": identified, **counts}


def names_table(figures: Mapping[str, Any]) -> str:
    """How often names are right."""
    lines = [
        "| hidden | cases | right | in the declared set | nothing claimed | more than that | wrong |",
        "|" + "---|" * 7,
    ]
    for kind, counts in figures["names"].items():
        right = counts.get(_QUIET.get(kind, "right"), 0)
        quiet = 0 if kind in _QUIET else counts.get("missed", 0)
        cells = [
            sum(counts.values()), right, counts.get("set", 0), quiet, counts.get("extra", 0),
            counts.get("wrong", 0) + counts.get("error", 0),
        ]  # fmt: skip
        lines.append(f"| {TITLES[kind]} | " + " | ".join(map(str, cells)) + " |")
    return "\n".join(lines)


def intervals_table(figures: Mapping[str, Any]) -> str:
    """How many 95 % intervals hold the true value, by the effect or the link's numbers that they are of."""
    groups: dict[str, list[int]] = {}
    for name, (count, within) in figures["intervals"].items():
        whose = name.partition(".")[0] if "." in name else name.partition("_")[0]
        group = groups.setdefault(_GROUPS.get(whose, whose.replace("_", " ")), [0, 0])
        group[0] += count
        group[1] += within
    groups["all"] = [sum(each[k] for each in groups.values()) for k in (0, 1)]
    lines = ["| of | estimates | the interval holds the truth |", "|---|---|---|"]
    lines += [
        f"| {name} | {count} | {100 * within / count:.0f} % |" for name, (count, within) in groups.items()
    ]
    return "\n".join(lines)
