"""Which program an arm ran, by its path alone: logs whose paths in joint space cover each other.

Nothing of the torque is asked, nor how fast or how often a path was gone through. What differs between two
logs of one program is the arm; a log of another program says nothing of a change, but is one of its own.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from scipy.spatial import cKDTree

from robodyn.arrays import Floats, Indices
from robodyn.fleet.digest import Digest
from robodyn.fleet.limits import COVERED, PART_COVERED


def programs_of(units: Indices, digest: Callable[[int], Digest]) -> Indices:
    """The program [K] of each log of a type (``units`` [K]: the unit of each): a number from 0 on, in the
    order of the logs. Two units may run one program. Of each unit the logs with the longest paths come first:
    each joins a program of the unit that it shares a path with, else one of others that looks like it."""
    labels = np.full(len(units), -1)
    leaders: list[tuple[Floats, float, Floats]] = []  # of each program: path, size of cells, mean and scatter
    for unit in dict.fromkeys(units.tolist()):
        own = ((k, digest(k)) for k in np.flatnonzero(units == unit).tolist())
        paths = [(k, one.path, one.cell) for k, one in own]
        of_unit: list[int] = []
        for k, path, cell in sorted(paths, key=lambda row: -len(row[1])):
            look = np.concatenate([path.mean(axis=0), path.std(axis=0)])
            far = [np.abs(one[2] - look).max() > 5 * max(cell, one[1]) for one in leaders]
            others = [p for p, is_far in enumerate(far) if not is_far]
            fitting = (p for p in (*of_unit, *others) if is_same(leaders[p][:2], (path, cell)))
            labels[k] = same = next(fitting, len(leaders))
            if same == len(leaders):
                leaders.append((path, cell, look))
            if same not in of_unit:
                of_unit.append(same)
    _, first, dense = np.unique(labels, return_index=True, return_inverse=True)
    return np.argsort(np.argsort(first))[dense]


def is_same(one: tuple[Floats, float], other: tuple[Floats, float]) -> bool:
    """Whether two paths [m, n], each with the size of its cells, are of one program: most of the shorter one
    lies along the longer one, and a good part of that along the shorter one (which may be a part of it)."""
    n = one[0].shape[1]
    radius = max(one[1], other[1]) * np.sqrt(n) / 2
    shares = [
        float((cKDTree(a).query(b, distance_upper_bound=radius)[0] < radius).mean())
        for a, b in ((one[0], other[0]), (other[0], one[0]))
    ]
    return max(shares) > COVERED and min(shares) > PART_COVERED


def split_of(programs: Indices) -> int | None:
    """From which log on (of those of a unit, by date, from 2 on) it runs none of the ``programs`` [K] that it
    ran before, with most logs on either side; None where it never does."""
    count = len(programs)
    places = [k for k in range(2, count - 1) if not np.isin(programs[k:], programs[:k]).any()]
    return min(places, key=lambda k: abs(2 * k - count), default=None)


def chances_of(programs: Indices) -> Floats:
    """How often a random order of a unit's logs has a split with 0, 1, 2 ... logs or more on either side: of
    all sets of so many logs that might come first, those that are all logs of some ``programs`` [K]."""
    count, sets = len(programs), np.ones(1)
    for own in np.unique(programs, return_counts=True)[1].tolist():
        sets = np.convolve(sets, np.bincount([0, own]))
    share = np.array([sets[k] / math.comb(count, k) for k in range(count + 1)])
    return np.array([share[k : count + 1 - k].sum() for k in range(count // 2 + 1)])


def switching(units: Indices, programs: Indices) -> float:
    """The share of successive logs of a unit that are of two programs."""
    same = units[1:] == units[:-1]
    return float((programs[1:] != programs[:-1])[same].mean()) if same.any() else 1.0
