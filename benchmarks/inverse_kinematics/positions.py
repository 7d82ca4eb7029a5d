"""Joint positions that poses are made of: drawn from a hash of the arm's name, the same for anybody."""

from __future__ import annotations

import hashlib

import numpy as np
from benchmarks.inverse_kinematics.chain import Chain, Floats

#: Positions of a joint among which a change of sign of the determinant is looked for.
_GRID = 65
#: Halvings of an interval between two of them, until neighbouring doubles are left.
_HALVINGS = 60
#: How far beside a singularity [rad, m]: on it, and where double precision begins to lose digits.
NEAR = (0.0, 1e-12, 1e-9, 1e-6, 1e-3)


def generator(chain: Chain, purpose: str) -> np.random.Generator:
    """Random numbers that belong to the arm and the purpose."""
    digest = hashlib.sha256(f"{chain.name} {purpose}".encode()).digest()
    return np.random.default_rng(int.from_bytes(digest[:8], "little"))


def drawn(chain: Chain, count: int, purpose: str = "sets") -> Floats:
    """Positions [count, n] within half a turn to each side, whatever the limits; slides within theirs."""
    random = generator(chain, purpose)
    low, high = chain.ranges()
    return random.uniform(low, high, (count, chain.n))


def at_limits(chain: Chain, count: int) -> Floats:
    """Positions [count, n] of which each joint is exactly at one of its limits, or anywhere, at random."""
    random = generator(chain, "limits")
    low, high = chain.ranges()
    q = random.uniform(low, high, (count, chain.n))
    limited = np.isfinite(chain.limits).all(axis=1)
    ends = np.where(random.random(q.shape) < 0.5, chain.limits[:, 0], chain.limits[:, 1])
    return np.where(limited & (random.random(q.shape) < 0.5), ends, q)


def right_angles(chain: Chain, count: int) -> Floats:
    """Positions [count, n] at multiples of a right angle: all that aligns does so, often several at once."""
    random = generator(chain, "right angles")
    low, high = chain.ranges()
    turned = random.integers(-2, 3, (count, chain.n)) * (np.pi / 2)
    return np.where(chain.revolute, turned, random.uniform(low, high, turned.shape))


def singular(chain: Chain, count: int, redundant: int | None) -> Floats:
    """Positions [count, n] at a singularity of the Jacobian, and beside it by one of :data:`NEAR`.

    Of random positions a random joint is moved to where the determinant changes its sign (that of the other
    joints, where a redundant one is held), by bisection: the wrist aligned, the elbow stretched or folded,
    the wrist centre on the first axis, and whatever else an arm has, come up as often as the joint crosses
    them.
    """
    random = generator(chain, "singular")
    low, high = chain.ranges()
    rows: list[Floats] = []
    while sum(map(len, rows)) < count:
        q = random.uniform(low, high, (count, chain.n))
        joint = random.integers(0, chain.n, count)
        rows.append(_on_singularity(chain, q, joint, redundant, random))
    q = np.concatenate(rows)[:count]
    beside = np.array(NEAR)[random.integers(0, len(NEAR), count)]
    return np.asarray(q + beside[:, None] * random.choice([-1.0, 1.0], q.shape))


def _on_singularity(
    chain: Chain, q: Floats, joint: np.ndarray, redundant: int | None, random: np.random.Generator
) -> Floats:
    low, high = chain.ranges()
    k = np.arange(len(q))

    def moved(x: Floats) -> Floats:
        there = q.copy()
        there[k, joint] = x
        return there

    grid = low[joint, None] + np.linspace(0, 1, _GRID) * (high - low)[joint, None]
    values = np.stack([determinants(chain, moved(x), redundant) for x in grid.T], axis=1)
    crossing = values[:, :-1] * values[:, 1:] < 0
    usable = np.flatnonzero(crossing.any(axis=1))
    first = np.argmax(crossing * random.random(crossing.shape), axis=1)
    a, b = grid[k, first], grid[k, first + 1]
    sign = np.sign(values[k, first])
    for _ in range(_HALVINGS):
        middle = (a + b) / 2
        left = np.sign(determinants(chain, moved(middle), redundant)) == sign
        a, b = np.where(left, middle, a), np.where(left, b, middle)
    return moved(b)[usable]


def determinants(chain: Chain, q: Floats, redundant: int | None) -> Floats:
    """Of the square Jacobian [N], without the column of the redundant joint.

    Arms of fewer than six joints have that of the tool's origin.
    """
    J = chain.jacobians(q)[:, : chain.n] if chain.n < 6 else chain.jacobians(q)
    if redundant is not None:
        J = np.delete(J, redundant, axis=2)
    return np.asarray(np.linalg.det(J))
