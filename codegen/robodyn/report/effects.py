"""The catalogue of effects as a page to read: Markdown and LaTeX from the definitions themselves."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import Any

from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect, Parameter
from robodyn.emit.render import environment


def page(ids: Iterable[str] = CATALOGUE) -> str:
    """The page of all effects, or of ``ids``, in Markdown."""
    chosen = [CATALOGUE[id] for id in ids]
    head = overview(chosen, lambda id: f"#{id}") + "\n" if len(chosen) > 1 else ""
    return head + "\n".join(
        f"## {effect.id}\n\n{body(effect, f'**{effect.title}**', lambda id: f'`{id}`')}" for effect in chosen
    )


def overview(effects: Iterable[Effect], link: Callable[[str], str]) -> str:
    """What holds of all effects, and a list of them, each with a ``link``, in Markdown."""
    return environment().get_template("report/effects.md.j2").render(effects=effects, link=link)


def body(effect: Effect, name: str, rival: Callable[[str], str]) -> str:
    """One effect in Markdown without its heading, ``name`` and each ``rival`` as they shall be shown."""
    rivals = ", ".join(map(rival, effect.rivals))
    template = environment().get_template("report/effect.md.j2")
    return template.render(effect=effect, name=name, rivals=rivals, default=default_text)


def default_text(p: Parameter) -> str:
    """A default as a file would have it."""
    if isinstance(p.default, Fraction):
        default = p.default.numerator if p.default.denominator == 1 else float(p.default)
        return f"[{default}, {default}, {default}]" if p.kind == "vector" else str(default)
    return str(p.default)


def latex(ids: Iterable[str] = CATALOGUE) -> str:
    """The equations as LaTeX, one display an effect."""
    return "\n".join(f"% {CATALOGUE[id].title}\n\\[ {CATALOGUE[id].latex} \\]" for id in ids) + "\n"


def data(effect: Effect) -> dict[str, Any]:
    """One effect for ``--json``."""
    plain = ("title", "level", "place", "kind", "dissipative", "latex", "doc", "signature")
    return {
        "effect": effect.id,
        **{key: getattr(effect, key) for key in plain},
        "rivals": list(effect.rivals),
        "separates": effect.separates,
        "source": effect.source,
        "parameters": [
            {
                **{key: getattr(p, key) for key in ("name", "doc", "unit")},
                "prismatic_unit": p.unit_at(revolute=False),
                **{key: getattr(p, key) for key in ("kind", "sign", "required")},
                "default": None if p.default is None else default_text(p),
                "choices": list(p.choices),
                "run_time_name": p.names,
                "linear": p.name in effect.linear,
            }
            for p in effect.parameters
        ],
    }
