"""Which program an arm ran, by its path alone: logs whose paths in joint space cover each other.

Nothing of the torque is asked, nor how fast or how often a path was gone through. What differs between two
logs of one program is the arm; a log of another program says nothing of a change, but is one of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from scipy.spatial import cKDTree

from robodyn.arrays import Floats, Indices
from robodyn.fleet.digest import Digest
from robodyn.fleet.limits import COVERED, FALSE_NAMES, PART_COVERED, PERMUTATIONS


def programs_of(units: Indices, digest: Callable[[int], Digest]) -> Indices:
    """The program [K] of each log of a type (``units`` [K]: the unit of each): a number from 0 on, in the
    order of the logs. Two units may run one program."""
    labels = np.full(len(units), -1)
    leaders: list[tuple[Floats, float, Floats]] = []  # of each program: path, size of cells, mean and scatter
    for unit in dict.fromkeys(units.tolist()):
        own = np.flatnonzero(units == unit)
        paths = [(one.path, one.cell) for one in map(digest, own.tolist())]
        for group in _groups(paths):
            path, cell = max((paths[k] for k in group), key=lambda one: len(one[0]))
            look = np.concatenate([path.mean(axis=0), path.std(axis=0)])
            alike = (
                k for k, one in enumerate(leaders) if np.abs(one[2] - look).max() < 5 * max(cell, one[1])
            )
            same = next((k for k in alike if is_same(leaders[k][:2], (path, cell))), len(leaders))
            if same == len(leaders):
                leaders.append((path, cell, look))
            labels[own[group]] = same
    _, first, dense = np.unique(labels, return_index=True, return_inverse=True)
    return np.argsort(np.argsort(first))[dense]


def _groups(paths: Sequence[tuple[Floats, float]]) -> list[list[int]]:
    """The paths of a unit by programs, the longest paths first: each joins a program with a path that it
    shares."""
    groups: list[list[int]] = []
    for k in sorted(range(len(paths)), key=lambda k: -len(paths[k][0])):
        same = (group for group in groups if any(is_same(paths[one], paths[k]) for one in group[:3]))
        group = next(same, None)
        if group is None:
            groups.append([k])
        else:
            group.append(k)
    return groups


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


def program_change(programs: Indices, usually: float, seed: int) -> int | None:
    """From which log on (of those of a unit, by date, from 2 on) it runs none of the ``programs`` [K] that it
    ran before; None where it never does, or where programs that take turns could look so by chance.
    ``usually``: the share of successive logs in the fleet that are of two programs."""
    place, shorter = _split(programs)
    if not shorter:
        return None
    rng = np.random.default_rng(seed)
    chance = np.mean([_split(rng.permutation(programs))[1] >= shorter for _ in range(PERMUTATIONS)])
    return place if min(float(chance), usually) <= FALSE_NAMES else None


def _split(programs: Indices) -> tuple[int, int]:
    """The log from which on no program of those before comes back, and how many logs there are on the shorter
    side of it, at least two; of several that with most, of none 0."""
    best = (0, 0)
    for k in range(2, len(programs) - 1):
        if not np.isin(programs[k:], programs[:k]).any():
            best = max(best, (k, min(k, len(programs) - k)), key=lambda one: one[1])
    return best


def switching(units: Indices, programs: Indices) -> float:
    """The share of successive logs of a unit that are of two programs."""
    same = units[1:] == units[:-1]
    return float((programs[1:] != programs[:-1])[same].mean()) if same.any() else 1.0
