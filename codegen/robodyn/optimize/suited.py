"""The variant that suits an arm without a search."""

from __future__ import annotations

from collections.abc import Sequence

from robodyn.dynamics.arm import Arm
from robodyn.dynamics.lump import MomentForm
from robodyn.dynamics.regroup import suited_forms
from robodyn.optimize.slide import slides
from robodyn.optimize.variant import LinkVariant, SecondRule, Slide, Variant


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
