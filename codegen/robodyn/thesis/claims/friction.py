"""Friction and the case study (chapter 3)."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Final

from robodyn.effects import thesis_friction as laws
from robodyn.schedule import general_graph
from robodyn.schedule.friction_tasks import Friction, friction_tasks
from robodyn.schedule.graph import link_and_number
from robodyn.schedule.tasks import TASKS
from robodyn.thesis.case_arm import D4_START, efficiency_points, led
from robodyn.thesis.claims.arms import LINKS, Arms, case_torques
from robodyn.thesis.claims.claim import Outcome
from robodyn.thesis.printed_counts import TABLE_3_3, TABLE_3_4, TABLE_3_5
from robodyn.thesis.tables import table_3_3
from robodyn.thesis.tables.table_3_5 import EXACT

_JOURNALS: Final = Friction("journal", "linear")


def _rounded(values: Any, digits: int = 2) -> list[float]:
    return [round(float(x), digits) for x in values]


def joint_friction_at_one_instant(_: Arms) -> Outcome:
    """Friction of joints to that of transmissions in Table 3.5."""
    ratios = [abs(row.joint_friction / row.transmission) for row in TABLE_3_5]
    return {"ratios": _rounded(ratios)}, None


def joint_friction_at_all_times(arms: Arms) -> Outcome:
    """The largest such ratio in our case study, with bearings 0.2 m and 1 m apart."""

    def largest(torques: Any) -> list[float]:
        ratio = abs(torques.joint - torques.rigid) / abs(torques.total - torques.joint)
        return _rounded(ratio.max(axis=0))

    wide = largest(case_torques(Fraction(1)))
    return {"largest": largest(arms.case_study), "largest_with_a_span_of_1_m": max(wide)}, None


def significance(_: Arms) -> Outcome:
    """Input torque and friction to the dynamic torque in Table 3.5."""
    whole = [abs(row.input / row.dynamic) for row in TABLE_3_5]
    friction = [abs((row.input - row.dynamic) / row.dynamic) for row in TABLE_3_5]
    return {"input": _rounded(whole), "friction": _rounded(friction)}, min(friction) > 1


def region_one(arms: Arms) -> Outcome:
    """Where rate and torque agree: the share of the case study's samples with less torque than the dynamics
    ask for, joint by joint, and the links of Table 3.5 where they agree."""
    torques = arms.case_study
    agree = torques.qd * torques.joint > 0
    less = agree & (abs(torques.total) < abs(torques.rigid))
    shares = [float(less[:, j].sum() / max(1, agree[:, j].sum())) for j in range(less.shape[1])]
    links = [k for k, row in enumerate(TABLE_3_5, 1) if row.joint_friction * row.joint_total > 0]
    figures = {
        "shares": _rounded(shares),
        "samples": len(agree),
        "links": links,
        "input": [abs(float(TABLE_3_5[k - 1].input)) for k in links],
        "dynamic": [abs(float(TABLE_3_5[k - 1].dynamic)) for k in links],
    }
    return figures, min(shares) > 0.5


def _increase(base: int, more: int) -> float:
    return round(100 * (more / base - 1), 1)


def load_with_friction(_: Arms) -> Outcome:
    """More operations a joint, tasks and levels with friction [%]."""
    counts = {row: count.mul + count.add for row, count in table_3_3.ours().items()}
    rigid = sum(TABLE_3_3["frictionless"]["revolute"])
    plain, graph = general_graph(LINKS), general_graph(LINKS, _JOURNALS)
    figures = {
        "percent": _increase(counts["frictionless, revolute"], counts["total_linear, revolute"]),
        "cubic_percent": _increase(counts["frictionless, revolute"], counts["total_cubic, revolute"]),
        "prismatic_percent": _increase(counts["frictionless, prismatic"], counts["total_linear, prismatic"]),
        "printed_percent": _increase(rigid, sum(TABLE_3_3["total_linear"]["revolute"])),
        "transmission_percent": _increase(rigid, rigid + sum(TABLE_3_3["transmission"]["linear"])),
        "tasks_percent": _increase(len(plain), len(graph)),
        "levels_percent": _increase(plain.critical_path, graph.critical_path),
    }
    return figures, None


def operations_of_friction(_: Arms) -> Outcome:
    """Operations of friction at a revolute and a prismatic joint, efficiency on a straight line."""
    counts = table_3_3.ours()
    gear = _total(counts["transmission, linear"])
    figures = {
        "flops": _total(counts["joint, revolute"]) + gear,
        "prismatic": _total(counts["joint, prismatic"]) + gear,
        "additions_of_eq_3_3": counts["joint, revolute"].add,
    }
    printed = sum(TABLE_3_3["joint"]["revolute"]) + sum(TABLE_3_3["transmission"]["linear"])
    return figures, figures["flops"] == printed


def _total(count: Any) -> int:
    return int(count.mul + count.add)


def transmissions_alone(_: Arms) -> Outcome:
    """Operations of a transmission whose efficiency is on a straight line."""
    flops = _total(table_3_3.ours()["transmission, linear"])
    return {"without_joint_friction": flops}, flops == sum(TABLE_3_3["transmission"]["linear"])


def small_coefficients(_: Arms) -> Outcome:
    """What is lost of the input torque of Table 3.5 if joint friction of half its mu is left out [%]."""
    lost = [50 * abs(row.joint_friction / row.input) for row in TABLE_3_5]
    return {"lost_pct": _rounded(lost, 1)}, None


def _eq_3_3(f: Any, n: Any, *, as_printed: bool) -> float:
    return float(laws.journal_bearing(0.1, 0.08, 0.2, f, n, 1, as_printed=as_printed))


def limits_of_eq_3_3(_: Arms) -> Outcome:
    """Eq 3.3 as printed against mu r |f| without a moment, and 2 mu r |n| / d without a force."""
    f, n, none = (3.0, 4.0, 0.0), (0.6, 0.8, 0.0), (0.0, 0.0, 0.0)
    off = (
        abs(_eq_3_3(f, none, as_printed=True) - 0.1 * 0.08 * 5),
        abs(_eq_3_3(none, n, as_printed=True) - 2 * 0.1 * 0.08 / 0.2),
    )
    return {"limits": sum(x < 1e-12 for x in off)}, max(off) < 1e-12


def eq_3_3_between(_: Arms) -> Outcome:
    """Eq 3.3 as printed over what two journals take under a force and a moment together [%]."""
    f, n = (3.0, 4.0, 0.0), (0.6, 0.8, 0.0)
    printed, right = (_eq_3_3(f, n, as_printed=way) for way in (True, False))
    return {"off_pct": round(100 * (printed / right - 1), 1)}, abs(printed - right) < 1e-12


def efficiencies(_: Arms) -> Outcome:
    """The points of the efficiency curve that Table 3.5 gives away: load [%] and efficiency."""
    points = sorted(efficiency_points(), key=lambda point: point.load)
    figures = {
        "load_pct": [round(100 * float(point.load), 1) for point in points],
        "efficiency": [round(float(point.efficiency), 3) for point in points],
    }
    values = figures["efficiency"]
    return figures, values == sorted(values) and values[0] < values[-1]


def breakaway_torques(_: Arms) -> Outcome:
    """Break-away torques of the rated torque and of the joint torque at 0.6 s [%]."""
    of_rated = [100 * drive.breakaway / drive.largest for drive in TABLE_3_4]
    of_joint = [
        100 * drive.breakaway / abs(row.joint_total) for drive, row in zip(TABLE_3_4, TABLE_3_5, strict=True)
    ]
    figures = {"of_rated_pct": _rounded(of_rated, 1), "of_joint_pct": [round(float(x)) for x in of_joint]}
    return figures, None


def braking(_: Arms) -> Outcome:
    """Link 3 of Table 3.5, which brakes: output, input, and the output above which input is less [N m]."""
    row, drive, point = TABLE_3_5[2], TABLE_3_4[2], efficiency_points()[2]
    output, whole = abs(row.joint_total), abs(row.input)
    limit = drive.breakaway / (1 + point.efficiency)
    figures = {"output": _rounded([output])[0], "input": _rounded([whole])[0], "limit": _rounded([limit])[0]}
    return figures, whole < output


def points_a_and_b(_: Arms) -> Outcome:
    """Input torques by Table 3.2 at both signs of the rate, with link 3's numbers: for an output above zero
    and one below."""
    drive, point, output = TABLE_3_4[2], efficiency_points()[2], abs(TABLE_3_5[2].joint_total)
    eta, breakaway = point.efficiency, drive.breakaway

    def into(torque: Fraction, direction: int) -> Fraction:
        law = laws.driving if torque * direction > 0 else laws.braking
        return Fraction(law(torque, eta, breakaway, direction))

    a, b = [into(output, way) for way in (1, -1)], [into(-output, way) for way in (1, -1)]
    holds_at_a = a[1] < output < a[0]
    holds_at_b = abs(b[0]) < output < abs(b[1])
    return {"a": _rounded(a), "b": _rounded(b), "output": _rounded([output])[0]}, holds_at_a and holds_at_b


def signs(_: Arms) -> Outcome:
    """Links of Table 3.5 whose torque with friction is the signed sum of Eq 3.6, and Eq 3.7 for link 3, which
    brakes."""
    fit = [
        abs(laws.with_friction(row.dynamic, row.joint_friction) - row.joint_total) <= EXACT
        for row in TABLE_3_5
    ]
    row = TABLE_3_5[2]
    by_3_7 = row.dynamic - row.joint_friction
    figures = {"links": sum(fit), "by_eq_3_7": float(by_3_7), "printed": float(row.joint_total)}
    return figures, abs(by_3_7 - row.joint_total) <= EXACT


def start_of_the_line(_: Arms) -> Outcome:
    """Where the tool of program D.1.3 is at the angles at which D.4 begins [m]."""
    import numpy as np

    point = led("programs").kinematics.position(np.array([D4_START]))[0]
    figures = {"point": _rounded(point, 4)}
    return figures, figures["point"][0] == 0.3


def reactions(_: Arms) -> Outcome:
    """Tasks of the dynamics that wait for a task of friction, and how far Eq 3.2 is off at mu = 0.1 [%]."""
    graph = general_graph(LINKS, _JOURNALS)
    rigid = set(range(1, len(TASKS) + 1))
    waiting = [
        task
        for task, needed in graph.after.items()
        if link_and_number(task)[1] in rigid
        and any(link_and_number(other)[1] not in rigid for other in needed)
    ]
    off = 100 * ((1 + 0.1**2) ** 0.5 - 1)
    return {"waiting": len(waiting), "off_pct": round(off, 1)}, not waiting


def friction_as_tasks(_: Arms) -> Outcome:
    """Tasks a joint and the longest chain of six joints, with all friction and with transmissions."""
    gear = Friction(None, "linear")
    figures = {
        "tasks": len(friction_tasks(_JOURNALS)),
        "transmission_tasks": len(friction_tasks(gear)),
        "chain": general_graph(LINKS).critical_path,
        "chain_with_both": general_graph(LINKS, _JOURNALS).critical_path,
        "chain_with_transmissions": general_graph(LINKS, gear).critical_path,
    }
    return figures, figures["transmission_tasks"] < figures["tasks"]
