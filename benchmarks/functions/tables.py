"""functions.md and the table in the documents, made from functions.json and nothing else."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from statistics import median
from typing import Any

from benchmarks.marked import with_part

TITLES = {
    "casadi": "CasADi SX, `cse`",
    "symforce": "SymForce",
    "wrenfold": "wrenfold",
    "pinocchio": "Pinocchio -> CasADi, `cse`",
}
MARK = "counts"
#: The arms whose operations stand in the documents, one with zeros in its model and one without.
SHOWN = ("puma560", "panda")


def markdown(figures: Mapping[str, Any]) -> str:
    """All figures as Markdown."""
    parts = [
        "# Operations of every function: robodyn and its peers",
        f"{versions(figures)}. Written by `python -m benchmarks.functions`; made from `functions.json`.",
        explained(figures),
        "## In short",
        summary(figures),
        *_not_below(figures),
    ]
    for function in functions(figures):
        parts += [f"## {function}", of_function(figures, function)]
    parts += ["## Not counted", _missing(figures)]
    return "\n\n".join(part for part in parts if part) + "\n"


def in_document(figures: Mapping[str, Any], document: str) -> str:
    """``document`` with the tables between its marks.

    Raises
    ------
    ValueError: it has no marks.
    """
    parts = [f"{versions(figures)}; {len(figures['robots'])} bundled robots.", summary(figures)]
    for robot in SHOWN:
        if robot in figures["robots"]:
            parts += [f"`{robot}`:", _of_robot(figures, robot)]
    return with_part(document, MARK, "\n\n".join([*parts, *_not_below(figures)]))


def explained(figures: Mapping[str, Any]) -> str:
    """What is counted, and how."""
    states, seconds = figures["states"], figures["seconds"]
    return (
        "Multiplications, additions, divisions and square roots; unary minus, sines and cosines are free. "
        "*robodyn*: as shipped (with records where there are any); *fast*: `--optimize fast`, which any arm "
        "gets. The others are given the same arm and the same function as their users write it "
        "(`benchmarks/functions/natural.py`: recursive Newton-Euler, composite bodies, `L D L^T`, the tool's "
        "own differentiation), in each way to write it that is listed there; the one with the fewest "
        "operations counts. Pinocchio's own algorithms (crba, aba, computeRNEADerivatives, "
        "computeABADerivatives, ...) are traced over CasADi's SX. Each is held against our values at "
        f"{states} random states, to 1e-9 of the largest, before it counts; each had {seconds:g} s of "
        "CPU for a function. *Ratio*: the fewest operations of any of them, to ours."
    )


def versions(figures: Mapping[str, Any]) -> str:
    """Names and versions of the tools."""
    return ", ".join(f"{tool} {version}" for tool, version in figures["versions"].items())


def functions(figures: Mapping[str, Any]) -> list[str]:
    """Names of all functions that a robot has."""
    return list(dict.fromkeys(name for table in figures["robots"].values() for name in table))


def ratio(row: Mapping[str, Any], own: str = "record") -> tuple[float, str] | None:
    """The fewest operations of a peer to ours, and which peer; None where no peer has any."""
    others = [(row[tool]["total"], tool) for tool in TITLES if "total" in row.get(tool, {})]
    if not others:
        return None
    fewest, tool = min(others)
    ours = row[own]["total"]
    return (fewest / ours if ours else float("inf") if fewest else 1.0), tool


def not_below(figures: Mapping[str, Any]) -> Iterator[tuple[str, str, int, str, int]]:
    """Where ours is not below a peer: function, robot, our operations, the best peer and its."""
    for function in functions(figures):
        for robot, table in figures["robots"].items():
            best = ratio(table[function]) if function in table else None
            if best is not None and best[0] <= 1:
                row, tool = table[function], best[1]
                yield function, robot, row["record"]["total"], tool, row[tool]["total"]


def _not_below(figures: Mapping[str, Any]) -> Iterator[str]:
    more: dict[str, list[str]] = {}
    equal: dict[str, list[str]] = {}
    for function, robot, ours, tool, theirs in not_below(figures):
        if theirs < ours:
            more.setdefault(function, []).append(f"`{robot}` {ours} ({TITLES[tool]} {theirs})")
        else:
            equal.setdefault(function, []).append(f"`{robot}` {ours}")
    for what, table in (
        ("Where another takes fewer operations than ours", more),
        ("Where the best of the others takes as many", equal),
    ):
        lines = [f"- {function}: {', '.join(robots)}" for function, robots in table.items()]
        yield f"{what}:\n\n" + "\n".join(lines) if lines else f"{what}: nowhere."


def summary(figures: Mapping[str, Any]) -> str:
    """A line a function: how many times the operations the best of the others has."""
    lines = []
    for function in functions(figures):
        rows = [table[function] for table in figures["robots"].values() if function in table]
        bests = [best for best in map(ratio, rows) if best is not None]
        if not bests:
            continue
        ratios, tools = [best[0] for best in bests], [best[1] for best in bests]
        often = max(TITLES, key=tools.count)
        others = f"{TITLES[often]} ({tools.count(often)} of {len(tools)})"
        cells = (min(ratios), median(ratios), max(ratios))
        lines.append((function, *(f"{x:.2f}" for x in cells), others))
    return table_of(("function", "least ratio", "median", "largest", "best of the others, most often"), lines)


def of_function(figures: Mapping[str, Any], function: str) -> str:
    lines = [
        (f"`{robot}`", *_cells(table[function]))
        for robot, table in figures["robots"].items()
        if function in table
    ]
    return table_of(("robot", *_HEAD), lines)


def _of_robot(figures: Mapping[str, Any], robot: str) -> str:
    return table_of(
        ("function", *_HEAD), ((name, *_cells(row)) for name, row in figures["robots"][robot].items())
    )


_HEAD = ("robodyn", "fast", *TITLES.values(), "ratio")


def _cells(row: Mapping[str, Any]) -> tuple[str, ...]:
    best = ratio(row)
    others = (str(row[tool]["total"]) if "total" in row.get(tool, {}) else "-" for tool in TITLES)
    own = f"**{row['record']['total']}**", str(row["fast"]["total"])
    return (*own, *others, "-" if best is None else f"{best[0]:.2f}")


def _missing(figures: Mapping[str, Any]) -> str:
    reasons: dict[tuple[str, str, str], list[str]] = {}
    for robot, table in figures["robots"].items():
        for function, row in table.items():
            for tool, title in TITLES.items():
                if "total" not in row.get(tool, {}):
                    why = row.get(tool, {}).get("why", "not asked")
                    reasons.setdefault((title, function, why), []).append(robot)
    return "\n".join(
        f"- {title}, {function} ({len(robots)} robots): {why}"
        for (title, function, why), robots in reasons.items()
    )


def table_of(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table in Markdown."""
    lines = ["| " + " | ".join(head) + " |", "|---" + "|---:" * (len(head) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])
