"""What other tools need for the functions of the bundled robots, as `python -m benchmarks.functions` counted.

``robots/records/peers.csv`` has a line for each robot, by the hash of its numbers, and function.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping
from functools import cache
from typing import Any, Final

from robodyn.resources import data_dir
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot

#: The tools by their columns, as people call them.
TITLES: Final = {
    "casadi": "CasADi",
    "symforce": "SymForce",
    "wrenfold": "wrenfold",
    "pinocchio": "Pinocchio through CasADi",
}
FILE: Final = "records/peers.csv"
FIELDS: Final = ("identity", "robot", "function", *TITLES)


def operations_of_peers(robot: Robot) -> dict[str, dict[str, int]]:
    """By function, then by tool: the operations (total) of an arm with exactly the numbers of ``robot``;
    nothing of arms that were not counted."""
    return _all().get(identity(robot), {})


def versions_of_peers() -> str:
    """Which versions were counted."""
    return _text().partition("\n")[0].removeprefix("# ")


@cache
def _text() -> str:
    return (data_dir("robots") / FILE).read_text(encoding="utf-8")


@cache
def _all() -> dict[str, dict[str, dict[str, int]]]:
    known: dict[str, dict[str, dict[str, int]]] = {}
    for row in csv.DictReader(_text().splitlines()[1:]):
        counts = {tool: int(row[tool]) for tool in TITLES if row[tool]}
        known.setdefault(row["identity"], {})[row["function"]] = counts
    return known


def peers_csv(versions: str, robots: Iterable[tuple[Robot, Mapping[str, Mapping[str, Any]]]]) -> str:
    """The text of the file: of each robot the operations by function and tool, where a tool has any."""
    lines = [f"# {versions}", ",".join(FIELDS)]
    for robot, functions in robots:
        for function, row in functions.items():
            totals = [str(row.get(tool, {}).get("total", "")) for tool in TITLES]
            lines.append(",".join([identity(robot), robot.name, function, *totals]))
    return "\n".join(lines) + "\n"
