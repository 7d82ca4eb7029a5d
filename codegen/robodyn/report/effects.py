"""The catalogue of effects as a page to read: Markdown and LaTeX from the definitions themselves."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import Any

from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect, Parameter

_PLACES = {
    "link": "on the link's side of the drive",
    "bearing": "in the joint's bearings, under the load of the rigid arm and what is before them",
    "coupler": "between link and motor",
    "gear": "in the gear, on the torque that it passes on",
    "motor": "on the motor's side of the gear",
    "pair": "on the motors' side, in two joints",
    "sensor": "on what is measured; in no kernel",
    "rigid": "in the numbers of the rigid arm",
    "outside": "from outside, in a window of time; in no kernel",
}
_KINDS = {
    "algebraic": "straight-line code",
    "state": "remembers: `NAME_state` and `dt`",
    "sensor": "simulated and diagnosed, never emitted",
    "rigid": "no code of its own",
    "outside": "reported and simulated, never emitted",
}
_SIGNS = {"any": "", "nonnegative": "0 or more", "positive": "above 0", "share": "above 0, at most 1"}
_WHERE = {
    "joint": "an entry of a link's `effects`",
    "pair": "an entry of the first joint's link",
    "robot": "an entry of the robot's `effects`",
}
_HEAD = """\
# Effects

What a rigid arm lacks, each defined once: the same equation is emitted as C, simulated, fitted and typeset.
This page is written by `robodyn effects --markdown` from the definitions in `codegen/robodyn/effects/`; a
test holds it to them.

The drive of a joint, from the link to the motor; every effect adds something, reflected to the joint's side
of the gear:

1. the torque of the rigid arm on the joint (at a prismatic joint a force), a payload included;
2. on the link's side: springs; then bearings, which feel the load;
3. between link and motor, where the joint is elastic or has backlash: a coupler; else both move alike;
4. in the gear: the loss, on the torque that it passes on;
5. on the motor's side: the rotor's inertia, friction, ripple; motors that drive two joints.

With `torque_side: link` only 1 and 2 are in the torque.

**Near rest** sgn of the velocity is what `friction_at_rest` says: `exact` (the default: sgn 0 = 0; the
simulator lets joints stick and break away), `smooth: {velocity: v}` (tanh of velocity over v) or
`dead_band: {velocity: v}` (0 below v, half at v).

**Memory**: presliding, elastic joints and backlash keep their states as they are in a call whose sample
cannot be: a position, velocity or acceleration that is infinite or no number, or such a `dt`, or one that is
negative. The torque of that call is no number either (with a bad `dt` alone it is that of the states as they
were), and the next good sample is right again; rates of a twist are differences over `dt`, and off for two
calls. A velocity that is merely wrong bends a bristle to its level at most.

"""


def page(ids: Iterable[str] = CATALOGUE) -> str:
    """The page of all effects, or of ``ids``, in Markdown."""
    chosen = [CATALOGUE[id] for id in ids]
    head = overview(chosen, lambda id: f"#{id}") + "\n" if len(chosen) > 1 else ""
    return head + "\n".join(map(section, chosen))


def overview(effects: Iterable[Effect], link: Callable[[str], str]) -> str:
    """What holds of all effects, and a list of them, each with a ``link``, in Markdown."""
    return _HEAD + "".join(f"- [`{effect.id}`]({link(effect.id)}): {effect.title}\n" for effect in effects)


def section(effect: Effect) -> str:
    """One effect in Markdown."""
    return f"## {effect.id}\n\n{body(effect, f'**{effect.title}**', lambda id: f'`{id}`')}"


def body(effect: Effect, name: str, rival: Callable[[str], str]) -> str:
    """One effect in Markdown without its heading, ``name`` and each ``rival`` as they shall be shown."""
    lines = [
        f"{name}: {_WHERE[effect.level]}; acts {_PLACES[effect.place]}; {_KINDS[effect.kind]}.",
        "",
        f"$${effect.latex}$$",
        "",
        effect.doc,
        "",
        "| key | what | unit | bounds | default |",
        "|---|---|---|---|---|",
        *map(_row, effect.parameters),
        "",
        f"- In a log: {effect.signature}.",
        f"- Rivals: {', '.join(map(rival, effect.rivals)) or 'none'}.",
        f"- What separates them: {effect.separates}.",
        f"- Source: {effect.source}.",
    ]
    return "\n".join(lines) + "\n"


def _row(p: Parameter) -> str:
    unit = p.unit if p.linear_unit is None else f"{p.unit}, prismatic {p.linear_unit}"
    bounds = ", ".join(p.choices) if p.choices else _SIGNS[p.sign]
    default = "required" if p.required else "may be left out" if p.default is None else default_text(p)
    cells = (f"`{p.name}`", p.doc + (" May be a run-time name." if p.names else ""), unit, bounds, default)
    return f"| {' | '.join(cells)} |"


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
    return {
        "effect": effect.id,
        "title": effect.title,
        "level": effect.level,
        "place": effect.place,
        "kind": effect.kind,
        "dissipative": effect.dissipative,
        "latex": effect.latex,
        "doc": effect.doc,
        "signature": effect.signature,
        "rivals": list(effect.rivals),
        "separates": effect.separates,
        "source": effect.source,
        "parameters": [
            {
                "name": p.name,
                "doc": p.doc,
                "unit": p.unit,
                "prismatic_unit": p.unit if p.linear_unit is None else p.linear_unit,
                "kind": p.kind,
                "sign": p.sign,
                "required": p.required,
                "default": None if p.default is None else default_text(p),
                "choices": list(p.choices),
                "run_time_name": p.names,
                "linear": p.name in effect.linear,
            }
            for p in effect.parameters
        ],
    }
