"""A map for a file that says little of itself: by the names of its columns, and by what their numbers do."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import Place
from robodyn.logs.families import TIMES, Family, best_size, families_of, tokens_of, unit_in
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
from robodyn.logs.survey import ColumnFacts, StreamFacts
from robodyn.logs.units import UnknownUnit, unit_of
from robodyn.logs.usual import JOINT_STATE, base_to_tip, joints_in
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]

_TIME_UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}


@dataclass(frozen=True, slots=True)
class Proposal:
    """A map, why each of its groups is what it is, and what is ``missing`` from it."""

    mapping: LogMap
    reasons: Mapping[str, str]
    missing: tuple[str, ...]


def propose(recording: Recording, facts: Sequence[StreamFacts], robot: Robot | None) -> Proposal:
    """The map that names and numbers of ``recording`` suggest."""
    place = Place(recording.file)
    states = [one for one in facts if joints_in(one.stream)]
    if states:
        return _joint_states(recording, states, robot, place)
    wanted = None if robot is None else robot.n
    main = facts[0] if facts else None
    if main is None:
        return Proposal(LogMap({}), {}, ("t", "q", "tau"))
    best: tuple[int, StreamFacts, dict[str, Family]] | None = None
    for one in facts:
        families = families_of(one.columns, wanted)
        n = wanted or best_size(families) or 1
        chosen = _families([family for family in families if len(family.members) == n])
        score = len(chosen) + 10 * ("q" in chosen) + 10 * ("tau" in chosen)
        if best is None or score > best[0]:
            best = (score, one, chosen)
    assert best is not None
    _, main, chosen = best
    groups: dict[str, Channel] = {}
    reasons: dict[str, str] = {}
    period = _time(main, groups, reasons, place)
    for group, family in chosen.items():
        groups[group] = Channel((main.stream.full(family.pattern),), place)
        if group == "ql":  # joints whose column never changes have no second encoder
            moved = [j for j, name in enumerate(family.members) if not main.columns[name].constant]
            if len(moved) < len(family.members):
                names = tuple(main.stream.full(family.members[j]) for j in moved)
                groups[group] = Channel(names, place, joints=tuple(j + 1 for j in moved))
            if not moved:
                del groups[group]
                continue
        reasons[group] = "by its name"
    _units(main, chosen, groups, reasons, robot, period)
    missing = tuple(group for group in ("t", "q", "tau") if group not in groups)
    if main.stream.stamps and "t" not in groups:
        missing = tuple(group for group in missing if group != "t")
    return Proposal(LogMap(groups), reasons, missing)


def _joint_states(
    recording: Recording, states: Sequence[StreamFacts], robot: Robot | None, place: Place
) -> Proposal:
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
    return Proposal(LogMap(groups, order, one.stream.name), reasons, missing)


def _families(families: Sequence[Family]) -> dict[str, Family]:
    """The best family of each group; none is used twice."""
    chosen: dict[str, Family] = {}
    for group in ("q", "tau", "qd", "qdd", "ql"):
        used = {family.pattern for family in chosen.values()}
        scored = [(family.score(group), family) for family in families if family.pattern not in used]
        scored = [pair for pair in scored if pair[0] > (1 if group in ("qd", "qdd", "ql") else 0)]
        if scored:
            chosen[group] = max(scored, key=lambda pair: pair[0])[1]
    return chosen


# --- time -------------------------------------------------------------------------------------------------


def _time(
    main: StreamFacts, groups: dict[str, Channel], reasons: dict[str, str], place: Place
) -> float | None:
    """Put the column of times into ``groups``; the time between two rows [s], None if there is none."""
    if main.stream.stamps:
        steps = np.diff(main.seconds) if main.seconds is not None else np.empty(0)
        return float(np.median(steps)) if len(steps) else None
    best: tuple[int, str] | None = None
    for name, column in main.columns.items():
        words = [word for word in tokens_of(name) if word in TIMES]
        steps = np.diff(column.window)
        if not words or column.constant or not len(steps) or (steps < 0).mean() > 0.01:
            continue
        score = max(10 - TIMES.index(word) for word in words)
        if best is None or score > best[0]:
            best = (score, name)
    if best is None:
        return None
    name = best[1]
    window = main.columns[name].window
    steps = np.diff(window)
    step = float(np.median(steps[steps > 0])) if (steps > 0).any() else math.nan
    stated = main.stream.units.get(name, "") or unit_in(name)
    unit = stated if stated in _TIME_UNITS else _time_unit(step, float(window[0]))
    groups["t"] = Channel((main.stream.full(name),), place, "" if unit == "s" else unit)
    reasons["t"] = f"{'stated' if stated == unit else 'by its steps'}: {step * _TIME_UNITS[unit]:.4g} s a row"
    return step * _TIME_UNITS[unit]


def _time_unit(step: float, first: float) -> str:
    """The unit in which rows come at a rate that logs have; dates say it by themselves."""
    for unit, size in _TIME_UNITS.items():
        if 1e9 < abs(first) * size < 4e9:  # seconds since 1970, from 2001 to 2096
            return unit
    for unit, size in _TIME_UNITS.items():
        if 1 / FASTEST_RATE <= step * size <= 1 / SLOWEST_RATE:
            return unit
    return "s"


# --- units ------------------------------------------------------------------------------------------------


def _units(
    main: StreamFacts,
    chosen: Mapping[str, Family],
    groups: dict[str, Channel],
    reasons: dict[str, str],
    robot: Robot | None,
    period: float | None,
) -> None:
    """Give the channels their units, and say why."""
    for group, family in chosen.items():
        stated = main.stream.units.get(family.members[0], "")
        unit, why = stated, "stated in the file"
        if not unit:
            unit, why = unit_in(family.pattern.replace("%d", "").rstrip(".[]_")), "by the end of its name"
        if unit and not _fits(unit, group):
            unit = ""
        if not unit and group in ("q", "ql"):
            unit, why = _angle_unit(main, family, robot)
        if not unit and group in ("qd", "qdd"):
            below = "q" if group == "qd" else "qd"
            unit, why = _rate_unit(main, chosen, groups, below, family, period)
            if not unit:
                del groups[group]
                reasons[group] = f"left out: {why}"
                continue
        if not unit and group == "tau":
            current = {"current", "currents", "cur", "curr", "amp", "strom"} & set(family.tokens)
            largest = _largest([main.columns[member] for member in family.members])
            whole = all(main.columns[member].whole for member in family.members)
            if whole and largest > COUNTS:
                unit, why = "raw", f"whole numbers up to {largest:.6g}: write factor, N m to one of them"
            elif current:
                unit, why = "A" if largest < MOST_AMPERES else "mA", "a current, by its name and size"
            else:
                unit, why = "N m", "taken for N m: nothing says otherwise"
        groups[group] = replace(groups[group], unit=unit)
        reasons[group] = why


def _fits(unit: str, group: str) -> bool:
    for prismatic in (False, True):
        try:
            unit_of(unit, group, prismatic=prismatic)
        except UnknownUnit:
            continue
        return True
    return False


def _largest(columns: Sequence[ColumnFacts]) -> float:
    """The largest size of the numbers in ``columns``; 0 where there is none."""
    return max((abs(x) for c in columns if c.share for x in (c.low, c.high)), default=0.0)


def _angle_unit(main: StreamFacts, family: Family, robot: Robot | None) -> tuple[str, str]:
    """The unit of positions by their range."""
    columns = [main.columns[member] for member in family.members]
    largest = _largest(columns)
    if not any(column.share for column in columns):
        return "rad", "taken for rad: there is no number in it"
    limits = [None] * len(columns) if robot is None else [link.joint.limits.position for link in robot.links]
    bounds = [max(abs(float(x)) for x in pair) for pair in limits if pair is not None]
    turn = max([TURNED, *(1.1 * bound for bound in bounds)])
    if largest <= turn:
        return "rad", f"|q| is at most {largest:.3g}: within {turn:.3g} rad"
    if all(column.whole for column in columns) and largest > 720:
        return "ticks", f"whole numbers up to {largest:.6g}: ticks (write counts_per_turn)"
    return "deg", f"|q| is up to {largest:.4g}: more than {turn:.3g} rad"


def _rate_unit(
    main: StreamFacts,
    chosen: Mapping[str, Family],
    groups: Mapping[str, Channel],
    below: str,
    family: Family,
    period: float | None,
) -> tuple[str, str]:
    """The unit of a rate by what it is times the difference of what it is the rate of."""
    if below not in chosen or below not in groups or period is None or not period > 0:
        return "", "nothing says its unit"
    try:
        base = float(unit_of(groups[below].unit or ("rad" if below == "q" else "rad/s"), below).factor)
    except UnknownUnit:
        return "", "nothing says its unit"
    ratios = []
    for member, lower in zip(family.members, chosen[below].members, strict=True):
        x, rate = main.columns[lower].window * base, main.columns[member].window
        difference = np.gradient(x, period) if len(x) > 2 else x
        sound = np.isfinite(difference) & np.isfinite(rate)
        a, b = difference[sound], rate[sound]
        power = float(a @ a)
        if power > 0 and float(b @ b) > 0:
            correlation = float(a @ b) / math.sqrt(power * float(b @ b))
            if abs(correlation) > RATE_MATCH:
                ratios.append(abs(float(a @ b) / power))
    if not ratios:
        return "", "it does not follow the positions"
    ratio = float(np.median(ratios))
    names = ("rad/s", "deg/s", "rpm", "mrad/s", "rev/s") if below == "q" else ("rad/s^2", "deg/s^2")
    for name in names:
        expected = 1 / float(unit_of(name, "qd" if below == "q" else "qdd").factor)
        if abs(math.log(ratio / expected)) < RATE_NEAR:
            return name, f"{ratio:.3g} times the rate of the positions in SI units"
    return "", f"{ratio:.3g} times the rate of the positions: no unit that is known"
