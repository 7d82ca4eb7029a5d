"""Sliding origins: an offset between parallel axes moves to the joint before, where it costs less.

The origin of a frame may stand anywhere on its joint's axis. Where the next axis is parallel, sliding the
origin along makes one offset of two, and of none beside the base, whose frame does not move. The origin of
a link that slides may stand anywhere along its way: beside the centre of mass nothing is left of its moment.
The variant that suits an arm without a search slides them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from robodyn.dynamics.arm import Arm
from robodyn.dynamics.lump import MomentForm
from robodyn.dynamics.regroup import regrouped, suited_forms
from robodyn.effects.scalars import is_zero
from robodyn.optimize.variant import LinkVariant, SecondRule, Slide, Variant


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


def suited_variant(arm: Arm, chains: bool = True, forms: Sequence[MomentForm] = ()) -> Variant:
    """The textbook's gauge with the form of moments that costs less, and origins slid along parallel axes."""
    links: list[LinkVariant] = []
    slid = slides(arm)
    for body, form, slide in zip(arm.bodies, forms or suited_forms(arm), slid, strict=True):
        # The choice of the literature: Iyy zero where the moment is written with inertias.
        second: SecondRule = "-xx" if form == "inertia" and links and body.revolute else "zero"
        place: Slide = "next" if slide else "none"
        links.append(LinkVariant(form=form, second=second, slide=place, column="carried", chained=chains))
    return Variant(tuple(links))
