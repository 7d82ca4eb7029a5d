"""Bodies that move as those of a description do, and that MuJoCo and SDF accept: with mass, and with tensors
that some body has.

A description may state less: only what enters torques, or a table of moments that no body has. A body is here
its pseudo-inertia, the integral of ``[r; 1] [r; 1]^T`` over its mass, which is positive definite for every
body that is not flat. Mass on a revolute joint's axis counts for either link alike, since the axis belongs to
both, and so does the second moment of mass of links that slide along each other: that much is moved from the
link before, and behind the base it is free. What is moved has few digits, and sums are exact: decimals of the
description stay decimals, and the arm's function the same.

Source: Wensing, Kim and Slotine, RA-L 2018 (pseudo-inertia); Gautier 1991 (what can be moved).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from robodyn.formats.chain import Body, Pose
from robodyn.formats.frames import rows
from robodyn.formats.limits import LEAST_BODY, MOVED_DIGITS, SLACK
from robodyn.formats.writers.parts import Frame, PartJoint
from robodyn.robot.numbers import shortest
from robodyn.robot.values import ZERO

_Rows = list[list[Fraction]]


def physical(joints: Sequence[PartJoint]) -> tuple[tuple[PartJoint, ...], list[str]]:
    """The ``joints`` with bodies that have mass and physical tensors, those that had them unchanged; and what
    was changed."""
    import numpy as np

    moments = [_moments(joint.body) for joint in joints]
    least = LEAST_BODY * (max(float(np.trace(_floats(each))) for each in moments) or 1.0)
    changed: dict[int, _Rows] = {}
    bad = []
    for index in reversed(range(len(joints))):
        joint = joints[index]
        if index not in changed and _accepted(joint.body, least):
            continue
        missing, possible = _missing(_floats(moments[index]), joint.kind == "revolute", least)
        if not possible:
            bad.append(joint.name)
        if not missing.any():
            continue
        extra = _short(missing)
        changed[index] = moments[index] = _sum(moments[index], extra, 1)
        if index:
            step = _homogeneous(joint.frame)
            changed[index - 1] = moments[index - 1] = _sum(moments[index - 1], _seen(step, extra), -1)
    if bad:
        return tuple(joints), [
            f"no body moves as the description says of {', '.join(bad)}: its inertia is written as it "
            "stands, and MuJoCo and Gazebo will refuse it"
        ]
    if not changed:
        return tuple(joints), []
    bodies = [
        replace(joint, body=_body(changed[i])) if i in changed else joint for i, joint in enumerate(joints)
    ]
    names = ", ".join(joints[i].name for i in sorted(changed))
    return tuple(bodies), [
        "links without mass, or with an inertia that no body has, stand there as bodies that move alike: "
        + names
    ]


def _accepted(body: Body, least: float) -> bool:
    """Whether MuJoCo takes the body: mass, and no principal moment above the sum of the two others. Those of
    a diagonal tensor are compared as they are, so that a flat body is one; others are rounded on the way."""
    import numpy as np

    diagonal = not any(body.inertia[3:])
    moments = body.inertia[:3] if diagonal else np.linalg.eigvalsh(_tensor(body.inertia)).tolist()
    low, middle, high = sorted(moments)
    room = 0.0 if diagonal else SLACK
    return bool(body.mass >= least and low >= least and low + middle >= high * (1 + room))


def _missing(moments: Any, revolute: bool, least: float) -> tuple[Any, bool]:
    """What can be added to ``moments`` without changing how the arm moves, for it to be a body's; and whether
    that makes it one."""
    import numpy as np

    extra, free = np.zeros((4, 4)), [2, 3] if revolute else [0, 1, 2]
    fixed = [k for k in range(4) if k not in free]
    rigid = moments[np.ix_(fixed, fixed)]
    lowest, scale = float(np.linalg.eigvalsh(rigid)[0]), float(np.trace(moments))
    if lowest < -SLACK * abs(scale):
        return extra, False
    if lowest < least:  # a mass too small to be noticed
        floor = 2 * least * np.eye(len(fixed))
        extra[np.ix_(fixed, fixed)] = floor
        rigid = rigid + floor
    across = moments[np.ix_(free, fixed)]
    needed = across @ np.linalg.solve(rigid, across.T)
    there = moments[np.ix_(free, free)]
    room = SLACK * max(float(np.trace(rigid) + np.trace(needed)), 1e3 * least)
    lacking = needed + room * np.eye(len(free)) - there
    if revolute and lacking[1, 1] < 0:  # it has mass: a moment is all that is moved
        extra[2, 2] = max(float(lacking[0, 0] + lacking[0, 1] ** 2 / -lacking[1, 1]), 0.0)
        return extra, True
    values, vectors = np.linalg.eigh(lacking)
    extra[np.ix_(free, free)] = (vectors * np.maximum(values, 0)) @ vectors.T
    return extra, True


def _short(matrix: Any) -> _Rows:
    """The symmetric ``matrix``, positive or zero, in few digits and none the smaller for it."""
    unit = Fraction(10) ** (math.floor(math.log10(abs(matrix).max())) - MOVED_DIGITS)
    rows = [[round(Fraction(float(entry)) / unit) * unit for entry in row] for row in matrix]
    for k, row in enumerate(rows):
        if matrix[k].any():  # rounding takes half a unit from each entry of a row at the most
            row[k] += len(rows) * unit
    return rows


def _tensor(inertia: Sequence[float]) -> Any:
    import numpy as np

    xx, yy, zz, xy, xz, yz = inertia
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def _moments(body: Body) -> _Rows:
    """The pseudo-inertia [4, 4] about the frame's origin: second and first moments, and mass."""
    mass, com = shortest(body.mass), [*map(shortest, body.com), Fraction(1)]
    xx, yy, zz, xy, xz, yz = map(shortest, body.inertia)
    half = (xx + yy + zz) / 2
    second = [[half - xx, -xy, -xz], [-xy, half - yy, -yz], [-xz, -yz, half - zz]]
    central = [[*row, ZERO] for row in second] + [[ZERO] * 4]
    return [
        [x + mass * r * c for x, c in zip(row, com, strict=True)] for row, r in zip(central, com, strict=True)
    ]


def _body(moments: _Rows) -> Body:
    mass = moments[3][3]
    com = [moments[k][3] / mass for k in range(3)]
    (a, d, e), (_, b, f), (_, _, c) = (
        [moments[i][k] - mass * com[i] * com[k] for k in range(3)] for i in range(3)
    )
    x, y, z = map(float, com)
    entries = tuple(map(float, (b + c, a + c, a + b, -d, -e, -f)))
    return Body(float(mass), (x, y, z), entries)  # type: ignore[arg-type]  # six of them


def _homogeneous(frame: Frame) -> _Rows:
    """The pose of ``frame`` [4, 4], whole numbers where it turns axes into axes."""
    turn = rows(Pose.from_rpy(frame.xyz, frame.rpy).rotation)
    matrix = [[*row, shortest(x)] for row, x in zip(turn, frame.xyz, strict=True)]
    return [*matrix, [ZERO, ZERO, ZERO, Fraction(1)]]


def _seen(step: _Rows, moments: _Rows) -> _Rows:
    """``moments`` in the frame that ``step`` leads from."""
    return _product(_product(step, moments), [list(column) for column in zip(*step, strict=True)])


def _product(one: _Rows, other: _Rows) -> _Rows:
    columns = list(zip(*other, strict=True))
    return [[sum((x * y for x, y in zip(row, c, strict=True)), ZERO) for c in columns] for row in one]


def _sum(one: _Rows, other: _Rows, sign: int) -> _Rows:
    return [[x + sign * y for x, y in zip(u, v, strict=True)] for u, v in zip(one, other, strict=True)]


def _floats(moments: _Rows) -> Any:
    import numpy as np

    return np.array(moments, dtype=float)
