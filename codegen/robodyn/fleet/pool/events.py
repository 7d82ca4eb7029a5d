"""What happens to a unit that is none of its arm: it runs another program, or its clock is wrong."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from robodyn.arrays import Floats
from robodyn.fleet.as_json import day
from robodyn.fleet.pool.programs import chances_of, split_of, switching
from robodyn.fleet.pool.type_model import TypeModel, is_clock_wrong
from robodyn.fleet.result import CLOCK, DATE, PROGRAM_CHANGE, Claim, Unused
from robodyn.fleet.sources.dates import DAY
from robodyn.fleet.sources.fleet import LogFile


def program_changes(
    models: Sequence[TypeModel], named: int, false_names: float
) -> dict[tuple[int, int], Claim]:
    """By type and unit, what runs another program from a day on and none of the old ones again. Programs that
    take turns look so by chance: of all names, ``named`` others among them, the share ``false_names`` is
    expected to be such, at most (Benjamini and Hochberg 1995, with the chances that there are)."""
    chances: list[Floats] = []
    splits: list[tuple[float, tuple[int, int], Claim]] = []
    for k, model in enumerate(models):
        seldom = switching(model.unit, model.program) <= false_names
        for u in range(len(model.units)):
            logs = model.logs_of(u)
            chances.append(np.zeros(1) if seldom else chances_of(model.program[logs])[2:])
            place = split_of(model.program[logs])
            if place is not None:
                chance = 0.0 if seldom else float(chances[-1][min(place, len(logs) - place) - 2])
                between = model.dates[logs][place - 1 : place + 1].tolist()
                claim = _event(PROGRAM_CHANGE, PROGRAM_CHANGE, between, 1.0, "-")
                splits.append((chance, (k, u), claim))
    splits.sort(key=lambda one: one[0])
    expected = [sum(own[own <= chance].max(initial=0.0) for own in chances) for chance, *_ in splits]
    counts = [n for n, e in enumerate(expected, 1) if e <= false_names * (n + named)]
    return {unit: claim for _, unit, claim in splits[: max(counts, default=0)]}


def clock_event(model: TypeModel, unit: int) -> Claim | None:
    """The clock of a unit (from 0) of a type, where it is wrong."""
    logs = model.logs_of(unit)
    wrong = is_clock_wrong(model.clock[logs])
    if wrong.sum() < 2:  # one log is odd
        return None
    off = float(np.median(model.clock[logs][wrong])) - 1
    first = int(np.argmax(wrong))
    is_step = first > 0 and not wrong[:first].any() and bool(wrong[first:].all())
    return _event(
        CLOCK, CLOCK, model.dates[logs][first - 1 : first + 1].tolist() if is_step else [], off, "1"
    )


def _event(effect: str, feature: str, between: Sequence[float], size: float, unit: str) -> Claim:
    """An event between two dates (none: in all logs)."""
    since = sum(between) / 2 if between else None
    interval = (between[0], between[1]) if between else None
    shape = "step" if between else "always"
    share = size if unit == "1" else None
    return Claim((effect,), None, feature, shape, since, interval, None, size, 0.0, unit, share, 0.0, 0.0)  # type: ignore[arg-type]


def lost_dates(logs: Sequence[LogFile]) -> tuple[dict[tuple[str, str], list[Claim]], list[Unused]]:
    """Logs whose dates lie as far from those of the fleet as the fleet's are apart, or farther: by type and
    unit the clocks that have lost their date, and the logs, which cannot be compared."""
    if not logs:
        return {}, []
    dates = np.array([log.date for log in logs])
    low, high = np.quantile(dates, [0.05, 0.95])
    reach = max(float(high - low), 30 * DAY)
    far = (dates < low - reach) | (dates > high + reach)
    claims: dict[tuple[str, str], list[Claim]] = {}
    unused = []
    for k in np.flatnonzero(far).tolist():
        log = logs[k]
        why = (
            f"its date, {day(log.date)[:10]}, lies far from those of all others: its clock has lost the date"
        )
        unused.append(Unused(log.source, log.type, log.unit, why))
        off = (log.date - float(np.median(dates))) / DAY
        claims.setdefault((log.type, log.unit), [_event(CLOCK, DATE, [], off, "d")])
    known = {(log.type, log.unit) for log, is_far in zip(logs, far.tolist(), strict=True) if not is_far}
    return {unit: own for unit, own in claims.items() if unit in known}, unused
