"""Tables 3.4 and 3.5: parameters of friction beside what the printed torques let them be, and the torques at
0.6 s: what follows from their own columns, and what nothing gives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import pairwise
from typing import Any, Final

from robodyn.effects import thesis_friction as friction
from robodyn.thesis.case_arm import efficiency_point, efficiency_points
from robodyn.thesis.printed import TABLE_3_4, TABLE_3_5, PrintedTorques
from robodyn.thesis.tables.table import Row, Verdict, verdict_of, words_of

#: Half of what the last digit of three rounded numbers can be off by.
EXACT: Final = Fraction(1, 10000)
#: How near to Table 3.5 torques are asked to be where joint friction is bounded [N m].
NEAR: Final = 4.0
_DIGITS: Final = 4

# --- 3.4 --------------------------------------------------------------------------------------------------

_UNIT: Final = {"mu": "", "radius": " [m]", "breakaway": " [N m]", "largest torque": " [N m]"}
#: Torques of the arm's joints 1 to 3 in public programs for the PUMA 560 [N m], six joints of which have
#: breakaway torques of 6.3, 5.5, 2.6, 1.3, 1.0, 1.2 and largest ones of 97.6, 186.4, 89.4, 24.2, 20.1, 21.3.
PUBLISHED: Final = {"breakaway": (6.3, 5.5, 2.6), "largest torque": (97.6, 186.4, 89.4)}


def table_3_4() -> Iterator[Row]:
    """A row for each printed figure, with the range that Table 3.5 leaves it."""
    from robodyn.thesis.tables.operating_point import bounds

    links = list(enumerate(zip(TABLE_3_4, TABLE_3_5, strict=True), 1))
    limits, reasons = bounds(NEAR).values(), words_of("3.4")["reasons"]
    for link, (drive, row) in links:
        share, reason = Fraction(0), reasons["no span"]
        if link > 1:
            least = Fraction(min(pair[link - 2] for pair in limits))  # friction with the printed mu r [N m]
            share = abs(row.joint_friction) / least
            figures = {"least": float(least), "near": NEAR, "printed": float(abs(row.joint_friction))}
            reason = reasons["bearings"].format_map(figures)
        for name, printed in (("mu", drive.mu), ("radius", drive.radius)):
            yield _parameter(link, name, printed, Fraction(0), printed * share if share else None, reason)
    for link, (drive, row) in links:
        # what the motor gives and the joint takes, along the motion; the rest is breakaway and efficiency
        motor, joint = row.input * row.direction, row.joint_total * row.direction
        reason = reasons["breakaway"].format(case="driving" if joint > 0 else "braking")
        least = Fraction(0) if joint > 0 else motor
        yield _parameter(link, "breakaway", drive.breakaway, least, motor - joint, reason)
    points = efficiency_points()
    for (link, (drive, row)), point in zip(links, points, strict=True):
        below = [other.load for other in points if other.efficiency < point.efficiency]
        above = [other.load for other in points if other.efficiency > point.efficiency]
        torque = abs(row.joint_total)
        least = torque / min(above) if above else torque
        most = torque / max(below) if below else None
        yield _parameter(link, "largest torque", drive.largest, least, most, reasons["largest torque"])


def _parameter(
    link: int, name: str, printed: Fraction, least: Fraction, most: Fraction | None, reason: str
) -> Row:
    verdict: Verdict = verdict_of(least <= printed and (most is None or printed <= most))
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
        "not recoverable" if most is None and not least else verdict,
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
    words = words_of("3.5")
    yield _lost("link 1, joint friction", TABLE_3_5[0], {"bound": 0}, words["reasons"]["no span"])
    yield from _bounded()
    for row in words["lost"]:
        yield Row(row["name"], {"given": row["given"]}, row["ours"], "not recoverable", row["reason"])


def _lost(name: str, row: PrintedTorques, ours: dict[str, Any], reason: str) -> Row:
    return Row(name, {"torque": float(row.joint_friction)}, ours, "not recoverable", reason)


def _sum(name: str, printed: Fraction, total: Fraction, parts: str) -> Row:
    same = abs(total - printed) <= EXACT
    nearly = ", to the last digit but one" if total != printed and same else ""
    reason = f"{'' if same else 'not '}the sum of {parts}, each with its sign{nearly}"
    return Row(name, {"torque": float(printed)}, {"torque": float(total)}, verdict_of(same), reason)


def _sign_rule() -> Row:
    row = TABLE_3_5[1]
    by_3_6 = friction.with_friction(row.dynamic, row.joint_friction)
    by_3_7 = row.dynamic - row.joint_friction  # sgn(qd) = -1, a second time
    return Row(
        "link 2, sign rule",
        {"torque": float(row.joint_total)},
        {"torque": float(by_3_6), "by_eq_3_7": float(by_3_7)},
        verdict_of(abs(by_3_6 - row.joint_total) <= EXACT < abs(by_3_7 - row.joint_total)),
        words_of("3.5")["reasons"]["sign rule"].format(by_3_7=float(by_3_7)),
    )


def _efficiencies() -> Iterator[Row]:
    by_load = sorted(efficiency_points(), key=lambda point: point.load)
    reason = words_of("3.5")["reasons"]["efficiency"]
    rises = all(a.efficiency < b.efficiency for a, b in pairwise(by_load))
    for link, (row, drive) in enumerate(zip(TABLE_3_5, TABLE_3_4, strict=True), 1):
        point = efficiency_point(row, drive)
        eta, load = round(point.efficiency, _DIGITS), round(point.load, _DIGITS)
        case = friction.driving if point.drives else friction.braking
        torque = case(row.joint_total, eta, drive.breakaway, row.direction)
        possible = 0 < eta <= 1 and rises
        drives = "drives" if point.drives else "brakes"
        figures = {"eta": float(eta), "load": float(load), "drives": drives}
        yield Row(
            f"link {link}, efficiency",
            {"torque": float(row.input)},
            {
                "torque": float(round(torque, _DIGITS)),
                "efficiency": float(eta),
                "load_fraction": float(load),
                "case": drives,
            },
            verdict_of(possible and abs(torque - row.input) <= 20 * EXACT),
            reason.format_map(figures) if possible else "no efficiency gives it",
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
        words_of("3.5")["reasons"]["dynamic"].format(
            off=off, z=z, highest=highest, exact=exact, sets=len(SETS)
        ),
    )


def _bounded() -> Iterator[Row]:
    from robodyn.thesis.tables.operating_point import SETS, bounds

    limits, reasons = bounds(NEAR), words_of("3.5")["reasons"]
    for k, link in enumerate((2, 3)):
        by_set = {name: round(limits[name][k], 2) for name in SETS if name in limits}
        least = min(by_set.values())
        against = [name for name, bound in by_set.items() if bound > abs(TABLE_3_5[link - 1].joint_friction)]
        holds = "all four sets of parameters" if len(against) == len(SETS) else ", ".join(against)
        reason = reasons["bounded" if against else "no span"].format(least=least, near=NEAR, holds=holds)
        bound = {"bound": least, "bound_by_parameters": by_set}
        yield _lost(f"link {link}, joint friction", TABLE_3_5[link - 1], bound, reason)
