"""peers.md, made from peers.json and nothing else."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any


def markdown(figures: Mapping[str, Any]) -> str:
    """The results as Markdown."""
    machine, native, python = figures["machine"], figures["native"], figures["python"]
    parts = [
        f"# Inverse dynamics of {native['robot']}: robodyn and its peers",
        f"{machine['processor']}, {machine['compiler']}, Python {machine['python']}; load {machine['load']} "
        f"on {machine['cores']} cores while it ran. Written by `make benchmarks`; made from `peers.json`.",
        f"{native['states']} random states. Every runner got the same arm, and was timed only after its "
        "torques had been held against the plain textbook's (double precision: to 1e-9 of the largest torque "
        f"of a state). All ran in one process, in short blocks in turn, {native['rounds']} rounds. *Ratio*: "
        "the median of the ratios within a round to our kernel with built-in sine and cosine, compiled as "
        "its peers are; in brackets the interval that has that median with 95 %. Below 1 is faster.",
        "![Times as ratios](peers.svg)",
        "## One state after another",
        table(("", "ns", "ratio", "instructions", "compiled with"), _native(native["rows"], batch=False)),
        "Instructions by callgrind, the loop around the call included, on builds for AVX2 (valgrind knows no "
        "AVX-512): ours and the C of CasADi with `-std=c99 -O2 -march=x86-64-v3`, the rest with "
        "`-O3 -march=x86-64-v3`; what lies compiled in a wheel as it is. C++ "
        "was compiled with `-DNDEBUG`, which is what release builds have; where it is left out Eigen checks "
        "sizes in every operation, and the row says so.",
    ]
    batches = list(_native(native["rows"], batch=True))
    if batches:
        parts += [
            "## Batches, a state",
            f"{native['states']} states in one call, structure of arrays, one core.",
            table(("", "ns", "ratio", "instructions", "compiled with"), batches),
        ]
    parts += [
        "## From Python",
        table(
            ("", "µs a state", "ratio"),
            ((row["title"], f"{row['ns'] / 1000:.3f}", _ratio(row["ratio"])) for row in python["rows"]),
        ),
        f"{python['rounds']} rounds, in turn, in one process; ratio to the call through `Workspace`.",
        "## What was to be shown",
        table(
            ("how many times faster", "wanted", "measured"),
            (_demand(row, figures) for row in [*native["demands"], *python["demands"]]),
        ),
    ]
    missing = [*native["missing"], *python["missing"]]
    if missing:
        parts += ["## Not raced", "\n".join(f"- {one['title']}: {one['why']}" for one in missing)]
    if figures["growth"]:
        parts += _growth(figures["growth"])
    if figures.get("functions"):
        parts += _functions(figures["functions"])
    return "\n\n".join(parts) + "\n"


def _native(rows: Iterable[Mapping[str, Any]], *, batch: bool) -> Iterable[tuple[str, ...]]:
    for row in rows:
        if row["key"].startswith("batch-") == batch:
            title = f"**{row['title']}**" if row["ours"] else row["title"]
            note = f" ({row['note']})" if row["note"] else ""
            counted = "-" if row["instructions"] is None else f"{row['instructions']:.0f}"
            yield title + note, f"{row['ns']:.1f}", _ratio(row["ratio"]), counted, f"`{row['flags']}`"


def _ratio(ratio: Sequence[float]) -> str:
    middle, low, high = ratio
    return "1" if low == high == 1 else f"{middle:.3g} [{low:.3g}, {high:.3g}]"


def _demand(row: Mapping[str, Any], figures: Mapping[str, Any]) -> tuple[str, str, str]:
    titles = {one["key"]: (one["title"], one.get("flags", "")) for one in figures["native"]["rows"]}
    titles |= {one["key"]: (one["title"], "") for one in figures["python"]["rows"]}
    (peer, _), (ours, flags) = titles[row["peer"]], titles[row["ours"]]
    built = f" (`{flags}`)" if flags else ""
    verdict = "" if row["ratio"][0] >= row["wanted"] else ", **missed**"
    return f"{ours}{built} than {peer}", f"{row['wanted']:g}", _ratio(row["ratio"]) + verdict


_KEYS = (("robodyn-builtin", "built-in"), ("robodyn-libm", "libm"), ("pinocchio", "Pinocchio"))


def _growth(rows: Sequence[Mapping[str, Any]]) -> list[str]:
    keys = [(key, title) for key, title in _KEYS if key in rows[0]["ns"]]
    head = ["joints", "operations", "generation, s", *(f"{title}, ns" for _, title in keys)]
    head += [f"{title}, instructions" for _, title in keys]
    lines = []
    for row in rows:
        counted = [row["instructions"].get(key) for key, _ in keys]
        lines.append(
            (
                str(row["joints"]),
                str(row["operations"]),
                f"{row['generation_s']['process']:.2f}",
                *(f"{row['ns'][key]:.0f}" for key, _ in keys),
                *("-" if x is None else f"{x:.0f}" for x in counted),
            )
        )
    start = rows[0]["generation_s"]["start"]
    return [
        "## From 1 to 30 joints",
        "Revolute arms in general position with full inertias (`benchmarks.peers.family`), `--optimize "
        "fast`: no record, no search. Generation is the CPU time of the whole process `robodyn gen` of the "
        f"inverse dynamics in C; {start:.2f} s of it are the start of Python.",
        "![Growth](growth.svg)",
        table(head, lines),
    ]


def _functions(figures: Mapping[str, Any]) -> Iterable[str]:
    """Every function: what was to be shown first, then all who raced."""
    machine, races = figures["machine"], figures["races"]
    yield "## Every function"
    yield (
        f"{machine['processor']}, {machine['compiler']}; load {machine['load']} "
        f"on {machine['cores']} cores. As above: the same arms and states, results held against "
        "ours, one process for all of a function, ratios round by round; C++ with `-DNDEBUG`, results stored "
        "as ours are. Of Pinocchio's two conventions the faster one is meant."
    )
    lines = []
    for race in races:
        titles = {row["key"]: (row["title"], row["flags"]) for row in race["rows"]}
        for demand in race["demands"]:
            verdict = "" if demand["ratio"][0] >= demand["wanted"] else ", **missed**"
            cells = (titles[demand["peer"]][0], f"`{titles[demand['ours']][1]}`", f"{demand['wanted']:g}")
            lines.append((race["robot"], race["function"], *cells, _ratio(demand["ratio"]) + verdict))
    yield table(("robot", "function", "times faster than", "ours compiled with", "wanted", "measured"), lines)
    rows = []
    for race in races:
        for row in race["rows"]:
            title = f"**{row['title']}**" if row["ours"] else row["title"]
            counted = "-" if row["instructions"] is None else f"{row['instructions']:.0f}"
            columns = (f"{row['ns']:.0f}", _ratio(row["ratio"]), counted, f"`{row['flags']}`")
            rows.append((race["robot"], race["function"], title, *columns))
    yield table(("robot", "function", "", "ns", "ratio", "instructions", "compiled with"), rows)
    absent = {f"- {one['title']}: {one['why']}" for race in races for one in race["missing"]}
    if absent:
        yield "\n".join(sorted(absent))


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table in Markdown."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])
