"""Operations of customised inverse dynamics: Table 2.10, the thesis's and those that it quotes, and all
bundled robots, by level of optimisation and beside other tools."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

from robodyn.counts import Count, count
from robodyn.counts.thesis import TABLE_2_10, beside
from robodyn.kernels.generate import Options, program
from robodyn.kernels.options import Level
from robodyn.robot import Robot, bundled_names
from robodyn.thesis.printed import LISTINGS, METHODS, OPENSYMORO, PEERS, Pair, bundled, table_2_10
from robodyn.thesis.tables.table import (
    Row,
    Verdict,
    count_data,
    difference_in_words,
    pair,
    verdict_of,
    words_of,
)

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
        ours = {"none": count_data(plain(robot)), "default": count_data(optimised(robot))}
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
            method_count = {"method": None if run is None else count_data(run)}
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
    reasons = words_of("2.10")["reasons"]
    figures: dict[str, Any] = {"theirs": METHODS[method]}
    if run is None:
        doubt = ""
        if (row, method) == ("puma_6", "II"):
            more = 100 * (sum(printed) / sum(others["I"]) - 1)
            doubt = reasons["doubtful"].format(total=sum(printed), five=others["V"][0], more=more)
        return "not recoverable", doubt + reasons["quoted"].format_map(figures)
    if (run.mul, run.add) == printed:
        return "reproduced", reasons["same"]
    figures |= {"apart": difference_in_words(printed, run), "printed": TABLE_2_10[row][2]}
    return "differs", reasons[method].format_map(figures)


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
                "none": count_data(plain(robot)),
                "fast": count_data(optimised(robot, "fast")),
                "default": count_data(record),
                "opensymoro": None if peer is None else peer.total,
            },
            None if printed is None else verdict_of(printed.verdict == "reproduced"),
            "" if printed is None else f"Table {printed.table}, {printed.row}, of which: {printed.note}",
            tuple(one.to_dict() for one in peers if one is not peer or one.mul is not None),
        )
