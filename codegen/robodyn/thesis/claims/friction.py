"""Friction and the case study (chapter 3)."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Final

import numpy as np

from robodyn.counts import Count
from robodyn.effects import thesis_friction as laws
from robodyn.schedule import general_graph
from robodyn.schedule.friction_tasks import Friction, friction_tasks
from robodyn.schedule.graph import link_and_number
from robodyn.schedule.tasks import TASKS
from robodyn.thesis.case_arm import D4_START, efficiency_points, led
from robodyn.thesis.claims import LINKS, Arms, CaseTorques, Outcome, case_torques
from robodyn.thesis.printed import TABLE_3_3, TABLE_3_4, TABLE_3_5
from robodyn.thesis.tables import operations
from robodyn.thesis.tables.case_study import EXACT

_GEAR: Final = Friction(None, "linear")
_BOTH: Final = Friction("journal", "linear")


def _rounded(values: Any, digits: int = 2) -> list[float]:
    return [round(float(x), digits) for x in values]


def joint_friction_at_one_instant(_: Arms) -> Outcome:
    """Friction of joints to that of transmissions in Table 3.5."""
    return {"ratios": _rounded(abs(row.joint_friction / row.transmission) for row in TABLE_3_5)}, None


def joint_friction_at_all_times(arms: Arms) -> Outcome:
    """The largest such ratio in our case study, with bearings 0.2 m and 1 m apart."""

    def largest(torques: CaseTorques) -> list[float]:
        ratio = abs(torques.joint - torques.rigid) / abs(torques.total - torques.joint)
        return _rounded(ratio.max(axis=0))

    wide = max(largest(case_torques(1.0)))
    return {"largest": largest(arms.case_study), "largest_with_a_span_of_1_m": wide}, None


def significance(_: Arms) -> Outcome:
    """Input torque and friction to the dynamic torque in Table 3.5."""
    whole = [abs(row.input / row.dynamic) for row in TABLE_3_5]
    parts = [abs((row.input - row.dynamic) / row.dynamic) for row in TABLE_3_5]
    return {"input": _rounded(whole), "friction": _rounded(parts)}, min(parts) > 1


def region_one(arms: Arms) -> Outcome:
    """Where rate and torque agree: the share of the case study's samples with less torque than the dynamics
    ask for, joint by joint, and input and dynamic torque of the links of Table 3.5 where they agree."""
    torques = arms.case_study
    agree = torques.qd * torques.joint > 0
    less = agree & (abs(torques.total) < abs(torques.rigid))
    shares = (less.sum(axis=0) / np.maximum(1, agree.sum(axis=0))).tolist()
    rows = [row for row in TABLE_3_5 if row.joint_friction * row.joint_total > 0]
    figures = {
        "shares": _rounded(shares),
        "samples": len(agree),
        "input": [abs(float(row.input)) for row in rows],
        "dynamic": [abs(float(row.dynamic)) for row in rows],
    }
    return figures, min(shares) > 0.5


def _increase(base: int, more: int) -> float:
    return round(100 * (more / base - 1), 1)


def _total(count: Count) -> int:
    return count.mul + count.add


def load_with_friction(_: Arms) -> Outcome:
    """More operations a joint, tasks and levels with friction [%]."""
    counts = {row: _total(count) for row, count in operations.friction_counts().items()}
    rigid, gear = sum(TABLE_3_3["frictionless"]["revolute"]), sum(TABLE_3_3["transmission"]["linear"])
    plain, graph = general_graph(LINKS), general_graph(LINKS, _BOTH)

    def more(total: str, kind: str) -> float:
        return _increase(counts[f"frictionless, {kind}"], counts[f"{total}, {kind}"])

    figures = {
        "percent": more("total_linear", "revolute"),
        "cubic_percent": more("total_cubic", "revolute"),
        "prismatic_percent": more("total_linear", "prismatic"),
        "printed_percent": _increase(rigid, sum(TABLE_3_3["total_linear"]["revolute"])),
        "transmission_percent": _increase(rigid, rigid + gear),
        "tasks_percent": _increase(len(plain), len(graph)),
        "levels_percent": _increase(plain.critical_path, graph.critical_path),
    }
    return figures, None


def operations_of_friction(_: Arms) -> Outcome:
    """Operations of friction at a revolute and a prismatic joint, efficiency on a straight line."""
    counts = operations.friction_counts()
    gear = _total(counts["transmission, linear"])
    flops, prismatic = (_total(counts[f"joint, {kind}"]) + gear for kind in ("revolute", "prismatic"))
    printed = sum(TABLE_3_3["joint"]["revolute"]) + sum(TABLE_3_3["transmission"]["linear"])
    additions = counts["joint, revolute"].add
    return {"flops": flops, "prismatic": prismatic, "additions_of_eq_3_3": additions}, flops == printed


def transmissions_alone(_: Arms) -> Outcome:
    """Operations of a transmission whose efficiency is on a straight line."""
    flops = _total(operations.friction_counts()["transmission, linear"])
    return {"without_joint_friction": flops}, flops == sum(TABLE_3_3["transmission"]["linear"])


def small_coefficients(_: Arms) -> Outcome:
    """What is lost of the input torque of Table 3.5 if joint friction of half its mu is left out [%]."""
    return {"lost_pct": _rounded((50 * abs(row.joint_friction / row.input) for row in TABLE_3_5), 1)}, None


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
    values = _rounded((point.efficiency for point in points), 3)
    figures = {"load_pct": _rounded((100 * float(point.load) for point in points), 1), "efficiency": values}
    return figures, values == sorted(values) and values[0] < values[-1]


def breakaway_torques(_: Arms) -> Outcome:
    """Break-away torques of the rated torque and of the joint torque at 0.6 s [%]."""
    rows = list(zip(TABLE_3_4, TABLE_3_5, strict=True))
    of_rated = _rounded((100 * drive.breakaway / drive.largest for drive, _ in rows), 1)
    of_joint = [round(float(100 * drive.breakaway / abs(row.joint_total))) for drive, row in rows]
    return {"of_rated_pct": of_rated, "of_joint_pct": of_joint}, None


def braking(_: Arms) -> Outcome:
    """Link 3 of Table 3.5, which brakes: output, input, and the output above which input is less [N m]."""
    row, drive, point = TABLE_3_5[2], TABLE_3_4[2], efficiency_points()[2]
    torques = abs(row.joint_total), abs(row.input), drive.breakaway / (1 + point.efficiency)
    return dict(zip(("output", "input", "limit"), _rounded(torques), strict=True)), torques[1] < torques[0]


def points_a_and_b(_: Arms) -> Outcome:
    """Input torques by Table 3.2 at both signs of the rate, with link 3's numbers: for an output above zero
    and one below."""
    drive, point, output = TABLE_3_4[2], efficiency_points()[2], abs(TABLE_3_5[2].joint_total)

    def into(torque: Fraction, direction: int) -> Fraction:
        law = laws.driving if torque * direction > 0 else laws.braking
        return Fraction(law(torque, point.efficiency, drive.breakaway, direction))

    a, b = ([into(torque, way) for way in (1, -1)] for torque in (output, -output))
    holds = a[1] < output < a[0] and abs(b[0]) < output < abs(b[1])
    return {"a": _rounded(a), "b": _rounded(b), "output": _rounded([output])[0]}, holds


def signs(_: Arms) -> Outcome:
    """Links of Table 3.5 whose torque with friction is the signed sum of Eq 3.6, and Eq 3.7 for link 3, which
    brakes."""
    sums = [laws.with_friction(row.dynamic, row.joint_friction) - row.joint_total for row in TABLE_3_5]
    row = TABLE_3_5[2]
    by_3_7 = row.dynamic - row.joint_friction
    figures = {"links": sum(abs(x) <= EXACT for x in sums), "by_eq_3_7": float(by_3_7)}
    return {**figures, "printed": float(row.joint_total)}, abs(by_3_7 - row.joint_total) <= EXACT


def start_of_the_line(_: Arms) -> Outcome:
    """Where the tool of program D.1.3 is at the angles at which D.4 begins [m]."""
    point = _rounded(led("programs").kinematics.position(np.array([D4_START]))[0], 4)
    return {"point": point}, point[0] == 0.3


def reactions(_: Arms) -> Outcome:
    """Tasks of the dynamics that wait for a task of friction, and how far Eq 3.2 is off at mu = 0.1 [%]."""

    def of_friction(task: int) -> bool:
        return link_and_number(task)[1] > len(TASKS)

    after = general_graph(LINKS, _BOTH).after
    waiting = sum(not of_friction(task) and any(map(of_friction, needed)) for task, needed in after.items())
    return {"waiting": waiting, "off_pct": round(100 * ((1 + 0.1**2) ** 0.5 - 1), 1)}, not waiting


def friction_as_tasks(_: Arms) -> Outcome:
    """Tasks a joint and the longest chain of six joints, with all friction and with transmissions."""
    tasks, fewer = len(friction_tasks(_BOTH)), len(friction_tasks(_GEAR))
    kinds = {"chain": None, "chain_with_both": _BOTH, "chain_with_transmissions": _GEAR}
    chains = {name: general_graph(LINKS, kind).critical_path for name, kind in kinds.items()}
    return {"tasks": tasks, "transmission_tasks": fewer, **chains}, fewer < tasks
