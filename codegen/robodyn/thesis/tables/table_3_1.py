"""Table 3.1: friction of the kinds of joints, beside the statics of two bearings."""

from __future__ import annotations

from functools import partial
from typing import Final

from robodyn.thesis.slips import friction
from robodyn.thesis.slips.slip import Slip
from robodyn.thesis.tables.equations import COLUMNS, slip_row
from robodyn.thesis.tables.table import Table

_SAME: Final = "the same"

#: The table's kinds of joints with the equations that it puts together.
KINDS: Final = (
    Slip(
        "revolute, journal, force (Eq 3.2)", "mu r sqrt(f_x^2 + f_y^2) sgn(qd)", _SAME,
        friction.journal_bearing_without_moment,
    ),
    Slip(
        "revolute, two journals (Eq 3.3)",
        "mu r / d times two roots, n_x and n_y with equal signs in each",
        "opposite signs: one root of (d f_x/2 + n_y)^2 + (d f_y/2 - n_x)^2, one of the other two",
        friction.journal_bearing,
    ),
    Slip(
        "prismatic, two sliding bearings (Eq 3.4)",
        "mu / d times |d f_x/2 + n_y| + |d f_x/2 - n_y| and the same of f_y and n_x", _SAME,
        friction.linear_bearing,
    ),
    Slip(
        "revolute, thrust bearing", "mu r |f_z| sgn(qd); Eq 3.5 has f_x", _SAME,
        partial(friction.thrust_bearing, 2),
    ),
)  # fmt: skip


def table() -> Table:
    """The kinds of bearings, each tried on random loads."""
    return Table(
        "3.1",
        "friction of the kinds of joints",
        COLUMNS,
        tuple(map(slip_row, KINDS)),
        (
            "Reference: the loads of two bearings at z = d/2 and -d/2 that are in equilibrium with the force "
            "and the moment of the joint, solved for; mu times each load, a journal's times its radius. The "
            "text's equations stand for the table's entries, of which f_z is the one that they differ in.",
        ),
    )
