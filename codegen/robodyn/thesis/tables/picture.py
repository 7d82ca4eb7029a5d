"""Tables 2.9 and 1.1 as a picture: what two methods cost a joint and an arm, and all formulations beside.

Left, Table 2.9: operations a joint by kind of joint, method I and II, printed and ours. Middle: a revolute
arm of n joints by the same figures. Right, Table 1.1: all formulations, as lines on a logarithmic scale. For
Figure 2.9 itself see :mod:`.picture_2_9`. SVG, the same bytes at any time.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, Final

from robodyn.counts.general import general_count
from robodyn.draw.markup import markup_template
from robodyn.dynamics.steps import Method
from robodyn.thesis.polynomial import value
from robodyn.thesis.printed_counts import TABLE_1_1, TABLE_2_9
from robodyn.thesis.tables import table_2_9
from robodyn.thesis.tables.table import summed
from robodyn.thesis.tables.table_1_1 import DESCRIBED, formulation

WIDTH: Final = 1180
HEIGHT: Final = 470
PANEL_HEIGHT: Final = 270
TOP: Final = 70
_BLUE, _ORANGE, _GREEN, _RED, _GREY = "#1f5fa8", "#d9822b", "#3a8f5c", "#b03a48", "#666666"
_DASHED: Final = "6 4"
_METHODS: Final[tuple[tuple[Method, str, str], ...]] = (("I", _BLUE, "#c6d8ec"), ("II", _ORANGE, "#f6dfc5"))
_NAMES: Final = {
    "uicker_kahn": ("Lagrange, closed form (Uicker, Kahn)", _RED),
    "hollerbach_4x4": ("Lagrange, 4x4 (Hollerbach)", _GREEN),
    "hollerbach_3x3": ("Lagrange, 3x3 (Hollerbach)", _GREY),
    "newton_euler": ("Newton-Euler (Luh, Walker, Paul)", _ORANGE),
}
_KINDS: Final = ("revolute", "prismatic")
JOINTS: Final = range(1, 7)


def operations_svg() -> str:
    """The picture, recomputed."""
    return markup_template("operations.svg.j2").render(
        width=WIDTH,
        height=HEIGHT,
        title="Operations of the inverse dynamics",
        description="Multiplications and additions of two Newton-Euler methods a joint and an arm, and of "
        "four formulations; printed in the thesis and recomputed.",
        panels=[_a_joint(60, 300), _an_arm(440, 300), _formulations(840, 300)],
    )


def _number(x: float) -> str:
    return f"{x:.1f}"


def _panel(x: int, width: int, title: str, subtitle: str, **parts: Any) -> dict[str, Any]:
    return {
        "x": x, "y": TOP, "width": width, "height": PANEL_HEIGHT, "label_y": PANEL_HEIGHT + 18,
        "title": title, "subtitle": subtitle, "bars": [], "lines": [], **parts,
    }  # fmt: skip


def _a_joint(x: int, width: int) -> dict[str, Any]:
    top = 280
    bars = []
    slot = width / 2
    for k, kind in enumerate(_KINDS):
        figures = []
        for method, strong, pale in _METHODS:
            printed = sum(TABLE_2_9[f"{kind}_{method}"]["total"])
            ours = summed(*table_2_9.counts(method, kind == "revolute").values()).total
            figures += [(method, "printed", printed, pale, strong), (method, "ours", ours, strong, strong)]
        for i, (method, who, figure, fill, stroke) in enumerate(figures):
            left, height = k * slot + 15 + 31 * i + 6 * (i // 2), PANEL_HEIGHT * figure / top
            bars.append(
                {
                    "x": _number(left), "y": _number(PANEL_HEIGHT - height), "width": 27,
                    "height": _number(height), "fill": fill, "stroke": stroke, "label": figure,
                    "middle": _number(left + 13.5), "label_y": _number(PANEL_HEIGHT - height - 5),
                    "name": f"{kind}, method {method}, {who}: {figure}",
                }
            )  # fmt: skip
    legend = [
        _key(0, row, stroke, f"method {method}, {who}", thickness=9)
        for row, (method, who, stroke) in enumerate(
            (method, who, colour)
            for method, strong, pale in _METHODS
            for who, colour in (("printed", pale), ("ours", strong))
        )
    ]
    return _panel(
        x, width, "A joint", "operations by kind of joint, Table 2.9",
        bars=bars,
        y_ticks=_ticks(range(0, top + 1, 40), lambda y: PANEL_HEIGHT * (1 - y / top)),
        x_ticks=[{"at": _number(slot * (k + 0.47)), "label": kind} for k, kind in enumerate(_KINDS)],
        legend=legend,
    )  # fmt: skip


def _an_arm(x: int, width: int) -> dict[str, Any]:
    top = 1600
    lines: list[dict[str, str]] = []
    legend: list[dict[str, Any]] = []

    def height(y: float) -> float:
        return PANEL_HEIGHT * (1 - y / top)

    for method, strong, _ in _METHODS:
        printed = sum(TABLE_2_9[f"revolute_{method}"]["total"])
        ours = summed(*table_2_9.counts(method, True).values()).total
        for who, a_joint, dashes in (("printed", printed, _DASHED), ("ours", ours, "")):
            name = f"method {method}, {who}: {a_joint} n"
            lines.append(_line([a_joint * n for n in JOINTS], width, height, strong, name, dashes))
            legend.append(_key(0, len(legend), strong, name, dashes=dashes))
    return _panel(
        x, width, "An arm", "n revolute joints by the figures of a joint",
        lines=lines,
        y_ticks=_ticks(range(0, top + 1, 200), height),
        x_ticks=_joint_ticks(width),
        legend=legend,
    )  # fmt: skip


def _formulations(x: int, width: int) -> dict[str, Any]:
    low, high = 1.5, 6.0
    lines: list[dict[str, str]] = []
    legend: list[dict[str, Any]] = []

    def height(y: float) -> float:
        return PANEL_HEIGHT * (1 - (math.log10(y) - low) / (high - low))

    for name, (label, colour) in _NAMES.items():
        run, printed = formulation(DESCRIBED[name].formulation), TABLE_1_1[name]
        ours = []
        for n in JOINTS:
            counts = general_count(run, n, dense=True)
            ours.append(counts.mul + counts.add)
        polynomial = [float(value(printed.mul, n) + value(printed.add, n)) for n in JOINTS]
        lines.append(_line(polynomial, width, height, colour, f"{label}, printed", _DASHED))
        lines.append(_line(ours, width, height, colour, f"{label}, ours", ""))
        legend.append(_key(0, len(legend), colour, label))
    legend.append(_key(0, len(legend), "#222", "dashed: printed, Table 1.1", dashes=_DASHED))
    return _panel(
        x, width, "All formulations", "n revolute joints, of which nothing is special",
        lines=lines,
        y_ticks=_ticks([10**k for k in range(2, 7)], height),
        x_ticks=_joint_ticks(width),
        legend=legend,
    )  # fmt: skip


def _at(n: int, width: int) -> float:
    return width * (n - 0.5) / len(JOINTS)


def _joint_ticks(width: int) -> list[dict[str, str]]:
    return [{"at": _number(_at(n, width)), "label": str(n)} for n in JOINTS]


def _ticks(values: Sequence[int], height: Callable[[float], float]) -> list[dict[str, str]]:
    return [{"at": _number(height(y)), "label": f"{y:,}".replace(",", " ")} for y in values]


def _line(
    values: Sequence[float],
    width: int,
    height: Callable[[float], float],
    stroke: str,
    name: str,
    dashes: str,
) -> dict[str, str]:
    points = " ".join(
        f"{_number(_at(n, width))},{_number(height(y))}" for n, y in zip(JOINTS, values, strict=True)
    )
    return {"points": points, "stroke": stroke, "dashes": dashes, "name": name}


def _key(
    x: int, row: int, stroke: str, label: str, *, thickness: int = 2, dashes: str = ""
) -> dict[str, Any]:
    return {
        "x": x, "x_end": x + 26, "text_x": x + 33, "y": PANEL_HEIGHT + 46 + 18 * row, "stroke": stroke,
        "label": label, "thickness": thickness, "dashes": dashes,
    }  # fmt: skip
