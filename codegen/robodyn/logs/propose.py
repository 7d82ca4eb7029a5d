"""A map for a file that says little of itself: by the names of its columns, and by what their numbers do."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from robodyn.errors import Place
from robodyn.logs.limits import (
    COUNTS,
    FASTEST_RATE,
    MOST_AMPERES,
    RATE_MATCH,
    RATE_NEAR,
    SLOWEST_RATE,
    TURNED,
)
from robodyn.logs.mapping import Channel, LogMap
from robodyn.logs.recording import Recording
from robodyn.logs.resolve import JOINT_STATE, base_to_tip, joints_in
from robodyn.logs.survey import ColumnFacts, StreamFacts
from robodyn.logs.units import UnknownUnit, unit_of
from robodyn.robot.model import Robot

_INTEGER: Final = re.compile(r"[0-9]+")
_TOKEN: Final = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[0-9]+")

#: Words in names, and how much each speaks for a group.
_WORDS: Final = {
    "q": {
        "q": 5, "pos": 6, "position": 6, "positions": 6, "angle": 5, "angles": 5, "theta": 4, "phi": 4,
        "joint": 1, "encoder": 4, "enc": 4, "winkel": 5, "lage": 4,
    },
    "qd": {
        "qd": 7, "dq": 7, "vel": 7, "velocity": 7, "velocities": 7, "speed": 7, "omega": 5, "qp": 6,
        "rate": 2, "geschwindigkeit": 7,
    },
    "qdd": {"qdd": 8, "ddq": 8, "acc": 7, "accel": 7, "acceleration": 7, "accelerations": 7, "qpp": 7},
    "tau": {
        "tau": 7, "torque": 7, "torques": 7, "trq": 7, "effort": 6, "moment": 5, "current": 5, "currents": 5,
        "cur": 4, "curr": 4, "load": 3, "force": 4, "amp": 3, "drehmoment": 7, "strom": 5, "nm": 3,
    },
}  # fmt: skip
#: Second encoders: these beside those of positions.
_LINK: Final = {"se", "secondary", "link", "ql", "output", "outer", "loadside"}
#: What is wanted and not what is, or what was made of it: never proposed where there is something else.
_WANTED: Final = {
    "ref", "reference", "des", "desired", "cmd", "command", "commanded", "target", "goal", "set", "setpoint",
    "error", "err", "ext", "external", "friction", "temp", "temperature", "ff", "feedforward", "dot", "std",
    "model", "estimate", "est", "gravity", "g", "c", "rel", "relative", "volt", "volts", "voltage", "limit",
}  # fmt: skip
#: Switches and states: never a quantity.
_STATES: Final = {"enable", "enabled", "status", "mode", "flag", "id", "valid"}
_MEASURED: Final = {"act", "actual", "meas", "measured", "msr", "is", "ist", "mot", "motor", "rec", "abs"}
_UNITS: Final = {
    ("deg", "per", "s"): "deg/s", ("rad", "per", "s"): "rad/s", ("rad", "s"): "rad/s", ("deg", "s"): "deg/s",
    ("rpm",): "rpm", ("deg",): "deg", ("degrees",): "deg", ("rad",): "rad", ("nm",): "N m",
    ("m", "nm"): "mN m", ("mnm",): "mN m", ("ma",): "mA", ("a",): "A", ("amps",): "A", ("amp",): "A",
    ("ms",): "ms", ("us",): "us",
    ("ns",): "ns", ("s",): "s", ("sec",): "s", ("mm",): "mm", ("ticks",): "ticks", ("counts",): "ticks",
    ("usec",): "us", ("msec",): "ms", ("nsec",): "ns", ("percent",): "%", ("permille",): "permille",
}  # fmt: skip
_TIMES: Final = (
    "t", "time", "timestamp", "times", "stamp", "zeit", "sec", "seconds", "clock", "tick", "ms", "us",
)  # fmt: skip
_TIME_UNITS: Final = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
_CURRENT: Final = {"current", "currents", "cur", "curr", "amp", "strom"}


@dataclass(frozen=True, slots=True)
class Family:
    """Columns that differ by a number: the ``pattern`` with %d for it, and the ``members`` in their order.
    A column by itself is a family of one, without %d."""

    pattern: str
    members: tuple[str, ...]

    @property
    def tokens(self) -> set[str]:
        """The words of its name, in small letters."""
        return set(_tokens_of(self.pattern.replace("%d", " ").replace("%02d", " ")))

    def score(self, group: str) -> int:
        """How much its name speaks for ``group``; 0: nothing does."""
        words = self.tokens
        scores = {g: max((table.get(word, 0) for word in words), default=0) for g, table in _WORDS.items()}
        best = scores["q" if group == "ql" else group]
        is_link = bool(_LINK & words)
        if not best or _STATES & words or max(scores.values()) > best:
            return 0
        if is_link != (group == "ql") and group in ("q", "ql"):
            return 0
        count = len(_tokens_of(self.pattern.replace("%d", " ").replace("%02d", " ")))
        return max(10 * best + 3 * len(_MEASURED & words) - 20 * len(_WANTED & words) - count, 1)


def _tokens_of(name: str) -> tuple[str, ...]:
    """The words of a name, in small letters: of camel case, and between marks."""
    return tuple(word.lower() for word in _TOKEN.findall(name) if not word.isdigit())


def _unit_in(name: str) -> str:
    """The unit with which a name ends; "" if it ends with none."""
    words = _tokens_of(name)
    for length in (3, 2, 1):
        if len(words) > length and words[-length:] in _UNITS:
            return _UNITS[words[-length:]]
    return ""


def _families_of(columns: Iterable[str], n: int | None) -> list[Family]:
    """The families of ``columns`` that have ``n`` members; None: of any size above one. Numbers rise by one
    from 0 or 1; of several numbers in a name, the one that makes the largest family is that of the joint."""
    by_pattern: dict[str, dict[int, str]] = {}
    for name in columns:
        for match in _INTEGER.finditer(name):
            digits = match[0]
            if len(digits) <= 3:
                form = f"%0{len(digits)}d" if len(digits) > 1 and digits[0] == "0" else "%d"
                pattern = name[: match.start()] + form + name[match.end() :]
                by_pattern.setdefault(pattern, {})[int(digits)] = name
    families = []
    for pattern, members in by_pattern.items():
        first = 0 if 0 in members else 1
        run: list[str] = []
        while first + len(run) in members:
            run.append(members[first + len(run)])
        if len(run) > 1 and n in (None, len(run)):
            families.append(Family(pattern, tuple(run)))
    if n in (None, 1):
        families += [Family(name, (name,)) for name in columns]
    return families


def _best_size(families: Sequence[Family]) -> int:
    """How many joints there are: the size at which positions and torques both have families, else 1."""
    for size in sorted({len(family.members) for family in families}, reverse=True):
        some = [family for family in families if len(family.members) == size]
        if all(any(family.score(group) > 1 for family in some) for group in ("q", "tau")):
            return size
    return 1


def _chosen(families: Sequence[Family]) -> dict[str, Family]:
    """The best family of each group; none is used twice."""
    chosen: dict[str, Family] = {}
    for group in ("q", "tau", "qd", "qdd", "ql"):
        used = {family.pattern for family in chosen.values()}
        least = 1 if group in ("qd", "qdd", "ql") else 0
        left = [family for family in families if family.pattern not in used and family.score(group) > least]
        if left:
            chosen[group] = max(left, key=lambda family: family.score(group))
    return chosen


# --- the map ----------------------------------------------------------------------------------------------


#: A map, why each of its groups is what it is, and which groups are missing from it.
Proposal = tuple[LogMap, dict[str, str], tuple[str, ...]]


def propose(recording: Recording, facts: Sequence[StreamFacts], robot: Robot | None) -> Proposal:
    """The map that names and numbers of ``recording`` suggest."""
    place = Place(recording.file)
    states = [one for one in facts if joints_in(one.stream)]
    if states:
        return _joint_states(states, robot, place)
    best: tuple[int, StreamFacts, dict[str, Family]] | None = None
    for one in facts:
        families = _families_of(one.columns, None if robot is None else robot.n)
        n = _best_size(families) if robot is None else robot.n
        chosen = _chosen([family for family in families if len(family.members) == n])
        score = len(chosen) + 10 * ("q" in chosen) + 10 * ("tau" in chosen)
        if best is None or score > best[0]:
            best = (score, one, chosen)
    if best is None:
        return LogMap({}), {}, ("t", "q", "tau")
    proposer = _Proposer(best[1], best[2], robot, place)
    groups = proposer.groups
    times = () if proposer.stream.stamps else ("t",)
    missing = tuple(group for group in (*times, "q", "tau") if group not in groups)
    return LogMap(groups), proposer.reasons, missing


def _joint_states(states: Sequence[StreamFacts], robot: Robot | None, place: Place) -> Proposal:
    one = max(
        states, key=lambda each: ("effort" in str(list(each.columns)[-1:]), len(each.columns), each.rows)
    )
    names = joints_in(one.stream)
    order, why = base_to_tip(names, robot)
    reasons = {"joints": f"{why}" if order else "as messages have them: set them base to tip"}
    order = order or names
    groups = {}
    for group, field in JOINT_STATE.items():
        if all(f"{field}.{name}" in one.columns for name in order):
            groups[group] = Channel((f"{field}.%s",), place)
            reasons[group] = "sensor_msgs/JointState: rad, m and N m by its definition"
    missing = tuple(group for group in ("q", "tau") if group not in groups)
    return LogMap(groups, order, one.stream.name), reasons, missing


class _Proposer:
    """Channels of the ``chosen`` families of a stream, with units, and the ``reasons`` for them."""

    def __init__(
        self, main: StreamFacts, chosen: Mapping[str, Family], robot: Robot | None, place: Place
    ) -> None:
        self.columns, self.stream, self.robot, self.chosen = main.columns, main.stream, robot, chosen
        self.groups: dict[str, Channel] = {}
        self.reasons: dict[str, str] = {}
        self.period = self.times(main, place)
        for group, family in chosen.items():
            self.groups[group] = Channel((self.stream.full(family.pattern),), place)
            if group == "ql":  # joints whose column never changes have no second encoder
                moved = [j for j, name in enumerate(family.members) if not self.columns[name].constant]
                if len(moved) < len(family.members):
                    names = tuple(self.stream.full(family.members[j]) for j in moved)
                    self.groups[group] = Channel(names, place, joints=tuple(j + 1 for j in moved))
                if not moved:
                    del self.groups[group]
        for group, family in chosen.items():
            if group in self.groups:
                unit, self.reasons[group] = self.unit(group, family)
                self.groups[group] = replace(self.groups[group], unit=unit)
                if not unit:
                    del self.groups[group]

    def times(self, main: StreamFacts, place: Place) -> float | None:
        """The time between two rows [s], None if there is none; the column of times becomes a group."""
        if self.stream.stamps:
            steps = np.diff(main.seconds) if main.seconds is not None else np.empty(0)
            return float(np.median(steps)) if len(steps) else None
        scores = {}
        for name, column in self.columns.items():
            steps = np.diff(column.window)
            if not column.constant and len(steps) and (steps < 0).mean() <= 0.01:
                scores[name] = max((10 - _TIMES.index(w) for w in _tokens_of(name) if w in _TIMES), default=0)
        name = max(scores, key=lambda each: scores[each], default="")
        if not scores.get(name):
            return None
        window = self.columns[name].window
        steps = np.diff(window)
        step = float(np.median(steps[steps > 0])) if (steps > 0).any() else math.nan
        stated = self.stream.units.get(name, "") or _unit_in(name)
        unit = stated if stated in _TIME_UNITS else _time_unit(step, float(window[0]))
        self.groups["t"] = Channel((self.stream.full(name),), place, "" if unit == "s" else unit)
        why = "stated" if stated == unit else "by its steps"
        self.reasons["t"] = f"{why}: {step * _TIME_UNITS[unit]:.4g} s a row"
        return step * _TIME_UNITS[unit]

    def unit(self, group: str, family: Family) -> tuple[str, str]:
        """The unit of a group, and why; "": it is left out."""
        stated = self.stream.units.get(family.members[0], "")
        unit = stated or _unit_in(family.pattern.replace("%d", "").rstrip(".[]_"))
        if unit and _fits(unit, group):
            return unit, "stated in the file" if stated else "by the end of its name"
        columns = [self.columns[member] for member in family.members]
        largest = max((abs(x) for c in columns if c.share for x in (c.low, c.high)), default=0.0)
        is_whole = all(column.whole for column in columns)
        if group in ("q", "ql"):
            return self.angle(columns, largest, is_whole)
        if group in ("qd", "qdd"):
            unit, why = self.rate("q" if group == "qd" else "qd", group, family)
            return unit, why if unit else f"left out: {why}"
        if is_whole and largest > COUNTS:
            return "raw", f"whole numbers up to {largest:.6g}: write factor, N m to one of them"
        if _CURRENT & family.tokens:
            return "A" if largest < MOST_AMPERES else "mA", "a current, by its name and size"
        return "N m", "taken for N m: nothing says otherwise"

    def angle(self, columns: Sequence[ColumnFacts], largest: float, is_whole: bool) -> tuple[str, str]:
        """The unit of positions by their range."""
        if not any(column.share for column in columns):
            return "rad", "taken for rad: there is no number in it"
        limits = [] if self.robot is None else [link.joint.limits.position for link in self.robot.links]
        turn = max([TURNED, *(1.1 * max(abs(float(x)) for x in pair) for pair in limits if pair is not None)])
        if largest <= turn:
            return "rad", f"|q| is at most {largest:.3g}: within {turn:.3g} rad"
        if is_whole and largest > 720:
            return "ticks", f"whole numbers up to {largest:.6g}: ticks (write counts_per_turn)"
        return "deg", f"|q| is up to {largest:.4g}: more than {turn:.3g} rad"

    def rate(self, below: str, group: str, family: Family) -> tuple[str, str]:
        """The unit of a rate by what it is times the difference of what it is the rate of."""
        unknown = "", "nothing says its unit"
        usual = "rad" if below == "q" else "rad/s"
        if below not in self.groups or self.period is None or not self.period > 0:
            return unknown
        try:
            base = float(unit_of(self.groups[below].unit or usual, below).factor)
        except UnknownUnit:
            return unknown
        ratios = []
        for member, lower in zip(family.members, self.chosen[below].members, strict=True):
            x, rate = self.columns[lower].window * base, self.columns[member].window
            difference = np.gradient(x, self.period) if len(x) > 2 else x
            sound = np.isfinite(difference) & np.isfinite(rate)
            a, b = difference[sound], rate[sound]
            power, other = float(a @ a), float(b @ b)
            if power > 0 and other > 0 and abs(float(a @ b)) > RATE_MATCH * math.sqrt(power * other):
                ratios.append(abs(float(a @ b) / power))
        if not ratios:
            return "", "it does not follow the positions"
        ratio = float(np.median(ratios))
        for name in ("rad/s", "deg/s", "rpm", "mrad/s", "rev/s") if below == "q" else ("rad/s^2", "deg/s^2"):
            if abs(math.log(ratio * float(unit_of(name, group).factor))) < RATE_NEAR:
                return name, f"{ratio:.3g} times the rate of the positions in SI units"
        return "", f"{ratio:.3g} times the rate of the positions: no unit that is known"


def _time_unit(step: float, first: float) -> str:
    """The unit in which rows come at a rate that logs have; dates say it by themselves."""
    for unit, size in _TIME_UNITS.items():
        if 1e9 < abs(first) * size < 4e9:  # seconds since 1970, from 2001 to 2096
            return unit
    for unit, size in _TIME_UNITS.items():
        if 1 / FASTEST_RATE <= step * size <= 1 / SLOWEST_RATE:
            return unit
    return "s"


def _fits(unit: str, group: str) -> bool:
    for is_prismatic in (False, True):
        try:
            unit_of(unit, group, prismatic=is_prismatic)
        except UnknownUnit:
            continue
        return True
    return False
