"""The page of an arm: one HTML file that asks for nothing, with the kernel that moves the arm within it.

Texts of a description are escaped wherever they stand. Beyond that the page's own policy names its scripts by
their hashes, so that no browser runs anything else.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from markupsafe import Markup, escape

from robodyn.draw.markup import json_text, markup_template, policy, script_text
from robodyn.draw.mathml import of_latex
from robodyn.emit.render import environment
from robodyn.report.arm_data import Arm
from robodyn.report.chart_frames import Chart, Frame, Mark, span
from robodyn.report.figures import formatted
from robodyn.report.schedule_pictures import gantt_svg, layers_svg
from robodyn.robot.account import account_lines

#: What the script is told of an arm; the rest of its data stands in the page.
_LIVE: Final = ("robot", "base", "reach", "joints", "links", "home", "kernel", "motion")
_MODULES: Final = ("report/arm_scene.js", "report/arm_kernel.js", "report/arm_panel.js", "report/arm_main.js")
_DYNAMICS: Final = r"\tau = M(q)\,\ddot q + h(q, \dot q) + g(q)"
#: Charts are drawn of so many joints at most.
_MOST_CHARTS: Final = 16
#: A task graph of more tasks, and a file of more characters, are too large to be looked at in a page.
_MOST_TASKS, _MOST_CODE = 600, 400_000


def page(arms: Sequence[Arm], comparison: dict[str, Any] | None = None) -> str:
    """The HTML of an arm, or of two beside each other with their ``comparison``."""
    scripts = [_kernel_script(arm) for arm in arms]
    scripts.append(script_text("".join(environment().get_template(name).render() for name in _MODULES)))
    return markup_template("arm.html.j2").render(
        arms=[_shown(arm) for arm in arms],
        pages=[arm.data for arm in arms],
        comparison=comparison,
        rows=_rows(arms),
        dynamics=Markup(of_latex(_DYNAMICS)),
        live=json_text([{key: arm.data[key] for key in _LIVE} for arm in arms]),
        scripts=scripts,
        policy=policy(scripts),
        version=arms[0].data["version"],
    )


def _kernel_script(arm: Arm) -> Markup:
    """The emitted module, and a line that hands its functions on."""
    (module,) = arm.kernel.files(("javascript",)).values()
    entries = arm.data["kernel"]["functions"]
    functions = ", ".join(f"{name}: {entry['symbol']}" for name, entry in entries.items())
    initial = "initial_state" if any(entry["remembers"] for entry in entries.values()) else "null"
    handed = f"(globalThis.robodynKernels ??= []).push({{ {functions}, initial_state: {initial} }});\n"
    return script_text(f"{module}\n{handed}")


# --- what the template is told ----------------------------------------------------------------------------


def _shown(arm: Arm) -> dict[str, Any]:
    data = arm.data
    kinds = [joint["kind"] for joint in data["joints"]]
    return {
        "name": data["robot"],
        "title": data["title"] or data["robot"],
        "kinds": " and ".join(f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds)),
        "length": formatted(data["reach"]),
        "mass": formatted(sum(link["mass"] for link in data["links"])),
        "hardest": _hardest(data),
        "doubts": _doubts(data["links"]),
        "account": list(account_lines(arm.robot)),
        "charts": [_motion_chart(data, j) for j in range(min(len(kinds), _MOST_CHARTS))],
        "effects": [_effect(effect) for effect in data["effects"]],
        "next_best": next((bar for bar in data["counts"]["bars"] if not bar["ours"]), None),
        "gantt": Markup(gantt_svg(arm.source, arm.solved)),
        "layers": Markup(layers_svg(arm.source)) if data["schedule"]["tasks"] <= _MOST_TASKS else None,
        "notes": arm.source.notes,
        "code": {
            name: (text, highlighted(text) if len(text) <= _MOST_CODE else None)
            for name, text in arm.generated.files(("c",)).items()
        },
    }


def _rows(arms: Sequence[Arm]) -> list[dict[str, Any]]:
    """A row of controls for each joint; of two arms that of the first where it has one."""
    first = arms[0].data["joints"]
    most = max(arms, key=lambda arm: arm.robot.n).data["joints"]
    rows = [*first, *most[len(first) :]]
    return [
        {**row, "name": "" if row["name"] == f"link{j}" else row["name"]} for j, row in enumerate(rows, 1)
    ]


def _doubts(links: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Each doubt once, with the links that it is about."""
    by_text: dict[tuple[str, str], list[str]] = {}
    for link in links:
        own = "" if link["name"] == f"link{link['link']}" else f" ({link['name']})"
        for doubt in link["doubts"]:
            by_text.setdefault((doubt["what"], doubt["acknowledged"]), []).append(f"{link['link']}{own}")
    return [{"what": what, "acknowledged": why, "links": places} for (what, why), places in by_text.items()]


def _hardest(data: dict[str, Any]) -> dict[str, Any] | None:
    """The joint that carries most of gravity along the motion."""
    peaks = [max(map(abs, column)) for column in data["motion"]["gravity"]]
    j = int(np.argmax(peaks))
    if not peaks[j]:
        return None
    return {"joint": j + 1, "torque": formatted(peaks[j]), "unit": data["joints"][j]["units"]["torque"]}


def _motion_chart(data: dict[str, Any], j: int) -> Chart:
    """The torque of joint ``j`` (from 0) along the motion, and what of it holds the arm."""
    path, unit = data["motion"], data["joints"][j]["units"]["torque"]
    total, holding = np.array(path["torque"][j]), np.array(path["gravity"][j])
    caption = f"{total.min():.3g} to {total.max():.3g} {unit}".replace("-", "−")
    curves = {"mean holding": holding, "mean total": total}
    return _chart(f"Joint {j + 1}", caption, ("t [s]", f"[{unit}]"), path["times"], curves, path["period"])


def _effect(effect: dict[str, Any]) -> dict[str, Any]:
    charts = [_effect_chart(effect["title"], curve) for curve in effect["curves"][:_MOST_CHARTS]]
    return {**effect, "equation": Markup(of_latex(effect["latex"])), "charts": charts}


def _effect_chart(title: str, curve: dict[str, Any]) -> Chart:
    ways = dict(zip(("mean total", "mean back total"), map(np.array, curve["torque"]), strict=False))
    labels = (f"{curve['over']} [{curve['unit']}]", f"[{curve['torque_unit']}]")
    peak = max(float(np.abs(y).max()) for y in ways.values())
    caption = f"up to {peak:.3g} {curve['torque_unit']}"
    return _chart(f"Joint {curve['joint']}: {title}", caption, labels, curve["x"], ways, curve["x"][-1])


def _chart(
    title: str, caption: str, labels: tuple[str, str], x: list[float], curves: dict[str, Any], end: float
) -> Chart:
    """A chart of ``curves`` over ``x`` up to ``end``, by the names of their looks."""
    frame = Frame(x[0], end, *span(*curves.values(), [0.0]))
    marks = [Mark(css, frame.line(np.array(x), y)) for css, y in curves.items()]
    return frame.chart(title, caption, labels, marks, most=(5, 3))


# --- the emitted C ----------------------------------------------------------------------------------------

_TOKEN: Final = re.compile(
    r"(?P<comment>/\*.*?\*/)|(?P<directive>^#.*?$)|(?P<keyword>\b(?:void|const|static|double|float|return)\b)"
    r"|(?P<number>(?<![\w.])\d+\.?\d*(?:e[+-]?\d+)?f?\b)",
    re.DOTALL | re.MULTILINE,
)


def highlighted(text: str) -> Markup:
    """C with its comments, directives, keywords and numbers marked."""
    parts, place = [], 0
    for match in _TOKEN.finditer(text):
        parts += [
            escape(text[place : match.start()]),
            Markup('<i class="{}">{}</i>').format((match.lastgroup or "")[0], match[0]),
        ]
        place = match.end()
    return Markup("").join([*parts, escape(text[place:])])
