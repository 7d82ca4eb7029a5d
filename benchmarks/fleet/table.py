"""The page of results about simulated fleets."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

_HEAD = """\
# Fleets of which is known what is planted

Written by `python -m benchmarks.fleet`; `docs/blind-tests.md` says how such a fleet comes about. A unit is
named that has a claim; a name is right whose joint is the planted one and one of whose effects is planted.

| | wanted | {} |
|---|---|{}
"""


def page(results: Mapping[str, Any]) -> str:
    """The page with all figures of ``results``."""
    fleets = results.get("fleets", {})
    columns = [_column(figures) for figures in fleets.values()]
    wanted = {
        "planted units named": "90 %",
        "healthy units named": "5 % of the named at most",
        "names right": "95 %",
        "dates off by (median)": "30 days",
    }
    rows = dict.fromkeys(name for column in columns for name in column)
    lines = [
        _HEAD.format(" | ".join(f"simulated by {name}" for name in fleets), "---|" * len(fleets)).rstrip()
    ]
    for name in rows:
        cells = [column.get(name, "") for column in columns]
        lines.append(f"| {name} | {wanted.get(name, '')} | {' | '.join(cells)} |")
    for name, figures in fleets.items():
        cases = [case for case in figures["score"]["cases"] if not case["right"]]
        if not cases:
            continue
        lines += [
            "",
            f"## Simulated by {name}: what was not right",
            "",
            "| unit | planted | named |",
            "|---|---|---|",
        ]
        lines += [
            f"| {case['unit']} | {case['planted'] or 'nothing'} | {', '.join(case['named']) or 'nothing'} |"
            for case in cases
        ]
    return "\n".join(lines) + "\n"


def _column(figures: Mapping[str, Any]) -> dict[str, str]:
    score = figures["score"]
    column = {
        "units, logs, seed": f"{score['units']}, {figures['logs']}, {figures['seed']}",
        "planted units named": _share(score["named"], score["planted"]),
    }
    for kind, counts in score["kinds"].items():
        column[f"{kind}: named; right"] = f"{counts['named']}; {counts['right']} of {counts['planted']}"
    column["healthy units named"] = _share(score["false"], score["healthy"])
    column["names right"] = _share(score["right"], score["claims"])
    if score["days_off"] is not None:
        column["dates off by (median)"] = f"{score['days_off']:.0f} days"
        column["dates off by 30 days at most"] = f"{score['near']:.0%}"
    if score["interval_holds"] is not None:
        column["dates in the stated interval"] = f"{score['interval_holds']:.0%}"
    column |= {f"{what} in": f"{seconds / 60:.1f} min" for what, seconds in figures["seconds"].items()}
    return column


def _share(part: int, whole: int) -> str:
    return f"{part} of {whole}" + (f" ({part / whole:.1%})" if whole else "")
