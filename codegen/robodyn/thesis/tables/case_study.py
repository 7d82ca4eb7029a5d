"""Tables 3.4 and 3.5: parameters of friction beside what the printed torques let them be, and the torques at
0.6 s: what follows from their own columns, and what nothing gives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import pairwise
from typing import Any, Final

from robodyn.effects import thesis_friction as friction
from robodyn.thesis.case_arm import efficiency_point, efficiency_points
from robodyn.thesis.printed import TABLE_3_4, TABLE_3_5
from robodyn.thesis.tables.table import Row, Verdict, judged

#: Half of what the last digit of three rounded numbers can be off by.
EXACT: Final = Fraction(1, 10000)
#: How near to Table 3.5 torques are asked to be where joint friction is bounded [N m].
NEAR: Final = 4.0
_DIGITS: Final = 4
_NO_SPAN: Final = "the span d of the bearings, which Eq 3.3 needs, is not given"

# --- 3.4 --------------------------------------------------------------------------------------------------

_UNIT: Final = {"mu": "", "radius": " [m]", "breakaway": " [N m]", "largest torque": " [N m]"}
#: Torques of the arm's joints 1 to 3 in public programs for the PUMA 560 [N m], six joints of which have
#: breakaway torques of 6.3, 5.5, 2.6, 1.3, 1.0, 1.2 and largest ones of 97.6, 186.4, 89.4, 24.2, 20.1, 21.3.
PUBLISHED: Final = {"breakaway": (6.3, 5.5, 2.6), "largest torque": (97.6, 186.4, 89.4)}


def table_3_4() -> Iterator[Row]:
    """A row for each printed figure, with the range that Table 3.5 leaves it."""
    from robodyn.thesis.tables.operating_point import bounds

    links = list(enumerate(zip(TABLE_3_4, TABLE_3_5, strict=True), 1))
    limits = bounds(NEAR).values()
    for link, (drive, row) in links:
        share, reason = Fraction(0), _NO_SPAN
        if link > 1:
            least = Fraction(min(pair[link - 2] for pair in limits))  # friction with the printed mu r [N m]
            share = abs(row.joint_friction) / least
            reason = (
                f"with it the bearings take at least {float(least):.2f} N m where the torques are within "
                f"{NEAR:g} N m of Table 3.5's, which has {float(abs(row.joint_friction)):g} N m"
            )
        for name, printed in (("mu", drive.mu), ("radius", drive.radius)):
            yield _parameter(link, name, printed, Fraction(0), printed * share if share else None, reason)
    for link, (drive, row) in links:
        # what the motor gives and the joint takes, along the motion; the rest is breakaway and efficiency
        motor, joint = row.input * row.direction, row.joint_total * row.direction
        reason = (
            "by Table 3.2 and Table 3.5 the efficiency is between 0 and 1 within these bounds, the motor "
            + ("driving" if joint > 0 else "braking")
        )
        least = Fraction(0) if joint > 0 else motor
        yield _parameter(link, "breakaway", drive.breakaway, least, motor - joint, reason)
    points = efficiency_points()
    for (link, (drive, row)), point in zip(links, points, strict=True):
        below = [other.load for other in points if other.efficiency < point.efficiency]
        above = [other.load for other in points if other.efficiency > point.efficiency]
        torque = abs(row.joint_total)
        yield _parameter(
            link, "largest torque", drive.largest,
            torque / min(above) if above else torque, torque / max(below) if below else None,
            "within these bounds the efficiencies that Table 3.5 gives away rise with the load",
        )  # fmt: skip


def _parameter(
    link: int, name: str, printed: Fraction, least: Fraction, most: Fraction | None, reason: str
) -> Row:
    verdict: Verdict = judged(least <= printed and (most is None or printed <= most))
    beside: tuple[Mapping[str, Any], ...] = ()
    if name in PUBLISHED:
        beside = ({"what": "public programs for the arm", "value": PUBLISHED[name][link - 1]},)
    return Row(
        f"link {link}, {name}{_UNIT[name]}",
        {"value": float(printed)},
        {
            "least": float(f"{float(least):.3g}"),
            "most": None if most is None else float(f"{float(most):.3g}"),
        },
        "not recoverable" if reason == _NO_SPAN else verdict,
        reason,
        beside,
    )


# --- 3.5 --------------------------------------------------------------------------------------------------


def table_3_5() -> Iterator[Row]:
    """Printed torques beside what follows from them."""
    for link, row in enumerate(TABLE_3_5, 1):
        total = row.dynamic + row.joint_friction
        yield _sum(f"link {link}, joint total", row.joint_total, total, "dynamic and joint friction")
    for link, row in enumerate(TABLE_3_5, 1):
        total = row.joint_total + row.transmission
        yield _sum(f"link {link}, input", row.input, total, "joint total and transmission")
    yield _sign_rule()
    yield from _efficiencies()
    yield _dynamic()
    yield _lost("link 1, joint friction", float(TABLE_3_5[0].joint_friction), {"bound": 0}, _NO_SPAN)
    yield from _bounded()
    yield _lost(
        "velocity profile",
        "rest at the start, 201 samples, 2 s",
        {"assumed": "quintic, rest to rest"},
        "neither how the motion goes along the line nor where it ends is given; the start that D.4 prints is "
        "x = 0.4 m, y = z = 0.1 m (the text has x = 0.3 m)",
    )
    yield _lost(
        "efficiency curve",
        "a figure",
        {"points": len(efficiency_points())},
        "the curve is a figure without numbers; Table 3.5 gives away three points, all below a tenth of full "
        "load",
    )
    yield _lost(
        "Figures 3.6 to 3.13",
        "figures",
        {"drawn": "by robodyn case-study, anew"},
        "they depend on the profile, the span and the efficiency curve, and the text has none of their "
        "numbers; the text speaks of figures up to 3.15, the captions end at 3.13",
    )


def _lost(name: str, printed: float | str, ours: dict[str, Any], reason: str) -> Row:
    given = {"torque" if isinstance(printed, float) else "given": printed}
    return Row(name, given, ours, "not recoverable", reason)


def _sum(name: str, printed: Fraction, total: Fraction, parts: str) -> Row:
    same = abs(total - printed) <= EXACT
    nearly = ", to the last digit but one" if total != printed and same else ""
    reason = f"{'' if same else 'not '}the sum of {parts}, each with its sign{nearly}"
    return Row(name, {"torque": float(printed)}, {"torque": float(total)}, judged(same), reason)


def _sign_rule() -> Row:
    row = TABLE_3_5[1]
    by_3_6 = friction.with_friction(row.dynamic, row.joint_friction)
    by_3_7 = row.dynamic - row.joint_friction  # sgn(qd) = -1, a second time
    return Row(
        "link 2, sign rule",
        {"torque": float(row.joint_total)},
        {"torque": float(by_3_6), "by_eq_3_7": float(by_3_7)},
        judged(abs(by_3_6 - row.joint_total) <= EXACT < abs(by_3_7 - row.joint_total)),
        "the signed sum of Eq 3.6 covers what Eq 3.7 is for: the printed friction carries sgn(qd) already, "
        f"and counted again as in Eq 3.7 the sum would be {float(by_3_7)}",
    )


def _efficiencies() -> Iterator[Row]:
    by_load = sorted(efficiency_points(), key=lambda point: point.load)
    rises = all(a.efficiency < b.efficiency for a, b in pairwise(by_load))
    for link, (row, drive) in enumerate(zip(TABLE_3_5, TABLE_3_4, strict=True), 1):
        point = efficiency_point(row, drive)
        eta, load = round(point.efficiency, _DIGITS), round(point.load, _DIGITS)
        case = friction.driving if point.drives else friction.braking
        torque = case(row.joint_total, eta, drive.breakaway, row.direction)
        possible = 0 < eta <= 1 and rises
        reason = (
            f"Table 3.2 gives it with the efficiency {float(eta)} at {float(load)} of the largest torque, "
            f"where the motor {'drives' if point.drives else 'brakes'}; the three points rise with the load, "
            "and are all that can be recovered of the curve"
        )
        yield Row(
            f"link {link}, efficiency",
            {"torque": float(row.input)},
            {
                "torque": float(round(torque, _DIGITS)),
                "efficiency": float(eta),
                "load_fraction": float(load),
                "case": "drives" if point.drives else "brakes",
            },
            judged(possible and abs(torque - row.input) <= 20 * EXACT),
            reason if possible else "no efficiency gives it",
        )


def _dynamic() -> Row:
    from robodyn.thesis.tables.operating_point import SETS, closest, nearest, on_the_path_of_d4

    path = on_the_path_of_d4()
    off, z = closest("puma560_3dof_d12", path)
    highest = float(path.z[path.fitting].max())
    distances = nearest()
    exact = sum(distance < 0.05 for distance in distances.values())
    return Row(
        "dynamic",
        {"torque": " ".join(str(float(row.dynamic)) for row in TABLE_3_5)},
        {
            "off": round(off, 2),
            "at_z": round(z, 2),
            "highest_z_with_these_signs": round(highest, 2),
            "off_on_any_branch": {name: round(distance, 3) for name, distance in distances.items()},
        },
        "not recoverable",
        "place, velocity and acceleration are not given. On the line and the branch on which D.4 begins, "
        f"program D.1.2's arm comes within {off:.1f} N m at best (z = {z:.2f} m), and the joints turn as "
        f"printed (+ - +) only at z = {highest:.2f} m and below, whatever the masses; D.4 begins at "
        f"z = 0.10 m. With any branch {exact} of {len(SETS)} sets of parameters have states that fit to "
        "0.05 N m: the torques do not tell the motion",
    )


def _bounded() -> Iterator[Row]:
    from robodyn.thesis.tables.operating_point import SETS, bounds

    limits = bounds(NEAR)
    for k, link in enumerate((2, 3)):
        printed = TABLE_3_5[link - 1].joint_friction
        by_set = {name: round(limits[name][k], 2) for name in SETS if name in limits}
        least = min(by_set.values())
        against = [name for name, bound in by_set.items() if bound > abs(printed)]
        holds = "all four sets of parameters" if len(against) == len(SETS) else ", ".join(against)
        reason = (
            "Table 3.4 and Eq 3.3 do not give it, whatever the span d: the bearings take at least "
            f"mu r sqrt(fx^2 + fy^2), which is {least:.2f} N m or more wherever on the line the torques are "
            f"within {NEAR:g} N m of the printed ones and the joints turn as printed ({holds}; on a grid of "
            "states)"
        )
        bound = {"bound": least, "bound_by_parameters": by_set}
        yield _lost(f"link {link}, joint friction", float(printed), bound, reason if against else _NO_SPAN)
