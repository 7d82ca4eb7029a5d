"""Puts the operations of the arms of examples/arms into the table of their README.

python -m benchmarks.arms
"""

from __future__ import annotations

import sys
from pathlib import Path

from robodyn import count, load
from robodyn.formats.writers.parts import parts_of

FOLDER = Path(__file__).parents[1] / "examples" / "arms"
FUNCTIONS = ("inverse_dynamics", "gravity", "mass_matrix", "forward_dynamics")
START, END = "<!-- operations -->\n", "<!-- end -->"


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


def main() -> int:
    """Write the table."""
    readme = FOLDER / "README.md"
    head, start, rest = readme.read_text(encoding="utf-8").partition(START)
    if not start:
        print(f"{readme}: no {START.strip()}", file=sys.stderr)
        return 1
    readme.write_text(f"{head}{start}{table()}{END}{rest.partition(END)[2]}", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
