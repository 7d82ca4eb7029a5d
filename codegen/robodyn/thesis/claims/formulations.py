"""Formulations, what they cost, and which steps of a recursion are saved (sections 1.2 and 2.2 to 2.4)."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import pairwise
from typing import Any, Final

from robodyn.counts import Count
from robodyn.counts.general import general_count
from robodyn.dynamics.equality import equals_recursion
from robodyn.dynamics.transforms import Matrix, product, summed, transposed
from robodyn.kernels.generate import Options, program
from robodyn.robot.bundled import bundled_names
from robodyn.schedule import Machine, Sparsity, solve, sparsity
from robodyn.schedule.cutting import cut
from robodyn.thesis import steps
from robodyn.thesis.claims import LINKS, PUMA, SMALL_PUMA, STANFORD, Arms, Outcome
from robodyn.thesis.polynomial import fit, value
from robodyn.thesis.printed import TABLE_1_1, TABLE_2_9, TABLE_4_4, TABLE_4_4_ZEROS, bundled
from robodyn.thesis.steps import Method, step_counts
from robodyn.thesis.tables.customised import plain
from robodyn.thesis.tables.formulations import formulation
from robodyn.thesis.tables.operations import joint_count

_FUNCTIONS: Final = ("inverse_dynamics", "gravity", "bias", "mass_matrix", "forward_dynamics")
_METHODS: Final[tuple[Method, ...]] = ("I", "II")


def _general(name: str, n: int = LINKS) -> Count:
    return general_count(formulation(name), n, dense=True)


def orders(_: Arms) -> Outcome:
    """The degree of each formulation's cost in the number of joints."""
    degrees = {}
    for name in ("lagrange", "lagrange_4x4", "lagrange_3x3", "newton_euler", "kane"):
        totals = {n: _general(name, n).total for n in range(2, 8)}
        degrees[name] = next((k for k in range(1, 5) if fit(totals, k) is not None), None)
    return degrees, list(degrees.values())[:4] == [4, 1, 1, 1]


def newton_euler_counts(_: Arms) -> Outcome:
    """The printed polynomials at six joints, and our recursion for any arm."""
    printed, count = TABLE_1_1["newton_euler"], _general("newton_euler")
    polynomials = [int(value(part, LINKS)) for part in (printed.mul, printed.add)]
    figures = {"polynomials": polynomials, "mul": count.mul, "add": count.add}
    return figures, polynomials == [count.mul, count.add] == [printed.mul_6, printed.add_6]


def savings(_: Arms) -> Outcome:
    """By what factor each change of Table 1.1 makes the dynamics cheaper."""
    factors = [a / b for a, b in pairwise(cost.total_6 for cost in TABLE_1_1.values())]
    names = ("by_recursion", "by_3x3", "by_newton_euler")
    figures = {name: round(factor, 1) for name, factor in zip(names, factors, strict=True)}
    return figures, factors[0] > factors[1] * factors[2]


def lagrange_is_newton_euler(_: Arms) -> Outcome:
    """Whether Lagrange's equations give what the Newton-Euler recursion gives, on fractions."""
    robot = bundled(SMALL_PUMA)
    equal = 0
    for name in _FUNCTIONS:
        made = program(robot, name, Options((name,), formulation="lagrange", optimize="none"))
        equal += equals_recursion(robot, name, made)
    return {"equal": equal, "of": len(_FUNCTIONS)}, equal == len(_FUNCTIONS)


def no_advantage(_: Arms) -> Outcome:
    """Kane's and Balafoutis's operations beside Newton-Euler's, on the PUMA and for any arm [%]."""
    names = ("newton_euler", "modified_newton_euler", "balafoutis", "kane")
    customised = {name: plain(bundled(PUMA), name).total for name in names}
    general = {name: _general(name).total for name in names}

    def more(totals: dict[str, int], name: str) -> float:
        return round(100 * (totals[name] / totals["newton_euler"] - 1), 1)

    apart = {
        name: {"customised_pct": more(customised, name), "general_pct": more(general, name)}
        for name in names[1:]
    }
    beside = customised["balafoutis"] - customised["modified_newton_euler"]
    return {"apart": apart, "balafoutis_beside_modified": beside}, None


def fewest(_: Arms) -> Outcome:
    """Operations of any six-joint arm by the linear recursions, ours."""
    totals = {name: _general(name).total for name in ("balafoutis", "modified_newton_euler", "newton_euler")}
    least_printed = min(TABLE_1_1, key=lambda name: TABLE_1_1[name].total_6)
    return totals, min(totals, key=totals.__getitem__) == least_printed == "newton_euler"


def sparse_vectors(_: Arms) -> Outcome:
    """Zeros among the components of the position vectors, and what they save the modified recursion."""
    stanford, puma = (sparsity(bundled(name)) for name in (STANFORD, PUMA))
    stanford_of, puma_of = 6 * len(stanford.s), 6 * len(puma.s) - 3  # Table 2.5 has no s of link 1
    puma_zeros = puma_of - sum(map(len, (*puma.s, *puma.p)))
    figures = {
        "stanford_zeros": stanford.zeros,
        "stanford_of": stanford_of,
        "puma_zeros": puma_zeros,
        "puma_of": puma_of,
        "any_arm": _general("modified_newton_euler").total,
        "puma": plain(bundled(PUMA)).total,
    }
    return figures, 2 * stanford.zeros > stanford_of and 2 * puma_zeros > puma_of


def zeros_of_stanford(_: Arms) -> Outcome:
    """Zeros of the Stanford arm's vectors by Table 2.7."""
    zeros = sparsity(bundled(STANFORD)).zeros
    return {"zeros": zeros, "of": TABLE_4_4_ZEROS[1]}, zeros == TABLE_4_4_ZEROS[0]


def one_axis(_: Arms) -> Outcome:
    """Vectors that are not zero, and those of them along one axis."""
    patterns: dict[str, Sparsity] = {name: sparsity(bundled(name)) for name in (STANFORD, PUMA)}
    figures: dict[str, Any] = {}
    for name, pattern in {**patterns, "stanford_printed": TABLE_4_4}.items():
        axes = [vector for vector in (*pattern.s, *pattern.p) if vector]
        figures |= {name: sum(len(vector) == 1 for vector in axes), f"{name}_of": len(axes)}
    return figures, 2 * figures["stanford_printed"] > figures["stanford_printed_of"]


def concurrency_of_formulations(_: Arms) -> Outcome:
    """Levels and longest chains of single operations of three joints on six processors."""
    robot = bundled(SMALL_PUMA)
    figures = {}
    for name in ("newton_euler", "lagrange", "modified_newton_euler"):
        options = Options(("inverse_dynamics",), formulation=name)
        graph = cut(program(robot, "inverse_dynamics", options), 1).graph
        levels = solve(graph, Machine(LINKS), "critical-path").timetable.levels
        figures[name] = {"levels": levels, "chain": graph.critical_path}
    first, second = figures["newton_euler"], figures["lagrange"]
    return figures, all(first[key] < second[key] for key in first)


# --- steps of the recursion -------------------------------------------------------------------------------


def _pairs(step: str) -> tuple[dict[str, list[int]], bool]:
    """Operations of a step by both methods, and whether Table 2.9 has them so."""
    counts = ((method, step_counts(method, revolute=True)[step]) for method in _METHODS)
    pairs: dict[str, list[int]] = {method: [count.mul, count.add] for method, count in counts}
    return pairs, all(list(TABLE_2_9[f"revolute_{method}"][step]) == pair for method, pair in pairs.items())


def coriolis(_: Arms) -> Outcome:
    """The step that forms alpha, by both methods."""
    pairs, same = _pairs("alpha")
    fewer = [b - a for a, b in zip(pairs["I"], pairs["II"], strict=True)]
    return {**pairs, "fewer": fewer}, same


def gyroscopic(_: Arms) -> Outcome:
    """The step that forms N, by both methods; method I's tensors are diagonal, method II's full."""
    pairs, same = _pairs("N")
    return {**pairs, "fewer": sum(pairs["II"]) - sum(pairs["I"])}, same


def prismatic_lambda(_: Arms) -> Outcome:
    """Operations that lambda takes behind a prismatic joint whose R is right-angled, and any other R."""
    right = step_counts("I", revolute=False, rotation="right-angled")["lambda"].total
    other = step_counts("I", revolute=False, rotation="full")["lambda"].total
    return {"right_angled": right, "any_other": other}, right == 0


def turned_lambda(_: Arms) -> Outcome:
    """Which entries of ``R lambda R^T`` and of ``R^T lambda R`` are not those of the next link's lambda.

    Lambda is ``[alpha]x + [w]x [w]x``, formed of ``w`` and ``alpha`` here and of ``R^T w`` and ``R^T alpha``
    there; R is that of the Stanford arm's joint 3.
    """
    R: Matrix = ((1, 0, 0), (0, 0, -1), (0, 1, 0))
    w, alpha = (Fraction(2), Fraction(3), Fraction(5)), (Fraction(7), Fraction(11), Fraction(13))

    def skew(u: Iterable[Any]) -> Matrix:
        x, y, z = u
        return ((0, -z, y), (z, 0, -x), (-y, x, 0))

    before, after = (
        summed(skew(alpha), product(skew(w), skew(w)))
        for w, alpha in ((w, alpha), (steps.turned_back(R, w), steps.turned_back(R, alpha)))
    )

    def wrong(matrix: Matrix) -> list[str]:
        return [f"{i + 1}{j + 1}" for i in range(3) for j in range(3) if matrix[i][j] != after[i][j]]

    as_printed = wrong(product(product(R, before), transposed(R)))
    the_other_way = wrong(product(product(transposed(R), before), R))
    return {"wrong_as_printed": as_printed, "wrong_the_other_way": the_other_way}, not as_printed


def principal_axes(_: Arms) -> Outcome:
    """Bundled robots with products of inertia."""
    names = bundled_names()
    oblique = [
        robot
        for robot in map(bundled, names)
        if any(any((link.inertia.xy, link.inertia.xz, link.inertia.yz)) for link in robot.links)
    ]
    invented = sum(robot.links[0].origins.inertia == "synthetic" for robot in oblique)
    return {"with_products": len(oblique), "of": len(names), "invented": invented}, None


def backward_recursion(_: Arms) -> Outcome:
    """The operations of the backward steps but N, by both methods, carried out and printed; the methods
    divide f and f_rotated otherwise."""
    figures: dict[str, list[int]] = {}
    forces = []
    for method in _METHODS:
        counts = step_counts(method, revolute=True)
        figures[method] = [counts["n"].mul, counts["n"].add]
        figures[f"printed_{method}"] = list(TABLE_2_9[f"revolute_{method}"]["n"])
        forces.append((counts["f"].mul + counts["f_rotated"].mul, counts["f"].add + counts["f_rotated"].add))
    return figures, figures["I"] == figures["II"] and forces[0] == forces[1]


def joint_totals(_: Arms) -> Outcome:
    """A joint's operations by both methods: printed sums, sums of the printed columns, ours."""
    figures: dict[str, Any] = {}
    for kind in ("revolute", "prismatic"):
        for method in _METHODS:
            column = TABLE_2_9[f"{kind}_{method}"]
            added = sum(sum(pair) for step, pair in column.items() if step != "total")
            ours = joint_count(method, kind == "revolute").total
            figures[f"{kind}_{method}"] = {"printed": sum(column["total"]), "column": added, "ours": ours}
    return figures, all(len(set(one.values())) == 1 for one in figures.values())


def lambda_form(arms: Arms) -> Outcome:
    """The share of a joint's operations that the lambda matrix saves [%]: by the printed totals, by the right
    sum of the printed column, and ours."""
    totals, _ = joint_totals(arms)

    def saved(kind: str, key: str) -> float:
        share: float = 1 - totals[f"{kind}_I"][key] / totals[f"{kind}_II"][key]
        return round(100 * share, 1)

    pairs, _ = _pairs("N")
    ours = {kind: saved(kind, "ours") for kind in ("revolute", "prismatic")}
    figures = {
        **ours,
        "by_printed_totals": [saved(kind, "printed") for kind in ours],
        "by_the_right_sum": saved("revolute", "column"),
        "by_full_tensors": sum(pairs["II"]) - sum(pairs["I"]),
    }
    return figures, all(30 <= share <= 40 for share in ours.values())
