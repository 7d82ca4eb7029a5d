"""An effect in numbers: an entry that is usual of a joint, and the curve of the torque that it adds there."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Final

import numpy as np

from robodyn.draw.scales import label, share, ticks
from robodyn.effects.effect import Effect, Site
from robodyn.effects.traits import Usual

#: A revolute joint of an arm of middle size, as a blind test would meet it.
_JOINT: Final = Usual(
    joint=2, joints=6, revolute=True, mass=8.0, duration=10.0, tau=30.0, peak=80.0, speed=0.8, rate=3.0,
    slow=0.05, weight=2.0, middle=0.0, gravity=40.0, upright=1.57,
)  # fmt: skip
#: Larger effects than those that are hidden, so that their shape is seen.
_LARGER: Final = 2.0
_POINTS: Final = 241
#: What an effect may be drawn over: what its equation reads, its unit, and how far the axis reaches.
_AXES: Final = {
    "position": ("q", "rad", math.pi),
    "velocity": ("qd", "rad/s", 1.5),
    "acceleration": ("qdd", "rad/s²", 10.0),
    "load": ("tau", "N m", 100.0),
}
#: A motion to and fro that bends what remembers: amplitude [rad], turns of its phase, time step [s].
_SWAY, _TURNS, _STEP = 0.05, 1.25, 1e-3
#: Of the frame within the picture, px.
_WIDTH, _HEIGHT, _LEFT, _TOP = 420, 220, 58, 14
Values = Mapping[str, Any]
Points = Sequence[tuple[float, float]]


@dataclass(frozen=True, slots=True)
class Picture:
    """Lines over one axis; ``names`` tell them apart where there are two."""

    across: str
    up: str
    lines: tuple[Points, ...]
    names: tuple[str, ...] = ()


def usual_values(effect: Effect) -> dict[str, Any]:
    """Parameters of ``effect`` that are usual at a joint, three digits each; none where nothing says so."""
    hidden = effect.traits.hidden
    if hidden is None:
        return {}
    form = hidden.form(_JOINT, 1.0, np.random.default_rng(0))
    built = form.build(min(_LARGER * form.start, form.most))
    if not set(built) <= set(effect.names):  # numbers of a vector, one by one
        return {}
    return {name: x if isinstance(x, str) else float(f"{x:.3g}") for name, x in built.items()}


def entry(effect: Effect, values: Values) -> str:
    """An entry of a description."""
    integers = {p.name for p in effect.parameters if p.kind == "joint"}
    settings = ", ".join(
        f"{name}: {int(value) if name in integers else value if isinstance(value, str) else f'{value:g}'}"
        for name, value in values.items()
    )
    return f"effects:\n  - {{effect: {effect.id}, {settings}}}"


def picture(effect: Effect, values: Values) -> Picture | None:
    """The torque that ``effect`` adds over what decides it; None where it is no curve over one quantity."""
    over, _, ways = effect.traits.over.partition(", ")
    every = {p.name: _number(p.default) for p in effect.parameters if p.default is not None} | dict(values)
    if effect.coupler is not None:
        twist = effect.coupler.twist
        points = [(x, float(twist(every, x))) for x in _spaced(_AXES["load"][2])]
        return Picture("torque [N m]", "twist, motor less link [rad]", (points,))
    if effect.memory is not None:
        return Picture("position [rad]", "torque [N m]", (_there_and_back(effect, every),))
    if effect.equation is None:
        return None
    equation = effect.equation
    if effect.traits.cycles:
        reach = 2 * math.pi / float(every[effect.traits.cycles])
        line = [(x, float(equation(every, Site(True, q=x)))) for x in _spaced(reach)]
        return Picture("position [rad]", "torque [N m]", (line,))
    if over not in _AXES:
        return None
    reads, unit, reach = _AXES[over]

    def torque(x: float, way: float) -> float:
        direction = math.copysign(1.0, x) if reads == "qd" else way
        state: dict[str, Any] = {reads: x, "direction": direction}
        if reads == "tau":
            state |= {"f": (x, 0.0, 0.0), "n": (0.0, 0.0, x)}
        return float(equation(every, Site(True, **state)))

    lines = [[(x, torque(x, way)) for x in _spaced(reach)] for way in ((1.0, -1.0) if ways else (1.0,))]
    names = ("moving forward", "moving backward") if ways else ()
    return Picture(f"{over} [{unit}]", "torque [N m]", tuple(lines), names)


def svg(title: str, shown: Picture) -> str:
    """The picture as SVG within a page, in the page's colours."""
    across = ticks([x for line in shown.lines for x, _ in line], tight=True)
    up = ticks([y for line in shown.lines for _, y in line])

    def at(x: float, y: float) -> tuple[float, float]:
        return round(_LEFT + _WIDTH * share(x, across), 1), round(_TOP + _HEIGHT * (1 - share(y, up)), 1)

    bottom, right = _TOP + _HEIGHT, _LEFT + _WIDTH
    marks = [
        f'<path class="grid" d="M{at(x, 0)[0]} {_TOP}V{bottom}"/>'
        f'<text x="{at(x, 0)[0]}" y="{bottom + 16}" text-anchor="middle">{label(x)}</text>'
        for x in across
    ]
    marks += [
        f'<path class="grid" d="M{_LEFT} {at(across[0], y)[1]}H{right}"/>'
        f'<text x="{_LEFT - 6}" y="{at(across[0], y)[1] + 4}" text-anchor="end">{label(y)}</text>'
        for y in up
    ]
    paths = [" ".join(f"{a},{b}" for a, b in (at(*point) for point in line)) for line in shown.lines]
    lines = [f'<polyline class="line{k}" points="{path}"/>' for k, path in enumerate(paths)]
    keys = "".join(f'<span class="line{k}">{name}</span>' for k, name in enumerate(shown.names))
    return (
        f'<figure class="curve"><svg viewBox="0 0 {right + 18} {bottom + 26}" role="img" aria-label='
        f'"{title}: {shown.up} over {shown.across}">{"".join(marks)}{"".join(lines)}</svg>'
        f"<figcaption>{shown.up} over {shown.across}{': ' if keys else ''}{keys}</figcaption></figure>"
    )


def _there_and_back(effect: Effect, values: Values) -> Points:
    """The torque of an effect that remembers, on a motion to and fro from rest."""
    memory = effect.memory
    assert memory is not None
    state: tuple[Any, ...] = tuple(0.0 for _ in memory.names)
    points = []
    for k in range(int(_TURNS / _STEP)):
        phase = 2 * math.pi * k * _STEP
        q, qd = _SWAY * math.sin(phase), 2 * math.pi * _SWAY * math.cos(phase)
        site = Site(True, q=q, qd=qd, direction=math.copysign(1.0, qd))
        state, torque = memory.step(values, site, state, _STEP)
        points.append((q, float(torque)))
    return points[:: max(1, len(points) // _POINTS)]


def _spaced(reach: float) -> Iterable[float]:
    return [reach * (2 * k / (_POINTS - 1) - 1) for k in range(_POINTS)]


def _number(value: Fraction | str | None) -> Any:
    return float(value) if isinstance(value, Fraction) else value
