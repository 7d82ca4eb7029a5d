"""The catalogue of effects as a page to read: Markdown and LaTeX from the definitions themselves."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import Any

from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect, Parameter

_PLACES = {
    "link": "on the link's side of the drive",
    "bearing": "in the joint's bearings, under the load of the rigid arm and of effects before them",
    "coupler": "between link and motor",
    "gear": "in the gear, on the torque that it transmits",
    "motor": "on the motor's side of the gear",
    "pair": "on the motors' side, in two joints",
    "sensor": "on what is measured",
    "rigid": "in the numbers of the rigid arm",
    "outside": "from outside, in a window of time",
}
_KINDS = {
    "algebraic": "Kernels have it as straight-line code",
    "state": "It has memory: kernels take `NAME_state` and `dt`",
    "sensor": "It is simulated and diagnosed, and in no kernel",
    "rigid": "It needs no code of its own",
    "outside": "It is reported and simulated, and in no kernel",
}
_SIGNS = {"any": "", "nonnegative": "0 or more", "positive": "above 0", "share": "above 0, at most 1"}
_WHERE = {
    "joint": "an entry of a link's `effects`",
    "pair": "an entry of the `effects` of the first joint's link",
    "robot": "an entry of the robot's `effects`",
}
_HEAD = """\
# Effects

What real arms have and rigid bodies with ideal motors lack: friction, springs, elasticity, payloads, sensor
errors. Each effect is defined once, and can be stated in a description, emitted in kernels, simulated, and
looked for in logs. This page is written by `robodyn effects --markdown` from the definitions in
`codegen/robodyn/effects/`; a test compares them. <!-- written by robodyn effects --markdown -->

Effects act along the drive of a joint, from the link to the motor. Each adds a torque, reflected to the
joint's side of the gear, in this order:

1. the torque of the rigid arm on the joint (at a prismatic joint a force), a payload included;
2. on the link's side: springs; then bearings, which feel the load;
3. between link and motor: elasticity or backlash; without them both move together;
4. in the gear: the loss, which depends on the torque that the gear transmits;
5. on the motor's side: the rotor's inertia, friction, ripple; motors that drive two joints.

With `torque_side: link` only 1 and 2 are in the torque.

**Near rest** the sign of the velocity is what `friction_at_rest` says: `exact` (the default: sgn 0 = 0; the
simulator lets joints stick and break away), `smooth: {velocity: v}` (tanh of velocity over v) or
`dead_band: {velocity: v}` (0 below v, half at v).

**Memory**: presliding, elastic joints and backlash have states in `inverse_dynamics`; all other functions
take the joint for stiff and its friction for that of steady motion. A call with an impossible sample leaves
the states unchanged: a position, velocity, acceleration or `dt` that is infinite or NaN, or a negative `dt`.
The torque of that call is NaN (with a bad `dt` alone it is that of the unchanged states), and the next good
sample gives the right torque again; only rates of a twist, which are differences over `dt`, need two calls. A
velocity that is finite and wrong deflects a presliding contact to its level at most.

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
        f"{name} is {_WHERE[effect.level]}. It acts {_PLACES[effect.place]}. {_KINDS[effect.kind]}.",
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
