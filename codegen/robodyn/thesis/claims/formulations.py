"""Formulations, what they cost, and which steps of a recursion are saved (sections 1.2 and 2.2 to 2.4)."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any, Final

from robodyn.counts.general import general_count
from robodyn.dynamics.equality import equals_recursion
from robodyn.dynamics.transforms import product, transposed
from robodyn.kernels.generate import Options, program
from robodyn.robot.bundled import bundled_names
from robodyn.schedule import Machine, Sparsity, solve, sparsity
from robodyn.schedule.cutting import cut
from robodyn.thesis import method_steps as steps
from robodyn.thesis.claims.arms import LINKS, PUMA, STANFORD, Arms
from robodyn.thesis.claims.claim import Outcome
from robodyn.thesis.method_steps import Method
from robodyn.thesis.polynomial import fitted, value
from robodyn.thesis.printed_counts import TABLE_1_1, TABLE_2_9, Pair
from robodyn.thesis.printed_tasks import TABLE_4_4, TABLE_4_4_ZEROS
from robodyn.thesis.steps import step_counts
from robodyn.thesis.tables import table_2_9
from robodyn.thesis.tables.table import summed
from robodyn.thesis.tables.table_1_1 import formulation
from robodyn.thesis.tables.table_2_10 import plain

#: The bundled arm of three joints on which formulations are held to each other.
SMALL_PUMA: Final = "puma560_3dof_d12"
_FUNCTIONS: Final = ("inverse_dynamics", "gravity", "bias", "mass_matrix", "forward_dynamics")
_INVERSE: Final = ("inverse_dynamics",)
_METHODS: Final[tuple[Method, ...]] = ("I", "II")


def orders(_: Arms) -> Outcome:
    """The degree of each formulation's cost in the number of joints."""
    names = ("lagrange", "lagrange_4x4", "lagrange_3x3", "newton_euler", "kane")
    degrees = {name: _degree(name) for name in names}
    return degrees, [degrees[name] for name in names[:4]] == [4, 1, 1, 1]


def _degree(name: str) -> int | None:
    totals = {n: general_count(formulation(name), n, dense=True).total for n in range(2, 8)}
    return next((degree for degree in range(1, 5) if fitted(totals, degree) is not None), None)


def newton_euler_counts(_: Arms) -> Outcome:
    """The printed polynomials at six joints, and our recursion for any arm."""
    printed = TABLE_1_1["newton_euler"]
    polynomials = [int(value(part, LINKS)) for part in (printed.mul, printed.add)]
    count = general_count(formulation("newton_euler"), LINKS, dense=True)
    figures = {"polynomials": polynomials, "mul": count.mul, "add": count.add}
    return figures, polynomials == [count.mul, count.add] == [printed.mul_6, printed.add_6]


def savings(_: Arms) -> Outcome:
    """By what factor each change of Table 1.1 makes the dynamics cheaper."""
    totals = [cost.total_6 for cost in TABLE_1_1.values()]
    by_recursion, by_size, by_vectors = (a / b for a, b in pairwise(totals))
    figures = {
        "by_recursion": round(by_recursion, 1),
        "by_3x3": round(by_size, 1),
        "by_newton_euler": round(by_vectors, 1),
    }
    return figures, by_recursion > by_size * by_vectors


def lagrange_is_newton_euler(arms: Arms) -> Outcome:
    """Whether Lagrange's equations give what the Newton-Euler recursion gives, on fractions."""
    robot = arms.load_robot(SMALL_PUMA)
    equal = [
        name
        for name in _FUNCTIONS
        if equals_recursion(
            robot,
            name,
            program(robot, name, Options((name,), formulation="lagrange", optimize="none")),
        )
    ]
    return {"equal": len(equal), "of": len(_FUNCTIONS)}, len(equal) == len(_FUNCTIONS)


def no_advantage(arms: Arms) -> Outcome:
    """Kane's and Balafoutis's operations beside Newton-Euler's, on the PUMA and for any arm [%]."""
    robot = arms.load_robot(PUMA)
    names = ("newton_euler", "modified_newton_euler", "balafoutis", "kane")
    customised = {name: plain(robot, name).total for name in names}
    general = {name: general_count(formulation(name), LINKS, dense=True).total for name in names}
    apart = {
        name: {
            "customised_pct": round(100 * (customised[name] / customised["newton_euler"] - 1), 1),
            "general_pct": round(100 * (general[name] / general["newton_euler"] - 1), 1),
        }
        for name in names[1:]
    }
    figures = {
        "operations": customised,
        "operations_of_any_arm": general,
        "apart": apart,
        "balafoutis_beside_modified": customised["balafoutis"] - customised["modified_newton_euler"],
    }
    return figures, None


def fewest(_: Arms) -> Outcome:
    """Operations of any six-joint arm by the linear recursions, ours."""
    names = ("balafoutis", "modified_newton_euler", "newton_euler")
    totals = {name: general_count(formulation(name), LINKS, dense=True).total for name in names}
    totals_printed = {name: cost.total_6 for name, cost in TABLE_1_1.items()}
    least_printed = min(totals_printed, key=totals_printed.__getitem__)
    figures = {**totals, "least_of_table_1_1": least_printed}
    return figures, min(totals, key=totals.__getitem__) == least_printed == "newton_euler"


def sparse_vectors(arms: Arms) -> Outcome:
    """Zeros among the components of the position vectors, and what they save the modified recursion."""
    stanford, puma = (sparsity(arms.load_robot(name)) for name in (STANFORD, PUMA))
    of = _components(puma)
    figures = {
        "stanford_zeros": stanford.zeros,
        "stanford_of": 6 * len(stanford.s),
        "puma_zeros": of - sum(map(len, (*puma.s, *puma.p))),
        "puma_of": of,
        "any_arm": general_count(formulation("modified_newton_euler"), LINKS, dense=True).total,
        "puma": plain(arms.load_robot(PUMA)).total,
    }
    mostly = 2 * stanford.zeros > figures["stanford_of"] and 2 * figures["puma_zeros"] > of
    return figures, mostly


def _components(puma: Sparsity) -> int:
    """Components of the PUMA's vectors that the tables have: Table 2.5 has no centre of mass of link 1."""
    return 6 * len(puma.s) - 3


def zeros_of_stanford(arms: Arms) -> Outcome:
    """Zeros of the Stanford arm's vectors by Table 2.7."""
    zeros = sparsity(arms.load_robot(STANFORD)).zeros
    return {"zeros": zeros, "of": TABLE_4_4_ZEROS[1]}, zeros == TABLE_4_4_ZEROS[0]


def one_axis(arms: Arms) -> Outcome:
    """Vectors that are not zero, and those of them along one axis."""
    robots = {name: sparsity(arms.load_robot(name)) for name in (STANFORD, PUMA)}
    counts = {
        name: _along_one_axis(pattern) for name, pattern in {**robots, "stanford_printed": TABLE_4_4}.items()
    }
    figures: dict[str, Any] = {}
    for name, (along, present) in counts.items():
        figures |= {name: along, f"{name}_of": present}
    return figures, 2 * figures["stanford_printed"] > figures["stanford_printed_of"]


def _along_one_axis(pattern: Sparsity) -> tuple[int, int]:
    axes = [vector for vector in (*pattern.s, *pattern.p) if vector]
    return sum(len(vector) == 1 for vector in axes), len(axes)


def concurrency_of_formulations(arms: Arms) -> Outcome:
    """Levels and longest chains of single operations of three joints on six processors."""
    robot = arms.load_robot(SMALL_PUMA)
    figures = {}
    for name in ("newton_euler", "lagrange", "modified_newton_euler"):
        graph = cut(program(robot, "inverse_dynamics", Options(_INVERSE, formulation=name)), 1).graph
        levels = solve(graph, Machine(LINKS), "critical-path").timetable.levels
        figures[name] = {"levels": levels, "chain": graph.critical_path}
    first, second = figures["newton_euler"], figures["lagrange"]
    return figures, all(first[key] < second[key] for key in first)


# --- steps of the recursion -------------------------------------------------------------------------------


def _pairs(step: str) -> dict[str, list[int]]:
    counts = {method: step_counts(method, revolute=True)[step] for method in _METHODS}
    return {method: [count.mul, count.add] for method, count in counts.items()}


def coriolis(_: Arms) -> Outcome:
    """The step that forms alpha, by both methods."""
    pairs = _pairs("alpha")
    fewer = [b - a for a, b in zip(pairs["I"], pairs["II"], strict=True)]
    same = all(tuple(pairs[method]) == TABLE_2_9[f"revolute_{method}"]["alpha"] for method in _METHODS)
    return {**pairs, "fewer": fewer}, same


def prismatic_lambda(_: Arms) -> Outcome:
    """Operations that lambda takes behind a prismatic joint whose R is right-angled, and any other R."""
    right, other = (
        step_counts("I", revolute=False, rotation=rotation)["lambda"].total
        for rotation in ("right-angled", "full")
    )
    return {"right_angled": right, "any_other": other}, right == 0


def turned_lambda(_: Arms) -> Outcome:
    """Which entries of ``R lambda R^T`` and of ``R^T lambda R`` are not those of the next link's lambda.

    Lambda is ``[alpha]x + [w]x [w]x``, formed of ``w`` and ``alpha`` here and of ``R^T w`` and ``R^T alpha``
    there; R is that of the Stanford arm's joint 3.
    """
    R = ((Fraction(1), Fraction(0), Fraction(0)), (Fraction(0), Fraction(0), Fraction(-1)),
         (Fraction(0), Fraction(1), Fraction(0)))  # fmt: skip
    w, alpha = (Fraction(2), Fraction(3), Fraction(5)), (Fraction(7), Fraction(11), Fraction(13))
    before, after = _lambda(w, alpha), _lambda(steps.turned_back(R, w), steps.turned_back(R, alpha))
    as_printed = product(product(R, before), transposed(R))
    the_other_way = product(product(transposed(R), before), R)

    def wrong(matrix: Any) -> list[str]:
        rows = enumerate(zip(matrix, after, strict=True), 1)
        return [f"{i}{j}" for i, (a, b) in rows for j in (1, 2, 3) if a[j - 1] != b[j - 1]]

    figures = {"wrong_as_printed": wrong(as_printed), "wrong_the_other_way": wrong(the_other_way)}
    return figures, not figures["wrong_as_printed"]


def _lambda(w: Any, alpha: Any) -> Any:
    def skew(u: Any) -> Any:
        x, y, z = u
        return ((0, -z, y), (z, 0, -x), (-y, x, 0))

    twice = product(skew(w), skew(w))
    return tuple(
        tuple(a + b for a, b in zip(*rows, strict=True)) for rows in zip(skew(alpha), twice, strict=True)
    )


def gyroscopic(_: Arms) -> Outcome:
    """The step that forms N, by both methods; method I's tensors are diagonal, method II's full."""
    pairs = _pairs("N")
    fewer = sum(pairs["II"]) - sum(pairs["I"])
    same = all(tuple(pairs[method]) == TABLE_2_9[f"revolute_{method}"]["N"] for method in _METHODS)
    return {**pairs, "fewer": fewer}, same


def principal_axes(arms: Arms) -> Outcome:
    """Bundled robots with products of inertia."""
    names = bundled_names()
    with_products = [
        name
        for name in names
        if any(
            product != 0
            for link in arms.load_robot(name).links
            for product in (link.inertia.xy, link.inertia.xz, link.inertia.yz)
        )
    ]
    origins = [arms.load_robot(name).links[0].origins.inertia for name in with_products]
    figures = {"with_products": len(with_products), "of": len(names), "invented": origins.count("synthetic")}
    return {**figures, "names": with_products}, None


def backward_recursion(_: Arms) -> Outcome:
    """The operations of the backward steps but N, by both methods, carried out and printed."""
    ours = {method: _backward(step_counts(method, revolute=True)) for method in _METHODS}
    printed = {method: _printed_backward(TABLE_2_9[f"revolute_{method}"]) for method in _METHODS}
    figures = {
        "I": ours["I"]["n"],
        "II": ours["II"]["n"],
        "printed_I": printed["I"],
        "printed_II": printed["II"],
    }
    same = all(ours["I"][key] == ours["II"][key] for key in ours["I"])
    return figures, same


def _backward(counts: Any) -> dict[str, list[int]]:
    """Force handed on (f and f_rotated together, which the methods divide otherwise) and moment."""
    force = summed(counts["f"], counts["f_rotated"])
    return {"f": [force.mul, force.add], "n": [counts["n"].mul, counts["n"].add]}


def _printed_backward(column: dict[str, Pair]) -> list[int]:
    return list(column["n"])


def joint_totals(_: Arms) -> Outcome:
    """A joint's operations by both methods: printed sums, sums of the printed columns, ours."""
    figures: dict[str, Any] = {}
    for kind in ("revolute", "prismatic"):
        for method in _METHODS:
            column = TABLE_2_9[f"{kind}_{method}"]
            added = sum(sum(pair) for step, pair in column.items() if step != "total")
            ours = summed(*table_2_9.counts(method, kind == "revolute").values()).total
            figures[f"{kind}_{method}"] = {"printed": sum(column["total"]), "column": added, "ours": ours}
    return figures, all(one["printed"] == one["column"] == one["ours"] for one in figures.values())


def lambda_form(_: Arms) -> Outcome:
    """The share of a joint's operations that the lambda matrix saves [%]: by the printed totals, by the right
    sum of the printed column, and ours."""
    totals, _holds = joint_totals(_)

    def saved(kind: str, key: str) -> float:
        share: float = 1 - totals[f"{kind}_I"][key] / totals[f"{kind}_II"][key]
        return round(100 * share, 1)

    shares = {
        kind: {key: saved(kind, key) for key in ("printed", "column", "ours")}
        for kind in ("revolute", "prismatic")
    }
    figures = {
        "revolute": shares["revolute"]["ours"],
        "prismatic": shares["prismatic"]["ours"],
        "by_printed_totals": [shares[kind]["printed"] for kind in shares],
        "by_the_right_sum": shares["revolute"]["column"],
        "by_full_tensors": sum(_pairs("N")["II"]) - sum(_pairs("N")["I"]),
    }
    return figures, all(30 <= share["ours"] <= 40 for share in shares.values())
