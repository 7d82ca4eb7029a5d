"""The thesis's operation counts (Table 2.10), beside ours with a verdict.

Each formulation is held to its own method: the modified recursion to the thesis's (I), Balafoutis's to the
figure that the thesis quotes of him (VI). The other methods of the table are programs of others, whose
recursions are none of ours, and formulations that the table does not list have no figure in it.
"""

from __future__ import annotations

from dataclasses import dataclass

from robodyn.counts.count import Count
from robodyn.dynamics.functions import function_named
from robodyn.robot.model import Robot

#: Row of Table 2.10: multiplications, additions, and what is to be known of the printed figure.
TABLE_2_10: dict[str, tuple[int, int, str]] = {
    "puma_6": (
        208,
        152,
        "counts the listing of appendix D.3.4 as printed, one definition missing (208/153 completed); "
        "centre-of-mass terms of links 2 and 3 and lambda_1 p_1 are left out of it",
    ),
    "puma_3": (
        80,
        55,
        "counts an incomplete listing (D.3.3 uses quantities that it never defines): 84/58 completed, "
        "90/62 with the lambda_1 p_1 term that it drops",
    ),
    "stanford_6": (
        183,
        140,
        "no convention reproduces it from the listing D.3.2, which has 186/141 as printed and 184/137 "
        "corrected and without dead code",
    ),
    "stanford_3": (
        48,
        33,
        "counts the listing D.3.1 as printed, which has no joint variable q3; 58/40 with it and with "
        "lambda_1 p_1",
    ),
}

#: Method VI, quoted: row, multiplications, additions, and what is to be known of the figure.
TABLE_2_10_BALAFOUTIS: dict[str, tuple[int, int, str]] = {
    "puma_6": (
        277,
        255,
        "method VI, Balafoutis 1988, quoted by the thesis; for which parameters, it does not say",
    )
}
#: The rows of the table by the formulation that they are of.
_OWN_ROWS = {"modified_newton_euler": TABLE_2_10, "balafoutis": TABLE_2_10_BALAFOUTIS}


@dataclass(frozen=True, slots=True)
class Beside:
    """A printed count and how ours stands to it: ``reproduced``, ``lower`` or ``higher``."""

    table: str
    row: str
    mul: int
    add: int
    note: str
    verdict: str

    @property
    def total(self) -> int:
        """Multiplications and additions together."""
        return self.mul + self.add

    def to_dict(self) -> dict[str, object]:
        """As ``flops --json`` prints it."""
        return {
            "mul": self.mul, "add": self.add, "note": self.note,
            "table": self.table, "row": self.row, "verdict": self.verdict,
        }  # fmt: skip


def beside(
    robot: Robot, function: str, count: Count, formulation: str = "modified_newton_euler"
) -> Beside | None:
    """The thesis's figure for ``robot``'s inverse dynamics by ``formulation``, if its file names a row of
    Table 2.10 and the table has a figure of that formulation."""
    compare = robot.compare
    if not function_named(function).is_recursion or compare is None or compare.table != "2.10":
        return None
    printed = _OWN_ROWS.get(formulation, {}).get(compare.row)
    if printed is None:
        return None
    mul, add, note = printed
    return Beside("2.10", compare.row, mul, add, note, _verdict(count, mul, add))


def _verdict(count: Count, mul: int, add: int) -> str:
    difference = count.total - (mul + add)
    share = 100 * abs(difference) / (mul + add)
    if (count.mul, count.add) == (mul, add):
        return "reproduced"
    if difference == 0:
        return "differs: the same total, split otherwise"
    return f"differs: {abs(difference)} {'fewer' if difference < 0 else 'more'} ({share:.1f} %)"
