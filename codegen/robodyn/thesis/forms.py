"""The logarithmic forms beside the linear ones: chains and work for every number of joints."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from robodyn.errors import InputError
from robodyn.thesis.logarithmic import (
    FORMS,
    LINEAR,
    LOGARITHMIC,
    TITLES,
    Cost,
    cost,
    thesis_chain,
)

MOST_JOINTS = 48


def compared(most: int, tell: Callable[[str], None] = lambda _: None) -> dict[str, Any]:
    """Chains and work of all forms for 2 to ``most`` joints, and from which number on a logarithmic form has
    the shorter chain.

    Raises
    ------
    InputError: fewer than two joints, or more than take seconds.
    """
    if not 2 <= most <= MOST_JOINTS:
        raise InputError("forms need joints", found=f"--links {most}", expected=f"2 to {MOST_JOINTS}")
    rows: list[dict[str, Any]] = []
    costs: dict[str, dict[int, Cost]] = {form: {} for form in FORMS}
    for n in range(2, most + 1):
        tell(f"{n} joints")
        for form in FORMS:
            costs[form][n] = cost(form, n)
        rows.append(
            {
                "joints": n,
                "thesis_tasks_chain": thesis_chain(n),
                **{form: {"chain": costs[form][n].chain, "work": costs[form][n].work} for form in FORMS},
            }
        )
    chains = {form: {n: one.chain for n, one in costs[form].items()} for form in FORMS}
    thesis = {n: thesis_chain(n) for n in range(2, most + 1)}
    against = {**{form: chains[form] for form in LINEAR}, "thesis_tasks": thesis}
    return {
        "titles": dict(TITLES),
        "rows": rows,
        "shorter_from": {
            form: {other: _first(chains[form], than) for other, than in against.items()}
            for form in LOGARITHMIC
        },
    }


def _first(own: dict[int, int], other: dict[int, int]) -> int | None:
    """From which number of joints on ``own`` is shorter, up to the last one."""
    first = None
    for n in sorted(own, reverse=True):
        if own[n] >= other[n]:
            break
        first = n
    return first


def forms_text(comparison: dict[str, Any]) -> str:
    """The comparison for a person."""
    forms = list(FORMS)
    lines = [
        "Operations one after another (chain) and in all (work), revolute arms with right angles, single "
        "operations,",
        "processors being plenty; sines and cosines given. Thesis: its tasks of three, 12 n + 9.",
        "",
        "joints  thesis  " + "  ".join(form.rjust(22) for form in forms),
        "                " + "  ".join("chain / work".rjust(22) for _ in forms),
    ]
    for row in comparison["rows"]:
        cells = "  ".join(f"{row[form]['chain']:>13} / {row[form]['work']:<6}" for form in forms)
        lines.append(f"{row['joints']:>6}  {row['thesis_tasks_chain']:>6}  {cells}".rstrip())
    lines.append("")
    for form, against in comparison["shorter_from"].items():
        crossings = ", ".join(
            f"{other} from {n} joints on" if n else f"{other} at no number here"
            for other, n in against.items()
        )
        lines.append(f"{form}: a shorter chain than {crossings}")
    last = comparison["rows"][-1]
    base = last["modified newton-euler"]["work"]
    for form in LOGARITHMIC:
        lines.append(
            f"{form}: {last[form]['work'] / base:.2f} times the work of modified newton-euler at "
            f"{last['joints']} joints"
        )
    lines += ["", *(f"{name}: {title}" for name, title in comparison["titles"].items())]
    return "\n".join(lines) + "\n"
