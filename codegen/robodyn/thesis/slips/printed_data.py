"""Printed data and programs: sums, parameters, the order of tasks, and what programs D.1.3, D.2 and D.4
compute with.

Source: Dhanaraj 1990, Tables 1.1 to 4.6, programs D.1 to D.4.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.dynamics.arm import origin
from robodyn.robot.model import Robot
from robodyn.schedule.arithmetic import one_after_another, run_tasks
from robodyn.schedule.graph import task_id
from robodyn.schedule.tasks import FLOPS_PER_TASK
from robodyn.thesis.case_arm import D4_BRANCH, FOREARM, OFFSET
from robodyn.thesis.polynomial import value
from robodyn.thesis.printed import (
    D_2,
    D_2_LAST_DIGIT,
    PUMA,
    TABLE_1_1,
    TABLE_2_9,
    TABLE_3_3,
    TABLE_4_4_ZEROS,
    TABLE_4_5,
    TABLE_4_6,
    PrintedLink,
    bundled,
    moved_to_origin,
)
from robodyn.thesis.puma_inverse import BRANCHES, PumaArm
from robodyn.thesis.slips import Comparison, compare
from robodyn.thesis.slips.recursion import STATES, against_newton_euler, scalars, states, torques_of
from robodyn.thesis.tables.operations import journal
from robodyn.thesis.tables.programs import D4_PRINTED
from robodyn.thesis.tables.tasks import flops
from robodyn.verify.reference import Reference

# --- sums -------------------------------------------------------------------------------------------------


def sampling() -> Comparison:
    """Section 1.1: 20 times 5 to 10 Hz."""
    return compare([1000, 2000], [100, 200], [20 * 5, 20 * 10], "Hz", "20 times 5 and 10 Hz")


def polynomial() -> Comparison:
    """Table 1.1: Uicker and Kahn's multiplications for six joints against the printed polynomial."""
    row = TABLE_1_1["uicker_kahn"]
    truth = float(value(row.mul, 6))
    return compare(row.mul_6, 67143, truth, "multiplications", "the printed polynomial at 6")


def additions_of_a_joint() -> Comparison:
    """Table 2.9: additions of a revolute joint, method II, against the column."""
    column = TABLE_2_9["revolute_II"]
    added = sum(pair[1] for step, pair in column.items() if step != "total")
    return compare(column["total"][1], 113, added, "additions", "the sum of the printed column")


def additions_of_friction() -> Comparison:
    """Table 3.3: additions of Eq 3.3 against carrying it out on numbers that count."""
    printed = TABLE_3_3["joint"]["revolute"][1]
    return compare(printed, 7, journal().add, "additions", "Eq 3.3 carried out")


def zeros_of_the_stanford_arm() -> Comparison:
    """Table 4.4: zeros among the components of s and p, against the bundled robot's numbers."""
    robot = bundled("stanford")
    # in a position without zeros of its own, so that only the numbers of the robot are zero
    arm, motion = scalars(robot, _alike(robot, 0.7, 0.0, 0.0))
    origins = [origin(body, d) for body, d in zip(arm.bodies[1:], motion.d[1:], strict=True)]
    vectors: list[Any] = [*(link.com for link in robot.links), *origins, (0, 0, 0)]
    zeros = sum(bool(np.all(np.asarray(x, dtype=float) == 0)) for vector in vectors for x in vector)
    return compare(TABLE_4_4_ZEROS[0], 26, zeros, "zeros", "the numbers of stanford")


def _alike(robot: Robot, *numbers: float) -> tuple[Floats, Floats, Floats]:
    """All joints alike, in every state."""
    q, qd, qdd = (np.full((STATES, robot.n), number) for number in numbers)
    return q, qd, qdd


# --- tasks ------------------------------------------------------------------------------------------------


def moved_tasks(tasks: Sequence[int], anchor: int, place: int) -> Comparison:
    """Table 4.1: tasks carried out in an order that the printed predecessors allow and the right ones do not:
    ``tasks`` of every link right before the task ``anchor`` of the link at ``place`` (-1 the one before, 0
    its own)."""
    robot = bundled("puma560_d2")
    order = one_after_another(scalars(robot, states(robot))[0])
    for link in range(1 - place, robot.n + 1):
        moved = [task_id(link, task) for task in tasks]
        order = [task for task in order if task not in moved]
        k = order.index(task_id(link + place, anchor))
        order[k:k] = moved

    def run(at: Any, **given: Any) -> list[Any]:
        return [link.n[2] for link in run_tasks(*at, **given)]

    return against_newton_euler(robot.name, lambda at: run(at, order=order), run)


def tasks_of_link_2() -> Comparison:
    """Table 4.6: the number of eliminated tasks beside link 2 against its list."""
    *_, tasks, total = TABLE_4_6[1]
    return compare(total, 12, len(tasks), "tasks", "the printed list of link 2")


def eliminated_or_executed() -> Comparison:
    """Table 4.5: its columns read as tasks eliminated, as the caption says, and as tasks executed, against
    the operations that are left."""
    rules = [
        (rule.tasks, zeros, len(tasks)) for rule in TABLE_4_5 for zeros, tasks in enumerate(rule.executed, 1)
    ]
    return compare(
        [len(tasks) - listed for tasks, _, listed in rules],
        [listed for *_, listed in rules],
        [-(-flops(tasks, zeros) // FLOPS_PER_TASK) for tasks, zeros, _ in rules],
        "tasks",
        "operations left, three a task",
    )


def origin_of_step_3() -> Comparison:
    """Table 4.6: step 3 of link i judged by p_i: the link of which the origin is read is found by moving one
    origin at a time."""
    robot = bundled("stanford")
    arm, motion = scalars(robot, _alike(robot, 0.7, 1.1, 0.3))
    rest = [(0.1, 0.2, 0.3)] * robot.n

    def products(origins: Sequence[Any]) -> list[Floats]:
        links = run_tasks(arm, motion, origins=origins)
        return [np.array([[np.mean(x) for x in row] for row in link.before]) for link in links]

    before = products(rest)
    links = range(2, robot.n + 1)
    reads = dict.fromkeys(links, 0)
    for moved in range(1, robot.n):  # the origin of link moved + 1, counted from 1, is p of link `moved`
        other = products([(0.4, 0.5, 0.6) if k == moved else p for k, p in enumerate(rest)])
        reads |= {link: moved for link in links if not np.allclose(other[link - 1], before[link - 1])}
    right = [link - 1 for link in links]
    return compare(links, right, list(reads.values()), "link", "origins moved one at a time")


# --- parameters -------------------------------------------------------------------------------------------


def tenfold_inertias() -> Comparison:
    """Table 2.6: links 5 and 6, moved to the links' origins, against the tensors of program D.2."""

    def tenth(link: PrintedLink) -> PrintedLink:
        xx, yy, zz = (x and x / 10 for x in link.moments)
        return replace(link, moments=(xx, yy, zz))

    tensors = (map(moved_to_origin, PUMA[4:]), map(moved_to_origin, map(tenth, PUMA[4:])), D_2[4:])
    printed, right, truth = ([list(map(float, filter(None, one))) for one in form] for form in tensors)
    against = "the tensors of program D.2, four decimals"
    return compare(printed, right, truth, "kg m^2", against, float(D_2_LAST_DIGIT) / 2)


def two_arms(printed: str, right: str) -> Comparison:
    """Torques of two bundled arms by the recursion against Newton-Euler of the right one."""
    return _of_arms(bundled(printed), bundled(right), f"{right}, 1000 states")


def _of_arms(printed: Robot, right: Robot, what: str) -> Comparison:
    at = states(right)
    truth = Reference(right).inverse_dynamics(*at)
    return compare(torques_of(printed, at), torques_of(right, at), truth, "N m", f"Newton-Euler of {what}")


def _changed(robot: Robot, link: int, **numbers: Any) -> Robot:
    """``robot`` with other numbers at a link (from 1)."""
    links = list(robot.links)
    links[link - 1] = replace(links[link - 1], **numbers)
    return replace(robot, links=tuple(links))


def other_centres(name: str, factors: Mapping[int, Sequence[int]]) -> Comparison:
    """Centres of mass of links (from 1) times ``factors``, a sign that is wrong or a number left out."""
    right = printed = bundled(name)
    for link, by in factors.items():
        com = tuple(Fraction(factor) * x for factor, x in zip(by, right.links[link - 1].com, strict=True))
        printed = _changed(printed, link, com=com)
    return _of_arms(printed, right, f"{name}, 1000 states")


def parallel_axes_twice() -> Comparison:
    """D.2: tensors about the links' origins in a recursion that adds s x F besides; right are those of Table
    2.6 about the centres of mass, with the rotors in Izz."""
    printed = right = bundled("puma560_d2")
    for i, link in enumerate(bundled("puma560_rotor_in_link").links, 1):
        right = _changed(right, i, inertia=link.inertia)
    return _of_arms(printed, right, "puma560_d2, tensors not moved")


def link_1_left_out() -> Comparison:
    """D.3.2: the mass of the Stanford arm's link 1 left out."""
    whole = bundled("stanford_d3")
    return _of_arms(_changed(whole, 1, mass=Fraction(0)), whole, "stanford_d3, 1000 states")


def wrist_as_a_point() -> Comparison:
    """D.3.1: the wrist's masses at the centre of mass of link 3, against the six-joint arm at rest in the
    wrist: torques of the first three joints."""
    six, three = bundled("stanford_d3"), bundled("stanford_3dof_d3")
    q, qd, qdd = states(six)
    at = (q, *(np.where(np.arange(six.n) < 3, x, 0.0) for x in (qd, qdd)))
    truth = Reference(six).inverse_dynamics(*at)[:, :3]
    printed = torques_of(three, (at[0][:, :3], at[1][:, :3], at[2][:, :3]))
    right = torques_of(six, (at[0], at[1], at[2]))[:, :3]
    return compare(printed, right, truth, "N m", "Newton-Euler of stanford_d3, wrist still, 1000 states")


# --- programs D.1.3 and D.4 -------------------------------------------------------------------------------

#: Half a unit of the last digit of the start that D.4 prints [rad].
_HALF_DIGIT: Final = 0.51e-4
_POINT: Final = (0.4, 0.1, 0.1)


def start_of_d4(forearm: float, x: float) -> Comparison:
    """D.1.3: the comment's forearm, or the line's x [m], where D.4's start needs the formulas' forearm and
    0.4 m: joint positions by the formulas of D.1.3, on D.4's branch and in its turn."""

    def start(forearm: float, x: float) -> Floats:
        arm = PumaArm(float(OFFSET), float(FOREARM), -forearm)  # the upper arm is as long as the forearm
        q = arm.positions([x, *_POINT[1:]])[BRANCHES.index(D4_BRANCH)]
        return np.array([q[0] % (2 * np.pi), q[1], q[2]])

    printed, right = start(forearm, x), start(float(FOREARM), _POINT[0])
    against = "the start that D.4 prints, four decimals"
    return compare(printed, right, D4_PRINTED, "rad", against, _HALF_DIGIT)


def offset_of_the_shoulder() -> Comparison:
    """D.1.3 leads a point of an arm with an offset of 0.127 m; D.1.2, which gets its angles, has 0.1501:
    where the point of each is by the tool's pose."""
    led = bundled("puma560_3dof_d13")
    moved = replace(bundled("puma560_3dof_d12"), tool=led.tool)
    positions = PumaArm(float(OFFSET), float(FOREARM), -float(FOREARM)).positions(_POINT)
    printed, right = (Reference(robot).tool_pose(positions)[:, :, 3] for robot in (moved, led))
    return compare(printed, right, np.tile(_POINT, (4, 1)), "m", "the point x = 0.4, y = z = 0.1 m")


def masses_of_link_3() -> Comparison:
    """D.4: link 3 has 16.04 kg in the inertia matrix and 16.05 kg in the bias."""
    robot = bundled("puma560_3dof_d4")
    lighter = _changed(robot, 3, mass=Fraction("16.04"))
    return _columns(
        _weightless(lighter), _weightless(robot), "the mass matrix of the bias's arm, 1000 states"
    )


def gravity_in_columns() -> Comparison:
    """D.4: columns of the inertia matrix as torques of unit accelerations at rest, gravity not named."""
    robot = bundled("puma560_3dof_d4")
    return _columns(robot, _weightless(robot), "the mass matrix of puma560_3dof_d4, 1000 states")


def _weightless(robot: Robot) -> Robot:
    return replace(robot, gravity=(Fraction(0),) * 3)


def _columns(printed: Robot, right: Robot, against: str) -> Comparison:
    """Torques [K, n, n] of unit accelerations at rest, one joint at a time, against the mass matrix."""
    q, none = states(right)[0], np.zeros((STATES, right.n))
    units = [np.tile(unit, (STATES, 1)) for unit in np.eye(right.n)]
    by_print, mended = (
        np.stack([torques_of(arm, (q, none, unit)) for unit in units], axis=2) for arm in (printed, right)
    )
    return compare(by_print, mended, Reference(right).mass_matrix(q), "kg m^2", against)


def rows_of_torques() -> Comparison:
    """D.4: the row of the torque is time / 0.01, cut off, in single precision: 404 evaluations in steps of
    0.02 s with halves, against the rows that are meant."""
    step, time = np.float32(0.01), np.float32(0)
    cut, rounded = 0, 0  # evaluations that read another row than is meant
    for begin in range(0, 202, 2):  # steps that begin at 0 to 2.00 s
        half = np.float32(time + step)
        end = np.float32(half + step)
        for late, instant in ((0, time), (1, half), (1, half), (2, end)):
            cut += int(instant / step) != begin + late
            rounded += round(float(instant) / 0.01) != begin + late
        time = end
    return compare(cut, rounded, 0, "evaluations of 404", "rows by counting steps")


def rows_beyond_the_table() -> Comparison:
    """D.4: the step that begins at 2.00 s asks for torques beyond 201 rows."""
    rows = [1 + 200 + late for late in (0, 1, 1, 2)]
    there = [min(row, 201) for row in rows]
    return compare(rows, there, there, "rows", "a table of 201 rows")
