"""Tables of blind trials: how often names are right, how well intervals hold, how near contacts are."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

from benchmarks.gap.blind.grade import WIDE

Row = Mapping[str, Any]
#: Ends of the steps of a confidence that is said.
STEPS = (0.0, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.98, 1.0)


def summary(rows: Sequence[Row]) -> str:
    """Text for people: names by kind, what was wrong, how right names are that are said to be so sure,
    coverage by kind and of all, contacts, widths of backlash."""
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    by_kind = [intervals([row for row in rows if row["kind"] == kind], f"{kind}: ") for kind in kinds]
    parts = [names(rows), wrongs(rows), reliability_text(reliability(rows))]
    parts += [*(by_kind if len(kinds) > 1 else []), intervals(rows), contacts(rows)]
    return "\n\n".join(part for part in parts if part)


def names(rows: Sequence[Row]) -> str:
    """By kind: how many, and the shares of each status; median CPU time."""
    kinds: dict[str, list[Row]] = defaultdict(list)
    for row in rows:
        kinds[row["kind"]].append(row)
    lines = []
    for kind, each in kinds.items():
        counts = Counter(row["status"] for row in each)
        shares = ", ".join(
            f"{status} {count} ({100 * count / len(each):.0f} %)" for status, count in counts.most_common()
        )
        times = sorted(row["cpu"] for row in each)
        lines.append(
            f"{kind}: {len(each)}: {shares}; {times[len(times) // 2]:.0f} s (median), {times[-1]:.0f} s"
        )
    return "\n".join(lines)


def wrongs(rows: Sequence[Row]) -> str:
    """Every trial that is neither right nor silent, with what was claimed."""
    lines = []
    for row in rows:
        if row["status"] in ("right", "silent"):
            continue
        claims = [
            f"{effect}@{joint or 'all'} {confidence:.2f}" + (f" or {'/'.join(rivals)}" if rivals else "")
            for effect, joint, confidence, rivals, _ in row.get("findings", ())
        ]
        answer = row.get("error") or f"{row.get('verdict', '')}: {'; '.join(claims) or 'nothing'}"
        if "floor_ratio" in row:
            answer += f"; left in noise floors {row['floor_ratio']}"
        if "truth_ratio" in row:
            answer += f", the true arm {row['truth_ratio']}"
        if "masses" in row:
            answer += f"; masses off by {row['masses']}"
        lines.append(f"{row['status']:7s} {row['key']}: {answer}")
    return "\n".join(sorted(lines))


def reliability(rows: Sequence[Row]) -> list[list[float]]:
    """Of each step of confidence that findings have: its ends, how many, the mean of what was said, how many
    are right (effect and joint). Trials of what no catalogue has are left out: no name is right there."""
    findings = [
        (confidence, right)
        for row in rows
        if row["kind"] != "outside"
        for _, _, confidence, _, right in row.get("findings", ())
    ]
    steps: list[list[float]] = []
    for low, high in pairwise(STEPS):
        within = [f for f in findings if low <= f[0] < high or f[0] == high == STEPS[-1]]
        if within:
            said, right = (float(sum(part)) for part in zip(*within, strict=True))
            steps.append([low, high, len(within), said / len(within), int(right)])
    return steps


def reliability_text(steps: Sequence[Sequence[float]]) -> str:
    """The same for people."""
    lines = [
        f"  {low:.2f} to {high:.2f}: {count:.0f}, said {100 * said:.1f} %, right {100 * right / count:.1f} %"
        for low, high, count, said, right in steps
    ]
    return "\n".join(["confidence of findings, and how many are right", *lines]) if steps else ""


def coverage(rows: Sequence[Row]) -> dict[str, list[float]]:
    """By parameter: standard errors that values are off (inf: an error of 0 beside a wrong value)."""
    off: dict[str, list[float]] = defaultdict(list)
    for row in rows:
        for name, value, error, true, *bounds in row.get("values", ()):
            beyond = abs(value - true)
            if error is not None and bounds in ([], [None, None]):
                off[name].append(beyond / error if error else math.inf if beyond else 0.0)
            elif bounds not in ([], [None, None]):  # an open side holds whatever is there
                end = bounds[true > value]
                half = math.inf if end is None else abs(end - value)
                off[name].append(WIDE * beyond / half if half else math.inf if beyond else 0.0)
    return off


def intervals(rows: Sequence[Row], heading: str = "") -> str:
    """By parameter: how many, share within their 95 % interval, median and worst distance."""
    off = coverage(rows)
    if not off:
        return ""
    lines = [f"{heading}intervals: estimates, within 95 %, median and worst in standard errors"]
    for name, each in sorted(off.items()):
        each = sorted(each)
        lines.append(f"  {name}: {len(each)}, {_share(each)}, {each[len(each) // 2]:.1f}, {each[-1]:.1f}")
    every = [z for each in off.values() for z in each]
    return "\n".join([*lines, f"  all: {len(every)}, {_share(every)}"])


def _share(off: Sequence[float]) -> str:
    return f"{100 * sum(z <= WIDE for z in off) / len(off):.0f} %"


def contacts(rows: Sequence[Row]) -> str:
    """How far off windows and forces of contacts are, and relative errors of the width of play."""
    lines = []
    every = [c for row in rows for c in row.get("contacts", ()) if "angle" in c]
    if every:
        near = sum(c["angle"] <= 20 for c in every)
        turned = sum(c["angle"] > 90 for c in every)
        late = sorted(max(abs(c["start"]), abs(c["end"])) for c in every)
        lines.append(
            f"contacts: {len(every)}, {near} within 20 degrees, {turned} with the wrong sign, "
            f"windows off by {late[len(late) // 2]:.3f} s (median), {late[-1]:.3f} s"
        )
    widths = [
        abs(value / true - 1)
        for row in rows
        for name, value, _, true, *_ in row.get("values", ())
        if name == "backlash.gap"
    ]
    if widths:
        lines.append(f"width of play: {sum(w <= 0.2 for w in widths)} of {len(widths)} within 20 %")
    return "\n".join(lines)
