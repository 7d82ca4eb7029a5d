"""All bundled robots: our operations by level of optimisation, the thesis's, other tools'."""

from __future__ import annotations

from robodyn.counts import beside, count
from robodyn.kernels.generate import Options, program
from robodyn.robot import Robot, bundled_names
from robodyn.thesis.other_tools import OPENSYMORO, PEERS
from robodyn.thesis.tables.table import Column, Progress, Row, Table, Verdict, counted, pair
from robodyn.thesis.tables.table_2_10 import Load, best, load_quietly, plain


def table(progress: Progress = lambda _: None, load_robot: Load = load_quietly) -> Table:
    """A row for every bundled robot, by name."""
    rows = []
    for name in bundled_names():
        progress(name)
        rows.append(_row(load_robot(name)))
    return Table(
        "robots",
        "operations of the inverse dynamics of all bundled robots",
        (
            Column("joints", "ours", "joints"),
            Column("none", "ours", "none"),
            Column("fast", "ours", "fast"),
            Column("default", "ours", "default"),
            Column("OpenSYMORO", "ours", "opensymoro"),
            Column("thesis", "printed", "total"),
        ),
        tuple(rows),
        (
            "Multiplications/additions = total. none is the recursion with the lambda matrix as the book has "
            "it, fast what takes milliseconds, default what robodyn gen writes. OpenSYMORO is on base "
            "parameters, as robodyn's authors measured it with the same numbers and counting; the other "
            "tools "
            "are beside Table 2.10. Robots with _full in their names, rx90 and iiwa have full tensors of "
            "inertia; diagonal ones flatter.",
        ),
    )


def _row(robot: Robot) -> Row:
    record = best(robot)
    fast = count(program(robot, "inverse_dynamics", Options(("inverse_dynamics",), optimize="fast")))
    printed = beside(robot, "inverse_dynamics", record)
    peer = next((p for p in PEERS.get(robot.name, ()) if p.tool == OPENSYMORO), None)
    verdict: Verdict | None = None
    reason = ""
    if printed is not None:
        verdict = "reproduced" if printed.verdict == "reproduced" else "differs"
        reason = f"Table {printed.table}, {printed.row}, of which: {printed.note}"
    return Row(
        robot.name,
        {} if printed is None else pair(printed.mul, printed.add),
        {
            "joints": "".join(link.joint.kind[0].upper() for link in robot.links),
            "none": counted(plain(robot)),
            "fast": counted(fast),
            "default": counted(record),
            "opensymoro": None if peer is None else peer.total,
        },
        verdict,
        reason,
        tuple(p.to_dict() for p in PEERS.get(robot.name, ()) if p is not peer or p.mul is not None),
    )
