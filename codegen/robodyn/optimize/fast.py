"""The variant of ``--optimize fast``: a few changes of the textbook's that pay on most arms, each kept where
it does on this one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

from robodyn.dynamics.arm import Arm
from robodyn.dynamics.parallel import chained
from robodyn.effects.scalars import is_zero
from robodyn.optimize.costing import Costing
from robodyn.optimize.gauge import Unsuited
from robodyn.optimize.programs import Choice
from robodyn.optimize.slide import suited_variant
from robodyn.optimize.variant import LinkVariant, Variant
from robodyn.robot.model import Robot

#: Of programs whose costs are estimated so close the passes have the last word.
_CLOSE = 4


def fast_choices(robot: Robot) -> tuple[Choice, ...]:
    """The choices that ``fast`` takes the best of after all passes, usually one; never dearer than
    base-parameter regrouping alone, as the literature has it, or than the recursion as in the book."""
    costing = Costing(robot)
    best = suited_variant(costing.arm)
    cost = costing.factored_total(best)
    for change in _changes(costing.arm):
        other = change(best)
        if other == best:
            continue
        try:
            total = costing.factored_total(other)
        except Unsuited:
            continue
        if total < cost:
            best, cost = other, total
    alone = literature(costing.arm)
    costs = {
        Choice(variant=best, chains=any(link.chained for link in best.links)): cost,
        Choice(variant=alone, chains=False): costing.factored_total(alone),
        Choice(regroup=False, chains=False): costing.factored_total(None),
    }
    least = min(costs.values())
    return tuple(choice for choice, total in costs.items() if total <= least + _CLOSE)


def _changes(arm: Arm) -> Iterator[Callable[[Variant], Variant]]:
    """Changes of a variant, one after another."""
    n = len(arm.bodies)
    if n > 1 and arm.bodies[1].revolute and not is_zero(arm.bodies[1].d):
        # The second origin on the first axis: it only goes round.
        yield lambda variant: variant.with_link(1, slide="own")
    if any(chained(arm)):
        yield lambda variant: _all(variant, chained=False)
    if n > 1 and arm.bodies[-1].revolute:
        # A last link that looks the same from all sides of its axis: its sine and cosine are not needed.
        yield lambda variant: variant.with_link(n - 1, second="-xx", form="spin", frame="start")
    yield lambda variant: _all(variant, column="own")


def literature(arm: Arm) -> Variant:
    """Base-parameter regrouping alone: Gautier and Khalil's choice of what moves, ``I alpha + D k``."""
    links = [
        LinkVariant(form="inertia", second="-xx" if i and body.revolute else "zero", chained=False)
        for i, body in enumerate(arm.bodies)
    ]
    return Variant(tuple(links))


def _all(variant: Variant, **changes: Any) -> Variant:
    """``variant`` with ``changes`` in every link."""
    return replace(variant, links=tuple(replace(link, **changes) for link in variant.links))
