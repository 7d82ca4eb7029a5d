"""What is said of types and units beside the claims: readings, what was not observed, what to do first."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import nan
from typing import Final

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
        shown = logs[np.isfinite(population.value[logs])]
        if not len(shown):
            continue
        value, level = (np.vectorize(one.stated)(x) for x in (population.value[shown], population.level))
        error = population.stderr[shown] * (value if one.is_logarithm else 1.0)
        dates, programs = model.dates[shown].tolist(), (model.program[shown] + 1).tolist()
        series[one.name] = tuple(map(Reading, dates, value.tolist(), error.tolist(), programs))
        scatter = population.between_logs * (level**2 if one.is_logarithm else 1.0)
        now[one.name] = _now(series[one.name], claims, one.name, float(np.nan_to_num(scatter)))
    first, last = model.dates[logs][[0, -1]].tolist()
    name = model.units[unit]
    return UnitResult(model.name, name, len(logs), first, last, claims, series, now, unusual)


def _now(
    readings: Sequence[Reading], claims: Sequence[Claim], name: str, scatter: float
) -> tuple[float, float]:
    """What a feature comes to now, and its standard error: the mean of the readings since a change of it was
    there in full, each with the variance of logs (``scatter``) beside its own."""
    own = [claim for claim in claims if claim.feature == name]
    since = max((claim.until or claim.since or 0.0 for claim in own), default=0.0)
    late = [one for one in readings if one.date >= since] or readings[-1:]
    if any(map(_goes_on, own)):
        late = readings[-2:]
    weight = np.array([1 / max(one.stderr**2 + scatter, 1e-18) for one in late])
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

#: How urgent a claim of each kind is, and what to do about it.
_ACTIONS: Final = {
    "friction": (3.0, "check gear, grease, brake and temperature of {where}: {course}{margin}"),
    "play": (3.5, "check gear and coupling of {where}: {course}"),
    "body": (3.2, "correct the payload of {where} by {size:+.2g} kg, or look for what hangs at its tip"),
    "gain": (2.5, "check torque sensor and motor constant of {where}"),
    "offset": (2.5, "check torque sensor and motor constant of {where}"),
    "unexplained": (2.2, "look at {where}: its torque is less and less explained; see its diagnosis"),
    PROGRAM_CHANGE: (0.5, "no fault: {where} runs another program, so earlier logs are no measure of it"),
    CLOCK: (1.0, "set the clock of {where}"),
    DATE: (1.0, "set the clock of {where}"),
}


def first_to_look_at(models: Sequence[TypeModel], units: Sequence[UnitResult]) -> tuple[Look, ...]:
    """The units to look at first, by consequence: what nears a limit, then what harms the arm or its work,
    then what only keeps it from being compared."""
    kinds = {model.name: model for model in models}
    looks = []
    for unit in units:
        for claim in unit.claims[:1]:
            model = kinds[unit.type]
            kind = next((one.kind for one in model.features if one.name == claim.feature), claim.feature)
            urgency, action = _ACTIONS[kind]
            used, margin = _margin(claim, unit, model)
            action = action.format(
                where=f"joint {claim.joint} of {unit.unit}" if claim.joint else unit.unit,
                course=_course_text(claim, unit), margin=margin, size=claim.size,
            )  # fmt: skip
            look = Look(unit.type, unit.unit, why(claim), action, record(claim))
            looks.append((-(urgency + used + _goes_on(claim)), claim.p, unit.type, unit.unit, look))
    return tuple(row[-1] for row in sorted(looks, key=lambda row: row[:4])[:FIRST])


def _goes_on(claim: Claim) -> bool:
    return claim.shape == "drift" and claim.until is None


def _course_text(claim: Claim, unit: UnitResult) -> str:
    """How long something goes on already."""
    if claim.since is None:
        return "it was so in all logs"
    weeks = (unit.last - claim.since) / (7 * DAY)
    span = f"{weeks:.0f} weeks" if weeks >= 2 else f"{max(weeks * 7, 1):.0f} days"
    rising = "rising" if claim.size > 0 else "falling"
    return f"{rising} for {span}" if _goes_on(claim) else f"it began {span} ago"


def _margin(claim: Claim, unit: UnitResult, model: TypeModel) -> tuple[float, str]:
    """Which share of the joint's torque limit friction that has grown takes, and when it will take all of
    it."""
    effort = model.robot.links[(claim.joint or 1) - 1].joint.limits.torque
    is_friction = claim.feature.startswith("friction") and claim.feature in unit.now
    if not is_friction or claim.size <= 0 or effort is None:
        return 0.0, ""
    level, limit = unit.now[claim.feature][0], abs(float(effort))
    text = f"; it takes {level / limit:.0%} of the torque limit"
    if _goes_on(claim) and claim.since is not None and unit.last > claim.since:
        reached = unit.last + (limit - level) / claim.size * (unit.last - claim.since)
        if reached < unit.last + 3 * 365 * DAY:
            text += f", and at this rate all of it on {day(reached)[:10]}"
    return level / limit, text


def why(claim: Claim) -> str:
    """A claim in a sentence."""
    since = f" since {day(claim.since)[:10]}" if claim.since is not None else ""
    if claim.feature == DATE:
        return "its clock has lost the date"
    if claim.feature == CLOCK:
        return f"its clock runs {'slow' if claim.size < 0 else 'fast'} by {abs(claim.size):.0%}{since}"
    if claim.feature == PROGRAM_CHANGE:
        return f"it runs another program{since}"
    what = " and ".join(CATALOGUE[id].title.lower() for id in claim.effects) or "what no effect explains"
    where = f" at joint {claim.joint}" if claim.joint else ""
    amount = "" if claim.unit == "-" else f", {claim.size:+.3g} {claim.unit}"
    if claim.share is not None:
        amount = f", {claim.share:+.0%}"
    return f"{what}{where}{amount}{since or ' beside its siblings, in all its logs'}"


def record(claim: Claim) -> str:
    """What to record next, in words."""
    if claim.feature in (PROGRAM_CHANGE, CLOCK, DATE):
        return ""
    sought = [CATALOGUE[id].separates for id in claim.effects if CATALOGUE[id].separates]
    return sought[0] if sought else "a motion of all joints, slow and fast, with and without load"
