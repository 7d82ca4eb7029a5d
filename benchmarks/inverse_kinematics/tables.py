"""The tables of docs/inverse-kinematics-benchmark.md."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from benchmarks.marked import with_part

Results = Mapping[str, Any]


def written(page: str, results: Results) -> str:
    """The page with its tables anew."""
    for mark, table in (("arms", _arms), ("sets", _sets), ("hard", _hard), ("race", _race)):
        page = with_part(page, mark, "\n".join(table(results["arms"])))
    return page


def _arms(arms: Results) -> Iterator[str]:
    yield "| arm | joints | what holds of its axes | joint that is redundant | CPU time to generate, s |"
    yield "|---|---:|---|---:|---:|"
    for name, arm in arms.items():
        if "refused" in arm:
            yield f"| {name} | | refused: {arm['refused']} | | |"
            continue
        redundant = "" if arm["redundant"] is None else arm["redundant"] + 1
        row = (
            name,
            arm["joints"],
            "; ".join(arm["conditions"]),
            redundant,
            f"{arm['generated_seconds']:.1f}",
        )
        yield _row(row)


def _sets(arms: Results) -> Iterator[str]:
    columns = ("poses", "ours", "theirs", "missing", "invented", "twice", "theirs alone lack", "theirs wrong")
    yield "| arm | beside | " + " | ".join(columns) + " | ours close to | theirs |"
    yield "|---|---|" + "---:|" * (len(columns) + 2)
    for name, arm in arms.items():
        for one in arm.get("sets", ()):
            if "missing" in one and isinstance(one["missing"], str):
                yield _row((name, one["peer"], one["missing"], *[""] * (len(columns) + 1)))
                continue
            swept = one["swept"]
            row = (name, one["peer"], *(f"{one[key]:,}" for key in ("poses", "ours", "theirs")))
            row += (_both(one, "missing"), f"{one['invented']:,}", f"{one['twice']:,}")
            row += ("" if swept else _both(one, "only_ours"), f"{one['wrong']:,}")
            yield _row((*row, f"{one['closes']:.0e}", f"{one['closes_theirs']:.0e}"))


def _both(one: Mapping[str, Any], key: str) -> str:
    """Those away from singularities, and in brackets those at one."""
    at_one = one[f"{key}_singular"]
    return f"{one[key]:,}" + (f" (+{at_one:,})" if at_one else "")


def _hard(arms: Results) -> Iterator[str]:
    wrong = ("not finite", "no flags", "reachable, none exists", "out of reach, one exists")
    yield f"| arm | poses | how many | {' | '.join(wrong)} | at a limit, not within | close to |"
    yield "|---|---|" + "---:|" * 7
    for name, arm in arms.items():
        for one in arm.get("hard", ()):
            wrong = one["no_flags"] + one["miscounted"]
            cells = (f"{one[key]:,}" if key in one else "" for key in ("unsolved", "solved", "refused"))
            closes = f"{one['closes']:.0e}" if "closes" in one else ""
            yield _row((name, one["kind"], f"{one['poses']:,}", one["not_finite"], wrong, *cells, closes))


def _race(arms: Results) -> Iterator[str]:
    columns = ("solutions a pose", "ns a pose", "ns a solution", "times ours, a pose", "95 % interval")
    yield f"| arm | runner | {' | '.join(columns)} | instructions a pose |"
    yield "|---|---|" + "---:|" * (len(columns) + 1)
    for name, arm in arms.items():
        for one in (arm.get("race") or {"rows": ()})["rows"]:
            median, low, high = one["ratio"]
            ratio = ("", "") if one["ours"] else (f"{median:.1f}", f"{low:.1f} to {high:.1f}")
            counted = "" if one["instructions"] is None else f"{one['instructions']:,.0f}"
            each = one["ns"] / one["solutions"]
            cells = (f"{one['solutions']:.1f}", f"{one['ns']:,.0f}", f"{each:,.0f}", *ratio, counted)
            yield _row((name, one["title"], *cells))


def _row(cells: Any) -> str:
    return "| " + " | ".join(map(str, cells)) + " |"
