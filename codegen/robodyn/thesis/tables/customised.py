"""Operations of customised inverse dynamics: Table 2.10, the thesis's and those that it quotes, and all
bundled robots, by level of optimisation and beside other tools."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

from robodyn.counts import Count, beside, count
from robodyn.counts.thesis import TABLE_2_10
from robodyn.kernels.generate import Options, program
from robodyn.kernels.options import Level
from robodyn.robot import Robot, bundled_names
from robodyn.thesis.printed import LISTINGS, METHODS, OPENSYMORO, PEERS, Pair, bundled, table_2_10
from robodyn.thesis.tables.table import Row, Verdict, apart, counted, judged, pair

#: The robot with the numbers that the thesis's program used, by row of the table.
ROBOTS: Final = {
    "puma_3": "puma560_3dof_d3",
    "stanford_3": "stanford_3dof_d3",
    "puma_6": "puma560_d2",
    "stanford_6": "stanford_d3",
}


def optimised(robot: Robot, level: Level = "record") -> Count:
    """Ours as ``robodyn gen`` writes it, or by another level of optimisation."""
    return count(program(robot, "inverse_dynamics", Options(("inverse_dynamics",), optimize=level)))


def plain(robot: Robot, formulation: str = "modified_newton_euler") -> Count:
    """Ours as the recursion stands in the book: equal terms merged, zeros gone, nothing else."""
    options = Options(("inverse_dynamics",), formulation=formulation, optimize="none")
    return count(program(robot, "inverse_dynamics", options))


# --- 2.10 -------------------------------------------------------------------------------------------------


def rows_of_table_2_10() -> Iterator[Row]:
    """Every printed figure beside ours for the same robot."""
    for row, printed in table_2_10().items():
        robot = bundled(ROBOTS[row])
        ours = {"none": counted(plain(robot)), "default": counted(optimised(robot))}
        for method, figure in printed.items():
            run = _run(method, robot)
            verdict, reason = _verdict(row, method, figure, run, printed)
            peers: tuple[Mapping[str, Any], ...] = ()
            if method == "I":
                as_printed, completed = LISTINGS[row]
                peers = (
                    {"what": "lines of the thesis's listing as printed", **pair(*as_printed)},
                    {"what": "the listing completed", **pair(*completed)},
                    *(peer.to_dict() for peer in PEERS[robot.name]),
                )
            method_count = {"method": None if run is None else counted(run)}
            yield Row(
                f"{row}, {method}", {"operations": pair(*figure)}, {**method_count, **ours}, verdict, reason,
                peers,
            )  # fmt: skip


def _run(method: str, robot: Robot) -> Count | None:
    """Ours by the same method, where we have it."""
    if method == "IV":
        return optimised(robot, "fast")
    names = {"I": "modified_newton_euler", "VI": "balafoutis"}
    return plain(robot, names[method]) if method in names else None


def _verdict(
    row: str, method: str, printed: Pair, run: Count | None, others: Mapping[str, Pair]
) -> tuple[Verdict, str]:
    theirs = f"{METHODS[method]}'s program"
    if run is None:
        doubt = ""
        if (row, method) == ("puma_6", "II"):
            total = sum(printed)
            doubt = (
                "DOUBTFUL as printed: 152 multiplications are the 152 additions of method I, the only place "
                f"with fewer multiplications than additions, and {total} in all are the {others['V'][0]} "
                "multiplications of method V; the text says some 30 % more than method I, this is "
                f"{100 * (total / sum(others['I']) - 1):.0f} % more; "
            )
        return "not recoverable", (
            f"{doubt}{theirs} is not in the thesis, which quotes its counts; ours for the same robot stands "
            "beside it"
        )
    if (run.mul, run.add) == printed:
        return "reproduced", "our program of this method takes as many"
    if method == "I":
        return "differs", (
            f"{apart(printed, run)}: ours keeps the lambda_1 p_1 term and all of the joint variables, and "
            f"has nothing that is not needed; of the printed figure: {TABLE_2_10[row][2]}"
        )
    like = {
        "IV": "the Newton-Euler recursion on base parameters, and what else fast has",
        "VI": "Balafoutis's recursion as robodyn has it, not optimised",
    }
    return "differs", (
        f"{apart(printed, run)}: {theirs} and parameters are not in the thesis; ours is {like[method]}, on "
        "the numbers of the thesis's own program"
    )


# --- all robots -------------------------------------------------------------------------------------------


def table_of_robots() -> Iterator[Row]:
    """A row for every bundled robot, by name."""
    for name in bundled_names():
        robot, peers = bundled(name), PEERS.get(name, ())
        record = optimised(robot)
        printed = beside(robot, "inverse_dynamics", record)
        peer = next((peer for peer in peers if peer.tool == OPENSYMORO), None)
        yield Row(
            name,
            {} if printed is None else pair(printed.mul, printed.add),
            {
                "joints": "".join(link.joint.kind[0].upper() for link in robot.links),
                "none": counted(plain(robot)),
                "fast": counted(optimised(robot, "fast")),
                "default": counted(record),
                "opensymoro": None if peer is None else peer.total,
            },
            None if printed is None else judged(printed.verdict == "reproduced"),
            "" if printed is None else f"Table {printed.table}, {printed.row}, of which: {printed.note}",
            tuple(one.to_dict() for one in peers if one is not peer or one.mul is not None),
        )
