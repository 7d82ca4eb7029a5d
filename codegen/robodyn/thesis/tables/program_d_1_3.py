"""Program D.1.3, the inverse kinematics of the PUMA's first three joints, beside the generated one."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, Final

from robodyn.counts import count
from robodyn.kernels.generate import Options, program
from robodyn.robot import load
from robodyn.robot.model import Robot
from robodyn.thesis.case_arm import D4_BRANCH, FOREARM, LED_ROBOT, OFFSET, led
from robodyn.thesis.tables.table import Column, Row, Table, judged

#: Where simulation D.4 begins as the thesis prints it [rad]; the point that it is said to be at, x [m], and
#: the y and z that its line begins at.
D4_PRINTED: Final = (3.6997, 2.3083, 0.5951)
X_PRINTED: Final = Fraction(3, 10)
Y_AND_Z: Final = Fraction(1, 10)
#: The x at which the printed positions put the point [m].
X: Final = Fraction(4, 10)
#: The forearm by the comment of D.1.3, which computes with another [m].
FOREARM_IN_COMMENT: Final = Fraction(4521, 10000)


def generated(robot: Robot, point: tuple[Fraction, Fraction, Fraction]) -> list[list[float]]:
    """Joint positions [4][3] (rad) of all branches by the generated inverse kinematics, in floats."""
    from robodyn.dynamics.arm import build_arm
    from robodyn.dynamics.inverse import inverse_of

    inverse = inverse_of(build_arm(robot, lambda x: x, lambda name: name), [None] * robot.n)
    pose: list[Any] = [1.0, 0.0, 0.0, point[0], 0.0, 1.0, 0.0, point[1], 0.0, 0.0, 1.0, point[2]]
    solved = inverse.solve([float(x) for x in pose], [0.0] * robot.n, Fraction(1, 1 << 52))
    assert all(solved.exists)
    return [[float(x) for x in q] for q in solved.solutions]


def table() -> Table:
    """The four branches at the beginning of simulation D.4, and the numbers of D.1.3 that do not fit."""
    arm = led("programs")
    point = (X, Y_AND_Z, Y_AND_Z)
    robot = load(LED_ROBOT)
    ours = generated(robot, point)
    by_formulas = arm.inverse.positions([float(x) for x in point])
    rows = [_branch_row(signs, q, ours) for signs, q in zip(_SIGNS, by_formulas.tolist(), strict=True)]
    return Table(
        "inverse",
        "program D.1.3: inverse kinematics of the PUMA 560's first three joints",
        (Column("printed", "printed", "value"), Column("ours", "ours", "value")),
        (*rows, _operations(robot), *_numbers()),
        (
            "The branches are those of the point x = 0.4, y = z = 0.1 m, where simulation D.4 begins, by the "
            "generated inverse kinematics; beside it, by how much the formulas of D.1.3 differ. Both put the "
            "point back to within rounding on all four.",
        ),
    )


def _operations(robot: Robot) -> Row:
    """What the generated kernel takes for all branches."""
    kernel = count(program(robot, "inverse_kinematics", Options(("inverse_kinematics",))))
    return Row(
        "operations",
        {},
        {"value": str(kernel.total), "operations": kernel.to_dict()},
        None,
        f"not printed; multiplications, additions, divisions and square roots of {robot.name}'s generated "
        "inverse kinematics, all four branches together",
    )


#: The roots of the four branches, of q1 and of q3, in the order in which the formulas have them.
_SIGNS: Final = ((1, 1), (1, -1), (-1, 1), (-1, -1))


def _branch_row(signs: tuple[int, int], q: list[float], ours: list[list[float]]) -> Row:
    name = "q1 by {} root, q3 by {} root".format(*("plus" if s > 0 else "minus" for s in signs))
    nearest = min(ours, key=lambda other: _apart(other, q))
    beside = ({"what": "off the formulas of D.1.3 [rad]", "largest": f"{_apart(nearest, q):.1e}"},)
    if signs != D4_BRANCH:
        return Row(name, {}, {"value": _positions(nearest)}, None, "not printed", beside)
    turned = [nearest[0] % (2 * math.pi), *nearest[1:]]
    same = max(abs(x - y) for x, y in zip(turned, D4_PRINTED, strict=True)) <= 5.1e-5
    reason = "where D.4 begins, q1 one turn on; not the branch that D.1.3 takes first"
    printed = {"value": _positions(D4_PRINTED)}
    return Row(name, printed, {"value": _positions(turned)}, judged(same), reason, beside)


def _numbers() -> tuple[Row, ...]:
    return (
        _number(
            "x of the line [m]",
            X_PRINTED,
            X,
            "the printed positions of D.4 put the point at x = 0.4; at 0.3 they are 0.2 rad off at best",
        ),
        _number(
            "forearm [m]",
            FOREARM_IN_COMMENT,
            FOREARM,
            "the comment of D.1.3 has the first, its formulas the second; the six-joint arm has 0.4331 and "
            "an elbow of -0.0203",
        ),
        _number(
            "shoulder's offset [m]",
            OFFSET,
            Fraction(1501, 10000),
            "D.1.3 leads the point with the first, D.1.2, which computes the torques, has the second",
        ),
    )


def _number(name: str, printed: Fraction, ours: Fraction, reason: str) -> Row:
    return Row(name, {"value": f"{float(printed):g}"}, {"value": f"{float(ours):g}"}, judged(False), reason)


def _apart(one: list[float], other: list[float]) -> float:
    return max(abs(math.remainder(x - y, math.tau)) for x, y in zip(one, other, strict=True))


def _positions(q: tuple[float, ...] | list[float]) -> str:
    return ", ".join(f"{x:.4f}" for x in q)
