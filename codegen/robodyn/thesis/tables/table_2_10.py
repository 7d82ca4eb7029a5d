"""Table 2.10: operations of customised inverse dynamics, the thesis's and those that it quotes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from robodyn.counts import Count, count
from robodyn.counts.thesis import TABLE_2_10
from robodyn.kernels.generate import Options, program
from robodyn.robot import Robot, load
from robodyn.thesis.other_tools import PEERS
from robodyn.thesis.printed_counts import LISTINGS, METHODS, Pair, table_2_10
from robodyn.thesis.tables.table import Column, Progress, Row, Table, Verdict, apart, counted, pair

#: The robot with the numbers that the thesis's program used, by row of the table.
ROBOTS: Final = {
    "puma_3": "puma560_3dof_d3",
    "stanford_3": "stanford_3dof_d3",
    "puma_6": "puma560_d2",
    "stanford_6": "stanford_d3",
}

Load = Callable[[str], Robot]
_INVERSE: Final = ("inverse_dynamics",)

_LIKE: Final = {
    "IV": "the Newton-Euler recursion on base parameters, and what else fast has",
    "VI": "Balafoutis's recursion as robodyn has it, not optimised",
}

DOUBTFUL: Final = (
    "DOUBTFUL as printed: 152 multiplications are the 152 additions of method I, the only place with fewer "
    "multiplications than additions, and {total} in all are the {five} multiplications of method V; the text "
    "says some 30 % more than method I, this is {share:.0f} % more"
)


def load_quietly(name: str) -> Robot:
    """A bundled robot; doubts about its numbers belong to ``gen``."""
    return load(name, warn=lambda _: None)


def best(robot: Robot) -> Count:
    """Ours as ``robodyn gen`` writes it."""
    return count(program(robot, "inverse_dynamics", Options(_INVERSE)))


def plain(robot: Robot, formulation: str = "modified_newton_euler") -> Count:
    """Ours as the recursion stands in the book: equal terms merged, zeros gone, nothing else."""
    return count(
        program(robot, "inverse_dynamics", Options(_INVERSE, formulation=formulation, optimize="none"))
    )


def table(progress: Progress = lambda _: None, load_robot: Load = load_quietly) -> Table:
    """Every printed figure beside ours for the same robot."""
    rows: list[Row] = []
    for row, printed in table_2_10().items():
        progress(row)
        rows += _rows(row, printed, load_robot(ROBOTS[row]))
    return Table(
        "2.10",
        "operations of customised inverse dynamics by method: I the thesis, II to VI as it quotes them",
        (
            Column("printed", "printed", "operations"),
            Column("ours by it", "ours", "method"),
            Column("none", "ours", "none"),
            Column("default", "ours", "default"),
        ),
        tuple(rows),
        (
            "Multiplications/additions = total. Ours is counted on programs for the same robot, with the "
            "numbers that the thesis's programs used: none is the recursion with the lambda matrix as the "
            "book has it, default what robodyn gen writes. Ours by the method is none for I, for IV fast, "
            "which begins with the base parameters of Gautier and Khalil, and for VI Balafoutis's recursion, "
            "not optimised. Methods: "
            + ", ".join(f"{amount} {who}" for amount, who in METHODS.items())
            + ".",
        ),
    )


def _rows(row: str, printed: dict[str, Pair], robot: Robot) -> list[Row]:
    ours = {"none": counted(plain(robot)), "default": counted(best(robot))}
    rows = []
    for method, figure in printed.items():
        run = _run(method, robot)
        verdict, reason = _verdict(row, method, figure, run, printed)
        peers: tuple[dict[str, Any], ...] = ()
        if method == "I":
            as_printed, completed = LISTINGS[row]
            peers = (
                {"what": "lines of the thesis's listing as printed", **pair(*as_printed)},
                {"what": "the listing completed", **pair(*completed)},
                *(peer.to_dict() for peer in PEERS[robot.name]),
            )
        rows.append(
            Row(
                f"{row}, {method}",
                {"operations": pair(*figure)},
                {"method": None if run is None else counted(run), **ours},
                verdict,
                reason,
                peers,
            )
        )
    return rows


def _run(method: str, robot: Robot) -> Count | None:
    """Ours by the same method, where we have it."""
    if method == "I":
        return plain(robot)
    if method == "IV":
        return count(program(robot, "inverse_dynamics", Options(_INVERSE, optimize="fast")))
    return plain(robot, "balafoutis") if method == "VI" else None


def _verdict(
    row: str, method: str, printed: Pair, run: Count | None, others: dict[str, Pair]
) -> tuple[Verdict, str]:
    doubt = ""
    if (row, method) == ("puma_6", "II"):
        total, own = sum(printed), sum(others["I"])
        doubt = DOUBTFUL.format(total=total, five=others["V"][0], share=100 * (total / own - 1)) + "; "
    if run is None:
        return "not recoverable", (
            f"{doubt}{METHODS[method]}'s program is not in the thesis, which quotes its counts; ours for the "
            "same robot stands beside it"
        )
    if (run.mul, run.add) == printed:
        return "reproduced", "our program of this method takes as many"
    apart_by = apart(printed, (run.mul, run.add))
    if method == "I":
        return "differs", (
            f"{apart_by}: ours keeps the lambda_1 p_1 term and all of the joint variables, and has nothing "
            f"that is not needed; of the printed figure: {TABLE_2_10[row][2]}"
        )
    return "differs", (
        f"{apart_by}: {METHODS[method]}'s program and parameters are not in the thesis; ours is "
        f"{_LIKE[method]}, "
        "on the numbers of the thesis's own program"
    )
