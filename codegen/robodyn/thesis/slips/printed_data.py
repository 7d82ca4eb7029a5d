"""Printed data and programs: sums, parameters, and what programs D.1.3, D.2 and D.4 compute with.

Source: Dhanaraj 1990, Tables 1.1 to 4.6, programs D.1 to D.4.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.arm import origin
from robodyn.robot.model import Link, Robot
from robodyn.robot.parts import Placement
from robodyn.schedule.arithmetic import run_tasks
from robodyn.schedule.tasks import FLOPS_PER_TASK
from robodyn.thesis.case_arm import D4_BRANCH, FOREARM, OFFSET
from robodyn.thesis.printed_counts import TABLE_1_1, TABLE_2_9, TABLE_3_3
from robodyn.thesis.printed_parameters import D_2, D_2_LAST_DIGIT, PUMA, moved_to_origin
from robodyn.thesis.printed_tasks import TABLE_4_4_ZEROS, TABLE_4_5, TABLE_4_6
from robodyn.thesis.puma_inverse import BRANCHES, PumaArm
from robodyn.thesis.slips.comparison import Comparison, compared
from robodyn.thesis.slips.recursion import STATES, Recursion, bundled, scalars, stacked, states
from robodyn.thesis.tables.program_d_1_3 import D4_PRINTED
from robodyn.thesis.tables.table_3_3 import journal
from robodyn.thesis.tables.table_4_5 import flops
from robodyn.verify.reference import Reference

Floats = NDArray[np.float64]

# --- sums -------------------------------------------------------------------------------------------------


def sampling() -> Comparison:
    """Section 1.1: 20 times 5 to 10 Hz."""
    exact = [20 * hertz for hertz in (5, 10)]
    return compared([1000, 2000], [100, 200], exact, "Hz", "20 times 5 and 10 Hz")


def polynomial() -> Comparison:
    """Table 1.1: Uicker and Kahn's multiplications for six joints against the printed polynomial."""
    row = TABLE_1_1["uicker_kahn"]
    value = Fraction(0)
    for coefficient in row.mul:
        value = value * 6 + coefficient
    return compared([row.mul_6], [67143], [float(value)], "multiplications", "the printed polynomial at 6")


def additions_of_a_joint() -> Comparison:
    """Table 2.9: additions of a revolute joint, method II, against the column."""
    column = TABLE_2_9["revolute_II"]
    added = sum(pair[1] for step, pair in column.items() if step != "total")
    return compared([column["total"][1]], [113], [added], "additions", "the sum of the printed column")


def additions_of_friction() -> Comparison:
    """Table 3.3: additions of Eq 3.3 against carrying it out on numbers that count."""

    printed = TABLE_3_3["joint"]["revolute"][1]
    return compared([printed], [7], [journal().add], "additions", "Eq 3.3 carried out")


def zeros_of_the_stanford_arm() -> Comparison:
    """Table 4.4: zeros among the components of s and p, against the bundled robot's numbers."""
    robot = bundled("stanford")
    vectors = [link.com for link in robot.links]
    # in a position without zeros of its own, so that only the numbers of the robot are zero
    arm, motion = scalars(robot, _alike(robot, 0.7, 0.0, 0.0))

    origins: list[Any] = [origin(body, d) for body, d in zip(arm.bodies[1:], motion.d[1:], strict=True)] + [
        (0, 0, 0)
    ]
    zeros = sum(bool(np.all(np.asarray(x, dtype=float) == 0)) for v in (*vectors, *origins) for x in v)
    return compared([TABLE_4_4_ZEROS[0]], [26], [zeros], "zeros", "the numbers of stanford")


def _alike(robot: Robot, q: float, qd: float, qdd: float) -> tuple[Floats, Floats, Floats]:
    """All joints alike, in every state."""
    shape = (STATES, robot.n)
    return np.full(shape, q), np.full(shape, qd), np.full(shape, qdd)


def tasks_of_link_2() -> Comparison:
    """Table 4.6: the number of eliminated tasks beside link 2 against its list."""
    *_, tasks, total = TABLE_4_6[1]
    return compared([total], [12], [len(tasks)], "tasks", "the printed list of link 2")


def eliminated_or_executed() -> Comparison:
    """Table 4.5: its columns read as tasks eliminated, as the caption says, and as tasks executed, against
    the operations that are left."""

    printed, right, truth = [], [], []
    for rule in TABLE_4_5:
        for zeros, column in enumerate(rule.executed, 1):
            printed.append(len(rule.tasks) - len(column))
            right.append(len(column))
            truth.append(-(-flops(rule.tasks, zeros) // FLOPS_PER_TASK))
    return compared(printed, right, truth, "tasks", "operations left, three a task")


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
    reads = {}
    for moved in range(1, robot.n):  # the origin of link moved + 1, counted from 1, is p of link `moved`
        other = products([(0.4, 0.5, 0.6) if k == moved else p for k, p in enumerate(rest)])
        for link in range(2, robot.n + 1):
            if not np.allclose(other[link - 1], before[link - 1]):
                reads[link] = moved
    links = range(2, robot.n + 1)
    truth = [reads.get(link, 0) for link in links]
    return compared(links, [link - 1 for link in links], truth, "link", "origins moved one at a time")


# --- parameters -------------------------------------------------------------------------------------------


def tenfold_inertias() -> Comparison:
    """Table 2.6: links 5 and 6, moved to the links' origins, against the tensors of program D.2."""
    printed, right, truth = [], [], []
    for link, tensor in zip(PUMA[4:], D_2[4:], strict=True):
        xx, yy, zz = (None if x is None else x / 10 for x in link.moments)
        smaller = replace(link, moments=(xx, yy, zz))
        printed += _numbers(moved_to_origin(link))
        right += _numbers(moved_to_origin(smaller))
        truth += _numbers(tensor)
    half = float(D_2_LAST_DIGIT) / 2
    return compared(printed, right, truth, "kg m^2", "the tensors of program D.2, four decimals", half)


def _numbers(values: Sequence[Fraction | None]) -> list[float]:
    return [float(x) for x in values if x is not None]


def of_arms(printed: Robot, right: Robot, what: str) -> Comparison:
    """Torques of two arms by the recursion against Newton-Euler of the ``right`` one."""
    at = states(right)
    by_print, mended = (stacked(Recursion().torques(*scalars(robot, at))) for robot in (printed, right))
    return compared(
        by_print, mended, Reference(right).inverse_dynamics(*at), "N m", f"Newton-Euler of {what}"
    )


def changed(robot: Robot, change: Callable[[int, Link], Link]) -> Robot:
    """``robot`` with its links changed, ``change`` being told their numbers from 1."""
    return replace(robot, links=tuple(change(i, link) for i, link in enumerate(robot.links, 1)))


def sign_of_z_of_link_3() -> Comparison:
    """Table 2.7: z of the Stanford arm's link 3 is positive, in the programs negative."""
    programs = bundled("stanford_d3")

    def with_other_sign(i: int, link: Link) -> Link:
        x, y, z = link.com
        return replace(link, com=(x, y, -z)) if i == 3 else link

    return of_arms(changed(programs, with_other_sign), programs, "stanford_d3, 1000 states")


def _table_with_rotors_in_links() -> Robot:
    """The arm of D.2 with Table 2.6's tensors about the centres of mass and the rotors in Izz."""
    rotors = bundled("puma560_rotor_in_link")

    def own_tensor(i: int, link: Link) -> Link:
        return replace(link, inertia=rotors.links[i - 1].inertia)

    return changed(bundled("puma560_d2"), own_tensor)


def parallel_axes_twice() -> Comparison:
    """D.2: tensors about the links' origins in a recursion that adds s x F besides."""
    return of_arms(bundled("puma560_d2"), _table_with_rotors_in_links(), "puma560_d2, tensors not moved")


def rotors_in_links() -> Comparison:
    """D.2: rotor inertias in the links' Izz, which turn with everything before them."""
    return of_arms(bundled("puma560_rotor_in_link"), bundled("puma560"), "puma560, 1000 states")


def centres_without_y_and_z() -> Comparison:
    """D.2: y and z of the centres of mass of links 2 and 3 left out."""
    tables = bundled("puma560")

    def flattened(i: int, link: Link) -> Link:
        x, y, _ = link.com
        return replace(link, com=(x, Fraction(0) if i == 2 else y, Fraction(0))) if i in (2, 3) else link

    return of_arms(changed(tables, flattened), tables, "puma560, 1000 states")


def sign_of_x_of_link_2() -> Comparison:
    """D.2: x of link 2 is -0.068, in Table 2.5 it is 0.068."""
    tables = bundled("puma560")

    def with_other_sign(i: int, link: Link) -> Link:
        x, y, z = link.com
        return replace(link, com=(-x, y, z)) if i == 2 else link

    return of_arms(changed(tables, with_other_sign), tables, "puma560, 1000 states")


def centre_of_link_4() -> Comparison:
    """D.2: the centre of mass of link 4 is at the origin; the listing D.3.4 has z = -0.019."""
    listing = bundled("puma560_d2")

    def centred(i: int, link: Link) -> Link:
        return replace(link, com=(Fraction(0),) * 3) if i == 4 else link

    return of_arms(changed(listing, centred), listing, "puma560_d2, 1000 states")


def link_1_left_out() -> Comparison:
    """D.3.2: the mass of the Stanford arm's link 1 left out."""
    whole = bundled("stanford_d3")

    def weightless(i: int, link: Link) -> Link:
        none: Any = (Fraction(0),) * 3
        return replace(link, mass=Fraction(0), com=none) if i == 1 else link

    return of_arms(changed(whole, weightless), whole, "stanford_d3, 1000 states")


def wrist_as_a_point() -> Comparison:
    """D.3.1: the wrist's masses at the centre of mass of link 3, against the six-joint arm at rest in the
    wrist: torques of the first three joints."""
    six, three = bundled("stanford_d3"), bundled("stanford_3dof_d3")
    q, qd, qdd = states(six)
    still = [np.where(np.arange(six.n) < 3, x, 0.0) for x in (qd, qdd)]
    truth = Reference(six).inverse_dynamics(q, *still)[:, :3]
    right = stacked(Recursion().torques(*scalars(six, (q, still[0], still[1]))))[:, :3]
    printed = stacked(Recursion().torques(*scalars(three, (q[:, :3], still[0][:, :3], still[1][:, :3]))))
    return compared(printed, right, truth, "N m", "Newton-Euler of stanford_d3, wrist still, 1000 states")


def inertia_sets_of_d_1() -> Comparison:
    """D.1: programs D.1.1 and D.1.2 are of one arm and have two sets of inertias."""
    return of_arms(bundled("puma560_3dof_d11"), bundled("puma560_3dof_d12"), "puma560_3dof_d12, 1000 states")


# --- programs D.1.3 and D.4 -------------------------------------------------------------------------------

#: Half a unit of the last digit of the start that D.4 prints [rad].
_HALF_DIGIT: Final = 0.51e-4
_POINT: Final = (0.4, 0.1, 0.1)


def _start(forearm: float, x: float) -> Floats:
    """Joint positions [3] at the start of D.4 by the formulas of D.1.3, on its branch and in its turn."""
    arm = PumaArm(float(OFFSET), float(FOREARM), -forearm)  # the upper arm is as long as the forearm
    q = arm.positions([x, *_POINT[1:]])[BRANCHES.index(D4_BRANCH)]
    return np.array([q[0] % (2 * np.pi), q[1], q[2]])


def forearm_in_comment() -> Comparison:
    """D.1.3: the comment's forearm and the formulas', against the start that D.4 prints."""
    printed, right = (_start(length, _POINT[0]) for length in (0.4521, float(FOREARM)))
    return compared(
        printed, right, D4_PRINTED, "rad", "the start that D.4 prints, four decimals", _HALF_DIGIT
    )


def x_of_the_line() -> Comparison:
    """D.1.3: x = 0.3 m, where D.4's start needs 0.4."""
    printed, right = (_start(float(FOREARM), x) for x in (0.3, _POINT[0]))
    return compared(
        printed, right, D4_PRINTED, "rad", "the start that D.4 prints, four decimals", _HALF_DIGIT
    )


def offset_of_the_shoulder() -> Comparison:
    """D.1.3 leads a point of an arm with an offset of 0.127 m; D.1.2, which gets its angles, has 0.1501:
    where the point of each is by the tool's pose."""
    led = bundled("puma560_3dof_d13")
    tool = led.tool
    assert isinstance(tool, Placement)
    moved = replace(bundled("puma560_3dof_d12"), tool=tool)
    inverse = PumaArm(float(OFFSET), float(FOREARM), -float(FOREARM))
    positions = inverse.positions(_POINT)
    printed, right = (Reference(robot).tool_pose(positions)[:, :, 3] for robot in (moved, led))
    return compared(printed, right, np.tile(_POINT, (4, 1)), "m", "the point x = 0.4, y = z = 0.1 m")


def _columns(robot: Robot, *, with_gravity: bool) -> Floats:
    """Torques [K, n, n] of unit accelerations, one joint at a time, at rest."""
    still = robot if with_gravity else replace(robot, gravity=(Fraction(0),) * 3)
    q, none, _ = states(robot)[0], np.zeros((STATES, robot.n)), None
    units = (np.tile(np.eye(robot.n)[j], (STATES, 1)) for j in range(robot.n))
    columns = [stacked(Recursion().torques(*scalars(still, (q, none, unit)))) for unit in units]
    return np.stack(columns, axis=2)


def masses_of_link_3() -> Comparison:
    """D.4: link 3 has 16.04 kg in the inertia matrix and 16.05 kg in the bias."""
    robot = bundled("puma560_3dof_d4")

    def lighter(i: int, link: Link) -> Link:
        return replace(link, mass=Fraction("16.04")) if i == 3 else link

    by_print, mended = (_columns(arm, with_gravity=False) for arm in (changed(robot, lighter), robot))
    truth = Reference(robot).mass_matrix(states(robot)[0])
    return compared(by_print, mended, truth, "kg m^2", "the mass matrix of the bias's arm, 1000 states")


def gravity_in_columns() -> Comparison:
    """D.4: columns of the inertia matrix as torques of unit accelerations at rest, gravity not named."""
    robot = bundled("puma560_3dof_d4")
    by_print, mended = (_columns(robot, with_gravity=gravity) for gravity in (True, False))
    truth = Reference(robot).mass_matrix(states(robot)[0])
    return compared(by_print, mended, truth, "kg m^2", "the mass matrix of puma560_3dof_d4, 1000 states")


def rows_of_torques() -> Comparison:
    """D.4: the row of the torque is time / 0.01, cut off, in single precision: 404 evaluations in steps of
    0.02 s with halves, against the rows that are meant."""
    step = np.float32(0.01)
    time = np.float32(0)
    cut, rounded = 0, 0  # evaluations that read another row than is meant
    for begin in range(0, 202, 2):  # steps that begin at 0 to 2.00 s
        half = np.float32(time + step)
        end = np.float32(half + step)
        for late, instant in ((0, time), (1, half), (1, half), (2, end)):
            cut += int(instant / step) != begin + late
            rounded += round(float(instant) / 0.01) != begin + late
        time = end
    return compared([cut], [rounded], [0], "evaluations of 404", "rows by counting steps")


def rows_beyond_the_table() -> Comparison:
    """D.4: the step that begins at 2.00 s asks for torques beyond 201 rows."""
    rows = [1 + 200 + late for late in (0, 1, 1, 2)]
    there = [min(row, 201) for row in rows]
    return compared(rows, there, there, "rows", "a table of 201 rows")
