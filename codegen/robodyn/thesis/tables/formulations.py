"""Table 1.1: what the formulations cost, as polynomials in the number of joints.

Lagrange's closed form is counted once more by its parts, each as often as the figures of 1980 have it: the
printed polynomials of Uicker and Kahn's method are a sum of four. What one part costs is counted on our own
formulation's functions, how often it comes is read from the printed figures. The inertial traces come half as
often as they are needed (for one joint half a trace): by this convention nobody could compute, and it is only
for seeing what the figures are made of.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from typing import Any, Final, Literal

from robodyn.counts import Count
from robodyn.counts.general import Formulation, Tally, general_count
from robodyn.dynamics.transforms import Matrix, applied, inner, product
from robodyn.optimize.choice import formulation_named
from robodyn.thesis.formulations.lagrange import weighed
from robodyn.thesis.polynomial import Polynomial, difference, fit, polynomial_text, value
from robodyn.thesis.printed import TABLE_1_1, PrintedCost
from robodyn.thesis.steps import step_counts
from robodyn.thesis.tables.table import Row, count_data, summed, verdict_of, words_of

JOINTS: Final = 6
#: The printed rows' formulations, and those that the table has no row for, with the degrees of their costs.
DEGREES: Final = {"lagrange": 4, "lagrange_4x4": 1, "lagrange_3x3": 1, "newton_euler": 1}
OTHERS: Final = {"newton_euler_base": 1, "orin": 1, "balafoutis": 1, "kane": 2, "modified_newton_euler": 1}
_NAMES: Final = dict(zip(TABLE_1_1, DEGREES, strict=True))


def formulation(name: str) -> Formulation:
    """The recursion of that name, of Table 1.1's rows or of robodyn's."""
    function = formulation_named(_NAMES.get(name, name))
    return lambda arm, motion, mark: list(function(arm, motion, mark))


def table_1_1() -> Iterator[Row]:
    """Printed polynomials and figures for six joints beside those that our formulations' runs give."""
    words = words_of("1.1")
    for name, printed in TABLE_1_1.items():
        yield from _rows(name, printed, words["reasons"])
    recursion = general_count(formulation("newton_euler"), JOINTS, dense=True)
    for name, degree in OTHERS.items():
        yield _unlisted(name, degree, words["others"][name], recursion)


def _counts(name: str, sizes: Sequence[int]) -> tuple[Count, dict[str, dict[int, int]]]:
    """Operations for six joints, and multiplications and additions for so many."""
    run = formulation(name)
    counts = {n: general_count(run, n, dense=True) for n in {*sizes, JOINTS}}
    return counts[JOINTS], {kind: {n: getattr(counts[n], kind) for n in sizes} for kind in ("mul", "add")}


def _rows(name: str, printed: PrintedCost, reasons: Mapping[str, str]) -> Iterator[Row]:
    degree = DEGREES[_NAMES[name]]
    at_6, ours = _counts(name, range(1, degree + 4))
    kinds: tuple[tuple[Literal["mul", "add"], Polynomial, int], ...] = (
        ("mul", printed.mul, printed.mul_6), ("add", printed.add, printed.add_6)
    )  # fmt: skip
    for kind, coefficients, figure in kinds:
        polynomial = fit(ours[kind], degree)
        beside: tuple[Mapping[str, Any], ...] = ()
        if name == "newton_euler":
            joint = count_data(summed(step_counts("II", revolute=True).values()))
            beside = ({"what": "the same recursion, a joint, R full, as Table 2.9 has it", **joint},)
        yield Row(
            f"{name}, {kind}",
            _printed(coefficients, figure),
            {"polynomial": polynomial and polynomial_text(polynomial), "n6": getattr(at_6, kind)},
            verdict_of(polynomial == coefficients and getattr(at_6, kind) == figure),
            _reason(f"{name}, {kind}", coefficients, figure, polynomial, reasons),
            beside,
        )
        if name == "uicker_kahn":
            yield _parts_row(kind, coefficients, figure)
    total = at_6.mul + at_6.add
    at_polynomial = value(printed.mul, JOINTS) + value(printed.add, JOINTS)
    gives = "this total" if at_polynomial == printed.total_6 else str(at_polynomial)
    yield Row(
        f"{name}, total",
        {"n6": printed.total_6, "polynomial_at_6": _number(at_polynomial)},
        {"n6": total},
        verdict_of(total == printed.total_6),
        f"the printed polynomials give {gives}, ours is {abs(total - at_polynomial)} "
        f"{'fewer' if total < at_polynomial else 'more'}: see the rows above",
    )


def _unlisted(name: str, degree: int, words: str, newton_euler: Count) -> Row:
    """The row of a formulation of which nothing is printed."""
    at_6, ours = _counts(name, range(2, degree + 5))
    polynomials = ((kind, fit(figures, degree)) for kind, figures in ours.items())
    share = 100 * (at_6.total - newton_euler.total) / newton_euler.total
    return Row(
        f"{name}, total",
        {},
        {
            "n6": at_6.total,
            "mul_6": at_6.mul,
            "add_6": at_6.add,
            "polynomial": " and ".join(
                f"{polynomial_text(found)} {kind}" for kind, found in polynomials if found
            ),
        },
        None,
        f"the table has no row of it: {words}; {abs(share):.0f} % {'more' if share > 0 else 'fewer'} "
        "operations than Newton-Euler",
    )


def _printed(coefficients: Polynomial, at_6: int) -> dict[str, Any]:
    at_polynomial = _number(value(coefficients, JOINTS))
    return {"polynomial": polynomial_text(coefficients), "n6": at_6, "polynomial_at_6": at_polynomial}


def _number(x: Fraction) -> int | str:
    return x.numerator if x.denominator == 1 else str(x)


def _reason(
    row: str, coefficients: Polynomial, at_6: int, polynomial: Polynomial | None, reasons: Mapping[str, str]
) -> str:
    slip, given = "", value(coefficients, JOINTS)
    if given != at_6:
        slip = (
            f"the printed polynomial gives {given} for six joints, {abs(given - at_6)} from the {at_6} "
            "printed beside it; "
        )
    if polynomial is None:
        return slip + "our counts are no polynomial of that degree"
    if polynomial == coefficients:
        return slip + "the same polynomial"
    apart = polynomial_text(difference(coefficients, polynomial))
    explained = reasons.get(f"{row}: {apart}", "this difference is not the one that is explained")
    return f"{slip}printed less ours is {apart}: {explained}"


# --- Lagrange's closed form by its parts ------------------------------------------------------------------


def pairs(n: int) -> int:
    """Joint and link, ``i <= p``."""
    return n * (n + 1) // 2


def triples(n: int) -> int:
    """Two joints and a link, ``i <= j <= p``."""
    return n * (n + 1) * (n + 2) // 6


@cache
def part_costs() -> dict[str, tuple[int, int]]:
    """Multiplications and additions of a full trace ``tr(X J Y^T)``, of a product of two full 4x4 matrices,
    and of a link's share ``m g^T (dW r)`` in the gravity of a joint."""
    ledger: dict[str, int] = {}

    def column() -> tuple[Any, ...]:
        return tuple(Tally(ledger) for _ in range(4))

    def full() -> Matrix:
        return tuple(column() for _ in range(4))

    costs = {}
    for name, run in (
        ("trace", lambda: weighed(full(), full(), full())),
        ("product", lambda: product(full(), full())),
        ("gravity", lambda: inner(column(), applied(full(), column())) * column()[0]),
    ):
        ledger.clear()
        run()
        costs[name] = ledger.get("mul", 0), ledger.get("add", 0)
    return costs


def uicker_kahn_by_parts(n: int) -> dict[str, Fraction]:
    """Multiplications and additions for ``n`` joints: two rates and a sum with every trace of D_ijk, one
    acceleration and a sum with every second trace of D_ij, ``n^2 - 2`` transforms beside the sum over
    ``i <= j <= p``, and gravity."""
    halved, products = Fraction(triples(n), 2), triples(n) + n * n - 2
    traces = pairs(n) ** 2  # three joints and a link, none of the joints beyond it
    totals = {}
    for k, (kind, rates, acceleration) in enumerate((("mul", 2, 1), ("add", 1, 1))):
        trace, matrix, weight = (part_costs()[name][k] for name in ("trace", "product", "gravity"))
        inertial = (trace + rates) * traces + (trace + acceleration) * halved
        totals[kind] = inertial + matrix * products + weight * pairs(n)
    return totals


def _parts_row(kind: str, coefficients: Polynomial, at_6: int) -> Row:
    polynomial = fit({n: uicker_kahn_by_parts(n)[kind] for n in range(1, 8)}, 4)
    same = polynomial == coefficients
    ours_at_6 = uicker_kahn_by_parts(JOINTS)[kind]
    reason = (
        "the convention: traces, 4x4 products and gravity shares, all full, each as often as the printed "
        "polynomial has it: for every i, j, k <= p, half of i <= j <= p, n^2 - 2 and i <= j <= p, i <= p"
    )
    if same:
        reason += "; reproduces the printed polynomial exactly"
    elif polynomial is not None:
        reason += f"; the printed polynomial has {polynomial_text(difference(coefficients, polynomial))} more"
        reason += ", where joining the three sums of a torque would take 2 n" if kind == "add" else ""
    if same and value(coefficients, JOINTS) != at_6:
        reason += f", and so {ours_at_6} for six joints, not the {at_6} printed"
    return Row(
        f"uicker_kahn, {kind}, by parts",
        _printed(coefficients, at_6),
        {"polynomial": polynomial and polynomial_text(polynomial), "n6": _number(ours_at_6)},
        verdict_of(same),
        reason,
    )
