"""What the thesis prints: figures, parameters and lists as ``data/printed.yaml`` holds them, slips included.

A pair is multiplications and additions. What is wrong with a figure is said where it is set beside ours
(:mod:`robodyn.thesis.tables`). Source: Dhanaraj 1990.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any, Final

from robodyn.counts.thesis import TABLE_2_10, TABLE_2_10_BALAFOUTIS
from robodyn.robot import Robot, load
from robodyn.schedule.elimination import FIRST_LINK, LAST_LINK, PRISMATIC, Sparsity

Pair = tuple[int, int]
#: Entries of a diagonal tensor; None where nothing is printed.
Moments = tuple[Fraction | None, Fraction | None, Fraction | None]


@cache
def data(name: str) -> Any:
    """The content of the file of that name beside this module's other data."""
    import yaml

    path = Path(__file__).parent / "data" / f"{name}.yaml"
    return yaml.load(path.read_text(encoding="utf-8"), yaml.CSafeLoader)


@cache
def bundled(name: str) -> Robot:
    """A bundled robot; doubts about its numbers belong to ``gen``."""
    return load(name, warn=lambda _: None)


_PRINTED: Final[dict[str, Any]] = data("printed")


def _fractions(text: str) -> tuple[Fraction, ...]:
    return tuple(map(Fraction, text.split()))


def _pairs(table: dict[str, Any]) -> dict[str, dict[str, Pair]]:
    return {row: {name: (mul, add) for name, (mul, add) in pairs.items()} for row, pairs in table.items()}


@dataclass(frozen=True, slots=True)
class PrintedCost:
    """A formulation's row of Table 1.1: coefficients from the highest power of n to the constant, and the
    values that the table gives for six joints."""

    mul: tuple[Fraction, ...]
    add: tuple[Fraction, ...]
    mul_6: int
    add_6: int
    total_6: int


TABLE_1_1: Final = {
    name: PrintedCost(**{**row, "mul": _fractions(row["mul"]), "add": _fractions(row["add"])})
    for name, row in _PRINTED["table_1_1"].items()
}
TABLE_2_9: Final = _pairs(_PRINTED["table_2_9"])
METHODS: Final[dict[str, str]] = _PRINTED["methods"]
TABLE_2_10_QUOTED: Final = _pairs(_PRINTED["table_2_10_quoted"])
TABLE_2_10_QUOTED["puma_6"]["VI"] = TABLE_2_10_BALAFOUTIS["puma_6"][:2]
LISTINGS: Final[dict[str, tuple[Pair, Pair]]] = {
    name: ((a, b), (c, d)) for name, ((a, b), (c, d)) in _PRINTED["listings"].items()
}
TABLE_3_3: Final = _pairs(_PRINTED["table_3_3"])


def table_2_10() -> dict[str, dict[str, Pair]]:
    """Table 2.10: by row and method, method I being the thesis's own."""
    return {row: {"I": (mul, add), **TABLE_2_10_QUOTED[row]} for row, (mul, add, _) in TABLE_2_10.items()}


@dataclass(frozen=True, slots=True)
class PrintedDrive:
    """A row of Table 3.4: coefficient of friction, radius of the journals [m], breakaway torque and largest
    torque [N m]."""

    mu: Fraction
    radius: Fraction
    breakaway: Fraction
    largest: Fraction


@dataclass(frozen=True, slots=True)
class PrintedTorques:
    """A row of Table 3.5 [N m], 0.6 s into the case study's motion."""

    dynamic: Fraction
    joint_friction: Fraction
    joint_total: Fraction
    transmission: Fraction
    input: Fraction

    @property
    def direction(self) -> int:
        """The sign of the joint's rate: that of its friction."""
        return 1 if self.joint_friction > 0 else -1


TABLE_3_4: Final = tuple(PrintedDrive(*_fractions(row)) for row in _PRINTED["table_3_4"])
TABLE_3_5: Final = tuple(PrintedTorques(*_fractions(row)) for row in _PRINTED["table_3_5"])


@dataclass(frozen=True, slots=True)
class PrintedLink:
    """Mass [kg] and centre of mass [m] (Table 2.5), principal moments and rotor inertia [kg m^2] (2.6)."""

    mass: Fraction
    com: tuple[Fraction, Fraction, Fraction]
    moments: Moments
    motor: Fraction

    @property
    def rotors(self) -> tuple[Fraction, Fraction, Fraction]:
        """What its rotor adds to each moment [kg m^2]."""
        return Fraction(0), Fraction(0), self.motor

    @property
    def shifts(self) -> tuple[Fraction, Fraction, Fraction]:
        """What a tensor about the link's origin has more than one about the centre of mass [kg m^2]."""
        x, y, z = (u * u for u in self.com)
        return self.mass * (y + z), self.mass * (x + z), self.mass * (x + y)


def _moments(text: str) -> Moments:
    xx, yy, zz = (None if moment == "-" else Fraction(moment) for moment in text.split())
    return xx, yy, zz


def _link(body: str, moments: str, motor: str) -> PrintedLink:
    mass, x, y, z = _fractions(body)
    return PrintedLink(mass, (x, y, z), _moments(moments), Fraction(motor))


PUMA: Final = tuple(_link(**link) for link in _PRINTED["puma"])
#: Program D.2's tensors, and the last digit that is printed of each.
D_2: Final = tuple(map(_moments, _PRINTED["d_2"]))
D_2_LAST_DIGIT: Final = Fraction(1, 10000)


def moved_to_origin(link: PrintedLink) -> Moments:
    """Moments [kg m^2] of Table 2.6 about the link's origin by the offsets of Table 2.5, with the rotor in
    Izz: how D.2's numbers came about."""
    xx, yy, zz = (
        None if moment is None else moment + shift + rotor
        for moment, shift, rotor in zip(link.moments, link.shifts, link.rotors, strict=True)
    )
    return xx, yy, zz


@dataclass(frozen=True, slots=True)
class Misprinted:
    """What Table 4.1 prints of a task that cannot be meant: ``what`` it is (``step``, ``after`` or ``does``),
    as ``printed``, and how one knows."""

    what: str
    printed: str
    why: str


TABLE_4_1_MISPRINTS: Final = {
    task: Misprinted(row["what"], row["printed"], row["why"])
    for row in _PRINTED["table_4_1_misprints"]
    for task in row["tasks"]
}
#: Table 4.2: tasks that are eliminated, and the number of them that is printed beside.
TABLE_4_2: Final[dict[str, tuple[frozenset[int], int]]] = {
    "prismatic_joint": (PRISMATIC, 9), "first_link": (FIRST_LINK, 19), "last_link": (LAST_LINK, 8),
}  # fmt: skip
#: Table 4.4: components of the Stanford arm's s and p that are not zero, link by link; zeros, of so many.
TABLE_4_4: Final = Sparsity(s=("yz", "z", "z", "yz", "yz", "z"), p=("y", "y", "", "", "", ""))
TABLE_4_4_ZEROS: Final = (25, 36)


@dataclass(frozen=True, slots=True)
class PrintedRule:
    """A row of Table 4.5: the tasks of a step, and those executed where the vector has 1, 2 or 3 zeros."""

    step: str
    what: str
    tasks: tuple[int, ...]
    executed: tuple[tuple[int, ...], ...]


TABLE_4_5: Final = tuple(
    PrintedRule(row["step"], row["what"], tuple(row["tasks"]), tuple(map(tuple, row["executed"])))
    for row in _PRINTED["table_4_5"]
)
#: Zeros of s and p, tasks eliminated, and their printed number, link by link.
TABLE_4_6: Final[tuple[tuple[int, int, tuple[int, ...], int], ...]] = tuple(
    (s, p, tuple(tasks), total) for s, p, tasks, total in _PRINTED["table_4_6"]
)
LEVELS_SIX_LINK: Final[dict[int, int]] = _PRINTED["levels_six_link"]
LEVELS_STANFORD: Final[dict[int, int]] = _PRINTED["levels_stanford"]
TIMES_STANFORD: Final[dict[int, float]] = _PRINTED["times_stanford"]
TIMES_OTHERS: Final[dict[str, dict[int, float]]] = _PRINTED["times_others"]
#: Task by task, from 1, of the other columns of Table 4.8: its time, and after a colon the tasks it waits
#: for.
RIVAL_TASKS: Final[str] = _PRINTED["rival_tasks"]
#: Milliseconds a task on the thesis's processor: what one processor takes for all, divided by their number.
TASK_MS: Final = TIMES_STANFORD[1] / LEVELS_STANFORD[1]


@dataclass(frozen=True, slots=True)
class Peer:
    """A tool's operations for a robot; of some only the total was kept."""

    tool: str
    total: int
    mul: int | None = None
    add: int | None = None

    def to_dict(self) -> dict[str, object]:
        """As ``tables --json`` prints it."""
        source = "measured by robodyn's authors, same machine, same counting"
        return {"tool": self.tool, "mul": self.mul, "add": self.add, "total": self.total, "source": source}


OPENSYMORO: Final = "OpenSYMORO, base parameters"
#: What other tools need, by the name of the bundled robot.
PEERS: Final[dict[str, tuple[Peer, ...]]] = {
    robot: tuple(
        Peer(tool, found) if isinstance(found, int) else Peer(tool, sum(found), *found)
        for tool, found in tools.items()
    )
    for robot, tools in _PRINTED["peers"].items()
}
