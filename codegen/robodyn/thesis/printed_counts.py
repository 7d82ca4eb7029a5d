"""Figures as the thesis prints them: data, slips included, for the tables that stand beside ours.

Source: Dhanaraj 1990. A pair is multiplications and additions. What is wrong with a figure is said where it
is set beside ours (:mod:`robodyn.thesis.tables`).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Final

from robodyn.counts.thesis import TABLE_2_10, TABLE_2_10_BALAFOUTIS

Pair = tuple[int, int]


@dataclass(frozen=True, slots=True)
class PrintedCost:
    """A formulation's row of Table 1.1: coefficients from the highest power of n to the constant, and the
    values that the table gives for six joints."""

    mul: tuple[Fraction, ...]
    add: tuple[Fraction, ...]
    mul_6: int
    add_6: int
    total_6: int


def _coefficients(*numbers: str) -> tuple[Fraction, ...]:
    return tuple(map(Fraction, numbers))


TABLE_1_1: Final = {
    "uicker_kahn": PrintedCost(
        _coefficients("65/2", "1037/12", "685/4", "160/3", "-128"),
        _coefficients("25", "199/3", "259/2", "127/3", "-96"),
        66271, 51548, 117819,
    ),
    "hollerbach_4x4": PrintedCost(
        _coefficients("830", "-592"), _coefficients("675", "-464"), 4388, 3586, 7974
    ),
    "hollerbach_3x3": PrintedCost(
        _coefficients("412", "-277"), _coefficients("320", "-201"), 2195, 1719, 3914
    ),
    "newton_euler": PrintedCost(_coefficients("150", "-48"), _coefficients("131", "-48"), 852, 738, 1590),
}  # fmt: skip

#: Table 2.9, operations a joint by method and step: I the lambda matrix, II cross products.
TABLE_2_9: Final[dict[str, dict[str, Pair]]] = {
    "revolute_I": {
        "omega": (9, 7), "alpha": (11, 9), "lambda": (6, 9), "a": (18, 15), "a_c": (9, 9), "F": (3, 0),
        "N": (6, 3), "f": (0, 3), "f_rotated": (9, 6), "n": (21, 15), "total": (92, 76),
    },
    "revolute_II": {
        "omega": (9, 7), "alpha": (24, 19), "lambda": (0, 0), "a": (27, 21), "a_c": (18, 15), "F": (3, 0),
        "N": (24, 18), "f": (9, 9), "f_rotated": (0, 0), "n": (21, 24), "total": (135, 123),
    },
    "prismatic_I": {
        "omega": (0, 0), "alpha": (0, 0), "lambda": (0, 0), "a": (20, 18), "a_c": (9, 9), "F": (3, 0),
        "N": (6, 3), "f": (0, 3), "f_rotated": (9, 6), "n": (12, 15), "total": (59, 54),
    },
    "prismatic_II": {
        "omega": (0, 0), "alpha": (0, 0), "lambda": (0, 0), "a": (33, 26), "a_c": (18, 15), "F": (3, 0),
        "N": (24, 18), "f": (9, 9), "f_rotated": (0, 0), "n": (21, 24), "total": (108, 92),
    },
}  # fmt: skip

METHODS: Final = {
    "I": "thesis",
    "II": "Murray and Neuman 1988",
    "III": "Toogood 1989",
    "IV": "Khalil 1986",
    "V": "Burdick 1986",
    "VI": "Balafoutis 1988",
}
"""The methods of Table 2.10; II to VI are figures that the thesis quotes."""

TABLE_2_10_QUOTED: Final[dict[str, dict[str, Pair]]] = {
    "puma_3": {"II": (55, 42), "III": (114, 81)},
    "stanford_3": {"II": (40, 24)},
    "puma_6": {
        "II": (152, 249),
        "III": (441, 365),
        "IV": (214, 176),
        "V": (401, 254),
        "VI": TABLE_2_10_BALAFOUTIS["puma_6"][:2],
    },
    "stanford_6": {"II": (183, 147), "III": (338, 276), "IV": (187, 152)},
}

#: What the listings of appendix D.3, whose counts method I gives, hold: lines as printed, and with the
#: definitions that are missing. Counted by robodyn's authors on the listings, which are not part of robodyn.
LISTINGS: Final[dict[str, tuple[Pair, Pair]]] = {
    "puma_3": ((80, 55), (84, 58)),
    "stanford_3": ((48, 33), (48, 33)),
    "puma_6": ((208, 152), (208, 153)),
    "stanford_6": ((186, 141), (187, 142)),
}

TABLE_3_3: Final[dict[str, dict[str, Pair]]] = {
    "frictionless": {"revolute": (92, 76), "prismatic": (59, 54)},
    "joint": {"revolute": (15, 5), "prismatic": (10, 7)},
    "transmission": {"cubic_spline": (5, 4), "linear": (2, 2)},
    "total_cubic": {"revolute": (112, 85), "prismatic": (74, 65)},
    "total_linear": {"revolute": (109, 83), "prismatic": (71, 63)},
}


@dataclass(frozen=True, slots=True)
class PrintedDrive:
    """A row of Table 3.4: coefficient of friction, radius of the journals [m], breakaway torque and largest
    torque [N m]."""

    mu: Fraction
    radius: Fraction
    breakaway: Fraction
    largest: Fraction


TABLE_3_4: Final = tuple(
    PrintedDrive(*_coefficients(*row.split()))
    for row in ("0.1 0.10 6.3 97.6", "0.1 0.08 5.5 186.4", "0.1 0.07 2.6 89.4")
)


@dataclass(frozen=True, slots=True)
class PrintedTorques:
    """A row of Table 3.5 [N m]."""

    dynamic: Fraction
    joint_friction: Fraction
    joint_total: Fraction
    transmission: Fraction
    input: Fraction


#: Torques of the three joints 0.6 s into the case study's motion.
TABLE_3_5: Final = tuple(
    PrintedTorques(*_coefficients(*row.split()))
    for row in (
        "1.2140 1.7803 2.9943 9.8968 12.8911",
        "-15.6364 -0.3281 -15.9646 -17.9472 -33.9117",
        "-0.8042 0.1241 -0.6801 3.0449 2.3648",
    )
)


def table_2_10() -> dict[str, dict[str, Pair]]:
    """Table 2.10: by row and method, method I being the thesis's own."""
    return {row: {"I": (mul, add), **TABLE_2_10_QUOTED[row]} for row, (mul, add, _) in TABLE_2_10.items()}
