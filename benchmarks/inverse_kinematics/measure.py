"""What is measured of an arm: sets of solutions beside others', poses at singularities and limits, a race."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.inverse_kinematics import multistart, positions
from benchmarks.inverse_kinematics.chain import Chain, Floats, chain_of
from benchmarks.inverse_kinematics.runners import (
    SLOTS,
    SLOTS_REDUNDANT,
    Flagged,
    Ours,
    answers,
    computed,
    flagged,
    ours,
    peers,
    ssik,
    states,
)
from benchmarks.inverse_kinematics.sets import Answers, Compared, closures, compared, matched, total
from benchmarks.peers.building import Lacking
from benchmarks.peers.candidates import Candidate, Missing
from benchmarks.peers.race import Race, paired

from robodyn.robot import Robot

#: Poses that are compared at once.
TOGETHER = 5000
#: Poses of which a runner with many solutions each is asked at once, and one in how many it is asked of.
TOGETHER_SWEPT, ONE_IN = 250, 100
#: How far out of reach poses are pushed, in reaches.
BEYOND = (1.001, 4.0)
#: Poses of a race; its rounds, and nanoseconds of a block.
RACED, ROUNDS, BLOCK_NS = 256, 300, 4e5


@dataclass(frozen=True, slots=True)
class Arm:
    """An arm that is measured, in the folder ``race.folder``; what several have in common is in ``work``."""

    robot: Robot
    chain: Chain
    ours: Ours
    race: Race
    work: Path

    def solved(self, poses: Floats, near: Floats) -> Flagged:
        """What our kernel gives at ``poses`` [N, 4, 4], with ``near`` [N, n] for what they leave free."""
        size = self.ours.branches * (self.chain.n + 3) + 1
        rows = np.concatenate([*computed(self.race, self.ours.candidate.timed, poses, near, size, TOGETHER)])
        return flagged(rows, self.ours.branches, self.chain.n)


def arm_of(robot: Robot, harness: Path, work: Path) -> Arm:
    """The arm, its kernel compiled.

    Raises
    ------
    NoSuchFunction: it is of no class that has a closed form.
    """
    folder = work / robot.name
    folder.mkdir(parents=True, exist_ok=True)
    return Arm(robot, chain_of(robot), ours(robot, folder), Race(folder, harness), work)


# --- sets ---------------------------------------------------------------------------------------------------


def sets(arm: Arm, poses: int, searched: int) -> Iterator[dict[str, Any]]:
    """Our solutions beside each peer's and those of the search from many starts."""
    q = positions.drawn(arm.chain, poses)
    for peer in peers(arm.chain, arm.race.folder, arm.work, arm.ours.redundant):
        if isinstance(peer, Missing):
            yield {"peer": peer.title, "missing": peer.why}
            continue
        swept = arm.chain.n > 6 and peer.key.startswith("ssik")
        parts = [*(_swept(arm, peer, q[::ONE_IN]) if swept else _same(arm, peer, q))]
        yield {"peer": peer.title, "swept": swept, **total(parts).to_dict()}
    few = q[:searched]
    searched_for = multistart.search(arm.chain, arm.chain.poses(few), few, arm.ours.redundant)
    own = arm.solved(arm.chain.poses(few), few).answers
    beside = compared(arm.chain, arm.chain.poses(few), own, searched_for, arm.ours.redundant)
    yield {"peer": f"search from {multistart.STARTS} starts", "swept": False, **beside.to_dict()}


def _same(arm: Arm, peer: Candidate, q: Floats) -> Iterator[Compared]:
    """Sets of the same poses, a redundant joint where it was drawn."""
    n = arm.chain.n
    for start in range(0, len(q), TOGETHER):
        some = q[start : start + TOGETHER]
        poses = arm.chain.poses(some)
        own = arm.solved(poses, some).answers
        (rows,) = computed(arm.race, peer.timed, poses, some, 1 + SLOTS * n, TOGETHER)
        yield compared(arm.chain, poses, own, answers(rows, n), arm.ours.redundant)


def _swept(arm: Arm, peer: Candidate, q: Floats) -> Iterator[Compared]:
    """Each solution of a peer that chooses the redundant joint itself, beside ours with the joint there."""
    n = arm.chain.n
    for start in range(0, len(q), TOGETHER_SWEPT):
        some = q[start : start + TOGETHER_SWEPT]
        poses = arm.chain.poses(some)
        (rows,) = computed(arm.race, peer.timed, poses, some, 1 + SLOTS_REDUNDANT * n, TOGETHER_SWEPT)
        theirs = answers(rows, n)
        pose, place = np.nonzero(theirs.exists)
        near = theirs.q[pose, place]
        own = arm.solved(poses[pose], near).answers
        one = Answers(near[:, None], np.ones((len(near), 1), dtype=bool))
        yield compared(arm.chain, poses[pose], own, one, arm.ours.redundant)


# --- singularities and boundaries ---------------------------------------------------------------------------


def hard(arm: Arm, count: int) -> Iterator[dict[str, Any]]:
    """What our kernel says of ``count`` poses of each kind at which inverse kinematics tend to fail."""
    chain = arm.chain
    kinds = {
        "at and beside singularities": positions.singular(chain, count, arm.ours.redundant),
        "all joints at right angles": positions.right_angles(chain, count),
        "joints at their limits": positions.at_limits(chain, count),
    }
    for title, q in kinds.items():
        poses = chain.poses(q)
        result = arm.solved(poses, q)
        drawn = Answers(q[:, None], np.ones((count, 1), dtype=bool))
        same = matched(chain, result.answers, drawn)[:, :, 0]
        allowed = ((q >= chain.limits[:, 0]) & (q <= chain.limits[:, 1])).all(axis=1)
        yield {
            "kind": title,
            "poses": count,
            **_counted(arm, result),
            "unsolved": int((~result.answers.exists.any(axis=1)).sum()),
            "closes": float(closures(chain, poses, result.answers).max(initial=0.0)),
            "refused": int((allowed & same.any(axis=1) & ~(same & (result.within > 0)).any(axis=1)).sum()),
        }
    if not chain.revolute.all():
        return  # without its limits a slide reaches everything, and limits decide of `within` alone
    q = positions.drawn(chain, count, "beyond")
    poses = chain.poses(q)
    out = poses[:, :3, 3] - chain.points[0]
    far = np.linspace(*BEYOND, count)[:, None] * chain.reach
    poses[:, :3, 3] = chain.points[0] + out / np.linalg.norm(out, axis=1, keepdims=True) * far
    result = arm.solved(poses, q)
    yield {
        "kind": "out of reach",
        "poses": count,
        **_counted(arm, result),
        "solved": int(result.answers.exists.any(axis=1).sum()),
    }


def _counted(arm: Arm, result: Flagged) -> dict[str, int]:
    """Results that no kernel may give."""
    flags = np.stack([result.answers.exists, result.within, result.singular])
    return {
        "not_finite": int((~np.isfinite(result.answers.q)).any(axis=(1, 2)).sum()),
        "no_flags": int(((flags != 0) & (flags != 1)).sum()),
        "miscounted": int((result.count != result.answers.exists.sum(axis=1)).sum()),
    }


# --- race ---------------------------------------------------------------------------------------------------


def raced(arm: Arm, rounds: int = ROUNDS) -> dict[str, Any]:
    """All branches of the same poses, a redundant joint at one position, in blocks one after another."""
    q = positions.drawn(arm.chain, RACED, "race")
    if arm.ours.redundant is not None:
        q[:, arm.ours.redundant] = q[0, arm.ours.redundant]
    racing: list[Candidate] = [arm.ours.candidate]
    missing: list[Missing] = []
    for peer in (*peers(arm.chain, arm.race.folder, arm.work, arm.ours.redundant), *_at_one(arm)):
        if isinstance(peer, Missing):
            missing.append(peer)
        else:
            racing.append(peer)
    states(arm.chain.poses(q), q).write(arm.race.folder / "states.bin")
    poses = arm.chain.poses(q)
    times = arm.race.times([one.timed for one in racing], rounds, BLOCK_NS)
    rows = [
        {
            "title": one.title,
            "flags": one.flags,
            "ours": one.ours,
            "solutions": _solutions(arm, one, poses, q),
            "ns": float(np.median(times[:, k])),
            "ratio": paired(times[:, k], times[:, 0]).to_list(),
            "instructions": arm.race.instructions(one.counted, RACED) if one.counted else None,
        }
        for k, one in enumerate(racing)
    ]
    return {
        "rounds": rounds,
        "poses": RACED,
        "rows": rows,
        "missing": [[one.title, one.why] for one in missing],
    }


def _solutions(arm: Arm, one: Candidate, poses: Floats, q: Floats) -> float:
    """How many solutions a runner gives of a pose, on average."""
    if one.ours:
        return float(arm.solved(poses, q).answers.exists.sum() / len(poses))
    swept = arm.chain.n > 6 and one.key.startswith("ssik") and not one.key.endswith("one-position")
    size = 1 + (SLOTS_REDUNDANT if swept else SLOTS) * arm.chain.n
    return float(
        np.mean([rows[:, 0].mean() for rows in computed(arm.race, one.timed, poses, q, size, len(poses))])
    )


def _at_one(arm: Arm) -> Iterator[Candidate]:
    """ssik's closed form at one position of a redundant last joint, where ours is the last one too."""
    if arm.ours.redundant == arm.chain.n - 1:
        try:
            yield ssik(arm.chain, arm.race.folder, arm.work, one=True)
        except Lacking:
            return
