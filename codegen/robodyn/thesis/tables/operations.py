"""Operations a joint: of the two Newton-Euler methods, step by step (Table 2.9), and of friction (Table
3.3)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, Final

from robodyn.counts import Count
from robodyn.counts.general import Tally, general_count
from robodyn.dynamics.modified_newton_euler import modified_newton_euler
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.vectors import Vector
from robodyn.effects import thesis_friction as friction
from robodyn.thesis.printed import TABLE_2_9, TABLE_3_3
from robodyn.thesis.steps import Method, Rotation, step_counts
from robodyn.thesis.tables.table import Row, compared_count, count_data, summed, words_of

#: The rows in which the table takes a prismatic joint's R for a full matrix; in the others it is free.
FULL_R: Final[dict[Method, frozenset[str]]] = {
    "I": frozenset(("a", "f_rotated")),
    "II": frozenset(("a", "f", "n")),
}


def joint_counts(method: Method, revolute: bool) -> dict[str, Count]:
    """Ours by step, R of a prismatic joint full or free as the table has it in that row."""
    full = step_counts(method, revolute=revolute, rotation="full")
    if revolute:
        return full
    free = step_counts(method, revolute=False, rotation="right-angled")
    return {step: (full if step in FULL_R[method] else free)[step] for step in full}


def joint_count(method: Method, revolute: bool) -> Count:
    """Ours of all steps of a joint."""
    return summed(joint_counts(method, revolute).values())


def table_2_9() -> Iterator[Row]:
    """Printed and recomputed operations, step by step, of both methods and kinds of joints."""
    for heading, printed in TABLE_2_9.items():
        kind, _, column = heading.partition("_")
        method: Method = "I" if column == "I" else "II"
        revolute = kind == "revolute"
        ours = {**joint_counts(method, revolute), "total": joint_count(method, revolute)}
        for step, figure in printed.items():
            yield compared_count(
                f"{kind} {method}, {step}",
                figure,
                ours[step],
                words_of("2.9")["reasons"],
                _agreement(method, revolute, step),
                _beside(method, revolute) if step == "total" else (),
            )


def _agreement(method: Method, revolute: bool, step: str) -> str:
    if revolute or (step in ("a_c", "F", "N", "f") and step not in FULL_R[method]):
        return "the step, carried out, takes as many"
    if step == "total":
        return "the sum of rows that treat R differently"
    return f"the step, carried out, takes as many with R {'full' if step in FULL_R[method] else 'free'}"


def _beside(method: Method, revolute: bool) -> tuple[Mapping[str, Any], ...]:
    if revolute:
        run = modified_newton_euler if method == "I" else newton_euler
        fewer, more = (general_count(run, n) for n in (3, 4))
        joint = Count(mul=more.mul - fewer.mul, add=more.add - fewer.add)
        what = "robodyn's recursion, a joint, DH's R in two turns, full tensor"
        return ({"what": what, **count_data(joint)},)
    rotations: tuple[Rotation, ...] = ("full", "right-angled")
    return tuple(
        {
            "what": f"R {rotation} throughout",
            **count_data(summed(step_counts(method, revolute=False, rotation=rotation).values())),
        }
        for rotation in rotations
    )


# --- 3.3 --------------------------------------------------------------------------------------------------


def _tallied(run: Callable[[Callable[[], Any], Callable[[], Vector]], object]) -> Count:
    """The operations of ``run``, which is given makers of numbers and of vectors."""
    ledger: dict[str, int] = {}

    def number() -> Any:
        return Tally(ledger)

    run(number, lambda: (number(), number(), number()))
    return Count(**ledger)


def journal(*, as_printed: bool = False) -> Count:
    """Operations of Eq 3.3."""
    return _tallied(
        lambda x, v: friction.journal_bearing(x(), x(), x(), v(), v(), x(), as_printed=as_printed)
    )


def transmission(efficiency: Callable[[Any, Any], Any]) -> Count:
    """Operations of Table 3.2's first case with the efficiency by ``efficiency(load, coefficients)``."""

    def run(x: Callable[[], Any], _: object) -> object:
        torque = x()
        load = friction.load_fraction(torque, x())
        return friction.driving(torque, efficiency(load, [x() for _ in range(4)]), x(), x())

    return _tallied(run)


def friction_counts() -> dict[str, Count]:
    """All rows of Table 3.3, ours."""
    cubic = transmission(friction.cubic_efficiency_in_pairs)
    straight = transmission(friction.linear_efficiency)
    linear = _tallied(lambda x, v: friction.linear_bearing(x(), x(), v(), v(), x()))
    counts = {"transmission, cubic_spline": cubic, "transmission, linear": straight}
    for kind, joint in (("revolute", journal()), ("prismatic", linear)):
        rigid = joint_count("I", kind == "revolute")
        counts[f"frictionless, {kind}"] = rigid
        counts[f"joint, {kind}"] = joint
        counts[f"total_cubic, {kind}"] = summed((rigid, joint, cubic))
        counts[f"total_linear, {kind}"] = summed((rigid, joint, straight))
    return counts


def table_3_3() -> Iterator[Row]:
    """Printed and recomputed operations of friction in joints and transmissions."""
    counts, reasons = friction_counts(), words_of("3.3")["reasons"]
    beside: dict[str, Mapping[str, Any]] = {
        "joint, revolute": {
            "what": "Eq 3.3 as printed, a wrong sign in it", **count_data(journal(as_printed=True)),
        },
        "transmission, cubic_spline": {
            "what": "by Horner's rule", **count_data(transmission(friction.cubic_efficiency)),
        },
    }  # fmt: skip
    for name, figures in TABLE_3_3.items():
        for kind, printed in figures.items():
            row = f"{name}, {kind}"
            others = (beside[row],) if row in beside else ()
            yield compared_count(row, printed, counts[row], reasons, "the sum of the rows above", others)
