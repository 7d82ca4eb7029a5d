"""Table 1.1: what the formulations cost, as polynomials in the number of joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Final

from robodyn.counts import Count
from robodyn.counts.general import Formulation, general_count
from robodyn.optimize.choice import formulation_named
from robodyn.thesis.parts import uicker_kahn_by_parts
from robodyn.thesis.polynomial import Polynomial, difference, fitted, spelled, value
from robodyn.thesis.printed_counts import TABLE_1_1, PrintedCost
from robodyn.thesis.steps import step_counts
from robodyn.thesis.tables.table import Column, Progress, Row, Table, counted, judged, summed

JOINTS: Final = 6


@dataclass(frozen=True, slots=True)
class Described:
    """A row: the formulation that it describes, the degree of its cost, and why the printed figures are not
    ours, to be read only where the difference (printed less ours) is the one explained."""

    formulation: str
    degree: int
    mul: tuple[str, str]
    add: tuple[str, str]


_LEFT: Final = "what its author counted besides is not recoverable: the thesis quotes the polynomial alone"
_PARTS: Final = (
    "ours multiplies a rate pair into each D_ijk, not into each of its traces, and an acceleration into each "
    "D_ij; it needs the inertial traces of all i <= j <= p, of which the printed figure has half; it forms "
    "(n - 1)(n - 2)/2 transforms fewer; it counts the entries of the transforms and the sums over links"
)

DESCRIBED: Final = {
    "uicker_kahn": Described(
        "lagrange",
        4,
        (
            "1/2 n^4 - 139/12 n^3 - 1/4 n^2 - 727/6 n + 64",
            _PARTS,
        ),
        ("-25/3 n^3 - 2 n^2 - 171/2 n + 48", _PARTS),
    ),
    "hollerbach_4x4": Described(
        "lagrange_4x4",
        1,
        (
            "20 n + 16",
            "16 of the 20 a link would be one more scaling of a 4x4 matrix, and 4 are not explained by its "
            f"equations; the 16 are the base's velocity and acceleration, zero, multiplied; {_LEFT}",
        ),
        (
            "32 n + 48",
            "32 a link would be two more sums of 4x4 matrices, the 48 the zero velocity and acceleration of "
            f"the base, multiplied and added; {_LEFT}",
        ),
    ),
    "hollerbach_3x3": Described(
        "lagrange_3x3",
        1,
        (
            "13 n + 2",
            "9 of the 13 a link would be one more scaling of a 3x3 matrix, as in the row of 4x4 matrices, "
            f"and 4 are not explained, as there; {_LEFT}",
        ),
        (
            "15 n + 30",
            "18 a link would be two more sums of 3x3 matrices, as in the row of 4x4 matrices, and 3 fewer, "
            "since "
            f"ours adds the masses beyond at the next origin, which does not turn with its joint; {_LEFT}",
        ),
    ),
    "newton_euler": Described(
        "newton_euler",
        1,
        (
            "33 n - 2",
            "18 a joint come with R as a full matrix, R^T w formed twice and a full cross product with z qd, "
            "as Table 2.9 counts the same recursion (135); the other 15 are more than the equations of the "
            f"recursion have, 9 of them perhaps one more product with R; {_LEFT}",
        ),
        (
            "41 n - 7",
            "20 a joint come with R as a full matrix, R^T w formed twice and a full cross product with z qd, "
            "as Table 2.9 counts the same recursion (110, not the 123 printed there); the other 21 are more "
            f"than the equations of the recursion have; {_LEFT}",
        ),
    ),
}


#: Formulations that the table has no row for, with the degree of their cost, and what is to be known of them.
UNLISTED: Final = {
    "newton_euler_base": (
        1,
        "every vector along the base's axes, as before Luh, Walker and Paul: each link's inertia is turned "
        "into the base, which takes 45 multiplications and 30 additions of it",
    ),
    "orin": (
        1,
        "motion along the base's axes, forces and moments along each link's: no inertia is turned, but three "
        "vectors a link",
    ),
    "balafoutis": (1, "the tensor recursion, of which Table 2.10 quotes a figure for the PUMA"),
    "kane": (2, "Kane's equations for any arm; what a hand would see of a special one, it does not"),
    "modified_newton_euler": (
        1,
        "the thesis's own; Table 2.9 has its cost a joint",
    ),
}


def formulation(name: str) -> Formulation:
    """The recursion of that name."""
    function = formulation_named(name)
    return lambda arm, motion, mark: list(function(arm, motion, mark))


def table(progress: Progress = lambda _: None) -> Table:
    """Printed polynomials and figures for six joints beside those that our formulations' runs give."""
    rows = []
    for name, printed in TABLE_1_1.items():
        progress(name)
        rows += _rows(name, printed, DESCRIBED[name])
    newton_euler = general_count(formulation("newton_euler"), JOINTS, dense=True)
    for name, (degree, words) in UNLISTED.items():
        progress(name)
        rows.append(_unlisted(name, degree, words, newton_euler))
    return Table(
        "1.1",
        "operations of the inverse dynamics by formulation, n revolute joints",
        (
            Column("printed at 6", "printed", "n6"),
            Column("its polynomial at 6", "printed", "polynomial_at_6"),
            Column("ours at 6", "ours", "n6"),
            Column("printed", "printed", "polynomial", below=True),
            Column("ours", "ours", "polynomial", below=True),
        ),
        tuple(rows),
        (
            "Ours: each formulation of robodyn run on numbers that only count, for arms of which nothing is "
            "special; matrices as full as the formulation writes them (a product of two 4x4 transforms is 64 "
            "multiplications and 48 additions), what depends on the model alone formed beforehand, sine, "
            "cosine and changes of sign free. The polynomial goes through the counts of so many arms as it "
            "has coefficients, and has been checked on two larger ones.",
        ),
    )


def _rows(name: str, printed: PrintedCost, described: Described) -> list[Row]:
    run = formulation(described.formulation)
    sizes = [*range(1, described.degree + 4)]
    counts = {n: general_count(run, n, dense=True) for n in {*sizes, JOINTS}}
    rows = []
    for kind, coefficients, at_6, (known, words) in (
        ("mul", printed.mul, printed.mul_6, described.mul),
        ("add", printed.add, printed.add_6, described.add),
    ):
        ours = {n: getattr(counts[n], kind) for n in counts}
        polynomial = fitted({n: ours[n] for n in sizes}, described.degree)
        rows.append(
            Row(
                f"{name}, {kind}",
                _printed(coefficients, at_6),
                {"polynomial": None if polynomial is None else spelled(polynomial), "n6": ours[JOINTS]},
                judged(polynomial == coefficients and ours[JOINTS] == at_6),
                _reason(coefficients, at_6, polynomial, known, words),
                _by_steps(kind) if name == "newton_euler" else (),
            )
        )
        if name == "uicker_kahn":
            rows.append(_parts_row(kind, coefficients, at_6))
    total = counts[JOINTS].mul + counts[JOINTS].add
    at_polynomial = value(printed.mul, JOINTS) + value(printed.add, JOINTS)
    same = at_polynomial == printed.total_6
    rows.append(
        Row(
            f"{name}, total",
            {"n6": printed.total_6, "polynomial_at_6": _number(at_polynomial)},
            {"n6": total},
            judged(total == printed.total_6),
            f"the printed polynomials give {'this total' if same else str(at_polynomial)}, ours is "
            f"{abs(total - at_polynomial)} {'fewer' if total < at_polynomial else 'more'}: see the rows "
            "above",
        )
    )
    return rows


def _unlisted(name: str, degree: int, words: str, newton_euler: Count) -> Row:
    """The row of a formulation of which nothing is printed."""
    run = formulation(name)
    sizes = range(2, degree + 5)
    counts = {n: general_count(run, n, dense=True) for n in {*sizes, JOINTS}}
    polynomials = {
        kind: fitted({n: getattr(counts[n], kind) for n in sizes}, degree) for kind in ("mul", "add")
    }
    at_6 = counts[JOINTS]
    share = 100 * (at_6.total - newton_euler.total) / newton_euler.total
    return Row(
        f"{name}, total",
        {},
        {
            "n6": at_6.total,
            "mul_6": at_6.mul,
            "add_6": at_6.add,
            "polynomial": " and ".join(
                f"{spelled(polynomial)} {kind}"
                for kind, polynomial in polynomials.items()
                if polynomial is not None
            ),
        },
        None,
        f"the table has no row of it: {words}; {abs(share):.0f} % {'more' if share > 0 else 'fewer'} "
        "operations than Newton-Euler",
    )


def _printed(coefficients: Sequence[Fraction], at_6: int) -> dict[str, Any]:
    return {
        "polynomial": spelled(coefficients),
        "n6": at_6,
        "polynomial_at_6": _number(value(coefficients, JOINTS)),
    }


def _number(x: Fraction) -> int | str:
    return x.numerator if x.denominator == 1 else str(x)


def _reason(
    coefficients: Sequence[Fraction], at_6: int, polynomial: Polynomial | None, known: str, words: str
) -> str:
    slip = ""
    if value(coefficients, JOINTS) != at_6:
        slip = (
            f"the printed polynomial gives {value(coefficients, JOINTS)} for six joints, "
            f"{abs(value(coefficients, JOINTS) - at_6)} from the {at_6} printed beside it; "
        )
    if polynomial is None:
        return slip + "our counts are no polynomial of that degree"
    if polynomial == coefficients:
        return slip + "the same polynomial"
    apart = spelled(difference(coefficients, polynomial))
    explained = words if apart == known else "this difference is not the one that is explained"
    return f"{slip}printed less ours is {apart}: {explained}"


def _parts_row(kind: str, coefficients: Sequence[Fraction], at_6: int) -> Row:
    which = ("mul", "add").index(kind)
    sizes = range(1, 8)
    polynomial = fitted({n: uicker_kahn_by_parts(n)[which] for n in sizes}, 4)
    at_polynomial = value(coefficients, JOINTS)
    same = polynomial == tuple(coefficients)
    reason = (
        "the convention: traces, 4x4 products and gravity shares, all full, each as often as the printed "
        "polynomial has it: for every i, j, k <= p, half of i <= j <= p, n^2 - 2 and i <= j <= p, i <= p"
    )
    if same:
        reason += "; reproduces the printed polynomial exactly"
    elif polynomial is not None:
        reason += f"; the printed polynomial has {spelled(difference(coefficients, polynomial))} more"
        reason += ", where joining the three sums of a torque would take 2 n" if kind == "add" else ""
    ours_at_6 = uicker_kahn_by_parts(JOINTS)[which]
    if same and at_polynomial != at_6:
        reason += f", and so {ours_at_6} for six joints, not the {at_6} printed"
    return Row(
        f"uicker_kahn, {kind}, by parts",
        _printed(coefficients, at_6),
        {"polynomial": None if polynomial is None else spelled(polynomial), "n6": _number(ours_at_6)},
        judged(same),
        reason,
    )


def _by_steps(kind: str) -> tuple[dict[str, Any], ...]:
    total: Count = summed(*step_counts("II", revolute=True).values())
    return ({"what": "the same recursion, a joint, R full, as Table 2.9 has it", **counted(total)},)
