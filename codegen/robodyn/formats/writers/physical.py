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

import numpy as np

from robodyn.formats.chain import Body, Pose, body_with, moments_of
from robodyn.formats.frames import rows
from robodyn.formats.limits import LEAST_BODY, MOVED_DIGITS, SLACK
from robodyn.formats.writers.parts import Frame, PartJoint
from robodyn.robot.numbers import shortest
from robodyn.robot.values import ZERO


def physical(joints: Sequence[PartJoint]) -> tuple[tuple[PartJoint, ...], list[str]]:
    """The ``joints`` with bodies that have mass and physical tensors, those that had them unchanged; and what
    was changed."""
    moments = [np.array(moments_of(joint.body), dtype=object) for joint in joints]
    least = LEAST_BODY * (max(float(np.trace(each.astype(float))) for each in moments) or 1.0)
    changed: set[int] = set()
    bad = []
    for index in reversed(range(len(joints))):
        joint = joints[index]
        if index not in changed and _accepted(joint.body, least):
            continue
        missing, possible = _missing(moments[index].astype(float), joint.kind == "revolute", least)
        if not possible:
            bad.append(joint.name)
        if not missing.any():
            continue
        extra = _short(missing)
        moments[index] = moments[index] + extra
        changed.add(index)
        if index:  # what the frame before loses, in its own axes
            step = _homogeneous(joint.frame)
            moments[index - 1] = moments[index - 1] - step @ extra @ step.T
            changed.add(index - 1)
    if bad:
        return tuple(joints), [
            f"no body moves as the description says of {', '.join(bad)}: its inertia is written as it "
            "stands, and MuJoCo and Gazebo will refuse it"
        ]
    bodies = [
        replace(joint, body=body_with(moments[i].tolist())) if i in changed else joint
        for i, joint in enumerate(joints)
    ]
    words = "links without mass, or with an inertia that no body has, stand there as bodies that move alike"
    names = ", ".join(joints[i].name for i in sorted(changed))
    return tuple(bodies), [f"{words}: {names}"] if changed else []


def _accepted(body: Body, least: float) -> bool:
    """Whether MuJoCo takes the body: mass, and no principal moment above the sum of the two others. Those of
    a diagonal tensor are compared as they are, so that a flat body is one; others are rounded on the way."""
    xx, yy, zz, xy, xz, yz = body.inertia
    diagonal = not any((xy, xz, yz))
    tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    low, middle, high = sorted((xx, yy, zz) if diagonal else np.linalg.eigvalsh(tensor).tolist())
    room = 0.0 if diagonal else SLACK
    return bool(body.mass >= least and low >= least and low + middle >= high * (1 + room))


def _missing(moments: Any, revolute: bool, least: float) -> tuple[Any, bool]:
    """What can be added to ``moments`` without changing how the arm moves, for it to be a body's; and whether
    that makes it one."""
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


def _short(matrix: Any) -> Any:
    """The symmetric ``matrix``, positive or zero, in few digits and none the smaller for it; exact."""
    unit = Fraction(10) ** (math.floor(math.log10(abs(matrix).max())) - MOVED_DIGITS)
    short = np.array([[round(Fraction(float(x)) / unit) * unit for x in row] for row in matrix], dtype=object)
    for k in range(len(short)):
        if matrix[k].any():  # rounding takes half a unit from each entry of a row at the most
            short[k, k] += len(short) * unit
    return short


def _homogeneous(frame: Frame) -> Any:
    """The pose of ``frame`` [4, 4], exact, whole numbers where it turns axes into axes."""
    turn = rows(Pose.from_rpy(frame.xyz, frame.rpy).rotation)
    matrix = [[*row, shortest(x)] for row, x in zip(turn, frame.xyz, strict=True)]
    return np.array([*matrix, [ZERO, ZERO, ZERO, Fraction(1)]], dtype=object)
