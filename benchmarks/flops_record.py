"""The shipped records, proved; and what ``fast`` takes for every bundled robot, held to what is committed.

    python benchmarks/flops_record.py            recompute, compare, fail where anything got worse
    python benchmarks/flops_record.py --update   and write the new figures

The committed programs (robots/records/) are read and proved equal to the plain recursion on exact fractions.
What ``fast`` takes is committed in robots/records/counts.csv; what the kernels with records take is in
robodyn.lock, which ``robodyn build --check`` holds them to.
"""

from __future__ import annotations

import argparse
import csv
import io
import sys
import warnings
from pathlib import Path

from robodyn.counts import count
from robodyn.dynamics.equality import equals_recursion
from robodyn.kernels.generate import Options, program
from robodyn.optimize.records import Record, best_record, bundled_records, parse_record
from robodyn.optimize.records.find import records_of_arms
from robodyn.optimize.records.validation import frictionless
from robodyn.robot import Robot, bundled_names, load
from robodyn.robot.identity import identity

ARMS = Path(__file__).parents[1] / "examples" / "arms"
COUNTS = bundled_records() / "counts.csv"
FIELDS = ("robot", "function", "mul", "add", "total", "sincos")
Row = dict[str, str]


def recomputed() -> list[Row]:
    """What ``fast`` takes for every bundled robot's functions."""
    rows = []
    for name in bundled_names():
        robot = load(name, warn=lambda text: None)
        for function in ("inverse_dynamics", "gravity", "bias", "mass_matrix"):
            fast = count(program(robot, function, Options((function,), optimize="fast")))
            numbers = (fast.mul + fast.div, fast.add, fast.total, fast.sincos)
            rows.append(dict(zip(FIELDS, (name, function, *map(str, numbers)), strict=True)))
        print(f"{name}: counted", file=sys.stderr)
    return rows


def unproved() -> list[str]:
    """Records that do not equal the recursion on fractions, or that no bundled robot has."""
    faults = []
    robots = {
        identity(robot): robot for robot in (load(name, warn=lambda text: None) for name in bundled_names())
    }
    for arm in sorted(ARMS.glob("*.yaml")):
        bare = frictionless(load(arm))
        robots.setdefault(identity(bare), bare)
    for path in sorted([*bundled_records().glob("*.record"), *records_of_arms().glob("*.record")]):
        record = parse_record(path.read_text(encoding="utf-8"), str(path))
        robot = robots.get(record.identity)
        if robot is None:
            faults.append(f"{path.name}: no bundled robot or example has these parameters any more")
        elif _best_program(robot, record) != record.program:
            faults.append(f"{path.name}: another record stands in its way")
        elif not equals_recursion(robot, record.function, record.program, points=3):
            faults.append(f"{path.name}: not equal to the plain recursion")
    return faults


def _best_program(robot: Robot, record: Record) -> object:
    best = best_record(robot, record.function, record.objective)
    return best and best.program


def worse(before: list[Row], now: list[Row]) -> list[str]:
    """What costs more than is committed, in words."""
    old = {(row["robot"], row["function"]): row for row in before}
    regressions = []
    for row in now:
        key = (row["robot"], row["function"])
        committed = old.pop(key, None)
        for field in ("total", "sincos"):
            if committed is not None and int(row[field]) > int(committed[field]):
                regressions.append(f"{' '.join(key)}: {field} {row[field]}, committed {committed[field]}")
    return regressions + [f"{' '.join(key)}: gone" for key in old]


def main() -> int:
    """0 where all is as good as committed or better, 1 where something got worse."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--update", action="store_true", help="write the figures")
    update = parser.parse_args().update
    warnings.simplefilter("ignore")
    now = recomputed()
    before = list(csv.DictReader(io.StringIO(_read(COUNTS))))
    faults = unproved() + worse(before, now)
    for fault in faults:
        print(fault)
    better = sum(int(row["total"]) for row in now) < sum(int(row["total"]) for row in before)
    print(f"{len(now)} programs of fast, {sum(int(row['total']) for row in now)} operations in all")
    if update:
        text = io.StringIO()
        writer = csv.DictWriter(text, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(now)
        COUNTS.write_text(text.getvalue(), encoding="utf-8")
    elif better and not faults:
        print("better than committed: make flops-record UPDATE=--update")
    return 1 if faults else 0


def _read(path: Path) -> str:
    return path.read_text(encoding="utf-8") if path.is_file() else ""


if __name__ == "__main__":
    sys.exit(main())
