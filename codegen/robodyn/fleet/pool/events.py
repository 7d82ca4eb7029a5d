"""What happens to a unit that is none of its arm: it runs another program, or its clock is wrong."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from robodyn.fleet.as_json import day
from robodyn.fleet.pool.programs import program_change, switching
from robodyn.fleet.pool.type_model import TypeModel, is_clock_wrong
from robodyn.fleet.result import CLOCK, DATE, PROGRAM_CHANGE, Claim, Unused
from robodyn.fleet.sources.dates import DAY
from robodyn.fleet.sources.fleet import LogFile


def unit_events(model: TypeModel, unit: int) -> Iterator[Claim]:
    """The events of a unit (from 0) of a type: another program since a day, and a clock that is wrong."""
    logs = model.logs_of(unit)
    dates = model.dates[logs]
    place = program_change(model.program[logs], switching(model.unit, model.program), unit)
    if place is not None:
        yield _event(PROGRAM_CHANGE, PROGRAM_CHANGE, dates[place - 1 : place + 1].tolist(), 1.0, "-")
    wrong = is_clock_wrong(model.clock[logs])
    if wrong.sum() < 2:  # one log is odd
        return
    off = float(np.median(model.clock[logs][wrong])) - 1
    first = int(np.argmax(wrong))
    if first and not wrong[:first].any() and wrong[first:].all():
        yield _event(CLOCK, CLOCK, dates[first - 1 : first + 1].tolist(), off, "1")
    else:
        yield _event(CLOCK, CLOCK, [], off, "1")


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
