"""Puts the operations of the arms of examples/arms into the table of their README.

    python -m benchmarks.arms
    python -m benchmarks.arms --records      and before that: their records, from arms that are built alike

Records are of the arms without friction, which is put on top: an arm of the same make has the same record.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from pathlib import Path

from benchmarks.marked import with_part

from robodyn import Options, count, load, program
from robodyn.counts.objective import Objective
from robodyn.formats.writers.parts import parts_of
from robodyn.optimize.records import Record
from robodyn.optimize.records.find import records_of_arms
from robodyn.optimize.records.validation import frictionless
from robodyn.search.improve import cost, proved, write_record
from robodyn.search.transfer import transferred

FOLDER = Path(__file__).parents[1] / "examples" / "arms"
FUNCTIONS = ("inverse_dynamics", "gravity", "mass_matrix", "forward_dynamics")
RECORDED = ("inverse_dynamics", "mass_matrix")
HOW = "robodyn --optimize search, from the record of an arm that is built alike"
#: [s] For the records of one function of one arm.
BUDGET = 300.0
MARK = "operations"


def row(path: Path) -> str:
    """The table's row of one arm: joints, mass that they carry, operations of some functions."""
    robot = load(path)
    mass = sum(joint.body.mass for joint in parts_of(robot).joints)
    figures = [str(count(robot, function).total) for function in FUNCTIONS]
    return f"| {path.stem} | {robot.n} | {mass:.2f} | {' | '.join(figures)} |"


def table() -> str:
    """The table of all arms."""
    head = "| arm | joints | kg | " + " | ".join(name.replace("_", " ") for name in FUNCTIONS) + " |"
    rows = map(row, sorted(FOLDER.glob("*.yaml")))
    return "\n".join([head, "|---" + "|---:" * (2 + len(FUNCTIONS)) + "|", *rows, ""])


def records() -> Iterator[Record]:
    """The records of all arms that are built like bundled ones, without friction."""
    for path in sorted(FOLDER.glob("*.yaml")):
        robot = frictionless(load(path))
        for function in RECORDED:
            fast = program(robot, function, Options((function,), optimize="fast"))
            programs = [fast, *transferred(robot, function, time.monotonic() + BUDGET)]
            best = min(programs, key=lambda each: cost(each, Objective()))
            if best is not fast and (record := proved(robot, function, best, fast, Objective(), HOW)):
                yield record


def main() -> int:
    """Write the table, and before that, if asked for, the records."""
    if "--records" in sys.argv[1:]:
        for record in records():
            print(write_record(record, records_of_arms()).name)
    readme = FOLDER / "README.md"
    readme.write_text(with_part(readme.read_text(encoding="utf-8"), MARK, table()), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
