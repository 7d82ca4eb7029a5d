"""Pictures of tables: what two methods cost a joint and an arm, and all formulations beside (2.9 and 1.1),
Figure 2.9, and the operations of some bundled robots. SVG, the same bytes at any time."""

from __future__ import annotations

from typing import Final

from robodyn.counts.general import general_count
from robodyn.draw.panels import Bars, Curve, Panel, figure
from robodyn.draw.style import BLUE, GREEN, GREY, ORANGE, OURS, PURPLE, SKY, VERMILION
from robodyn.thesis.polynomial import value
from robodyn.thesis.printed import METHODS, TABLE_1_1, TABLE_2_9
from robodyn.thesis.steps import Method
from robodyn.thesis.tables import Table, make
from robodyn.thesis.tables.formulations import formulation
from robodyn.thesis.tables.operations import joint_count

_METHODS: Final[tuple[tuple[Method, str], ...]] = (("I", BLUE), ("II", VERMILION))
_NAMES: Final = {
    "uicker_kahn": ("Lagrange, closed form (Uicker, Kahn)", PURPLE),
    "hollerbach_4x4": ("Lagrange, 4x4 (Hollerbach)", GREEN),
    "hollerbach_3x3": ("Lagrange, 3x3 (Hollerbach)", VERMILION),
    "newton_euler": ("Newton-Euler (Luh, Walker, Paul)", BLUE),
}
_KINDS: Final = ("revolute", "prismatic")
JOINTS: Final = range(1, 7)


def operations_svg() -> str:
    """Left, Table 2.9: operations a joint by kind of joint, method I and II, printed and ours. Middle: a
    revolute arm of n joints by the same figures. Right, Table 1.1: all formulations, logarithmic."""
    bars, lines, curves = [], [], []
    for method, colour in _METHODS:
        printed = [sum(TABLE_2_9[f"{kind}_{method}"]["total"]) for kind in _KINDS]
        ours = [joint_count(method, kind == "revolute").total for kind in _KINDS]
        for who, totals, is_printed in (("printed", printed, True), ("ours", ours, False)):
            bars.append(Bars(f"method {method}, {who}", totals, colour, is_printed))
            name = f"method {method}, {who}: {totals[0]} n"
            lines.append(Curve(name, JOINTS, [totals[0] * n for n in JOINTS], is_printed, colour))
    for name, (title, colour) in _NAMES.items():
        run, cost = formulation(name), TABLE_1_1[name]
        polynomial = [float(value(cost.mul, n) + value(cost.add, n)) for n in JOINTS]
        curves.append(Curve("", JOINTS, polynomial, True, colour))
        counts = (general_count(run, n, dense=True) for n in JOINTS)
        curves.append(Curve(title, JOINTS, [count.mul + count.add for count in counts], False, colour))
    panels = (
        Panel("A joint, Table 2.9", "kind of joint", "operations", bars=tuple(bars), categories=_KINDS),
        Panel("An arm by the figures of a joint", "revolute joints n", "operations", tuple(lines)),
        Panel(
            "All formulations, Table 1.1", "revolute joints n, of which nothing is special",
            "operations, logarithmic", tuple(curves), logarithmic=True,
        ),
    )  # fmt: skip
    return figure(
        "Operations of the inverse dynamics",
        "Multiplications and additions together; dashed and pale: printed in the thesis, else recomputed",
        panels,
    )


def figure_2_9_svg(table: Table | None = None) -> str:
    """Figure 2.9: Table 2.10's totals for the PUMA's six joints by published methods, ours beside; of
    ``table`` 2.10 where it is at hand."""
    table = table or make("2.10")
    rows = [table.row(f"puma_6, {method}") for method in METHODS]
    printed = [row.printed["operations"]["total"] for row in rows]
    ours = [(row.ours["method"] or row.ours["default"])["total"] for row in rows]
    panel = Panel(
        "PUMA 560, six joints", "method, by whom", "multiplications and additions",
        bars=(Bars("printed in Table 2.10", printed, OURS, pale=True), Bars("ours", ours, OURS)),
        categories=tuple(f"{method}, {who}" for method, who in METHODS.items()),
    )  # fmt: skip
    return figure(
        "Figure 2.9, redrawn: operations by published methods",
        "Totals of Table 2.10; ours: by that method where it is known (I, IV, VI), else by robodyn gen",
        [panel],
        width=720,
    )


#: One parameter set of each arm of six or seven joints that another tool was counted on.
SHOWN: Final = ("ur10", "stanford_d3", "puma560_d2", "rx90", "iiwa", "panda")


def robots_svg(table: Table | None = None) -> str:
    """Operations of some bundled robots as bars: the textbook's recursion, OpenSYMORO, the thesis, ours; of
    the table ``robots`` where it is at hand."""
    rows = list(map((table or make("robots")).row, SHOWN))
    textbook, ours = ([row.ours[level]["total"] for row in rows] for level in ("none", "default"))
    bars = (
        Bars("textbook's recursion, common subexpressions computed once", textbook, GREY, pale=True),
        Bars("the thesis, Table 2.10", [row.printed.get("total") for row in rows], SKY),
        Bars("OpenSYMORO, base parameters", [row.ours["opensymoro"] for row in rows], ORANGE),
        Bars("robodyn gen", ours, OURS),
    )
    panel = Panel(
        "One call of the inverse dynamics", "robot", "multiplications and additions",
        bars=bars, categories=SHOWN,
    )  # fmt: skip
    return figure(
        "Operations of the inverse dynamics",
        "Multiplications and additions of one call for bundled robots, by robodyn and by others",
        [panel],
        width=840,
    )
