"""Tables of blind trials: how often names are right, how well intervals hold, how near contacts are."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from typing import Any

#: Standard errors to either side of an interval of 95 %.
WIDE = 1.96
Row = Mapping[str, Any]


def summary(rows: Sequence[Row]) -> str:
    """Text for people: names by kind, what was wrong, coverage by kind and of all, contacts, widths of
    backlash."""
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    by_kind = [intervals([row for row in rows if row["kind"] == kind], f"{kind}: ") for kind in kinds]
    parts = [names(rows), wrongs(rows), *(by_kind if len(kinds) > 1 else []), intervals(rows), contacts(rows)]
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
