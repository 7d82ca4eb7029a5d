"""A fleet on a terminal: how many units differ, what to look at first, what to record next."""

from __future__ import annotations

import textwrap
from collections import Counter
from collections.abc import Iterator

from robodyn.fleet.result import FleetResult, UnitResult
from robodyn.report.fleet_text import (
    capital,
    extent_text,
    headline,
    interval_text,
    several,
    since_text,
    size_text,
    what_text,
)

#: Columns of a line; units and reasons that have a line; lines of an advice.
_WIDTH, _LOOKS, _REASONS = 100, 5, 3


def summary(result: FleetResult, page: str) -> list[str]:
    """A few lines; ``page`` is where the page is."""
    lines = [f"{result.name}: {headline(result)}", extent_text(result), *_looks(result)]
    if result.first_to_look_at and result.first_to_look_at[0].record:
        first = result.first_to_look_at[0]
        lines.append(f"record next of {first.unit}: {first.record}")
    lines += _unused(result)
    lines.append(f"page: {page}")
    return [wrapped for line in lines for wrapped in _wrapped(line)]


def _looks(result: FleetResult) -> Iterator[str]:
    units = {(unit.type, unit.unit): unit for unit in result.units}
    looks = [look for look in result.first_to_look_at if (look.type, look.unit) in units]
    if looks:
        yield "look at first:"
    for k, look in enumerate(looks[:_LOOKS], 1):
        yield f"{k}. {look.type}/{look.unit}: {_why(units[look.type, look.unit], look.why)}"
    named = sum(bool(unit.claims) for unit in result.units)
    if named > min(_LOOKS, len(looks)):
        yield f"and {named - min(_LOOKS, len(looks)):,} more on the page"


def _why(unit: UnitResult, why: str) -> str:
    """What is claimed first of a unit; without a claim what is said of it."""
    if not unit.claims:
        return why
    claim, days = unit.claims[0], interval_text(unit.claims[0])
    more = f"; and {several(len(unit.claims) - 1, 'more claim')}" if len(unit.claims) > 1 else ""
    since = f"{since_text(claim)}{f' ({days})' if days else ''}"
    return f"{what_text(claim)}: {size_text(claim)}, {since}{more}"


def _unused(result: FleetResult) -> Iterator[str]:
    """How many logs were not used, by reason."""
    if not result.unused:
        return
    yield f"{capital(several(len(result.unused), 'log'))} not used:"
    reasons = Counter(log.why for log in result.unused).most_common()
    for why, count in reasons[:_REASONS]:
        example = next(log.source for log in result.unused if log.why == why)
        yield f"- {count:,}: {why} ({'' if count == 1 else 'such as '}{example})"
    if len(reasons) > _REASONS:
        rest = sum(count for _, count in reasons[_REASONS:])
        yield f"- {rest:,} for other reasons"


def _wrapped(line: str) -> list[str]:
    plain = "".join(c if c.isprintable() else " " for c in line)
    indent = "   " if plain[:1].isdigit() and plain[1:3] == ". " else "  "
    return textwrap.wrap(
        plain, _WIDTH, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False
    )
