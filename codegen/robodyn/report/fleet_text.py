"""What is said of a fleet, in words: effects, sizes, days, how unusual."""

from __future__ import annotations

import math
import textwrap
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Final, TypeGuard

from robodyn.draw.scales import DAY, day_text, range_text
from robodyn.fleet.result import (
    CLOCK,
    DATE,
    PROGRAM_CHANGE,
    Claim,
    Feature,
    FleetResult,
    UnitResult,
    address,
    unit_folder,
)
from robodyn.report import figures
from robodyn.report.diagnosis_text import listed, named, place_of
from robodyn.report.figures import capital, formatted, printable, several

#: Units of small things, which have prefixes; the smallest figure that is read easily.
_SMALL: Final = ("rad", "m")
_PREFIXES: Final = ((1.0, ""), (1e3, "m"), (1e6, "\u00b5"))
_LEAST: Final = 0.1
#: An error that is so small a share of its value is none.
_NOTHING: Final = 1e-6
_SINCE: Final = {"drift": "drifting since", "step": "changed on"}
#: What happens to a unit that is none of its arm.
_EVENTS: Final = {PROGRAM_CHANGE: "another program", CLOCK: "a wrong clock"}
#: Units in which the same has changed at one time, from which on it has one cause.
_TOGETHER: Final = 3


def effects_text(effects: Sequence[str]) -> str:
    """What effects do together, within a sentence: ``Coulomb and viscous friction``; what no effect
    explains, where there are none."""
    names = [_EVENTS.get(effect) or named(effect) for effect in effects]
    if not names:
        return "unexplained torque"
    heads, _, tails = zip(*(name.rpartition(" ") for name in names), strict=True)
    if len(set(tails)) == 1 and all(heads):
        return f"{listed(heads)} {tails[0]}"
    return listed(names)


def place_text(joint: int | None) -> str:
    """Where a feature is."""
    return "the whole arm" if joint is None else place_of(joint)


def what_text(one: Feature | Claim) -> str:
    """A feature, or what is peculiar: effects and their place."""
    if one.effects and one.effects[0] in _EVENTS:
        return effects_text(one.effects)
    return f"{effects_text(one.effects)}, {place_text(one.joint)}"


def plain(value: float, *, signed: bool = False) -> str:
    """A figure of three digits with a true minus sign."""
    return ("+" if signed and value > 0 else "") + _true_signs(formatted(value))


def _true_signs(text: str) -> str:
    """Minus signs in the place of hyphens, but for those of powers of ten."""
    return text.replace("-", "\u2212").replace("e\u2212", "e-")


def with_error(value: float, error: float, unit: str, *, signed: bool = False) -> str:
    """A figure and its standard error, digits as far as that lets them count, with its unit."""
    if not is_known(value):
        return "\u2013"
    if not is_known(error) or error <= _NOTHING * abs(value):
        return with_unit(value, unit, signed=signed)
    factor, name = _scale(max(abs(value), abs(error)), unit)
    text = _true_signs(figures.with_error(factor * value, factor * error, "\u00b1"))
    return ("+" if signed and value > 0 else "") + text + name


def with_unit(value: float, unit: str, *, signed: bool = False) -> str:
    """A figure with its unit."""
    factor, name = _scale(abs(value), unit)
    return plain(factor * value, signed=signed) + name


def has_unit(unit: str) -> bool:
    """Whether a figure has a unit of measurement."""
    return unit not in ("", "1", "-")


def _scale(size: float, unit: str) -> tuple[float, str]:
    """The factor, and the unit after a space, in which a figure of this ``size`` is read most easily."""
    if not has_unit(unit):
        return 1.0, ""
    prefixes = _PREFIXES if unit in _SMALL and size > 0 else ()
    return next(((f, f" {prefix}{unit}") for f, prefix in prefixes if f * size >= _LEAST), (1.0, f" {unit}"))


def size_text(claim: Claim) -> str:
    """How much more there is, with its standard error: ``+0.42 ± 0.03 N m (+18 %)``; empty of an event that
    has no size."""
    if claim.feature == PROGRAM_CHANGE:
        return ""
    if claim.feature == CLOCK:
        return f"time stamps are {100 * abs(claim.size):.0f} % too {'short' if claim.size < 0 else 'long'}"
    if claim.feature == DATE:
        return f"off by {with_unit(abs(claim.size), claim.unit)}"
    more = f" ({share_text(claim)})" if is_known(claim.share) else ""
    return with_error(claim.size, claim.stderr, claim.unit, signed=True) + more


def share_text(claim: Claim) -> str:
    """How much more there is, as a share of what there was; where that was nothing, with its unit."""
    if is_known(claim.share):
        return f"{100 * claim.share:+.0f} %".replace("-", "\u2212")
    return with_unit(claim.size, claim.unit, signed=True)


def brief(claim: Claim) -> str:
    """What is peculiar in a few words: ``backlash J3 +25 % since 3 May 2025``."""
    place = "" if claim.joint is None else f" J{claim.joint}"
    if is_event(claim):
        place, size = "", ""
    else:
        size = f" {share_text(claim)}"
    since = "" if claim.since is None else f" since {day_text(claim.since)}"
    return f"{effects_text(claim.effects)}{place}{size}{since}"


def is_event(claim: Claim) -> bool:
    """Whether a claim is none of the arm: another program, a wrong clock."""
    return bool(claim.effects) and claim.effects[0] in _EVENTS


def since_text(claim: Claim) -> str:
    """Since when: ``drifting since 3 May 2025``, ``drifted until ... from 3 May 2025`` where that has
    ended; ``in all its logs`` where there was no change."""
    if claim.shape not in _SINCE or claim.since is None:
        return "in all its logs"
    if claim.until is not None:
        return f"drifted until {day_text(claim.until)} from {day_text(claim.since)}"
    return f"{_SINCE[claim.shape]} {day_text(claim.since)}"


def interval_text(claim: Claim) -> str:
    """The days between which the change was, in 95 of 100 cases; empty where there was none."""
    return "" if claim.since_interval is None else range_text(*claim.since_interval)


def unusual_text(value: float | None) -> str:
    """How far from usual, with its sign: ``+4.2``; of ten and more without a digit after the point."""
    if not is_known(value):
        return "\u2013"
    text = f"{value:+.0f}" if abs(value) >= 9.95 else f"{value:+.1f}"
    return "0.0" if text in ("+0.0", "-0.0") else text.replace("-", "\u2212")


def is_known(value: float | None) -> TypeGuard[float]:
    """Whether it is a number."""
    return value is not None and math.isfinite(value)


def most_unusual(unit: UnitResult) -> float:
    """How far the unit's most unusual feature is from usual, without its sign."""
    return max((abs(value) for value in unit.unusual.values() if is_known(value)), default=0.0)


def days_of(result: FleetResult) -> tuple[float, float] | None:
    """The first and the last moment of the logs that were used."""
    if not result.units:
        return None
    return min(unit.first for unit in result.units), max(unit.last for unit in result.units)


def extent_text(result: FleetResult) -> str:
    """How much was looked at: ``1,000 units of 3 types, 12,345 logs of 364 days (2 not used)``."""
    logs = sum(kind.logs for kind in result.types)
    text = f"{several(len(result.units), 'unit')} of {several(len(result.types), 'type')}"
    text += f", {several(logs, 'log')}"
    span = days_of(result)
    if span is not None:
        text += f" of {several(round((span[1] - span[0]) / DAY) or 1, 'day')}"
    return f"{text} ({len(result.unused):,} not used)" if result.unused else text


def headline(result: FleetResult) -> str:
    """How many units differ, how sure that is, and what was not observed, as a sentence."""
    if not result.units:
        return "No log of this fleet could be used"
    count, units = len(differing(result)), several(len(result.units), "unit")
    parts = [*_events_texts(result), *_not_observed_texts(result)]
    if count:
        verb = "differs from its siblings or from what it was"
        verb = verb if count == 1 else "differ from their siblings or from what they were"
        text = f"{count:,} of {units} {verb} ({false_text(result)})"
    elif len(result.units) == 1:
        text = "Of the only unit no change is seen"
    else:
        text = f"Of {units} none is seen to differ from its siblings or from what it was"
    return "; ".join([text, *parts])


def differing(result: FleetResult) -> list[UnitResult]:
    """The units whose arm differs."""
    return [unit for unit in result.units if any(not is_event(claim) for claim in unit.claims)]


def _events_texts(result: FleetResult) -> Iterator[str]:
    """How many units run another program, or have a wrong clock."""
    for effect, words in ((PROGRAM_CHANGE, "another program runs"), (CLOCK, "the clock is wrong")):
        count = sum(any(effect in claim.effects for claim in unit.claims) for unit in result.units)
        if count:
            yield f"{words} in {count:,}"


def _not_observed_texts(result: FleetResult) -> Iterator[str]:
    """In how many units some joint was not observed."""
    units = {(one.type, one.unit) for one in result.not_observed}
    if units:
        joints = sum(one.joint is not None for one in result.not_observed)
        what = f"{several(joints, 'joint')} of " if joints else ""
        was = "was" if joints == 1 or (not what and len(units) == 1) else "were"
        yield f"{what}{several(len(units), 'unit')} {was} not observed"


def not_observed_lines(result: FleetResult) -> list[str]:
    """What was not observed, by joint and reason: ``joint 6 of 40 units was not observed: ...``."""
    counts = Counter((one.joint, one.record) for one in result.not_observed)
    lines = []
    for (joint, record), count in sorted(counts.items(), key=lambda item: (-item[1], item[0][0] or 0)):
        own = [one for one in result.not_observed if (one.joint, one.record) == (joint, record)]
        where = "no joint" if joint is None else f"joint {joint}"
        units = own[0].unit if count == 1 else several(count, "unit")
        was = "was observed" if joint is None else "was not observed"
        example = own[0].reason if count == 1 else f"in {own[0].unit} {own[0].reason}"
        lines.append(f"{where} of {units} {was}: {example}; {record}")
    return lines


def together_lines(result: FleetResult) -> list[str]:
    """What has changed at one time in many arms, for which there is one cause: a service, grease, a change of
    the program or of software."""
    claims = [claim for unit in result.units for claim in unit.claims if claim.since_interval is not None]
    lines = []
    for effects in sorted({claim.effects for claim in claims}):
        own = [claim for claim in claims if claim.effects == effects]
        while own:
            day = max((c.since or 0.0 for c in own), key=lambda day: sum(_holds(c, day) for c in own))
            same = [claim for claim in own if _holds(claim, day)]
            if len(same) < _TOGETHER:
                break
            own = [claim for claim in own if not _holds(claim, day)]
            lines.append(
                f"{capital(effects_text(effects))}: {len(same)} units at one time, about {day_text(day)}. "
                "Look for one cause: a service, grease, software, a change of the product"
            )
    return lines


def _holds(claim: Claim, day: float) -> bool:
    low, high = claim.since_interval or (math.inf, -math.inf)
    return low <= day <= high


def false_text(result: FleetResult) -> str:
    """How many of the units with a name are healthy, at most."""
    count = len(differing(result))
    expected = result.false_names * count
    if count > 1 and expected >= 1:
        return f"on average at most {formatted(expected)} of these {'is' if expected == 1 else 'are'} healthy"
    units = "units with a name" if count != 1 else "such units"
    return f"on average at most {formatted(100 * result.false_names)} % of {units} are healthy"


def counted(names: Sequence[str]) -> str:
    """How often each of ``names`` is there, the most frequent first."""
    counts = sorted(Counter(names).items(), key=lambda item: (-item[1], item[0]))
    return listed([f"{name} ({count})" for name, count in counts])


def page_of(unit: UnitResult) -> str:
    """The address of the page of a unit."""
    return address(f"{unit_folder(unit.type, unit.unit)}/index.html")


#: Columns of a line; units and reasons that have a line; lines of an advice.
_WIDTH, _LOOKS, _REASONS = 100, 5, 3


def summary(result: FleetResult, page: str) -> list[str]:
    """A few lines; ``page`` is where the page is."""
    lines = [f"{result.name}: {headline(result)}", extent_text(result), *_looks(result)]
    observed = not_observed_lines(result)
    lines += observed[:_REASONS]
    if len(observed) > _REASONS:
        lines.append(f"and {len(observed) - _REASONS} more such lines on the page")
    if result.unused:
        lines.append(f"{capital(several(len(result.unused), 'log'))} not used:")
    reasons = Counter(log.why for log in result.unused).most_common()
    for why, count in reasons[:_REASONS]:
        example = next(log.source for log in result.unused if log.why == why)
        lines.append(f"- {count:,}: {why} ({'' if count == 1 else 'such as '}{example})")
    if len(reasons) > _REASONS:
        lines.append(f"- {sum(count for _, count in reasons[_REASONS:]):,} for other reasons")
    return [wrapped for line in [*lines, f"page: {page}"] for wrapped in _wrapped(line)]


def _looks(result: FleetResult) -> Iterator[str]:
    """What is claimed first of the units to look at, and what to do; without a claim what is said of them."""
    units = {(unit.type, unit.unit): unit for unit in result.units}
    looks = [look for look in result.first_to_look_at if (look.type, look.unit) in units][:_LOOKS]
    if looks:
        yield "what to do first:"
    for k, look in enumerate(looks, 1):
        why, (claim, *others) = look.why, units[look.type, look.unit].claims or (None,)
        if claim is not None:
            days = interval_text(claim)
            more = f"; and {several(len(others), 'more claim')}" if others else ""
            since = f"{since_text(claim)}{f' ({days})' if days else ''}"
            why = f"{what_text(claim)}: {', '.join(filter(None, [size_text(claim), since]))}{more}"
        yield f"{k}. {look.type}/{look.unit}: {why}; {look.action}"
    named = sum(bool(unit.claims) for unit in result.units)
    if named > len(looks):
        yield f"and {named - len(looks):,} more on the page"


def _wrapped(line: str) -> list[str]:
    line = printable(line)
    indent = "   " if line[:1].isdigit() and line[1:3] == ". " else "  "
    return textwrap.wrap(
        line, _WIDTH, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False
    )
