"""Tables 2.9 and 1.1 as a picture: what two methods cost a joint and an arm, and all formulations beside.

Left, Table 2.9: operations a joint by kind of joint, method I and II, printed and ours. Middle: a revolute
arm of n joints by the same figures. Right, Table 1.1: all formulations, as lines on a logarithmic scale. For
Figure 2.9 itself see :mod:`.picture_2_9`. SVG, the same bytes at any time.
"""

from __future__ import annotations

from typing import Final

from robodyn.counts.general import general_count
from robodyn.draw.panels import Bars, Curve, Panel, figure
from robodyn.draw.style import BLUE, GREEN, PURPLE, VERMILION
from robodyn.thesis.method_steps import Method
from robodyn.thesis.polynomial import value
from robodyn.thesis.printed_counts import TABLE_1_1, TABLE_2_9
from robodyn.thesis.tables import table_2_9
from robodyn.thesis.tables.table import summed
from robodyn.thesis.tables.table_1_1 import DESCRIBED, formulation

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
    """The picture, recomputed."""
    return figure(
        "Operations of the inverse dynamics",
        "Multiplications and additions together; dashed and pale: printed in the thesis, else recomputed",
        (_a_joint(), _an_arm(), _formulations()),
    )


def _printed(method: Method, kind: str) -> int:
    return sum(TABLE_2_9[f"{kind}_{method}"]["total"])


def _ours(method: Method, kind: str) -> int:
    return summed(*table_2_9.counts(method, kind == "revolute").values()).total


def _a_joint() -> Panel:
    return Panel(
        "A joint, Table 2.9", "kind of joint", "operations",
        bars=tuple(
            Bars(f"method {method}, {who}", [totals(method, kind) for kind in _KINDS], colour, is_pale)
            for method, colour in _METHODS
            for who, totals, is_pale in (("printed", _printed, True), ("ours", _ours, False))
        ),
        categories=_KINDS,
    )  # fmt: skip


def _an_arm() -> Panel:
    curves = []
    for method, colour in _METHODS:
        for who, a_joint, dashed in (
            ("printed", _printed(method, "revolute"), True), ("ours", _ours(method, "revolute"), False),
        ):  # fmt: skip
            name = f"method {method}, {who}: {a_joint} n"
            curves.append(Curve(name, JOINTS, [a_joint * n for n in JOINTS], dashed, colour))
    return Panel("An arm by the figures of a joint", "revolute joints n", "operations", tuple(curves))


def _formulations() -> Panel:
    curves = []
    for name, (title, colour) in _NAMES.items():
        run, printed = formulation(DESCRIBED[name].formulation), TABLE_1_1[name]
        counts = [general_count(run, n, dense=True) for n in JOINTS]
        polynomial = [float(value(printed.mul, n) + value(printed.add, n)) for n in JOINTS]
        curves.append(Curve("", JOINTS, polynomial, True, colour))
        curves.append(Curve(title, JOINTS, [one.mul + one.add for one in counts], False, colour))
    return Panel(
        "All formulations, Table 1.1", "revolute joints n, of which nothing is special",
        "operations, logarithmic", tuple(curves), logarithmic=True,
    )  # fmt: skip
