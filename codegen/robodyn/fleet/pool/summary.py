"""What is said of types and units beside the claims: readings, what was not observed, what to do first."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import nan

import numpy as np
from numpy.typing import NDArray

from robodyn.effects.catalogue import CATALOGUE
from robodyn.fleet.as_json import day
from robodyn.fleet.limits import FIRST, LEAST_LOGS, SEEN
from robodyn.fleet.pool.names import Key
from robodyn.fleet.pool.scan import Course
from robodyn.fleet.pool.type_model import TypeModel, is_clock_wrong
from robodyn.fleet.result import (
    CLOCK,
    DATE,
    PROGRAM_CHANGE,
    Claim,
    Feature,
    Look,
    NotObserved,
    Reading,
    TypeResult,
    UnitResult,
)
from robodyn.fleet.sources.dates import DAY
from robodyn.robot.account import account_lines

_SLOW_AND_FAST = "record it moving both ways at two speeds for half a minute"


def type_result(model: TypeModel) -> TypeResult:
    """What units of a type have in common."""
    features = []
    for one, population in zip(model.features, model.population, strict=True):
        mean = one.stated(population.level)
        factor = mean if one.is_logarithm else 1.0
        slopes = dict(zip(model.conditions, (factor * population.slopes).tolist(), strict=False))
        units, logs = population.between_units, float(np.sqrt(population.between_logs))
        # One object for what is not known: answers are compared, and nan is not equal to nan.
        between = (factor * units if np.isfinite(units) else nan, factor * logs if np.isfinite(logs) else nan)
        shown = int(np.isfinite(population.value).sum())
        features.append(Feature(one.name, one.effects, one.joint, one.unit, mean, *between, slopes, shown))
    robot = model.robot
    programs = int(model.program.max()) + 1
    return TypeResult(
        model.name, robot.n, len(model.units), len(model.logs), programs, tuple(features),
        tuple(account_lines(robot)),
    )  # fmt: skip


def unit_result(
    model: TypeModel, unit: int, claims: tuple[Claim, ...], unusual: Mapping[str, float]
) -> UnitResult:
    """All that is said of a unit (from 0)."""
    logs = model.logs_of(unit)
    series, now = {}, {}
    for one, population in zip(model.features, model.population, strict=True):
        shown = [k for k in logs.tolist() if np.isfinite(population.value[k])]
        if not shown:
            continue
        factors = [one.stated(float(population.value[k])) if one.is_logarithm else 1.0 for k in shown]
        readings = tuple(
            Reading(
                model.logs[k].date, one.stated(float(population.value[k])),
                factor * float(population.stderr[k]), int(model.program[k]) + 1,
            )
            for k, factor in zip(shown, factors, strict=True)
        )  # fmt: skip
        series[one.name] = readings
        scatter = one.stated(population.level) if one.is_logarithm else 1.0
        now[one.name] = _now(readings, claims, one.name, scatter * float(np.sqrt(population.between_logs)))
    dates = model.dates[logs]
    return UnitResult(
        model.name,
        model.units[unit],
        len(logs),
        float(dates[0]),
        float(dates[-1]),
        claims,
        series,
        now,
        unusual,
    )


def _now(
    readings: Sequence[Reading], claims: Sequence[Claim], name: str, scatter: float
) -> tuple[float, float]:
    """What a feature comes to now, and its standard error: the mean of the readings since a change of it was
    there in full, each with the ``scatter`` of logs beside its own error."""
    since = max((claim.until or claim.since or 0.0 for claim in claims if claim.feature == name), default=0.0)
    late = [one for one in readings if one.date >= since] or list(readings[-1:])
    if any(one.shape == "drift" and one.until is None and one.feature == name for one in claims):
        late = list(readings[-2:])  # it still goes on
    weight = np.array(
        [1 / max(one.stderr**2 + (0.0 if np.isnan(scatter) else scatter) ** 2, 1e-18) for one in late]
    )
    value = np.array([one.value for one in late])
    return float(weight @ value / weight.sum()), float(1 / np.sqrt(weight.sum()))


def not_observed(models: Sequence[TypeModel], courses: Mapping[Key, Course]) -> Iterator[NotObserved]:
    """Joints of which the logs of a unit say too little for a change to be told, with the reason."""
    for t, model in enumerate(models):
        friction = {one.joint: c for c, one in enumerate(model.features) if one.kind == "friction"}
        for u, unit in enumerate(model.units):
            logs = model.logs_of(u)
            if len(logs) < LEAST_LOGS:
                count = f"{len(logs)} log" + ("s" if len(logs) > 1 else "")
                yield NotObserved(
                    model.name, unit, None, f"{count}: a change is told from {LEAST_LOGS} on",
                    "record further logs of the same program",
                )  # fmt: skip
                continue
            for joint, c in friction.items():
                if (t, u, c) not in courses and joint is not None:
                    yield NotObserved(model.name, unit, joint, *_too_little(model, logs, joint - 1, c))


def _too_little(model: TypeModel, logs: NDArray[np.intp], j: int, c: int) -> tuple[str, str]:
    """Why joint ``j`` (from 0) is not observed in ``logs``, and what to record."""
    error, shown = model.readings.error[logs, j], np.isfinite(model.readings.value[logs, c])
    wrong = int(is_clock_wrong(model.clock[logs]).sum())
    if 2 * wrong > len(logs) or len(logs) - wrong < LEAST_LOGS:
        return f"the clock is wrong in {wrong} of {len(logs)} logs", "set the clock, and record again"
    resting = int(np.isinf(error).sum())
    if shown.sum() >= LEAST_LOGS:
        return (
            "nearly each of its logs is of another program, or too few are of one",
            "record the same program again",
        )
    if 2 * resting > len(logs):
        return f"it does not move in {resting} of {len(logs)} logs", _SLOW_AND_FAST
    known = float(np.median(error[np.isfinite(error)]))
    return (
        f"its friction is known to {min(known, 9.99):.0%} in the middle of its logs, and "
        f"{SEEN['friction']:.0%} would show a change",
        _SLOW_AND_FAST,
    )


# --- what to do first -------------------------------------------------------------------------------------


def first_to_look_at(models: Sequence[TypeModel], units: Sequence[UnitResult]) -> tuple[Look, ...]:
    """The units to look at first, by consequence: what nears a limit, then what harms the arm or its work,
    then what only keeps it from being compared."""
    kinds = {model.name: model for model in models}
    looks = []
    for unit in units:
        for claim in unit.claims[:1]:
            urgency, action = _action(claim, unit, kinds[unit.type])
            look = Look(unit.type, unit.unit, why(claim), action, record(claim))
            looks.append((-urgency, claim.p, unit.type, unit.unit, look))
    return tuple(row[-1] for row in sorted(looks, key=lambda row: row[:4])[:FIRST])


def _action(claim: Claim, unit: UnitResult, model: TypeModel) -> tuple[float, str]:
    """How urgent a claim is, and what to do about it."""
    where = f"joint {claim.joint} of {unit.unit}" if claim.joint else unit.unit
    kind = next((one.kind for one in model.features if one.name == claim.feature), claim.feature)
    goes_on = claim.shape == "drift" and claim.until is None
    if kind == "friction":
        used, limit_text = _margin(claim, unit, model) if claim.size > 0 else (0.0, "")
        verb = "check gear, grease and brake" if claim.size > 0 else "check grease and temperature"
        return 3 + used + goes_on, f"{verb} of {where}: {_course_text(claim, unit)}{limit_text}"
    if kind == "play":
        return 3.5 + goes_on, f"check gear and coupling of {where}: {_course_text(claim, unit)}"
    if kind == "body":
        way = "enter the payload" if claim.size > 0 else "enter the payload that is gone"
        return 3.2, f"{way} of {where}, {claim.size:+.2g} kg, or look for what hangs at its tip"
    if kind in ("gain", "offset"):
        return 2.5, f"check torque sensor and motor constant of {where}"
    if kind == "unexplained":
        return 2.2 + goes_on, f"look at {where}: its torque is less and less explained; see its diagnosis"
    if kind == PROGRAM_CHANGE:
        return 0.5, f"no fault: {where} runs another program, so earlier logs are no measure of it"
    return 1.0, f"set the clock of {where}"


def _course_text(claim: Claim, unit: UnitResult) -> str:
    """How long something goes on already."""
    if claim.since is None:
        return "it was so in all logs"
    weeks = (unit.last - claim.since) / (7 * DAY)
    span = f"{weeks:.0f} weeks" if weeks >= 2 else f"{max(weeks * 7, 1):.0f} days"
    rising = "rising" if claim.size > 0 else "falling"
    return (
        f"{rising} for {span}" if claim.shape == "drift" and claim.until is None else f"it began {span} ago"
    )


def _margin(claim: Claim, unit: UnitResult, model: TypeModel) -> tuple[float, str]:
    """Which share of the joint's torque limit its friction takes, and when it will take all of it."""
    link = model.robot.links[(claim.joint or 1) - 1]
    effort = link.joint.limits.torque
    if effort is None or claim.feature not in unit.now:
        return 0.0, ""
    level, limit = unit.now[claim.feature][0], abs(float(effort))
    share = level / limit
    text = f"; it takes {share:.0%} of the torque limit"
    if claim.shape == "drift" and claim.until is None and claim.since is not None and unit.last > claim.since:
        rate = claim.size / (unit.last - claim.since)
        reached = unit.last + (limit - level) / rate
        if reached < unit.last + 3 * 365 * DAY:
            text += f", and at this rate all of it on {day(reached)[:10]}"
    return share, text


def why(claim: Claim) -> str:
    """A claim in a sentence."""
    if claim.feature == DATE:
        return "its clock has lost the date"
    if claim.feature == CLOCK:
        since = f" since {day(claim.since)[:10]}" if claim.since is not None else ""
        return f"its clock runs {'slow' if claim.size < 0 else 'fast'} by {abs(claim.size):.0%}{since}"
    if claim.feature == PROGRAM_CHANGE:
        return f"it runs another program since {day(claim.since or 0.0)[:10]}"
    what = " and ".join(CATALOGUE[id].title.lower() for id in claim.effects) or "what no effect explains"
    where = f" at joint {claim.joint}" if claim.joint else ""
    amount = "" if claim.share is None else f", {claim.share:+.0%}"
    if claim.share is None and claim.unit != "-":
        amount = f", {claim.size:+.3g} {claim.unit}"
    if claim.since is None:
        return f"{what}{where}{amount} beside its siblings, in all its logs"
    return f"{what}{where}{amount} since {day(claim.since)[:10]}"


def record(claim: Claim) -> str:
    """What to record next, in words."""
    if claim.feature in (PROGRAM_CHANGE, CLOCK, DATE):
        return ""
    sought = [CATALOGUE[id].separates for id in claim.effects if CATALOGUE[id].separates]
    return sought[0] if sought else "a motion of all joints, slow and fast, with and without load"
