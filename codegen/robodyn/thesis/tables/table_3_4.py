"""Table 3.4: parameters of friction, beside what Table 3.5 lets them be."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any, Final

from robodyn.thesis.case_arm import efficiency_point
from robodyn.thesis.printed_counts import TABLE_3_4, TABLE_3_5
from robodyn.thesis.tables.table import Column, Row, Table, Verdict
from robodyn.thesis.tables.table_3_5 import NEAR

_UNIT: Final = {"mu": "", "radius": " [m]", "breakaway": " [N m]", "largest torque": " [N m]"}

#: Torques of the arm's joints 1 to 3 in public programs for the PUMA 560 [N m], six joints of which have
#: breakaway torques of 6.3, 5.5, 2.6, 1.3, 1.0, 1.2 and largest ones of 97.6, 186.4, 89.4, 24.2, 20.1, 21.3.
PUBLISHED: Final = {
    "breakaway": ("6.3", "5.5", "2.6"),
    "largest torque": ("97.6", "186.4", "89.4"),
}


def table() -> Table:
    """A row for each printed figure."""
    return Table(
        "3.4",
        "parameters of friction of the PUMA 560's first three joints",
        (
            Column("printed", "printed", "value"),
            Column("at least", "ours", "least"),
            Column("at most", "ours", "most"),
        ),
        (*_bearings(), *_breakaways(), *_largest()),
        (
            "Ours: the range in which a figure must be for the torques of Table 3.5 to follow from it, the "
            "other figures being right. The thesis has the torques of the motors from Armstrong 1988; what "
            "public programs have of the same arm is beside. The span of the bearings is not given.",
        ),
    )


def _row(
    link: int, name: str, printed: Fraction, least: Fraction | None, most: Fraction | None, reason: str,
    verdict: Verdict | None = None,
) -> Row:  # fmt: skip
    inside = (least is None or least <= printed) and (most is None or printed <= most)
    published = PUBLISHED.get(name)
    beside: tuple[dict[str, Any], ...] = ()
    if published is not None:
        beside = ({"what": "public programs for the arm", "value": float(published[link - 1])},)
    return Row(
        f"link {link}, {name}{_UNIT[name]}",
        {"value": float(printed)},
        {"least": _figure(least), "most": _figure(most)},
        verdict or ("reproduced" if inside else "differs"),
        reason,
        beside,
    )


def _figure(x: Fraction | None) -> float | None:
    return None if x is None else float(f"{float(x):.3g}")


def _bearings() -> Iterator[Row]:
    from robodyn.thesis.tables.operating_point import bounds

    limits = bounds(NEAR).values()
    for link, (drive, row) in enumerate(zip(TABLE_3_4, TABLE_3_5, strict=True), 1):
        if link == 1:
            reason = "the span d of the bearings, which Eq 3.3 needs, is not given"
            for name, printed in (("mu", drive.mu), ("radius", drive.radius)):
                yield _row(link, name, printed, Fraction(0), None, reason, "not recoverable")
            continue
        least = Fraction(min(pair[link - 2] for pair in limits))  # friction with the printed mu r [N m]
        share = abs(row.joint_friction) / least
        reason = (
            f"with it the bearings take at least {float(least):.2f} N m where the torques are within "
            f"{NEAR:g} N m of Table 3.5's, which has {float(abs(row.joint_friction)):g} N m"
        )
        yield _row(link, "mu", drive.mu, Fraction(0), drive.mu * share, reason)
        yield _row(link, "radius", drive.radius, Fraction(0), drive.radius * share, reason)


def _breakaways() -> Iterator[Row]:
    """Table 3.2 with an efficiency above 0 and not above 1."""
    for link, (drive, row) in enumerate(zip(TABLE_3_4, TABLE_3_5, strict=True), 1):
        direction = 1 if row.joint_friction > 0 else -1
        # what the motor gives and the joint takes, along the motion; the rest is breakaway and efficiency
        motor, joint = row.input * direction, row.joint_total * direction
        least, most = (Fraction(0), motor - joint) if joint > 0 else (motor, motor - joint)
        reason = (
            "by Table 3.2 and Table 3.5 the efficiency is between 0 and 1 within these bounds, the motor "
            + ("driving" if joint > 0 else "braking")
        )
        yield _row(link, "breakaway", drive.breakaway, least, most, reason)


def _largest() -> Iterator[Row]:
    """An efficiency that rises with the load: the shares of the largest torques are in the efficiencies'
    order."""
    points = [efficiency_point(*rows) for rows in zip(TABLE_3_5, TABLE_3_4, strict=True)]
    for k, (point, drive, row) in enumerate(zip(points, TABLE_3_4, TABLE_3_5, strict=True)):
        others = [other for j, other in enumerate(points) if j != k]
        below = [other.load for other in others if other.efficiency < point.efficiency]
        above = [other.load for other in others if other.efficiency > point.efficiency]
        torque = abs(row.joint_total)
        least = torque / min(above) if above else torque
        most = torque / max(below) if below else None
        yield _row(
            k + 1, "largest torque", drive.largest, least, most,
            "within these bounds the efficiencies that Table 3.5 gives away rise with the load",
        )  # fmt: skip
