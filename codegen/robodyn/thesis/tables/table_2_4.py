"""Table 2.4: the steps of the modified Newton-Euler recursion, each tried as it is printed."""

from __future__ import annotations

from functools import partial
from typing import Final

from robodyn.thesis.slips.recursion import PUMA, STANFORD, Recursion, of_recursion
from robodyn.thesis.slips.rows import SLIPS
from robodyn.thesis.slips.slip import Slip
from robodyn.thesis.tables.equations import COLUMNS, slip_row
from robodyn.thesis.tables.table import Table

_PLACE: Final = "Table 2.4, "
_SAME: Final = "the same"
_REVOLUTE: Final = partial(of_recursion, Recursion, PUMA)
_PRISMATIC: Final = partial(of_recursion, Recursion, STANFORD)

#: The steps that are right as printed, with the arms on which they are tried.
_RIGHT: Final = (
    Slip("step 1", "w = R^T w + z qd", _SAME, _REVOLUTE),
    Slip("step 2", "alpha = R^T alpha + (w_y qd, -w_x qd, qdd)", _SAME, _REVOLUTE),
    Slip("step 3, revolute", "a = R^T (a + lambda p)", _SAME, _REVOLUTE),
    Slip(
        "step 3, prismatic", "besides 2 qd (w_y, -w_x, 0) + z qdd, along the slide's axes", _SAME, _PRISMATIC
    ),
    Slip("step 4", "a_c = a + lambda s", _SAME, _REVOLUTE),
    Slip("step 5", "F = m a_c", _SAME, _REVOLUTE),
    Slip("step 7", "f = F + R f", _SAME, _REVOLUTE),
    Slip("step 9, revolute", "tau = n_z", _SAME, _REVOLUTE),
)


def _order(step: Slip) -> tuple[str, bool]:
    """Steps by number, a prismatic joint's after a revolute one's."""
    step_number, _, kind = step.place.partition(",")
    return step_number, kind.strip() == "prismatic"


def table() -> Table:
    """The steps in their order; those with a slip as ``tables equations`` has them."""
    slips = [
        Slip(slip.place.removeprefix(_PLACE), slip.printed, slip.right, slip.check)
        for slip in SLIPS
        if slip.place.startswith(_PLACE)
    ]
    return Table(
        "2.4",
        "steps of the modified Newton-Euler recursion",
        COLUMNS,
        tuple(slip_row(step) for step in sorted((*_RIGHT, *slips), key=_order)),
        (
            f"Torques of the bundled robots {PUMA} and {STANFORD} (N at its slide) with one step as printed, "
            "the others right, against plain Newton-Euler. Where a step is right as printed the whole "
            "recursion is what is compared.",
        ),
    )
