"""Table 3.5: the case study's torques at 0.6 s; what follows from its own columns, and what nothing gives."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any, Final

from robodyn.effects import thesis_friction as friction
from robodyn.thesis.case_arm import EfficiencyPoint, efficiency_point, efficiency_points
from robodyn.thesis.printed_counts import TABLE_3_4, TABLE_3_5, PrintedDrive, PrintedTorques
from robodyn.thesis.tables.table import Column, Row, Table, judged

#: Half of what the last digit of three rounded numbers can be off by.
EXACT: Final = Fraction(1, 10000)
#: How near to Table 3.5 torques are asked to be where joint friction is bounded [N m].
NEAR: Final = 4.0
_DIGITS: Final = 4


def table() -> Table:
    """Printed torques beside what follows from them."""
    links = list(zip(TABLE_3_5, TABLE_3_4, strict=True))
    rows = (
        *(_sum(k, row, "joint_total") for k, row in enumerate(TABLE_3_5, 1)),
        *(_sum(k, row, "input") for k, row in enumerate(TABLE_3_5, 1)),
        _sign_rule(),
        *(_efficiency(k, row, drive) for k, (row, drive) in enumerate(links, 1)),
        _dynamic(),
        _free_friction(),
        *_bounded(),
        *_lost(),
    )
    return Table(
        "3.5",
        "torques of the case study at 0.6 s, three joints of the PUMA 560",
        (Column("printed", "printed", "torque"), Column("ours", "ours", "torque")),
        rows,
        (
            "N m. Ours: the printed columns put together by Eq 3.6 and Table 3.2, exactly, with the "
            "breakaway torques of Table 3.4. What the thesis gives of the motion: the line y = z, its start, "
            "201 samples in 2 s. robodyn case-study runs a new study on stated assumptions.",
        ),
    )


def _sum(link: int, row: PrintedTorques, column: str) -> Row:
    if column == "joint_total":
        printed, total = row.joint_total, row.dynamic + row.joint_friction
        what = "dynamic and joint friction, each with its sign"
    else:
        printed, total = row.input, row.joint_total + row.transmission
        what = "joint total and transmission, each with its sign"
    same = abs(total - printed) <= EXACT
    reason = f"the sum of {what}{', to the last digit but one' if total != printed and same else ''}"
    return Row(
        f"link {link}, {column.replace('_', ' ')}",
        {"torque": _plain(printed)},
        {"torque": _plain(total)},
        judged(same),
        reason if same else f"not {reason}",
    )


def _sign_rule() -> Row:
    row = TABLE_3_5[1]
    by_3_6 = friction.with_friction(row.dynamic, row.joint_friction)
    by_3_7 = row.dynamic - row.joint_friction  # sgn(qd) = -1, a second time
    same = abs(by_3_6 - row.joint_total) <= EXACT < abs(by_3_7 - row.joint_total)
    return Row(
        "link 2, sign rule",
        {"torque": _plain(row.joint_total)},
        {"torque": _plain(by_3_6), "by_eq_3_7": _plain(by_3_7)},
        judged(same),
        "the signed sum of Eq 3.6 covers what Eq 3.7 is for: the printed friction carries sgn(qd) already, "
        f"and counted again as in Eq 3.7 the sum would be {_plain(by_3_7)}",
    )


def _efficiency(link: int, row: PrintedTorques, drive: PrintedDrive) -> Row:
    point = efficiency_point(row, drive)
    eta, load = round(point.efficiency, _DIGITS), round(point.load, _DIGITS)
    direction = 1 if row.joint_friction > 0 else -1
    case = friction.driving if point.drives else friction.braking
    efficiency = case(row.joint_total, eta, drive.breakaway, direction)
    possible = 0 < eta <= 1 and _rises()
    return Row(
        f"link {link}, efficiency",
        {"torque": _plain(row.input)},
        {
            "torque": _plain(round(efficiency, _DIGITS)),
            "efficiency": _plain(eta),
            "load_fraction": _plain(load),
            "case": "drives" if point.drives else "brakes",
        },
        judged(possible and abs(efficiency - row.input) <= 20 * EXACT),
        f"Table 3.2 gives it with the efficiency {_plain(eta)} at {_plain(load)} of the largest torque, "
        f"where the motor {'drives' if point.drives else 'brakes'}; the three points rise with the load, and "
        "are all that can be recovered of the curve"
        if possible
        else "no efficiency gives it",
    )


def _rises() -> bool:
    points: list[EfficiencyPoint] = sorted(efficiency_points(), key=lambda point: point.load)
    return all(a.efficiency < b.efficiency for a, b in pairwise(points))


def _dynamic() -> Row:
    from robodyn.thesis.tables.operating_point import SETS, closest, nearest, on_the_path_of_d4

    path = on_the_path_of_d4()
    off, z = closest("puma560_3dof_d12", path)
    highest = float(path.z[path.fitting].max())
    elsewhere = nearest()
    exact = [name for name, distance in elsewhere.items() if distance < 0.05]
    return Row(
        "dynamic",
        {"torque": " ".join(str(_plain(row.dynamic)) for row in TABLE_3_5)},
        {
            "off": round(off, 2),
            "at_z": round(z, 2),
            "highest_z_with_these_signs": round(highest, 2),
            "off_on_any_branch": {name: round(distance, 3) for name, distance in elsewhere.items()},
        },
        "not recoverable",
        "place, velocity and acceleration are not given. On the line and the branch on which D.4 begins, "
        f"program D.1.2's arm comes within {off:.1f} N m at best (z = {z:.2f} m), and the joints turn as "
        f"printed (+ - +) only at z = {highest:.2f} m and below, whatever the masses; D.4 begins at "
        f"z = 0.10 m. With any branch {len(exact)} of {len(SETS)} sets of parameters have states that fit to "
        "0.05 N m: the torques do not tell the motion",
    )


def _free_friction() -> Row:
    return _not_recoverable(
        "link 1, joint friction",
        {"torque": _plain(TABLE_3_5[0].joint_friction)},
        {"bound": 0},
        "the span d of the bearings, which Eq 3.3 needs, is not given",
    )


def _bounded() -> tuple[Row, Row]:
    from robodyn.thesis.tables.operating_point import SETS, bounds

    limits = bounds(NEAR)
    rows = []
    for k, link in enumerate((2, 3)):
        printed = abs(TABLE_3_5[link - 1].joint_friction)
        by_set = {name: round(limits[name][k], 2) for name in SETS if name in limits}
        least = min(by_set.values())
        against = [name for name, bound in by_set.items() if bound > printed]
        holds = "all four sets of parameters" if len(against) == len(SETS) else ", ".join(against)
        rows.append(
            _not_recoverable(
                f"link {link}, joint friction",
                {"torque": _plain(TABLE_3_5[link - 1].joint_friction)},
                {"bound": least, "bound_by_parameters": by_set},
                "Table 3.4 and Eq 3.3 do not give it, whatever the span d: the bearings take at least "
                f"mu r sqrt(fx^2 + fy^2), which is {least:.2f} N m or more wherever on the line the torques "
                f"are within {NEAR:g} N m of the printed ones and the joints turn as printed ({holds}; on a "
                "grid of states)"
                if against
                else "the span d of the bearings, which Eq 3.3 needs, is not given",
            )
        )
    return rows[0], rows[1]


def _lost() -> tuple[Row, ...]:
    return (
        _not_recoverable(
            "velocity profile",
            {"given": "rest at the start, 201 samples, 2 s"},
            {"assumed": "quintic, rest to rest"},
            "neither how the motion goes along the line nor where it ends is given; the start that D.4 "
            "prints is x = 0.4 m, y = z = 0.1 m (the text has x = 0.3 m)",
        ),
        _not_recoverable(
            "efficiency curve",
            {"given": "a figure"},
            {"points": len(efficiency_points())},
            "the curve is a figure without numbers; Table 3.5 gives away three points, all below a tenth of "
            "full load",
        ),
        _not_recoverable(
            "Figures 3.6 to 3.13",
            {"given": "figures"},
            {"drawn": "by robodyn case-study, anew"},
            "they depend on the profile, the span and the efficiency curve, and the text has none of their "
            "numbers; the text speaks of figures up to 3.15, the captions end at 3.13",
        ),
    )


def _not_recoverable(name: str, printed: dict[str, Any], ours: dict[str, Any], reason: str) -> Row:
    return Row(name, printed, ours, "not recoverable", reason)


def _plain(x: Fraction) -> float:
    return float(x)
