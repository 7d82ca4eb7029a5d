"""Tables of chapter 2: the steps of the recursion as printed (2.4), inertias of the PUMA 560 beside what
program D.2's tensors make of them (2.6), and operations of the two Newton-Euler methods, a joint and a step
(2.9)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any, Final

from robodyn.counts import Count
from robodyn.counts.general import general_count
from robodyn.dynamics.modified_newton_euler import modified_newton_euler
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.thesis.printed import D_2, D_2_LAST_DIGIT, PUMA, TABLE_2_9
from robodyn.thesis.slips import slips, slips_of
from robodyn.thesis.steps import Method, Rotation, step_counts
from robodyn.thesis.tables.equations import slip_row
from robodyn.thesis.tables.table import Row, compared_count, counted, judged, summed, words_of

# --- 2.4 --------------------------------------------------------------------------------------------------


def table_2_4() -> Iterator[Row]:
    """The steps in their order, a prismatic joint's after a revolute one's; those with a slip as ``tables
    equations`` has them."""
    rows = [slip_row(step) for step in (*slips("table_2_4"), *slips_of("Table 2.4, "))]
    yield from sorted(rows, key=lambda row: (row.name.partition(",")[0], row.name.endswith("prismatic")))


# --- 2.6 --------------------------------------------------------------------------------------------------


def table_2_6() -> Iterator[Row]:
    """A row for each printed figure, and one for the tensor that no body has."""
    half = D_2_LAST_DIGIT / 2
    for k, (link, tensor) in enumerate(zip(PUMA, D_2, strict=True), 1):
        for name, moment, whole, shift, rotor in zip(
            ("Ixx", "Iyy", "Izz"), link.moments, tensor, link.shifts, link.rotors, strict=True
        ):
            if moment is not None and whole is not None:
                yield _inertia(f"link {k}, {name}", moment, whole - shift - rotor, whole)
        (_, iyy, izz), (_, around_y, around_z) = link.moments, tensor
        if izz is not None and around_z is not None:
            tenfold = iyy and around_y and abs(around_y - link.shifts[1] - iyy / 10) <= half
            moment = izz / 10 if tenfold else izz
            yield _inertia(f"link {k}, rotor", link.motor, around_z - link.shifts[2] - moment, around_z)
    for k, link in enumerate(PUMA, 1):
        xx, yy, zz = link.moments
        if xx is None or yy is None or zz is None:
            continue
        spare = min(xx + yy - zz, yy + zz - xx, xx + zz - yy)
        yield Row(
            f"link {k}, triangle",
            {"value": f"{float(xx)} {float(yy)} {float(zz)}"},
            {"value": float(spare)},
            judged(spare >= 0),
            "the least of the sums of two moments less the third, which no body has below 0"
            + ("" if spare >= 0 else ": these moments are no body's"),
        )


def _inertia(name: str, printed: Fraction, ours: Fraction, whole: Fraction) -> Row:
    """A printed figure beside ours, which is D.2's ``whole`` one less what belongs to others."""
    half = D_2_LAST_DIGIT / 2
    same = abs(ours - printed) <= half
    if same:
        reason = "program D.2 has it, moved to the link's origin"
    elif abs(ours - printed / 10) <= half:
        reason = "ten times what program D.2 has"
    elif whole == printed:
        reason = "program D.2 has the printed one about the link's origin: it was not moved there"
    else:
        reason = "program D.2 has another one"
    return Row(name, {"value": float(printed)}, {"value": float(round(ours, 6))}, judged(same), reason)


# --- 2.9 --------------------------------------------------------------------------------------------------

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
        return ({"what": "robodyn's recursion, a joint, DH's R in two turns, full tensor", **counted(joint)},)
    rotations: tuple[Rotation, ...] = ("full", "right-angled")
    return tuple(
        {
            "what": f"R {rotation} throughout",
            **counted(summed(step_counts(method, revolute=False, rotation=rotation).values())),
        }
        for rotation in rotations
    )
