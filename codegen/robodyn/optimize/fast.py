"""Variants without a search: the one that suits an arm by its frames, with sliding origins, and that of
``--optimize fast``: a few changes of the textbook's that pay on most arms, each kept where it does on this
one.

The origin of a frame may stand anywhere on its joint's axis. Where the next axis is parallel, sliding the
origin along makes one offset of two, and of none beside the base, whose frame does not move. The origin of a
link that slides may stand anywhere along its way: beside the centre of mass nothing is left of its moment.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm
from robodyn.dynamics.parallel import chained
from robodyn.dynamics.regroup import regrouped, suited_forms
from robodyn.effects.scalars import is_zero
from robodyn.optimize.choice import Choice
from robodyn.optimize.costing import Costing
from robodyn.optimize.gauge import Unsuited
from robodyn.optimize.variant import LinkVariant, SecondRule, Slide, Variant
from robodyn.robot.model import Robot


def slides(arm: Arm) -> tuple[bool, ...]:
    """For each link [n] whether its origin slides along, so that the next offset ``d`` is zero."""
    slid = [False] * len(arm.bodies)
    offset = [body.d for body in arm.bodies]
    for i in reversed(range(len(arm.bodies) - 1)):
        child = arm.bodies[i + 1]
        if not is_zero(child.sin_alpha) or is_zero(offset[i + 1]):
            continue
        if i and is_zero(offset[i]):
            continue  # one offset stays one offset
        slid[i] = True
        offset[i] = offset[i] + child.cos_alpha * offset[i + 1]
    return tuple(slid)


def slid(arm: Arm) -> Arm:
    """``arm`` in frames whose origins make the offsets ``d`` between parallel axes zero.

    The joint variables, torques and everything but the frames stay the same.
    """
    bodies = list(arm.bodies)
    for i in reversed([i for i, slides_here in enumerate(slides(arm)) if slides_here]):
        body, child = bodies[i], bodies[i + 1]
        shift = child.cos_alpha * child.d
        x, y, z = body.com
        bodies[i] = replace(body, d=body.d + shift, com=(x, y, z - shift))
        bodies[i + 1] = replace(child, d=0)
    return replace(arm, bodies=tuple(bodies))


def centred(arm: Arm) -> Arm:
    """``arm`` in frames of which the last that slides stands beside the centre of mass that it carries: where
    the axes behind it are parallel to its own, as their frames move along and no offset comes of it, and the
    one before it is not."""
    bodies = list(arm.bodies)
    i = max((k for k, body in enumerate(bodies) if not body.revolute), default=None)
    if not i or is_zero(bodies[i].sin_alpha):
        return arm
    if not all(is_zero(body.sin_alpha) for body in bodies[i + 1 :]):
        return arm
    lump = regrouped(arm, ["second_moment"] * len(bodies))[i]
    if not all(isinstance(x, int | Fraction) for x in (lump.mass, lump.first[2])) or not lump.mass:
        return arm  # numbers that are known at run time only would be divided there
    shift = Fraction(lump.first[2]) / lump.mass
    bodies[i] = replace(bodies[i], d=bodies[i].d + shift)
    for k, body in enumerate(bodies[i:], i):
        if k > i:
            shift = body.cos_alpha * shift
        x, y, z = body.com
        bodies[k] = replace(body, com=(x, y, z - shift))
    x, y, z = arm.tool.origin
    return replace(arm, bodies=tuple(bodies), tool=replace(arm.tool, origin=(x, y, z - shift)))


def suited_variant(arm: Arm, chains: bool = True) -> Variant:
    """The textbook's gauge with the form of moments that costs less, and origins slid along parallel axes."""
    links: list[LinkVariant] = []
    slid = slides(arm)
    for body, form, slide in zip(arm.bodies, suited_forms(arm), slid, strict=True):
        # The choice of the literature: Iyy zero where the moment is written with inertias.
        second: SecondRule = "-xx" if form == "inertia" and links and body.revolute else "zero"
        place: Slide = "next" if slide else "none"
        links.append(LinkVariant(form=form, second=second, slide=place, column="carried", chained=chains))
    return Variant(tuple(links))


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
