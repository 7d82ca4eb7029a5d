"""A page for each effect of the catalogue."""

from __future__ import annotations

from typing import Final

from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect
from robodyn.report.effects import body, overview
from robodyn_site.curves import entry, picture, svg, usual_values
from robodyn_site.markdown import fenced, page

FOLDER: Final = "effects"


def pages() -> dict[str, str]:
    """The pages of the effects; what the repository has in one page is their overview here."""
    index = {"effects.md": overview(CATALOGUE.values(), lambda id: f"{FOLDER}/{id}.md")}
    return index | {f"{FOLDER}/{id}.md": of_effect(effect) for id, effect in CATALOGUE.items()}


def of_effect(effect: Effect) -> str:
    """The page of one effect."""
    values = usual_values(effect)
    shown = picture(effect, values) if values else None
    return page(
        f"# {effect.title}",
        body(effect, name=f"`{effect.id}`", rival=lambda id: f"[`{id}`]({id}.md)"),
        "## For example" if values else "",
        fenced(entry(effect, values), "yaml") if values else "",
        svg(effect.title, shown) if shown else "",
        "[All effects](../effects.md), and the order in which they act. `robodyn effects "
        f"{effect.id}` prints this page.",
    )
